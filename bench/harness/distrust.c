#include "bench/harness/distrust.h"

#include <math.h>

#include "bench/harness/looks.h"
#include "models/vector.h"

/* Returns how far the supports a and b pull apart those of their places that are nearest on
 * the sheet, at t, over their distance on it; 0: they share a place. */
static double pulled_at(const struct scene *scene, const struct scene_support *a,
                        const struct scene_support *b, double t)
{
    const double side[3] = {scene->length, scene->width, 0};
    double from[3], to[3], x[3], y[3], square = 0;
    struct scene_placement place;

    for (int i = 0; i < 3; i++) {
        from[i] = fmin(fmax(b->lo[i], a->lo[i]), a->hi[i]);
        to[i] = fmin(fmax(from[i], b->lo[i]), b->hi[i]);
        square += (to[i] - from[i]) * (to[i] - from[i]) * side[i] * side[i];
    }
    scene_rest_point(scene, from, x);
    scene_motion_at(&a->motion, t, &place);
    scene_placement_point(&place, x, from);
    scene_rest_point(scene, to, y);
    scene_motion_at(&b->motion, t, &place);
    scene_placement_point(&place, y, to);
    return square > 0 ? vector_distance(from, to) / sqrt(square) : 0;
}

/* Returns to how many times its length supports pull the sheet between them, at most; 1:
 * not at all. */
static double pulled(const struct scene *scene)
{
    enum { TIMES = 100 };
    double most = 1;

    for (int n = 0; n < scene->support_count; n++)
        for (int k = 0; k < n; k++) {
            const struct scene_support *a = &scene->supports[n], *b = &scene->supports[k];
            const bool pulls =
                a->sheet == b->sheet && (a->fix & b->fix & FIX_XYZ) == FIX_XYZ;
            for (int t = 0; pulls && t <= TIMES; t++)
                most = fmax(most, pulled_at(scene, a, b, scene->end * t / TIMES));
        }
    return most;
}

bool distrust(const struct scene *scene, const double value[MEASURES],
              struct message *sentence)
{
    const double stretch = value[MEASURE_STRETCH_MAX],
                 weight = value[MEASURE_HANGING_STRAIN],
                 depth = value[MEASURE_PENETRATION_MAX],
                 begin = value[MEASURE_INTERSECTION_TIME],
                 left = value[MEASURE_NOT_ARRIVED], through = value[MEASURE_THROUGH_MAX];
    const bool stretched = stretch > pulled(scene) * fmax(DISTRUST_STRETCH, 1 + 2 * weight),
               deep = depth > DISTRUST_DEPTH * scene->thickness,
               crossed = value[MEASURE_INTERSECTIONS_MAX] > 0, moved = begin > 0,
               missed = left > 0, passed = through > 0,
               coarse = stretched || deep || passed || (crossed && !moved);

    sentence->text[0] = '\0';
    if (!stretched && !deep && !crossed && !missed && !passed)
        return false;
    message_add(sentence, "Do not trust this result: ");
    if (passed)
        message_add(sentence,
                    "a body thinner than the net came through it, first up to %.3g s, in "
                    "%.0f steps%s",
                    value[MEASURE_THROUGH_TIME], through,
                    missed || stretched || deep || crossed ? ", " : "");
    if (missed)
        message_add(sentence,
                    "iterations ended at their limit with up to %.2g %% of a step's loads "
                    "unbalanced%s",
                    100 * left, stretched || deep || crossed ? ", " : "");
    if (stretched)
        message_add(
            sentence,
            "the mid-surface is stretched to %.3g times its length, of which its hanging "
            "weight explains %.4g",
            stretch, 1 + weight);
    if (deep)
        message_add(sentence, "%san obstacle is %.2g mm deep in a sheet of %.2g mm",
                    stretched ? ", " : "", 1e3 * depth, 1e3 * scene->thickness);
    if (crossed)
        message_add(sentence, "%sit passes through itself", stretched || deep ? ", " : "");
    if (crossed && moved)
        message_add(sentence, " from %.3g s on", begin);
    const bool smaller = missed || passed;
    message_add(sentence, "; try %s%s%s", smaller ? "smaller steps" : "",
                coarse ? smaller ? ", a finer net" : "a finer net" : "",
                stretched ? ", another model beside it" : "");
    if (crossed && moved)
        message_add(sentence,
                    scene->contact.self
                        ? "%san end before %.3g s"
                        : "%san end before %.3g s, as nothing keeps this sheet off itself "
                          "(section contact)",
                    coarse || smaller ? ", or " : "", begin);
    message_add(sentence, ".");
    return true;
}

enum status distrust_fields(const struct scene *scene, int count, const double *time,
                            double *const *xyz, struct message *sentence)
{
    struct looks looks;
    double value[MEASURES];
    enum status st;

    TRY(looks_init(&looks, count));
    for (int n = 0; n < count; n++)
        looks_add(&looks, scene, time[n], xyz[n], true);
    looks_reduce(&looks, scene, STATUS_OK, NAN, NULL, value);
    distrust(scene, value, sentence);
out:
    looks_clear(&looks);
    return st;
}

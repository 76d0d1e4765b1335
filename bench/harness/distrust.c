#include "bench/harness/distrust.h"

#include <math.h>

#include "bench/harness/looks.h"

bool distrust(const struct scene *scene, const double value[MEASURES],
              struct message *sentence)
{
    const double stretch = value[MEASURE_STRETCH_MAX],
                 weight = value[MEASURE_HANGING_STRAIN],
                 depth = value[MEASURE_PENETRATION_MAX],
                 begin = value[MEASURE_INTERSECTION_TIME];
    const bool stretched = stretch > fmax(DISTRUST_STRETCH, 1 + 2 * weight),
               deep = depth > DISTRUST_DEPTH * scene->thickness,
               crossed = value[MEASURE_INTERSECTIONS_MAX] > 0, moved = begin > 0,
               coarse = stretched || deep || !moved;

    sentence->text[0] = '\0';
    if (!stretched && !deep && !crossed)
        return false;
    message_add(sentence, "Do not trust this result: ");
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
    message_add(sentence, "; try %s%s", coarse ? "a finer net" : "",
                stretched ? ", another model beside it" : "");
    if (crossed && moved)
        message_add(sentence,
                    scene->contact.self
                        ? "%san end before %.3g s"
                        : "%san end before %.3g s, as nothing keeps this sheet off itself "
                          "(section contact)",
                    coarse ? ", or " : "", begin);
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
    looks_reduce(&looks, scene, STATUS_OK, NAN, value);
    distrust(scene, value, sentence);
out:
    looks_clear(&looks);
    return st;
}

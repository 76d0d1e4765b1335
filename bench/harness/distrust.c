#include "bench/harness/distrust.h"

#include <math.h>
#include <string.h>

#include "bench/harness/looks.h"
#include "bench/harness/warnings.h"
#include "models/vector.h"

/* The largest plausible stretch of what no support pulls (woven cloth tears before it) or,
 * if that is more, strain over the one that the scene prescribes; the largest angle by
 * which a cell bends [rad]: the chord of an arc of the angle t is t / 8 of itself off the
 * arc, 5 %, and t^2 / 24 shorter, by which neighbouring stretches may differ, too, besides
 * SPREAD times that strain; a sheet that bends in one direction alone need not stretch for
 * it, and its chords may be off by OFF of the length; the largest share of the energy that
 * may be won where nothing is moved. */
static const double STRETCH = 1.3, STRAIN = 10, TURN = 0.4, EVEN = 0.4 * 0.4 / 24,
                    SPREAD = 1.5, OFF = 0.01, WON = 0.3;

enum { TIMES = 100 };

/* Returns how far the supports a and b pull apart those of their places that are nearest on
 * the sheet, in the components that both hold, at t, over their distance on it; 0: they
 * share a place. */
static double pulled_at(const struct scene *scene, const struct scene_support *a,
                        const struct scene_support *b, double t)
{
    const double side[3] = {scene->length, scene->width, 0};
    const unsigned both = a->fix & b->fix;
    double from[3], to[3], x[3], y[3], square = 0, apart = 0;
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
    for (int i = 0; i < 3; i++)
        apart += both & (FIX_X << i) ? (to[i] - from[i]) * (to[i] - from[i]) : 0;
    return square > 0 ? sqrt(apart / square) : 0;
}

/* Returns to how many times its length supports pull the sheet between them, at most; 1:
 * not at all. Grippers do not: the sheet hangs between them as it did when they took it. */
static double pulled(const struct scene *scene)
{
    double most = 1;

    for (int n = 0; n < scene->support_count; n++)
        for (int k = 0; k < n; k++) {
            const struct scene_support *a = &scene->supports[n], *b = &scene->supports[k];
            const bool pull = a->sheet == b->sheet && !scene_grips(a) && !scene_grips(b);
            for (int t = 0; pull && t <= TIMES; t++)
                most = fmax(most, pulled_at(scene, a, b, scene->end * t / TIMES));
        }
    return most;
}

/* Returns the largest speed of a point of what moves so [m/s]. */
static double speed_of(const struct scene *scene, const struct scene_motion *m,
                       const double x[3])
{
    const double dt = scene->end / TIMES;
    double before[3], now[3], most = 0;
    struct scene_placement place;

    for (int t = 0; SCENE_MOVES(*m) && t <= TIMES; t++) {
        memcpy(before, now, sizeof before);
        scene_motion_at(m, t * dt, &place);
        scene_placement_point(&place, x, now);
        most = t ? fmax(most, vector_distance(before, now) / dt) : 0;
    }
    return most;
}

/* Returns the speed at which a sheet may be stopped. */
static double speed(const struct scene *s)
{
    const double g = vector_length(s->gravity), side = fmax(s->length, s->width);
    double moved = 0, corner[3];

    for (int n = 0; n < s->support_count; n++) {
        scene_rest_point(s, s->supports[n].hi, corner);
        moved = fmax(moved, speed_of(s, &s->supports[n].motion, corner));
    }
    for (int n = 0; n < s->obstacle_count; n++)
        moved = fmax(moved, speed_of(s, &s->obstacles[n].motion, s->obstacles[n].point));
    return fmin(sqrt(2 * g * side), g * s->end) + vector_length(s->velocity) +
           vector_length(s->spin) * side + vector_length(s->ripple) + moved;
}

/* Returns the strain of loads: of each over the width that it acts on, but a cell of the
 * grid at least; and of pressure, around a closed sheet where it is widest. */
static double loaded(const struct scene *s)
{
    const double stiff = s->young * s->thickness, side = fmax(s->length, s->width);
    double strain = 0, top, hem, z;

    if (s->pressure != 0) {
        scene_cloak_meridian(s, 0, 0.5, &top, &z);
        scene_cloak_meridian(s, 1, 0.5, &hem, &z);
        strain = fabs(s->pressure) * fmax(top, hem) / stiff;
    }
    for (int n = 0; n < s->load_count; n++) {
        const struct scene_load *l = &s->loads[n];
        const double wide =
            fmax(fmax((l->hi[0] - l->lo[0]) * s->length, (l->hi[1] - l->lo[1]) * s->width),
                 side / TIMES);
        strain += vector_length(l->force) / (stiff * wide);
    }
    return strain;
}

double distrust_strain(const struct scene *s)
{
    const double weight = s->density * vector_length(s->gravity) * s->length / s->young,
                 wave = speed(s) / sqrt(s->young / s->density);

    return weight + loaded(s) + wave;
}

static bool is_moved(const struct scene *s)
{
    bool moved = s->pressure != 0 || scene_wind_speed(s) > 0;

    for (int n = 0; n < s->support_count; n++)
        moved |= SCENE_MOVES(s->supports[n].motion);
    for (int n = 0; n < s->obstacle_count; n++)
        moved |= SCENE_MOVES(s->obstacles[n].motion);
    return moved;
}

/* The clauses say what is wrong; the flags say what to try against it. */
struct told {
    struct message what;
    bool steps, net, model;
};

#define TELL(t, ...) TEXT_JOIN((t)->what.text, ", ", __VA_ARGS__)

static void tell_steps(const double value[MEASURES], struct told *t)
{
    const double left = value[MEASURE_NOT_ARRIVED], through = value[MEASURE_THROUGH_MAX];

    if (through > 0) {
        TELL(t,
             "a body thinner than the net came through it, first up to %.3g s, in %.0f "
             "steps",
             value[MEASURE_THROUGH_TIME], through);
        t->steps = t->net = true;
    }
    if (left > 0) {
        TELL(t,
             "iterations ended at their limit with up to %.2g %% of a step's loads "
             "unbalanced",
             100 * left);
        t->steps = true;
    }
}

/* Returns the largest angle by which cells of the net may bend [rad]. */
static double most_turn(const struct run *r)
{
    return scene_same_across(&r->scene)
               ? fmax(TURN, 8 * OFF * (r->discretization.points[0] - 1))
               : TURN;
}

static void tell_shape(const struct run *run, const double value[MEASURES], struct told *t)
{
    const struct scene *scene = &run->scene;
    const double pull = pulled(scene), strain = distrust_strain(scene),
                 whole = pull * (1 + strain) - 1, stretch = value[MEASURE_STRETCH_MAX],
                 spread = value[MEASURE_SPREAD_MAX], turn = value[MEASURE_TURN_MAX],
                 depth = value[MEASURE_PENETRATION_MAX],
                 won = value[MEASURE_ENERGY_DRIFT_MAX];

    if (stretch > pull * fmax(STRETCH, 1 + STRAIN * strain)) {
        TELL(t,
             "the mid-surface is stretched to %.3g times its length, where the scene "
             "prescribes a strain of %.2g",
             stretch, whole);
        t->net = t->model = true;
    }
    if (spread > EVEN + SPREAD * whole) {
        TELL(t,
             "neighbouring stretches differ by %.2g, where the scene prescribes a strain "
             "of %.2g",
             spread, whole);
        t->net = true;
    }
    if (turn > most_turn(run)) {
        TELL(t, "a cell of the net bends by %.0f degrees", turn * 180 / acos(-1.0));
        t->net = true;
    }
    if (won > WON && !is_moved(scene)) {
        TELL(t, "%.0f %% of the energy are won from nothing", 100 * won);
        t->steps = t->model = true;
    }
    if (depth > DISTRUST_DEPTH * scene->thickness) {
        TELL(t, "an obstacle is %.2g mm deep in a sheet of %.2g mm", 1e3 * depth,
             1e3 * scene->thickness);
        t->net = true;
    }
}

/* Adds what the net cannot hold; a sheet that nothing holds and no body has carried yet
 * falls, and its weight does not bend it. */
static void tell_net(const struct run *run, double carried, struct told *t)
{
    const bool falls = !run->scene.support_count && carried < 1;

    for (const struct warnings_rule *r = warnings_rules; run->contestant && r->name; r++) {
        double number[WARNINGS_NUMBERS] = {0};
        if (falls || !r->is_grave || !r->holds(run, number) || !r->is_grave(run, number))
            continue;
        TELL(t, "%s", r->grave);
        t->net = t->model = true;
    }
}

bool distrust(const struct run *run, const double value[MEASURES], struct message *sentence)
{
    const struct scene *scene = &run->scene;
    const double begin = value[MEASURE_INTERSECTION_TIME];
    const bool crossed = value[MEASURE_INTERSECTIONS_MAX] > 0, later = crossed && begin > 0;
    struct told t = {0};

    sentence->text[0] = '\0';
    tell_steps(value, &t);
    tell_net(run, value[MEASURE_LOAD_MAX], &t);
    tell_shape(run, value, &t);
    if (later)
        TELL(&t, "it passes through itself from %.3g s on", begin);
    else if (crossed)
        TELL(&t, "it passes through itself");
    if (!*t.what.text)
        return false;
    t.net |= crossed && !later;
    message_add(sentence, "Do not trust this result: %s; try ", t.what.text);
    struct message cures = {""};
    if (t.steps)
        TEXT_JOIN(cures.text, ", ", "smaller steps");
    if (t.net)
        TEXT_JOIN(cures.text, ", ", "a finer net");
    if (t.model)
        TEXT_JOIN(cures.text, ", ", "another model beside it");
    if (later)
        TEXT_JOIN(cures.text, ", or ", "an end before %.3g s%s", begin,
                  scene->contact.self ? ""
                                      : ", as nothing keeps this sheet off itself (section "
                                        "contact)");
    message_add(sentence, "%s.", cures.text);
    return true;
}

void distrust_fields(const struct scene *scene, int count, const double *time,
                     double *const *xyz, struct message *sentence)
{
    const struct run run = {.scene = *scene}; /* borrowed */
    struct looks looks SCOPED(looks_clear) = {0};
    double value[MEASURES];

    looks_init(&looks, count);
    for (int n = 0; n < count; n++)
        looks_add(&looks, scene, time[n], xyz[n], looks_crossings(scene, xyz[n]));
    if (count)
        looks_recount(&looks, scene, xyz[count - 1]);
    looks_reduce(&looks, scene, STATUS_OK, NAN, NULL, value);
    distrust(&run, value, sentence);
}

/* Measures: what each series of looks is, where the largest of it and the last go, what is
 * not there, and their words. (looks.c: when, and how it ended.) */
#include "bench/harness/looks.h"

#include <float.h>

#include "models/metric/metric.h"
#include "tests/check.h"

/* A few operations. */
#define TOL_ROUND (8 * DBL_EPSILON)

enum { LOOKS = 4 };
static const double time[LOOKS] = {0, 0.2, 0.3, 0.7};

/* As many of the looks as asked for: series n is n + 1 at the first, then grows by halves,
 * falls below zero, and ends above where it began. */
static struct looks make(int count)
{
    static const double shape[LOOKS] = {1, 1.5, -2, 1.25};
    struct looks l;

    REQUIRE(looks_init(&l, LOOKS) == STATUS_OK && l.count == 0 && l.room == LOOKS);
    l.count = count;
    for (int n = 0; n < LOOKS; n++) {
        l.time[n] = time[n];
        for (int s = 0; s < LOOKS_SERIES; s++)
            l.series[s][n] = (s + 1) * shape[n];
        l.energy[n] = (struct energy){0};
    }
    return l;
}

/* L = 0.4 m, E / rho = 250 m^2/s^2, g = 13 m/s^2 askew. */
static struct scene sheet(void)
{
    struct scene s;

    REQUIRE(scene_init(&s) == STATUS_OK);
    s.length = 0.4, s.young = 500, s.density = 2;
    memcpy(s.gravity, (double[]){3, -4, 12}, sizeof s.gravity);
    return s;
}

static void reduce(const struct looks *l, const struct scene *s, enum status outcome,
                   double *value)
{
    for (int n = 0; n < MEASURES; n++)
        value[n] = -77; /* nothing is left as it was */
    REQUIRE(looks_reduce(l, s, outcome, 0.35, value) == STATUS_OK);
    for (int n = 0; n < MEASURES; n++)
        if (!CHECK(value[n] != -77))
            printf("  %s is not there\n", measure_name(n));
}

/* The measures of each series. */
static const struct {
    int series, most, end;
    const char *name, *unit;
    double (*value)(const struct scene *scene, const double *xyz);
} of[LOOKS_SERIES] = {
    {LOOKS_DROP, MEASURE_DROP_MAX, MEASURE_DROP_END, "drop", "1", metric_drop},
    {LOOKS_ANGLE, MEASURE_ANGLE_MAX, MEASURE_ANGLE_END, "angle", "degrees", metric_angle},
    {LOOKS_STRETCH, MEASURE_STRETCH_MAX, MEASURE_STRETCH_END, "stretch", "1",
     metric_stretch},
    {LOOKS_ROUGHNESS, MEASURE_ROUGHNESS_MAX, MEASURE_ROUGHNESS_END, "roughness", "1",
     metric_roughness},
    {LOOKS_PENETRATION, MEASURE_PENETRATION_MAX, -1, "penetration", "m",
     metric_penetration},
    {LOOKS_INTERSECTIONS, MEASURE_INTERSECTIONS_MAX, MEASURE_INTERSECTIONS_END,
     "intersections", "1", NULL},
    {LOOKS_SPEED, MEASURE_SPEED_MAX, MEASURE_SPEED_END, "speed", "m/s", NULL},
    {LOOKS_LOAD, MEASURE_LOAD_MAX, MEASURE_LOAD_END, "load", "1", NULL},
};

static void test_series(void)
{
    struct scene scene = sheet();
    struct scene_obstacle plane = {.kind = OBSTACLE_PLANE, .normal = {0, 0, 1}};
    struct looks l = make(LOOKS);
    double value[MEASURES];

    scene.obstacles = &plane, scene.obstacle_count = 1;
    reduce(&l, &scene, STATUS_OK, value);
    for (int s = 0; s < LOOKS_SERIES; s++) {
        CHECK(of[s].series == s && !strcmp(looks_series[s].name, of[s].name));
        CHECK(!strcmp(looks_series[s].unit, of[s].unit));
        CHECK(looks_series[s].value == of[s].value);
        CHECK(value[of[s].most] == 1.5 * (s + 1));
        CHECK(of[s].end < 0 || value[of[s].end] == 1.25 * (s + 1));
    }
    CHECK(value[MEASURE_END_TIME] == 0.7);
    CHECK(!strcmp(measure_name(MEASURE_SPEED_END), "speed_end"));
    CHECK(!strcmp(measure_unit(MEASURE_SPEED_END), "m/s") && *measure_sentence(0));
    CHECK(!strcmp(measure_name(MEASURES), "unknown") && !*measure_unit(-1));
    l.series[LOOKS_SPEED][0] = NAN; /* as it is; the rest counts */
    l.series[LOOKS_DROP][1] = NAN;
    l.series[LOOKS_ANGLE][LOOKS - 1] = NAN;
    for (int n = 0; n < LOOKS; n++)
        l.series[LOOKS_STRETCH][n] = NAN;
    reduce(&l, &scene, STATUS_OK, value);
    CHECK(value[MEASURE_SPEED_MAX] == 1.5 * (LOOKS_SPEED + 1));
    CHECK(value[MEASURE_DROP_MAX] == 1.25 * (LOOKS_DROP + 1));
    CHECK(isnan(value[MEASURE_ANGLE_END]) && !isnan(value[MEASURE_ANGLE_MAX]));
    CHECK(isnan(value[MEASURE_STRETCH_MAX]));

    scene.obstacle_count = 0; /* nothing to penetrate is not a penetration of zero */
    l.count = 2;
    reduce(&l, &scene, STATUS_OK, value);
    CHECK(isnan(value[MEASURE_PENETRATION_MAX]) && value[MEASURE_END_TIME] == 0.2);
    CHECK(value[MEASURE_ROUGHNESS_END] == 1.5 * (LOOKS_ROUGHNESS + 1));
    l.count = 0; /* and without looks there is nothing at all but the scene */
    reduce(&l, &scene, STATUS_UNSUPPORTED, value);
    for (int s = 0; s < LOOKS_SERIES; s++)
        CHECK(isnan(value[of[s].most]) && (of[s].end < 0 || isnan(value[of[s].end])));
    CHECK(isnan(value[MEASURE_END_TIME]));
    CHECK(isnan(value[MEASURE_ENERGY_DRIFT_MAX]) && isnan(value[MEASURE_ENERGY_DRIFT_END]));
    scene.obstacles = NULL;
    looks_clear(&l);
    scene_clear(&scene);
}

/* A swing that loses a quarter of what is in play, then has won a quarter. */
static void test_energy(void)
{
    static const struct energy swing[LOOKS] = {{0, 0, 5}, {3, 1, 1}, {2, 0, 2}, {4, 1, 1}};
    struct scene scene = sheet();
    struct looks l = make(LOOKS);
    double value[MEASURES];

    memcpy(l.energy, swing, sizeof swing);
    reduce(&l, &scene, STATUS_OK, value); /* E = 5, 5, 4, 6; in play at most 4 + 1 + 4 */
    CHECK_NEAR(value[MEASURE_ENERGY_DRIFT_MAX], 1 / 9., TOL_ROUND);
    CHECK_NEAR(value[MEASURE_ENERGY_DRIFT_END], 1 / 9., TOL_ROUND);
    l.count = 3; /* in play at most 3 + 1 + 4 */
    reduce(&l, &scene, STATUS_OK, value);
    CHECK(value[MEASURE_ENERGY_DRIFT_MAX] == 0);
    CHECK_NEAR(value[MEASURE_ENERGY_DRIFT_END], -1 / 8., TOL_ROUND);
    looks_clear(&l);
    scene_clear(&scene);
}

static void test_energy_drift(void)
{
    /* E = 2, 2, 1, 2.5; in play 2, 6, 7, 2.5 */
    static const struct energy energy[] = {{2, 0, 0}, {3, 1, -2}, {1, 3, -3}, {0.5, 1, 1}};
    struct energy rest[2] = {{0, 0, 7}, {0, 0, 7}};
    double drift[4], largest = 7;

    metric_energy_drift(4, energy, drift);
    CHECK(drift[0] == 0 && drift[1] == 0);
    CHECK_NEAR(drift[2], -1 / largest, TOL_ROUND);
    CHECK_NEAR(drift[3], 0.5 / largest, TOL_ROUND);
    metric_energy_drift(2, rest, drift);
    CHECK(drift[0] == 0 && drift[1] == 0);
    rest[1].elastic = NAN;
    metric_energy_drift(2, rest, drift);
    CHECK(drift[0] == 0 && isnan(drift[1]));
}

/* The largest distance to a truth, the last one that there is, and the bar beside it. */
static void test_truth(void)
{
    static const double error[] = {NAN, 0.5, 0.25, NAN}, bar[] = {NAN, 0.125, 0.0625, NAN};
    struct scene scene = sheet();
    struct looks l = make(LOOKS);
    double value[MEASURES];

    reduce(&l, &scene, STATUS_OK, value); /* looks alone have none */
    for (int n = 0; n < 2; n++) {
        CHECK(isnan(value[MEASURE_TRUTH_ERROR_MAX]));
        CHECK(isnan(value[MEASURE_TRUTH_ERROR_END]) && isnan(value[MEASURE_TRUTH_BAR_END]));
        looks_reduce_truth(1, error, bar, value);
    }
    looks_reduce_truth(LOOKS, error, bar, value);
    CHECK(value[MEASURE_TRUTH_ERROR_MAX] == 0.5);
    CHECK(value[MEASURE_TRUTH_ERROR_END] == 0.25);
    CHECK(value[MEASURE_TRUTH_BAR_END] == 0.0625);
    looks_clear(&l);
    scene_clear(&scene);
}

int main(void)
{
    test_series();
    test_energy();
    test_energy_drift();
    test_truth();
    return check_result();
}

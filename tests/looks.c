/* What a run is reduced to, by hand-made looks; keys that stand for others; who watches a
 * motion sees every corner fly away, and in which frame. */
#include "bench/harness/looks.h"

#include "bench/harness/derived_key.h"
#include "bench/harness/motion.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/run_fixture.h"

enum { LOOKS = 4 };

/* Powers, roots and sums of a few numbers. */
static const double TOL_ROUNDING = 1e-14;

static bool equal(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

/* Of series n: 10 n + 1, none, 10 n + 3 (the most), 10 n + 2. */
static void fill(struct looks *l)
{
    static const double over[LOOKS] = {1, NAN, 3, 2}, kinetic[LOOKS] = {0, 4, 9, 3};

    REQUIRE(looks_init(l, LOOKS) == STATUS_OK && l->room == LOOKS && l->count == 0);
    l->count = LOOKS;
    for (int n = 0; n < LOOKS; n++) {
        l->time[n] = 0.1 * n;
        l->energy[n] = (struct energy){kinetic[n], 1, 10.0 - 2 * n};
        for (int s = 0; s < LOOKS_SERIES; s++)
            l->series[s][n] = 10 * s + over[n];
    }
}

/* The same numbers under the same names as the series have, whatever their table says. */
static void check_series(const double *value)
{
    static const struct {
        int series, most, end;
    } want[] = {{LOOKS_DROP, MEASURE_DROP_MAX, MEASURE_DROP_END},
                {LOOKS_ANGLE, MEASURE_ANGLE_MAX, MEASURE_ANGLE_END},
                {LOOKS_STRETCH, MEASURE_STRETCH_MAX, MEASURE_STRETCH_END},
                {LOOKS_ROUGHNESS, MEASURE_ROUGHNESS_MAX, MEASURE_ROUGHNESS_END},
                {LOOKS_PENETRATION, MEASURE_PENETRATION_MAX, -1},
                {LOOKS_INTERSECTIONS, MEASURE_INTERSECTIONS_MAX, MEASURE_INTERSECTIONS_END},
                {LOOKS_SPEED, MEASURE_SPEED_MAX, MEASURE_SPEED_END},
                {LOOKS_LOAD, MEASURE_LOAD_MAX, MEASURE_LOAD_END}};

    for (int n = 0; n < LENGTH(want); n++) {
        CHECK(value[want[n].most] == 10 * want[n].series + 3);
        CHECK(want[n].end < 0 || value[want[n].end] == 10 * want[n].series + 2);
    }
    CHECK(LENGTH(want) == LOOKS_SERIES && value[MEASURE_END_TIME] == 0.1 * (LOOKS - 1));
}

static void check_energy(const struct looks *l, const double *value)
{
    double drift[LOOKS], most = -INFINITY;

    metric_energy_drift(LOOKS, l->energy, drift);
    for (int n = 0; n < LOOKS; n++)
        most = fmax(most, drift[n]);
    CHECK(value[MEASURE_ENERGY_DRIFT_MAX] == most && most > drift[LOOKS - 1]);
    CHECK(value[MEASURE_ENERGY_DRIFT_END] == drift[LOOKS - 1]);
}

/* What obstacles carry at the end is a mean over the last tenth of the time. */
static void test_load(void)
{
    static const double time[LOOKS] = {0, 0.9, 0.95, 1}, load[LOOKS] = {9, 7, 3, 1};
    struct scene scene;
    struct looks l;
    double value[MEASURES];

    REQUIRE(scene_init(&scene) == STATUS_OK);
    fill(&l);
    memcpy(l.time, time, sizeof time);
    memcpy(l.series[LOOKS_LOAD], load, sizeof load);
    REQUIRE(looks_reduce(&l, &scene, STATUS_OK, NAN, value) == STATUS_OK);
    CHECK(value[MEASURE_LOAD_END] == 2 && value[MEASURE_LOAD_MAX] == 9);
    looks_clear(&l);
    scene_clear(&scene);
}

static void test_reduction(void)
{
    struct scene scene;
    struct looks l, none;
    double value[MEASURES];

    REQUIRE(scene_init(&scene) == STATUS_OK && looks_init(&none, 0) == STATUS_OK);
    scene.density = 0.5, scene.young = 1e4, scene.length = 2;
    memcpy(scene.gravity, (double[]){2, 3, 6}, sizeof scene.gravity);
    fill(&l);
    scene.obstacle_count = 1;
    REQUIRE(looks_reduce(&l, &scene, STATUS_OK, NAN, value) == STATUS_OK);
    scene.obstacle_count = 0;
    check_series(value);
    check_energy(&l, value);
    CHECK(value[MEASURE_BLOWUP_TIME] == INFINITY);
    CHECK(value[MEASURE_GAMMA] == scene_gamma(&scene));
    CHECK(value[MEASURE_YOUNG_OVER_DENSITY] == 1e4 / 0.5);
    CHECK_RELATIVE(value[MEASURE_HANGING_STRAIN], 0.5 * 7 * 2 / 1e4, TOL_ROUNDING);
    REQUIRE(looks_reduce(&l, &scene, STATUS_NAN, 0.25, value) == STATUS_OK);
    CHECK(value[MEASURE_BLOWUP_TIME] == 0.25 && isnan(value[MEASURE_PENETRATION_MAX]));
    REQUIRE(looks_reduce(&none, &scene, STATUS_UNSUPPORTED, NAN, value) == STATUS_OK);
    for (int m = 0; m < MEASURE_GAMMA; m++)
        CHECK(isnan(value[m]));
    looks_clear(&l);
    looks_clear(&none);
    scene_clear(&scene);
}

/* The first look that crosses itself; none; not counted. */
static void test_crossing(void)
{
    static const struct {
        double crossings[LOOKS], time;
    } want[] = {{{0, 0, 5, 2}, 0.2},         {{1, 0, 0, 0}, 0},
                {{0, 0, 0, 1}, 0.1 * 3},     {{0, 0, 0, 0}, INFINITY},
                {{NAN, 0, 1, 0}, NAN}, /* not from the start on:
                                          not known */
                {{NAN, NAN, NAN, NAN}, NAN}, {{0, NAN, 0, 1}, 0.1 * 3}};
    struct scene scene;
    struct looks l;
    double value[MEASURES];

    REQUIRE(scene_init(&scene) == STATUS_OK);
    fill(&l);
    for (int n = 0; n < LENGTH(want); n++) {
        memcpy(l.series[LOOKS_INTERSECTIONS], want[n].crossings, sizeof want[n].crossings);
        REQUIRE(looks_reduce(&l, &scene, STATUS_OK, NAN, value) == STATUS_OK);
        CHECK(equal(value[MEASURE_INTERSECTION_TIME], want[n].time));
    }
    looks_clear(&l);
    scene_clear(&scene);
}

/* A key set to the solution gives the number that was wanted. */
static void test_derived_keys(void)
{
    struct scene scene;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.gravity[2] = -9.81;
    const struct {
        const char *key, *by;
        double *field;
    } want[] = {{"gamma", "material.young", &scene.young},
                {"gamma", "material.density", &scene.density},
                {"gamma", "sheet.thickness", &scene.thickness},
                {"gamma", "sheet.length", &scene.length},
                {"young_over_density", "material.young", &scene.young},
                {"young_over_density", "material.density", &scene.density}};
    for (int n = 0; n < LENGTH(want); n++) {
        const double before = *want[n].field;
        *want[n].field = derived_key_solve(want[n].key, want[n].by, 50, &scene);
        CHECK_RELATIVE(derived_key_number(want[n].key, &scene), 50.0, TOL_ROUNDING);
        CHECK_RELATIVE(n < 4 ? scene_gamma(&scene) : scene.young / scene.density, 50.0,
                       TOL_ROUNDING);
        *want[n].field = before;
        CHECK(derived_key_is(want[n].key) && !derived_key_is(want[n].by));
    }
    CHECK(isnan(derived_key_solve("young_over_density", "sheet.length", 50, &scene)));
    CHECK(isnan(derived_key_solve("gamma", "time.end", 50, &scene)));
    memset(scene.gravity, 0, sizeof scene.gravity);
    CHECK(isnan(derived_key_solve("gamma", "sheet.length", 50, &scene)));
    scene_clear(&scene);
}

/* A sheet of which one point leaves in the third frame. */
static struct {
    const struct scene *scene;
    double u, v, lengths;
    int axis, frame, samples;
} leaver;

static enum status leave(void *state, struct counters *counters)
{
    (void)state, (void)counters;
    leaver.frame++;
    return STATUS_OK;
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    (void)state;
    for (int p = 0; p < n; p++) {
        scene_rest_point(leaver.scene, uvw + 3 * p, xyz + 3 * p);
        if (leaver.frame >= 3 && uvw[3 * p] == leaver.u && uvw[3 * p + 1] == leaver.v)
            xyz[3 * p + leaver.axis] += leaver.lengths * leaver.scene->length;
    }
}

static void sample(const void *state, double *xyz)
{
    leaver.samples++;
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        probe(state, 1, uvw, xyz + 3 * n);
    }
}

/* Where it ends, and how often the whole grid was looked at. */
static void fly(double lengths, bool judged, enum status death, int samples)
{
    static const struct model model = {
        .name = "leaver", .advance = leave, .probe = probe, .sample = sample};
    const double step = leaver.scene->step;
    struct message why = {""};
    struct motion m;

    leaver.frame = leaver.samples = 0;
    leaver.lengths = lengths;
    REQUIRE(motion_init(&m, &model, leaver.scene, NULL) == STATUS_OK);
    m.judged = judged;
    REQUIRE(motion_run(&m, NULL, NULL, true, NULL) == STATUS_OK);
    CHECK(m.death == death && leaver.samples == samples);
    CHECK(m.frames == (death ? 2 : m.frame_count) && m.time == m.frames * step);
    CHECK(m.steps == m.frames + (death != STATUS_OK));
    CHECK(!death || m.death_time == 3 * step);
    motion_tell_death(&m, &why);
    CHECK(!death || (strstr(why.text, "leaver on ") && strstr(why.text, " died at t = ") &&
                     strstr(why.text, status_text(death))));
    motion_clear(&m);
}

static void test_flight(void)
{
    struct settings s = LIST("time.end=0.02"); /* four frames */
    struct scene scene;
    struct message why = {""};

    REQUIRE(contestant_read_scene(&s, DROP, &scene, &why) == STATUS_OK);
    leaver.scene = &scene;
    for (int n = 0; n < 12; n++) {
        leaver.u = n & 1, leaver.v = n >> 1 & 1, leaver.axis = n >> 2;
        fly(12, false, STATUS_ESCAPED, 1);
        fly(-12, false, STATUS_ESCAPED, 1);
        fly(3.999, false, STATUS_OK, 0);
    }
    fly(NAN, false, STATUS_NAN, 1);
    fly(4.1, false, STATUS_OK, 2); /* suspicious, and looked at in each frame */
    fly(12, true, STATUS_OK, 0);
    scene_clear(&scene);
    settings_clear(&s);
}

int main(void)
{
    test_load();
    test_reduction();
    test_crossing();
    test_derived_keys();
    test_flight();
    return check_result();
}

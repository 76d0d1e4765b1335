/* Tests the measures of looks at a run: the largest and the last of each series, energy,
 * the first crossing, the truth, what is not there; keys that stand for others; who watches
 * a motion sees every corner fly away, and in which frame; what a death advises is there.
 */
#include "bench/harness/looks.h"

#include <float.h>

#include "bench/harness/derived_key.h"
#include "bench/harness/motion.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/run_fixture.h"

/* Powers, roots and sums of a few numbers. */
#define TOL_ROUND (8 * DBL_EPSILON)

enum { LOOKS = 4 };

/* L = 0.4 m, E / rho = 250 m^2/s^2, g = 13 m/s^2 askew, a plane to fall on. */
static struct scene sheet;
static struct looks looks;
static double value[MEASURES];

/* Series n is n + 1 at the first look, then grows by halves, falls below zero, and ends
 * above where it began. */
static void begin(void)
{
    static const double shape[LOOKS] = {1, 1.5, -2, 1.25}, time[LOOKS] = {0, 0.2, 0.3, 0.7};
    static struct scene_obstacle plane = {.kind = OBSTACLE_PLANE, .normal = {0, 0, 1}};

    REQUIRE(scene_init(&sheet) == STATUS_OK);
    looks_init(&looks, LOOKS);
    CHECK(looks.count == 0 && looks.room == LOOKS);
    sheet.length = 0.4, sheet.young = 500, sheet.density = 2;
    memcpy(sheet.gravity, (double[]){3, -4, 12}, sizeof sheet.gravity);
    sheet.obstacles = &plane, sheet.obstacle_count = 1;
    looks.count = LOOKS;
    for (int n = 0; n < LOOKS; n++) {
        looks.time[n] = time[n];
        looks.energy[n] = (struct energy){0};
        for (int s = 0; s < LOOKS_SERIES; s++)
            looks.series[s][n] = (s + 1) * shape[n];
    }
}

static void end(void)
{
    sheet.obstacles = NULL, sheet.obstacle_count = 0;
    scene_clear(&sheet);
    looks_clear(&looks);
}

static void reduce(enum status outcome)
{
    for (int n = 0; n < MEASURES; n++)
        value[n] = -77; /* nothing is left as it was */
    looks_reduce(&looks, &sheet, outcome, outcome ? 0.35 : NAN, NULL, value);
    for (int n = 0; n < MEASURES; n++)
        CHECK_SAY(value[n] != -77, "%s is not there", measure_name(n));
}

/* The metric that a series is of. */
static double (*const metric[LOOKS_SERIES])(const struct scene *, const double *) = {
    [LOOKS_DROP] = metric_drop,
    [LOOKS_ANGLE] = metric_angle,
    [LOOKS_STRETCH] = metric_stretch,
    [LOOKS_ROUGHNESS] = metric_roughness,
    [LOOKS_SPREAD] = metric_spread};

/* A measure is called after its series. */
static bool is_called(int measure, const char *series, const char *end)
{
    char name[64];

    snprintf(name, sizeof name, "%s_%s", series, end);
    return !strcmp(measure_name(measure), name);
}

static void test_series(void)
{
    begin();
    reduce(STATUS_OK);
    for (int s = 0; s < LOOKS_SERIES; s++) {
        const struct looks_series *l = &looks_series[s];
        CHECK(l->value == metric[s] && is_called(l->most, l->name, "max"));
        CHECK(l->end < 0 ? (s == LOOKS_PENETRATION || s >= LOOKS_THROUGH)
                         : is_called(l->end, l->name, "end"));
        CHECK(value[l->most] == 1.5 * (s + 1));
        CHECK(l->end < 0 || value[l->end] == 1.25 * (s + 1));
        CHECK(!strcmp(l->unit, measure_unit(l->most)));
    }
    CHECK(value[MEASURE_END_TIME] == 0.7 && value[MEASURE_BLOWUP_TIME] == INFINITY);
    CHECK(value[MEASURE_GAMMA] == scene_gamma(&sheet));
    CHECK(value[MEASURE_YOUNG_OVER_DENSITY] == 250);
    CHECK_RELATIVE(value[MEASURE_HANGING_STRAIN], 2. * 13 * 0.4 / 500, TOL_ROUND);
    looks.series[LOOKS_SPEED][0] = NAN; /* as it is; the rest counts */
    looks.series[LOOKS_DROP][1] = NAN;
    looks.series[LOOKS_ANGLE][LOOKS - 1] = NAN;
    for (int n = 0; n < LOOKS; n++)
        looks.series[LOOKS_STRETCH][n] = NAN;
    reduce(STATUS_NAN);
    CHECK(value[MEASURE_BLOWUP_TIME] == 0.35);
    CHECK(value[MEASURE_SPEED_MAX] == 1.5 * (LOOKS_SPEED + 1));
    CHECK(value[MEASURE_DROP_MAX] == 1.25 * (LOOKS_DROP + 1));
    CHECK(isnan(value[MEASURE_ANGLE_END]) && !isnan(value[MEASURE_ANGLE_MAX]));
    CHECK(isnan(value[MEASURE_STRETCH_MAX]));
    sheet.obstacle_count = 0; /* nothing to penetrate is not a penetration of zero */
    looks.count = 2;
    reduce(STATUS_OK);
    CHECK(isnan(value[MEASURE_PENETRATION_MAX]) && value[MEASURE_END_TIME] == 0.2);
    CHECK(value[MEASURE_ROUGHNESS_END] == 1.5 * (LOOKS_ROUGHNESS + 1));
    looks.count = 0; /* and without looks there is nothing at all but the scene */
    reduce(STATUS_UNSUPPORTED);
    for (int m = 0; m < MEASURE_GAMMA; m++)
        CHECK(isnan(value[m]));
    end();
}

/* A look at a body that moves is one at its time. */
static void test_moving(void)
{
    static double path[2][4] = {{0, 0, 0, 0}, {1, 0, 0, 0.5}};
    struct scene_obstacle plane = {.kind = OBSTACLE_PLANE,
                                   .normal = {0, 0, 1},
                                   .motion = {.path_count = 2, .path = path}};
    static double xyz[3 * GRID_POINTS];

    begin();
    sheet.obstacles = &plane, looks.count = 0;
    looks_add(&looks, &sheet, 0, xyz, NAN);
    looks_add(&looks, &sheet, 0.5, xyz, NAN);
    CHECK(looks.series[LOOKS_PENETRATION][0] == 0);
    CHECK(looks.series[LOOKS_PENETRATION][1] == 0.25);
    end();
}

/* The load on obstacles at the end is a mean over the last tenth of the time. */
static void test_load(void)
{
    static const double time[LOOKS] = {0, 0.9, 0.95, 1}, load[LOOKS] = {9, 7, 3, 1};

    begin();
    memcpy(looks.time, time, sizeof time);
    memcpy(looks.series[LOOKS_LOAD], load, sizeof load);
    reduce(STATUS_OK);
    CHECK(value[MEASURE_LOAD_END] == 2 && value[MEASURE_LOAD_MAX] == 9);
    end();
}

/* A swing that loses a quarter of what is in play, then has won a quarter. */
static void test_energy(void)
{
    static const struct energy swing[LOOKS] = {{0, 0, 5}, {3, 1, 1}, {2, 0, 2}, {4, 1, 1}};
    struct energy rest[2] = {{0, 0, 7}, {0, 0, 7}};
    double drift[2];

    begin();
    memcpy(looks.energy, swing, sizeof swing);
    reduce(STATUS_OK); /* E = 5, 5, 4, 6; in play at most 4 + 1 + 4 */
    CHECK_NEAR(value[MEASURE_ENERGY_DRIFT_MAX], 1 / 9., TOL_ROUND);
    CHECK_NEAR(value[MEASURE_ENERGY_DRIFT_END], 1 / 9., TOL_ROUND);
    looks.count = 3; /* in play at most 3 + 1 + 4 */
    reduce(STATUS_OK);
    CHECK(value[MEASURE_ENERGY_DRIFT_MAX] == 0);
    CHECK_NEAR(value[MEASURE_ENERGY_DRIFT_END], -1 / 8., TOL_ROUND);
    sheet.young = 1e24; /* where a strain of 1e-10 stores more: rounding alone */
    reduce(STATUS_OK);
    CHECK(value[MEASURE_ENERGY_DRIFT_END] == 0);
    end();
    metric_energy_drift(2, rest, drift);
    CHECK(drift[0] == 0 && drift[1] == 0);
    rest[1].elastic = NAN;
    metric_energy_drift(2, rest, drift);
    CHECK(drift[0] == 0 && isnan(drift[1]));
}

/* The first look that crosses itself; none; not counted. */
static void test_crossing(void)
{
    static const struct {
        double crossings[LOOKS], time;
    } want[] = {{{0, 0, 5, 2}, 0.3},         {{1, 0, 0, 0}, 0},     {{0, 0, 0, 1}, 0.7},
                {{0, 0, 0, 0}, INFINITY},    {{NAN, 0, 1, 0}, NAN}, /* not from the start
                                                                       on: not known */
                {{NAN, NAN, NAN, NAN}, NAN}, {{0, NAN, 0, 1}, 0.7}};

    begin();
    for (int n = 0; n < LENGTH(want); n++) {
        memcpy(looks.series[LOOKS_INTERSECTIONS], want[n].crossings,
               sizeof want[n].crossings);
        reduce(STATUS_OK);
        const double time = value[MEASURE_INTERSECTION_TIME];
        CHECK(isnan(want[n].time) ? isnan(time) : time == want[n].time);
    }
    end();
}

/* A crossing between the points of looks is found at the end, where crossings are counted.
 */
static void test_recount(void)
{
    static const double fold[4][2] = {{51.5, 0}, {51.5, 1}, {50, 1}, {50, -1}};
    static double xyz[3 * GRID_POINTS];

    begin();
    for (int n = 0; n < GRID_POINTS; n++) {
        const int i = n / GRID_V % GRID_U, j = n % GRID_V;
        const bool folded = i >= 50 && i < 54;
        xyz[3 * n] = 1e-3 * (folded ? fold[i - 50][0] : i);
        xyz[3 * n + 1] = 1e-3 * j;
        xyz[3 * n + 2] = 1e-3 * (folded ? fold[i - 50][1] : 0);
    }
    for (int counted = 0; counted < 2; counted++) {
        looks.count = 0;
        looks_add(&looks, &sheet, 0, xyz, counted ? looks_crossings(&sheet, xyz) : NAN);
        looks_recount(&looks, &sheet, xyz);
        const double found = looks.series[LOOKS_INTERSECTIONS][0];
        CHECK(counted ? found > 0 && found == metric_intersections(&sheet, xyz)
                      : isnan(found));
    }
    end();
}

/* The largest distance to a truth, the last one that there is, and the bar beside it. */
static void test_truth(void)
{
    static const double error[] = {NAN, 0.5, 0.25, NAN}, bar[] = {NAN, 0.125, 0.0625, NAN};

    begin();
    reduce(STATUS_OK); /* looks alone have none */
    for (int n = 0; n < 2; n++) {
        CHECK(isnan(value[MEASURE_TRUTH_ERROR_MAX]));
        CHECK(isnan(value[MEASURE_TRUTH_ERROR_END]) && isnan(value[MEASURE_TRUTH_BAR_END]));
        looks_reduce_truth(1, error, bar, value);
    }
    looks_reduce_truth(LOOKS, error, bar, value);
    CHECK(value[MEASURE_TRUTH_ERROR_MAX] == 0.5);
    CHECK(value[MEASURE_TRUTH_ERROR_END] == 0.25);
    CHECK(value[MEASURE_TRUTH_BAR_END] == 0.0625);
    end();
}

static void test_words(void)
{
    for (int n = 0; n < MEASURES; n++) {
        CHECK(*measure_name(n) && *measure_unit(n) && *measure_sentence(n));
        for (int k = 0; k < n; k++)
            CHECK(strcmp(measure_name(n), measure_name(k)) != 0);
    }
}

static const double TOL_DERIVED = 1e-14;

/* E set to the solution gives the number that was wanted. */
static void test_derived_keys(void)
{
    static const char *const keys[] = {"gamma", "young_over_density"};
    struct scene scene;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.gravity[2] = -9.81;
    for (int n = 0; n < LENGTH(keys); n++) {
        scene.young = derived_key_young(keys[n], 50, &scene);
        CHECK_RELATIVE(derived_key_number(keys[n], &scene), 50.0, TOL_DERIVED);
        CHECK_RELATIVE(n ? scene.young / scene.density : scene_gamma(&scene), 50.0,
                       TOL_DERIVED);
        CHECK(derived_key_is(keys[n]));
    }
    CHECK(!derived_key_is("material.young"));
    scene.is_fabric = true;
    scene.fabric = (struct law_fabric){{1, 1, 0, 1}, {1, 1, 0, 1}, 0, 1};
    for (int n = 0; n < LENGTH(keys); n++)
        CHECK(isnan(derived_key_young(keys[n], 50, &scene)));
    scene.is_fabric = false;
    memset(scene.gravity, 0, sizeof scene.gravity);
    CHECK(isnan(derived_key_young("gamma", 50, &scene)));
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

/* Checks where it ends, and how often the whole grid was looked at. */
static void fly(double lengths, bool judged, enum status death, int samples)
{
    static const struct model model = {
        .name = "leaver", .advance = leave, .probe = probe, .sample = sample};
    const double step = leaver.scene->step;
    struct message why = {""};
    struct motion m;

    leaver.frame = leaver.samples = 0;
    leaver.lengths = lengths;
    motion_init(&m, &model, leaver.scene, NULL);
    m.judged = judged;
    REQUIRE(motion_run(&m, NULL, NULL, true, NULL) == STATUS_OK);
    CHECK(m.death == death && leaver.samples == samples);
    CHECK(m.frames == (death ? 2 : m.frame_count) && m.time == m.frames * step);
    CHECK(m.steps == m.frames + (death != STATUS_OK));
    CHECK(!death || m.death_time == 3 * step);
    motion_tell_death(&m, &why);
    CHECK(!death || *why.text);
    motion_clear(&m);
}

static void test_flight(void)
{
    struct settings s = LIST("time.end=0.02"); /* four frames */
    struct scene scene;

    REQUIRE(contestant_read_scene(&s, DROP, &scene, NULL) == STATUS_OK);
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

/* Tells whether a model is built with explicit steps. */
static bool has_explicit(const struct model *model, const struct scene *scene)
{
    struct discretization d;
    struct message told = {""}, why = {""};
    void *state = calloc(1, model->bytes);

    REQUIRE(state);
    model_open(model, &d);
    d.integrator = INTEGRATOR_LEAPFROG;
    model_complete(model, scene, &d, &told);
    const bool built = model->init(state, scene, &d, &why) == STATUS_OK;
    model->clear(state);
    free(state);
    return built;
}

/* Every model can do what a death under contact advises: half the step, and explicit steps
 * where they are named, among supports that hold the middle of the thickness. */
static void test_advice(void)
{
    struct settings s = {0};
    struct scene scene;
    struct message why = {""};
    int named_explicit = 0, models = 0;

    REQUIRE(contestant_read_scene(&s, SOURCE_DIR "/tests/through/wrung.yaml", &scene,
                                  &why) == STATUS_OK);
    for (; contestant_model(models); models++) {
        const struct model *model = contestant_model(models);
        const struct motion m = {.model = model, .scene = &scene, .death = STATUS_DIVERGED};
        motion_tell_death(&m, &why);
        CHECK(strstr(why.text, "time.step"));
        if (!strstr(why.text, "integrator=leapfrog"))
            continue;
        named_explicit++;
        CHECK_SAY(has_explicit(model, &scene), "%s has no explicit steps there",
                  model->name);
    }
    CHECK(named_explicit == 3 && models > named_explicit); /* shell, springs, triangles */
    scene_clear(&scene);
    settings_clear(&s);
}

int main(void)
{
    test_series();
    test_load();
    test_moving();
    test_energy();
    test_crossing();
    test_recount();
    test_truth();
    test_words();
    test_derived_keys();
    test_flight();
    test_advice();
    return check_result();
}

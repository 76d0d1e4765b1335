/* What is read from the file of a run whose arrays were put there by hand: seconds of
 * repeats, work, and what does not fit together; and what a caller puts there itself. */
#include "bench/harness/run_result.h"

#include <unistd.h>

#include "bench/files/hdf5_file.h"
#include "bench/files/seal.h"
#include "bench/files/store.h"
#include "bench/harness/run_file.h"
#include "models/metric/metric.h"
#include "tests/run_fixture.h"
#include "tests/scratch.h"
#include "tests/scripted_model.h"

static const char *path;

struct array {
    const char *name;
    int rows, columns;
    double value[9];
};

/* A run of five looks (frames 0, 5, ..., 20) with these arrays, and an outcome, in it. */
static enum status read_with(int count, const struct array *arrays, const char *outcome,
                             struct run_result *r, struct message *why)
{
    const struct run_keep keep = {.file = path, .every = 5, .fields = RUN_FIELDS_NONE};
    const struct run_plan plan = {DROP, &scripted, NULL, 0.1};

    script_reset();
    REQUIRE(run_file_write(&plan, &keep, NULL, NULL) == STATUS_OK);
    hid_t file = H5Fopen(path, H5F_ACC_RDWR, H5P_DEFAULT);
    REQUIRE(file >= 0);
    for (int n = 0; n < count; n++) {
        const struct array *a = &arrays[n];
        H5Ldelete(file, a->name, H5P_DEFAULT); /* if it is there */
        REQUIRE(!a->rows || hdf5_file_put_array(file, a->name,
                                                (struct hdf5_file_meaning){"s", "repeat"},
                                                a->value, a->rows, a->columns) >= 0);
    }
    if (outcome) {
        H5Adelete(file, "outcome");
        REQUIRE(hdf5_file_put_text(file, "outcome", outcome) >= 0);
    }
    H5Fclose(file);
    REQUIRE(seal_write(path, NULL) == STATUS_OK);
    *r = (struct run_result){0};
    why->text[0] = '\0';
    return run_result_read(path, true, r, why);
}

/* Of each repeat the mean of its steps; a death leaves some out, or all. */
static void test_seconds(void)
{
    static const struct array arrays[] = {
        {"seconds/create", 3, 0, {0.25, 1, 0.5}},
        {"seconds/advance", 3, 3, {1, 2, 3, NAN, NAN, NAN, 4, NAN, 8}},
        {"seconds/look", 1, 0, {7}},
        {"seconds/assemble", 2, 0, {10, 20}},
        {"seconds/factor", 2, 0, {11, 21}},
        {"seconds/solve", 3, 0, {12, 22, 32}}};
    static const struct array rest[] = {{"seconds/advance", 0, 0, {0}},
                                        {"seconds/equilibrium", 2, 1, {5, 9}}};
    struct run_result r;
    struct message why;

    REQUIRE(read_with(LENGTH(arrays), arrays, NULL, &r, &why) == STATUS_OK);
    CHECK(r.create.count == 3 && r.create.min == 0.25 && r.create.median == 0.5);
    CHECK(r.create.max == 1 && r.create_seconds == 0.25);
    CHECK(r.step.count == 2 && r.step.min == 2 && r.step.max == 6 && r.step.median == 4);
    CHECK(r.step_seconds == 6 && r.steps == 3 && r.look_seconds == 7);
    for (int p = 0; p < RUN_RESULT_PHASES; p++)
        CHECK(r.phase[p].count == 2 + (p == 2) && r.phase[p].min == 10 + p);
    run_result_clear(&r);
    REQUIRE(read_with(LENGTH(rest), rest, NULL, &r, &why) == STATUS_OK);
    CHECK(r.step.count == 2 && r.step.min == 5 && r.step.max == 9);
    CHECK(r.steps == 0 && r.step_seconds == 0 && r.phase[0].count == 0);
    run_result_clear(&r);
}

/* Work up to the last look. */
static void test_work(void)
{
    static const struct array arrays[] = {
        {"counters/steps", 2, 0, {1, 11}},          {"counters/assemblies", 2, 0, {1, 12}},
        {"counters/factorisations", 2, 0, {1, 13}}, {"counters/solves", 2, 0, {1, 14}},
        {"counters/iterations", 1, 0, {15}},        {"counters/substeps", 2, 0, {1, 16}}};
    const struct counters want = {11, 12, 13, 14, 15, 16};
    struct run_result r;
    struct message why;

    REQUIRE(read_with(LENGTH(arrays), arrays, NULL, &r, &why) == STATUS_OK);
    CHECK(!memcmp(&r.work, &want, sizeof want));
    run_result_clear(&r);
}

/* The energies of five looks, told by the drift that only these three make. */
static void test_energy(void)
{
    static const struct array arrays[] = {{"energy/kinetic", 5, 0, {0, 1, 2, 3, 4}},
                                          {"energy/elastic", 5, 0, {10, 10, 10, 10, 10}},
                                          {"energy/potential", 5, 0, {0, 0, 0, 0, 0.5}}};
    struct energy energy[5];
    double drift[5];
    struct run_result r;
    struct message why;

    for (int n = 0; n < 5; n++)
        energy[n] = (struct energy){n, 10, n == 4 ? 0.5 : 0};
    metric_energy_drift(5, energy, drift);
    REQUIRE(read_with(LENGTH(arrays), arrays, NULL, &r, &why) == STATUS_OK);
    CHECK(r.value[MEASURE_ENERGY_DRIFT_END] == drift[4] && drift[4] != drift[3]);
    run_result_clear(&r);
}

/* Distances to a truth, where both series of it are there; else there are none. */
static void test_truth(void)
{
    static const struct array arrays[] = {
        {"metrics/truth_error", 5, 0, {NAN, 0.5, NAN, 0.25, NAN}},
        {"metrics/truth_bar", 5, 0, {NAN, 0.125, NAN, 0.0625, NAN}}};
    struct run_result r;
    struct message why;

    for (int count = 0; count <= LENGTH(arrays); count++) {
        REQUIRE(read_with(count, arrays, NULL, &r, &why) == STATUS_OK);
        CHECK(isnan(r.value[MEASURE_TRUTH_ERROR_MAX]) == (count < 2));
        if (count == 2) {
            CHECK(r.value[MEASURE_TRUTH_ERROR_MAX] == 0.5);
            CHECK(r.value[MEASURE_TRUTH_ERROR_END] == 0.25);
            CHECK(r.value[MEASURE_TRUTH_BAR_END] == 0.0625);
        }
        run_result_clear(&r);
    }
}

/* A file without its scene: nothing to give back, whatever was there before. */
static void test_no_scene(void)
{
    struct run_result r;
    struct store_read *file = NULL;
    struct scene scene;
    struct message why;

    REQUIRE(read_with(0, NULL, NULL, &r, &why) == STATUS_OK);
    run_result_clear(&r);
    hid_t id = H5Fopen(path, H5F_ACC_RDWR, H5P_DEFAULT);
    REQUIRE(id >= 0 && H5Adelete(id, "scene") >= 0 && H5Fclose(id) >= 0);
    REQUIRE(seal_write(path, NULL) == STATUS_OK);
    CHECK(run_result_read(path, true, &r, &why) == STATUS_INPUT);
    CHECK(strstr(why.text, "has no text scene"));
    REQUIRE(store_read_open(path, &file, NULL) == STATUS_OK);
    memset(&scene, 0x55, sizeof scene);
    CHECK(store_scene(file, path, &scene, &why) == STATUS_INPUT);
    scene_clear(&scene);
    store_read_close(file);
}

static void test_misfits(void)
{
    static const struct {
        struct array array;
        const char *outcome, *sentence;
    } want[] = {
        {{"metrics/drop", 2, 0, {0, 1}}, NULL, "metrics/drop has 2 numbers for 5"},
        {{"metrics/speed", 5, 2, {0}}, NULL, "metrics/speed has 10 numbers for 5"},
        {{"metrics/truth_error", 2, 0, {0, 1}}, NULL, "truth_error has 2 numbers for 5"},
        {{"energy/kinetic", 1, 0, {0}}, NULL, "energy/kinetic has 1 numbers for 5"},
        {{"energy/elastic", 0, 0, {0}}, NULL, "has no energy/elastic"},
        {{"energy/potential", 0, 0, {0}}, NULL, "has no energy/potential"},
        {{"metrics/none", 0, 0, {0}}, "flew away", "unknown outcome 'flew away'"},
        {{"xyz_time", 2, 0, {0, 1}}, NULL, "has 0 fields at 2 times"},
        {{"metrics/none", 0, 0, {0}}, "", "has no text note"}};
    struct run_result r;
    struct message why;

    for (int n = 0; n < LENGTH(want); n++) {
        const char *outcome =
            n == LENGTH(want) - 1 ? status_text(STATUS_UNSUPPORTED) : want[n].outcome;
        CHECK(read_with(1, &want[n].array, outcome, &r, &why) == STATUS_INPUT);
        if (!CHECK(strstr(why.text, want[n].sentence) && strstr(why.text, path)))
            printf("  %s\n", why.text);
    }
}

/* Every end has a sentence; a death its time, to six digits. */
static void test_sentences(void)
{
    struct run_result r = {.outcome = STATUS_NAN, .death_time = 0.1234567};
    char want[128];

    run_result_tell(&r, "no");
    snprintf(want, sizeof want, "died at t = 0.123457 s: %s", status_text(STATUS_NAN));
    CHECK(!strcmp(r.sentence.text, want) && !run_result_refused(&r));
    r.outcome = STATUS_UNSUPPORTED;
    run_result_tell(&r, "it cannot");
    CHECK(!strcmp(r.sentence.text, "it cannot") && run_result_refused(&r));
    r.outcome = STATUS_INPUT;
    CHECK(run_result_refused(&r));
    r.outcome = STATUS_OK;
    run_result_tell(&r, "it cannot");
    CHECK(!strcmp(r.sentence.text, "done") && !run_result_refused(&r));
}

static void check_array(const struct store_read *file, const char *name, int count,
                        const double *want)
{
    double *value = NULL;
    int rows = 0, columns = 0;

    CHECK(store_read_array(file, name, &value, &rows, &columns, NULL) == STATUS_OK);
    if (CHECK(rows * columns == count))
        for (int n = 0; n < count; n++)
            CHECK(value[n] == want[n]);
    free(value);
}

static enum status look(void *context, const struct motion *m, const double *xyz,
                        double *value)
{
    value[0] = m->frames;
    value[1] = -10 * m->frames;
    value[2] = xyz == NULL ? NAN : *(const double *)context;
    return STATUS_OK;
}

/* Numbers of the caller's own, each under its name with its unit. */
static void test_own(void)
{
    static const struct run_own own[] = {{"ups", "m"}, {"downs", "s"}, {"same", "kg"}};
    static const double want[3][3] = {{0, 10, 20}, {0, -100, -200}, {7, 7, 7}};
    double context = 7;
    const struct run_keep keep = {.file = path,
                                  .every = 10,
                                  .fields = RUN_FIELDS_NONE,
                                  .own_count = LENGTH(own),
                                  .own = own,
                                  .own_look = look,
                                  .context = &context};
    struct store_read *file = NULL;

    script_reset();
    REQUIRE(run_file_write(&(struct run_plan){DROP, &scripted, NULL, 0.1}, &keep, NULL,
                           NULL) == STATUS_OK);
    REQUIRE(store_read_open(path, &file, NULL) == STATUS_OK);
    for (int n = 0; n < LENGTH(own); n++) {
        char name[64], *unit = NULL;
        snprintf(name, sizeof name, "metrics/%s", own[n].name);
        check_array(file, name, 3, want[n]);
        CHECK(store_read_text(file, name, "unit", &unit, NULL) == STATUS_OK);
        CHECK(unit && !strcmp(unit, own[n].unit));
        free(unit);
    }
    store_read_close(file);
}

/* Seconds that are handed in stand for the run's own of that phase, and of no other. */
static void test_handed_in(void)
{
    static const struct {
        const char *phase;
        int creates, steps;
    } want[] = {
        {"assemble", 1, 20}, {"create", 3, 20}, {"advance", 1, 3}, {"equilibrium", 1, 0}};
    static const double seconds[3] = {1, 2, 3};
    const struct run_keep keep = {.file = path, .every = 5, .fields = RUN_FIELDS_NONE};
    const struct run_plan plan = {DROP, &scripted, NULL, 0.1};

    for (int n = 0; n < LENGTH(want); n++) {
        struct run run;
        struct motion m;
        struct run_file *f = NULL;
        struct store_read *file = NULL;
        char name[64];
        double *value = NULL;
        int rows = 0, columns = 0;

        script_reset();
        REQUIRE(run_open(&run, &plan, NULL) == STATUS_OK);
        REQUIRE(run_file_open(&run, &keep, &f, NULL) == STATUS_OK);
        REQUIRE(motion_init(&m, run.model, &run.scene, run.state) == STATUS_OK);
        REQUIRE(motion_run(&m, run_file_watch, f, true, NULL) == STATUS_OK);
        REQUIRE(run_file_seconds(f, want[n].phase, seconds, 3, n < 2 ? 0 : 1, NULL) ==
                STATUS_OK);
        REQUIRE(run_file_close(f, &m, NULL, NULL) == STATUS_OK);
        motion_clear(&m);
        run_close(&run);
        REQUIRE(store_read_open(path, &file, NULL) == STATUS_OK);
        snprintf(name, sizeof name, "seconds/%s", want[n].phase);
        check_array(file, name, 3, seconds);
        CHECK(store_read_array(file, "seconds/create", &value, &rows, &columns, NULL) ==
                  STATUS_OK &&
              rows == want[n].creates);
        free(value), value = NULL;
        CHECK(store_read_has(file, "seconds/advance") == (want[n].steps > 0));
        if (want[n].steps)
            CHECK(store_read_array(file, "seconds/advance", &value, &rows, &columns,
                                   NULL) == STATUS_OK &&
                  rows * columns == want[n].steps);
        free(value);
        store_read_close(file);
    }
}

int main(void)
{
    scratch_open();
    path = scratch_path("run.h5");
    test_seconds();
    test_work();
    test_energy();
    test_truth();
    test_no_scene();
    test_misfits();
    test_sentences();
    test_own();
    test_handed_in();
    return check_result();
}

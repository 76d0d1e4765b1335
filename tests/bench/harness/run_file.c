/* The one runner: the same bits from the run and from its file, with fields and without;
 * looks and fields where they were asked for; measures that are those of the run's own
 * metrics; deaths, told the same by all who move a sheet, and refusals are results; what a
 * caller puts into a file; files whose arrays do not fit together. */
#include "bench/harness/run_file.h"

#include <unistd.h>

#include "bench/experiment/measurement.h"
#include "bench/files/hdf5_file.h"
#include "bench/files/seal.h"
#include "bench/files/store.h"
#include "bench/harness/looks.h"
#include "models/metric/metric.h"
#include "models/vector.h"
#include "tests/run_fixture.h"
#include "tests/scratch.h"
#include "tests/scripted_model.h"

#define FIELD ((size_t)3 * GRID_POINTS)

static const char *file, *view;

/* The same run: all but the seconds. */
static bool same(const struct run_result *a, const struct run_result *b)
{
    return a->outcome == b->outcome && !strcmp(a->sentence.text, b->sentence.text) &&
           !memcmp(&a->death_time, &b->death_time, sizeof a->death_time) &&
           !memcmp(a->value, b->value, sizeof a->value) &&
           !memcmp(&a->work, &b->work, sizeof a->work) && a->steps == b->steps;
}

static void read_back(bool fields, struct run_result *r)
{
    struct message why = {""};

    REQUIRE_SAY(run_result_read(file, fields, r, &why) == STATUS_OK, "%s", why.text);
}

/* Writes a run and reads it back: the numbers are those that the run itself gave. */
static void write_run(const struct case_plan *plan, const struct run_keep *keep,
                      struct run_result *r)
{
    struct run_result back;
    struct message why = {""};
    struct case_plan c = *plan;

    c.keep = *keep;
    CHECK_SAY(run_file_write(&c, r, &why) == STATUS_OK, "%s", why.text);
    if (!keep->file)
        return;
    read_back(true, &back);
    CHECK(same(&back, r) && back.create_seconds == r->create_seconds);
    CHECK(back.look_seconds == r->look_seconds && back.step_seconds == r->step_seconds);
    run_result_clear(&back);
}

/* The scripted model on its frames of 5 ms, and what its file says. */
static void write_script(double end, const struct run_keep *keep, struct run_result *r)
{
    write_run(&(struct case_plan){DROP, &scripted, {0}, end}, keep, r);
}

/* Twice without a file, with one, fields kept and not, and read back: 40 frames, looks at
 * frames 0 7 14 20 21 28 35 40. */
static void test_same_bits(void)
{
    static const int frames[] = {1, 8, 0};
    const double time[] = {0.1}; /* no multiple of the looks */
    struct case_plan plan = {DROP, named("iga_paper"),
                             LIST("discretization.points=[6,6,2]"), 0.2};
    struct run_keep keep = {
        .every = 7, .times = 1, .time = time, .intersections = true, .doubles = true};
    struct run_result first, other, back;
    static double seen[FIELD];

    write_run(&plan, &keep, &first);
    write_run(&plan, &keep, &other);
    CHECK(same(&first, &other) && first.steps == 40 && first.step_seconds > 0);
    CHECK(first.outcome == STATUS_OK && !strcmp(first.sentence.text, "done"));
    CHECK(isnan(first.death_time) && isinf(first.value[MEASURE_BLOWUP_TIME]));
    CHECK(first.value[MEASURE_INTERSECTIONS_MAX] == 0);
    CHECK(isinf(first.value[MEASURE_INTERSECTION_TIME]));
    CHECK(isnan(first.value[MEASURE_PENETRATION_MAX])); /* there is nothing to penetrate */
    keep.file = file;
    for (keep.fields = RUN_FIELDS_TIMES; keep.fields <= RUN_FIELDS_NONE; keep.fields++) {
        write_run(&plan, &keep, &other);
        CHECK(same(&first, &other));
        read_back(true, &back);
        CHECK(back.unknowns == 6 * 6 * 2 * 3 - 36);
        REQUIRE(back.frames == frames[keep.fields]);
        const int n = back.frames > 1 ? 3 : 0;
        if (back.frames)
            CHECK(back.time[n] == 20 * 0.005);
        if (back.frames == 1)
            memcpy(seen, back.xyz[0], FIELD * sizeof *seen);
        if (back.frames == 8) {
            CHECK(!memcmp(seen, back.xyz[n], FIELD * sizeof *seen));
            CHECK(first.value[MEASURE_SPEED_END] ==
                  metric_rmse(back.xyz[7], back.xyz[6]) / (back.time[7] - back.time[6]));
        }
        run_result_clear(&back);
    }
    settings_clear(&plan.settings);
}

/* Reads the last of a vector's rows, whose first, before any step, is not known. */
static void last_vector(const char *name, const char *unit, double last[3])
{
    char told[8] = "";
    struct store_read *store = NULL;
    double *value = NULL;
    int rows = 0, columns = 0;

    REQUIRE(store_read_open(file, &store, NULL) == STATUS_OK);
    CHECK(store_read_array(store, name, &value, &rows, &columns, NULL) == STATUS_OK);
    REQUIRE(rows > 1 && columns == 3);
    CHECK(isnan(value[0]));
    memcpy(last, value + 3 * (rows - 1), 3 * sizeof *last);
    store_read_close(store);
    const hid_t id = H5Fopen(file, H5F_ACC_RDONLY, H5P_DEFAULT);
    const hid_t unit_of = H5Aopen_by_name(id, name, "unit", H5P_DEFAULT, H5P_DEFAULT);
    const hid_t type = H5Aget_type(unit_of);
    REQUIRE(H5Tget_size(type) < sizeof told && H5Aread(unit_of, type, told) >= 0);
    CHECK(!strcmp(told, unit));
    H5Tclose(type), H5Aclose(unit_of), H5Fclose(id);
}

/* A sheet that has come to rest on the ground is carried by it; one that hangs is by
 * nothing, and a scheme without elastic energy has no drift of it. */
static void test_load(void)
{
    static const double AT_REST = 0.05; /* its last small bounces, over its weight */
    struct settings s = LIST("damping={kind: none}", "discretization.points=[6,6]");
    const struct run_keep keep = {.file = file, .every = 1};
    struct run_result r;
    double f[3];

    write_run(&(struct case_plan){SCENES "ground.yaml", named("mass_spring"), s, 0}, &keep,
              &r);
    CHECK_NEAR(r.value[MEASURE_LOAD_END], 1, AT_REST);
    last_vector("forces/obstacle_0", "N", f);
    CHECK(isnan(r.value[MEASURE_REACTION_END]) && f[2] > 0);
    CHECK(r.value[MEASURE_LOAD_MAX] > 1.5);           /* it fell */
    CHECK(isnan(r.value[MEASURE_INTERSECTIONS_MAX])); /* not asked for */
    settings_set(&s, "sheet={outline: [[0, 0], [1, 0], [0, 1]], thickness: 0.001177}");
    write_run(&(struct case_plan){SCENES "ground.yaml", named("mass_spring"), s, 0}, &keep,
              &r);
    CHECK_NEAR(r.value[MEASURE_LOAD_END], 1, AT_REST);
    write_run(&(struct case_plan){DROP, named("iga_paper"), {0}, 0.05}, &keep, &r);
    CHECK(isnan(r.value[MEASURE_LOAD_END]) && isnan(r.value[MEASURE_ENERGY_DRIFT_MAX]));
    settings_clear(&s);
}

/* A look has the forces of supports and obstacles, also where not every frame is one; a run
 * the size of the first support's; moments are about the scene's origin, on the held edge.
 */
static void test_forces(void)
{
    static const double ROUND_OFF = 1e-12;
    struct run_keep keep = {.file = file, .every = 3};
    struct settings low = LIST("discretization.points=[6,6]");
    struct run_result r;
    double f[3], m[3];

    write_run(&(struct case_plan){DROP, named("shell"), low, 0.1}, &keep, &r);
    last_vector("forces/support_0", "N", f);
    last_vector("moments/support_0", "N m", m);
    CHECK_RELATIVE(r.value[MEASURE_REACTION_END], vector_length(f), ROUND_OFF);
    CHECK(f[2] > 0);
    CHECK_RELATIVE(m[0], f[2] / 2, ROUND_OFF); /* of a sheet 1 m wide */
    settings_set(&low, "obstacles=[{plane: {point: [0, 0, -0.01], normal: [0, 0, 1]}}]");
    write_run(&(struct case_plan){DROP, named("shell"), low, 0.1}, &keep, &r);
    last_vector("forces/support_0", "N", f);
    last_vector("forces/obstacle_0", "N", m);
    CHECK_RELATIVE(r.value[MEASURE_REACTION_END], vector_length(f), ROUND_OFF);
    CHECK(m[2] >= 0);
    settings_clear(&low);
}

/* The last look counts what a coarse search does not see, also in a run that dies. */
static void test_crossing(void)
{
    const struct run_keep keep = {.file = file, .every = 5, .intersections = true};
    struct run_result r;

    for (int dies = 0; dies < 2; dies++) {
        script_reset();
        script.folds = true, script.dies = 13 * dies, script.death = STATUS_DIVERGED;
        write_script(0.1, &keep, &r);
        CHECK(r.value[MEASURE_INTERSECTIONS_END] > 0);
        CHECK(r.value[MEASURE_INTERSECTION_TIME] == (dies ? 10 : 20) * 0.005);
    }
}

static void check_array(const char *name, int count, const double *want)
{
    struct store_read *store = NULL;
    double *value = NULL;
    int rows = 0, columns = 0;

    REQUIRE(store_read_open(file, &store, NULL) == STATUS_OK);
    CHECK(store_read_array(store, name, &value, &rows, &columns, NULL) == STATUS_OK);
    if (CHECK(rows * columns == count))
        CHECK(!memcmp(value, want, (size_t)count * sizeof *value));
    store_read_close(store);
}

/* The last frame that it lived: 12 of 13, looked at every 5 frames. */
static void test_last_frame(void)
{
    struct run_keep keep = {
        .file = file, .every = 5, .fields = RUN_FIELDS_ALL, .quick = true, .doubles = true};
    struct run_result r;

    script_reset();
    script.dies = 13, script.death = STATUS_DIVERGED;
    write_script(0.1, &keep, &r);
    CHECK(r.outcome == STATUS_DIVERGED && r.death_time == 13 * 0.005);
    CHECK(r.value[MEASURE_END_TIME] == 12 * 0.005 && r.work.steps == 12);
    read_back(true, &r);
    REQUIRE(r.frames == 4 && r.quick);
    for (int n = 0; n < 4; n++) {
        const int frame = n < 3 ? 5 * n : 12;
        CHECK(r.time[n] == frame * 0.005);
        CHECK(r.xyz[n][2] == r.xyz[0][2] + 1e-3 * frame);
    }
    run_result_clear(&r);
    check_array("energy/kinetic", 4, (const double[]){0, 5, 10, 12}); /* not the dead's */
    keep.fields = RUN_FIELDS_NONE;
    write_script(0.1, &keep, &r);
    CHECK(r.value[MEASURE_END_TIME] == 10 * 0.005);
}

/* Times on the way, the last one after the end; a look at each, a field at each. */
static void test_times(void)
{
    const double time[] = {0, 0.03, 0.035, 0.1, 0.2};
    struct run_keep keep = {.file = file, .times = 5, .time = time};
    struct run_result r;

    script_reset();
    write_script(0.1, &keep, &r);
    CHECK(r.outcome == STATUS_OK && r.value[MEASURE_END_TIME] == 20 * 0.005);
    read_back(true, &r);
    REQUIRE(r.frames == 4 && !r.quick);
    for (int n = 0; n < 4; n++) {
        CHECK_NEAR(r.time[n], time[n], 1e-15);
        CHECK_NEAR(r.xyz[n][2] - r.xyz[0][2], time[n] / 5, 1e-7); /* stored as floats */
    }
    CHECK(r.step.count == 1 && r.steps == 20);
    run_result_clear(&r);
    /* no frame at all: the state at the start */
    script_reset();
    keep = (struct run_keep){.file = file, .every = 1};
    write_script(1e-3, &keep, &r);
    CHECK(r.outcome == STATUS_OK && r.steps == 0 && r.value[MEASURE_END_TIME] == 0);
    CHECK(script_advances == 0);
    /* and a death in the first frame */
    script.dies = 1, script.death = STATUS_NAN;
    keep.every = 0;
    write_script(0.1, &keep, &r);
    CHECK(r.outcome == STATUS_NAN && r.death_time == 0.005 && r.steps == 1);
}

/* A sheet at rest has one look, at 0 s, and nothing that moved. */
static void test_rest(void)
{
    const struct measurement_options options = {.again = true};
    struct case_plan c = {
        DROP,         &scripted,   .timed = CASE_FAIR, .keep = {.file = file},
        .rest = true, .repeats = 2};
    struct run_result r;

    script_reset();
    REQUIRE(measurement_run(&options, 1, &c, NULL) == STATUS_OK);
    read_back(true, &r);
    CHECK(r.outcome == STATUS_OK && r.frames == 1 && r.time[0] == 0 && r.steps == 0);
    CHECK(r.step.count == 2 && r.work.solves == 1 && !r.work.steps && r.unknowns == 12);
    run_result_clear(&r);
    script.equilibrium = STATUS_DIVERGED;
    REQUIRE(measurement_run(&options, 1, &c, NULL) == STATUS_OK);
    read_back(true, &r);
    CHECK(r.outcome == STATUS_DIVERGED && !r.frames && !r.step.count);
    run_result_clear(&r);
    script.equilibrium = STATUS_LIBRARY; /* no result, and no file of it */
    unlink(file);
    CHECK(measurement_run(&options, 1, &c, NULL) == STATUS_LIBRARY);
    CHECK(access(file, F_OK) != 0);
}

/* Only the lower side of the edge is held, and a net of springs has no lower side; a net of
 * fewer points than a span needs. */
static void test_refusals(void)
{
    static const struct {
        const char *contestant, *setting;
        enum status status;
    } want[] = {
        {"mass_spring", "supports=[{at: {u: 0, w: 0}, fix: xyz}]", STATUS_UNSUPPORTED},
        {"iga_paper", "discretization.points=[2,2,2]", STATUS_INPUT}};
    struct run_result r, timed;

    for (int n = 0; n < LENGTH(want); n++) {
        struct case_plan c = {
            DROP, named(want[n].contestant), LIST(want[n].setting),
            0.05, .timed = CASE_FAIR,        .keep = {.file = file, .every = 5}};
        write_run(&c, &c.keep, &r);
        CHECK(r.outcome == want[n].status && run_result_refused(&r));
        CHECK(isnan(r.value[MEASURE_STRETCH_MAX]) && isnan(r.value[MEASURE_BLOWUP_TIME]));
        CHECK(isnan(r.death_time) && r.value[MEASURE_GAMMA] > 0 && r.steps == 0);
        for (int rest = 0; rest < 2; rest++) {
            c.rest = rest;
            REQUIRE(measurement_run(&(struct measurement_options){0}, 1, &c, NULL) ==
                    STATUS_OK);
            read_back(true, &timed);
            CHECK(timed.outcome == r.outcome && !timed.step.count && !timed.frames);
            CHECK(!strcmp(timed.sentence.text, r.sentence.text));
            run_result_clear(&timed);
        }
        settings_clear(&c.settings);
    }
    script_reset(); /* a death before the first frame */
    script.create = STATUS_INDEFINITE;
    write_script(0, &(struct run_keep){.file = file, .every = 1}, &r);
    CHECK(r.outcome == STATUS_INDEFINITE && r.death_time == 0);
}

/* A failure that is no result leaves no file. */
static void test_failures(void)
{
    struct settings s = LIST("discretization.degree=[9,9,1]");
    const struct {
        struct case_plan plan;
        enum status create, death, want;
        const char *file;
    } row[] = {{{DROP, named("iga"), s, 0}, 0, 0, STATUS_INPUT, file},
               {{"/proc/nowhere.yaml", named("iga"), {0}, 0}, 0, 0, STATUS_INPUT, file},
               {{DROP, &scripted, {0}, 0}, STATUS_MEMORY, 0, STATUS_MEMORY, file},
               /* no death, a failure */
               {{DROP, &scripted, {0}, 0}, 0, STATUS_LIBRARY, STATUS_LIBRARY, file},
               {{DROP, &scripted, {0}, 0}, 0, 0, STATUS_FILE, "/proc/no/run.h5"}};
    struct run_result r;

    unlink(file);
    unlink(view);
    for (int n = 0; n < LENGTH(row); n++) {
        struct case_plan c = row[n].plan;
        c.keep = (struct run_keep){.file = row[n].file, .every = 1};
        script_reset();
        script.create = row[n].create;
        script.dies = 3 * (row[n].death != STATUS_OK), script.death = row[n].death;
        CHECK(run_file_write(&c, &r, NULL) == row[n].want);
        CHECK(access(file, F_OK) != 0 && access(view, F_OK) != 0);
    }
    CHECK(run_result_read(file, true, &r, NULL) == STATUS_FILE);
    settings_clear(&s);
}

/* --- deaths: who moves a sheet tells the same of the same run: code and time -------------
 */

static void check_told(const struct run_result *r, enum status death, int frame)
{
    CHECK(r->outcome == death && r->death_time == frame * 0.005);
    CHECK(r->value[MEASURE_BLOWUP_TIME] == r->death_time);
}

static void check_death(const struct case_plan *plan, enum status death, int frame)
{
    const double late[] = {0.4, 0.5};
    struct run_keep keep = {.times = 2, .time = late};
    const struct measurement_options quick = {.quick = true};
    struct run_result r;

    for (int n = 0; n < 2; n++) { /* looked at before it dies, or kept and not */
        keep.every = n ? 10 : 0;
        keep.file = n ? NULL : file;
        write_run(plan, &keep, &r);
        check_told(&r, death, frame);
        CHECK(r.steps == frame);
        CHECK(n ? r.value[MEASURE_END_TIME] == (frame - 1) / 10 * 10 * 0.005
                : isnan(r.value[MEASURE_END_TIME]));
    }
    keep.file = file;
    struct case_plan c = *plan;
    c.keep = keep;
    c.timed = CASE_WHOLE;
    c.repeats = 1;
    REQUIRE(measurement_run(&quick, 1, &c, NULL) == STATUS_OK);
    read_back(false, &r);
    check_told(&r, death, frame);
    CHECK(r.step.count == 1 && !r.frames);
    run_result_clear(&r);
}

static void test_deaths(void)
{
    struct settings undamped = LIST("damping.value=1");
    struct settings row7 =
        LIST("material.young=5e4", "material.density=0.1", "damping.value=0.9");

    check_death(
        &(struct case_plan){SCENES "corners_drop.yaml", named("iga_paper"), undamped, 0},
        STATUS_ESCAPED, 36);
    check_death(&(struct case_plan){DROP, named("iga_paper"), row7, 0.5}, STATUS_INVERTED,
                53);
    settings_clear(&undamped);
    settings_clear(&row7);
}

/* --- files whose arrays were put there by hand ------------------------------------------
 */

struct array {
    const char *name;
    int rows, columns;
    double value[9];
};

/* A run of five looks (frames 0, 5, ..., 20) with these arrays, and an attribute, in it. */
static enum status read_with(int count, const struct array *arrays, const char *key,
                             const char *text, struct run_result *r, struct message *why)
{
    const struct case_plan c = {
        DROP, &scripted, {0}, 0.1, {.file = file, .every = 5, .fields = RUN_FIELDS_NONE}};

    script_reset();
    REQUIRE(run_file_write(&c, NULL, NULL) == STATUS_OK);
    hid_t id = H5Fopen(file, H5F_ACC_RDWR, H5P_DEFAULT);
    REQUIRE(id >= 0);
    for (int n = 0; n < count; n++) {
        const struct array *a = &arrays[n];
        H5Ldelete(id, a->name, H5P_DEFAULT); /* if it is there */
        REQUIRE(!a->rows ||
                hdf5_file_put_array(id, a->name, (struct hdf5_file_meaning){"s", "repeat"},
                                    a->value, a->rows, a->columns) >= 0);
    }
    REQUIRE(!key || H5Adelete(id, key) >= 0);
    REQUIRE(!text || hdf5_file_put_text(id, key, text) >= 0);
    H5Fclose(id);
    REQUIRE(seal_write(file, NULL) == STATUS_OK);
    *r = (struct run_result){0};
    return run_result_read(file, true, r, why);
}

/* Seconds are summaries of each repeat's mean step; a death leaves some out, or all. */
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

    REQUIRE(read_with(LENGTH(arrays), arrays, NULL, NULL, &r, NULL) == STATUS_OK);
    CHECK(r.create.count == 3 && r.create.min == 0.25 && r.create.median == 0.5);
    CHECK(r.create.max == 1 && r.create_seconds == 0.25);
    CHECK(r.step.count == 2 && r.step.min == 2 && r.step.max == 6 && r.step.median == 4);
    CHECK(r.step_seconds == 6 && r.steps == 3 && r.look_seconds == 7);
    for (int p = 0; p < RUN_RESULT_PHASES; p++)
        CHECK(r.phase[p].count == 2 + (p == 2) && r.phase[p].min == 10 + p);
    run_result_clear(&r);
    REQUIRE(read_with(LENGTH(rest), rest, NULL, NULL, &r, NULL) == STATUS_OK);
    CHECK(r.step.count == 2 && r.step.min == 5 && r.step.max == 9);
    CHECK(r.steps == 0 && r.step_seconds == 0 && r.phase[0].count == 0);
    run_result_clear(&r);
}

/* Work up to the last look; the drift that only these energies make; distances to a truth,
 * where both series of it are there. */
static void test_series(void)
{
    static const struct array arrays[] = {
        {"metrics/truth_error", 5, 0, {NAN, 0.5, NAN, 0.25, NAN}},
        {"metrics/truth_bar", 5, 0, {NAN, 0.125, NAN, 0.0625, NAN}},
        {"energy/kinetic", 5, 0, {0, 1, 2, 3, 4}},
        {"energy/elastic", 5, 0, {10, 10, 10, 10, 10}},
        {"energy/potential", 5, 0, {0, 0, 0, 0, 0.5}},
        {"counters/steps", 2, 0, {1, 11}},
        {"counters/assemblies", 2, 0, {1, 12}},
        {"counters/factorisations", 2, 0, {1, 13}},
        {"counters/solves", 2, 0, {1, 14}},
        {"counters/iterations", 1, 0, {15}},
        {"counters/substeps", 2, 0, {1, 16}},
        {"counters/left", 2, 0, {0.5, 0.75}}};
    const struct counters work = {11, 12, 13, 14, 15, 16, .left = 0.75};
    struct energy energy[5];
    double drift[5];
    struct run_result r;

    for (int count = 0; count < 2; count++) {
        REQUIRE(read_with(count, arrays, NULL, NULL, &r, NULL) == STATUS_OK);
        CHECK(isnan(r.value[MEASURE_TRUTH_ERROR_MAX]));
        run_result_clear(&r);
    }
    REQUIRE(read_with(LENGTH(arrays), arrays, NULL, NULL, &r, NULL) == STATUS_OK);
    CHECK(r.value[MEASURE_TRUTH_ERROR_MAX] == 0.5);
    CHECK(r.value[MEASURE_TRUTH_ERROR_END] == 0.25);
    CHECK(r.value[MEASURE_TRUTH_BAR_END] == 0.0625);
    CHECK(!memcmp(&r.work, &work, sizeof work));
    for (int n = 0; n < 5; n++)
        energy[n] = (struct energy){n, 10, n == 4 ? 0.5 : 0};
    metric_energy_drift(5, energy, drift);
    CHECK(r.value[MEASURE_ENERGY_DRIFT_END] == drift[4] && drift[4] != drift[3]);
    run_result_clear(&r);
}

static void test_misfits(void)
{
    static const struct {
        struct array array;
        const char *key, *text;
    } want[] = {{{"metrics/drop", 2, 0, {0, 1}}},
                {{"metrics/speed", 5, 2, {0}}},
                {{"metrics/truth_error", 2, 0, {0, 1}}},
                {{"energy/kinetic", 1, 0, {0}}},
                {{"energy/kinetic", 0, 0, {0}}},
                {{"energy/elastic", 0, 0, {0}}},
                {{"energy/potential", 0, 0, {0}}},
                {{"xyz_time", 2, 0, {0, 1}}},
                {{"xyz_time", 0, 0, {0}}},
                {{"metrics/drop", 0, 0, {0}}},
                {{"counters/steps", 0, 0, {0}}},
                {{"none", 0, 0, {0}}, "outcome", "flew away"},
                {{"none", 0, 0, {0}}, "outcome", "bad input"},
                {{"none", 0, 0, {0}}, "scene", NULL}};
    struct run_result r;

    for (int n = 0; n < LENGTH(want); n++) {
        struct message why = {""};
        CHECK(read_with(1, &want[n].array, want[n].key, want[n].text, &r, &why) ==
              STATUS_INPUT);
        CHECK(strstr(why.text, file));
    }
}

static void look(const void *context, double time, const double *xyz, double *error,
                 double *bar)
{
    *error = xyz ? 100 * time : NAN;
    *bar = *(const double *)context;
}

/* Distances from a truth and its bars, under their names. */
static void test_truth(void)
{
    static const double want[LOOKS_TRUTH][3] = {{0, 5, 10}, {7, 7, 7}};
    double context = 7;
    const struct case_plan c = {DROP,
                                &scripted,
                                {0},
                                0.1,
                                {.file = file,
                                 .every = 10,
                                 .fields = RUN_FIELDS_NONE,
                                 .truth = look,
                                 .context = &context}};

    script_reset();
    REQUIRE(run_file_write(&c, NULL, NULL) == STATUS_OK);
    for (int n = 0; n < LOOKS_TRUTH; n++) {
        char name[64];
        snprintf(name, sizeof name, "metrics/%s", looks_truth[n]);
        check_array(name, 3, want[n]);
    }
}

int main(int argc, char **argv)
{
    const bool dying = argc > 1 && !strcmp(argv[1], "deaths");

    scratch_open();
    file = scratch_path("run.h5");
    view = scratch_path("run.xdmf");
    if (dying) {
        test_deaths();
        return check_result();
    }
    test_same_bits();
    test_load();
    test_forces();
    test_crossing();
    test_last_frame();
    test_times();
    test_rest();
    test_refusals();
    test_failures();
    test_seconds();
    test_series();
    test_misfits();
    test_truth();
    CHECK(scratch_files(scratch) <= 2);
    return check_result();
}

/* The one runner: the same bits from the run and from its file, with fields and without;
 * looks and fields where they were asked for; measures that are those of the run's own
 * metrics; deaths and refusals are results. */
#include "bench/harness/run_file.h"

#include <unistd.h>

#include "bench/experiment/measurement.h"
#include "bench/files/hdf5_file.h"
#include "bench/files/seal.h"
#include "bench/files/store.h"
#include "models/metric/metric.h"
#include "tests/run_fixture.h"
#include "tests/scratch.h"
#include "tests/scripted_model.h"

#define FIELD ((size_t)3 * GRID_POINTS)

static const char *file, *view;

/* The reading that NAME.h5 gives, which is to be the same. */
static void check_file(const struct run_result *r)
{
    struct run_result back;
    struct message why = {""};

    if (!CHECK(run_result_read(file, true, &back, &why) == STATUS_OK)) {
        printf("  %s\n", why.text);
        return;
    }
    CHECK(back.outcome == r->outcome && !strcmp(back.sentence.text, r->sentence.text));
    CHECK(!memcmp(&back.death_time, &r->death_time, sizeof r->death_time));
    CHECK(!memcmp(back.value, r->value, sizeof r->value));
    CHECK(!memcmp(&back.work, &r->work, sizeof r->work));
    CHECK(back.create_seconds == r->create_seconds && back.look_seconds == r->look_seconds);
    CHECK(back.step_seconds == r->step_seconds && back.steps == r->steps);
    run_result_clear(&back);
}

static bool same(const struct run_result *a, const struct run_result *b)
{
    return a->outcome == b->outcome && !strcmp(a->sentence.text, b->sentence.text) &&
           !memcmp(a->value, b->value, sizeof a->value) &&
           !memcmp(&a->work, &b->work, sizeof a->work) && a->steps == b->steps;
}

static void write_run(const struct run_plan *plan, const struct run_keep *keep,
                      struct run_result *r)
{
    struct message why = {""};

    if (!CHECK(run_file_write(plan, keep, r, &why) == STATUS_OK))
        printf("  %s\n", why.text);
    if (keep->file)
        check_file(r);
}

/* Twice without a file, with one, fields kept and not, and read back: 40 frames. */
static void test_same_bits(void)
{
    const double time[] = {0.1};
    struct settings s = LIST("discretization.points=[6,6,2]");
    struct run_plan plan = {DROP, named("iga_paper"), &s, 0.2};
    struct run_keep keep = {.every = 7, .times = 1, .time = time, .intersections = true};
    struct run_result first, other, back;
    double *seen[2];

    write_run(&plan, &keep, &first);
    write_run(&plan, &keep, &other);
    CHECK(same(&first, &other) && first.steps == 40 && first.step_seconds > 0);
    keep.file = file;
    for (keep.fields = RUN_FIELDS_TIMES; keep.fields <= RUN_FIELDS_NONE; keep.fields++) {
        const int want[] = {1, 8, 0}; /* looks at frames 0 7 14 20 21 28 35 40 */
        write_run(&plan, &keep, &other);
        CHECK(same(&first, &other));
        REQUIRE(run_result_read(file, true, &back, NULL) == STATUS_OK);
        CHECK(back.frames == want[keep.fields] && back.unknowns == 6 * 6 * 2 * 3 - 36);
        if (back.frames) /* 0.1 s, which is no multiple of the looks */
            CHECK(back.time[back.frames > 1 ? 3 : 0] == 20 * 0.005);
        if (back.frames)
            seen[keep.fields] = back.xyz[back.frames > 1 ? 3 : 0],
            back.xyz[back.frames > 1 ? 3 : 0] = NULL;
        run_result_clear(&back);
    }
    CHECK(!memcmp(seen[0], seen[1], FIELD * sizeof(double)));
    free(seen[0]);
    free(seen[1]);
    settings_clear(&s);
}

/* What a run frame by frame says of the looks: frames 0, 7, 14, 20 (asked), 21, ..., 40. */
struct own {
    double most[4], end[4], *xyz, *before, speed, speed_most, time;
};

static enum status watch(void *context, const struct motion *m, struct message *why)
{
    struct own *own = context;

    (void)why;
    if (m->frames % 7 && m->frames != 20 && m->frames != 40)
        return STATUS_OK;
    m->model->sample(m->state, own->xyz);
    own->end[0] = metric_stretch(m->scene, own->xyz);
    own->end[1] = metric_drop(m->scene, own->xyz);
    own->end[2] = metric_angle(m->scene, own->xyz);
    own->end[3] = metric_roughness(m->scene, own->xyz);
    for (int n = 0; n < 4; n++)
        own->most[n] = fmax(own->most[n], own->end[n]);
    if (m->frames)
        own->speed = metric_rmse(own->xyz, own->before) / (m->time - own->time);
    own->speed_most = fmax(own->speed_most, own->speed);
    own->time = m->time;
    memcpy(own->before, own->xyz, FIELD * sizeof(double));
    return STATUS_OK;
}

static void check_own(const struct run_result *r, const struct own *own)
{
    static const int most[] = {MEASURE_STRETCH_MAX, MEASURE_DROP_MAX, MEASURE_ANGLE_MAX,
                               MEASURE_ROUGHNESS_MAX};
    static const int end[] = {MEASURE_STRETCH_END, MEASURE_DROP_END, MEASURE_ANGLE_END,
                              MEASURE_ROUGHNESS_END};

    for (int n = 0; n < 4; n++) {
        CHECK(r->value[most[n]] == own->most[n] && own->most[n] > 0);
        CHECK(r->value[end[n]] == own->end[n]);
    }
    CHECK(r->value[MEASURE_SPEED_END] == own->speed);
    CHECK(r->value[MEASURE_SPEED_MAX] == own->speed_most);
    CHECK(r->value[MEASURE_END_TIME] == own->time && own->time == 40 * 0.005);
}

static void test_own_metrics(void)
{
    const double time[] = {0.1};
    struct settings s = LIST("discretization.points=[6,6,2]");
    const struct run_plan plan = {DROP, named("iga_paper"), &s, 0.2};
    const struct run_keep keep = {
        .every = 7, .times = 1, .time = time, .intersections = true};
    struct own own = {.xyz = malloc(FIELD * sizeof(double)),
                      .before = malloc(FIELD * sizeof(double))};
    struct run_result r;
    struct run run;
    struct motion m;

    REQUIRE(own.xyz && own.before);
    write_run(&plan, &keep, &r);
    REQUIRE(run_open(&run, &plan, NULL) == STATUS_OK);
    REQUIRE(motion_init(&m, run.model, &run.scene, run.state) == STATUS_OK);
    REQUIRE(motion_run(&m, watch, &own, true, NULL) == STATUS_OK);
    check_own(&r, &own);
    CHECK(r.value[MEASURE_GAMMA] == scene_gamma(&run.scene));
    CHECK(r.value[MEASURE_YOUNG_OVER_DENSITY] == 1e5 / 0.5);
    CHECK(r.outcome == STATUS_OK && !strcmp(r.sentence.text, "done") &&
          isnan(r.death_time));
    CHECK(isinf(r.value[MEASURE_BLOWUP_TIME]) && isinf(r.value[MEASURE_INTERSECTION_TIME]));
    CHECK(r.value[MEASURE_INTERSECTIONS_MAX] == 0);
    CHECK(isnan(r.value[MEASURE_PENETRATION_MAX])); /* there is nothing to penetrate */
    motion_clear(&m);
    run_close(&run);
    settings_clear(&s);
    free(own.xyz);
    free(own.before);
}

/* Undamped springs keep their energy up to their scheme's loss; the printed scheme has no
 * elastic energy at all. */
/* A sheet that has come to rest on the ground is carried by it, and one that hangs by
 * nothing. */
static void test_load(void)
{
    static const double AT_REST = 0.05; /* its last small bounces, over its weight */
    struct settings s = {0};
    struct run_result r;

    settings_set(&s, "damping={kind: none}");
    settings_set(&s, "discretization.points=[6,6]");
    write_run(&(struct run_plan){SOURCE_DIR "/models/scenes/ground.yaml",
                                 named("mass_spring"), &s, 0},
              &(struct run_keep){.every = 1}, &r);
    CHECK_NEAR(r.value[MEASURE_LOAD_END], 1, AT_REST);
    CHECK(r.value[MEASURE_LOAD_MAX] > 1.5); /* it fell */
    settings_set(&s, "time.end=0.1");
    write_run(&(struct run_plan){DROP, named("mass_spring"), &s, 0},
              &(struct run_keep){.every = 1}, &r);
    CHECK(isnan(r.value[MEASURE_LOAD_END]) && isnan(r.value[MEASURE_LOAD_MAX]));
    settings_clear(&s);
}

static void test_energy(void)
{
    struct settings s = LIST("damping={kind: none}");
    struct run_keep keep = {.file = file, .every = 7};
    struct run_result r;

    write_run(&(struct run_plan){DROP, named("iga_paper"), NULL, 0.05}, &keep, &r);
    CHECK(isnan(r.value[MEASURE_ENERGY_DRIFT_END]));
    CHECK(isnan(r.value[MEASURE_ENERGY_DRIFT_MAX]));
    write_run(&(struct run_plan){DROP, named("mass_spring"), &s, 0.2}, &keep, &r);
    CHECK(r.value[MEASURE_ENERGY_DRIFT_END] < 0 && r.value[MEASURE_ENERGY_DRIFT_END] > -1);
    CHECK(r.value[MEASURE_ENERGY_DRIFT_MAX] >= 0);
    CHECK(isnan(r.value[MEASURE_INTERSECTIONS_MAX])); /* not asked for */
    CHECK(isnan(r.value[MEASURE_INTERSECTION_TIME]));
    settings_clear(&s);
}

/* The last frame that it lived: 12 of 13, looked at every 5 frames. */
static void test_last_frame(void)
{
    const struct run_plan plan = {DROP, &scripted, NULL, 0.1};
    struct run_keep keep = {
        .file = file, .every = 5, .fields = RUN_FIELDS_ALL, .doubles = true};
    struct store_read *store = NULL;
    struct run_result r;
    double *kinetic = NULL;
    int rows = 0, columns;

    script_reset();
    script.dies = 13, script.death = STATUS_DIVERGED;
    write_run(&plan, &keep, &r);
    CHECK(r.outcome == STATUS_DIVERGED && r.death_time == 13 * 0.005);
    CHECK(r.value[MEASURE_END_TIME] == 12 * 0.005 && r.work.steps == 12);
    REQUIRE(run_result_read(file, true, &r, NULL) == STATUS_OK);
    REQUIRE(r.frames == 4);
    for (int n = 0; n < 4; n++) {
        const int frame = n < 3 ? 5 * n : 12;
        CHECK(r.time[n] == frame * 0.005);
        CHECK(r.xyz[n][2] == r.xyz[0][2] + 1e-3 * frame);
    }
    run_result_clear(&r);
    REQUIRE(store_read_open(file, &store, NULL) == STATUS_OK);
    CHECK(store_read_array(store, "energy/kinetic", &kinetic, &rows, &columns, NULL) ==
          STATUS_OK);
    CHECK(rows == 4 && kinetic[2] == 10 && kinetic[3] == 12); /* not of the dead state */
    free(kinetic);
    store_read_close(store);
    keep.fields = RUN_FIELDS_NONE;
    write_run(&plan, &keep, &r);
    CHECK(r.value[MEASURE_END_TIME] == 10 * 0.005);
}

/* What the file says of how and for whom it was made; nothing where nobody said so. */
static void test_made_for(void)
{
    static const char *const made_for[] = {NULL, "case 12 of a test"};

    for (int n = 0; n < 4; n++) {
        const struct run_keep keep = {
            .file = file, .every = 5, .quick = n % 2, .made_for = made_for[n / 2]};
        struct run_result r;

        script_reset();
        write_run(&(struct run_plan){DROP, &scripted, NULL, 0.05}, &keep, &r);
        CHECK(r.quick == n % 2);
        REQUIRE(run_result_read(file, false, &r, NULL) == STATUS_OK);
        CHECK(r.quick == n % 2);
        CHECK(!strcmp(r.made_for, made_for[n / 2] ? made_for[n / 2] : ""));
        run_result_clear(&r);
    }
}

/* Times on the way, the last one after the end; a look at each, a field at each. */
static void test_times(void)
{
    const double time[] = {0, 0.03, 0.035, 0.1, 0.2};
    struct run_keep keep = {.file = file, .times = 5, .time = time};
    struct run_result r;

    script_reset();
    write_run(&(struct run_plan){DROP, &scripted, NULL, 0.1}, &keep, &r);
    CHECK(r.outcome == STATUS_OK && r.value[MEASURE_END_TIME] == 20 * 0.005);
    REQUIRE(run_result_read(file, true, &r, NULL) == STATUS_OK);
    REQUIRE(r.frames == 4);
    for (int n = 0; n < 4; n++) {
        CHECK_NEAR(r.time[n], time[n], 1e-15);
        CHECK_NEAR(r.xyz[n][2] - r.xyz[0][2], time[n] / 5, 1e-7); /* stored as floats */
    }
    CHECK(r.step.count == 1 && r.steps == 20);
    run_result_clear(&r);
    /* no frame at all: the state at the start */
    script_reset();
    keep = (struct run_keep){.file = file, .every = 1};
    write_run(&(struct run_plan){DROP, &scripted, NULL, 1e-3}, &keep, &r);
    CHECK(r.outcome == STATUS_OK && r.steps == 0 && r.value[MEASURE_END_TIME] == 0);
    CHECK(script_advances == 0);
    /* and a death in the first frame */
    script.dies = 1, script.death = STATUS_NAN;
    keep.every = 0;
    write_run(&(struct run_plan){DROP, &scripted, NULL, 0.1}, &keep, &r);
    CHECK(r.outcome == STATUS_NAN && r.death_time == 0.005 && r.steps == 1);
}

/* At rest: one look, at 0 s, and nothing that moved. */
static void test_rest(void)
{
    const struct measurement_options options = {.repeats = 2, .again = true};
    struct measurement_case c = {
        .plan = {DROP, &scripted, NULL, 0}, .keep = {.file = file}, .rest = true};
    struct run_result r;

    script_reset();
    REQUIRE(measurement_run(&options, 1, &c, NULL) == STATUS_OK);
    REQUIRE(run_result_read(file, true, &r, NULL) == STATUS_OK);
    CHECK(r.outcome == STATUS_OK && r.frames == 1 && r.time[0] == 0 && r.steps == 0);
    CHECK(r.step.count == 2 && r.work.solves == 1 && !r.work.steps && r.unknowns == 12);
    run_result_clear(&r);
    script.equilibrium = STATUS_DIVERGED;
    REQUIRE(measurement_run(&options, 1, &c, NULL) == STATUS_OK);
    REQUIRE(run_result_read(file, true, &r, NULL) == STATUS_OK);
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
        const char *contestant, *setting, *word;
        enum status status;
    } want[] = {{"mass_spring", "supports=[{at: {u: 0, w: 0}, fix: xyz}]", "thickness",
                 STATUS_UNSUPPORTED},
                {"iga_paper", "discretization.points=[2,2,2]", "functions", STATUS_INPUT}};
    struct run_result r, timed;

    for (int n = 0; n < LENGTH(want); n++) {
        struct settings s = LIST(want[n].setting);
        struct measurement_case c = {.plan = {DROP, named(want[n].contestant), &s, 0.05},
                                     .keep = {.file = file, .every = 5}};
        write_run(&c.plan, &c.keep, &r);
        CHECK(r.outcome == want[n].status && run_result_refused(&r));
        if (!CHECK(strstr(r.sentence.text, want[n].word)))
            printf("  %s\n", r.sentence.text);
        CHECK(isnan(r.value[MEASURE_STRETCH_MAX]) && isnan(r.value[MEASURE_BLOWUP_TIME]));
        CHECK(isnan(r.death_time) && r.value[MEASURE_GAMMA] > 0 && r.steps == 0);
        for (int rest = 0; rest < 2; rest++) {
            c.rest = rest;
            REQUIRE(measurement_run(&(struct measurement_options){0}, 1, &c, NULL) ==
                    STATUS_OK);
            REQUIRE(run_result_read(file, true, &timed, NULL) == STATUS_OK);
            CHECK(timed.outcome == r.outcome && !timed.step.count && !timed.frames);
            CHECK(!strcmp(timed.sentence.text, r.sentence.text));
            run_result_clear(&timed);
        }
        settings_clear(&s);
    }
    script_reset(); /* a death before the first frame */
    script.create = STATUS_INDEFINITE;
    write_run(&(struct run_plan){DROP, &scripted, NULL, 0},
              &(struct run_keep){.file = file, .every = 1}, &r);
    CHECK(r.outcome == STATUS_INDEFINITE && r.death_time == 0);
    CHECK(strstr(r.sentence.text, "died at t = 0 s"));
}

/* What is no result leaves no file, and a sentence. */
static void test_failures(void)
{
    struct settings s = LIST("discretization.degree=[9,9,1]");
    struct run_keep keep = {.file = file, .every = 1};
    struct message why = {""};
    struct run_result r;

    unlink(file);
    unlink(view);
    CHECK(run_file_write(&(struct run_plan){DROP, named("iga"), &s, 0}, &keep, &r, &why) ==
          STATUS_INPUT);
    CHECK(strstr(why.text, "degree"));
    CHECK(run_file_write(&(struct run_plan){"/proc/nowhere.yaml", named("iga"), NULL, 0},
                         &keep, &r, &why) == STATUS_FILE);
    script_reset();
    script.create = STATUS_MEMORY;
    CHECK(run_file_write(&(struct run_plan){DROP, &scripted, NULL, 0}, &keep, &r, &why) ==
          STATUS_MEMORY);
    CHECK(strstr(why.text, "would not"));
    script_reset();
    script.dies = 3, script.death = STATUS_LIBRARY; /* no death, a failure */
    CHECK(run_file_write(&(struct run_plan){DROP, &scripted, NULL, 0}, &keep, &r, &why) ==
          STATUS_LIBRARY);
    CHECK(access(file, F_OK) != 0 && access(view, F_OK) != 0);
    CHECK(run_result_read(file, true, &r, &why) == STATUS_FILE && strstr(why.text, file));
    keep.file = "/proc/nowhere/run.h5";
    script_reset();
    CHECK(run_file_write(&(struct run_plan){DROP, &scripted, NULL, 0}, &keep, &r, &why) ==
          STATUS_FILE);
    CHECK(strstr(why.text, "/proc/nowhere"));
    settings_clear(&s);
}

/* Files that somebody has cut. */
static void test_damaged(void)
{
    static const char *const part[] = {"xyz_time", "metrics/drop", "counters/steps",
                                       "energy/kinetic"};
    struct run_keep keep = {.file = file, .every = 4, .fields = RUN_FIELDS_ALL};
    struct run_result r;
    struct message why = {""};

    for (int n = 0; n < LENGTH(part); n++) {
        script_reset();
        write_run(&(struct run_plan){DROP, &scripted, NULL, 0.1}, &keep, &r);
        hid_t id = H5Fopen(file, H5F_ACC_RDWR, H5P_DEFAULT);
        REQUIRE(id >= 0 && H5Ldelete(id, part[n], H5P_DEFAULT) >= 0);
        H5Fclose(id);
        REQUIRE(seal_write(file, NULL) == STATUS_OK);
        CHECK(run_result_read(file, true, &r, &why) == STATUS_INPUT);
        CHECK(strstr(why.text, part[n]) && strstr(why.text, file));
    }
    write_run(&(struct run_plan){DROP, &scripted, NULL, 0.1}, &keep, &r);
    hid_t id = H5Fopen(file, H5F_ACC_RDWR, H5P_DEFAULT);
    REQUIRE(id >= 0 && H5Ldelete(id, "xyz_time", H5P_DEFAULT) >= 0);
    REQUIRE(hdf5_file_put_array(id, "xyz_time", (struct hdf5_file_meaning){"s", "repeat"},
                                (const double[]){0, 1}, 2, 0) >= 0);
    H5Fclose(id);
    REQUIRE(seal_write(file, NULL) == STATUS_OK);
    CHECK(run_result_read(file, true, &r, &why) == STATUS_INPUT);
    CHECK(strstr(why.text, "6 fields at 2 times"));
}

static void test_words(void)
{
    for (int n = 0; n < MEASURES; n++)
        CHECK(strcmp(measure_name(n), "unknown") && *measure_sentence(n));
    static const int none[] = {-1, MEASURES, MEASURES + 1, -2000000000, 2000000000};
    for (int n = 0; n < LENGTH(none); n++)
        CHECK(!strcmp(measure_name(none[n]), "unknown") && !*measure_unit(none[n]) &&
              !*measure_sentence(none[n]));
    CHECK(!strcmp(measure_name(MEASURE_GAMMA), "gamma"));
    CHECK(!strcmp(measure_unit(MEASURE_SPEED_END), "m/s"));
}

int main(void)
{
    scratch_open();
    file = scratch_path("run.h5");
    view = scratch_path("run.xdmf");
    test_same_bits();
    test_own_metrics();
    test_load();
    test_energy();
    test_last_frame();
    test_made_for();
    test_times();
    test_rest();
    test_refusals();
    test_failures();
    test_damaged();
    test_words();
    CHECK(scratch_files(scratch) == 2);
    return check_result();
}

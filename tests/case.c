/* Cases: the same bits on every run, from the file and without it; measures that are those
 * of the run's own metrics; deaths and models that leave something out are results. */
#include "bench/harness/case.h"

#include <unistd.h>

#include "bench/harness/motion.h"
#include "bench/files/store_read.h"
#include "bench/harness/trial.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/check.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))
#define SCENES       SOURCE_DIR "/models/scenes/"

static char folder[] = "/tmp/clothbench-case-XXXXXX";
static char file[256];

static const char *const drop[] = {"discretization.points=[6,6,2]", "time.end=0.2",
                                   "snapshots=[0.1]"};

static struct case_plan drop_plan(void)
{
    return (struct case_plan){.path = SCENES "edge_drop.yaml",
                              .setting_count = COUNT(drop),
                              .settings = drop,
                              .model = "iga",
                              .every = 7,
                              .intersections = true};
}

static bool same(const struct case_result *a, const struct case_result *b)
{
    return a->outcome == b->outcome && !strcmp(a->sentence.text, b->sentence.text) &&
           !memcmp(a->value, b->value, sizeof a->value);
}

/* The field is that of 0.1 s, which is no multiple of the looks. */
static void check_snapshot(const struct store_read *store)
{
    double *time = NULL;
    int rows = 0, columns;
    struct message why = {""};

    CHECK(store_read_array(store, "xyz_time", &time, &rows, &columns, &why) == STATUS_OK);
    if (CHECK(rows == 1))
        CHECK(time[0] == 20 * 0.005);
    free(time);
}

/* Twice without a file, with one, with snapshots kept, and read back. */
static void test_same_bits(void)
{
    struct case_plan plan = drop_plan();
    struct case_result first, other;
    struct message why = {""};
    struct store_read *store = NULL;

    REQUIRE(case_run(&plan, &first, &why) == STATUS_OK);
    REQUIRE(case_run(&plan, &other, &why) == STATUS_OK);
    CHECK(same(&first, &other));
    for (int kept = 0; kept < 2; kept++) {
        plan.out = file;
        plan.snapshots = kept;
        REQUIRE(case_run(&plan, &other, &why) == STATUS_OK);
        CHECK(same(&first, &other));
        double seconds = other.step_seconds;
        REQUIRE(case_read(file, &other, &why) == STATUS_OK);
        CHECK(same(&first, &other));
        CHECK(other.step_seconds == seconds && seconds > 0);
        REQUIRE(store_read_open(file, &store, &why) == STATUS_OK);
        CHECK(store_read_frames(store) == kept);
        if (kept)
            check_snapshot(store);
        store_read_close(store);
    }
}

/* What a run frame by frame says of the looks: frames 0, 7, 14, 20 (snapshot), 21, ..., 40.
 */
struct own {
    double stretch, drop, angle, roughness, end[4];
    double *before, speed, speed_most, time;
};

static bool is_look(int frame)
{
    return frame % 7 == 0 || frame == 20 || frame == 40;
}

static enum status watch(void *context, const struct motion *m, struct message *why)
{
    struct own *own = context;
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);

    (void)why;
    REQUIRE(xyz);
    if (is_look(m->frames)) {
        m->model->sample(m->state, xyz);
        own->end[0] = metric_stretch(m->scene, xyz);
        own->end[1] = metric_drop(m->scene, xyz);
        own->end[2] = metric_angle(m->scene, xyz);
        own->end[3] = metric_roughness(m->scene, xyz);
        own->stretch = fmax(own->stretch, own->end[0]);
        own->drop = fmax(own->drop, own->end[1]);
        own->angle = fmax(own->angle, own->end[2]);
        own->roughness = fmax(own->roughness, own->end[3]);
        if (m->frames)
            own->speed = metric_rmse(xyz, own->before) / (m->time - own->time);
        own->speed_most = fmax(own->speed_most, own->speed);
        own->time = m->time;
        memcpy(own->before, xyz, 3 * GRID_POINTS * sizeof *xyz);
    }
    free(xyz);
    return STATUS_OK;
}

static void test_own_metrics(void)
{
    struct case_plan plan = drop_plan();
    struct case_result r;
    struct message why = {""};
    struct trial trial;
    struct motion m;
    struct own own = {.before = malloc(3 * GRID_POINTS * sizeof(double))};

    REQUIRE(own.before && case_run(&plan, &r, &why) == STATUS_OK);
    REQUIRE(trial_open(&trial, plan.path, plan.setting_count, plan.settings, plan.model,
                       &why) == STATUS_OK);
    REQUIRE(motion_init(&m, trial.model, &trial.scene, trial.state) == STATUS_OK);
    REQUIRE(motion_run(&m, watch, &own, true, &why) == STATUS_OK);
    CHECK(r.value[CASE_STRETCH_MAX] == own.stretch);
    CHECK(r.value[CASE_DROP_MAX] == own.drop);
    CHECK(r.value[CASE_ANGLE_MAX] == own.angle);
    CHECK(r.value[CASE_ROUGHNESS_MAX] == own.roughness);
    CHECK(r.value[CASE_STRETCH_END] == own.end[0]);
    CHECK(r.value[CASE_DROP_END] == own.end[1]);
    CHECK(r.value[CASE_ANGLE_END] == own.end[2]);
    CHECK(r.value[CASE_ROUGHNESS_END] == own.end[3]);
    CHECK(r.value[CASE_SPEED_END] == own.speed);
    CHECK(r.value[CASE_SPEED_MAX] == own.speed_most);
    CHECK(r.value[CASE_END_TIME] == m.time);
    CHECK(r.value[CASE_GAMMA] == scene_gamma(&trial.scene));
    CHECK(r.value[CASE_YOUNG_OVER_DENSITY] == 1e5 / 0.5);
    CHECK(r.outcome == STATUS_OK && !strcmp(r.sentence.text, "done"));
    CHECK(isinf(r.value[CASE_BLOWUP_TIME]) && isinf(r.value[CASE_INTERSECTION_TIME]));
    CHECK(r.value[CASE_INTERSECTIONS_MAX] == 0);
    CHECK(isnan(r.value[CASE_PENETRATION_MAX])); /* there is nothing to penetrate */
    motion_clear(&m);
    trial_close(&trial);
    free(own.before);
}

/* Undamped springs keep their energy up to their scheme's loss; the printed scheme has no
 * elastic energy at all. */
static void test_energy(void)
{
    struct case_plan plan = drop_plan();
    struct case_result r;
    struct message why = {""};
    static const char *const undamped[] = {"discretization.points=[8,8,1]", "time.end=0.2",
                                           "damping={kind: none}"};

    REQUIRE(case_run(&plan, &r, &why) == STATUS_OK);
    CHECK(isnan(r.value[CASE_ENERGY_DRIFT_END]) && isnan(r.value[CASE_ENERGY_DRIFT_MAX]));
    plan.model = "mass_spring";
    plan.settings = undamped;
    plan.intersections = false;
    REQUIRE(case_run(&plan, &r, &why) == STATUS_OK);
    CHECK(r.value[CASE_ENERGY_DRIFT_END] < 0 && r.value[CASE_ENERGY_DRIFT_END] > -1);
    CHECK(r.value[CASE_ENERGY_DRIFT_MAX] >= 0);
    CHECK(isnan(r.value[CASE_INTERSECTIONS_MAX]));
    CHECK(isnan(r.value[CASE_INTERSECTION_TIME]));
}

/* Row 7 of the paper's Table 4 on the horizontal drop. */
static void test_death(void)
{
    static const char *const row7[] = {"material.young=5e4", "material.density=0.1",
                                       "damping.value=0.9", "time.end=0.5", "snapshots=[]"};
    struct case_plan plan = {.path = SCENES "edge_drop.yaml",
                             .setting_count = COUNT(row7),
                             .settings = row7,
                             .model = "iga",
                             .every = 10,
                             .out = file};
    struct case_result r, back;
    struct message why = {""};

    REQUIRE(case_run(&plan, &r, &why) == STATUS_OK);
    CHECK(status_is_death(r.outcome));
    CHECK(r.value[CASE_BLOWUP_TIME] > 0.2 && r.value[CASE_BLOWUP_TIME] < 0.4);
    CHECK(r.value[CASE_END_TIME] <= r.value[CASE_BLOWUP_TIME]);
    CHECK(r.value[CASE_BLOWUP_TIME] - r.value[CASE_END_TIME] <= 10 * 0.005 + 1e-9);
    CHECK(strstr(r.sentence.text, "died at t = "));
    REQUIRE(case_read(file, &back, &why) == STATUS_OK);
    CHECK(same(&r, &back));
}

/* Only the lower side of the edge is held, and a net of springs has no lower side. */
static void test_unsupported(void)
{
    static const char *const lower[] = {"supports=[{at: {u: 0, w: 0}, fix: xyz}]",
                                        "time.end=0.05", "snapshots=[]"};
    struct case_plan plan = {.path = SCENES "edge_drop.yaml",
                             .setting_count = COUNT(lower),
                             .settings = lower,
                             .model = "mass_spring",
                             .every = 5,
                             .out = file};
    struct case_result r, back;
    struct message why = {""};

    REQUIRE(case_run(&plan, &r, &why) == STATUS_OK);
    REQUIRE(r.outcome == STATUS_UNSUPPORTED);
    CHECK(strstr(r.sentence.text, "thickness"));
    CHECK(isnan(r.value[CASE_STRETCH_MAX]) && isnan(r.value[CASE_BLOWUP_TIME]));
    CHECK(r.value[CASE_GAMMA] > 0);
    REQUIRE(case_read(file, &back, &why) == STATUS_OK);
    CHECK(same(&r, &back));
}

static void test_refusals(void)
{
    struct case_plan plan = drop_plan();
    struct case_result r;
    struct message why = {""};
    const char *const bad[] = {"discretization.degree=[9,9,1]"};

    unlink(file);
    plan.out = file;
    plan.model = "paper";
    CHECK(case_run(&plan, &r, &why) == STATUS_INPUT && strstr(why.text, "paper"));
    plan.model = "iga";
    plan.settings = bad, plan.setting_count = 1;
    CHECK(case_run(&plan, &r, &why) == STATUS_INPUT && strstr(why.text, "degree"));
    CHECK(access(file, F_OK) != 0);
    CHECK(case_read(file, &r, &why) == STATUS_FILE && strstr(why.text, file));
    plan = drop_plan();
    plan.out = "/nowhere/case.h5";
    CHECK(case_run(&plan, &r, &why) == STATUS_FILE && strstr(why.text, "/nowhere"));
}

static void test_words(void)
{
    for (int n = 0; n < CASE_MEASURES; n++)
        CHECK(strcmp(case_measure_name(n), "unknown") && *case_measure_sentence(n));
    CHECK(!strcmp(case_measure_name(CASE_MEASURES), "unknown"));
    CHECK(!strcmp(case_measure_name(CASE_GAMMA), "gamma"));
    CHECK(!strcmp(case_measure_unit(CASE_SPEED_END), "m/s"));
}

int main(void)
{
    REQUIRE(mkdtemp(folder));
    snprintf(file, sizeof file, "%s/case.h5", folder);
    test_same_bits();
    test_own_metrics();
    test_energy();
    test_death();
    test_unsupported();
    test_refusals();
    test_words();
    unlink(file);
    snprintf(file, sizeof file, "%s/case.xdmf", folder);
    unlink(file);
    CHECK(rmdir(folder) == 0);
    return check_result();
}

/* The engine of studies: plans with levels, differences, errors, orders and metrics from
 * result files, levels that die or are refused, truth found again. */
#include "bench/experiment/study.h"
#include "bench/experiment/plan.h"

#include "bench/files/store.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/fresh.h"
#include "tests/plan_fixture.h"

/* Files keep positions as 32-bit floats: 6e-8 of 1 m. */
static const double TOL_STORED = 1e-7;

/* A shell of 6x6 points, degree 2, against Kirchhoff's tip. */
static const double TOL_TIP = 0.05;

static const char *folder;

/* A plan of this text, written where results go. */
static struct plan plan_there(const char *name, const char *text)
{
    char path[4096];

    snprintf(path, sizeof path, "%s/%s.yaml", folder, name);
    return plan_of(path, text);
}

static void field(const char *name, int frame, double *xyz)
{
    struct store_read *file = NULL;
    char path[4096];

    snprintf(path, sizeof path, "%s/%s.h5", folder, name);
    REQUIRE(store_read_open(path, &file, NULL) == STATUS_OK);
    REQUIRE(store_read_frame(file, frame, xyz, NULL) == STATUS_OK);
    store_read_close(file);
}

static double rmse(const char *a, const char *b, int frame)
{
    static double x[3 * GRID_POINTS], y[3 * GRID_POINTS];

    field(a, frame, x);
    field(b, frame, y);
    return metric_rmse(x, y);
}

/* A study by its name; NULL: there is none. */
static const struct study *study_of(const struct study_results *r, const char *name)
{
    for (int n = 0; n < r->count; n++)
        if (!strcmp(r->study[n].plan->name, name))
            return &r->study[n];
    return NULL;
}

static double at(const struct study *s, int level, int time, enum quantity q)
{
    return quantity_at(&(struct place){NULL, s, level, time}, q);
}

static void measure(const struct plan *plan)
{
    const struct measurement_options options = {.quick = true};
    struct message why = {""};

    REQUIRE_SAY(study_measure(plan, folder, &options, &why) == STATUS_OK, "%s", why.text);
}

/* A plate so light that the truth is Kirchhoff's; the shell converges to it. */
static const char *const light =
    "name: light\nsource: a light plate\nscene: cantilever_transient\nmodel: shell\n"
    "settings: {material.density: 1e-4, discretization.kinematics: linear,\n"
    "           time.step: 0.0005}\n"
    "axes:\n  level:\n"
    "    6x6: {name: \"6\", size: 0.25, discretization.points: [6,6]}\n"
    "    10x10: {name: \"10\", size: 0.125, discretization.points: [10,10]}\n"
    "    18x18: {name: \"18\", size: 0.0625, discretization.points: [18,18]}\n"
    "times: [0.05, 0.1]\ntruth: true\ntimed: 1\n";

static void against_truth(void)
{
    struct plan plan = plan_there("light", light);
    struct study_results all;

    measure(&plan);
    REQUIRE(study_read(&plan, folder, &all, NULL) == STATUS_OK);
    const struct study *s = study_of(&all, "light");
    REQUIRE(s && all.count == 1 && !study_of(&all, "heavy"));
    CHECK(s->length == 1 && s->gamma < TRUTH_GAMMA);
    REQUIRE(s->truth && strstr(s->truth->source, "Kirchhoff"));
    for (int t = 0; t < 2; t++) {
        CHECK_NEAR(at(s, 0, t, QUANTITY_NEXT), rmse("light_6", "light_10", t), TOL_STORED);
        CHECK_NEAR(at(s, 1, t, QUANTITY_NEXT), rmse("light_10", "light_18", t), TOL_STORED);
        CHECK_NEAR(at(s, 0, t, QUANTITY_FINEST), rmse("light_6", "light_18", t),
                   TOL_STORED);
        CHECK(at(s, 1, t, QUANTITY_FINEST) == at(s, 1, t, QUANTITY_NEXT));
        CHECK(isnan(at(s, 2, t, QUANTITY_FINEST)) && isnan(at(s, 2, t, QUANTITY_NEXT)));
        for (int n = 0; n < 3; n++) /* the last is the truth itself */
            CHECK(at(s, n + 1, t, QUANTITY_ERROR) < at(s, n, t, QUANTITY_ERROR));
        CHECK(at(s, 3, t, QUANTITY_ERROR) == 0 && at(s, 3, t, QUANTITY_ROUGHNESS) > 0);
        CHECK_RELATIVE(at(s, 2, t, QUANTITY_DROP), at(s, 3, t, QUANTITY_DROP), 0.05);
    }
    CHECK(s->row[0].result.unknowns ==
          3 * (36 - 12) +
              6); /* held: a row of six, and of the next all but its way into the sheet */
    CHECK(at(s, 1, 0, QUANTITY_FRAME) > 0);
    CHECK_RELATIVE(at(s, 1, 0, QUANTITY_SECONDS), at(s, 1, 0, QUANTITY_FRAME) * 1e-3 * 200,
                   1e-9);
    study_clear(&all);
    plan_clear(&plan);
}

/* The second: Ren et al. 2024, Table 4 row 7, which dies. No truth of the flag is claimed
 * so late; of two times the first has one. */
static const char *const rough =
    "name: rough\nsource: levels that end badly\nscene: edge_drop\n"
    "model: iga_paper\naxes:\n  level:\n"
    "    calm: {discretization.points: [5,5,2]}\n"
    "    wild: {material.density: 0.1, material.young: 5e4, damping.value: 0.9}\n"
    "    odd: {discretization.remedy: incompatible}\n"
    "times: [0.05, 0.35]\ntimed: 1\n"
    "studies:\n"
    "  rough: {caption: levels that end badly}\n"
    "  late: {scene: flag, damping: {kind: none}, truth: true, times: [0.5],\n"
    "    axes: {level: {Flat Sheet: {discretization.points: [4,4,2]}}}}\n"
    "  early: {scene: flag, damping: {kind: none}, truth: true, times: [0.1, 0.5],\n"
    "    axes: {level: {Flat Sheet: {discretization.points: [4,4,2]}}}}\n"
    "  scaled: {truth: true, times: [0.05],\n"
    "    axes: {level: {coarse: {discretization.points: [4,4,2]}}}}\n";

static void deaths_and_refusals(void)
{
    struct plan plan = plan_there("rough", rough);
    struct study_results all;

    measure(&plan);
    REQUIRE(study_read(&plan, folder, &all, NULL) == STATUS_OK);
    const struct study *s = study_of(&all, "rough"), *late = study_of(&all, "late");
    const struct study_row *row = s->row;
    CHECK(!s->truth && isnan(at(s, 0, 0, QUANTITY_ERROR)));
    CHECK(row[1].xyz[0] && !row[1].xyz[1] && at(s, 1, 0, QUANTITY_FRAME) > 0);
    CHECK(run_result_refused(&row[2].result) && !row[2].xyz[0]);
    CHECK_NEAR(at(s, 0, 0, QUANTITY_NEXT), rmse("rough_calm", "rough_wild", 0), TOL_STORED);
    CHECK(isnan(at(s, 0, 1, QUANTITY_NEXT))); /* nobody else lives */
    CHECK(row[1].result.outcome == STATUS_INVERTED &&
          row[1].result.death_time == 53 * 0.005);
    CHECK(!late->truth && *late->no_truth.text);
    CHECK(!strcmp(late->plan->levels[0].name, "flat_sheet"));
    const struct study *early = study_of(&all, "early");
    REQUIRE(early->truth && early->truth->times == 1 && early->row[0].xyz[1]);
    CHECK(at(early, 0, 0, QUANTITY_ERROR) > 0 && at(early, 0, 0, QUANTITY_BAR) > 0);
    CHECK(isnan(at(early, 0, 1, QUANTITY_ERROR)) && isnan(at(early, 0, 1, QUANTITY_BAR)));
    CHECK(isnan(at(early, 0, 1, QUANTITY_OFF)));
    /* A factor a step has no limit: the shell's own steps would be damped otherwise. */
    CHECK(!study_of(&all, "scaled")->truth);
    study_clear(&all);
    CHECK(study_read(&plan, "/proc/nowhere", &all, NULL) == STATUS_FILE);
    CHECK(!all.study); /* all clear after a failure */
    plan_clear(&plan);
}

/* A strip that is let go: few sweeps leave much and stretch it too far; a sheet that
 * nothing damps but Euler's steps loses energy. */
static const char *const few =
    "name: few\nsource: few iterations\nscene: hanging\nmodel: vbd\n"
    "settings: {material.young: 9.81e5, discretization.points: [6,6],\n"
    "           discretization.substeps: 1}\n"
    "axes:\n  level:\n"
    "    1: {discretization.iterations: 1}\n"
    "    64: {discretization.iterations: 64}\n"
    "    free: {damping: {kind: none}, discretization.iterations: 64}\n"
    "times: [0.3]\n";

static void few_iterations(void)
{
    static const double ALIKE = 0.1; /* the overshoot that the steps' damping leaves */
    struct plan plan = plan_there("few", few);
    struct study_results all;

    measure(&plan);
    REQUIRE(study_read(&plan, folder, &all, NULL) == STATUS_OK);
    const struct study *s = study_of(&all, "few");
    CHECK_NEAR(at(s, 1, 0, QUANTITY_STIFFNESS), 1, ALIKE);
    CHECK(at(s, 0, 0, QUANTITY_STIFFNESS) < 0.8 * at(s, 1, 0, QUANTITY_STIFFNESS));
    CHECK(at(s, 0, 0, QUANTITY_LEFT) > 0.1 && at(s, 1, 0, QUANTITY_LEFT) < 1e-4);
    CHECK(at(s, 2, 0, QUANTITY_LOSS) > 0);
    CHECK_NEAR(at(s, 2, 0, QUANTITY_LOSS),
               -s->row[2].result.value[MEASURE_ENERGY_DRIFT_END] / 0.3, 1e-9);
    study_clear(&all);
    plan_clear(&plan);
}

/* At rest: a flat plate only bends, as 1/h^2 under its own weight. A quick run of a plan
 * with times for it is read as such, also where a level is refused. */
static void rest_and_quick(void)
{
    struct plan plan = plan_there(
        "statics",
        "name: statics\nsource: statics\nscene: cantilever\nmodel: shell_linear\n"
        "settings: {discretization.points: [6,6]}\n"
        "axes:\n  level:\n"
        "    thin: {sheet.thickness: 0.001}\n"
        "    thick: {sheet.thickness: 0.005, quick: {sheet.thickness: 0.004}}\n"
        "    odd: {discretization.points: [2,2]}\n"
        "studies:\n"
        "  rest: {times: []}\n"
        "  motion: {times: [0.01, 0.02], quick_times: [0.005]}\n");
    struct study_results all;

    measure(&plan);
    REQUIRE(study_read(&plan, folder, &all, NULL) == STATUS_OK);
    const struct study *rest = study_of(&all, "rest"), *moved = study_of(&all, "motion");
    CHECK(all.quick && rest->frames == 1 && !rest->time &&
          isnan(at(rest, 0, 0, QUANTITY_FRAME)));
    REQUIRE(rest->row[0].xyz[0] && rest->row[1].xyz[0]);
    CHECK(!rest->row[0].xyz[1] && run_result_refused(&moved->row[2].result));
    CHECK_RELATIVE(at(rest, 0, 0, QUANTITY_DROP) / at(rest, 1, 0, QUANTITY_DROP), 16.0,
                   1e-4);
    CHECK_NEAR(at(rest, 0, 0, QUANTITY_TIP), 1, TOL_TIP);
    CHECK(moved->frames == 1 && moved->time[0] == 0.005 && moved->row[0].xyz[0]);
    study_clear(&all);
    plan_clear(&plan);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    folder = argv[1];
    fresh_folder(folder);
    rest_and_quick();
    REQUIRE(!setenv("CLOTHBENCH_TRUTHS", SOURCE_DIR "/tests/truths", 1));
    deaths_and_refusals(); /* by a truth that ends early */
    REQUIRE(!unsetenv("CLOTHBENCH_TRUTHS"));
    against_truth();
    few_iterations();
    return check_result();
}

/* Tests the comparison of cases with a reference, from made-up files: known errors, every
 * way a case can end, files that are damaged, missing or cut short. */
#include <unistd.h>

#include "bench/harness/run_file.h"
#include "bench/experiment/sweep.h"
#include "models/reader/csv.h"
#include "tests/fresh.h"
#include "tests/plan_fixture.h"
#include "tests/scripted_model.h"

#define PLAN                                                                               \
    "name: stability\nsource: a test\nscene: cantilever\n"                                 \
    "settings: {time.end: 0.3, snapshots: [0.1, 0.2, 0.3]}\n"                              \
    "axes:\n"                                                                              \
    "  case: {a: {}, b: {}, c: {}}\n"                                                      \
    "  young_over_density: [1e4, 1e6]\n"                                                   \
    "  time.step: [0.05, 0.01, 0.1]\n"                                                     \
    "verdicts: [{label: off, measure: reference_error_max, above: 0.05, why: seen}]\n"

enum kind { RAN, DIES, REFUSES, FAILED, DAMAGED, GONE, CUT };

/* The cases in the order of the sweep: by what share of its height a sheet is off at the
 * worst of three times; the label, and the error. */
static const struct {
    enum kind kind;
    double off;
    const char *label;
    double error;
} cases[] = {
    {RAN, 0.04, "feasible", 0.04},    {RAN, 0, "feasible", 0},
    {RAN, 0.06, "off", 0.06},         {RAN, 0.2, "off", 0.2},
    {RAN, 0, "feasible", 0},          {RAN, -0.01, "feasible", 0.01},
    {RAN, 0, "off", INFINITY}, /* lives where the finest step died */
    {DIES, 0, "off", INFINITY},       {REFUSES, 0, "unsupported", NAN},
    {DIES, 0.01, "off", INFINITY},    {RAN, 0, "feasible", 0},
    {FAILED, 0, "no result", NAN},    {RAN, 0, "off", INFINITY},
    {FAILED, 0, "no result", NAN},    {GONE, 0, "run again", NAN},
    {RAN, 0, "not judged: off", NAN}, {DAMAGED, 0, "run again", NAN},
    {CUT, 0, "run again", NAN},
};
enum { CASES = sizeof cases / sizeof *cases };
static const double TOL_DOUBLE = 1e-12;

static double off; /* of the height at the second of the times */

/* Samples a sheet that rises with 1 m/s, but for the second time. */
static void sample(const void *state, double *xyz)
{
    const struct scripted *s = state;
    const double t = s->frame * s->scene->step;

    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(s->scene, uvw, xyz + 3 * n);
        xyz[3 * n + 2] += t * (fabs(t - 0.2) < 1e-9 ? 1 + off : 1);
    }
}

static void make_case(const struct plan *plan, int n)
{
    static const double times[] = {0.1, 0.2, 0.3};
    const struct message said = {"ended"};
    struct model model = scripted_model;
    const struct contestant contestant = {.name = "made up", .model = &model, .degree = 1};
    char path[32];
    struct plan_case c;
    struct run run;

    REQUIRE(plan_case_level(plan, plan->studies, &plan->studies->levels[n], false, &c,
                            NULL) == STATUS_OK);
    script_reset();
    model.sample = sample;
    off = cases[n].off;
    script.dies = cases[n].kind == DIES ? 2 : 0;
    script.death = STATUS_NAN;
    script.create = cases[n].kind == REFUSES ? STATUS_UNSUPPORTED : STATUS_OK;
    settings_set(&c.run.settings, "discretization.points=[4,4]");
    snprintf(path, sizeof path, "./case_%06d.h5", n + 1);
    const struct case_plan made = {c.run.path,
                                   &contestant,
                                   c.run.settings,
                                   0,
                                   {.file = path,
                                    .times = 3,
                                    .time = times,
                                    .doubles = true,
                                    .made_for = cases[n].kind == FAILED ? "key" : NULL}};
    REQUIRE(run_read(&run, &made, NULL) == STATUS_OK);
    if (cases[n].kind == FAILED || cases[n].kind == CUT)
        REQUIRE(run_file_lost(&made, &run, &said, NULL) == STATUS_OK);
    else if (cases[n].kind != GONE)
        REQUIRE(run_file_make(&made, &run, NULL, NULL) == STATUS_OK);
    if (cases[n].kind == DAMAGED)
        REQUIRE(truncate(path, 4000) == 0);
    run_close(&run);
    plan_case_clear(&c);
}

static void check_errors(void)
{
    struct study_results d;
    struct plan plan =
        plan_of("plan.yaml", PLAN "keep: snapshots\nreference: {time.step: 0.01}\n");
    struct csv csv;

    for (int n = 0; n < CASES; n++)
        make_case(&plan, n);
    REQUIRE(study_read(&plan, ".", &d, NULL) == STATUS_OK);
    REQUIRE(sweep_save(&d, &(struct printer){.folder = "."}, NULL) == STATUS_OK);
    REQUIRE(csv_read("table.csv", &csv, NULL) == STATUS_OK && csv.table->rows == CASES);
    for (int n = 0; n < CASES; n++) {
        const double is = csv_number_of(csv.table, n, "reference_error_max");
        const double want = cases[n].error;
        SAY_UNLESS(CHECK(!strcmp(csv_words_of(csv.table, n, "labels"), cases[n].label)) &&
                       CHECK(isfinite(want)
                                 ? fabs(is - want) < TOL_DOUBLE
                                 : isnan(is) == isnan(want) && isinf(is) == isinf(want)),
                   "case %d: %s, %g", n, csv_words_of(csv.table, n, "labels"), is);
    }
    csv_clear(&csv);
    study_clear(&d);
    plan_clear(&plan);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    REQUIRE(chdir(argv[1]) == 0);
    check_errors();
    return check_result();
}

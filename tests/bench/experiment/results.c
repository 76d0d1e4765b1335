/* A plan without a table is printed from made-up numbers: each in its cell, with truth,
 * without, at rest; levels that died or were refused; notes below. */
#include "bench/experiment/results.h"

#include <unistd.h>

#include "tests/fresh.h"
#include "tests/plan_fixture.h"
#include "tests/said.h"

static const char *folder, *path;

#define PLAN                                                                               \
    "name: told\nsource: numbers made up\nscene: edge_drop\n"                              \
    "axes:\n  level:\n"                                                                    \
    "    5x5x2: {size: 0.5, paper_ms: 12.5, discretization.points: [5,5,2]}\n"             \
    "    7x7x2: {size: 0.25, discretization.points: [7,7,2]}\n"                            \
    "    9x9x2: {size: 0.125, discretization.points: [9,9,2]}\n"

static void set(struct study_row *row, int time, enum quantity q, double value)
{
    row->value[time][q] = value;
    row->known[time][q] = true;
}

/* Sets five numbers of a sheet, each `by` more than those of another. */
static void set_shape(struct study_row *row, int time, const double shape[5], double by)
{
    static const enum quantity numbers[] = {QUANTITY_ROUGHNESS, QUANTITY_INNER,
                                            QUANTITY_STRETCH, QUANTITY_DROP,
                                            QUANTITY_UNEVENNESS};

    for (int i = 0; i < 5; i++)
        set(row, time, numbers[i], shape[i] + by);
}

/* Numbers of row n at time t: each is told from all others. Errors go with size^2, the
 * differences from the finest with size^3. */
static struct study study_of(const struct plan *plan, const double *time, int frames)
{
    static struct study_row rows[4];
    static const struct plan_level of_truth = {.label = "truth"};
    struct study s = {.plan = &plan->studies[0],
                      .row = rows,
                      .frames = frames,
                      .time = time,
                      .gamma = 123.4,
                      .length = 2};

    memset(rows, 0, sizeof rows);
    for (int n = 0; n < 3; n++) {
        struct study_row *row = &s.row[n];
        const double h = pow(0.5, n + 1);
        row->level = &plan->studies[0].levels[n];
        row->result = (struct run_result){.sentence = {"done"},
                                          .unknowns = 100 * (n + 1),
                                          .factor_entries = 1000 * (n + 1)};
        for (int t = 0; t < frames; t++) {
            set(row, t, QUANTITY_FRAME, 1.25 * (n + 1));
            set(row, t, QUANTITY_SECONDS, 0.5 * (n + 1));
            set(row, t, QUANTITY_NEXT, n < 2 ? 0.25 * (n + 1) : NAN);
            set(row, t, QUANTITY_FINEST, n < 2 ? pow(h, 3) : NAN);
            set(row, t, QUANTITY_ERROR, 0.5 * h * h * (t + 1));
            set_shape(row, t, (double[]){10, 20, 1.5, 0.5, 40}, n);
        }
    }
    rows[3] = (struct study_row){.level = &of_truth, .left_out = true};
    return s;
}

static char *print(const struct plan *plan, struct study *s, enum table_format format)
{
    const struct study_results d = {.plan = plan, .count = 1, .study = s};
    struct said said;
    struct printer p = {format, said_open(&said), folder};

    CHECK(results_print(&d, &p, NULL) == STATUS_OK);
    CHECK(printer_close(&p) == STATUS_OK);
    return said_text(&said);
}

static const char with_truth[] =
    "# numbers made up\n"
    "level,time_s,size,unknowns,factor_entries,frame_ms,paper_ms,stepping_s,"
    "to_next_over_length,to_finest_over_length,error_over_length,error_bar_over_length,"
    "roughness,inner_roughness,stretch,drop_over_length,unevenness\n"
    "5x5x2,0.125,0.5,100,1000,1.25,,0.5,0.25,0.125,0.125,0.0625,10,20,1.5,0.5,40\n"
    "7x7x2,0.125,0.25,200,2000,2.5,,1,0.5,0.015625,0.03125,0.0625,11,21,2.5,1.5,41\n"
    "9x9x2,0.125,0.125,300,3000,3.75,,1.5,,,0.0078125,0.0625,12,22,3.5,2.5,42\n"
    "truth,0.125,,,,,,,,,0,0.0625,1,2,3,4,5\n"
    "5x5x2,0.25,0.5,100,1000,1.25,,0.5,0.25,0.125,0.25,0.1875,10,20,1.5,0.5,40\n"
    "7x7x2,0.25,0.25,200,2000,2.5,,1,0.5,0.015625,0.0625,0.1875,11,21,2.5,1.5,41\n"
    "9x9x2,0.25,0.125,300,3000,3.75,,1.5,,,0.015625,0.1875,12,22,3.5,2.5,42\n"
    "truth,0.25,,,,,,,,,0,0.1875,6,7,8,9,10\n";

static void check_truth(void)
{
    struct plan plan = plan_of(path, PLAN "times: [0.125, 0.25]\ntruth: true\ntimed: 3\n");
    struct study s = study_of(&plan, plan.studies[0].times, 2);
    double bars[] = {0.125, 0.375}, *none[] = {NULL, NULL};
    struct truth truth = {2, plan.studies[0].times, none, bars, "somebody else's"};

    s.truth = &truth;
    for (int t = 0; t < 2; t++) {
        set(&s.row[3], t, QUANTITY_ERROR, 0);
        set_shape(&s.row[3], t, (double[]){1, 2, 3, 4, 5}, 5 * t);
    }
    char *text = print(&plan, &s, TABLE_CSV);
    CHECK_HAS(text, with_truth);
    CHECK_HAS(text, "# Observed order at 0.125 s: 2, of the error.\n");
    CHECK_HAS(text, "# Gamma = 123.4.\n");
    free(text);
    s.truth = NULL; /* asked for, but there is none */
    text = print(&plan, &s, TABLE_TEXT);
    CHECK_HAS(text, "Truth of told: none");
    CHECK_HAS(text, "Observed order at 0.25 s: 3, of the difference");
    CHECK(!strstr(text, "error bar"));
    free(text);
    plan_clear(&plan);
}

/* Other people's milliseconds stand where no truth is asked for; a refusal has no numbers,
 * and a note; a level that died has those it lived to. */
static void check_without(void)
{
    struct plan plan = plan_of(path, PLAN "times: [0.125, 0.25]\ntimed: 3\n");
    struct study s = study_of(&plan, plan.studies[0].times, 2);

    s.row[1].result.outcome = STATUS_UNSUPPORTED;
    snprintf(s.row[1].result.sentence.text, 64, "no such net");
    set(&s.row[1], 0, QUANTITY_FRAME, NAN);
    set(&s.row[1], 0, QUANTITY_SECONDS, NAN);
    s.row[2].result.outcome = STATUS_NAN;
    snprintf(s.row[2].result.sentence.text, 64, "died at t = 0.2 s");
    char *text = print(&plan, &s, TABLE_CSV);
    CHECK_HAS(text, "7x7x2: no such net");
    CHECK_HAS(text, "9x9x2: died at t = 0.2 s");
    CHECK_HAS(text, "\n7x7x2,0.125,,,,,,,");
    CHECK_HAS(text, "\n9x9x2,0.25,0.125,300,3000,3.75,,1.5,");
    CHECK_HAS(text, "\n5x5x2,0.25,0.5,100,1000,1.25,12.5,0.5,");
    free(text);
    plan_clear(&plan);
}

/* The chart's points stand under the names of its axes, at the last time. */
static void check_chart(void)
{
    struct plan plan = plan_of(
        path, PLAN "times: [0.125, 0.25]\ntable: {columns: [drop]}\n"
                   "chart: {x: \"mesh, [m]\", y: [drop], from: 1, line: [level]}\n");
    struct study s = study_of(&plan, plan.studies[0].times, 2);
    char *text = print(&plan, &s, TABLE_CSV);

    free(text);
    text = fresh_text(folder, "told_chart.csv");
    CHECK(!strncmp(text, "panel,line,\"mesh, [m]\",|drop - 1|\n", 34));
    CHECK_HAS(text, "\n,5x5x2,0.5,0.5\n,7x7x2,0.25,0.5\n,9x9x2,0.125,1.5\n");
    free(text);
    plan_clear(&plan);
}

static void writes(const struct study_results *d, const char *at, const char *want)
{
    struct said said;

    results_write(d, QUANTITY_DROP, WHERE({"at", at}), said_open(&said));
    said_close(&said, true);
    CHECK(!strcmp(said.text, want));
    said_clear(&said);
}

/* Words for sentences: a number of every level; and orders, which two points are not. */
static void check_words(void)
{
    struct plan plan = plan_of(path, PLAN "times: [0.05, 0.1]\n");
    struct study s = study_of(&plan, plan.studies[0].times, 2);
    const struct study_results d = {.plan = &plan, .count = 1, .study = &s};

    set(&s.row[0], 0, QUANTITY_DROP, 7);
    writes(&d, "*", "7, 0.5, 1.5, 1.5, 2.5, 2.5");
    for (int n = 0; n < 2; n++)
        set(&s.row[n], 1, QUANTITY_DROP, NAN);
    s.row[0].result.outcome = STATUS_UNSUPPORTED;
    s.row[1].xyz[0] = &s.length; /* lives, and has a number */
    writes(&d, "0.1", "refused, died, 2.5");
    s.row[1].xyz[1] = &s.length; /* lives, without this number */
    writes(&d, "0.1", "refused, nan, 2.5");
    writes(&d, "0.3", "");
    s.row[1].xyz[0] = s.row[1].xyz[1] = NULL;
    set(&s.row[0], 0, QUANTITY_FINEST, NAN);
    char *text = print(&plan, &s, TABLE_CSV);
    CHECK(!strstr(text, "Observed order at 0.05 s"));
    CHECK_HAS(text, "Observed order at 0.1 s: 3, of the difference");
    free(text);
    plan_clear(&plan);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    folder = argv[1];
    fresh_folder(folder);
    char file[4096];
    snprintf(file, sizeof file, "%s/told.yaml", folder);
    path = file;
    check_truth();
    check_without();
    check_words();
    check_chart();
    return check_result();
}

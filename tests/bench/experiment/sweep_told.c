/* Tests the table of a sweep: the numbers under their columns.
 * (commands/sweep.cases, sweep_ends.cases: the command and its files.) */
#include <unistd.h>

#include "models/reader/csv.h"
#include "bench/experiment/sweep.h"
#include "tests/fresh.h"
#include "tests/plan_fixture.h"
#include "tests/said.h"

/* Reads a plan and makes the rows of its only study, empty. */
static struct study_results begin(const char *text, struct plan *plan)
{
    struct study_results d = {.plan = plan, .count = 1};

    *plan = plan_of("plan.yaml", text);
    d.study = arena_take(&d.arena, 1, sizeof *d.study);
    d.study->plan = plan->studies;
    d.study->row =
        arena_take(&d.arena, (size_t)plan->studies->level_count + 1, sizeof *d.study->row);
    for (int n = 0; n < plan->studies->level_count; n++)
        d.study->row[n].level = &plan->studies->levels[n];
    return d;
}

static const struct printer files = {.folder = "."};

/* The only table of a file. */
static const struct csv_table *read_table(const char *name, struct csv *csv)
{
    REQUIRE(csv_read(name, csv, NULL) == STATUS_OK && csv->count == 1);
    return csv->table;
}

static const char plan_text[] =
    "name: told\nsource: a test\nscene: edge_drop\n"
    "settings: {time.end: 0.01, discretization.points: [4,4,2]}\n"
    "axes: {case: {\"light, so\": {}, heavy: {material.density: 2}},\n"
    "       damping.value: [0.1, 0.2, 0.3, 0.4]}\n"
    "verdicts:\n"
    "  - {label: big, measure: drop_max, above: 0.5, why: a test}\n"
    "  - {label: odd, measure: speed_max, below: 0.1, why: a test}\n"
    "  - {label: big, measure: stretch_max, above: 2, why: a test}\n";

/* --- the table --- */

static const struct {
    enum { RAN, LOST, AGAIN } state;
    enum status outcome;
    double value; /* of the measures, but for a little that each has of its own           */
    const char *why, *verdict, *labels;
} told[] = {
    /* clang-format off */
    {RAN, STATUS_OK, 0.25, "done", "feasible", "feasible"},
    {RAN, STATUS_NAN, 0.75, "died at t = 1 s: of \"x\"", "infeasible", "big"},
    {AGAIN, STATUS_OK, 7, "killed", "none", "run again"},
    {AGAIN, STATUS_OK, 7, "its file is damaged", "none", "run again"},
    {RAN, STATUS_UNSUPPORTED, NAN, "no contact", "none", "unsupported"},
    {LOST, STATUS_OK, 7, "timed out after 1 s", "none", "no result"},
    {AGAIN, STATUS_OK, 7, "its file is gone", "none", "run again"},
    {RAN, STATUS_OK, NAN, "done", "not judged", "not judged: big, odd"},
    /* clang-format on */
};
enum { TOLD = sizeof told / sizeof *told };

static const double OWN = 1e-5; /* what a measure has more than the one before it */

/* Checks a row: its keys, its measures each under its name, how it ends. */
static void check_case(const struct csv_table *t, int n)
{
    const bool has_run = told[n].state == RAN && isfinite(told[n].value);
    const double damping = 0.1 * (n % 4 + 1), rounding = 1e-12;

    CHECK(csv_number_of(t, n, "number") == n + 1);
    CHECK(!strcmp(csv_words_of(t, n, "case"), n < 4 ? "light, so" : "heavy"));
    CHECK(!strcmp(csv_words_of(t, n, "material.density"), n < 4 ? "" : "2"));
    CHECK_NEAR(csv_number_of(t, n, "damping.value"), damping, rounding);
    for (int m = 0; m < MEASURES; m++) {
        const char *key = m == MEASURE_GAMMA                ? "gamma_measured"
                          : m == MEASURE_YOUNG_OVER_DENSITY ? "young_over_density_measured"
                                                            : measure_name(m);
        const double value = csv_number_of(t, n, key);
        if (has_run)
            CHECK_NEAR(value, told[n].value + OWN * m, rounding);
        else
            CHECK(isnan(value));
    }
    CHECK(!strcmp(csv_words_of(t, n, "verdict"), told[n].verdict));
    CHECK(!strcmp(csv_words_of(t, n, "labels"), told[n].labels));
    CHECK(!strcmp(csv_words_of(t, n, "outcome"), told[n].why));
}

/* Checks how many have which label and end, in what is printed for people. */
static void check_counts(const struct study_results *d)
{
    static const char *const label[] = {"feasible",   "big",      "odd",
                                        "not judged", "died",     "unsupported",
                                        "no result",  "run again"};
    static const int count[] = {1, 1, 0, 1, 1, 1, 1, 3};
    struct said said;
    char line[64];

    sweep_print(d, said_open(&said));
    said_close(&said, true);
    for (int n = 0; n < 8; n++) {
        snprintf(line, sizeof line, "\n  %-24s%6d", label[n], count[n]);
        said_has(&said, "counts", line);
    }
    said_clear(&said);
}

static void check_table(void)
{
    struct plan plan;
    struct study_results d = begin(plan_text, &plan);
    struct csv csv;

    REQUIRE(plan_case_count(&plan) == TOLD);
    for (int n = 0; n < TOLD; n++) {
        struct study_row *row = &d.study->row[n];
        row->result.outcome = told[n].outcome;
        snprintf(row->result.sentence.text, sizeof row->result.sentence.text, "%s",
                 told[n].why);
        row->lost = told[n].state == RAN ? NULL : told[n].why;
        row->again = told[n].state == AGAIN;
        for (int m = 0; m < MEASURES; m++)
            row->result.value[m] = told[n].value + OWN * m;
    }
    check_counts(&d);
    REQUIRE(sweep_save(&d, &files, NULL) == STATUS_OK);
    const struct csv_table *t = read_table("table.csv", &csv);
    REQUIRE(t->rows == TOLD);
    for (int n = 0; n < TOLD; n++)
        check_case(t, n);
    csv_clear(&csv);
    unlink("table.csv");
    CHECK(sweep_save(&d, &(struct printer){.folder = "none"}, NULL) == STATUS_FILE);
    study_clear(&d);
    plan_clear(&plan);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    REQUIRE(chdir(argv[1]) == 0);
    check_table();
    return check_result();
}

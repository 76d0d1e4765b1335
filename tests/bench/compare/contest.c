/* Tests the numbers that compare reads off scripted runs: errors and seconds of a row, who
 * is nearest and cheapest, each way round, and where each stands in tables and CSV. */
#include "bench/compare/compare.h"
#include "models/reader/csv.h"
#include "tests/contest_fixture.h"
#include "tests/fresh.h"
#include "tests/said.h"

static const double TOL_SUM = 1e-12; /* rms of 60000 equal numbers                       */

static double *shifted(double by) /* by (3, 4, 12) cm, so many times */
{
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);

    REQUIRE(xyz);
    for (int n = 0; n < GRID_POINTS; n++)
        xyz[3 * n] = 0.03 * by, xyz[3 * n + 1] = 0.04 * by, xyz[3 * n + 2] = 0.12 * by;
    return xyz;
}

/* Errors are over L, at the time of each; the worst is the largest wherever it stands. */
static void fill(void)
{
    struct contest c = make();
    struct contest_row row = {0};
    double *xyz[TIMES] = {shifted(4), shifted(1)};
    struct run_result r = {
        .frames = TIMES, .xyz = xyz, .create = {.median = 0.5}, .step = {.median = 0.01}};

    r.steps = 20;
    contest_fill(&c, &r, &row);
    CHECK_NEAR(row.error[0], 4 * 0.13 / 2, TOL_SUM);
    CHECK_NEAR(row.error[1], 0.13 / 2, TOL_SUM);
    CHECK(row.worst == row.error[0]);
    CHECK_NEAR(row.seconds, 0.5 + 20 * 0.01, TOL_SUM);
    CHECK(!row.result.xyz && !row.result.time && row.result.steps == 20);
    double *swap = xyz[0];
    xyz[0] = xyz[1], xyz[1] = swap;
    contest_fill(&c, &r, &row);
    CHECK(row.worst == row.error[1] && row.error[1] > row.error[0]);

    r.frames = 1; /* it died: what it lived to see stands, and there is no worst */
    contest_fill(&c, &r, &row);
    CHECK_NEAR(row.error[0], 0.13 / 2, TOL_SUM);
    CHECK(isnan(row.error[1]) && isnan(row.worst));
    r.frames = TIMES;
    xyz[0][7] = NAN; /* not only at the last time */
    contest_fill(&c, &r, &row);
    CHECK(isnan(row.error[0]) && isnan(row.worst));
    row.probe = true;
    contest_fill(&c, &r, &row);
    CHECK(isnan(row.seconds));
    world.truth.xyz = NULL;
    contest_fill(&c, &r, &row);
    CHECK(isnan(row.error[1]) && isnan(row.worst) && isnan(contest_largest_bar(&c)));
    free(xyz[0]), free(xyz[1]);
    unmake(&c);
}

/* Springs: cheap and far, dear and near, one that wastes its seconds, a probe that is best;
 * iterations: a refusal, a death; a plate for one error alone. In this order, not together:
 * rows may be added. */
static struct contest race(void)
{
    static const struct {
        const char *who;
        struct run_of run;
    } all[] = {
        {"mass_spring", {10, 1, 0, 0.05, 0.09, 0}},
        {"projective_dynamics", {10, 1, 10, 0.01, 0, REFUSES}},
        {"mass_spring", {20, 1, 0, 0.19, 0.025, EARLY}},
        {"mass_spring", {20, 4, 0, 0.21, 0.015, 0, 12}},
        {"mass_spring", {40, 1, 0, 0.3, 0.026, 0}},
        {"iga_selective_3", {6, 1, 0, 0.4, 0.0041, 0}},
        {"iga_linear", {10, 1, 0, 0.02, 0.0004, 0}},
        {"mass_spring", {30, 4, 0, 0, 0.009, PROBE, 12}},
        {"projective_dynamics", {20, 1, 10, 0.02, 0, DIES}},
        {"mass_spring", {20, 8, 0, 0, 0.0149, PROBE, 12}},
        {"projective_dynamics", {20, 1, 100, 0.25, 1.1, 0}},
    };
    struct contest c = make();

    for (size_t n = 0; n < sizeof all / sizeof *all; n++)
        add(&c, all[n].who, &all[n].run);
    return c;
}

/* An error that is met is reached, but not by a probe. */
static void choices(void)
{
    struct contest c = race();
    const struct contestant *springs = named("mass_spring");

    CHECK(contest_cheapest(&c, springs, 0.09) == &c.rows[0]);
    CHECK(contest_cheapest(&c, springs, 0.0899) == &c.rows[2]);
    CHECK(!contest_cheapest(&c, springs, 0.0149));
    for (int n = 0; n < c.count; n++) /* the front, by hand */
        CHECK(contest_on_front(&c, &c.rows[n]) == !strchr("14789", '0' + n % 10));
    CHECK_NEAR(contest_bar(&c, 0), 0.01, TOL_SUM);
    CHECK_NEAR(contest_largest_bar(&c), 0.02, TOL_SUM);
    unmake(&c);
}

/* Cells of tables, by the names of their columns: which column a number stands in. */
static const struct {
    const char *file;
    int row;
    const char *cells;
} want[] = {
    {"compare.csv", 2,
     "title=mass-spring, "
     "matched;contestant=mass_spring;model=mass_spring;side=20;across=12;"
     "step_s=0.001;iterations=;unknowns=2000;setup_s=0.042;stepping_s=0.168;repeats=9;"
     "model_bytes=210000;seconds=0.21;rmse_over_length_0.1_s=0.0075;"
     "rmse_over_length_0.2_s=0.015;worst_rmse_over_length=0.015;bar_over_length=0.02;front="
     "1;outcome=done"},
    {"compare.csv", 3, "side=40;front=0"},
    {"compare.csv", 4, /* a probe is not timed */
     "side=30;unknowns=3000;setup_s=;stepping_s=;repeats=;model_bytes=;seconds=;"
     "worst_rmse_over_length=0.009;front=0"},
    {"compare.csv", 6, "iterations=10;unknowns=;seconds=;outcome=would not"},
    {"compare.csv", 7,
     "rmse_over_length_0.1_s=0.3;rmse_over_length_0.2_s=;worst_rmse_over_length=;seconds="
     "0.02;outcome=died at t = 0.15 s: a point is farther than 10 lengths from its "
     "support"},
    {"compare.csv", 10, "contestant=iga_linear"},
    {"compare_targets.csv", 0,
     "title=mass-spring, matched;seconds_0.03=0.19;side_0.03=20;across_0.03=20;step_s_0.03="
     "0.004;iterations_0.03=;seconds_0.02=0.21;side_0.02=20;across_0.02=12;step_s_0.02="
     "0.001;seconds_0.01=;side_0.01=;seconds_0.002=;growth=0.84749295656081525"},
    {"compare_targets.csv", 3, "contestant=iga_linear;seconds_0.002=0.02;growth="},
    {"compare_limits.csv", 0,
     "title=mass-spring, matched;real_time_rmse_over_length=0.025;real_time_side=20;"
     "real_time_across=20;real_time_step_s=0.004;real_time_iterations=;"
     "lowest_rmse_over_length=0.015;lowest_side=20;lowest_across=12;lowest_step_s=0.001;"
     "sentence=the truth: within 1.5 of its error "
     "bars;limit=truth;net_gain=0.4;across_gain=;"
     "step_gain=0.0066666666666666;iterations_gain="},
    {"compare_limits.csv", 1,
     "real_time_rmse_over_length=;real_time_side=;lowest_rmse_over_length=1.1;"
     "lowest_iterations=100;limit=unknown"},
};

static void check_cells(const struct csv_table *t, int row, const char *cells)
{
    char copy[1024], *end;

    snprintf(copy, sizeof copy, "%s", cells);
    for (char *cell = strtok(copy, ";"); cell; cell = strtok(NULL, ";")) {
        char *text = strchr(cell, '=');
        *text++ = '\0';
        const int column = csv_column(t, cell);
        REQUIRE(column >= 0 && row < t->rows);
        const double number = strtod(text, &end);
        CHECK_SAY(*text && !*end
                      ? fabs(csv_number(t, row, column) - number) <= TOL_SUM * number
                      : !strcmp(csv_words(t, row, column), text),
                  "row %d, %s: %s, not %s", row, cell, csv_words(t, row, column), text);
    }
}

static char *print(const struct contest *c, const char *folder)
{
    struct said said;
    struct printer p = {TABLE_TEXT, said_open(&said), folder};
    struct message why = {""};

    CHECK_SAY(compare_print(c, &p, &why) == STATUS_OK, "%s", why.text);
    return said_text(&said);
}

static void tables(const char *folder)
{
    struct csv csv;
    struct contest c = race();
    struct message why;
    c.budget = 12;
    char *text = print(&c, folder);

    for (int n = 0; n < LENGTH(want); n++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%s", folder, want[n].file);
        REQUIRE(csv_read(path, &csv, &why) == STATUS_OK && csv.count == 1);
        check_cells(csv.table, want[n].row, want[n].cells);
        csv_clear(&csv);
    }
    free(text);
    CHECK(compare_print(&c, &(struct printer){TABLE_TEXT, stdout, "no/such/folder"},
                        &why) == STATUS_FILE);
    unmake(&c);
}

/* Seconds and refusals are told without errors: no targets, no limits. */
static void no_truth(const char *folder)
{
    struct contest c = race();

    world.truth.xyz = NULL;
    for (int n = 0; n < c.count; n++)
        c.rows[n].error[0] = c.rows[n].error[1] = c.rows[n].worst = NAN;
    char *text = print(&c, folder);
    CHECK(strstr(text, "would not") && !strstr(text, "10 %") && !strstr(text, "imited by"));
    free(text);
    unmake(&c);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    fill();
    choices();
    no_truth(argv[1]);
    tables(argv[1]);
    return check_result();
}

/* Whether a measure falls along an axis: which values grow, which are not judged, and what
 * the table, the sentence and the status say of it, each way round. */
#include "bench/sweep/sweep.h"

#include <unistd.h>

#include "tests/sweep_fixture.h"

enum { VALUES = 4 };

static const char head[] =
    "name: falls\nsource: a test\nscene: edge_drop\n"
    "settings: {time.end: 0.01}\n"
    "axes:\n"
    "  - {key: discretization.points, values: [[4,4], [5,5], [6,6], [7,7]]}\n"
    "  - {key: damping.value, values: [0.1, 0.5]}\n";
static const char by_bar[] =
    "falls: {measure: truth_error_end, along: discretization.points, by: truth_bar_end}\n";
static const char by_nothing[] =
    "falls: {measure: truth_error_end, along: discretization.points}\n";

enum { DIED = -1, REFUSED = -2, TIMED_OUT = -3, BLANK = -4 };

/* A row of made-up errors against a bar of 0.25, and where it grows. */
static const struct row {
    double error[VALUES];
    const char *cells, *grows, *grows_at_all; /* the last: without a bar                */
    bool judged;                              /* it has two values to compare           */
} rows[] = {
    {{4, 3, 2, 1}, "4,3,2,1", "", "", true},
    {{1, 1.25, 1, 1}, "1,1.25,1,1", "", "\"[5,5]\"", true}, /* as much as the bar       */
    {{1, 1.5, 1, 0.5}, "1,1.5,1,0.5", "\"[5,5]\"", "\"[5,5]\"", true},
    /* little by little: against the best net before, not the one before */
    {{1, 1.25, 1.5, 1.75},
     "1,1.25,1.5,1.75",
     "\"[6,6] [7,7]\"",
     "\"[5,5] [6,6] [7,7]\"",
     true},
    {{1, TIMED_OUT, REFUSED, 2}, "1,,,2", "\"[7,7]\"", "\"[7,7]\"", true},
    {{1, BLANK, DIED, 0.5}, "1,,,0.5", "\"[6,6]\"", "\"[6,6]\"", true},
    {{DIED, DIED, 2, 1}, ",,2,1", "", "", true}, /* what has not lived cannot grow       */
    {{DIED, TIMED_OUT, BLANK, 2}, ",,,2", "", "", false},
};
enum { ROWS = sizeof rows / sizeof *rows };

static struct sweep_row made(double error)
{
    struct sweep_row row = error == TIMED_OUT
                               ? sweep_fixture_other(SWEEP_ROW_FAILED, "timed out")
                               : sweep_fixture_ran(0.5);
    double *value = row.result.value;

    row.result.outcome = error == DIED      ? STATUS_NAN
                         : error == REFUSED ? STATUS_UNSUPPORTED
                                            : STATUS_OK;
    value[MEASURE_TRUTH_ERROR_END] = error == BLANK ? NAN : error;
    value[MEASURE_TRUTH_BAR_END] = 0.25;
    return row;
}

/* Both of these rows, by the bar or not. */
static void check_pair(const struct row *a, const struct row *b, bool bar)
{
    const struct row *both[2] = {a, b};
    const char *grows[2];
    struct sweep_falls *f = NULL;
    struct message why = {""};
    struct plan plan;
    char text[1024], want[2][128], *said = NULL;
    size_t size;
    int grown = 0, judged = 0;

    snprintf(text, sizeof text, "%s%s", head, bar ? by_bar : by_nothing);
    sweep_fixture_plan(text, &plan);
    REQUIRE(sweep_falls_create(&f, &plan) == STATUS_OK && f);
    for (int n = 0; n < 2 * VALUES; n++) {
        const struct sweep_row row = made(both[n % 2]->error[n / 2]);
        sweep_falls_row(f, n, &row);
    }
    REQUIRE(sweep_falls_judge(f, ".", NULL) == STATUS_OK);
    for (int n = 0; n < 2; n++) {
        grows[n] = bar ? both[n]->grows : both[n]->grows_at_all;
        snprintf(want[n], sizeof want[n], "%s,%s,%s,%s\n", n ? "0.5" : "0.1",
                 both[n]->cells, bar ? "0.25" : "0", grows[n]);
        grown += *grows[n] != '\0';
        judged += both[n]->judged;
    }
    char *csv = sweep_fixture_text("falls.csv");
    sweep_fixture_holds("falls", csv, "damping.value,at_1,at_2,at_3,at_4,by,grows_at\n");
    sweep_fixture_holds("falls", csv, want[0]);
    sweep_fixture_holds("falls", csv, want[1]);
    FILE *memory = open_memstream(&said, &size);
    REQUIRE(memory && sweep_falls_print(f, memory) == STATUS_OK && fclose(memory) == 0);
    if (grown)
        snprintf(text, sizeof text, "It grows in %d of %d rows", grown, judged);
    else
        snprintf(text, sizeof text, "It grows in none of %d rows", judged);
    sweep_fixture_holds("falls", said, text);
    CHECK(sweep_falls_check(f, &why) == (grown ? STATUS_FAILED : STATUS_OK));
    snprintf(text, sizeof text,
             "truth_error_end grows along discretization.points in %d of %d rows", grown,
             judged);
    CHECK(!strcmp(why.text, grown ? text : ""));
    free(said);
    free(csv);
    sweep_falls_destroy(f);
    plan_clear(&plan);
}

/* Names of listed cases stand for their keys; without all names the keys are told. */
static void check_names(void)
{
    static const char *const cases[][2] = {
        {"cases: [{name: a, material.poisson: 0}, {name: b, material.poisson: 0.1}]\n",
         "name,damping.value,at_1,"},
        {"cases: [{name: a, material.poisson: 0}, {material.poisson: 0.1}]\n",
         "material.poisson,damping.value,at_1,"}};

    for (int n = 0; n < 2; n++) {
        struct sweep_falls *f = NULL;
        struct plan plan;
        char text[1024];

        snprintf(text, sizeof text, "%s%s%s", head, by_bar, cases[n][0]);
        sweep_fixture_plan(text, &plan);
        REQUIRE(sweep_falls_create(&f, &plan) == STATUS_OK);
        REQUIRE(sweep_falls_judge(f, ".", NULL) == STATUS_OK);
        char *csv = sweep_fixture_text("falls.csv");
        CHECK(!strncmp(csv, cases[n][1], strlen(cases[n][1])));
        free(csv);
        sweep_falls_destroy(f);
        plan_clear(&plan);
    }
}

/* A plan in which nothing is to fall. */
static void check_none(void)
{
    struct sweep_falls *f = NULL;
    struct plan plan;
    const struct sweep_row row = made(1);

    sweep_fixture_plan(head, &plan);
    CHECK(sweep_falls_create(&f, &plan) == STATUS_OK && !f);
    sweep_falls_row(f, 0, &row);
    CHECK(sweep_falls_judge(f, "nowhere", NULL) == STATUS_OK);
    CHECK(sweep_falls_print(f, stdout) == STATUS_OK);
    CHECK(sweep_falls_check(f, NULL) == STATUS_OK);
    sweep_falls_destroy(f);
    plan_clear(&plan);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    sweep_fixture_begin(argv[1]);
    for (int n = 0; n < ROWS * ROWS; n++) {
        check_pair(&rows[n / ROWS], &rows[n % ROWS], false);
        check_pair(&rows[n / ROWS], &rows[n % ROWS], true);
    }
    check_names();
    check_none();
    return check_result();
}

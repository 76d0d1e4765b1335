/* Tests the tables, the map and the falls of a sweep: the numbers under their columns, the
 * map's from the script that draws it. (sweep.sh, sweep_ends.sh: the command, files that
 * are damaged or of others.) */
#include <unistd.h>

#include "bench/files/csv.h"
#include "bench/files/seal.h"
#include "bench/sweep/sweep.h"
#include "tests/fresh.h"

/* Reads a plan and makes its rows, empty. */
static struct sweep_rows begin(const char *text, struct plan *plan)
{
    struct message why = {""};
    struct sweep_rows rows;
    FILE *file = fopen("plan.yaml", "w");

    REQUIRE(file && fputs(text, file) >= 0 && fclose(file) == 0);
    if (!CHECK(plan_read("plan.yaml", plan, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
    REQUIRE(sweep_rows_init(&rows, plan) == STATUS_OK);
    return rows;
}

static void end(struct sweep_rows *rows, struct plan *plan)
{
    sweep_rows_clear(rows);
    plan_clear(plan);
}

/* Fills a row: all measures are `value`. */
static void set(struct sweep_rows *rows, long number, enum sweep_state state,
                enum status outcome, double value, const char *why)
{
    struct run_result r = {.outcome = outcome,
                           .create_seconds = number + 0.5,
                           .step_seconds = number + 0.25,
                           .look_seconds = number};

    for (int n = 0; n < MEASURES; n++)
        r.value[n] = value;
    REQUIRE(sweep_rows_set(rows, number, state, &r, why) == STATUS_OK);
}

static void holds(const char *what, const char *text, const char *part)
{
    if (!CHECK(strstr(text, part)))
        printf("  %s: no '%s' in\n%s", what, part, text);
}

/* The only table of a file. */
static const struct csv_table *read_table(const char *name, struct csv *csv)
{
    REQUIRE(csv_read(name, csv, NULL) == STATUS_OK && csv->count == 1);
    return csv->table;
}

static const char plan_text[] =
    "name: told\nsource: a test\nscene: edge_drop\n"
    "settings: {time.end: 0.01, discretization.points: [4,4,2]}\n"
    "axes: [{key: damping.value, values: [0.1, 0.2, 0.3, 0.4]}]\n"
    "cases: [{name: \"light, so\"}, {material.density: 2}]\n"
    "verdicts:\n"
    "  - {label: big, measure: drop_max, above: 0.5, why: a test}\n"
    "  - {label: odd, measure: speed_max, below: 0.1, why: a test}\n"
    "  - {label: big, measure: stretch_max, above: 2, why: a test}\n";

/* --- the table --- */

static const struct {
    enum sweep_state state;
    enum status outcome;
    double value; /* of the measures, but for a little that each has of its own           */
    const char *why, *verdict, *labels;
} told[] = {
    /* clang-format off */
    {SWEEP_RAN, STATUS_OK, 0.25, "done", "feasible", "feasible"},
    {SWEEP_RAN, STATUS_NAN, 0.75, "died at t = 1 s: of \"x\"", "infeasible", "big"},
    {SWEEP_OPEN, STATUS_OK, 7, "killed", "none", "run again"},
    {SWEEP_OPEN, STATUS_OK, 7, "its file is damaged", "none", "run again"},
    {SWEEP_RAN, STATUS_UNSUPPORTED, NAN, "no contact", "none", "unsupported"},
    {SWEEP_FAILED, STATUS_OK, 7, "timed out after 1 s", "none", "no result"},
    {SWEEP_OPEN, STATUS_OK, 7, "its file is gone", "none", "run again"},
    {SWEEP_RAN, STATUS_OK, NAN, "done", "not judged", "not judged: big, odd"},
    /* clang-format on */
};
enum { TOLD = sizeof told / sizeof *told };

static const double OWN = 1e-5; /* what a measure has more than the one before it */

/* Checks a row: its keys, its measures each under its name, how it ends. */
static void check_case(const struct csv_table *t, int n)
{
    const bool has_run = told[n].state == SWEEP_RAN && isfinite(told[n].value);
    const double damping = 0.1 * (n % 4 + 1), rounding = 1e-12;

    CHECK(csv_number_of(t, n, "case") == n + 1);
    CHECK(!strcmp(csv_words_of(t, n, "name"), n < 4 ? "light, so" : ""));
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
static void check_counts(const struct sweep_rows *rows)
{
    static const char *const label[] = {"feasible",   "big",      "odd",
                                        "not judged", "died",     "unsupported",
                                        "no result",  "run again"};
    static const int count[] = {1, 1, 0, 1, 1, 1, 1, 3};
    char *text = NULL, line[64];
    size_t size;
    FILE *memory = open_memstream(&text, &size);

    REQUIRE(memory);
    sweep_rows_print(rows, memory);
    REQUIRE(fclose(memory) == 0);
    for (int n = 0; n < 8; n++) {
        snprintf(line, sizeof line, "\n  %-24s%6d", label[n], count[n]);
        holds("counts", text, line);
    }
    free(text);
}

static void check_table(void)
{
    struct plan plan;
    struct sweep_rows rows = begin(plan_text, &plan);
    struct csv csv;

    REQUIRE(rows.count == TOLD);
    for (int n = 0; n < TOLD; n++) {
        set(&rows, n, told[n].state, told[n].outcome, told[n].value, told[n].why);
        for (int m = 0; m < MEASURES; m++)
            rows.row[n].value[m] += OWN * m;
    }
    check_counts(&rows);
    REQUIRE(sweep_rows_save(&rows, ".", NULL) == STATUS_OK);
    const struct csv_table *t = read_table("table.csv", &csv);
    REQUIRE(t->rows == TOLD);
    for (int n = 0; n < TOLD; n++)
        check_case(t, n);
    csv_clear(&csv);
    t = read_table("seconds.csv", &csv);
    CHECK(t->rows == 4); /* of those that ran; the last */
    CHECK(csv_number_of(t, 3, "case") == TOLD && csv_number_of(t, 3, "create") == 7.5);
    CHECK(csv_number_of(t, 3, "steps") == 7.25 && csv_number_of(t, 3, "looks") == 7);
    csv_clear(&csv);
    unlink("table.csv");
    CHECK(sweep_rows_save(&rows, "none", NULL) == STATUS_FILE);
    end(&rows, &plan);
}

/* Checks files that are sealed but hold no sentence of a sweep. (sweep_ends.sh: files of
 * other cases and builds, damaged and missing ones.) */
static void check_sentences(void)
{
    static const char *const text[] = {"", "case\n", "case\nfailed\n",
                                       "case\nslept\nso it is\n"};
    const struct sweep_folder here = {.path = "."};
    struct run_result result;
    struct message sentence;
    enum sweep_state state;

    for (size_t n = 0; n < sizeof text / sizeof *text; n++) {
        REQUIRE(seal_text_write("case_000001.txt", text[n], NULL) == STATUS_OK);
        REQUIRE(sweep_folder_read(&here, 0, NULL, false, &state, &result, &sentence) ==
                STATUS_OK);
        CHECK(state == (n == 2 ? SWEEP_FAILED : SWEEP_OPEN));
    }
    sweep_folder_remove(&here, 0);
    CHECK(access("case_000001.txt", F_OK) != 0);
}

/* --- the map: which key lies on which axis, on what scale, in which panel --- */

#define PLAN                                                                               \
    "name: test\nsource: a test\nscene: edge_drop\n"                                       \
    "settings: {time.end: 0.01, discretization.points: [4,4,2]}\n"
#define DAMPING "  - {key: damping.value, values: [0.1, 0.5]}\n"
#define GAMMA   "  - {key: gamma, values: [10, 1000], scale: log}\n"
#define TWO     "axes:\n" DAMPING GAMMA

/* Plans with maps, and how often numbers are in their scripts, three of each: PNG, SVG,
 * PDF; data once; -1: anywhere. The measures of case n are n + 1; the labels are, in turn,
 * feasible, a and b. */
static const struct {
    const char *plan;
    struct {
        const char *text;
        int count;
    } has[4];
} maps[] = {
    /* clang-format off */
    /* cells: half way to the neighbours, on a log scale in the geometric mean */
    {PLAN TWO "map: {x: damping.value, y: gamma}\n", {{"0.1 10 -0.1 0.3 1 100\n", 1},
     {"0.5 1000 0.3 0.7 100 10000\n", 1}, {"\nset logscale y\n", 3}, {"\nset logscale x", 0}}},
    {PLAN TWO "map: {x: gamma, y: damping.value}\n", {{"10 0.1 1 100 -0.1 0.3\n", 1},
     {"1000 0.5 100 10000 0.3 0.7\n", 1}}},
    /* a value alone; values in any order */
    {PLAN
     "axes: [{key: damping.value, values: [0.5, 0.1, 0.9]}, {key: gamma, values: [2]}]\n"
     "map: {x: damping.value, y: gamma}\n", {{"0.5 2 0.3 0.7 1.5 2.5\n", 1},
     {"0.1 2 -0.1 0.3 1.5 2.5\n", 1}, {"0.9 2 0.7 1.1 1.5 2.5\n", 1}}},
    /* a measure: where the case came to lie */
    {PLAN TWO "map: {x: damping.value, y: speed_max}\n", {{"0.1 1\n", 1}, {"0.1 2\n", 1},
     {"0.5 3\n", 1}, {"0.5 4\n", 1}}},
    {PLAN TWO "map: {x: drop_max, y: gamma}\n", {{"1 10\n", 1}, {"4 1000\n", 1},
     {"\nset logscale y\n", 3}, {"\nset logscale x", 0}}},
    /* words lie side by side, whatever the scale */
    {PLAN "axes:\n  - {key: damping.kind, values: [mass, velocity_scale], scale: log}\n"
     DAMPING "map: {x: damping.kind, y: damping.value}\n", {{"0 0.1 -0.5 0.5 -0.1 0.3\n",
     1}, {"1 0.5 0.5 1.5 0.3 0.7\n", 1}, {"'mass' 0,'velocity_scale' 1", -1},
     {"\nset logscale", 0}}},
    /* panels: by a key, by the cases' names */
    {PLAN TWO "map: {x: gamma, y: drop_max, panel: damping.value}\n",
     {{"$p0_0 << EOD\n10 1\n", 1}, {"$p0_1 << EOD\n1000 2\n", 1},
     {"$p1_0 << EOD\n1000 4\n", 1}}},
    {PLAN "cases: [{name: light}, {name: heavy, material.density: 2}]\naxes:\n" DAMPING
     "map: {x: damping.value, y: drop_max, panel: name}\n", {{"$p0_0 << EOD\n0.1 1\n", 1},
     {"$p0_1 << EOD\n0.5 2\n", 1}, {"$p1_0 << EOD\n0.5 4\n", 1}}},
    /* a key that some cases lack: these are nowhere on it */
    {PLAN "cases: [{material.density: 2}, {material.young: 1e4}]\naxes:\n" DAMPING
     "map: {x: material.density, y: drop_max}\n", {{"2 1\n", 1}, {"2 2\n", 1},
     {"2 3\n", 0}, {"nan", 0}}},
    /* marks: points of other people's; E/rho from their own values */
    {PLAN TWO
     "map: {x: damping.value, y: young_over_density, marks: [{text: one, label: theirs, "
     "at: {damping.value: 0.2, material.young: 3e4, material.density: 0.1}}]}\n",
     {{"\n0.2 300000\n", 1}}},
    /* a mark with a panel's value is on that alone, one without on all */
    {PLAN "axes:\n" DAMPING GAMMA "  - {key: material.poisson, values: [0, 0.3]}\n"
     "map: {x: damping.value, y: gamma, panel: material.poisson, marks: [{text: one, "
     "label: theirs, at: {damping.value: 0.25, material.poisson: 0.3}}, {text: two, "
     "label: all, at: {damping.value: 0.75}}]}\n",
     {{"set label 'one' at first 0.25, first ", 3}, {"set label 'two'", 6}}},
    /* clang-format on */
};

/* Draws the rows and returns the script, freed by the caller; NULL: the plan has no map. */
static char *draw(const struct sweep_rows *rows)
{
    struct chart *chart = NULL;

    REQUIRE(sweep_map(rows, &chart, NULL) == STATUS_OK);
    if (!chart)
        return NULL;
    CHECK(chart_write(chart, ".", "map", NULL) == STATUS_UNSUPPORTED);
    chart_destroy(chart);
    return fresh_text(".", "map.gp");
}

/* Draws runs whose measures are 1, 2, ... and that have these labels in turn. */
static char *draw_labels(struct sweep_rows *rows, const char *const *labels, int count)
{
    for (long n = 0; n < rows->count; n++) {
        set(rows, n, SWEEP_RAN, STATUS_OK, (double)n + 1, "done");
        free(rows->row[n].label);
        rows->row[n].label = strdup(labels[n % count]);
    }
    return draw(rows);
}

static void check_maps(void)
{
    static const char *const labels[] = {"feasible", "a", "b"};

    for (size_t n = 0; n < sizeof maps / sizeof *maps; n++) {
        struct plan plan;
        struct sweep_rows rows = begin(maps[n].plan, &plan);
        char *text = draw_labels(&rows, labels, 3);
        for (int i = 0; i < 4 && maps[n].has[i].text; i++) {
            const int count = fresh_count(text, maps[n].has[i].text);
            if (!CHECK(maps[n].has[i].count < 0 ? count > 0
                                                : count == maps[n].has[i].count))
                printf("  map %zu: '%s' is %d times in\n%s", n, maps[n].has[i].text, count,
                       text);
        }
        free(text);
        end(&rows, &plan);
    }
}

/* Checks that each label has its number, the feasible even if there are none, and that the
 * 25th label and all after it are one. */
static void check_labels(void)
{
    struct plan plan;
    struct sweep_rows rows =
        begin(PLAN "axes: [{key: damping.value, from: 0.01, to: 0.3, count: 30}]\n"
                   "map: {x: damping.value, y: drop_max}\n",
              &plan);
    char names[30][16];
    const char *many[30];

    for (int n = 0; n < 30; n++) {
        snprintf(names[n], sizeof names[n], "l%d", n);
        many[n] = names[n];
    }
    char *text = draw_labels(&rows, many, 30);
    holds("labels", text, "'feasible: 0'");
    holds("labels", text, "'l21: 1'");
    holds("labels", text, "'other: 8'");
    free(text);
    end(&rows, &plan);
}

/* Checks that rows without a result lie where their keys say and nowhere on a measure, and
 * that a plan that asks for no map has none. */
static void check_no_result(void)
{
    static const struct {
        const char *plan;
        bool there;
    } known[] = {{PLAN TWO "map: {x: damping.value, y: gamma}\n", true},
                 {PLAN TWO "map: {x: damping.value, y: drop_max}\n", false}};
    struct plan plan;

    for (int k = 0; k < 2; k++) {
        struct sweep_rows rows = begin(known[k].plan, &plan);
        for (int n = 0; n < 4; n++)
            set(&rows, n, SWEEP_FAILED, STATUS_OK, 1, "timed out after 1 s");
        char *text = draw(&rows);
        CHECK((strstr(text, "0.5 1000 0.3 0.7 100 10000\n") != NULL) == known[k].there);
        CHECK((strstr(text, "no result: 4") != NULL) == known[k].there);
        free(text);
        end(&rows, &plan);
    }
    struct sweep_rows rows = begin(PLAN TWO, &plan);
    CHECK(!draw(&rows));
    end(&rows, &plan);
}

/* --- a measure that falls along an axis --- */

enum { VALUES = 4 };
enum { DIED = -1, REFUSED = -2, TIMED_OUT = -3, BLANK = -4 };

/* Rows of made-up errors against a bar of 0.25, and where they grow. */
static const struct {
    double error[VALUES];
    const char *cells, *grows, *grows_at_all; /* the last: without a bar                */
} rows_of_falls[] = {
    {{4, 3, 2, 1}, "4,3,2,1", "", ""},
    {{1, 1.25, 1, 1}, "1,1.25,1,1", "", "\"[5,5]\""}, /* as much as the bar            */
    {{1, 1.5, 1, 0.5}, "1,1.5,1,0.5", "\"[5,5]\"", "\"[5,5]\""},
    /* little by little: against the best net before, not the one before */
    {{1, 1.25, 1.5, 1.75}, "1,1.25,1.5,1.75", "\"[6,6] [7,7]\"", "\"[5,5] [6,6] [7,7]\""},
    {{1, TIMED_OUT, REFUSED, 2}, "1,,,2", "\"[7,7]\"", "\"[7,7]\""},
    {{1, BLANK, DIED, 0.5}, "1,,,0.5", "\"[6,6]\"", "\"[6,6]\""},
    {{DIED, DIED, 2, 1}, ",,2,1", "", ""}, /* what has not lived cannot grow             */
    {{DIED, TIMED_OUT, BLANK, 2}, ",,,2", "", ""},
};
enum { ROWS = sizeof rows_of_falls / sizeof *rows_of_falls };

static const char head[] =
    "name: falls\nsource: a test\nscene: edge_drop\nsettings: {time.end: 0.01}\n"
    "axes:\n"
    "  - {key: discretization.points, values: [[4,4], [5,5], [6,6], [7,7]]}\n"
    "  - {key: damping.value, values: [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8]}\n";
#define FALLS "falls: {measure: truth_error_end, along: discretization.points"

/* Checks all rows, with the bar or without; all but the last have two values to compare. */
static void check_falls(bool bar)
{
    struct plan plan;
    char text[1024];
    struct sweep_falls f;

    snprintf(text, sizeof text, "%s" FALLS "%s}\n", head, bar ? ", by: truth_bar_end" : "");
    struct sweep_rows rows = begin(text, &plan);
    for (int n = 0; n < ROWS * VALUES; n++) {
        const double error = rows_of_falls[n % ROWS].error[n / ROWS];
        set(&rows, n, error == TIMED_OUT ? SWEEP_FAILED : SWEEP_RAN,
            error == DIED      ? STATUS_NAN
            : error == REFUSED ? STATUS_UNSUPPORTED
                               : STATUS_OK,
            error == BLANK ? NAN : error, "done");
        rows.row[n].value[MEASURE_TRUTH_BAR_END] = 0.25;
    }
    REQUIRE(sweep_falls_judge(&f, &rows) == STATUS_OK);
    REQUIRE(table_save(f.table, ".", "falls", NULL) == STATUS_OK);
    char *csv = fresh_text(".", "falls.csv");
    holds("falls", csv, "damping.value,at_1,at_2,at_3,at_4,by,grows_at\n");
    for (int n = 0; n < ROWS; n++) {
        snprintf(text, sizeof text, "\n0.%d,%s,%s,%s\n", n + 1, rows_of_falls[n].cells,
                 bar ? "0.25" : "0",
                 bar ? rows_of_falls[n].grows : rows_of_falls[n].grows_at_all);
        holds("falls", csv, text);
    }
    CHECK(f.rows == 7 && f.grown == (bar ? 4 : 5));
    free(csv);
    sweep_falls_clear(&f);
    end(&rows, &plan);
}

/* Checks that the names of listed cases stand for their keys, and that a plan without
 * `falls` has no table. */
static void check_names(void)
{
    static const char *const cases[] = {
        FALLS "}\ncases: [{name: a, material.poisson: 0}, {name: b}]\n", ""};

    for (int n = 0; n < 2; n++) {
        struct plan plan;
        struct sweep_falls f;
        char text[1024];

        snprintf(text, sizeof text, "%s%s", head, cases[n]);
        struct sweep_rows rows = begin(text, &plan);
        for (long k = 0; k < rows.count; k++)
            set(&rows, k, SWEEP_RAN, STATUS_OK, 1, "done");
        REQUIRE(sweep_falls_judge(&f, &rows) == STATUS_OK);
        CHECK(f.grown == 0 && (f.table != NULL) == (n == 0));
        if (f.table)
            CHECK(table_find(f.table, "name") == 0 &&
                  table_find(f.table, "damping.value") == 1 &&
                  table_find(f.table, "material.poisson") < 0);
        sweep_falls_clear(&f);
        end(&rows, &plan);
    }
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    REQUIRE(chdir(argv[1]) == 0);
    setenv("PATH", "/proc/nowhere", 1); /* the script is what counts: no gnuplot */
    check_table();
    check_sentences();
    check_maps();
    check_labels();
    check_no_result();
    check_falls(false);
    check_falls(true);
    check_names();
    return check_result();
}

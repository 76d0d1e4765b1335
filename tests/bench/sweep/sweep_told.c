/* Tests the tables, the map and the falls of a sweep: the numbers under their columns.
 * (sweep.sh, sweep_ends.sh: the command, files that are damaged or of others.) */
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
    sweep_rows_init(&rows, plan);
    return rows;
}

static void end(struct sweep_rows *rows, struct plan *plan)
{
    arena_clear(&rows->arena);
    plan_clear(plan);
}

static const struct printer files = {.folder = "."};

/* Fills a row: all measures are `value`. */
static void set(struct sweep_rows *rows, long number, enum sweep_state state,
                enum status outcome, double value, const char *why)
{
    struct run_result r = {.outcome = outcome};

    for (int n = 0; n < MEASURES; n++)
        r.value[n] = value;
    sweep_rows_set(rows, number, state, &r, why);
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
    "axes: {case: {\"light, so\": {}, heavy: {material.density: 2}},\n"
    "       damping.value: [0.1, 0.2, 0.3, 0.4]}\n"
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
    REQUIRE(sweep_rows_save(&rows, &files, NULL) == STATUS_OK);
    const struct csv_table *t = read_table("table.csv", &csv);
    REQUIRE(t->rows == TOLD);
    for (int n = 0; n < TOLD; n++)
        check_case(t, n);
    csv_clear(&csv);
    unlink("table.csv");
    CHECK(sweep_rows_save(&rows, &(struct printer){.folder = "none"}, NULL) == STATUS_FILE);
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

/* --- the map: which key is in which column, in which panel --- */

#define PLAN                                                                               \
    "name: test\nsource: a test\nscene: edge_drop\n"                                       \
    "settings: {time.end: 0.01, discretization.points: [4,4,2]}\n"
#define DAMPING "  damping.value: [0.1, 0.5]\n"
#define GAMMA   "  gamma: [10, 1000]\n"
#define TWO     "axes:\n" DAMPING GAMMA

/* Plans with maps, and lines that these have. The measures of case n are n + 1; the labels
 * are, in turn, feasible, a and b. */
static const struct {
    const char *plan, *line[4];
} maps[] = {
    /* clang-format off */
    {PLAN TWO "map: {x: damping.value, y: gamma}\n",
     {"panel,label,damping,\"Gamma, weight against bending\",mark\n", "\n,feasible,0.1,10,\n",
      "\n,feasible,0.5,1000,\n", "\n,b,0.5,10,\n"}},
    /* a measure: where the case came to lie */
    {PLAN TWO "map: {x: damping.value, y: speed_max}\n",
     {"panel,label,damping,speed_max [m/s],mark\n", "\n,feasible,0.1,1,\n", "\n,a,0.1,2,\n",
      "\n,b,0.5,3,\n"}},
    /* words */
    {PLAN "axes:\n  damping.kind: [mass, velocity_scale]\n"
     DAMPING "map: {x: damping.kind, y: damping.value}\n",
     {"damping.kind,damping,", "\n,feasible,mass,0.1,\n", ",velocity_scale,0.5,"}},
    /* panels: by a key, by the cases' names */
    {PLAN TWO "map: {x: gamma, y: drop_max, panel: damping.value}\n",
     {"\ndamping.value = 0.1,feasible,10,1,\n", "\ndamping.value = 0.5,feasible,1000,4,\n"}},
    {PLAN "axes:\n  case: {light: {}, heavy: {material.density: 2}}\n" DAMPING
     "map: {x: damping.value, y: drop_max, panel: case}\n",
     {"\nlight,feasible,0.1,1,\n", "\nheavy,feasible,0.5,4,\n"}},
    /* a key that some cases lack */
    {PLAN "axes:\n  case: {a: {material.density: 2}, b: {material.young: 1e4}}\n" DAMPING
     "map: {x: material.density, y: drop_max}\n", {"\n,a,2,2,\n", "\n,b,,3,\n"}},
    /* marks: points of other people's; E/rho from their own values */
    {PLAN TWO
     "map: {x: damping.value, y: young_over_density, marks: [{text: one, label: theirs, "
     "at: {damping.value: 0.2, material.young: 3e4, material.density: 0.1}}]}\n",
     {"E / rho [m^2/s^2]", "\n*,theirs,0.2", "300000,one\n"}},
    /* a mark with a panel's value is on that alone, one without on all */
    {PLAN "axes:\n" DAMPING GAMMA "  material.poisson: [0, 0.3]\n"
     "map: {x: damping.value, y: gamma, panel: material.poisson, marks: [{text: one, "
     "label: theirs, at: {damping.value: 0.25, material.poisson: 0.3}}, {text: two, "
     "label: all, at: {damping.value: 0.75}}]}\n",
     {"\nmaterial.poisson = 0.3,theirs,0.25,", ",one\n", "\n*,all,0.75,", ",two\n"}},
    /* clang-format on */
};

/* Writes the map and returns it, freed by the caller; NULL: the plan has none. */
static char *write_map(const struct sweep_rows *rows)
{
    remove("map.csv");
    REQUIRE(sweep_map(rows, &files, NULL) == STATUS_OK);
    return access("map.csv", F_OK) == 0 ? fresh_text(".", "map.csv") : NULL;
}

static void check_maps(void)
{
    static const char *const labels[] = {"feasible", "a", "b"};

    for (size_t n = 0; n < sizeof maps / sizeof *maps; n++) {
        struct plan plan;
        struct sweep_rows rows = begin(maps[n].plan, &plan);
        for (long k = 0; k < rows.count; k++) {
            set(&rows, k, SWEEP_RAN, STATUS_OK, (double)k + 1, "done");
            rows.row[k].label = labels[k % 3];
        }
        char *text = write_map(&rows);
        for (int i = 0; i < 4 && maps[n].line[i]; i++)
            holds("map", text, maps[n].line[i]);
        free(text);
        end(&rows, &plan);
    }
}

/* Checks that rows without a result lie where their keys say and nowhere on a measure, and
 * that a plan that asks for no map has none. */
static void check_no_result(void)
{
    struct plan plan;
    struct sweep_rows rows =
        begin(PLAN TWO "map: {x: damping.value, y: drop_max}\n", &plan);

    for (int n = 0; n < 4; n++)
        set(&rows, n, SWEEP_FAILED, STATUS_OK, 1, "timed out after 1 s");
    char *text = write_map(&rows);
    holds("no result", text, "\n,no result,0.5,,\n");
    free(text);
    end(&rows, &plan);
    rows = begin(PLAN TWO, &plan);
    CHECK(!write_map(&rows));
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
    "  discretization.points: [[4,4], [5,5], [6,6], [7,7]]\n"
    "  damping.value: [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8]\n";
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
    struct printer p = files;
    REQUIRE(sweep_falls_print(&rows, &p, &f, NULL) == STATUS_OK);
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
    end(&rows, &plan);
}

/* Checks that labels stand for what they set, and that a plan without `falls` has no
 * table. */
static void check_names(void)
{
    static const char *const cases[] = {
        "  listed: {a: {material.poisson: 0}, b: {}}\n" FALLS "}\n", ""};

    for (int n = 0; n < 2; n++) {
        struct plan plan;
        struct sweep_falls f;
        char text[1024];

        snprintf(text, sizeof text, "%s%s", head, cases[n]);
        struct sweep_rows rows = begin(text, &plan);
        for (long k = 0; k < rows.count; k++)
            set(&rows, k, SWEEP_RAN, STATUS_OK, 1, "done");
        unlink("falls.csv");
        struct printer p = files;
        REQUIRE(sweep_falls_print(&rows, &p, &f, NULL) == STATUS_OK);
        CHECK(f.grown == 0 && (access("falls.csv", F_OK) == 0) == (n == 0));
        char *csv = n ? NULL : fresh_text(".", "falls.csv");
        if (csv)
            holds("listed", csv, "damping.value,listed,at_1,");
        free(csv);
        end(&rows, &plan);
    }
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    fresh_folder(argv[1]);
    REQUIRE(chdir(argv[1]) == 0);
    check_table();
    check_sentences();
    check_maps();
    check_no_result();
    check_falls(false);
    check_falls(true);
    check_names();
    return check_result();
}

/* Tests the tables, the map and the falls of a sweep: the table cell by cell, the map from
 * the script that draws it. (sweep.sh, sweep_ends.sh: the command, files that are damaged
 * or of others.) */
#include <unistd.h>

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

/* Returns the summary for people, freed by the caller. */
static char *print(const struct sweep_rows *rows, const struct sweep_falls *falls)
{
    char *text = NULL;
    size_t size;
    FILE *memory = open_memstream(&text, &size);

    REQUIRE(memory);
    if (falls)
        CHECK(sweep_falls_print(falls, memory) == STATUS_OK);
    else
        sweep_rows_print(rows, memory);
    REQUIRE(fclose(memory) == 0);
    return text;
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

static const char header[] =
    "case,name,scene,time.end,discretization.points,model,material.density,damping.value,"
    "stretch_max,stretch_end,drop_max,drop_end,angle_max,angle_end,roughness_max,"
    "roughness_end,penetration_max,intersections_max,intersections_end,intersection_time,"
    "speed_max,speed_end,energy_drift_max,energy_drift_end,load_max,load_end,blowup_time,"
    "end_time,"
    "gamma_measured,young_over_density_measured,hanging_strain,truth_error_max,"
    "truth_error_end,truth_bar_end,reference_error_max,verdict,labels,outcome\n";

/* The cells of all measures, which have one value. */
#define ALL(x)                                                                             \
    x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x  \
      "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x ","

#define LIGHT(damping) "\"light, so\",edge_drop,0.01,\"[4,4,2]\",iga,," damping ","
#define HEAVY(damping) ",edge_drop,0.01,\"[4,4,2]\",iga,2," damping ","

static const struct {
    enum sweep_state state;
    enum status outcome;
    double value; /* of all measures                                               */
    const char *why;
    const char *line; /* in table.csv, but for the case's number                       */
} told[] = {
    /* clang-format off */
    {SWEEP_RAN, STATUS_OK, 0.25, "done", LIGHT("0.1") ALL("0.25") "feasible,feasible,done"},
    {SWEEP_RAN, STATUS_NAN, 0.75, "died at t = 1 s: of \"x\"", LIGHT("0.2") ALL("0.75")
     "infeasible,big,\"died at t = 1 s: of \"\"x\"\"\""},
    {SWEEP_OPEN, STATUS_OK, 7, "killed", LIGHT("0.3") ALL("") "none,run again,killed"},
    {SWEEP_OPEN, STATUS_OK, 7, "its file is damaged", LIGHT("0.4") ALL("")
     "none,run again,its file is damaged"},
    {SWEEP_RAN, STATUS_UNSUPPORTED, NAN, "no contact", HEAVY("0.1") ALL("")
     "none,unsupported,no contact"},
    {SWEEP_FAILED, STATUS_OK, 7, "timed out after 1 s", HEAVY("0.2") ALL("")
     "none,no result,timed out after 1 s"},
    {SWEEP_OPEN, STATUS_OK, 7, "its file is gone", HEAVY("0.3") ALL("")
     "none,run again,its file is gone"},
    {SWEEP_RAN, STATUS_OK, NAN, "done", HEAVY("0.4") ALL("")
     "not judged,\"not judged: big, odd\",done"},
    /* clang-format on */
};
enum { TOLD = sizeof told / sizeof *told };

static void check_table(void)
{
    struct plan plan;
    struct sweep_rows rows = begin(plan_text, &plan);
    char want[16384], seconds[1024] = "case,create,steps,looks\n", line[2048];

    snprintf(want, sizeof want, "%s", header);
    REQUIRE(rows.count == TOLD);
    for (int n = 0; n < TOLD; n++) {
        set(&rows, n, told[n].state, told[n].outcome, told[n].value, told[n].why);
        snprintf(line, sizeof line, "%d,%s\n", n + 1, told[n].line);
        strcat(want, line);
        snprintf(line, sizeof line, "%d,%g,%g,%d\n", n + 1, n + 0.5, n + 0.25, n);
        strcat(seconds, told[n].state == SWEEP_RAN ? line : "");
    }
    char *said = print(&rows, NULL);
    holds(
        "table", said,
        "told: 8 cases of edge_drop; 2 listed x 4 of damping.value\n\n"
        "  feasible                     1\n"
        "  big                          1   not judged in 1 more, where it was not "
        "measured\n"
        "  odd                          0   not judged in 1 more, where it was not "
        "measured\n"
        "  not judged                   1   no label, but not all could be asked for\n"
        "  died                         1   the numerics ended the run\n"
        "  unsupported                  1   the model leaves something out\n"
        "  no result                    1   timed out, crashed or refused: see table.csv\n"
        "  run again                    3   cut short, or damaged since: --resume does "
        "it\n\n");
    free(said);
    REQUIRE(sweep_rows_save(&rows, ".", NULL) == STATUS_OK);
    char *is = fresh_text(".", "table.csv"), *took = fresh_text(".", "seconds.csv");
    if (!CHECK(!strcmp(is, want)))
        printf("is:\n%swant:\n%s", is, want);
    if (!CHECK(!strcmp(took, seconds)))
        printf("is:\n%swant:\n%s", took, seconds);
    free(is);
    free(took);
    unlink("table.csv");
    CHECK(sweep_rows_save(&rows, "none", NULL) == STATUS_FILE);
    end(&rows, &plan);
}

/* Checks files that are sealed but hold no sentence of a sweep. (sweep_ends.sh: files of
 * other cases, plans and builds, damaged and missing ones.) */
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
        REQUIRE(sweep_folder_read(&here, 0, NULL, false, &state, &result, &sentence,
                                  NULL) == STATUS_OK);
        CHECK(state == (n == 2 ? SWEEP_FAILED : SWEEP_OPEN));
    }
    sweep_folder_remove(&here, 0);
    CHECK(access("case_000001.txt", F_OK) != 0);
}

/* --- the map: which key lies on which axis, on what scale, in which panel and colour ---
 */

#define PLAN                                                                               \
    "name: test\nsource: a test\nscene: edge_drop\n"                                       \
    "settings: {time.end: 0.01, discretization.points: [4,4,2]}\n"
#define DAMPING "  - {key: damping.value, values: [0.1, 0.5]}\n"
#define GAMMA   "  - {key: gamma, values: [10, 1000], scale: log}\n"
#define TWO     "axes:\n" DAMPING GAMMA

/* Plans with maps, and what is in their scripts. The measures of case n are n + 1; the
 * labels are, in turn, feasible, a and b. */
static const struct {
    const char *plan;
    const char *holds[8], *lacks[3];
    struct {
        const char *text;
        int count;
    } counts[3];
} maps[] = {
    /* clang-format off */
    /* cells: half way to the neighbours, on a log scale in the geometric mean */
    {PLAN TWO "map: {x: damping.value, y: gamma}\n", {"0.1 10 -0.1 0.3 1 100\n",
     "0.5 1000 0.3 0.7 100 10000\n", "set xlabel 'damping'\n",
     "set ylabel 'Gamma, weight against bending'\n", "set logscale y\n",
     "set xtics ('0.1' 0.1,'0.5' 0.5)\n", "set ytics ('10' 10,'1000' 1000)\n",
     "boxxyerror"}, {"\nset logscale x", "set title 'd"}},
    {PLAN TWO "map: {x: gamma, y: damping.value}\n", {"10 0.1 1 100 -0.1 0.3\n",
     "1000 0.5 100 10000 0.3 0.7\n", "set xlabel 'Gamma, weight against bending'\n",
     "set ylabel 'damping'\n", "set logscale x\n", "set ytics ('0.1' 0.1,'0.5' 0.5)\n"},
     {"\nset logscale y"}},
    /* a value alone, linear and logarithmic */
    {PLAN
     "axes: [{key: damping.value, values: [0.5]}, {key: gamma, values: [10], scale: log}]\n"
     "map: {x: damping.value, y: gamma}\n", {"0.5 10 0 1 5 20\n"}},
    /* values in any order; three of them */
    {PLAN
     "axes: [{key: damping.value, values: [0.5, 0.1, 0.9]}, {key: gamma, values: [2]}]\n"
     "map: {x: damping.value, y: gamma}\n", {"0.5 2 0.3 0.7 1.5 2.5\n",
     "0.1 2 -0.1 0.3 1.5 2.5\n", "0.9 2 0.7 1.1 1.5 2.5\n"}, {"\nset logscale"}},
    /* a measure: squares where the case came to lie; its unit */
    {PLAN TWO "map: {x: damping.value, y: speed_max}\n", {"0.1 1\n", "0.1 2\n", "0.5 3\n",
     "0.5 4\n", "set ylabel 'speed_max [m/s]'\n"}, {"boxxyerror", "\nset logscale"}},
    {PLAN TWO "map: {x: drop_max, y: gamma}\n", {"1 10\n", "2 1000\n", "3 10\n", "4 1000\n",
     "set xlabel 'drop_max'\n", "set logscale y\n"}, {"boxxyerror", "\nset logscale x"}},
    /* words lie side by side, whatever the scale */
    {PLAN "axes:\n  - {key: damping.kind, values: [mass, velocity_scale], scale: log}\n"
     DAMPING "map: {x: damping.kind, y: damping.value}\n", {"0 0.1 -0.5 0.5 -0.1 0.3\n",
     "1 0.5 0.5 1.5 0.3 0.7\n", "set xtics ('mass' 0,'velocity_scale' 1)\n",
     "set xlabel 'damping.kind'\n"}, {"\nset logscale"}},
    /* panels: by a key, by the cases' names, by a measure */
    {PLAN TWO "map: {x: gamma, y: drop_max, panel: damping.value}\n",
     {"set title 'damping = 0.1'", "set title 'damping = 0.5'", "$p0_0 << EOD\n10 1\n",
     "$p0_1 << EOD\n1000 2\n", "$p1_0 << EOD\n1000 4\n"}},
    {PLAN "cases: [{name: light}, {name: heavy, material.density: 2}]\naxes:\n" DAMPING
     "map: {x: damping.value, y: drop_max, panel: name}\n", {"set title 'light'",
     "set title 'heavy'", "$p0_0 << EOD\n0.1 1\n", "$p0_1 << EOD\n0.5 2\n",
     "$p1_0 << EOD\n0.5 4\n"}},
    {PLAN "axes:\n" DAMPING "map: {x: damping.value, y: drop_max, panel: speed_max}\n",
     {"set title 'speed_max = 1'", "set title 'speed_max = 2'"}},
    /* a key that some cases lack: these are nowhere on it */
    {PLAN "cases: [{material.density: 2}, {material.young: 1e4}]\naxes:\n" DAMPING
     "map: {x: material.density, y: drop_max}\n", {"2 1\n", "2 2\n",
     "set xlabel 'density [kg/m^3]'\n"}, {"2 3\n", "nan"}},
    /* marks: points of other people's; Gamma from their own values; E/rho */
    {PLAN TWO
     "map: {x: damping.value, y: young_over_density, marks: [{text: one, label: theirs, "
     "at: {damping.value: 0.2, material.young: 3e4, material.density: 0.1}}]}\n",
     {"\n0.2 300000\n", "'one'", "'theirs'", "set ylabel 'E / rho [m^2/s^2]'\n"}},
    /* a mark with a panel's value is on that alone, one without on all; three scripts */
    {PLAN "axes:\n" DAMPING GAMMA "  - {key: material.poisson, values: [0, 0.3]}\n"
     "map: {x: damping.value, y: gamma, panel: material.poisson, marks: [{text: one, "
     "label: theirs, at: {damping.value: 0.25, material.poisson: 0.3}}, {text: two, "
     "label: all, at: {damping.value: 0.75}}]}\n",
     {"set label 'one' at first 0.25, first "}, {NULL}, {{"set label 'one'", 3},
     {"set label 'two'", 6}, {"title 'theirs'", 3}}},
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
        char *text = draw_labels(&rows, labels, 3), name[32];
        snprintf(name, sizeof name, "map %zu", n);
        for (int i = 0; i < 8 && maps[n].holds[i]; i++)
            holds(name, text, maps[n].holds[i]);
        for (int i = 0; i < 3 && maps[n].lacks[i]; i++)
            if (!CHECK(!strstr(text, maps[n].lacks[i])))
                printf("  %s: '%s' is in map.gp\n", name, maps[n].lacks[i]);
        for (int i = 0; i < 3 && maps[n].counts[i].text; i++)
            CHECK(fresh_count(text, maps[n].counts[i].text) == maps[n].counts[i].count);
        free(text);
        end(&rows, &plan);
    }
}

/* Checks that the feasible are green even if there are none, that each label has its colour
 * and number, and that the 25th label and all after it are one. */
static void check_labels(void)
{
    static const char *const some[] = {"a", "died", "no result", "run again", "a", "b"};
    static const char *const parts[] = {
        "rgb '#8cd17d' title 'feasible: 0'",  "rgb '#e15759' title 'a: 10'",
        "rgb '#444444' title 'died: 5'",      "rgb '#d9d9d9' title 'no result: 5'",
        "rgb '#d9d9d9' title 'run again: 5'", "rgb '#b07aa1' title 'b: 5'"};
    struct plan plan;
    struct sweep_rows rows =
        begin(PLAN "axes: [{key: damping.value, from: 0.01, to: 0.3, count: 30}]\n"
                   "map: {x: damping.value, y: drop_max}\n",
              &plan);
    char names[30][16], *text = draw_labels(&rows, some, 6);
    const char *many[30];

    for (size_t n = 0; n < sizeof parts / sizeof *parts; n++)
        holds("labels", text, parts[n]);
    free(text);
    for (int n = 0; n < 30; n++) {
        snprintf(names[n], sizeof names[n], "l%d", n);
        many[n] = names[n];
    }
    text = draw_labels(&rows, many, 30);
    holds("many", text, "title 'l21: 1'");
    holds("many", text, "title 'other: 8'");
    CHECK(!strstr(text, "title 'l22"));
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
    char *csv = fresh_text(".", "falls.csv"), *said = print(NULL, &f);
    holds("falls", csv, "damping.value,at_1,at_2,at_3,at_4,by,grows_at\n");
    for (int n = 0; n < ROWS; n++) {
        snprintf(text, sizeof text, "\n0.%d,%s,%s,%s\n", n + 1, rows_of_falls[n].cells,
                 bar ? "0.25" : "0",
                 bar ? rows_of_falls[n].grows : rows_of_falls[n].grows_at_all);
        holds("falls", csv, text);
    }
    holds("falls", said,
          bar ? "It grows in 4 of 7 rows with two" : "It grows in 5 of 7 rows with two");
    CHECK(f.rows == 7 && f.grown == (bar ? 4 : 5));
    free(said);
    free(csv);
    sweep_falls_clear(&f);
    end(&rows, &plan);
}

/* Checks that the names of listed cases stand for their keys, that without all names the
 * keys are shown, and that a plan without `falls` has no table. */
static void check_names(void)
{
    static const char *const cases[][2] = {
        {FALLS "}\ncases: [{name: a, material.poisson: 0}, {name: b}]\n",
         "name,damping.value,at_1,"},
        {FALLS "}\ncases: [{name: a, material.poisson: 0}, {material.poisson: 0.1}]\n",
         "material.poisson,damping.value,at_1,"},
        {"", NULL}};

    for (int n = 0; n < 3; n++) {
        struct plan plan;
        struct sweep_falls f;
        char text[1024];

        snprintf(text, sizeof text, "%s%s", head, cases[n][0]);
        struct sweep_rows rows = begin(text, &plan);
        for (long k = 0; k < rows.count; k++)
            set(&rows, k, SWEEP_RAN, STATUS_OK, 1, "done");
        REQUIRE(sweep_falls_judge(&f, &rows) == STATUS_OK);
        CHECK(f.grown == 0 && !f.table == !cases[n][1]);
        char *said = print(NULL, &f);
        CHECK(strstr(said, "It grows in none of ") || (!f.table && !*said));
        if (f.table) {
            REQUIRE(table_save(f.table, ".", "falls", NULL) == STATUS_OK);
            char *csv = fresh_text(".", "falls.csv");
            CHECK(!strncmp(csv, cases[n][1], strlen(cases[n][1])));
            free(csv);
        }
        free(said);
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

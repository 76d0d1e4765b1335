/* What a sweep tells: its table, cell by cell and row by row; the map, from the script that
 * draws it; whether a measure falls along an axis. (sweep.sh, sweep_ends.sh: its summary,
 * files that are damaged or of others.) */
#include <unistd.h>

#include "bench/experiment/plan.h"
#include "bench/files/seal.h"
#include "bench/sweep/sweep.h"
#include "tests/fresh.h"

static void plan_of(const char *text, struct plan *plan)
{
    struct message why = {""};
    FILE *file = fopen("plan.yaml", "w");

    REQUIRE(file && fputs(text, file) >= 0 && fclose(file) == 0);
    if (!CHECK(plan_read("plan.yaml", plan, &why) == STATUS_OK)) {
        printf("%s\n", why.text);
        exit(1);
    }
}

/* A run that came well to its end, all of whose measures are `value`. */
static struct sweep_row row_ran(double value)
{
    struct sweep_row row = {.state = SWEEP_ROW_RAN, .why = {"done"}};

    for (int n = 0; n < MEASURES; n++)
        row.result.value[n] = value;
    return row;
}

static struct sweep_row row_other(enum sweep_row_state state, const char *why)
{
    struct sweep_row row = {.state = state};

    snprintf(row.why.text, sizeof row.why.text, "%s", why);
    return row;
}

static void holds(const char *what, const char *text, const char *part)
{
    if (!CHECK(strstr(text, part)))
        printf("  %s: no '%s'\n", what, part);
}

static const char plan_text[] =
    "name: told\nsource: a test\nscene: edge_drop\n"
    "settings: {time.end: 0.01, discretization.points: [4,4,2]}\n"
    "axes: [{key: damping.value, values: [0.1, 0.5]}]\n"
    "cases: [{name: \"light, so\"}, {material.density: 2}]\n"
    "verdicts:\n"
    "  - {label: big, measure: drop_max, above: 0.5, why: a test}\n"
    "  - {label: odd, measure: speed_max, below: 0.1, why: a test}\n"
    "  - {label: big, measure: stretch_max, above: 2, why: a test}\n";

/* --- The table. */

static const char header[] =
    "case,name,scene,time.end,discretization.points,model,material.density,damping.value,"
    "stretch_max,stretch_end,drop_max,drop_end,angle_max,angle_end,roughness_max,"
    "roughness_end,penetration_max,intersections_max,intersections_end,intersection_time,"
    "speed_max,speed_end,energy_drift_max,energy_drift_end,load_max,load_end,blowup_time,"
    "end_time,"
    "gamma_measured,young_over_density_measured,hanging_strain,truth_error_max,"
    "truth_error_end,truth_bar_end,verdict,labels,outcome\n";

/* A value that all measures have, and with it every one of them in the table. */
#define ALL(x)                                                                             \
    x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x  \
      "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x "," x ","

static const struct told {
    struct sweep_row row; /* `value`: of all measures                                  */
    double value;
    enum status outcome;
    const char *line; /* in table.csv, but for the case's number                       */
    bool timed;       /* a line in seconds.csv                                         */
} told[] = {
    /* clang-format off */
    {{.state = SWEEP_ROW_RAN, .why = {"done"}}, 0.25, STATUS_OK,
     "\"light, so\",edge_drop,0.01,\"[4,4,2]\",iga,,0.1," ALL("0.25")
     "feasible,feasible,done", true},
    {{.state = SWEEP_ROW_RAN, .why = {"died at t = 1 s: of \"x\""}}, 0.75, STATUS_NAN,
     "\"light, so\",edge_drop,0.01,\"[4,4,2]\",iga,,0.5," ALL("0.75")
     "infeasible,big,\"died at t = 1 s: of \"\"x\"\"\"", true},
    {{.state = SWEEP_ROW_RAN, .why = {"no contact"}}, NAN, STATUS_UNSUPPORTED,
     ",edge_drop,0.01,\"[4,4,2]\",iga,2,0.1," ALL("") "none,unsupported,no contact", true},
    {{.state = SWEEP_ROW_FAILED, .why = {"timed out after 1 s"}}, 7, STATUS_OK,
     ",edge_drop,0.01,\"[4,4,2]\",iga,2,0.5," ALL("") "none,no result,timed out after 1 s",
     false},
    {{.state = SWEEP_ROW_CUT, .why = {"killed"}}, 7, STATUS_OK,
     "\"light, so\",edge_drop,0.01,\"[4,4,2]\",iga,,0.1," ALL("") "none,run again,killed",
     false},
    {{.state = SWEEP_ROW_DAMAGED, .why = {"its file is damaged"}}, 7, STATUS_OK,
     "\"light, so\",edge_drop,0.01,\"[4,4,2]\",iga,,0.5," ALL("")
     "none,run again,its file is damaged", false},
    {{.state = SWEEP_ROW_GONE, .why = {"its file is gone"}}, 7, STATUS_OK,
     ",edge_drop,0.01,\"[4,4,2]\",iga,2,0.1," ALL("") "none,run again,its file is gone",
     false},
    {{.state = SWEEP_ROW_RAN, .why = {"done"}}, NAN, STATUS_OK,
     ",edge_drop,0.01,\"[4,4,2]\",iga,2,0.5," ALL("")
     "not judged,\"not judged: big, odd\",done", true},
    /* clang-format on */
};
enum { TOLD = sizeof told / sizeof *told };

static char *print(const struct plan *plan, const struct pool *pool,
                   const struct sweep_table *table, const char *plot)
{
    char *text = NULL;
    size_t size;
    FILE *memory = open_memstream(&text, &size);

    REQUIRE(memory);
    CHECK(sweep_table_print(plan, &(struct sweep_folder){.path = "there"}, pool, table,
                            NULL, plot, memory) == STATUS_OK);
    REQUIRE(fclose(memory) == 0);
    return text;
}

static void check_table(void)
{
    struct sweep_table table;
    struct plan plan;
    char want[16384], seconds[1024] = "case,create,steps,looks\n", labels[64];
    const struct sweep_folder folder = {.path = "."};

    plan_of(plan_text, &plan);
    REQUIRE(sweep_table_open(&table, &plan, &folder, NULL) == STATUS_OK);
    snprintf(want, sizeof want, "%s", header);
    for (int n = 0; n < TOLD; n++) {
        struct sweep_row row = told[n].row;
        struct plan_case c;
        char line[2048];

        REQUIRE(plan_case_given(&plan, n % 4, &c) == STATUS_OK);
        row.result.outcome = told[n].outcome;
        row.result.create_seconds = n + 0.5;
        row.result.step_seconds = n + 0.25;
        row.result.look_seconds = n;
        for (int i = 0; i < MEASURES; i++)
            row.result.value[i] = told[n].value;
        sweep_table_row(&table, &c, &row, labels, sizeof labels);
        if (!CHECK(strstr(told[n].line, labels)))
            printf("  row %d: label '%s'\n", n, labels);
        snprintf(line, sizeof line, "%d,%s\n", n % 4 + 1, told[n].line);
        strcat(want, line);
        snprintf(line, sizeof line, "%d,%g,%g,%d\n", n % 4 + 1, n + 0.5, n + 0.25, n);
        strcat(seconds, told[n].timed ? line : "");
        plan_case_clear(&c);
    }
    CHECK(table.feasible == 1 && table.died == 1 && table.unsupported == 1);
    CHECK(table.failed == 1 && table.open == 3 && table.unjudged == 1 && table.judged == 3);
    CHECK(table.labels[0] == 1 && table.labels[1] == 0 && table.labels[2] == 1);
    CHECK(table.lacking[0] == 1 && table.lacking[1] == 1 && table.lacking[2] == 1);
    char *said = print(&plan, &(struct pool){.ran = 4, .hands = 2, .seconds = 6, .wall = 4},
                       &table, "no plot");
    holds("table", said, "big                          1   not judged in 1 more");
    holds("table", said,
          "4 cases run now, 2 at a time: 1.5 s of processor time each, 6 s in");
    holds("table", said, "within 4 s; efficiency 75.0 %.");
    free(said);
    REQUIRE(sweep_table_close(&table, NULL) == STATUS_OK);
    char *is = fresh_text(".", "table.csv"), *took = fresh_text(".", "seconds.csv");
    if (!CHECK(!strcmp(is, want)))
        printf("is:\n%swant:\n%s", is, want);
    if (!CHECK(!strcmp(took, seconds)))
        printf("is:\n%swant:\n%s", took, seconds);
    free(is);
    free(took);
    plan_clear(&plan);
}

/* A table that is given up leaves nothing. */
static void check_discard(void)
{
    struct sweep_table table;
    struct plan plan;

    plan_of(plan_text, &plan);
    unlink("table.csv");
    REQUIRE(sweep_table_open(&table, &plan, &(struct sweep_folder){.path = "."}, NULL) ==
            STATUS_OK);
    sweep_table_discard(&table);
    CHECK(access("table.csv", F_OK) != 0);
    CHECK(sweep_table_open(&table, &plan, &(struct sweep_folder){.path = "none"}, NULL) ==
          STATUS_FILE);
    plan_clear(&plan);
}

/* A second opinion has a column, a count, and its bounds in the summary. */
static void check_learnt(void)
{
    static const struct {
        enum sweep_row_state state;
        double value;
        const char *ends; /* its line of table.csv                                     */
    } cases[] = {{SWEEP_ROW_RAN, 0.4, ",feasible,feasible,done,feasible\n"},
                 {SWEEP_ROW_RAN, 0.6, ",infeasible,big,done,feasible\n"},
                 {SWEEP_ROW_RAN, 0.8, ",infeasible,big,done,long\n"},
                 {SWEEP_ROW_FAILED, 0.4, ",none,no result,done,\n"}};
    struct sweep_table table;
    struct plan plan;
    char text[1024], labels[64];

    snprintf(text, sizeof text, "%s%s", plan_text,
             "learnt: [{label: long, measure: drop_max, above: 0.7, why: a test}]\n");
    plan_of(text, &plan);
    REQUIRE(sweep_table_open(&table, &plan, &(struct sweep_folder){.path = "."}, NULL) ==
            STATUS_OK);
    for (int n = 0; n < 4; n++) {
        struct sweep_row row = row_ran(cases[n].value);
        struct plan_case c;

        row.state = cases[n].state;
        REQUIRE(plan_case_given(&plan, n, &c) == STATUS_OK);
        CHECK(sweep_table_row(&table, &c, &row, labels, sizeof labels) == (n < 2));
        plan_case_clear(&c);
    }
    CHECK(table.feasible == 1 && table.learnt == 2);
    char *said = print(&plan, &(struct pool){0}, &table, "");
    holds("learnt", said,
          "\n  feasible                     2   by bounds learnt "
          "from the paper's words:\n");
    holds("learnt", said, " no long: drop_max above 0.7\n");
    free(said);
    REQUIRE(sweep_table_close(&table, NULL) == STATUS_OK);
    char *is = fresh_text(".", "table.csv");
    holds("learnt", is, ",outcome,learnt\n");
    for (int n = 0; n < 4; n++)
        holds("learnt", is, cases[n].ends);
    free(is);
    plan_clear(&plan);
}

/* Sealed, but no sentence of ours. (sweep_ends.sh: files of other cases, plans and builds,
 * damaged ones, those that are gone.) */
static void check_sentences(void)
{
    static const char *const text[] = {"", "case\n", "case\nfailed\n",
                                       "case\nslept\nso it is\n"};
    const struct sweep_folder here = {.path = "."};
    struct sweep_row row;

    for (size_t n = 0; n < sizeof text / sizeof *text; n++) {
        REQUIRE(seal_text_write("case_000001.txt", text[n], NULL) == STATUS_OK);
        sweep_row_read(&here, 0, NULL, false, &row);
        CHECK(row.state == (n == 2 ? SWEEP_ROW_FAILED : SWEEP_ROW_DAMAGED));
        CHECK(sweep_row_is_open(&row) == (n != 2));
    }
    sweep_row_remove(&here, 0);
    CHECK(access("case_000001.txt", F_OK) != 0);
}

/* --- The map: which key lies on which axis, on what scale, in which panel and colour. */

#define PLAN                                                                               \
    "name: test\nsource: a test\nscene: edge_drop\n"                                       \
    "settings: {time.end: 0.01, discretization.points: [4,4,2]}\n"
#define DAMPING "  - {key: damping.value, values: [0.1, 0.5]}\n"
#define GAMMA   "  - {key: gamma, values: [10, 1000], scale: log}\n"
#define TWO     "axes:\n" DAMPING GAMMA

#define LEARNT "learnt: [{label: c, measure: drop_max, above: 9, why: a test}]\n"

/* Measures of case n are n + 1; the cases' labels in turn: feasible, a, b; the second
 * opinion passes those that have b. */
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
     "boxxyerror"}, {"\nset logscale x", "set title 'd", "learnt"}},
    {PLAN TWO "map: {x: gamma, y: damping.value}\n", {"10 0.1 1 100 -0.1 0.3\n",
     "1000 0.5 100 10000 0.3 0.7\n", "set xlabel 'Gamma, weight against bending'\n",
     "set ylabel 'damping'\n", "set logscale x\n", "set ytics ('0.1' 0.1,'0.5' 0.5)\n"},
     {"\nset logscale y"}},
    /* a second opinion: hatched cells over the colours, dots where there are no cells */
    {PLAN TWO LEARNT "map: {x: damping.value, y: gamma}\n",
     {"$p0_3 << EOD\n0.5 10 0.3 0.7 1 100\nEOD", "transparent pattern 5 noborder",
     "title 'feasible by bounds learnt from the paper'.\"'\".'s words: 1'"}},
    {PLAN TWO LEARNT "map: {x: damping.value, y: speed_max}\n", {"$p0_3 << EOD\n0.5 3\nEOD",
     "words: 1'"}, {"boxxyerror"}},
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

static void draw(const struct plan *plan, const char *const *labels, int count)
{
    struct sweep_map *map = NULL;
    struct chart *chart = NULL;
    struct plan_case c;

    REQUIRE(sweep_map_create(&map, plan, "feasible") == STATUS_OK);
    for (long n = 0; n < plan_case_count(plan); n++) {
        const struct sweep_row row = row_ran((double)n + 1);
        REQUIRE(plan_case_given(plan, n, &c) == STATUS_OK);
        REQUIRE(sweep_map_row(map, &c, &row, labels[n % count], n % 3 == 2) == STATUS_OK);
        plan_case_clear(&c);
    }
    REQUIRE(sweep_map_chart(map, &chart, NULL) == STATUS_OK);
    CHECK(chart_write(chart, ".", "map", NULL) == STATUS_UNSUPPORTED);
    chart_destroy(chart);
    sweep_map_destroy(map);
}

static void check_maps(void)
{
    static const char *const labels[] = {"feasible", "a", "b"};

    for (size_t n = 0; n < sizeof maps / sizeof *maps; n++) {
        struct plan plan;
        char name[32];

        snprintf(name, sizeof name, "map %zu", n);
        plan_of(maps[n].plan, &plan);
        draw(&plan, labels, 3);
        char *text = fresh_text(".", "map.gp");
        for (int i = 0; i < 8 && maps[n].holds[i]; i++)
            holds(name, text, maps[n].holds[i]);
        for (int i = 0; i < 3 && maps[n].lacks[i]; i++)
            if (!CHECK(!strstr(text, maps[n].lacks[i])))
                printf("  %s: '%s' is in map.gp\n", name, maps[n].lacks[i]);
        for (int i = 0; i < 3 && maps[n].counts[i].text; i++)
            CHECK(fresh_count(text, maps[n].counts[i].text) == maps[n].counts[i].count);
        free(text);
        plan_clear(&plan);
    }
}

/* What is good is green even where nothing is good; each label has its colour and number;
 * the 25th and all after it are one. */
static void check_labels(void)
{
    static const char *const some[] = {"a", "died", "no result", "run again", "a", "b"};
    struct plan plan;
    char names[30][16];
    const char *many[30];

    plan_of(PLAN "axes: [{key: damping.value, from: 0.01, to: 0.3, count: 30}]\n"
                 "map: {x: damping.value, y: drop_max}\n",
            &plan);
    draw(&plan, some, 6);
    char *text = fresh_text(".", "map.gp");
    static const char *const parts[] = {
        "rgb '#8cd17d' title 'feasible: 0'",  "rgb '#e15759' title 'a: 10'",
        "rgb '#444444' title 'died: 5'",      "rgb '#d9d9d9' title 'no result: 5'",
        "rgb '#d9d9d9' title 'run again: 5'", "rgb '#b07aa1' title 'b: 5'"};
    for (size_t n = 0; n < sizeof parts / sizeof *parts; n++)
        holds("labels", text, parts[n]);
    free(text);
    for (int n = 0; n < 30; n++) {
        snprintf(names[n], sizeof names[n], "l%d", n);
        many[n] = names[n];
    }
    draw(&plan, many, 30);
    text = fresh_text(".", "map.gp");
    holds("many", text, "title 'l21: 1'");
    holds("many", text, "title 'other: 8'");
    CHECK(!strstr(text, "title 'l22"));
    free(text);
    plan_clear(&plan);
}

/* Rows without a result lie where their keys say, and nowhere on a measure. */
static void check_no_result(void)
{
    for (int measure = 0; measure < 2; measure++) {
        struct sweep_map *map = NULL;
        struct chart *chart = NULL;
        struct plan plan;
        struct plan_case c;
        const struct sweep_row row = row_other(SWEEP_ROW_FAILED, "timed out after 1 s");

        plan_of(measure ? PLAN TWO "map: {x: damping.value, y: drop_max}\n"
                        : PLAN TWO "map: {x: damping.value, y: gamma}\n",
                &plan);
        REQUIRE(sweep_map_create(&map, &plan, "feasible") == STATUS_OK);
        REQUIRE(plan_case_given(&plan, 3, &c) == STATUS_OK);
        REQUIRE(sweep_map_row(map, &c, &row, "no result", false) == STATUS_OK);
        REQUIRE(sweep_map_chart(map, &chart, NULL) == STATUS_OK);
        chart_write(chart, ".", "map", NULL);
        char *text = fresh_text(".", "map.gp");
        CHECK((strstr(text, "0.5 1000 0.3 0.7 100 10000\n") != NULL) != measure);
        CHECK((strstr(text, "no result: 1") != NULL) != measure);
        free(text);
        plan_case_clear(&c);
        chart_destroy(chart);
        sweep_map_destroy(map);
        plan_clear(&plan);
    }
}

/* A plan that asks for none has none, which is no failure. */
static void check_no_map(void)
{
    struct sweep_map *map = NULL;
    struct chart *chart = NULL;
    struct plan plan;

    plan_of(PLAN TWO, &plan);
    CHECK(sweep_map_create(&map, &plan, "feasible") == STATUS_OK && !map);
    CHECK(sweep_map_row(map, NULL, NULL, NULL, false) == STATUS_OK);
    CHECK(sweep_map_chart(map, &chart, NULL) == STATUS_OK && !chart);
    sweep_map_destroy(map);
    plan_clear(&plan);
}

/* --- Whether a measure falls along an axis. */

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
    struct sweep_row row =
        error == TIMED_OUT ? row_other(SWEEP_ROW_FAILED, "timed out") : row_ran(0.5);
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
    plan_of(text, &plan);
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
    char *csv = fresh_text(".", "falls.csv");
    holds("falls", csv, "damping.value,at_1,at_2,at_3,at_4,by,grows_at\n");
    holds("falls", csv, want[0]);
    holds("falls", csv, want[1]);
    FILE *memory = open_memstream(&said, &size);
    REQUIRE(memory && sweep_falls_print(f, memory) == STATUS_OK && fclose(memory) == 0);
    if (grown)
        snprintf(text, sizeof text, "It grows in %d of %d rows", grown, judged);
    else
        snprintf(text, sizeof text, "It grows in none of %d rows", judged);
    holds("falls", said, text);
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
        plan_of(text, &plan);
        REQUIRE(sweep_falls_create(&f, &plan) == STATUS_OK);
        REQUIRE(sweep_falls_judge(f, ".", NULL) == STATUS_OK);
        char *csv = fresh_text(".", "falls.csv");
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

    plan_of(head, &plan);
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
    fresh_folder(argv[1]);
    REQUIRE(chdir(argv[1]) == 0);
    setenv("PATH", "/proc/nowhere", 1); /* the script is what counts: no gnuplot */
    check_table();
    check_discard();
    check_learnt();
    check_sentences();
    check_maps();
    check_labels();
    check_no_result();
    check_no_map();
    for (int n = 0; n < ROWS * ROWS; n++) {
        check_pair(&rows[n / ROWS], &rows[n % ROWS], false);
        check_pair(&rows[n / ROWS], &rows[n % ROWS], true);
    }
    check_names();
    check_none();
    return check_result();
}

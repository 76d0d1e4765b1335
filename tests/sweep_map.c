/* The feasibility map: which key lies on which axis, on what scale, in which panel and
 * colour, told from the script that draws it. */
#include "bench/sweep/sweep.h"

#include <unistd.h>

#include "tests/sweep_fixture.h"

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
    /* cells: half way to the neighbours, on a log scale in the geometric mean */
    {PLAN TWO "map: {x: damping.value, y: gamma}\n",
     {"0.1 10 -0.1 0.3 1 100\n", "0.5 1000 0.3 0.7 100 10000\n", "set xlabel 'damping'\n",
      "set ylabel 'Gamma, weight against bending'\n", "set logscale y\n",
      "set xtics ('0.1' 0.1,'0.5' 0.5)\n", "set ytics ('10' 10,'1000' 1000)\n",
      "boxxyerror"},
     {"\nset logscale x", "set title 'd", "learnt"}},
    {PLAN TWO "map: {x: gamma, y: damping.value}\n",
     {"10 0.1 1 100 -0.1 0.3\n", "1000 0.5 100 10000 0.3 0.7\n",
      "set xlabel 'Gamma, weight against bending'\n", "set ylabel 'damping'\n",
      "set logscale x\n", "set ytics ('0.1' 0.1,'0.5' 0.5)\n"},
     {"\nset logscale y"}},
    /* a second opinion: hatched cells over the colours, dots where there are no cells */
    {PLAN TWO LEARNT "map: {x: damping.value, y: gamma}\n",
     {"$p0_3 << EOD\n0.5 10 0.3 0.7 1 100\nEOD", "transparent pattern 5 noborder",
      "title 'feasible by bounds learnt from the paper'.\"'\".'s words: 1'"}},
    {PLAN TWO LEARNT "map: {x: damping.value, y: speed_max}\n",
     {"$p0_3 << EOD\n0.5 3\nEOD", "words: 1'"},
     {"boxxyerror"}},
    /* a value alone, linear and logarithmic */
    {PLAN
     "axes: [{key: damping.value, values: [0.5]}, {key: gamma, values: [10], scale: log}]\n"
     "map: {x: damping.value, y: gamma}\n",
     {"0.5 10 0 1 5 20\n"}},
    /* values in any order; three of them */
    {PLAN
     "axes: [{key: damping.value, values: [0.5, 0.1, 0.9]}, {key: gamma, values: [2]}]\n"
     "map: {x: damping.value, y: gamma}\n",
     {"0.5 2 0.3 0.7 1.5 2.5\n", "0.1 2 -0.1 0.3 1.5 2.5\n", "0.9 2 0.7 1.1 1.5 2.5\n"},
     {"\nset logscale"}},
    /* a measure: squares where the case came to lie; its unit */
    {PLAN TWO "map: {x: damping.value, y: speed_max}\n",
     {"0.1 1\n", "0.1 2\n", "0.5 3\n", "0.5 4\n", "set ylabel 'speed_max [m/s]'\n"},
     {"boxxyerror", "\nset logscale"}},
    {PLAN TWO "map: {x: drop_max, y: gamma}\n",
     {"1 10\n", "2 1000\n", "3 10\n", "4 1000\n", "set xlabel 'drop_max'\n",
      "set logscale y\n"},
     {"boxxyerror", "\nset logscale x"}},
    /* words lie side by side, whatever the scale */
    {PLAN
     "axes:\n  - {key: damping.kind, values: [mass, velocity_scale], scale: log}\n" DAMPING
     "map: {x: damping.kind, y: damping.value}\n",
     {"0 0.1 -0.5 0.5 -0.1 0.3\n", "1 0.5 0.5 1.5 0.3 0.7\n",
      "set xtics ('mass' 0,'velocity_scale' 1)\n", "set xlabel 'damping.kind'\n"},
     {"\nset logscale"}},
    /* panels: by a key, by the cases' names, by a measure */
    {PLAN TWO "map: {x: gamma, y: drop_max, panel: damping.value}\n",
     {"set title 'damping = 0.1'", "set title 'damping = 0.5'", "$p0_0 << EOD\n10 1\n",
      "$p0_1 << EOD\n1000 2\n", "$p1_0 << EOD\n1000 4\n"}},
    {PLAN "cases: [{name: light}, {name: heavy, material.density: 2}]\naxes:\n" DAMPING
          "map: {x: damping.value, y: drop_max, panel: name}\n",
     {"set title 'light'", "set title 'heavy'", "$p0_0 << EOD\n0.1 1\n",
      "$p0_1 << EOD\n0.5 2\n", "$p1_0 << EOD\n0.5 4\n"}},
    {PLAN "axes:\n" DAMPING "map: {x: damping.value, y: drop_max, panel: speed_max}\n",
     {"set title 'speed_max = 1'", "set title 'speed_max = 2'"}},
    /* a key that some cases lack: these are nowhere on it */
    {PLAN "cases: [{material.density: 2}, {material.young: 1e4}]\naxes:\n" DAMPING
          "map: {x: material.density, y: drop_max}\n",
     {"2 1\n", "2 2\n", "set xlabel 'density [kg/m^3]'\n"},
     {"2 3\n", "nan"}},
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
     {"set label 'one' at first 0.25, first "},
     {NULL},
     {{"set label 'one'", 3}, {"set label 'two'", 6}, {"title 'theirs'", 3}}},
};

static void draw(const struct plan *plan, const char *const *labels, int count)
{
    struct sweep_map *map = NULL;
    struct chart *chart = NULL;
    struct plan_case c;

    REQUIRE(sweep_map_create(&map, plan, "feasible") == STATUS_OK);
    for (long n = 0; n < plan_case_count(plan); n++) {
        const struct sweep_row row = sweep_fixture_ran((double)n + 1);
        REQUIRE(plan_case_given(plan, n, &c) == STATUS_OK);
        REQUIRE(sweep_map_row(map, &c, &row, labels[n % count], n % 3 == 2) == STATUS_OK);
        plan_case_clear(&c);
    }
    REQUIRE(sweep_map_chart(map, &chart, NULL) == STATUS_OK);
    CHECK(chart_write(chart, ".", "map", NULL) == STATUS_UNSUPPORTED);
    chart_destroy(chart);
    sweep_map_destroy(map);
}

static int count_of(const char *text, const char *part)
{
    int count = 0;

    for (; (text = strstr(text, part)); text++)
        count++;
    return count;
}

static void check_maps(void)
{
    static const char *const labels[] = {"feasible", "a", "b"};

    for (size_t n = 0; n < sizeof maps / sizeof *maps; n++) {
        struct plan plan;
        char name[32];

        snprintf(name, sizeof name, "map %zu", n);
        sweep_fixture_plan(maps[n].plan, &plan);
        draw(&plan, labels, 3);
        char *text = sweep_fixture_text("map.gp");
        for (int i = 0; i < 8 && maps[n].holds[i]; i++)
            sweep_fixture_holds(name, text, maps[n].holds[i]);
        for (int i = 0; i < 3 && maps[n].lacks[i]; i++)
            if (!CHECK(!strstr(text, maps[n].lacks[i])))
                printf("  %s: '%s' is in map.gp\n", name, maps[n].lacks[i]);
        for (int i = 0; i < 3 && maps[n].counts[i].text; i++)
            CHECK(count_of(text, maps[n].counts[i].text) == maps[n].counts[i].count);
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

    sweep_fixture_plan(PLAN "axes: [{key: damping.value, from: 0.01, to: 0.3, count: 30}]\n"
                            "map: {x: damping.value, y: drop_max}\n",
                       &plan);
    draw(&plan, some, 6);
    char *text = sweep_fixture_text("map.gp");
    static const char *const parts[] = {
        "rgb '#8cd17d' title 'feasible: 0'",  "rgb '#e15759' title 'a: 10'",
        "rgb '#444444' title 'died: 5'",      "rgb '#d9d9d9' title 'no result: 5'",
        "rgb '#d9d9d9' title 'run again: 5'", "rgb '#b07aa1' title 'b: 5'"};
    for (size_t n = 0; n < sizeof parts / sizeof *parts; n++)
        sweep_fixture_holds("labels", text, parts[n]);
    free(text);
    for (int n = 0; n < 30; n++) {
        snprintf(names[n], sizeof names[n], "l%d", n);
        many[n] = names[n];
    }
    draw(&plan, many, 30);
    text = sweep_fixture_text("map.gp");
    sweep_fixture_holds("many", text, "title 'l21: 1'");
    sweep_fixture_holds("many", text, "title 'other: 8'");
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
        const struct sweep_row row =
            sweep_fixture_other(SWEEP_ROW_FAILED, "timed out after 1 s");

        sweep_fixture_plan(measure ? PLAN TWO "map: {x: damping.value, y: drop_max}\n"
                                   : PLAN TWO "map: {x: damping.value, y: gamma}\n",
                           &plan);
        REQUIRE(sweep_map_create(&map, &plan, "feasible") == STATUS_OK);
        REQUIRE(plan_case_given(&plan, 3, &c) == STATUS_OK);
        REQUIRE(sweep_map_row(map, &c, &row, "no result", false) == STATUS_OK);
        REQUIRE(sweep_map_chart(map, &chart, NULL) == STATUS_OK);
        chart_write(chart, ".", "map", NULL);
        char *text = sweep_fixture_text("map.gp");
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

    sweep_fixture_plan(PLAN TWO, &plan);
    CHECK(sweep_map_create(&map, &plan, "feasible") == STATUS_OK && !map);
    CHECK(sweep_map_row(map, NULL, NULL, NULL, false) == STATUS_OK);
    CHECK(sweep_map_chart(map, &chart, NULL) == STATUS_OK && !chart);
    sweep_map_destroy(map);
    plan_clear(&plan);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    sweep_fixture_begin(argv[1]);
    setenv("PATH", "/proc/nowhere", 1); /* the script is what counts: no gnuplot */
    check_maps();
    check_labels();
    check_no_result();
    check_no_map();
    return check_result();
}

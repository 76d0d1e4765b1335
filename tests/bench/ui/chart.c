/* Charts and pictures of sheets: what data and axes their scripts have, names that would be
 * commands, and the files that gnuplot draws. */
#include "bench/ui/chart.h"

#include <glob.h>

#include "bench/ui/picture.h"
#include "bench/ui/plot.h"
#include "models/grid.h"
#include "tests/fresh.h"
#include "tests/scratch.h"

static char *script; /* the one that was read last */

static void read_script(const char *name)
{
    free(script);
    script = fresh_text(".", name);
}

/* Writes and destroys a chart, and reads its script. */
static void write_chart(struct chart *c)
{
    chart_write(c, ".", "chart", NULL);
    chart_destroy(c);
    read_script("chart.gp");
}

/* Checks how often texts stand in the script; -1: at least once. */
struct wanted {
    const char *text;
    int count;
};
static void check_script(const struct wanted *wanted)
{
    for (; wanted->text; wanted++) {
        const int count = fresh_count(script, wanted->text);
        if (!CHECK(wanted->count < 0 ? count > 0 : count == wanted->count))
            printf("  '%s' is %d times in the script\n", wanted->text, count);
    }
}

static void points_bands_and_marks(void)
{
    static const double point[][2] = {
        {250, 0.1}, {125, NAN}, {1000, 0}, {20, 0.5}, {-1, 0.5} /* on no log axis */};
    struct chart *c = chart_create("Cost");

    chart_axes(c, &(struct chart_axis){"set-up", "ms", .log = true},
               &(struct chart_axis){"error", "L"});
    chart_series(c, &(struct chart_series){"iga", .sorted = true});
    for (int n = 0; n < 5; n++)
        chart_point(c, point[n][0], point[n][1]);
    chart_series(c, &(struct chart_series){"half a second", CHART_POINTS});
    chart_point(c, 500, 0.2);
    chart_band(c, "truth's error bar", 0, 0.05);
    chart_mark(c, 250, 0.1, "here");
    write_chart(c);
    check_script((struct wanted[]){
        {"$p0_0 << EOD\n20 0.5\n250 0.1\n1000 0\nEOD\n$p0_1 << EOD\n500 0.2\nEOD\n", 1},
        {"set xlabel 'set-up [ms]'\n", 3}, /* PNG, SVG, PDF */
        {"set logscale x\n", 3},
        {"set logscale y", 0},
        {"rectangle from graph 0, first 0 to graph 1, first 0.05 ", 3},
        {"set label 'here' at first 250, first 0.1 ", 3},
        {"title 'iga'", 3}, /* the legend */
        {NULL}});
}

static void styles_and_panels(void)
{
    static const char *const with[] = {"linespoints", "points", "points pt 5 ps", "boxxy"};
    static const struct chart_tic tics[] = {{1, "one"}, {5, "V"}};
    struct chart *c = chart_create(NULL);
    char text[64];

    chart_axes(c, &(struct chart_axis){"x", "m", .high = 9},
               &(struct chart_axis){"y", .tic_count = 2, .tics = tics});
    for (int panel = 0; panel < 2; panel++) {
        chart_panel(c, panel ? "right" : "left");
        for (int n = 0; n < 4; n++) {
            snprintf(text, sizeof text, "kind %d", n);
            chart_series(c, &(struct chart_series){text, (enum chart_style)n});
            if (n == CHART_CELLS)
                chart_cell(c, 1, 2, (double[]){0.5, 1.5}, (double[]){1.5, 2.5});
            else
                chart_point(c, n, 2);
        }
    }
    chart_series(c, &(struct chart_series){"none", CHART_POINTS});
    chart_point(c, NAN, 1);
    write_chart(c);
    for (int n = 0; n < 4; n++) {
        snprintf(text, sizeof text, "$p1_%d using", n);
        CHECK(strstr(script, text) && strstr(strstr(script, text), with[n]));
    }
    check_script((struct wanted[]){{"$p0_3 << EOD\n1 2 0.5 1.5 1.5 2.5\nEOD\n", 1},
                                   {"set xrange [0:9]", 2 * 3},
                                   {"set ytics ('one' 1,'V' 5)", 2 * 3},
                                   {"$p1_4", 0}, /* nothing to be drawn */
                                   {NULL}});
}

/* Cells fill their panel. */
static void cells(void)
{
    struct chart *c = chart_create(NULL);

    chart_series(c, &(struct chart_series){"good", CHART_CELLS, .rgb = "#8cd17d"});
    chart_cell(c, 1, 10, (double[]){0.5, 1.5}, (double[]){5, 20});
    chart_cell(c, 2, 10, (double[]){1.5, 2.5}, (double[]){5, 20});
    chart_series(c, &(struct chart_series){"row", CHART_POINTS, .rgb = "#000000"});
    chart_point(c, 1, 30);
    write_chart(c);
    check_script((struct wanted[]){
        {"set xrange [0.5:2.5]\n", 3}, {"set yrange [5:30]\n", 3}, {NULL}});
}

/* A label keeps its look in another panel; after the last look comes the first, dashed. */
static void looks(void)
{
    struct chart *c = chart_create(NULL);
    char label[24];

    for (int n = 0; n < 16; n++) { /* in the end one too many in the second panel */
        if (n == 4)
            chart_panel(c, "rest");
        snprintf(label, sizeof label, "line %d", n < 9 ? n : n == 9 ? 2 : n - 1);
        chart_series(c, &(struct chart_series){label});
        chart_point(c, 1, n);
        if (n != 9)
            continue;
        chart_write(c, ".", "chart", NULL);
        read_script("chart.gp");
        const char *a = strstr(script, "$p0_2 using"), *b = strstr(script, "$p1_5 using");
        CHECK(a && b && !strncmp(a + 5, b + 5, 60));
        check_script((struct wanted[]){{"ps scale*1.1 dt (10,6) pt 6 lc", -1}, {NULL}});
    }
    CHECK(chart_write(c, ".", "many", NULL) == STATUS_UNSUPPORTED);
    chart_destroy(c);
}

/* Words stay words wherever they go; none leaves its string. */
static void hostile_names(bool drawn)
{
    static const char *const names[] = {
        "x'; system(\"touch pwned\")",
        "a\n!touch pwned",
        "'\nEOD\nsystem(\"touch pwned\")\n#",
        "`touch pwned`",
        "\".system(\"touch pwned\").\"",
        "\\'; !touch pwned #",
        "} { } ]] ((",
        "@ending {/Bold x} a_b ^2 \\\n, ' . system('touch pwned') . '",
    };
    static const char *const files_of[] = {"|touch pwned", "a'b", "-e", "", "../x", "a b"};
    struct message why = {""};
    struct chart *c;
    glob_t made;

    for (size_t n = 0; n < sizeof names / sizeof *names; n++) {
        const struct chart_tic tic = {1, names[n]};
        const struct chart_axis axis = {names[n], names[n], .tic_count = 1, .tics = &tic};
        c = chart_create(names[n]);
        chart_axes(c, &axis, &axis);
        chart_panel(c, names[n]);
        chart_series(c, &(struct chart_series){names[n], .rgb = "#123456"});
        chart_point(c, 1, 2);
        chart_mark(c, 1, 2, names[n]);
        chart_band(c, names[n], 1, 2);
        CHECK(chart_write(c, ".", "hostile", &why) ==
              (drawn ? STATUS_OK : STATUS_UNSUPPORTED));
        CHECK(glob("pwned*", 0, NULL, &made) == GLOB_NOMATCH);
        read_script("hostile.gp");
        CHECK(!strstr(script, "\"\\n\"")); /* a line end in a name is a blank */
        chart_destroy(c);
    }
    c = chart_create(NULL);
    for (int n = 0; n < 6; n++)
        CHECK(chart_write(c, ".", files_of[n], &why) == STATUS_INPUT);
    chart_destroy(c);
}

static void drawn_files(bool drawn)
{
    static const struct {
        const char *name, *begin;
    } made[] = {{"made.png", "\x89PNG"}, {"made.svg", "<?xml"}, {"made.pdf", "%PDF"}};
    struct chart *c = chart_create("Made");
    struct message why = {""};

    chart_series(c, &(struct chart_series){"line"});
    chart_point(c, 1, 2);
    chart_point(c, 2, 3);
    chart_panel(c, "nothing in it");
    CHECK(chart_write(c, ".", "made", &why) == (drawn ? STATUS_OK : STATUS_UNSUPPORTED));
    for (int n = 0; n < 3 && drawn; n++) {
        read_script(made[n].name);
        CHECK(!strncmp(script, made[n].begin, strlen(made[n].begin)));
    }
    CHECK(chart_write(c, "/proc/nowhere", "made", &why) == STATUS_FILE);
    CHECK(chart_save(c, ".", "made", &why) == STATUS_OK); /* with gnuplot or without */
    CHECK(chart_write(NULL, ".", "made", &why) == STATUS_MEMORY);
}

/* A level sheet of 2 m x 1 m, `lift` up. */
static double *sheet(double lift)
{
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    REQUIRE(xyz);
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        xyz[3 * n] = 2 * uvw[0];
        xyz[3 * n + 1] = uvw[1];
        xyz[3 * n + 2] = lift + 0.2 * (uvw[2] - 0.5); /* its mid-surface is at `lift` */
    }
    return xyz;
}

static void sheets(bool drawn)
{
    double *low = sheet(-1), *high = sheet(0.5);
    const struct picture_panel panels[] = {
        {"low\nt = 1 s", low}, {"dead\r\x1b", NULL}, {"\"high\" it's `so` \\n", high}};
    struct message why = {""};
    int points = 0;

    high[3 * (51 * GRID_U + 51)] = NAN; /* one of every third: the box takes no notice */
    CHECK(picture_save(".", "sheets", 2, 3, panels, &why) == STATUS_OK);
    char *png = drawn ? fresh_text(".", "sheets.png") : NULL;
    CHECK(!drawn || !memcmp(png, "\x89PNG", 4));
    free(png);

    read_script("sheets.gp");
    bool data = false;
    for (char *line = script; *line; line += strcspn(line, "\n") + 1) {
        data = *line == '$' || (data && strncmp(line, "EOD", 3) != 0);
        points += data && *line != '$' && *line != '\n';
    }
    CHECK(points == 2 * 34 * 34); /* every third of 100, corners included */
    check_script((struct wanted[]){{"'dead  '", 1},
                                   {"'\"high\" it'.\"'\".'s `so` \\n'", 1},
                                   {"splot $p", 2},
                                   {"$p1", 0},
                                   {"set view equal xyz", 1},
                                   {"set xrange [-0.04:2.04]", 1},
                                   {"set zrange [-1.03:0.53]", 1},
                                   {"\n$p2 << EOD\n0 0 0.5\n", 1},
                                   {"\n0 0 -1\n", 1}, /* the mid-surface */
                                   {"\n2 1 -1\n", 1},
                                   {NULL}});
    CHECK(picture_save("/proc/nowhere", "sheets", 1, 1, panels, &why) == STATUS_FILE);
    free(low);
    free(high);
}

static void all(bool drawn)
{
    points_bands_and_marks();
    styles_and_panels();
    cells();
    looks();
    hostile_names(drawn);
    drawn_files(drawn);
    sheets(drawn);
}

int main(void)
{
    scratch_open();
    REQUIRE(chdir(scratch) == 0);
    if (system("gnuplot --version >/dev/null 2>&1") == 0)
        all(true);
    REQUIRE(setenv("PATH", scratch, 1) == 0);
    all(false);
    free(script);
    return check_result();
}

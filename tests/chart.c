/* Charts: what script and data hold for each form, names that would be commands, and the
 * files that gnuplot draws, or the sentence where it is missing. */
#include "bench/ui/chart.h"

#include <dirent.h>
#include <unistd.h>

#include "bench/ui/plot.h"
#include "tests/fresh.h"

static const char *folder;

static void holds(const char *script, const char *what)
{
    if (!CHECK(strstr(script, what)))
        printf("  '%s' is not in the script\n", what);
}

/* Two families, seconds shown as milliseconds, one number missing. */
static struct table *cost(void)
{
    static const struct table_column columns[] = {
        {"model", NULL, TABLE_LEFT},
        {"set-up", "ms", .key = "setup_s", .key_unit = "s", .scale = 1e3},
        {"error", "L"}};
    static const struct {
        const char *model;
        double seconds, error;
    } rows[] = {
        {"iga", 0.25, 0.1}, {"shell", 0.5, 0.2}, {"iga", 0.125, NAN}, {"iga", 1, 0}};
    struct table *t = table_create(3, columns, NULL);

    for (int n = 0; n < 4; n++) {
        table_row(t);
        table_text(t, "%s", rows[n].model);
        table_number(t, rows[n].seconds, 3);
        table_number(t, rows[n].error, 3);
    }
    return t;
}

static void rows_become_points(void)
{
    struct table *t = cost();
    const struct chart_axis x = chart_axis_of(t, "setup_s", true);
    const struct chart_axis y = chart_axis_of(t, "error_over_length", false);
    struct chart *c = chart_create("Cost");
    struct message why;

    chart_axes(c, &x, &y);
    chart_series(c, &(struct chart_series){"iga", .sorted = true});
    chart_rows(c, t, "setup_s", "error_over_length", 1,
               &(struct chart_where){"model", "iga"});
    chart_point(c, 20, 0.5);
    chart_point(c, -1, 0.5); /* on no log axis */
    chart_series(c, &(struct chart_series){"half a second", CHART_POINTS});
    chart_rows(c, t, "setup_s", "error_over_length", 1,
               &(struct chart_where){"setup_s", .number = 0.5});
    chart_band(c, "truth's error bar", 0, 0.05);
    chart_mark(c, 250, 0.1, "here");
    chart_write(c, folder, "cost", &why);
    char *script = fresh_text(folder, "cost.gp");
    holds(script,
          "$p0_0 << EOD\n20 0.5\n250 0.1\n1000 0\nEOD\n$p0_1 << EOD\n500 0.2\nEOD\n");
    holds(script, "set xlabel 'set-up [ms]'\n");
    holds(script, "set ylabel 'error [L]'\n");
    holds(script, "set logscale x\n");
    CHECK(!strstr(script, "set logscale y"));
    holds(script, "set multiplot title 'Cost'\n");
    holds(script, "rectangle from graph 0, first 0 to graph 1, first 0.05 ");
    holds(script, "set label 'here' at first 250, first 0.1 ");
    holds(script, "lc rgb '#0072b2' title 'iga'"); /* the legend */
    holds(script, "title 'truth'.\"'\".'s error bar'");
    holds(script, "unset key\n");
    free(script);
    chart_destroy(c);
    table_destroy(t);
}

static void styles_and_panels(void)
{
    static const char *const with[] = {"linespoints", "lines",          "points",
                                       "filled",      "points pt 5 ps", "boxxy"};
    static const struct chart_tic tics[] = {{1, "one"}, {5, NULL}};
    struct chart *c = chart_create(NULL);
    char label[6][24];
    struct message why;

    for (int panel = 0; panel < 2; panel++) {
        chart_panel(c, panel ? "right" : "left");
        if (!panel)
            chart_axes(c, &(struct chart_axis){"x", "m", .high = NAN},
                       &(struct chart_axis){"y", .tic_count = 2, .tics = tics});
        for (int n = 0; n < 6; n++) {
            snprintf(label[n], sizeof label[n], "kind %d", n);
            chart_series(c, &(struct chart_series){label[n], (enum chart_style)n});
            if (n == CHART_CELLS)
                chart_cell(c, 1, 2, (double[]){0.5, 1.5}, (double[]){1.5, 2.5});
            else
                chart_bar(c, n, 2, 1, 3);
        }
    }
    chart_series(c, &(struct chart_series){"none", CHART_POINTS});
    chart_point(c, NAN, 1);
    chart_write(c, folder, "styles", &why);
    char *script = fresh_text(folder, "styles.gp");
    for (int n = 0; n < 6; n++) {
        char want[64];
        snprintf(want, sizeof want, "$p1_%d using", n);
        CHECK(strstr(script, want) && strstr(strstr(script, want), with[n]));
        snprintf(want, sizeof want, "title 'kind %d'", n);
        CHECK(fresh_count(script, want) == 3); /* PNG, SVG, PDF */
    }
    holds(script, "$p0_5 << EOD\n1 2 0.5 1.5 1.5 2.5\nEOD\n");
    holds(script, "$p0_0 << EOD\n0 2 1 3\nEOD\n");
    holds(script, "with yerrorbars");
    CHECK(fresh_count(script, "set xlabel 'x [m]'") == 2 * 3);
    CHECK(fresh_count(script, "set xrange [0:*]") == 2 * 3);
    CHECK(fresh_count(script, "set ytics ('one' 1,'5' 5)") == 2 * 3);
    CHECK(!strstr(script, "$p1_6")); /* nothing to be drawn */
    free(script);
    chart_destroy(c);
}

/* Cells fill their panel. */
static void cells(void)
{
    struct chart *c = chart_create(NULL);
    struct message why;

    chart_series(c, &(struct chart_series){"good", CHART_CELLS, .rgb = "#8cd17d"});
    chart_cell(c, 1, 10, (double[]){0.5, 1.5}, (double[]){5, 20});
    chart_cell(c, 2, 10, (double[]){1.5, 2.5}, (double[]){5, 20});
    chart_series(c, &(struct chart_series){"row", CHART_POINTS, .rgb = "#000000"});
    chart_point(c, 1, 30);
    chart_write(c, folder, "cells", &why);
    char *script = fresh_text(folder, "cells.gp");
    holds(script, "set xrange [0.5:2.5]\n");
    holds(script, "set yrange [5:30]\n");
    holds(script, "with boxxyerror fs solid 1 border lc rgb '#8cd17d' lc rgb '#8cd17d'");
    free(script);
    chart_destroy(c);
}

/* What a label has, it keeps; after the last look comes the first, dashed. */
static void looks(void)
{
    struct chart *c = chart_create(NULL);
    struct message why;
    char label[24];

    for (int n = 0; n < 9; n++) {
        if (n == 4)
            chart_panel(c, "rest");
        snprintf(label, sizeof label, "line %d", n);
        chart_series(c, &(struct chart_series){label});
        chart_point(c, 1, n);
    }
    chart_series(c, &(struct chart_series){"line 2"});
    chart_point(c, 1, 1);
    chart_write(c, folder, "looks", &why);
    char *script = fresh_text(folder, "looks.gp");
    holds(script, "dt (10,6) pt 6 ps scale*1.1 lc rgb '#0072b2' title 'line 8'");
    CHECK(strstr(script, "$p1_5 using"));
    CHECK(
        !strncmp(strstr(strstr(script, "$p1_5 using"), "lc rgb"), "lc rgb '#009e73'", 16));
    for (int n = 9; n < 15; n++) { /* one too many in the second panel */
        snprintf(label, sizeof label, "line %d", n);
        chart_series(c, &(struct chart_series){label});
    }
    CHECK(chart_write(c, folder, "many", &why) == STATUS_UNSUPPORTED);
    CHECK(strstr(why.text, "12 lines"));
    free(script);
    chart_destroy(c);
}

static void remove_file(const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    remove(path);
}

/* How many files a hostile name has made; they go. */
static int pwned(void)
{
    int count = 0;
    DIR *dir = opendir(folder);
    REQUIRE(dir);
    for (struct dirent *e; (e = readdir(dir));)
        if (!strncmp(e->d_name, "pwned", 5)) {
            remove_file(e->d_name);
            count++;
        }
    closedir(dir);
    return count;
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
    enum { NAMES = sizeof names / sizeof *names };
    struct message why = {""};

    pwned();
    for (int n = 0; n < NAMES; n++) {
        const struct chart_tic tic = {1, names[n]};
        const struct chart_axis axis = {names[n], names[n], .tic_count = 1, .tics = &tic};
        struct chart *c = chart_create(names[n]);
        chart_axes(c, &axis, &axis);
        chart_panel(c, names[n]);
        chart_series(c, &(struct chart_series){names[n], .rgb = "#123456"});
        chart_point(c, 1, 2);
        chart_mark(c, 1, 2, names[n]);
        chart_band(c, names[n], 1, 2);
        const enum status st = chart_write(c, folder, "hostile", &why);
        CHECK(st == (drawn ? STATUS_OK : STATUS_UNSUPPORTED));
        CHECK(pwned() == 0);
        char *script = fresh_text(folder, "hostile.gp");
        CHECK(!strstr(script, "\"\\n\"")); /* a line end in a name is a blank */
        free(script);
        chart_destroy(c);
    }
    static const char *const files_of[] = {"|touch pwned", "a'b", "-e", "", "../x", "a b"};
    struct chart *c = chart_create(NULL);
    for (int n = 0; n < 6; n++)
        CHECK(chart_write(c, folder, files_of[n], &why) == STATUS_INPUT);
    chart_destroy(c);
}

static void drawn_files(bool drawn)
{
    static const struct {
        const char *name, *begin;
    } made[] = {{"made.png", "\x89PNG"}, {"made.svg", "<?xml"}, {"made.pdf", "%PDF"}};
    struct chart *c = chart_create("Made");
    struct message why = {""};

    for (int n = 0; n < 3; n++)
        remove_file(made[n].name);
    chart_series(c, &(struct chart_series){"line"});
    chart_point(c, 1, 2);
    chart_point(c, 2, 3);
    chart_panel(c, "nothing in it");
    CHECK(chart_write(c, folder, "made", &why) == (drawn ? STATUS_OK : STATUS_UNSUPPORTED));
    CHECK(drawn || strstr(why.text, "gnuplot is not installed"));
    for (int n = 0; n < 3 && drawn; n++) {
        char *text = fresh_text(folder, made[n].name);
        CHECK(!strncmp(text, made[n].begin, strlen(made[n].begin)));
        free(text);
    }
    CHECK(chart_write(c, "/proc/nowhere", "made", &why) == STATUS_FILE);
    CHECK(chart_save(c, folder, "made", &why) == STATUS_OK); /* with gnuplot or without */
    CHECK(chart_write(NULL, folder, "made", &why) == STATUS_MEMORY);
}

static void all(bool drawn)
{
    rows_become_points();
    styles_and_panels();
    cells();
    looks();
    hostile_names(drawn);
    drawn_files(drawn);
}

int main(int argc, char **argv)
{
    struct message why = {""};

    REQUIRE(argc == 2);
    folder = argv[1];
    REQUIRE(folder_make(folder, &why) == STATUS_OK);
    if (system("gnuplot --version >/dev/null 2>&1") == 0)
        all(true);
    REQUIRE(setenv("PATH", folder, 1) == 0);
    all(false);
    return check_result();
}

/* chart.c - holds a chart as a list of items in the order in which they were given, and
 * turns it into a script of gnuplot: numbers in data blocks, then, for each kind of
 * picture, the panels and the legend, each at its place on the page. */
#define _GNU_SOURCE /* open_memstream */
#include "bench/ui/chart.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/ui/plot.h"
#include "bench/ui/table.h"

struct place {
    double x, y, x_side[2], y_side[2]; /* sides: of cells; a band's are in y           */
};

enum item_kind { PANEL, SERIES, BAND, MARK };

struct item {
    enum item_kind kind;
    struct chart_series as; /* label, owned: a panel's title, a mark's words           */
    int look;               /* from 0                                                  */
    int panel, series;      /* number of its panel, and of the series in it, from 0    */
    int count;
    struct place *at; /* [count], one for a band or a mark                       owned */
};

struct chart {
    char *title;               /*                                                owned */
    struct chart_axis axis[2]; /* x, y: their numbers                                  */
    char *axis_text[2];        /* their names, tics and fixed ends as script     owned */
    int panels, looks, count;
    struct item *item; /* [count]                                                owned */
    bool failed;       /* out of memory somewhere                                      */
};

/* Appends a zero element to an array of `count`, returns it; NULL without memory. */
static void *one_more(struct chart *c, void *array, int *count, size_t size)
{
    char **at = array;
    const size_t n = (size_t)*count;

    if ((n & (n - 1)) == 0) { /* empty or full */
        char *grown = realloc(*at, (n ? 2 * n : 1) * size);
        c->failed = c->failed || !grown;
        if (!grown)
            return NULL;
        *at = grown;
    }
    (*count)++;
    return memset(*at + n * size, 0, size);
}

static char *copy(struct chart *c, const char *text)
{
    char *own = text ? strdup(text) : NULL;

    c->failed = c->failed || (text && !own);
    return own;
}

/* Appends an item to the last panel and returns it, NULL without memory. */
static struct item *add_item(struct chart *c, enum item_kind kind,
                             const struct chart_series *as)
{
    struct item *item =
        c && !c->failed ? one_more(c, &c->item, &c->count, sizeof *item) : NULL;

    if (!item)
        return NULL;
    c->panels += kind == PANEL;
    item->kind = kind;
    item->panel = c->panels - 1;
    item->as = *as;
    item->as.label = copy(c, as->label);
    return item;
}

/* Returns whether a number has a place on an axis. */
static bool is_on(const struct chart_axis *axis, double value)
{
    return isfinite(value) && !(axis->log && value <= 0);
}

/* Gives the last item a place, unless it lies on no axis. */
static void add_place(struct chart *c, struct place place)
{
    if (!c || c->failed || !is_on(&c->axis[0], place.x) || !is_on(&c->axis[1], place.y))
        return;
    struct item *item = &c->item[c->count - 1];
    struct place *at = one_more(c, &item->at, &item->count, sizeof *at);

    assert(item->kind != PANEL);
    if (at)
        *at = place;
}

struct chart *chart_create(const char *title)
{
    static const struct chart_axis none;
    struct chart *c = calloc(1, sizeof *c);

    if (!c)
        return NULL;
    c->title = copy(c, title);
    chart_axes(c, &none, &none);
    add_item(c, PANEL, &(struct chart_series){NULL});
    return c;
}

void chart_destroy(struct chart *c)
{
    if (!c)
        return;
    for (int n = 0; n < c->count; n++) {
        free((char *)c->item[n].as.label);
        free(c->item[n].at);
    }
    free(c->item);
    free(c->axis_text[0]);
    free(c->axis_text[1]);
    free(c->title);
    free(c);
}

/* Returns whether the ends of an axis are given. */
static bool is_fixed(const struct chart_axis *axis)
{
    return axis->low < axis->high;
}

/* Writes what is the same in all panels. */
static void write_fixed(FILE *file, char name, const struct chart_axis *axis)
{
    const bool unit = axis->unit && strcmp(axis->unit, "1") != 0;
    char label[256];

    snprintf(label, sizeof label, unit ? "%s [%s]" : "%s", axis->name ? axis->name : "",
             axis->unit);
    fprintf(file, "set %clabel ", name);
    plot_line(file, label);
    fprintf(file, "\nset format %c '%%g'\n", name);
    if (axis->log)
        fprintf(file, "set logscale %c\n", name);
    if (is_fixed(axis))
        fprintf(file, "set %crange [%.9g:%.9g]\n", name, axis->low, axis->high);
    if (axis->tic_count)
        fprintf(file, "set %ctics ", name);
    for (int n = 0; n < axis->tic_count; n++) {
        fputc(n ? ',' : '(', file);
        plot_line(file, axis->tics[n].text);
        fprintf(file, " %.9g", axis->tics[n].at);
    }
    fputs(axis->tic_count ? ")\n" : "", file);
}

void chart_axes(struct chart *c, const struct chart_axis *x, const struct chart_axis *y)
{
    for (int n = 0; c && n < 2; n++) {
        const struct chart_axis *axis = n ? y : x;
        size_t size;

        c->axis[n] = *axis;
        free(c->axis_text[n]);
        c->axis_text[n] = NULL;
        FILE *file = open_memstream(&c->axis_text[n], &size);
        if (file)
            write_fixed(file, "xy"[n], axis);
        c->failed = !file || fclose(file) != 0 || c->failed;
    }
}

void chart_panel(struct chart *c, const char *title)
{
    if (c && c->count == 1 && !c->item->as.label)
        c->item->as.label = copy(c, title);
    else
        add_item(c, PANEL, &(struct chart_series){title});
}

static bool same_label(const struct item *a, const struct item *b)
{
    return a->kind == b->kind && a->as.label && b->as.label &&
           !strcmp(a->as.label, b->as.label);
}

/* Returns the first item with the kind and label of the n-th, which may be itself. */
static const struct item *first_of(const struct chart *c, int n)
{
    for (int k = 0; k < n; k++)
        if (same_label(&c->item[k], &c->item[n]))
            return &c->item[k];
    return &c->item[n];
}

void chart_series(struct chart *c, const struct chart_series *series)
{
    struct item *item = add_item(c, SERIES, series);

    if (!item)
        return;
    for (int n = 0; n < c->count - 1; n++)
        item->series += c->item[n].kind == SERIES && c->item[n].panel == item->panel;
    const struct item *first = first_of(c, c->count - 1);
    item->look = series->colour  ? series->colour - 1
                 : first != item ? first->look
                                 : c->looks++;
}

void chart_point(struct chart *c, double x, double y)
{
    add_place(c, (struct place){x, y});
}

void chart_cell(struct chart *c, double x, double y, const double x_side[2],
                const double y_side[2])
{
    add_place(c, (struct place){x, y, {x_side[0], x_side[1]}, {y_side[0], y_side[1]}});
}

void chart_band(struct chart *c, const char *label, double low, double high)
{
    if (add_item(c, BAND, &(struct chart_series){label}))
        add_place(c, (struct place){1, 1, .y_side = {low, high}});
}

void chart_mark(struct chart *c, double x, double y, const char *text)
{
    if (add_item(c, MARK, &(struct chart_series){text}))
        chart_point(c, x, y);
}

/* --- looks: colours, points and dashes ------------------------------------------------ */

/* Looks that all eyes can distinguish (Okabe and Ito), in grey by their points. */
static const struct look {
    const char *rgb;
    int filled, open; /* points */
} looks[] = {{"#0072b2", 7, 6},   {"#d55e00", 5, 4},   {"#009e73", 9, 8},
             {"#cc79a7", 13, 12}, {"#000000", 11, 10}, {"#e69f00", 15, 14},
             {"#56b4e9", 3, 2},   {"#7f7f7f", 1, 1}};
enum { LOOKS = sizeof looks / sizeof *looks };

static const char band_rgb[] = "#c8c8c8";

static void write_look(FILE *file, const struct item *item, bool legend)
{
    static const struct {
        const char *with, *in_legend; /* NULL: the same */
    } forms[] = {[CHART_LINESPOINTS] = {"linespoints lw 1.6 ps scale*1.1", NULL},
                 [CHART_POINTS] = {"points ps scale*1.2", NULL},
                 [CHART_SQUARES] = {"points pt 5 ps scale*1.6", NULL},
                 [CHART_CELLS] = {"boxxyerror fs solid 1", "points pt 5 ps scale*2"}};
    const enum chart_style style = item->as.style;
    const struct look *look = &looks[item->look % LOOKS];
    const char *rgb = item->as.rgb ? item->as.rgb : look->rgb;
    /* as those beyond the number of looks are, too */
    const bool second = item->as.second || item->look / LOOKS % 2;

    fprintf(file, " with %s",
            legend && forms[style].in_legend ? forms[style].in_legend : forms[style].with);
    if (style == CHART_LINESPOINTS && second)
        fputs(" dt (10,6)", file);
    if (style == CHART_LINESPOINTS || style == CHART_POINTS)
        fprintf(file, " pt %d", second ? look->open : look->filled);
    if (style == CHART_CELLS && !legend)
        fprintf(file, " border lc rgb '%s'", rgb);
    fprintf(file, " lc rgb '%s'", rgb);
}

/* --- the legend ----------------------------------------------------------------------- */

/* Sizes in points of a screen: one panel alone, one of several, lines of text, a character,
 * the picture of a line in the legend with the room around it. */
enum { WIDE = 900, HIGH = 520, NARROW = 480, LOW = 380 };
enum { LINE = 20, CHARACTER = 8, KEY = 70 };

/* Returns whether the legend, which has each label once, takes it from this item. */
static bool is_entry(const struct chart *c, int n, enum item_kind kind)
{
    const struct item *item = &c->item[n];

    return item->kind == kind && item->as.label && first_of(c, n) == item;
}

/* Returns the rows of the legend, and its columns, as even as possible. */
static int legend_rows(const struct chart *c, int width, int *columns)
{
    int count = 0, widest = 1;

    for (int n = 0; n < c->count; n++)
        if (is_entry(c, n, SERIES) || is_entry(c, n, BAND)) {
            const int label = table_width(c->item[n].as.label);
            widest = label > widest ? label : widest;
            count++;
        }
    *columns = (width - 40) / (KEY + CHARACTER * widest);
    *columns = *columns < 1 ? 1 : *columns;
    const int rows = (count + *columns - 1) / *columns;
    *columns = rows ? (count + rows - 1) / rows : 1;
    return rows;
}

static void write_legend(FILE *file, const struct chart *c, int columns)
{
    fprintf(file,
            "unset object\nunset label\nunset logscale\nunset border\n"
            "unset tics\nunset grid\nunset title\nunset xlabel\nunset ylabel\n"
            "set lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
            "set key center center horizontal maxcols %d Left reverse samplen 3\n"
            "plot [0:1][0:1] \\\n",
            columns);
    for (enum item_kind kind = SERIES; kind <= BAND; kind++)
        for (int n = 0; n < c->count; n++) {
            const struct item *item = &c->item[n];
            if (!is_entry(c, n, kind))
                continue;
            fputs("NaN", file);
            if (kind == SERIES)
                write_look(file, item, true);
            else
                fprintf(file, " with points pt 5 ps scale*2 lc rgb '%s'", band_rgb);
            fputs(" title ", file);
            plot_line(file, item->as.label);
            fputs(", \\\n", file);
        }
    fputs("NaN notitle\n", file);
}

/* --- a panel -------------------------------------------------------------------------- */

static bool has_cells(const struct item *item)
{
    return item->as.style == CHART_CELLS;
}

static int by_x(const void *a, const void *b)
{
    const struct place *left = a, *right = b;

    return (left->x > right->x) - (left->x < right->x);
}

static void write_block(FILE *file, const struct item *item)
{
    if (item->as.sorted)
        qsort(item->at, (size_t)item->count, sizeof *item->at, by_x);
    fprintf(file, "$p%d_%d << EOD\n", item->panel, item->series);
    for (const struct place *at = item->at; at < item->at + item->count; at++) {
        fprintf(file, "%.9g %.9g", at->x, at->y);
        if (has_cells(item))
            fprintf(file, " %.9g %.9g %.9g %.9g", at->x_side[0], at->x_side[1],
                    at->y_side[0], at->y_side[1]);
        fputc('\n', file);
    }
    fputs("EOD\n", file);
}

/* Finds the least and greatest value on an axis; returns whether cells, which fill their
 * panel, are among the data. */
static bool ends_of(const struct chart *c, int panel, int axis, double *low, double *high)
{
    bool celled = false;

    *low = INFINITY, *high = -INFINITY;
    for (const struct item *item = c->item; item < c->item + c->count; item++)
        for (int k = 0; k < item->count && item->kind == SERIES && item->panel == panel;
             k++) {
            const struct place *at = &item->at[k];
            const double value = axis ? at->y : at->x;
            const double *side = axis ? at->y_side : at->x_side;
            celled = celled || has_cells(item);
            *low = fmin(*low, has_cells(item) ? side[0] : value);
            *high = fmax(*high, has_cells(item) ? side[1] : value);
        }
    return celled;
}

/* Writes tics at 1, 2 and 5 of each decade where the axis has fewer than two decades:
 * gnuplot numbers decades only. */
static void write_decade_tics(FILE *file, char name, double low, double high)
{
    static const int of_decade[] = {1, 2, 5};
    const char *comma = "";

    if (!(low > 0) || high / low > 150 || high / low < 1.0001)
        return;
    fprintf(file, "set %ctics (", name);
    for (int decade = (int)floor(log10(low)); decade <= (int)ceil(log10(high)); decade++)
        for (int n = 0; n < 3; n++) {
            fprintf(file, "%s%.9g", comma, of_decade[n] * pow(10, decade));
            comma = ",";
        }
    fputs(")\n", file);
}

/* Sets the range where the data have none of their own, which gnuplot insists on, and that
 * of cells, to which gnuplot would add room. */
static void write_range(FILE *file, char name, bool celled, double low, double high)
{
    const double room = fmax(fabs(low) / 2, 1e-9);

    if (low > high)
        fprintf(file, "set %crange [1:10]\n", name);
    else if (celled)
        fprintf(file, "set %crange [%.9g:%.9g]\n", name, low, high);
    else if (low == high)
        fprintf(file, "set %crange [%.9g:%.9g]\n", name, low - room, high + room);
}

static void write_axis(FILE *file, const struct chart *c, int panel, int n)
{
    const struct chart_axis *axis = &c->axis[n];
    double low, high;
    const bool celled = ends_of(c, panel, n, &low, &high);

    fputs(c->axis_text[n], file);
    if (is_fixed(axis))
        low = axis->low, high = axis->high;
    else
        write_range(file, "xy"[n], celled, low, high);
    if (axis->log && !axis->tic_count)
        write_decade_tics(file, "xy"[n], low, high);
}

/* Writes a band as an object, which lies behind the data. */
static void write_band(FILE *file, const struct item *item, bool log)
{
    const double low = item->at->y_side[0], high = item->at->y_side[1];

    if (isnan(low) || isnan(high) || (log && high <= 0))
        return;
    fputs("set object rectangle from graph 0, ", file);
    fprintf(file, log && low <= 0 ? "graph 0" : "first %.9g", low);
    fprintf(file, " to graph 1, first %.9g fc rgb '%s' fs solid noborder behind\n", high,
            band_rgb);
}

static void write_mark(FILE *file, const struct item *mark)
{
    fputs("set label ", file);
    plot_line(file, mark->as.label);
    fprintf(file, " at first %.9g, first %.9g center offset 0,0.8 font ',9' front\n",
            mark->at->x, mark->at->y);
}

static void write_series(FILE *file, const struct item *item)
{
    fprintf(file, "$p%d_%d using %s", item->panel, item->series,
            has_cells(item) ? "1:2:3:4:5:6" : "1:2");
    write_look(file, item, false);
    fputs(" notitle, \\\n", file);
}

static void write_panel(FILE *file, const struct chart *c, int panel)
{
    const struct item *item = c->item, *end = c->item + c->count;

    fputs("unset object\nunset label\nunset logscale\n"
          "set autoscale\nset xtics autofreq\nset ytics autofreq\n"
          "set tics out nomirror\nset grid xtics ytics lt 1 lw 0.8 lc rgb '#d8d8d8'\n"
          "unset key\n",
          file);
    write_axis(file, c, panel, 0);
    write_axis(file, c, panel, 1);
    for (item = c->item; item < end; item++)
        if (item->panel != panel) {
            continue;
        } else if (item->kind == PANEL) {
            fputs("set title ", file);
            plot_line(file, item->as.label ? item->as.label : "");
            fputc('\n', file);
        } else if (item->kind == BAND) {
            write_band(file, item, c->axis[1].log);
        } else if (item->kind == MARK && item->count) {
            write_mark(file, item);
        }
    fputs("plot \\\n", file);
    for (item = c->item; item < end; item++)
        if (item->panel == panel && item->kind == SERIES && item->count)
            write_series(file, item);
    fputs("NaN notitle\n", file);
}

/* --- the page ------------------------------------------------------------------------- */

/* Wraps words to lines of at most `most` characters, at blanks, since gnuplot does not;
 * returns the number of lines. */
static int wrap(const char *text, int most, char *wrapped, int size)
{
    int lines = 1, column = 0;
    char *blank = NULL;

    snprintf(wrapped, (size_t)size, "%s", text);
    for (char *at = wrapped; *at; at++) {
        *at = iscntrl((unsigned char)*at) ? ' ' : *at;
        blank = *at == ' ' ? at : blank;
        if (++column <= most || !blank)
            continue;
        *blank = '\n';
        column = (int)(at - blank);
        blank = NULL;
        lines++;
    }
    return lines;
}

/* Writes one picture: its size, the title, panels in rows, the legend. */
static void write_page(FILE *file, const struct chart *c, const char *name,
                       enum plot_kind kind)
{
    static const int columns_of[] = {1, 1, 2, 3, 2, 3, 3, 3, 4, 3};
    const int columns = c->panels < 10 ? columns_of[c->panels] : 4;
    const int rows = (c->panels + columns - 1) / columns;
    const int width = columns == 1 ? WIDE : NARROW * columns;
    const int high = c->panels == 1 ? HIGH : LOW;
    char title[1024] = "";
    const int lines = c->title ? wrap(c->title, width / CHARACTER, title, sizeof title) : 0;
    int legend_columns;
    const int legend = legend_rows(c, width, &legend_columns);
    const int foot = legend ? LINE * legend + 16 : 0;
    const int height = 8 + LINE * lines + rows * high + foot;

    plot_page(file, name, kind, width, height);
    fputs("set multiplot title ", file);
    plot_lines(file, title);
    fputc('\n', file);
    for (int p = 0; p < c->panels; p++) {
        const int up = rows - 1 - p / columns;
        fprintf(file, "set size %.6g,%.6g\nset origin %.6g,%.6g\n", 1. / columns,
                (double)high / height, (double)(p % columns) / columns,
                (foot + (double)high * up) / height);
        write_panel(file, c, p);
    }
    if (legend) {
        fprintf(file, "set size 1,%.6g\nset origin 0,0\n", (double)foot / height);
        write_legend(file, c, legend_columns);
    }
}

/* Returns the series of a panel that the reader must follow as lines of their own: classes
 * do not count, nor series that repeat a label or have none. */
static int lines_of(const struct chart *c, int panel)
{
    int count = 0;

    for (int n = 0; n < c->count; n++) {
        const struct chart_series *as = &c->item[n].as;
        bool line = c->item[n].kind == SERIES && c->item[n].panel == panel && as->label &&
                    !as->rgb && as->style != CHART_SQUARES && as->style != CHART_CELLS;
        for (int k = 0; k < n && line; k++)
            line = c->item[k].panel != panel || !same_label(&c->item[k], &c->item[n]);
        count += line;
    }
    return count;
}

enum status chart_write(const struct chart *c, const char *folder, const char *name,
                        struct message *why)
{
    struct output *out = NULL;
    enum status st;

    if (!c || c->failed)
        return STATUS_MEMORY;
    for (int p = 0; p < c->panels; p++)
        if (lines_of(c, p) > CHART_LINES_MOST)
            return status_fail(why, STATUS_UNSUPPORTED,
                               "no plot: a panel of %s has %d lines, and eyes follow %d",
                               name, lines_of(c, p), CHART_LINES_MOST);
    TRY(plot_begin(folder, name, &out, why));
    for (int n = 0; n < c->count; n++)
        if (c->item[n].kind == SERIES && c->item[n].count)
            write_block(output_stream(out), &c->item[n]);
    for (int kind = 0; kind < PLOT_KINDS; kind++)
        write_page(output_stream(out), c, name, (enum plot_kind)kind);
    TRY(plot_end(folder, name, &out, why));
out:
    return st;
}

enum status chart_save(struct chart *c, const char *folder, const char *name,
                       struct message *why)
{
    struct message plot = {""};
    enum status st = chart_write(c, folder, name, &plot);

    chart_destroy(c);
    return plot_tell(st, folder, name, ".png, .svg and .pdf", &plot, why);
}

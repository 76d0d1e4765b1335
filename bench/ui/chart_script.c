/* chart_script.c - a chart as a script of gnuplot: numbers in data blocks, then the panels
 * and the legend, each at its place on the page. */
#include "bench/ui/chart_parts.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/ui/plot.h"

/* Points of a screen: one panel alone, one of several, lines of text. */
enum { WIDE = 900, HIGH = 520, NARROW = 480, LOW = 380, LINE = 20 };

/* --- data ----------------------------------------------------------------------------- */

static bool is_drawn(const struct chart_axis axis[2], const struct chart_place *at)
{
    return isfinite(at->x) && isfinite(at->y) && !(axis[0].log && at->x <= 0) &&
           !(axis[1].log && at->y <= 0);
}

static int drawn_of(const struct chart_pane *p, const struct chart_item *item)
{
    int count = 0;

    for (int n = 0; n < item->count; n++)
        count += is_drawn(p->axis, &item->at[n]);
    return count;
}

static int by_x(const void *a, const void *b)
{
    const struct chart_place *left = a, *right = b;

    return (left->x > right->x) - (left->x < right->x);
}

static void write_block(struct output *out, const struct chart_pane *p, int pane, int n)
{
    const struct chart_item *item = &p->series.item[n];

    if (item->as.sorted && item->count)
        qsort(item->at, (size_t)item->count, sizeof *item->at, by_x);
    output_print(out, "$p%d_%d << EOD\n", pane, n);
    for (int k = 0; k < item->count; k++) {
        const struct chart_place *at = &item->at[k];
        if (!is_drawn(p->axis, at))
            continue;
        output_print(out, "%.9g %.9g", at->x, at->y);
        if (item->celled)
            output_print(out, " %.9g %.9g", at->x_side[0], at->x_side[1]);
        if (item->barred)
            output_print(out, " %.9g %.9g", at->y_side[0], at->y_side[1]);
        output_print(out, "\n");
    }
    output_print(out, "EOD\n");
}

/* --- a panel -------------------------------------------------------------------------- */

/* The data's ends on an axis; whether they are those of cells, which fill their panel. */
static bool ends_of(const struct chart_pane *p, int axis, double *low, double *high)
{
    bool celled = false;

    *low = INFINITY, *high = -INFINITY;
    for (int n = 0; n < p->series.count; n++)
        for (int k = 0; k < p->series.item[n].count; k++) {
            const struct chart_place *at = &p->series.item[n].at[k];
            const double value = axis ? at->y : at->x;
            const double *side = axis ? at->y_side : at->x_side;
            const bool cell = p->series.item[n].celled;
            if (!is_drawn(p->axis, at))
                continue;
            celled = celled || cell;
            *low = fmin(*low, cell ? side[0] : value);
            *high = fmax(*high, cell ? side[1] : value);
        }
    return celled;
}

/* gnuplot numbers decades only: on fewer than two of them 1, 2 and 5 of each. */
static void write_decade_tics(struct output *out, char name, double low, double high)
{
    static const int of_decade[] = {1, 2, 5};
    const char *comma = "";

    if (!(low > 0) || high / low > 150 || high / low < 1.0001)
        return;
    output_print(out, "set %ctics (", name);
    for (int decade = (int)floor(log10(low)); decade <= (int)ceil(log10(high)); decade++)
        for (int n = 0; n < 3; n++) {
            output_print(out, "%s%.9g", comma, of_decade[n] * pow(10, decade));
            comma = ",";
        }
    output_print(out, ")\n");
}

static void write_tics(struct output *out, char name, const struct chart_axis *axis)
{
    output_print(out, "set %ctics (", name);
    for (int n = 0; n < axis->tic_count; n++) {
        char number[32];
        snprintf(number, sizeof number, "%g", axis->tics[n].at);
        output_print(out, n ? "," : "");
        plot_text(out, axis->tics[n].text ? axis->tics[n].text : number);
        output_print(out, " %.9g", axis->tics[n].at);
    }
    output_print(out, ")\n");
}

/* Of data that has no range of its own: gnuplot wants one all the same, and adds room to
 * that of cells. */
static void write_range(struct output *out, char name, bool celled, double low, double high)
{
    const double room = fmax(fabs(low) / 2, 1e-9);

    if (low > high)
        output_print(out, "set %crange [1:10]\n", name);
    else if (celled)
        output_print(out, "set %crange [%.9g:%.9g]\n", name, low, high);
    else if (low == high)
        output_print(out, "set %crange [%.9g:%.9g]\n", name, low - room, high + room);
}

static void write_axis(struct output *out, const struct chart_pane *p, int n)
{
    const struct chart_axis *axis = &p->axis[n];
    const char name = n ? 'y' : 'x';
    char label[256];
    double low, high;

    const bool celled = ends_of(p, n, &low, &high);
    snprintf(label, sizeof label,
             axis->unit && strcmp(axis->unit, "1") != 0 ? "%s [%s]" : "%s",
             axis->name ? axis->name : "", axis->unit);
    output_print(out, "set %clabel ", name);
    plot_text(out, label);
    output_print(out, "\nset format %c '%%g'\n", name);
    if (axis->log)
        output_print(out, "set logscale %c\n", name);
    if (axis->low == axis->high) {
        write_range(out, name, celled, low, high);
    } else {
        char ends[2][32] = {"*", "*"};
        if (!isnan(axis->low))
            snprintf(ends[0], sizeof ends[0], "%.9g", low = axis->low);
        if (!isnan(axis->high))
            snprintf(ends[1], sizeof ends[1], "%.9g", high = axis->high);
        output_print(out, "set %crange [%s:%s]\n", name, ends[0], ends[1]);
    }
    if (axis->tic_count)
        write_tics(out, name, axis);
    else if (axis->log)
        write_decade_tics(out, name, low, high);
}

/* Objects lie behind the data. */
static void write_stripes(struct output *out, const struct chart_pane *p)
{
    for (int n = 0; n < p->stripes.count; n++) {
        const double *side = p->stripes.item[n].at->y_side;
        const bool log = p->axis[1].log;
        if (isnan(side[0]) || isnan(side[1]) || (log && side[1] <= 0))
            continue;
        if (side[0] == side[1]) {
            output_print(out,
                         "set arrow from graph 0, first %.9g to graph 1, first %.9g nohead "
                         "lw 1.5 dt (6,4) lc rgb '#808080' back\n",
                         side[0], side[1]);
            continue;
        }
        output_print(out, "set object rectangle from graph 0, ");
        output_print(out, log && side[0] <= 0 ? "graph 0" : "first %.9g", side[0]);
        output_print(out, " to graph 1, first %.9g fc rgb '%s' fs solid noborder behind\n",
                     side[1], chart_look_band);
    }
}

static void write_marks(struct output *out, const struct chart_pane *p)
{
    for (int n = 0; n < p->marks.count; n++) {
        const struct chart_item *mark = &p->marks.item[n];
        if (!is_drawn(p->axis, mark->at))
            continue;
        output_print(out, "set label ");
        plot_text(out, mark->as.label);
        output_print(out,
                     " at first %.9g, first %.9g center offset 0,0.8 font ',9' front\n",
                     mark->at->x, mark->at->y);
    }
}

static void write_series(struct output *out, const struct chart_pane *p, int pane, int n)
{
    const struct chart_item *item = &p->series.item[n];
    const enum chart_style style = item->as.style;

    if (!drawn_of(p, item))
        return;
    if (item->barred && !item->celled && style != CHART_BAND)
        output_print(
            out,
            "$p%d_%d using 1:2:3:4 with yerrorbars pt 0 lw 1 lc rgb '%s' notitle, \\\n",
            pane, n, chart_look_rgb(item));
    output_print(out, "$p%d_%d using %s", pane, n,
                 item->celled          ? "1:2:3:4:5:6"
                 : style == CHART_BAND ? "1:3:4"
                                       : "1:2");
    chart_look_write(out, item, false);
    output_print(out, " notitle, \\\n");
}

static void write_pane(struct output *out, const struct chart_pane *p, int pane)
{
    output_print(out, "unset object\nunset arrow\nunset label\nunset logscale\n"
                      "set autoscale\nset xtics autofreq\nset ytics autofreq\n"
                      "set tics out nomirror\nset grid xtics ytics lt 1 lw 0.8 lc rgb "
                      "'#d8d8d8'\nunset key\n"
                      "set title ");
    plot_text(out, p->title ? p->title : "");
    output_print(out, "\n");
    write_axis(out, p, 0);
    write_axis(out, p, 1);
    write_stripes(out, p);
    write_marks(out, p);
    output_print(out, "plot \\\n");
    for (int n = 0; n < p->series.count; n++)
        write_series(out, p, pane, n);
    output_print(out, "NaN notitle\n");
}

/* --- the page ------------------------------------------------------------------------- */

/* Words in lines of at most `most` characters, torn at blanks: gnuplot tears none. */
static int wrap(const char *text, int most, char *wrapped, int size)
{
    int lines = 1, column = 0;
    char *blank = NULL;

    snprintf(wrapped, (size_t)size, "%s", text);
    for (char *at = wrapped; *at; at++) {
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

/* How a chart is laid out on its page, in points. */
struct layout {
    int columns, rows, width, height, pane_height, foot;
    char title[1024];
    struct chart_legend legend;
};

static struct layout layout_of(const struct chart *c)
{
    static const int columns_of[] = {1, 1, 2, 3, 2, 3, 3, 3, 4, 3};
    const int panes = c->pane_count;
    struct layout y = {.pane_height = panes == 1 ? HIGH : LOW};

    y.columns = c->columns ? c->columns : panes < 10 ? columns_of[panes] : 4;
    y.rows = (panes + y.columns - 1) / y.columns;
    y.width = y.columns == 1 ? WIDE : NARROW * y.columns;
    y.legend = chart_look_legend(c, y.width);
    y.foot = y.legend.rows ? LINE * y.legend.rows + 16 : 0;
    const int lines =
        c->title ? wrap(c->title, y.width / CHART_CHARACTER, y.title, sizeof y.title) : 0;
    y.height = 8 + LINE * lines + y.rows * y.pane_height + y.foot;
    return y;
}

static void write_page(struct output *out, const struct chart *c, const struct layout *y)
{
    output_print(out, "set multiplot title ");
    plot_text(out, y->title);
    output_print(out, "\n");
    for (int p = 0; p < c->pane_count; p++) {
        const int up = y->rows - 1 - p / y->columns;
        output_print(out, "set size %.6g,%.6g\nset origin %.6g,%.6g\n", 1. / y->columns,
                     (double)y->pane_height / y->height,
                     (double)(p % y->columns) / y->columns,
                     (y->foot + (double)y->pane_height * up) / y->height);
        write_pane(out, &c->pane[p], p);
    }
    if (y->legend.count) {
        output_print(out, "set size 1,%.6g\nset origin 0,0\n", (double)y->foot / y->height);
        chart_look_write_legend(out, &y->legend);
    }
}

static void write_script(struct output *out, const struct chart *c, const char *name)
{
    const struct layout y = layout_of(c);

    for (int p = 0; p < c->pane_count; p++)
        for (int n = 0; n < c->pane[p].series.count; n++)
            if (drawn_of(&c->pane[p], &c->pane[p].series.item[n]))
                write_block(out, &c->pane[p], p, n);
    for (int kind = 0; kind < PLOT_KINDS; kind++) {
        plot_page(out, name, (enum plot_kind)kind, y.width, y.height);
        write_page(out, c, &y);
    }
}

/* Whether eyes must follow it: not classes, nor those that repeat a label or have none. */
static bool is_line(const struct chart_list *series, int n)
{
    const struct chart_series *as = &series->item[n].as;

    if (!as->label || as->rgb || as->style == CHART_SQUARES || as->style == CHART_CELLS)
        return false;
    for (int k = 0; k < n; k++)
        if (series->item[k].as.label && !strcmp(series->item[k].as.label, as->label))
            return false;
    return true;
}

static int lines_of(const struct chart_pane *p)
{
    int count = 0;

    for (int n = 0; n < p->series.count; n++)
        count += is_line(&p->series, n);
    return count;
}

enum status chart_write(const struct chart *c, const char *folder, const char *name,
                        struct message *why)
{
    struct output *out = NULL;
    enum status st;

    if (!c || c->failed)
        return STATUS_MEMORY;
    for (int n = 0; n < c->pane_count; n++)
        if (lines_of(&c->pane[n]) > CHART_LINES_MOST)
            return status_fail(why, STATUS_UNSUPPORTED,
                               "no plot: a panel of %s has %d lines, and eyes follow %d",
                               name, lines_of(&c->pane[n]), CHART_LINES_MOST);
    TRY(plot_begin(folder, name, &out, why));
    write_script(out, c, name);
    TRY(plot_end(folder, name, &out, why));
out:
    output_discard(out);
    return st;
}

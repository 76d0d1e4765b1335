/* chart.c - collects a chart, and turns it into a script of gnuplot: numbers in data
 * blocks, then the panels and the legend, each at its place on the page. */
#include "bench/ui/chart.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/ui/plot.h"

struct chart_place {
    double x, y, x_side[2], y_side[2]; /* sides are NaN for those that have none       */
};

struct chart_item {
    struct chart_series as; /* label and rgb                                     owned */
    int look;               /* from 0                                                  */
    bool band;              /* of chart_band                                           */
    bool barred, celled;    /* its points have sides in y; in x and y                  */
    int count;
    struct chart_place *at; /* [count]                                           owned */
};

struct chart_list {
    int count;
    struct chart_item *item; /* [count]                                          owned */
};

struct chart_pane {
    char *title;               /*                                                  owned */
    struct chart_axis axis[2]; /* x, y; with all they point to                   owned */
    struct chart_list series;
    struct chart_list stripes, marks; /* of one place each; a stripe's has sides in y  */
};

struct chart {
    char *title; /*                                                              owned */
    int pane_count, look_count;
    struct chart_pane *pane; /*                                                  owned */
    bool failed;             /* out of memory somewhere                                */
};

/* Appends a zero element to an array of `count`, returns it; NULL without memory. */
static void *one_more(struct chart *c, void *array, int *count, size_t size)
{
    char **at = array;
    const size_t n = (size_t)*count;

    if (!c || c->failed)
        return NULL;
    if ((n & (n - 1)) == 0) { /* empty or full */
        char *grown = realloc(*at, (n ? 2 * n : 1) * size);
        c->failed = !grown;
        if (!grown)
            return NULL;
        *at = grown;
    }
    (*count)++;
    return memset(*at + n * size, 0, size);
}

/* Copies into one line: a line end in a name must not tear a legend. NULL stays NULL. */
static char *copy(struct chart *c, const char *text)
{
    char *own = text ? strdup(text) : NULL;

    if (text && !own)
        c->failed = true;
    for (char *at = own; at && *at; at++)
        *at = iscntrl((unsigned char)*at) ? ' ' : *at;
    return own;
}

static struct chart_pane *pane_of(struct chart *c)
{
    return c && !c->failed ? &c->pane[c->pane_count - 1] : NULL;
}

struct chart *chart_create(const char *title)
{
    struct chart *c = calloc(1, sizeof *c);

    if (!c)
        return NULL;
    c->title = copy(c, title);
    one_more(c, &c->pane, &c->pane_count, sizeof *c->pane);
    return c;
}

static void clear_axis(struct chart_axis *axis)
{
    for (int n = 0; axis->tics && n < axis->tic_count; n++)
        free((char *)axis->tics[n].text);
    free((struct chart_tic *)axis->tics);
    free((char *)axis->name);
    free((char *)axis->unit);
}

static void clear_list(struct chart_list *list)
{
    for (int n = 0; n < list->count; n++) {
        free((char *)list->item[n].as.label);
        free((char *)list->item[n].as.rgb);
        free(list->item[n].at);
    }
    free(list->item);
}

static void clear_pane(struct chart_pane *p)
{
    clear_list(&p->series);
    clear_list(&p->stripes);
    clear_list(&p->marks);
    clear_axis(&p->axis[0]);
    clear_axis(&p->axis[1]);
    free(p->title);
}

void chart_destroy(struct chart *c)
{
    if (!c)
        return;
    for (int n = 0; n < c->pane_count; n++)
        clear_pane(&c->pane[n]);
    free(c->pane);
    free(c->title);
    free(c);
}

static void copy_axis(struct chart *c, struct chart_axis *to, const struct chart_axis *from)
{
    struct chart_tic *tics = calloc((size_t)from->tic_count + 1, sizeof *tics);
    struct chart_axis own = *from;

    for (int n = 0; tics && n < from->tic_count; n++)
        tics[n] = (struct chart_tic){from->tics[n].at, copy(c, from->tics[n].text)};
    own.name = copy(c, from->name);
    own.unit = copy(c, from->unit);
    own.tics = tics;
    c->failed = c->failed || !tics;
    clear_axis(to);
    *to = own;
}

void chart_axes(struct chart *c, const struct chart_axis *x, const struct chart_axis *y)
{
    struct chart_pane *p = pane_of(c);

    if (!p)
        return;
    copy_axis(c, &p->axis[0], x);
    copy_axis(c, &p->axis[1], y);
}

void chart_panel(struct chart *c, const char *title)
{
    struct chart_pane *p = pane_of(c);

    if (!p)
        return;
    if (p->title || p->series.count) {
        p = one_more(c, &c->pane, &c->pane_count, sizeof *p);
        if (!p)
            return;
        copy_axis(c, &p->axis[0], &p[-1].axis[0]);
        copy_axis(c, &p->axis[1], &p[-1].axis[1]);
    }
    p->title = copy(c, title ? title : "");
}

struct chart_axis chart_axis_of(const struct table *t, const char *key, bool log)
{
    const struct table_column *column = t ? table_column(t, table_find(t, key)) : NULL;

    return column ? (struct chart_axis){column->header, column->unit, .log = log}
                  : (struct chart_axis){.log = log};
}

/* Returns the first series with this label, of this panel or one before; NULL: none. */
static const struct chart_item *namesake(const struct chart *c, const char *label)
{
    for (int p = 0; label && p < c->pane_count; p++) {
        const struct chart_list *list = &c->pane[p].series;
        for (int n = 0; n < list->count; n++)
            if (list->item[n].as.label && !strcmp(list->item[n].as.label, label))
                return &list->item[n];
    }
    return NULL;
}

/* Appends an item to a list of the panel and returns it, NULL without memory. */
static struct chart_item *add_item(struct chart *c, struct chart_list *list,
                                   const struct chart_series *as)
{
    struct chart_item *item = one_more(c, &list->item, &list->count, sizeof *item);

    if (item) {
        item->as = *as;
        item->as.label = copy(c, as->label);
        item->as.rgb = copy(c, as->rgb);
    }
    return item;
}

void chart_series(struct chart *c, const struct chart_series *series)
{
    struct chart_pane *p = pane_of(c);
    struct chart_item *item = p ? add_item(c, &p->series, series) : NULL;
    const struct chart_item *same = item ? namesake(c, item->as.label) : NULL;

    if (item)
        item->look = series->colour         ? series->colour - 1
                     : same && same != item ? same->look
                                            : c->look_count++;
}

static void add(struct chart *c, struct chart_list *list, struct chart_place place)
{
    assert(list->count > 0);
    struct chart_item *item = &list->item[list->count - 1];
    struct chart_place *at = one_more(c, &item->at, &item->count, sizeof *at);

    if (!at)
        return;
    *at = place;
    item->barred = item->barred || !isnan(place.y_side[0]);
    item->celled = item->celled || !isnan(place.x_side[0]);
}

static void add_point(struct chart *c, struct chart_place place)
{
    struct chart_pane *p = pane_of(c);

    if (p)
        add(c, &p->series, place);
}

void chart_point(struct chart *c, double x, double y)
{
    add_point(c, (struct chart_place){x, y, {NAN, NAN}, {NAN, NAN}});
}

void chart_bar(struct chart *c, double x, double y, double low, double high)
{
    add_point(c, (struct chart_place){x, y, {NAN, NAN}, {low, high}});
}

void chart_cell(struct chart *c, double x, double y, const double x_side[2],
                const double y_side[2])
{
    add_point(c,
              (struct chart_place){x, y, {x_side[0], x_side[1]}, {y_side[0], y_side[1]}});
}

static bool meets(const struct table *t, int row, const struct chart_where *where)
{
    const int column = table_find(t, where->key);

    return where->text ? !strcmp(table_words(t, row, column), where->text)
                       : table_value(t, row, column) == where->number;
}

void chart_rows(struct chart *c, const struct table *t, const char *x, const char *y,
                int count, const struct chart_where *where)
{
    if (!t) {
        if (c)
            c->failed = true;
        return;
    }
    const int of_x = table_find(t, x), of_y = table_find(t, y);
    for (int row = 0; row < table_rows(t); row++) {
        bool wanted = true;
        for (int n = 0; n < count; n++)
            wanted = wanted && meets(t, row, &where[n]);
        if (wanted)
            chart_point(c, table_shown(t, row, of_x), table_shown(t, row, of_y));
    }
}

void chart_band(struct chart *c, const char *label, double low, double high)
{
    struct chart_pane *p = pane_of(c);
    struct chart_item *item =
        p ? add_item(c, &p->stripes, &(struct chart_series){label}) : NULL;

    if (!item)
        return;
    item->band = true;
    add(c, &p->stripes, (struct chart_place){.y_side = {low, high}});
}

void chart_mark(struct chart *c, double x, double y, const char *text)
{
    struct chart_pane *p = pane_of(c);

    if (p && add_item(c, &p->marks, &(struct chart_series){text}))
        add(c, &p->marks, (struct chart_place){x, y});
}

/* --- looks: colours, points and dashes ---------------------------------------------------
 */

/* Looks that all eyes can distinguish (Okabe and Ito), in grey by points and dashes. */
static const struct look {
    const char *rgb;
    int filled, open; /* points */
    const char *dash;
} looks[] = {{"#0072b2", 7, 6, "solid"},    {"#d55e00", 5, 4, "(14,5)"},
             {"#009e73", 9, 8, "(4,4)"},    {"#cc79a7", 13, 12, "(14,4,3,4)"},
             {"#000000", 11, 10, "(22,5)"}, {"#e69f00", 15, 14, "(8,8)"},
             {"#56b4e9", 3, 2, "(3,8)"},    {"#7f7f7f", 1, 1, "(14,4,3,4,3,4)"}};
enum { LOOKS = sizeof looks / sizeof *looks };

static const char band_rgb[] = "#c8c8c8";

/* Whether an item is dashed with open points, as those beyond the number of looks are. */
static bool is_second(const struct chart_item *item)
{
    return item->as.second || item->look / LOOKS % 2;
}

static const char *rgb_of(const struct chart_item *item)
{
    return item->as.rgb ? item->as.rgb : looks[item->look % LOOKS].rgb;
}

static void write_look(struct output *out, const struct chart_item *item, bool legend)
{
    const struct look *look = &looks[item->look % LOOKS];
    const bool second = is_second(item);
    const int type = second ? look->open : look->filled;
    const char *rgb = rgb_of(item);

    switch (item->as.style) {
    case CHART_LINESPOINTS:
        output_print(out, " with linespoints lw 1.6 dt %s pt %d ps scale*1.1",
                     second ? "(10,6)" : "solid", type);
        break;
    case CHART_LINE:
        output_print(out, " with lines lw 1.8 dt %s", second ? "(3,3)" : look->dash);
        break;
    case CHART_POINTS:
        output_print(out, " with points pt %d ps scale*1.2", type);
        break;
    case CHART_SQUARES:
        output_print(out, " with points pt 5 ps scale*1.6");
        break;
    case CHART_BAND:
    case CHART_CELLS:
    case CHART_HATCHED_CELLS:
        if (legend && item->as.style == CHART_HATCHED_CELLS)
            output_print(out, " with boxes fs transparent pattern 5");
        else if (legend)
            output_print(out, " with points pt 5 ps scale*2");
        else if (item->as.style == CHART_BAND)
            output_print(out, " with filledcurves fs transparent solid 0.3 noborder");
        else if (item->as.style == CHART_HATCHED_CELLS)
            output_print(out, " with boxxyerror fs transparent pattern 5 noborder");
        else
            output_print(out, " with boxxyerror fs solid 1 border lc rgb '%s'", rgb);
    }
    output_print(out, " lc rgb ");
    plot_text(out, rgb);
}

/* --- the legend ----------------------------------------------------------------------- */

/* The legend below the panels, which has each label once. */
enum { CHART_ENTRIES = 64, CHART_CHARACTER = 8 /* its width in points */ };
struct chart_legend {
    int count, columns, rows;
    const struct chart_item *entry[CHART_ENTRIES];
};
enum { KEY = 70 }; /* points for the picture of a line or point, and the room around */

static bool has_entry(const struct chart_legend *l, const char *label)
{
    for (int n = 0; n < l->count; n++)
        if (!strcmp(l->entry[n]->as.label, label))
            return true;
    return false;
}

static void add_entries(struct chart_legend *l, const struct chart_list *list)
{
    for (int n = 0; n < list->count && l->count < CHART_ENTRIES; n++)
        if (list->item[n].as.label && !has_entry(l, list->item[n].as.label))
            l->entry[l->count++] = &list->item[n];
}

static struct chart_legend legend_of(const struct chart *c, int width)
{
    struct chart_legend l = {0};
    int widest = 1;

    for (int p = 0; p < c->pane_count; p++) {
        add_entries(&l, &c->pane[p].series);
        add_entries(&l, &c->pane[p].stripes);
    }
    for (int n = 0; n < l.count; n++)
        if (table_width(l.entry[n]->as.label) > widest)
            widest = table_width(l.entry[n]->as.label);
    l.columns = (width - 40) / (KEY + CHART_CHARACTER * widest);
    if (l.columns < 1)
        l.columns = 1;
    l.rows = (l.count + l.columns - 1) / l.columns;
    if (l.rows) /* as even as possible */
        l.columns = (l.count + l.rows - 1) / l.rows;
    return l;
}

static void write_legend(struct output *out, const struct chart_legend *l)
{
    output_print(out,
                 "unset object\nunset arrow\nunset label\nunset logscale\nunset border\n"
                 "unset tics\nunset grid\nunset title\nunset xlabel\nunset ylabel\n"
                 "set lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
                 "set key center center horizontal maxcols %d Left reverse samplen 3\n"
                 "plot [0:1][0:1] \\\n",
                 l->columns);
    for (int n = 0; n < l->count; n++) {
        const struct chart_item *item = l->entry[n];
        output_print(out, "NaN");
        if (!item->band)
            write_look(out, item, true);
        else if (item->at->y_side[0] == item->at->y_side[1])
            output_print(out, " with lines lw 1.5 dt (6,4) lc rgb '#808080'");
        else
            output_print(out, " with points pt 5 ps scale*2 lc rgb '%s'", band_rgb);
        output_print(out, " title ");
        plot_text(out, item->as.label);
        output_print(out, ", \\\n");
    }
    output_print(out, "NaN notitle\n");
}

/* Sizes in points of a screen: one panel alone, one of several, lines of text. */
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

/* Finds the least and greatest value on an axis; returns whether cells, which fill their
 * panel, are among the data. */
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

/* Writes tics at 1, 2 and 5 of each decade where the axis has fewer than two decades:
 * gnuplot numbers decades only. */
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

/* Sets the range where the data have none of their own, which gnuplot insists on, and that
 * of cells, to which gnuplot would add room. */
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

/* Writes the stripes as objects, which lie behind the data. */
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
                     side[1], band_rgb);
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
            pane, n, rgb_of(item));
    output_print(out, "$p%d_%d using %s", pane, n,
                 item->celled          ? "1:2:3:4:5:6"
                 : style == CHART_BAND ? "1:3:4"
                                       : "1:2");
    write_look(out, item, false);
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

/* Wraps words to lines of at most `most` characters, at blanks: gnuplot does not. */
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

/* The layout of a chart on its page, in points. */
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

    y.columns = panes < 10 ? columns_of[panes] : 4;
    y.rows = (panes + y.columns - 1) / y.columns;
    y.width = y.columns == 1 ? WIDE : NARROW * y.columns;
    y.legend = legend_of(c, y.width);
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
        write_legend(out, &y->legend);
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

/* Whether the reader must follow the series as a line of its own: classes do not count, nor
 * series that repeat a label or have none. */
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

enum status chart_save(struct chart *c, const char *folder, const char *name,
                       struct message *why)
{
    struct message plot = {""};
    enum status st = chart_write(c, folder, name, &plot);

    chart_destroy(c);
    return plot_tell(st, folder, name, ".png, .svg and .pdf", &plot, why);
}

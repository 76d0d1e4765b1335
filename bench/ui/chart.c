/* chart.c - what a chart collects; chart_script.c says how it looks. */
#include "bench/ui/chart_parts.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/ui/plot.h"

/* The place for one more element behind `count` of them, all zero; NULL without memory. */
static void *one_more(struct chart *c, void *array, int *count, size_t size)
{
    char **at = array;
    const size_t n = (size_t)*count;

    if (!c || c->failed)
        return NULL;
    if ((n & (n - 1)) == 0) { /* none, or as many as there is room for */
        char *grown = realloc(*at, (n ? 2 * n : 1) * size);
        c->failed = !grown;
        if (!grown)
            return NULL;
        *at = grown;
    }
    (*count)++;
    return memset(*at + n * size, 0, size);
}

/* A copy in one line: a line end in a name must not tear a legend. NULL stays NULL. */
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

void chart_columns(struct chart *c, int columns)
{
    if (c)
        c->columns = columns;
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

/* The first series with this label, of this panel or one before; NULL: none. */
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

/* One more in a list of the panel, NULL without memory. */
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

enum status chart_save(struct chart *c, const char *folder, const char *name,
                       struct message *why)
{
    struct message plot = {""};
    enum status st = chart_write(c, folder, name, &plot);

    chart_destroy(c);
    return plot_tell(st, folder, name, ".png, .svg and .pdf", &plot, why);
}

#include "bench/sweep/sweep_map.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/ui/plot.h"
#include "bench/harness/derived_key.h"
#include "bench/sweep/sweep_map_plot.h"

/* One direction of the map, or the panels. */
struct dimension {
    const char *name;             /* NULL: none                                        */
    int key, measure;             /* of the plan or of cases; -1: not that             */
    const struct plan_axis *axis; /* NULL: values from the cases, or a measure         */
    bool words;                   /* of the axis; drawn at 0, 1, ...                   */
    bool log;
};

struct sweep_map {
    const struct plan *plan;
    char folder[SWEEP_FOLDER_PATH];
    struct output *data;
    struct dimension x, y, panel;
    struct sweep_map_names panels, classes;
    bool seen[SWEEP_MAP_NAMES][SWEEP_MAP_NAMES];   /* [panel][class]                   */
    bool marked[SWEEP_MAP_NAMES][SWEEP_MAP_NAMES]; /* [panel][label of a mark]         */
};

static struct dimension find_dimension(const struct plan *plan, const char *name)
{
    struct dimension d = {.name = name, .key = -1, .measure = -1};

    for (int k = 0; name && k < plan->key_count; k++)
        if (!strcmp(plan->keys[k], name))
            d.key = k;
    for (int n = 0; name && n < MEASURES; n++)
        if (!strcmp(measure_name(n), name))
            d.measure = n;
    for (int n = 0; name && n < plan->axis_count; n++)
        if (!strcmp(plan->axes[n].key, name))
            d.axis = &plan->axes[n];
    for (int n = 0; d.axis && n < d.axis->values.count; n++) {
        char *end;
        strtod(d.axis->values.list[n].value, &end);
        d.words |= *end != '\0';
    }
    d.log = d.axis ? d.axis->scale == PLAN_AXIS_LOG && !d.words
                   : d.key < 0 && name && derived_key_is(name);
    return d;
}

/* Where a value of an axis is drawn. */
static double place_of(const struct dimension *d, int n)
{
    return d->words ? n : strtod(d->axis->values.list[n].value, NULL);
}

/* Half way from a to b. */
static double between(const struct dimension *d, double a, double b)
{
    return d->log ? sqrt(a * b) : (a + b) / 2;
}

/* The cell around a place of an axis: half way to the nearest other places; as far to the
 * other side at the ends. */
static void find_cell(const struct dimension *d, double at, double *low, double *high)
{
    double below = -INFINITY, above = INFINITY;

    for (int n = 0; n < d->axis->values.count; n++) {
        const double other = place_of(d, n);
        if (other < at)
            below = fmax(below, other);
        if (other > at)
            above = fmin(above, other);
    }
    *low = isfinite(below) ? between(d, below, at) : NAN;
    *high = isfinite(above) ? between(d, at, above) : NAN;
    if (isnan(*low) && isnan(*high)) /* the only value */
        *low = d->log ? at / 2 : at - 0.5, *high = d->log ? at * 2 : at + 0.5;
    else if (isnan(*low))
        *low = d->log ? at * at / *high : 2 * at - *high;
    else if (isnan(*high))
        *high = d->log ? at * at / *low : 2 * at - *low;
}

/* Where the case is drawn; NaN: nowhere. */
static double find_place(const struct dimension *d, const struct plan_case *c,
                         const struct sweep_row *row)
{
    if (d->key < 0)
        return row->ran ? row->result.value[d->measure] : NAN;
    if (!c->given[d->key])
        return NAN;
    for (int n = 0; d->words && n < d->axis->values.count; n++)
        if (&d->axis->values.list[n] == c->given[d->key])
            return n;
    return strtod(c->given[d->key]->value, NULL);
}

static void panel_text(const struct dimension *d, const struct plan_case *c,
                       const struct sweep_row *row, char *text, int size)
{
    if (!d->name)
        snprintf(text, (size_t)size, "%s", "");
    else if (!strcmp(d->name, "name"))
        snprintf(text, (size_t)size, "%s", c->name ? c->name : "-");
    else if (d->key >= 0)
        snprintf(text, (size_t)size, "%s",
                 c->given[d->key] ? c->given[d->key]->value : "-");
    else
        snprintf(text, (size_t)size, "%.4g",
                 row->ran ? row->result.value[d->measure] : NAN);
}

enum status sweep_map_open(struct sweep_map **map, const struct plan *plan,
                           const struct sweep_folder *folder, const char *best,
                           struct message *why)
{
    enum status st = STATUS_OK;
    char path[SWEEP_FOLDER_PATH + 16];
    struct sweep_map *m;

    *map = NULL;
    if (!plan->map.x)
        return STATUS_OK;
    m = calloc(1, sizeof *m);
    if (!m)
        return STATUS_MEMORY;
    m->plan = plan;
    m->x = find_dimension(plan, plan->map.x);
    m->y = find_dimension(plan, plan->map.y);
    m->panel = find_dimension(plan, plan->map.panel);
    snprintf(m->folder, sizeof m->folder, "%s", folder->path);
    sweep_map_names_add(&m->classes, best);
    m->classes.uses[0] = 0;
    snprintf(path, sizeof path, "%s/map.dat", folder->path);
    TRY(output_create(path, &m->data, why));
    output_print(m->data, "# panel label x y x_low x_high y_low y_high\n");
    *map = m, m = NULL;
out:
    sweep_map_discard(m);
    return st;
}

void sweep_map_row(struct sweep_map *m, const struct plan_case *c,
                   const struct sweep_row *row, const char *labels)
{
    char panel[64];
    double x, y, cell[4];

    if (!m)
        return;
    x = find_place(&m->x, c, row);
    y = find_place(&m->y, c, row);
    if (!isfinite(x) || !isfinite(y))
        return;
    panel_text(&m->panel, c, row, panel, sizeof panel);
    for (int n = 0; n < 4; n++)
        cell[n] = n < 2 ? x : y;
    if (m->x.axis && m->y.axis) {
        find_cell(&m->x, x, &cell[0], &cell[1]);
        find_cell(&m->y, y, &cell[2], &cell[3]);
    }
    const int p = sweep_map_names_add(&m->panels, panel);
    const int class = sweep_map_names_add(&m->classes, labels);
    m->seen[p][class] = true;
    output_print(m->data, "%d %d %.9g %.9g %.9g %.9g %.9g %.9g\n", p, class, x, y, cell[0],
                 cell[1], cell[2], cell[3]);
}

/* Where a mark lies in a direction. */
static double mark_place(const struct dimension *d, const struct plan_mark *mark,
                         const struct scene *scene)
{
    const struct plan_setting *s = plan_settings_find(&mark->settings, d->name);

    if (derived_key_is(d->name))
        return derived_key_number(d->name, scene);
    return s ? strtod(s->value, NULL) : NAN;
}

/* The number of the panel that a mark belongs to; -1: it is on all of them. */
static int mark_panel(const struct sweep_map *m, const struct plan_mark *mark)
{
    const struct plan_setting *s =
        m->panel.name ? plan_settings_find(&mark->settings, m->panel.name) : NULL;

    for (int n = 0; s && n < m->panels.count; n++)
        if (!strcmp(m->panels.name[n], s->value))
            return n;
    return -1;
}

/* marks.dat: panel, label, x, y, text; `labels` in order of their numbers. */
static enum status write_marks(struct sweep_map *m, struct sweep_map_names *labels,
                               struct message *why)
{
    enum status st;
    char path[SWEEP_FOLDER_PATH + 16];
    struct output *out = NULL;
    struct scene scene = {0};

    snprintf(path, sizeof path, "%s/marks.dat", m->folder);
    TRY(output_create(path, &out, why));
    for (int n = 0; n < m->plan->map.mark_count; n++) {
        const struct plan_mark *mark = &m->plan->map.marks[n];

        TRY(plan_case_mark(m->plan, &mark->settings, &scene, why));
        const int panel = mark_panel(m, mark);
        const int label = sweep_map_names_add(labels, mark->label);
        for (int p = 0; p < m->panels.count; p++)
            m->marked[p][label] |= panel < 0 || panel == p;
        output_print(out, "%d %d %.9g %.9g \"%s\"\n", panel, label,
                     mark_place(&m->x, mark, &scene), mark_place(&m->y, mark, &scene),
                     mark->text);
        scene_clear(&scene);
    }
    struct output *whole = out;
    out = NULL;
    TRY(output_close(whole, why));
out:
    output_discard(out);
    return st;
}

/* Names at the places of an axis of words. */
static void write_tics(const struct dimension *d, char *text, int size)
{
    int used = snprintf(text, (size_t)size, "(");

    for (int n = 0; n < d->axis->values.count && used < size; n++)
        used += snprintf(text + used, (size_t)(size - used), "%s'%s' %d", n ? ", " : "",
                         d->axis->values.list[n].value, n);
    if (used < size)
        snprintf(text + used, (size_t)(size - used), ")");
}

static struct sweep_map_side side_of(const struct dimension *d)
{
    struct sweep_map_side side = {.name = d->name, .log = d->log};

    if (d->words)
        write_tics(d, side.tics, sizeof side.tics);
    return side;
}

enum status sweep_map_close(struct sweep_map *m, struct message *why)
{
    enum status st = STATUS_OK;
    struct sweep_map_names marks = {0};
    struct output *data;

    if (!m)
        return STATUS_OK;
    data = m->data, m->data = NULL;
    TRY(output_close(data, why));
    TRY(write_marks(m, &marks, why));
    TRY(sweep_map_plot(m->folder,
                       &(struct sweep_map_plot){.title = m->plan->name,
                                                .x = side_of(&m->x),
                                                .y = side_of(&m->y),
                                                .panel = m->panel.name,
                                                .cells = m->x.axis && m->y.axis,
                                                .seen = m->seen,
                                                .marked = m->marked,
                                                .panels = &m->panels,
                                                .classes = &m->classes,
                                                .marks = &marks},
                       why));
    TRY(plot_run(m->folder, "map.gp", why));
out:
    sweep_map_discard(m);
    return st;
}

void sweep_map_discard(struct sweep_map *m)
{
    if (m)
        output_discard(m->data);
    free(m);
}

#include "bench/sweep/sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/derived_key.h"

/* A direction of the map, or its panels. */
struct dimension {
    const char *name;             /* NULL: none                                         */
    int key, measure;             /* of the plan, of rows; -1: it is none               */
    const struct plan_axis *axis; /* NULL: values from the cases, or a measure          */
    bool words;                   /* the axis has words, which are drawn at 0, 1, ...   */
    bool log;
};

/* Names in the order in which they came; those beyond the room are "other". */
enum { NAMES = 24, TICS = 10 };
struct names {
    int count;
    long uses[NAMES]; /* times that each came                                           */
    char *name[NAMES];
};

/* The place of a case on the map. */
struct spot {
    int panel, label;
    double x, y;
};

struct map {
    const struct plan *plan;
    struct dimension x, y, panel;
    struct names panels, labels;
    long count;
    struct spot *spot; /* [count], with room for all cases                        owned */
};

/* Returns the number of a name, a new one for a new name; -1: no memory. */
static int add_name(struct names *names, const char *name)
{
    int n = 0;

    while (n < names->count && strcmp(names->name[n], name))
        n++;
    if (n == NAMES)
        n = NAMES - 1;
    if (n == names->count) {
        names->name[n] = strdup(n == NAMES - 1 ? "other" : name);
        if (!names->name[n])
            return -1;
        names->count++;
    }
    names->uses[n]++;
    return n;
}

static struct dimension find_dimension(const struct plan *plan, const char *name)
{
    struct dimension d = {
        .name = name, .key = -1, .measure = name ? measure_find(name) : -1};

    for (int k = 0; name && k < plan->key_count; k++)
        if (!strcmp(plan->keys[k], name))
            d.key = k;
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

/* Returns where value n of the axis is drawn. */
static double place_of(const struct dimension *d, int n)
{
    return d->words ? n : strtod(d->axis->values.list[n].value, NULL);
}

/* Returns the place half way from a to b; the mirror image of a at b. */
static double between(const struct dimension *d, double a, double b)
{
    return d->log ? sqrt(a * b) : (a + b) / 2;
}

static double beyond(const struct dimension *d, double a, double b)
{
    return d->log ? b * b / a : 2 * b - a;
}

/* Finds the cell around a place of an axis: half way to the nearest other places, at the
 * ends as far to the other side. */
static void find_cell(const struct dimension *d, double at, double side[2])
{
    double below = -INFINITY, above = INFINITY;

    for (int n = 0; n < d->axis->values.count; n++) {
        const double other = place_of(d, n);
        if (other < at)
            below = fmax(below, other);
        if (other > at)
            above = fmin(above, other);
    }
    const double low = between(d, below, at), high = between(d, at, above);
    const double alone[2] = {d->log ? at / 2 : at - 0.5, d->log ? at * 2 : at + 0.5};
    side[0] = isfinite(low) ? low : isfinite(high) ? beyond(d, high, at) : alone[0];
    side[1] = isfinite(high) ? high : isfinite(low) ? beyond(d, low, at) : alone[1];
}

/* Returns where the case is drawn; NaN: nowhere. */
static double find_place(const struct dimension *d, const struct plan_case *c,
                         const struct sweep_row *row)
{
    if (d->key < 0)
        return row->value[d->measure];
    if (!c->given[d->key])
        return NAN;
    for (int n = 0; d->words && n < d->axis->values.count; n++)
        if (&d->axis->values.list[n] == c->given[d->key])
            return n;
    return strtod(c->given[d->key]->value, NULL);
}

static int find_panel(struct map *m, const struct plan_case *c, const struct sweep_row *row)
{
    const struct dimension *d = &m->panel;
    char number[64];

    if (!d->name)
        return add_name(&m->panels, "");
    if (!strcmp(d->name, "name"))
        return add_name(&m->panels, c->name ? c->name : "-");
    if (d->key >= 0)
        return add_name(&m->panels, c->given[d->key] ? c->given[d->key]->value : "-");
    snprintf(number, sizeof number, "%.4g", row->value[d->measure]);
    return add_name(&m->panels, number);
}

static enum status add_spot(struct map *m, const struct sweep_row *row, long number)
{
    struct plan_case c = {0};
    enum status st;

    TRY(plan_case_given(m->plan, number, &c));
    struct spot spot = {.x = find_place(&m->x, &c, row), .y = find_place(&m->y, &c, row)};
    if (!isfinite(spot.x) || !isfinite(spot.y))
        goto out;
    spot.panel = find_panel(m, &c, row);
    spot.label = add_name(&m->labels, row->label);
    m->spot[m->count++] = spot;
    st = spot.panel < 0 || spot.label < 0 ? STATUS_MEMORY : STATUS_OK;
out:
    plan_case_clear(&c);
    return st;
}

/* Places all cases; the good ones come first in the legend, even if there are none. */
static enum status make(struct map *m, const struct sweep_rows *rows)
{
    const struct plan *plan = rows->plan;
    enum status st;

    *m = (struct map){.plan = plan,
                      .x = find_dimension(plan, plan->map.x),
                      .y = find_dimension(plan, plan->map.y),
                      .panel = find_dimension(plan, plan->map.panel)};
    m->spot = calloc((size_t)rows->count, sizeof *m->spot);
    TRY(m->spot && add_name(&m->labels, "feasible") == 0 ? STATUS_OK : STATUS_MEMORY);
    m->labels.uses[0] = 0;
    for (long n = 0; n < rows->count; n++)
        TRY(add_spot(m, &rows->row[n], n));
out:
    return st;
}

static void clear(struct map *m)
{
    for (int n = 0; n < NAMES; n++) {
        free(m->panels.name[n]);
        free(m->labels.name[n]);
    }
    free(m->spot);
}

static bool has_cells(const struct map *m)
{
    return m->x.axis && m->y.axis;
}

/* Returns green for the good, grey for those without a result; the others' colours are told
 * apart by eyes of all kinds. */
static const char *colour_of(const char *label, int n)
{
    static const struct {
        const char *label, *colour;
    } known[] = {
        {"feasible", "#8cd17d"},    {"degraded", "#edc948"},  {"died", "#444444"},
        {"unsupported", "#d9d9d9"}, {"no result", "#d9d9d9"}, {"run again", "#d9d9d9"},
    };
    static const char *const palette[] = {
        "#e15759", "#f28e2b", "#edc948", "#4e79a7", "#b07aa1", "#76b7b2", "#9c755f",
        "#ff9da7", "#a0cbe8", "#d37295", "#b6992d", "#d4a6c8", "#fabfd2", "#79706e",
    };
    enum { COLOURS = sizeof palette / sizeof *palette };

    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (!strcmp(label, known[k].label))
            return known[k].colour;
    return palette[(n + COLOURS - 1) % COLOURS];
}

/* Returns an axis as people call it, or by its key. The values of a plan are its tics where
 * there is room for them. */
static struct chart_axis axis_of(const struct dimension *d, struct chart_tic *tics)
{
    static const struct {
        const char *key;
        struct chart_axis axis;
    } known[] = {
        {"gamma", {"Gamma, weight against bending"}},
        {"young_over_density", {"E / rho", "m^2/s^2"}},
        {"material.young", {"Young's modulus", "Pa"}},
        {"material.poisson", {"Poisson's ratio"}},
        {"material.density", {"density", "kg/m^3"}},
        {"damping.value", {"damping"}},
        {"sheet.thickness", {"thickness", "m"}},
        {"time.step", {"time step", "s"}},
    };
    struct chart_axis axis = {.name = d->name};

    if (d->measure >= 0 && strcmp(measure_unit(d->measure), "1"))
        axis.unit = measure_unit(d->measure);
    for (size_t n = 0; n < sizeof known / sizeof *known; n++)
        if (!strcmp(d->name, known[n].key))
            axis = known[n].axis;
    axis.log = d->log;
    const int count = d->axis ? d->axis->values.count : 0;
    if (tics && (count <= TICS || d->words)) {
        for (int n = 0; n < count; n++)
            tics[n] = (struct chart_tic){place_of(d, n), d->axis->values.list[n].value};
        axis.tics = tics, axis.tic_count = count;
    }
    return axis;
}

/* Draws the spots of a panel with this label. */
static void draw_spots(const struct map *m, struct chart *c, int panel, int label)
{
    double x[2], y[2];

    for (const struct spot *s = m->spot; s < m->spot + m->count; s++) {
        if (s->panel != panel || s->label != label)
            continue;
        if (!has_cells(m)) {
            chart_point(c, s->x, s->y);
            continue;
        }
        find_cell(&m->x, s->x, x);
        find_cell(&m->y, s->y, y);
        chart_cell(c, s->x, s->y, x, y);
    }
}

/* Draws the labels of a panel in colours. */
static void draw_cases(const struct map *m, struct chart *c, int panel)
{
    const bool cells = has_cells(m);
    char text[256];

    for (int n = 0; n < m->labels.count; n++) {
        snprintf(text, sizeof text, "%s: %ld", m->labels.name[n], m->labels.uses[n]);
        chart_series(c, &(struct chart_series){.label = text,
                                               .style = cells ? CHART_CELLS : CHART_SQUARES,
                                               .rgb = colour_of(m->labels.name[n], n)});
        draw_spots(m, c, panel, n);
    }
}

/* Returns where a mark lies in a direction. */
static double mark_place(const struct dimension *d, const struct plan_mark *mark,
                         const struct scene *scene)
{
    const struct plan_setting *s = plan_settings_find(&mark->settings, d->name);

    if (derived_key_is(d->name))
        return derived_key_number(d->name, scene);
    return s ? strtod(s->value, NULL) : NAN;
}

/* Says if a mark belongs to a panel: to that of its value, or to all if none has it. */
static bool is_on(const struct map *m, const struct plan_mark *mark, int panel)
{
    const struct plan_setting *s =
        m->panel.name ? plan_settings_find(&mark->settings, m->panel.name) : NULL;

    for (int n = 0; s && n < m->panels.count; n++)
        if (!strcmp(m->panels.name[n], s->value))
            return n == panel;
    return true;
}

static enum status draw_marks(const struct map *m, struct chart *c, int panel,
                              struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < m->plan->map.mark_count; n++) {
        const struct plan_mark *mark = &m->plan->map.marks[n];
        struct scene scene;

        if (!is_on(m, mark, panel))
            continue;
        TRY(plan_case_mark(m->plan, &mark->settings, &scene, why));
        const double x = mark_place(&m->x, mark, &scene);
        const double y = mark_place(&m->y, mark, &scene);
        scene_clear(&scene);
        chart_series(c, &(struct chart_series){
                            .label = mark->label, .style = CHART_POINTS, .rgb = "#000000"});
        chart_point(c, x, y);
        chart_mark(c, x, y, mark->text);
    }
out:
    return st;
}

static void name_panel(const struct map *m, struct chart *c, int panel)
{
    char text[256];

    if (!m->panel.name)
        return;
    if (!strcmp(m->panel.name, "name"))
        snprintf(text, sizeof text, "%s", m->panels.name[panel]);
    else
        snprintf(text, sizeof text, "%s = %s", axis_of(&m->panel, NULL).name,
                 m->panels.name[panel]);
    chart_panel(c, text);
}

enum status sweep_map(const struct sweep_rows *rows, struct chart **chart,
                      struct message *why)
{
    struct chart_tic *tics = NULL;
    struct chart *c = NULL;
    struct map m = {0};
    enum status st = STATUS_OK;

    *chart = NULL;
    if (!rows->plan->map.x)
        return st;
    TRY(make(&m, rows));
    tics = calloc(2 * PLAN_AXIS_MOST, sizeof *tics);
    TRY(tics ? STATUS_OK : STATUS_MEMORY);
    const struct chart_axis x = axis_of(&m.x, tics),
                            y = axis_of(&m.y, tics + PLAN_AXIS_MOST);
    c = chart_create(m.plan->name);
    chart_axes(c, &x, &y);
    for (int panel = 0; panel < m.panels.count; panel++) {
        name_panel(&m, c, panel);
        draw_cases(&m, c, panel);
        TRY(draw_marks(&m, c, panel, why));
    }
    *chart = c, c = NULL;
out:
    chart_destroy(c);
    free(tics);
    clear(&m);
    return st;
}

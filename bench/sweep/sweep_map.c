#include "bench/sweep/sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/derived_key.h"

/* A direction of the map, or its panels. */
struct dimension {
    const char *name; /* NULL: none                                                      */
    int key, measure; /* of the plan, of rows; -1: it is none                            */
};

static struct dimension find_dimension(const struct plan *plan, const char *name)
{
    struct dimension d = {
        .name = name, .key = -1, .measure = name ? measure_find(name) : -1};

    for (int k = 0; name && k < plan->key_count; k++)
        if (!strcmp(plan->keys[k], name))
            d.key = k, d.measure = -1;
    return d;
}

/* Writes an axis as people call it, or by its key. */
static void write_title(const struct dimension *d, char title[64])
{
    static const char *const known[][2] = {
        {"gamma", "Gamma, weight against bending"},
        {"young_over_density", "E / rho [m^2/s^2]"},
        {"material.young", "Young's modulus [Pa]"},
        {"material.poisson", "Poisson's ratio"},
        {"material.density", "density [kg/m^3]"},
        {"damping.value", "damping"},
        {"sheet.thickness", "thickness [m]"},
        {"time.step", "time step [s]"},
    };
    const char *unit = d->measure >= 0 ? measure_unit(d->measure) : "1";
    const bool pure = !strcmp(unit, "1");

    snprintf(title, 64, "%s%s%s%s", d->name, pure ? "" : " [", pure ? "" : unit,
             pure ? "" : "]");
    for (size_t n = 0; n < sizeof known / sizeof *known; n++)
        if (!strcmp(d->name, known[n][0]))
            snprintf(title, 64, "%s", known[n][1]);
}

/* Returns what a case has for a key, or its label on an axis. */
static const char *word_of(const struct dimension *d, const struct plan_case *c,
                           const char *none)
{
    const char *label = plan_label(c->study, c->level, d->name);

    return d->key >= 0 ? (c->given[d->key] ? c->given[d->key]->value : none)
           : label     ? label
                       : none;
}

/* Adds the place of a case in a direction: words as the plan has them, or a measure. */
static void add_place(struct dataset *t, const struct dimension *d,
                      const struct plan_case *c, const struct sweep_row *row)
{
    if (d->measure >= 0)
        dataset_add(t, "%.6g", row->value[d->measure]);
    else
        dataset_text(t, "%s", word_of(d, c, ""));
}

static void add_panel(struct dataset *t, const struct dimension *d,
                      const struct plan_case *c, const struct sweep_row *row)
{
    char text[256] = "";

    if (d->name && d->measure >= 0)
        snprintf(text, sizeof text, "%s = %.4g", d->name, row->value[d->measure]);
    else if (d->name && d->key >= 0)
        snprintf(text, sizeof text, "%s = %s", d->name, word_of(d, c, "-"));
    else if (d->name)
        snprintf(text, sizeof text, "%s", word_of(d, c, "-"));
    dataset_text(t, "%s", text);
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

/* Adds a mark, to the panel of its value, or to all ("*") if it has none. */
static enum status add_mark(struct dataset *t, const struct plan *plan,
                            const struct plan_mark *mark, const struct dimension d[3],
                            struct message *why)
{
    const struct plan_setting *s =
        d[2].name ? plan_settings_find(&mark->settings, d[2].name) : NULL;
    struct scene scene;
    enum status st;

    TRY(plan_case_mark(plan, &mark->settings, &scene, why));
    dataset_row(t);
    dataset_text(t, s ? "%s = %s" : "*", s ? d[2].name : "", s ? s->value : "");
    dataset_text(t, "%s", mark->label);
    for (int k = 0; k < 2; k++)
        dataset_add(t, "%.6g", mark_place(&d[k], mark, &scene));
    dataset_text(t, "%s", mark->text);
    scene_clear(&scene);
out:
    return st;
}

enum status sweep_map(const struct sweep_rows *rows, const struct printer *p,
                      struct message *why)
{
    const struct plan *plan = rows->plan;
    struct dataset *t = NULL;
    char title[2][64];
    enum status st = STATUS_OK;

    if (!plan->map.x)
        return st;
    const struct dimension d[3] = {find_dimension(plan, plan->map.x),
                                   find_dimension(plan, plan->map.y),
                                   find_dimension(plan, plan->map.panel)};
    for (int k = 0; k < 2; k++)
        write_title(&d[k], title[k]);
    const struct dataset_column columns[] = {
        {"panel"}, {"label"}, {"x", .key = title[0]}, {"y", .key = title[1]}, {"mark"}};
    t = DATASET_OF(columns, NULL);
    for (long n = 0; n < rows->count; n++) {
        struct plan_case c = {0};
        TRY(plan_case_given(plan, n, &c));
        dataset_row(t);
        add_panel(t, &d[2], &c, &rows->row[n]);
        dataset_text(t, "%s", rows->row[n].label);
        add_place(t, &d[0], &c, &rows->row[n]);
        add_place(t, &d[1], &c, &rows->row[n]);
        plan_case_clear(&c);
    }
    for (int n = 0; n < plan->map.mark_count; n++)
        TRY(add_mark(t, plan, &plan->map.marks[n], d, why));
    st = printer_save(p, t, "map", why);
out:
    dataset_destroy(t);
    return st;
}

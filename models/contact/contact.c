#include "models/contact/contact_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/vector.h"

bool contact_wanted(const struct scene *scene)
{
    return scene->obstacle_count > 0 || scene->contact.self;
}

bool contact_rubs(const struct contact *c)
{
    bool any = c->scene->contact.friction > 0;

    for (int o = 0; o < c->scene->obstacle_count; o++)
        any |= c->scene->obstacles[o].friction > 0;
    return any;
}

void contact_clear(struct contact *c)
{
    contact_rim_clear(&c->rim);
    contact_search_clear(&c->search);
    contact_surface_clear(&c->surface);
    free(c->pose);
    free(c->pose_old);
    free(c->x_old);
    free(c->area);
    free(c->spare);
    free(c->near);
    free(c->pressed);
    free(c->touch);
    free(c->node);
    free(c->weight);
    memset(c, 0, sizeof *c);
}

enum status contact_init(struct contact *c, const struct scene *scene,
                         struct contact_surface *surface)
{
    const size_t bodies = (size_t)scene->obstacle_count;
    *c = (struct contact){.scene = scene,
                          .surface = *surface,
                          .body = contact_law_body(scene),
                          .self = contact_law_self(scene),
                          .pose = calloc(bodies + 1, sizeof *c->pose),
                          .pose_old = calloc(bodies + 1, sizeof *c->pose_old),
                          .x_old = calloc(3 * (size_t)surface->nodes, sizeof *c->x_old),
                          .area = calloc((size_t)surface->nodes, sizeof *c->area),
                          .spare = calloc(4 * (size_t)surface->count, sizeof *c->spare),
                          .near = calloc((size_t)surface->count, sizeof *c->near),
                          .pressed = calloc((size_t)surface->nodes, sizeof *c->pressed)};
    const struct contact_surface *s = &c->surface;
    *surface = (struct contact_surface){0};
    const bool all =
        c->pose && c->pose_old && c->x_old && c->area && c->spare && c->near && c->pressed;
    enum status st = all ? STATUS_OK : STATUS_MEMORY;
    for (int n = 0; all && n < s->count; n++)
        for (int k = n * s->width; k < n * s->width + s->used[n]; k++)
            c->area[s->node[k]] += s->shape[k] * s->area[n];
    if (st == STATUS_OK && scene->contact.self)
        st = contact_search_init(&c->search, &c->surface, c->self.start);
    if (st == STATUS_OK && scene->contact.self)
        st = contact_rim_init(&c->rim, &c->search);
    if (st != STATUS_OK)
        contact_clear(c);
    return st;
}

void contact_begin(struct contact *c, double t, double dt, const double *x_old)
{
    const double end = isfinite(dt) ? t + dt : t;

    c->dt = dt, c->rests = false;
    c->finds = 0, c->error = 0;
    memcpy(c->x_old, x_old, 3 * (size_t)c->surface.nodes * sizeof *c->x_old);
    for (int o = 0; o < c->scene->obstacle_count; o++) {
        scene_motion_at(&c->scene->obstacles[o].motion, t, &c->pose_old[o]);
        scene_motion_at(&c->scene->obstacles[o].motion, end, &c->pose[o]);
    }
}

void contact_begin_rest(struct contact *c, double t, double dt, const double *x_old)
{
    contact_begin(c, t, dt, x_old);
    c->rests = true;
}

/* Computes the forces of a touch at x. */
static void press(struct contact *c, struct contact_touch *t, const double *x)
{
    const struct contact_law *law = contact_touch_law(c, t);
    const double mu = contact_touch_friction(c, t);
    double way[3], slip[3];

    if (!isfinite(c->dt)) {
        t->push = t->area * contact_law_pressure(law, t->D, &t->stiffness);
        t->stiffness *= t->area;
        return;
    }
    contact_touch_way(c, t, x, way);
    const double along = contact_touch_split(way, t->normal, slip);
    const double D_old = contact_touch_before(c, t, along);
    t->push = t->area * contact_law_push(law, t->D, D_old, c->rests ? INFINITY : c->dt,
                                         &t->stiffness);
    t->stiffness *= t->area;
    if (mu == 0)
        return;
    const double size = vector_length(slip);
    const double share = contact_law_friction(law, size, c->dt);
    const double stick = 2 * mu * t->push / (law->creep * c->dt);
    t->drag = size > 0 ? mu * t->push * share / size : stick;
    t->grip = stick * fmax(0, 1 - size / (law->creep * c->dt));
    for (int i = 0; i < 3; i++)
        t->rub[i] = -t->drag * slip[i];
}

/* Returns the distance of y from a body: exact where contact has started, or where it is
 * less than the least so far, else some number from there up to it. */
static double body_distance(const struct contact *c, int obstacle, const double y[3],
                            double normal[3])
{
    return contact_shape_near(&c->scene->obstacles[obstacle], &c->pose[obstacle], y,
                              c->body.start + fmax(c->least, 0), normal);
}

enum status contact_find(struct contact *c, const double *x)
{
    enum status st = c->failed;

    c->failed = STATUS_OK;
    c->finds++;
    contact_touch_none(c);
    TRY(st);
    for (int n = 0; n < c->surface.count; n++) {
        double y[3], normal[3];
        contact_surface_at(&c->surface, n, x, y);
        for (int o = 0; o < c->scene->obstacle_count; o++) {
            double D = body_distance(c, o, y, normal);
            if (isnan(D))
                return STATUS_NAN;
            if (!contact_touch_still(
                    &c->scene->obstacles[o])) /* changes stop before still ones */
                D = contact_touch_met(c, n, o, y, D, normal);
            if (D - c->body.start < c->least)
                c->least = D - c->body.start;
            if (D < c->body.start)
                TRY(contact_touch_body(c, n, o, D, normal));
        }
    }
    TRY(contact_touch_own(c, x));
    for (int n = 0; n < c->count; n++) {
        press(c, &c->touch[n], x);
        contact_touch_total(c, &c->touch[n]);
    }
out:
    return st;
}

void contact_force(const struct contact *c, double *force)
{
    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++)
        for (int k = t->first; k < t->first + t->count; k++)
            for (int i = 0; i < 3; i++)
                force[3 * (size_t)c->node[k] + i] +=
                    c->weight[k] * (t->push * t->normal[i] + t->rub[i]);
}

/* Computes by how much the velocity of a touch is to change: to the mean one along the
 * normal, if it opens faster, and across, if it sticks. */
static void land(const struct contact *c, const struct contact_touch *t, const double *x,
                 const double *v, double by[3])
{
    double more[3] = {0}, across[3];

    for (int k = t->first; k < t->first + t->count; k++)
        for (int i = 0; i < 3; i++) {
            size_t u = 3 * (size_t)c->node[k] + i;
            more[i] += c->weight[k] * ((x[u] - c->x_old[u]) / c->dt - v[u]);
        }
    const double along = fmin(0, contact_touch_split(more, t->normal, across));
    for (int i = 0; i < 3; i++)
        by[i] = along * t->normal[i] + (t->grip > 0 ? across[i] : 0);
}

void contact_landing(const struct contact *c, const double *x, const double *v,
                     double *change)
{
    memset(change, 0, 3 * (size_t)c->surface.nodes * sizeof *change);
    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++) {
        const double area = t->obstacle < 0 ? t->area / 2 : t->area; /* both sides move */
        double by[3];
        if (!(t->push > 0))
            continue;
        land(c, t, x, v, by);
        for (int k = t->first; k < t->first + t->count; k++)
            for (int i = 0; i < 3; i++)
                change[3 * (size_t)c->node[k] + i] +=
                    c->weight[k] * area / c->area[c->node[k]] * by[i];
    }
}

void contact_report(const struct contact *c, struct model_contact *report)
{
    *report = (struct model_contact){.least_gap = c->least, .energy = c->energy};
    for (int n = 0; n < c->count; n++)
        report->nodes += c->touch[n].push > 0;
    memcpy(report->force, c->force, sizeof report->force);
}

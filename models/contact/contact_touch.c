#include "models/contact/contact_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/vector.h"

/* Makes room for one more touch of so many weights. */
static enum status make_room(struct contact *c, int weights)
{
    if (c->count == c->room) {
        const int room = 2 * c->room + 64;
        struct contact_touch *touch = realloc(c->touch, (size_t)room * sizeof *touch);
        if (!touch)
            return STATUS_MEMORY;
        c->touch = touch, c->room = room;
    }
    if (c->weights + weights > c->weight_room) {
        const int room = 2 * c->weight_room + weights + 64;
        int *node = realloc(c->node, (size_t)room * sizeof *node);
        c->node = node ? node : c->node;
        double *weight = realloc(c->weight, (size_t)room * sizeof *weight);
        c->weight = weight ? weight : c->weight;
        if (!node || !weight)
            return STATUS_MEMORY;
        c->weight_room = room;
    }
    return STATUS_OK;
}

void contact_touch_none(struct contact *c)
{
    c->count = c->weights = 0;
    c->energy = 0;
    c->least = INFINITY;
    memset(c->force, 0, sizeof c->force);
}

/* Appends the nodes and weights of a place, or of a foot, with the sign -1. */
static void append(struct contact *c, int count, const int *node, const double *weight,
                   double sign)
{
    for (int k = 0; k < count; k++, c->weights++) {
        c->node[c->weights] = node[k];
        c->weight[c->weights] = sign * weight[k];
    }
}

/* Appends a touch of a sample that is filled but for its weights, with the foot's. */
static enum status add(struct contact *c, struct contact_touch touch, int count,
                       const int *node, const double *weight)
{
    const struct contact_surface *s = &c->surface;
    const size_t row = (size_t)touch.sample * s->width;

    touch.first = c->weights;
    touch.count = s->used[touch.sample] + count;
    const enum status st = make_room(c, touch.count);
    if (st != STATUS_OK)
        return st;
    append(c, s->used[touch.sample], s->node + row, s->shape + row, 1);
    append(c, count, node, weight, -1);
    c->touch[c->count++] = touch;
    return STATUS_OK;
}

enum status contact_touch_body(struct contact *c, int sample, int obstacle, double D,
                               const double n[3])
{
    const struct contact_touch touch = {.sample = sample,
                                        .obstacle = obstacle,
                                        .D = D,
                                        .normal = {n[0], n[1], n[2]},
                                        .area = c->surface.area[sample]};

    return add(c, touch, 0, NULL, NULL);
}

/* Appends a touch of a rim's point with another rim. */
static enum status add_rim(void *context, const struct contact_rim_foot *foot)
{
    struct contact *c = context;
    const double *n = foot->normal;
    const int count = foot->of_point + foot->of_foot;
    const enum status st = make_room(c, count);

    if (st != STATUS_OK)
        return st;
    c->touch[c->count++] = (struct contact_touch){.sample = -1,
                                                  .obstacle = -1,
                                                  .first = c->weights,
                                                  .count = count,
                                                  .D = foot->distance,
                                                  .normal = {n[0], n[1], n[2]},
                                                  .area = foot->area / 2};
    append(c, count, foot->node, foot->weight, 1);
    return STATUS_OK;
}

enum status contact_touch_own(struct contact *c, const double *x)
{
    const struct contact_search *s = &c->search;
    enum status st = STATUS_OK;

    if (!c->scene->contact.self)
        return STATUS_OK;
    TRY(contact_search_find(&c->search, x));
    for (const struct contact_foot *f = s->foot; f < s->foot + s->count; f++) {
        const struct contact_touch touch = {
            .sample = f->sample,
            .obstacle = -1,
            .D = f->distance,
            .normal = {f->normal[0], f->normal[1], f->normal[2]},
            .at = {f->u, f->v},
            .area = f->strength * c->surface.area[f->sample] / 2};
        TRY(add(c, touch, f->count, s->node + f->first, s->weight + f->first));
    }
    TRY(contact_rim_find(&c->rim, add_rim, c));
out:
    return st;
}

bool contact_touch_still(const struct scene_obstacle *o)
{
    return !SCENE_MOVES(o->motion);
}

void contact_touch_way(const struct contact *c, const struct contact_touch *t,
                       const double *x, double way[3])
{
    way[0] = way[1] = way[2] = 0;
    for (int k = t->first; k < t->first + t->count; k++)
        for (int i = 0; i < 3; i++) {
            size_t u = 3 * (size_t)c->node[k] + i;
            way[i] += c->weight[k] * (x[u] - c->x_old[u]);
        }
    if (t->obstacle >= 0 && !contact_touch_still(&c->scene->obstacles[t->obstacle])) {
        double y[3], before[3];
        contact_surface_at(&c->surface, t->sample, x, y);
        contact_shape_carry(&c->pose[t->obstacle], &c->pose_old[t->obstacle], y, before);
        for (int i = 0; i < 3; i++)
            way[i] -= y[i] - before[i];
    }
}

const struct contact_law *contact_touch_law(const struct contact *c,
                                            const struct contact_touch *t)
{
    return t->obstacle < 0 ? &c->self : &c->body;
}

double contact_touch_friction(const struct contact *c, const struct contact_touch *t)
{
    return t->obstacle < 0 ? c->scene->contact.friction
                           : c->scene->obstacles[t->obstacle].friction;
}

double contact_touch_split(const double way[3], const double n[3], double slip[3])
{
    const double along = vector_dot(way, n);

    for (int i = 0; i < 3; i++)
        slip[i] = way[i] - along * n[i];
    return along;
}

double contact_touch_before(const struct contact *c, const struct contact_touch *t,
                            double along)
{
    double y[3];

    if (t->obstacle < 0)
        return t->D - along;
    contact_surface_at(&c->surface, t->sample, c->x_old, y);
    return contact_shape_distance(&c->scene->obstacles[t->obstacle],
                                  &c->pose_old[t->obstacle], y, NULL);
}

void contact_touch_total(struct contact *c, const struct contact_touch *t)
{
    const struct contact_law *law = contact_touch_law(c, t);

    c->least = fmin(c->least, t->D - law->start);
    c->energy += t->area * contact_law_potential(law, t->D);
    for (int i = 0; t->obstacle >= 0 && i < 3; i++)
        c->force[i] += t->push * t->normal[i] + t->rub[i];
}

double contact_touch_met(const struct contact *c, int sample, int obstacle,
                         const double y[3], double D, double normal[3])
{
    enum { TRIES = 60 };
    const struct scene_obstacle *o = &c->scene->obstacles[obstacle];
    const struct scene_placement *pose = &c->pose[obstacle];
    const double reached = 1e-3 * c->body.range;
    double old[3], from[3], at[3], way[3], far[3], entry[3], passed = 0;

    if (!isfinite(c->dt))
        return D;
    contact_surface_at(&c->surface, sample, c->x_old, old);
    contact_shape_carry(&c->pose_old[obstacle], pose, old, from);
    vector_between(from, y, way);
    const double length = vector_length(way);
    if (!(D <= length))
        return D;
    double left = contact_shape_distance(o, pose, from, entry);
    if (!(left > 0) || left + contact_shape_distance(o, pose, y, far) > length)
        return D;
    for (int n = 0; n < TRIES && left > reached && passed < length; n++) {
        passed += left;
        for (int i = 0; i < 3; i++)
            at[i] = from[i] + way[i] * passed / length;
        left = contact_shape_distance(o, pose, at, entry);
    }
    if (passed <= 0 || passed > length || left > reached || vector_dot(entry, far) >= 0)
        return D;
    memcpy(normal, entry, sizeof entry);
    return fmin(0, (y[0] - at[0]) * entry[0] + (y[1] - at[1]) * entry[1] +
                       (y[2] - at[2]) * entry[2]);
}

#include "models/contact/contact_outside.h"

#include <math.h>
#include <string.h>

#include "models/bodies/body_shape.h"
#include "models/vector.h"

/* Most sweeps; a sample that is this deep, in lengths of the sheet, is so by rounding. */
enum { SWEEPS = 50 };
static const double ROUNDING = 1e-12;

/* One body in a step. */
struct meeting {
    const struct scene_obstacle *body;
    struct scene_placement pose, pose_old;
    const int *held;
    double *x;
    const struct contact_outside_rate *rate;
};

void contact_outside_clear(struct contact_outside *o)
{
    for (int f = 0; f < CONTACT_OUTSIDE_FACES; f++)
        contact_surface_clear(&o->face[f]);
    memset(o, 0, sizeof *o);
}

/* Returns the weight of the column that the k-th node of a row begins, and in *next the
 * node behind it. */
static double column(const struct contact_outside *o, const int *node, const double *shape,
                     int used, int k, int *next)
{
    const int first = node[k] - node[k] % o->layers;
    double weight = 0;

    for (; k < used && node[k] < first + o->layers && node[k] >= first; k++)
        weight += o->first_only && node[k] != first ? 0 : shape[k];
    *next = k;
    return weight;
}

/* Moves the columns of a sample of y[nodes][3] by `way` n in all, as far as they are free;
 * returns the longest way of a component. */
static double lead(const struct contact_outside *o, const struct contact_surface *s,
                   int sample, const int *held, double way, const double n[3], double *y)
{
    const int *node = s->node + (size_t)sample * s->width, used = s->used[sample];
    const double *shape = s->shape + (size_t)sample * s->width;
    const int moving = 3 * (o->first_only ? 1 : o->layers);
    double squares = 0, most = 0;

    for (int k = 0; k < used;) {
        const double weight = column(o, node, shape, used, k, &k);
        squares += weight * weight;
    }
    for (int k = 0; k < used;) {
        const size_t first = 3 * (size_t)(node[k] - node[k] % o->layers);
        const double weight = column(o, node, shape, used, k, &k);
        for (int i = 0; i < moving; i++) {
            const double part = weight / squares * way * n[i % 3];
            if (held[first + i] < 0)
                continue;
            y[first + i] += part;
            most = fmax(most, fabs(part));
        }
    }
    return most;
}

/* Puts a sample on the body if it is inside. Returns how deep it was, 0 if it was not, and
 * in *moved how far it has moved. */
static double put(const struct contact_outside *o, const struct meeting *m,
                  const struct contact_surface *s, int sample, double *moved)
{
    double y[3], before[3], n[3], r[3];

    contact_surface_at(s, sample, m->x, y);
    const double D = body_shape_near(m->body, &m->pose, y, 0, n);
    *moved = 0;
    if (!(D < 0))
        return 0;
    for (int i = 0; i < 3; i++)
        y[i] -= D * n[i]; /* where it comes to lie */
    body_shape_carry(&m->pose, &m->pose_old, y, before);
    const double drift = vector_dot(y, n) - vector_dot(before, n);
    *moved = lead(o, s, sample, m->held, -D, n, m->x);
    for (int k = 0; k < CONTACT_OUTSIDE_RATES; k++) {
        contact_surface_at(s, sample, m->rate[k].of, r);
        const double into = vector_dot(r, n) - m->rate[k].way * drift;
        if (into < 0)
            lead(o, s, sample, m->held, -into, n, m->rate[k].of);
    }
    return -D;
}

/* Puts all samples on a body once; returns how far the one that moved most has moved. */
static double sweep(struct contact_outside *o, const struct meeting *m, int *count,
                    struct counters *counters)
{
    double most = 0, moved;

    for (int f = 0; f < CONTACT_OUTSIDE_FACES; f++)
        for (int n = 0; n < o->face[f].count; n++) {
            const double depth = put(o, m, &o->face[f], n, &moved);
            o->depth = fmax(o->depth, depth);
            *count += depth > 0;
            most = fmax(most, moved);
        }
    for (int f = 0; f < CONTACT_OUTSIDE_FACES; f++)
        counters->tested += o->face[f].count;
    return most;
}

void contact_outside_put(struct contact_outside *o, const struct scene *scene, double t,
                         double dt, const int *held, double *x,
                         const struct contact_outside_rate rate[CONTACT_OUTSIDE_RATES],
                         struct counters *counters)
{
    struct meeting m = {.held = held, .x = x, .rate = rate};
    double most = INFINITY;

    for (int n = 0; n < SWEEPS && most > ROUNDING * scene->length; n++) {
        int count = 0;
        most = o->depth = 0;
        for (int b = 0; b < scene->obstacle_count; b++) {
            m.body = &scene->obstacles[b];
            scene_motion_at(&m.body->motion, t, &m.pose_old);
            scene_motion_at(&m.body->motion, t + dt, &m.pose);
            most = fmax(most, sweep(o, &m, &count, counters));
        }
        if (n == 0)
            o->put = count;
    }
}

void contact_outside_report(const struct contact_outside *o, struct model_contact *report)
{
    *report = (struct model_contact){.nodes = o->put,
                                     .least_gap = o->put ? -o->depth : INFINITY,
                                     .force = {NAN, NAN, NAN}};
}

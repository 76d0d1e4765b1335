#include "models/mechanics/contact_system.h"

#include <string.h>

#include "models/vector.h"

/* Adds the turning of the normal of a body where a touch moves at x. */
static void add_turning(const struct contact *c, const struct contact_touch *t,
                        const double *x, double B[9])
{
    const double reach = 1e-4 * c->body.start; /* for the normal's derivatives */
    double y[3], n[2][3];

    if (t->obstacle < 0)
        return;
    contact_surface_at(&c->surface, t->sample, x, y);
    for (int j = 0; j < 3; j++) {
        for (int side = 0; side < 2; side++) {
            double z[3] = {y[0], y[1], y[2]};
            z[j] += side ? reach : -reach;
            contact_shape_distance(&c->scene->obstacles[t->obstacle], &c->pose[t->obstacle],
                                   z, n[side]);
        }
        for (int i = 0; i < 3; i++)
            B[3 * i + j] -= t->push * (n[1][i] - n[0][i]) / (2 * reach);
    }
}

/* Computes the stiffness of a touch's relative motion; x NULL: without turning. */
static void stiffness(const struct contact *c, const struct contact_touch *t,
                      const double *x, double B[9])
{
    const double rub = vector_dot(t->rub, t->rub);

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double along = rub > 0 ? t->rub[i] * t->rub[j] / rub : 0;
            B[3 * i + j] = (t->stiffness - t->drag) * t->normal[i] * t->normal[j] +
                           (t->grip - t->drag) * along + t->drag * (i == j);
        }
    if (x)
        add_turning(c, t, x, B);
}

static bool same_nodes(const struct contact *c, const struct contact_touch *s,
                       const struct contact_touch *t)
{
    return s->count == t->count && !memcmp(c->node + s->first, c->node + t->first,
                                           (size_t)s->count * sizeof *c->node);
}

/* Touches of one element have the same nodes; so many at most are added at once. */
enum { TOGETHER = 16 };

/* Adds touches with the same nodes; false if the graph lacks a pair. */
static bool add_together(const struct contact *c, const struct contact_touch *touch,
                         int count, const double *x, const struct blocks *graph,
                         double (*K)[9])
{
    const int *node = c->node + touch->first;
    double B[TOGETHER][9];

    for (int n = 0; n < count; n++)
        stiffness(c, &touch[n], x, B[n]);
    for (int a = 0; a < touch->count; a++)
        for (int b = 0; b < touch->count; b++) {
            if (node[b] < node[a])
                continue;
            const long pair = blocks_find(graph, node[a], node[b]);
            if (pair < 0)
                return false;
            for (int n = 0; n < count; n++) {
                const double *weight = c->weight + touch[n].first;
                const double w = weight[a] * weight[b];
                for (int k = 0; k < 9; k++)
                    K[pair][k] += w * B[n][k];
            }
        }
    return true;
}

static bool add(const struct contact *c, const double *x, const struct blocks *graph,
                double (*K)[9])
{
    const struct contact_touch *end = c->touch + c->count;

    for (const struct contact_touch *t = c->touch, *next; t < end; t = next) {
        for (next = t + 1; next < end && next < t + TOGETHER && same_nodes(c, t, next);)
            next++;
        if (!add_together(c, t, (int)(next - t), x, graph, K))
            return false;
    }
    return true;
}

bool contact_system_tangent(const struct contact *c, const struct blocks *graph,
                            double (*K)[9])
{
    return add(c, NULL, graph, K);
}

bool contact_system_turned(const struct contact *c, const double *x,
                           const struct blocks *graph, double (*K)[9])
{
    return add(c, x, graph, K);
}

#include "models/mechanics/contact_system.h"

#include <math.h>
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

/* The error below which friction has its tangent: in the slip, or that from which friction
 * is whole. */
static const double CLOSE = 0.1;

/* The calls of contact_find in a step whose error nobody tells after which friction has the
 * stiffness that ends the slip. */
enum { CAREFUL = 9 };

/* Tells whether x is near enough to the solution for friction's tangent. */
static bool is_close(const struct contact *c, double slip)
{
    return c->error > 0 ? c->error <= CLOSE * fmax(slip, c->body.creep * c->dt)
                        : c->finds <= CAREFUL;
}

/* Computes the stiffness of a touch's relative motion; x NULL: without turning. */
static void stiffness(const struct contact *c, const struct contact_touch *t,
                      const double *x, double B[9])
{
    const double rub = vector_dot(t->rub, t->rub);
    const double slip = rub > 0 ? sqrt(rub) / t->drag : 0;
    const double grip = is_close(c, slip) ? t->grip : t->drag;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double along = rub > 0 ? t->rub[i] * t->rub[j] / rub : 0;
            B[3 * i + j] = (t->stiffness - t->drag) * t->normal[i] * t->normal[j] +
                           (grip - t->drag) * along + t->drag * (i == j);
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

void contact_system_land(struct contact *c, const struct blocks *graph, const double *M,
                         const int *held, const double *x, double *v, double *work)
{
    const size_t count = 3 * (size_t)graph->nodes;
    double *change = work, *y = work + count, along = 0, square = 0;

    if (!c->count)
        return;
    contact_landing(c, x, v, change);
    for (size_t k = 0; k < count; k++)
        change[k] = held[k] < 0 ? 0 : change[k];
    blocks_multiply_mass(graph, M, change, y);
    for (size_t k = 0; k < count; k++)
        along -= y[k] * v[k], square += y[k] * change[k];
    const double share = square > 0 ? fmax(0, fmin(1, along / square)) : 0;
    for (size_t k = 0; k < count; k++) {
        v[k] += share * change[k];
        c->force[k % 3] += share * y[k] / c->dt;
    }
}

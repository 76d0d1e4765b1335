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

/* How a tangent is made. */
struct manner {
    const double *x; /* for the turning of normals; NULL: without                       */
    double error;    /* of x                                                     [m]   */
};

/* Computes the stiffness of a touch's relative motion. */
static void stiffness(const struct contact *c, const struct contact_touch *t,
                      const struct manner *how, double B[9])
{
    const double rub = vector_dot(t->rub, t->rub);
    const double slip = rub > 0 ? sqrt(rub) / t->drag : 0;
    const bool close = how->error <= CLOSE * fmax(slip, c->body.creep * c->dt);
    const double grip = close ? t->grip : t->drag;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double along = rub > 0 ? t->rub[i] * t->rub[j] / rub : 0;
            B[3 * i + j] = (t->stiffness - t->drag) * t->normal[i] * t->normal[j] +
                           (grip - t->drag) * along + t->drag * (i == j);
        }
    if (how->x)
        add_turning(c, t, how->x, B);
}

static bool same_nodes(const struct contact *c, const struct contact_touch *s,
                       const struct contact_touch *t)
{
    return s->count == t->count && !memcmp(c->node + s->first, c->node + t->first,
                                           (size_t)s->count * sizeof *c->node);
}

static void add(const struct contact *c, const struct manner *how,
                const struct blocks *graph, double (*K)[9])
{
    const struct contact_touch *end = c->touch + c->count;

    /* touches of one element have the same nodes, which are looked up once */
    for (const struct contact_touch *t = c->touch, *next; t < end; t = next) {
        for (next = t + 1; next < end && same_nodes(c, t, next);)
            next++;
        for (int a = 0; a < t->count; a++)
            for (int b = 0; b < t->count; b++) {
                const int row = c->node[t->first + a], column = c->node[t->first + b];
                if (column < row)
                    continue;
                double *block = K[blocks_find(graph, row, column)];
                for (const struct contact_touch *s = t; s < next; s++) {
                    double B[9], w = c->weight[s->first + a] * c->weight[s->first + b];
                    stiffness(c, s, how, B);
                    for (int k = 0; k < 9; k++)
                        block[k] += w * B[k];
                }
            }
    }
}

void contact_system_tangent(const struct contact *c, double error,
                            const struct blocks *graph, double (*K)[9])
{
    add(c, &(struct manner){.error = c->rests ? 0 : error}, graph, K);
}

void contact_system_turned(const struct contact *c, const double *x,
                           const struct blocks *graph, double (*K)[9])
{
    add(c, &(struct manner){.x = x}, graph, K);
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

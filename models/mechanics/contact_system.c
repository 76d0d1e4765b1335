#include "models/mechanics/contact_system.h"

#include <math.h>
#include <string.h>

#include "models/vector.h"

/* The most nodes of a row. */
enum { MOST_NODES = 64 };

static bool meets_smooth(const struct contact *c, const struct contact_touch *t)
{
    return t->obstacle < 0 && t->sample >= 0 && c->surface.row &&
           c->surface.width <= MOST_NODES && t->D > 0;
}

/* Adds the turning of the normal of a body where a touch moves at x. */
static void add_turning(const struct contact *c, const struct contact_touch *t,
                        const double *x, double B[9])
{
    const double reach = 1e-4 * c->body.start; /* for the normal's derivatives */
    double y[3], n[2][3];

    for (int k = 0; k < 9 && meets_smooth(c, t); k++)
        B[k] -= t->push / t->D * ((k % 4 == 0) - t->normal[k / 3] * t->normal[k % 3]);
    if (t->obstacle < 0 || t->sample < 0) /* a feature's place slides with its normal */
        return;
    contact_surface_at(&c->surface, t->sample, x, y);
    for (int j = 0; j < 3; j++) {
        for (int side = 0; side < 2; side++) {
            double z[3] = {y[0], y[1], y[2]};
            z[j] += side ? reach : -reach;
            body_shape_distance(&c->scene->obstacles[t->obstacle], &c->pose[t->obstacle], z,
                                n[side]);
        }
        for (int i = 0; i < 3; i++)
            B[3 * i + j] -= t->push * (n[1][i] - n[0][i]) / (2 * reach);
    }
}

/* A sheet around one of its places: its bend, and the slopes of the weights of its nodes.
 */
struct around {
    struct contact_bend bend;
    double slope[2][MOST_NODES];
    bool free[2]; /* the place is not as far along u, or v, as the sheet goes on          */
};

/* Adds a row of the surface, `times`, to the slopes of the weights that are among
 * node[count]. */
static void add_row(const struct contact_surface *s, const struct contact_ends *e, double u,
                    double v, int count, const int *node, double times, double *slope)
{
    double shape[MOST_NODES];
    int own[MOST_NODES];
    const int used = contact_surface_row(s, e, u, v, own, shape);

    for (int k = 0; k < used; k++)
        for (int n = 0; n < count; n++)
            if (node[n] == own[k])
                slope[n] += times * shape[k];
}

static void look_around(const struct contact_surface *s, const double at[2],
                        const double *x, int count, const int *node, struct around *a)
{
    const struct contact_ends e = contact_surface_ends(s, at[0]);

    double shape[MOST_NODES];
    int own[MOST_NODES];

    memset(a, 0, sizeof *a);
    contact_surface_bend(s, &e, x, at[0], at[1], own, shape, &a->bend);
    for (int k = 0; k < 4; k++) {
        const int d = k / 2, sign = k % 2 ? 1 : -1;
        const double by = sign * e.step[d];
        add_row(s, &e, a->bend.u + (d ? 0 : by), a->bend.v + (d ? by : 0), count, node,
                1 / (2 * by), a->slope[d]);
        a->free[d] = at[d] > e.least[d] && at[d] < e.most[d];
    }
}

/* Inverts F_a F_b - w F_ab, w the way from the foot; of what is not free nothing. */
static void invert_slip(const struct around *a, const double w[3], double inverse[2][2])
{
    double A[3];

    contact_bend_rounds(&a->bend, w, A);
    if (!a->free[0] || !a->free[1])
        A[1] = 0;
    const double det = A[0] * A[2] - A[1] * A[1];
    inverse[0][0] = a->free[0] ? A[2] / det : 0;
    inverse[1][1] = a->free[1] ? A[0] / det : 0;
    inverse[0][1] = inverse[1][0] = -A[1] / det;
}

/* Adds to K what the slip of the foot takes from the second derivative of D, that of a
 * distance to a place that stays being in B. With the way w = D n between sample and foot,
 * the weights W of its nodes and the surface's slopes F_a, the foot is where w F_a = 0; its
 * change by A^-1 h, h_a = F_a W + w dF_a, A_ab = F_a F_b - w F_ab, takes h A^-1 h / D.
 * Returns false if the graph lacks a pair. */
static bool add_slip(const struct contact *c, const struct contact_touch *t,
                     const double *x, const struct blocks *graph, double (*K)[9])
{
    const int *node = c->node + t->first, used = c->surface.used[t->sample];
    const double *weight = c->weight + t->first;
    double w[3], inverse[2][2], h[2][2 * MOST_NODES][3];
    struct around around;

    look_around(&c->surface, t->at, x, t->count - used, node + used, &around);
    for (int i = 0; i < 3; i++)
        w[i] = t->D * t->normal[i];
    invert_slip(&around, w, inverse);
    for (int d = 0; d < 2; d++)
        for (int k = 0; k < t->count; k++)
            for (int i = 0; i < 3; i++)
                h[d][k][i] = weight[k] * around.bend.d[d][i] +
                             (k < used ? 0 : w[i] * around.slope[d][k - used]);
    for (int k = 0; k < 4 * t->count * t->count; k++) {
        const int d = k % 2, e = k / 2 % 2, a = k / 4 / t->count, b = k / 4 % t->count;
        const long pair = node[b] < node[a] ? -1 : blocks_find(graph, node[a], node[b]);
        if (pair < 0 && node[b] >= node[a])
            return false;
        for (int i = 0; i < 9 && pair >= 0; i++)
            K[pair][i] += t->push / t->D * inverse[d][e] * h[d][a][i / 3] * h[e][b][i % 3];
    }
    return true;
}

/* Computes the stiffness of a touch's relative motion; x NULL: without turning. */
static void stiffness(const struct contact *c, const struct contact_touch *t,
                      const double *x, double B[9])
{
    contact_grip(t, B);
    for (int k = 0; k < 9; k++)
        B[k] += t->stiffness * t->normal[k / 3] * t->normal[k % 3];
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

bool contact_system_tangent(const struct contact *c, const double *x,
                            const struct blocks *graph, double (*K)[9])
{
    const struct contact_touch *end = c->touch + c->count;

    for (const struct contact_touch *t = c->touch, *next; t < end; t = next) {
        for (next = t + 1; next < end && next < t + TOGETHER && same_nodes(c, t, next);)
            next++;
        if (!add_together(c, t, (int)(next - t), x, graph, K))
            return false;
        for (; x && t < next; t++)
            if (meets_smooth(c, t) && !add_slip(c, t, x, graph, K))
                return false;
    }
    return true;
}

void contact_system_land(struct contact *c, const struct blocks *graph, const double *M,
                         const struct supports *held, const double *x, double *v,
                         double *work)
{
    const size_t count = 3 * (size_t)graph->nodes;
    double *change = work, *y = work + count, *part = y + count, along = 0, square = 0;

    if (!c->count)
        return;
    contact_landing(c, CONTACT_ANY, x, v, change);
    supports_zero(held, change);
    blocks_multiply_mass(graph, M, change, y);
    for (size_t k = 0; k < count; k++)
        along -= y[k] * v[k], square += y[k] * change[k];
    const double share = square > 0 ? fmax(0, fmin(1, along / square)) : 0;
    const bool alone = c->scene->obstacle_count == 1 && !c->scene->contact.self;
    for (int o = 0; share > 0 && o < c->scene->obstacle_count; o++) {
        if (!alone) {
            contact_landing(c, o, x, v, part);
            supports_zero(held, part);
            blocks_multiply_mass(graph, M, part, y);
        }
        for (size_t u = 0; u < count; u += 3)
            contact_force_at(x + u, y + u, share / c->dt, c->landed[o]);
    }
    for (size_t k = 0; k < count; k++)
        v[k] += share * change[k];
}

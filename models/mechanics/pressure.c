#include "models/mechanics/pressure.h"

#include <stdlib.h>
#include <string.h>

#include "models/vector.h"

enum status pressure_init(struct pressure *p, const struct scene *scene, int elements,
                          int points, int local, const int *node)
{
    const size_t count = 3 * (size_t)elements * (size_t)points * (size_t)local;

    *p = (struct pressure){.value = scene->pressure,
                           .elements = elements,
                           .points = points,
                           .local = local,
                           .node = node};
    memcpy(p->axis, scene->axis_u, sizeof p->axis);
    if (p->value != 0)
        p->shape = calloc(count, sizeof *p->shape);
    return p->value == 0 || p->shape ? STATUS_OK : STATUS_MEMORY;
}

void pressure_clear(struct pressure *p)
{
    free(p->shape);
    memset(p, 0, sizeof *p);
}

static const int *nodes_of(const struct pressure *p, int element)
{
    return p->node + (size_t)element * (size_t)p->local;
}

static const double *shape_of(const struct pressure *p, int element, int point)
{
    const size_t at = (size_t)element * (size_t)p->points + (size_t)point;

    return p->shape + 3 * at * (size_t)p->local;
}

/* Computes the slopes x_u and x_v at a point, of (1 - share) x_old + share x. */
static void slopes(const struct pressure *p, const int *node, const double *N,
                   const double *x_old, double share, const double *x, double slope[2][3])
{
    memset(slope, 0, 6 * sizeof **slope);
    for (int a = 0; a < p->local; a++)
        for (int i = 0; i < 3; i++) {
            const size_t t = 3 * (size_t)node[a] + (size_t)i;
            const double at = share == 1 ? x[t] : (1 - share) * x_old[t] + share * x[t];
            for (int d = 0; d < 2; d++)
                slope[d][i] += N[(1 + d) * p->local + a] * at;
        }
}

void pressure_force(const struct pressure *p, double factor, const double *x_old,
                    double share, const double *x, double *f)
{
    for (int n = 0; n < p->elements * p->points; n++) {
        const int *node = nodes_of(p, n / p->points);
        const double *N = shape_of(p, 0, n);
        double slope[2][3], normal[3];
        slopes(p, node, N, x_old, share, x, slope);
        vector_cross(slope[0], slope[1], normal);
        for (int a = 0; a < p->local; a++)
            for (int i = 0; i < 3; i++)
                f[3 * (size_t)node[a] + (size_t)i] -= factor * p->value * N[a] * normal[i];
    }
}

/* Adds [c]x to a block. */
static void add_skew(const double c[3], double K[9])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        K[3 * j + k] -= c[i];
        K[3 * k + j] += c[i];
    }
}

/* Adds an element's part for a pair of its functions, at its points of the given slopes. */
static void add_pair(const struct pressure *p, const double *shape, int a, int b,
                     double half, double (*slope)[2][3], double K[9])
{
    double c[3] = {0};

    for (int q = 0; q < p->points; q++) {
        const double *N = shape + 3 * q * p->local, *u = N + p->local, *v = u + p->local;
        const double of_u = N[a] * v[b] - N[b] * v[a], of_v = N[a] * u[b] - N[b] * u[a];
        for (int i = 0; i < 3; i++)
            c[i] += half * (of_u * slope[q][0][i] - of_v * slope[q][1][i]);
    }
    add_skew(c, K);
}

void pressure_tangent(const struct pressure *p, double factor, const double *x_old,
                      double share, const double *x, const struct blocks *graph,
                      double (*K)[9])
{
    const double half = factor * share * p->value / 2;
    double slope[PRESSURE_MOST][2][3];

    for (int n = 0; n < p->elements; n++) {
        const int *node = nodes_of(p, n);
        for (int q = 0; q < p->points; q++)
            slopes(p, node, shape_of(p, n, q), x_old, share, x, slope[q]);
        for (int a = 0; a < p->local; a++)
            for (int b = a + 1; b < p->local; b++)
                add_pair(p, shape_of(p, n, 0), a, b, half, slope,
                         K[blocks_find(graph, node[a], node[b])]);
    }
}

/* Returns the volume inside, with planes across the axis at its ends. */
static double volume(const struct pressure *p, const double *x)
{
    double sum = 0;

    for (int n = 0; n < p->elements * p->points; n++) {
        const int *node = nodes_of(p, n / p->points);
        const double *N = shape_of(p, 0, n);
        double slope[2][3], normal[3], at[3] = {0}; /* at: times the weight */
        slopes(p, node, N, NULL, 1, x, slope);
        vector_cross(slope[0], slope[1], normal);
        for (int a = 0; a < p->local; a++)
            for (int i = 0; i < 3; i++)
                at[i] += N[a] * x[3 * (size_t)node[a] + (size_t)i];
        sum += (vector_dot(at, normal) -
                vector_dot(at, p->axis) * vector_dot(normal, p->axis)) /
               2;
    }
    return sum;
}

double pressure_energy(const struct pressure *p, const double *rest, const double *x)
{
    return p->value * (volume(p, x) - volume(p, rest));
}

#include "mass_spring/spring_frequency.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LANCZOS_STEPS = 200, LANCZOS_LOOK = 8 };

/* Of omega^2: it has converged when it gains less in LANCZOS_LOOK steps. */
static const double LANCZOS_GAIN = 1e-3;

static double norm(size_t count, const double *x)
{
    double sum = 0;

    for (size_t t = 0; t < count; t++)
        sum += x[t] * x[t];
    return sqrt(sum);
}

/* m^-1/2 of the free unknowns, 0 of the others. */
static void set_scale(const struct supports *supports, size_t count, const double *mass,
                      double *scale)
{
    for (size_t t = 0; t < count; t++)
        scale[t] = supports->free_index[t] < 0 ? 0 : 1 / sqrt(mass[t / 3]);
}

/* y = m^-1/2 K m^-1/2 x among the free unknowns. */
static void multiply(const struct blocks *graph, const double *scale, const double (*K)[9],
                     const double *x, double *work, double *y)
{
    size_t count = 3 * (size_t)graph->nodes;

    for (size_t t = 0; t < count; t++)
        work[t] = scale[t] * x[t];
    blocks_multiply(graph, K, work, y);
    for (size_t t = 0; t < count; t++)
        y[t] *= scale[t];
}

/* A start without symmetry: a low-discrepancy sequence. */
static void start_vector(const struct supports *supports, size_t count, double *q)
{
    for (size_t t = 0; t < count; t++)
        q[t] = supports->free_index[t] < 0 ? 0
                                           : fmod((double)(t + 1) * 0.61803398875, 1) - 0.5;
    double length = norm(count, q);
    for (size_t t = 0; t < count; t++)
        q[t] /= length;
}

/* The largest eigenvalue of the tridiagonal matrix of n steps. */
static double ritz(int n, const double *alpha, const double *beta)
{
    double a[LANCZOS_STEPS], b[LANCZOS_STEPS];

    memcpy(a, alpha, (size_t)n * sizeof *a);
    memcpy(b, beta, (size_t)n * sizeof *b);
    return LAPACKE_dsterf(n, a, b) == 0 ? a[n - 1] : 0;
}

enum status spring_frequency_largest(const struct blocks *graph,
                                     const struct supports *supports, const double *mass,
                                     const double (*K)[9], double *omega)
{
    size_t count = 3 * (size_t)graph->nodes;
    double *room = calloc(5 * count, sizeof *room), alpha[LANCZOS_STEPS],
           beta[LANCZOS_STEPS];
    double *q = room, *before = room + count, *y = room + 2 * count,
           *work = room + 3 * count, *root = room + 4 * count;
    double square = 0;
    int n = 0;

    *omega = 0;
    if (!room)
        return STATUS_MEMORY;
    if (!supports->free_count)
        goto out;
    start_vector(supports, count, q);
    set_scale(supports, count, mass, root);
    for (double last = 0; n < LANCZOS_STEPS && n < supports->free_count;) {
        multiply(graph, root, K, q, work, y);
        alpha[n] = 0;
        for (size_t t = 0; t < count; t++)
            alpha[n] += q[t] * y[t];
        for (size_t t = 0; t < count; t++)
            y[t] -= alpha[n] * q[t] + last * before[t];
        last = beta[n] = norm(count, y);
        double scale = fabs(alpha[n++]);
        double known = square;
        if (n % LANCZOS_LOOK == 0)
            square = ritz(n, alpha, beta);
        if (last <= 1e-12 * scale ||
            (square > known && square < (1 + LANCZOS_GAIN) * known))
            break;
        double *old = before;
        before = q, q = y, y = old;
        for (size_t t = 0; t < count; t++)
            q[t] /= last;
    }
    *omega = sqrt(fmax(0, ritz(n, alpha, beta)));
out:
    free(room);
    return STATUS_OK;
}

#include "models/mechanics/frequency.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LANCZOS_STEPS = 200, LANCZOS_LOOK = 8 };

/* Of omega^2: it has converged when it gains less in LANCZOS_LOOK steps. */
static const double LANCZOS_GAIN = 1e-3;

/* y = A x among the free unknowns, self-adjoint in the inner product x . W y: with lumped
 * mass A = m^-1/2 K m^-1/2 and W = 1, else A = M^-1 K and W = M. */
struct operator
{
    const struct blocks *graph;
    const struct supports *supports;
    const double(*K)[9];
    double *scale;       /* [nodes][3] m^-1/2 of the free unknowns, 0 of the others     */
    struct system *mass; /* NULL: lumped                                                */
    const double *M;
    double *work; /* [nodes][3]                                                         */
};

static size_t count_of(const struct operator* o)
{
    return 3 * (size_t)o->graph->nodes;
}

static enum status multiply(const struct operator* o, const double *x, double *y)
{
    if (o->mass) {
        blocks_multiply(o->graph, o->K, x, y);
        return system_solve(o->mass, y);
    }
    for (size_t t = 0; t < count_of(o); t++)
        o->work[t] = o->scale[t] * x[t];
    blocks_multiply(o->graph, o->K, o->work, y);
    for (size_t t = 0; t < count_of(o); t++)
        y[t] *= o->scale[t];
    return STATUS_OK;
}

static double product(const struct operator* o, const double *x, const double *y)
{
    double sum = 0;

    if (o->mass)
        blocks_multiply_mass(o->graph, o->M, y, o->work);
    for (size_t t = 0; t < count_of(o); t++)
        sum += x[t] * (o->mass ? o->work[t] : y[t]);
    return sum;
}

/* A start without symmetry: a low-discrepancy sequence. */
static void start_vector(const struct operator* o, double *q)
{
    size_t count = count_of(o);

    for (size_t t = 0; t < count; t++)
        q[t] = o->supports->free_index[t] < 0
                   ? 0
                   : fmod((double)(t + 1) * 0.61803398875, 1) - 0.5;
    double length = sqrt(product(o, q, q));
    for (size_t t = 0; t < count; t++)
        q[t] /= length;
}

/* No eigenvalue of the tridiagonal matrix of n steps is above x: by Sturm's sequence. */
static bool above_all(int n, const double *alpha, const double *beta, double x)
{
    double d = alpha[0] - x;

    for (int i = 1; i < n && d < 0; i++)
        d = alpha[i] - x - beta[i - 1] * beta[i - 1] / d;
    return d < 0;
}

/* Its largest eigenvalue, by bisection: one alone costs less than a library's all. */
static double ritz(int n, const double *alpha, const double *beta)
{
    double low = alpha[0], high = alpha[0];

    for (int i = 0; i < n; i++) { /* Gershgorin's circles */
        double reach = (i ? fabs(beta[i - 1]) : 0) + (i < n - 1 ? fabs(beta[i]) : 0);
        low = fmax(low, alpha[i]), high = fmax(high, alpha[i] + reach);
    }
    for (;;) {
        double middle = low + (high - low) / 2;
        if (!(middle > low && middle < high))
            return high;
        if (above_all(n, alpha, beta, middle))
            high = middle;
        else
            low = middle;
    }
}

/* room: 3 [nodes][3], zero. */
static enum status iterate(const struct operator* o, double *room, double *omega)
{
    enum status st = STATUS_OK;
    size_t count = count_of(o);
    double alpha[LANCZOS_STEPS], beta[LANCZOS_STEPS], square = 0, last = 0;
    double *q = room, *before = room + count, *y = room + 2 * count;
    int n = 0;

    start_vector(o, q);
    while (n < LANCZOS_STEPS && n < o->supports->free_count) {
        TRY(multiply(o, q, y));
        alpha[n] = product(o, q, y);
        for (size_t t = 0; t < count; t++)
            y[t] -= alpha[n] * q[t] + last * before[t];
        last = beta[n] = sqrt(product(o, y, y));
        double scale = fabs(alpha[n++]), known = square;
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
    return st;
}

static enum status largest(struct operator* o, const double *mass, double *omega)
{
    size_t count = count_of(o);
    double *room = calloc(5 * count, sizeof *room);
    enum status st = STATUS_OK;

    *omega = 0;
    if (!room)
        return STATUS_MEMORY;
    o->work = room + 3 * count, o->scale = room + 4 * count;
    for (size_t t = 0; mass && t < count; t++)
        o->scale[t] = o->supports->free_index[t] < 0 ? 0 : 1 / sqrt(mass[t / 3]);
    if (o->supports->free_count)
        st = iterate(o, room, omega);
    free(room);
    return st;
}

enum status frequency_largest(const struct blocks *graph, const struct supports *supports,
                              const double *mass, const double (*K)[9], double *omega)
{
    return largest(&(struct operator){.graph = graph, .supports = supports, .K = K}, mass,
                   omega);
}

enum status frequency_consistent(struct system *mass, const double *M, const double (*K)[9],
                                 double *omega)
{
    return largest(
        &(struct operator){
            .graph = mass->graph, .supports = mass->held, .K = K, .mass = mass, .M = M},
        NULL, omega);
}

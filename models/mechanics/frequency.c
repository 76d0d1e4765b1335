#include "models/mechanics/frequency.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LANCZOS_STEPS = 200, LANCZOS_LOOK = 8 };

/* omega^2 has converged when it gains less than this share in LANCZOS_LOOK steps. */
static const double LANCZOS_GAIN = 1e-3;

/* The share to which an eigenvalue of the tridiagonal matrix is found. */
static const double RITZ_ROUNDING = 1e-9;

/* The operator y = S m^-1/2 K m^-1/2 x among the free unknowns, S = 1 + m^-1/2 beyond
 * m^-1/2. It is symmetric in the product x . m^-1/2 K m^-1/2 y, without S in x . y. */
struct operator
{
    const struct frequency_body *body;
    const struct supports *supports;
    double *scale; /* [nodes][3] m^-1/2 of the free unknowns, 0 of the others           */
    double *work;  /* [nodes][3]                                                        */
};

static size_t count_of(const struct operator* o)
{
    return 3 * (size_t)o->supports->nodes;
}

/* Computes y = m^-1/2 A m^-1/2 x, A one of the body's products. */
static void scaled(const struct operator* o,
                   void (*product)(const void *self, const double *x, double *y),
                   const double *x, double *y)
{
    for (size_t t = 0; t < count_of(o); t++)
        o->work[t] = o->scale[t] * x[t];
    supports_from_frames(o->supports, o->work);
    product(o->body->self, o->work, y);
    supports_to_frames(o->supports, y);
    for (size_t t = 0; t < count_of(o); t++)
        y[t] *= o->scale[t];
}

static void multiply(const struct operator* o, const double *x, double *y)
{
    scaled(o, o->body->multiply, x, y);
}

/* Computes y = S z. */
static void spread(const struct operator* o, const double *z, double *y)
{
    scaled(o, o->body->beyond, z, y);
    for (size_t t = 0; t < count_of(o); t++)
        y[t] += z[t];
}

/* Adds in lanes: vectors, and the same bits on every CPU. */
enum { LANES = 8 };

static double product(const struct operator* o, const double *x, const double *y)
{
    const size_t count = count_of(o), whole = count - count % LANES;
    double lane[LANES] = {0}, sum = 0;

    for (size_t t = 0; t < whole; t += LANES)
        for (int n = 0; n < LANES; n++)
            lane[n] += x[t + n] * y[t + n];
    for (size_t t = whole; t < count; t++)
        sum += x[t] * y[t];
    for (int n = 0; n < LANES; n++)
        sum += lane[n];
    return sum;
}

/* Fills q with a start without symmetry: a low-discrepancy sequence. */
static void start_vector(const struct operator* o, double *q)
{
    size_t count = count_of(o);

    for (size_t t = 0; t < count; t++)
        q[t] = o->supports->free_index[t] < 0
                   ? 0
                   : (double)(t + 1) * 0.61803398875 -
                         floor((double)(t + 1) * 0.61803398875) - 0.5;
    double length = sqrt(product(o, q, q));
    for (size_t t = 0; t < count; t++)
        q[t] /= length;
}

/* Tells whether no eigenvalue of the tridiagonal matrix of n steps exceeds x (Sturm
 * sequence). */
static bool above_all(int n, const double *alpha, const double *beta, double x)
{
    double d = alpha[0] - x;

    for (int i = 1; i < n && d < 0; i++)
        d = alpha[i] - x - beta[i - 1] * beta[i - 1] / d;
    return d < 0;
}

/* Returns its largest eigenvalue, which is not below `low`, by bisection: cheaper than all
 * of them from a library. */
static double ritz(int n, const double *alpha, const double *beta, double low)
{
    double high = low;

    for (int i = 0; i < n; i++) { /* Gershgorin's circles */
        double reach = (i ? fabs(beta[i - 1]) : 0) + (i < n - 1 ? fabs(beta[i]) : 0);
        high = fmax(high, alpha[i] + reach);
    }
    while (high - low > RITZ_ROUNDING * fabs(high)) {
        double middle = low + (high - low) / 2;
        if (above_all(n, alpha, beta, middle))
            high = middle;
        else
            low = middle;
    }
    return high;
}

/* Computes z, with which y's products are made; returns y's length. */
static double measure(const struct operator* o, const double *y, double *z)
{
    if (o->body->beyond)
        multiply(o, y, z);
    else
        memcpy(z, y, count_of(o) * sizeof *z);
    return sqrt(fmax(0, product(o, y, z)));
}

/* Iterates; returns the largest eigenvalue. room: 4 [nodes][3], zero. */
static double iterate(const struct operator* o, double *room)
{
    size_t count = count_of(o);
    double alpha[LANCZOS_STEPS], beta[LANCZOS_STEPS], square = 0, last = 0;
    double *q = room, *before = room + count, *y = room + 2 * count, *z = room + 3 * count;
    int n = 0;

    start_vector(o, q);
    double first = measure(o, q, z);
    for (size_t t = 0; o->body->beyond && t < count; t++)
        q[t] /= first, z[t] /= first;
    while (n < LANCZOS_STEPS && n < o->supports->free_count) {
        if (o->body->beyond)
            spread(o, z, y);
        else
            multiply(o, q, y);
        alpha[n] = product(o, z, y);
        for (size_t t = 0; t < count; t++)
            y[t] -= alpha[n] * q[t] + last * before[t];
        last = beta[n] = measure(o, y, z);
        double scale = fabs(alpha[n++]), known = square;
        if (n % LANCZOS_LOOK == 0)
            square = ritz(n, alpha, beta, known);
        if (last <= 1e-12 * scale ||
            (square > known && square < (1 + LANCZOS_GAIN) * known))
            break;
        double *old = before;
        before = q, q = y, y = old;
        const double over = 1 / last;
        for (size_t t = 0; t < count; t++)
            q[t] *= over, z[t] *= over;
    }
    return sqrt(n % LANCZOS_LOOK == 0 ? square : ritz(n, alpha, beta, square));
}

enum status frequency_of_body(const struct frequency_body *body, double *omega)
{
    struct operator o = {.body = body, .supports = body->supports};
    const size_t count = count_of(&o);
    double *room = calloc(6 * count, sizeof *room);

    *omega = 0;
    if (!room)
        return STATUS_MEMORY;
    o.work = room + 4 * count, o.scale = room + 5 * count;
    for (size_t t = 0; t < count; t++)
        o.scale[t] = o.supports->free_index[t] < 0 ? 0 : 1 / sqrt(body->mass[t / 3]);
    if (o.supports->free_count)
        *omega = iterate(&o, room);
    free(room);
    return STATUS_OK;
}

/* A matrix as a body. */
struct matrix_of {
    const struct blocks *graph;
    const double (*K)[9];
    const double *beyond;
};

static void multiply_blocks(const void *self, const double *x, double *y)
{
    const struct matrix_of *m = self;

    blocks_multiply(m->graph, m->K, x, y);
}

static void multiply_beyond(const void *self, const double *x, double *y)
{
    const struct matrix_of *m = self;

    blocks_multiply_mass(m->graph, m->beyond, x, y);
}

enum status frequency_largest(const struct blocks *graph, const struct supports *supports,
                              const double *mass, const double *beyond,
                              const double (*K)[9], double *omega)
{
    const struct matrix_of matrix = {graph, K, beyond};
    const struct frequency_body body = {.supports = supports,
                                        .mass = mass,
                                        .multiply = multiply_blocks,
                                        .beyond = beyond ? multiply_beyond : NULL,
                                        .self = &matrix};

    return frequency_of_body(&body, omega);
}

double frequency_limit(double omega, double beta)
{
    return omega > 0 ? sqrt(beta * beta + 4 / (omega * omega)) - beta : INFINITY;
}

const double frequency_chosen = 0.95;

enum status frequency_steps(double frame, double limit, int asked, int *steps,
                            struct message *why)
{
    const double n = asked ? asked : fmax(1, ceil(frame / (frequency_chosen * limit)));

    if (!(n <= FREQUENCY_MOST_STEPS))
        return status_fail(why, STATUS_INPUT,
                           "explicit steps: %g substeps a frame are needed here (greatest "
                           "stable step %g s); use integrator=implicit",
                           n, limit);
    *steps = (int)n;
    return STATUS_OK;
}

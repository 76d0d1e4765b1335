#include "fem_ref/kirchhoff.h"
#include "fem_ref/ritz.h"

#include <assert.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Modes of one parity in y - W/2. Unknown (a, b) of size nx x ny multiplies
 * phi_a(x / L) psi_{2b + parity}(y / W). Everything here is dimensionless: lengths over L
 * and W, K over D W / L^3, M over rho h L W, so that mu = 1 / lambda^2 with
 * lambda = omega L^2 sqrt(rho h / D). */
struct family {
    int parity, ny, n; /* n = nx ny                                                  */
    double *mass;      /* [n][n]                                                     */
    double *stiffness; /* [n][n]                                                     */
    double *mode;      /* [n][n]; mode[i] is K-orthonormal, highest frequency first  */
    double *mu;        /* [n] ascending                                              */
    double *load;      /* [n] mode[i] . (integrals of the functions)                 */
};

struct order {
    double lambda;
    int family, index;
};

struct kirchhoff {
    struct kirchhoff_plate plate;
    double deflection_scale; /* L^4 / D [m^3/N]      */
    double frequency_scale;  /* sqrt(D / rho h) / L^2 */
    struct ritz along, across;
    struct family family[2]; /* even, odd             */
    struct order *order;     /* [count] ascending     */
    int count;
};

/* ------------------------------------------------------------------ building -------- */

static double *table(size_t n)
{
    return calloc(n, sizeof(double));
}

/* The integrals of two functions of one direction. */
struct pair {
    double mass, slope, bend; /* phi_i phi_j, phi_i' phi_j', phi_i'' phi_j'' */
    double mixed, mixed_back; /* phi_i'' phi_j, phi_i phi_j''                */
};

static struct pair pair_of(const struct ritz *r, int i, int j)
{
    return (struct pair){.mass = ritz_product(r, 0, i, 0, j),
                         .slope = ritz_product(r, 1, i, 1, j),
                         .bend = ritz_product(r, 2, i, 2, j),
                         .mixed = ritz_product(r, 2, i, 0, j),
                         .mixed_back = ritz_product(r, 0, i, 2, j)};
}

/* Fills both matrices; the bending energy is, with r = L / W,
 *   w_xx^2 + r^4 w_yy^2 + 2 nu r^2 w_xx w_yy + 2 (1 - nu) r^2 w_xy^2. */
static enum status fill_matrices(const struct kirchhoff *k, struct family *f)
{
    const int nx = k->along.count, ny = f->ny, odd = f->parity;
    const double nu = k->plate.poisson;
    const double r = k->plate.length / k->plate.width, r2 = r * r;
    struct pair *across = calloc((size_t)ny * ny, sizeof *across);

    if (!across)
        return STATUS_MEMORY;
    for (int n = 0; n < ny * ny; n++)
        across[n] = pair_of(&k->across, 2 * (n / ny) + odd, 2 * (n % ny) + odd);
    for (int ac = 0; ac < nx * nx; ac++) {
        const int a = ac / nx, c = ac % nx;
        const struct pair x = pair_of(&k->along, a, c);
        for (int n = 0; n < ny * ny; n++) {
            const struct pair y = across[n];
            size_t at = (size_t)(a * ny + n / ny) * f->n + c * ny + n % ny;
            f->mass[at] = x.mass * y.mass;
            f->stiffness[at] = x.bend * y.mass + r2 * r2 * x.mass * y.bend +
                               nu * r2 * (x.mixed * y.mixed_back + x.mixed_back * y.mixed) +
                               2 * (1 - nu) * r2 * x.slope * y.slope;
        }
    }
    free(across);
    return STATUS_OK;
}

/* Solves M c = mu K c; the eigenvectors come out K-orthonormal, one a row of `mode`. */
static enum status solve_modes(struct family *f)
{
    enum status st = STATUS_OK;
    double *K = table((size_t)f->n * f->n);

    if (!K)
        return STATUS_MEMORY;
    memcpy(K, f->stiffness, sizeof(double) * f->n * f->n);
    memcpy(f->mode, f->mass, sizeof(double) * f->n * f->n);
    if (LAPACKE_dsygvd(LAPACK_COL_MAJOR, 1, 'V', 'L', f->n, f->mode, f->n, K, f->n, f->mu))
        st = STATUS_LIBRARY;
    free(K);
    return st;
}

static enum status family_init(const struct kirchhoff *k, int parity, struct family *f)
{
    enum status st;

    f->parity = parity;
    f->ny = (k->across.count - parity + 1) / 2;
    f->n = k->along.count * f->ny;
    f->mass = table((size_t)f->n * f->n);
    f->stiffness = table((size_t)f->n * f->n);
    f->mode = table((size_t)f->n * f->n);
    f->mu = table(f->n);
    f->load = table(f->n);
    if (!f->mass || !f->stiffness || !f->mode || !f->mu || !f->load)
        return STATUS_MEMORY;
    TRY(fill_matrices(k, f));
    TRY(solve_modes(f));
    for (int i = 0; i < f->n; i++) {
        const double *c = f->mode + (size_t)i * f->n;
        for (int a = 0; a < k->along.count; a++)
            for (int b = 0; b < f->ny; b++)
                f->load[i] += c[a * f->ny + b] * ritz_integral(&k->along, a) *
                              ritz_integral(&k->across, 2 * b + parity);
        /* Round-off of the largest mu exceeds the smallest, which are kept finite. */
        f->mu[i] = fmax(f->mu[i], DBL_EPSILON * f->mu[f->n - 1]);
    }
out:
    return st;
}

static void family_clear(struct family *f)
{
    free(f->mass);
    free(f->stiffness);
    free(f->mode);
    free(f->mu);
    free(f->load);
}

static int by_frequency(const void *a, const void *b)
{
    const struct order *p = a, *q = b;
    if (p->lambda != q->lambda)
        return p->lambda < q->lambda ? -1 : 1;
    return p->family - q->family;
}

static enum status sort_modes(struct kirchhoff *k)
{
    int at = 0;

    k->count = k->family[0].n + k->family[1].n;
    k->order = calloc(k->count, sizeof *k->order);
    if (!k->order)
        return STATUS_MEMORY;
    for (int g = 0; g < 2; g++)
        for (int i = 0; i < k->family[g].n; i++)
            k->order[at++] = (struct order){1 / sqrt(k->family[g].mu[i]), g, i};
    qsort(k->order, k->count, sizeof *k->order, by_frequency);
    return STATUS_OK;
}

void kirchhoff_destroy(struct kirchhoff *k)
{
    if (!k)
        return;
    ritz_clear(&k->along);
    ritz_clear(&k->across);
    family_clear(&k->family[0]);
    family_clear(&k->family[1]);
    free(k->order);
    free(k);
}

enum status kirchhoff_create(const struct kirchhoff_plate *plate, int terms,
                             struct kirchhoff **out)
{
    enum status st;
    const double nu = plate->poisson;
    struct kirchhoff *k = calloc(1, sizeof *k);

    assert(plate->length > 0 && plate->width > 0 && plate->thickness > 0);
    assert(plate->young > 0 && plate->density > 0 && nu > -1 && nu < 0.5);
    if (!k)
        return STATUS_MEMORY;
    const double D = plate->young * pow(plate->thickness, 3) / (12 * (1 - nu * nu));
    const double L2 = plate->length * plate->length;
    k->plate = *plate;
    k->deflection_scale = L2 * L2 / D;
    k->frequency_scale = sqrt(D / (plate->density * plate->thickness)) / L2;
    TRY(ritz_init(&k->along, RITZ_CLAMPED_FREE, terms));
    TRY(ritz_init(&k->across, RITZ_FREE_FREE, terms));
    TRY(family_init(k, 0, &k->family[0]));
    TRY(family_init(k, 1, &k->family[1]));
    TRY(sort_modes(k));
    *out = k, k = NULL;
out:
    kirchhoff_destroy(k);
    return st;
}

/* -------------------------------------------------------------------- modes --------- */

double kirchhoff_frequency(const struct kirchhoff *k, int i)
{
    assert(i >= 0 && i < k->count);
    return k->order[i].lambda * k->frequency_scale;
}

/* Returns sum c_ab X_a Y_b for functions already evaluated. */
static double combine(const struct kirchhoff *k, const struct family *f, const double *c,
                      const double *X, const double *Y)
{
    double sum = 0;
    for (int a = 0; a < k->along.count; a++) {
        double row = 0;
        for (int b = 0; b < f->ny; b++)
            row += c[a * f->ny + b] * Y[2 * b + f->parity];
        sum += X[a] * row;
    }
    return sum;
}

static double value(const struct kirchhoff *k, const struct family *f, const double *c,
                    double x, double y)
{
    double X[RITZ_MAX], Y[RITZ_MAX];
    ritz_eval(&k->along, 0, x / k->plate.length, X);
    ritz_eval(&k->across, 0, y / k->plate.width, Y);
    return combine(k, f, c, X, Y);
}

double kirchhoff_mode(const struct kirchhoff *k, int i, double x, double y)
{
    assert(i >= 0 && i < k->count);
    const struct family *f = &k->family[k->order[i].family];
    const double *c = f->mode + (size_t)k->order[i].index * f->n;
    return k->order[i].lambda * value(k, f, c, x, y); /* c^T M c = mu */
}

/* -------------------------------------------------------------------- motion -------- */

/* Computes y(t) and its rate: y'' + alpha y' + omega^2 y = omega^2, from rest. */
static void step_response(double omega, double alpha, double t, double *y, double *rate)
{
    const double a = alpha / 2, s2 = omega * omega - a * a, s = sqrt(fabs(s2));

    if (isinf(t)) {
        *y = 1, *rate = 0;
        return;
    }
    if (a == 0) {
        double half = sin(omega * t / 2); /* 1 - cos, without cancellation */
        *y = 2 * half * half;
        *rate = omega * sin(omega * t);
        return;
    }
    if (s2 < 0 && s * t > 1) { /* both exponentials decay: no overflow at large t */
        double slow = omega * omega / (a + s), fast = a + s;
        *y = 1 - (fast * exp(-slow * t) - slow * exp(-fast * t)) / (2 * s);
        *rate = omega * omega * (exp(-slow * t) - exp(-fast * t)) / (2 * s);
        return;
    }
    double wave = s2 < 0 ? cosh(s * t) : cos(s * t);
    double over = s == 0 ? t : (s2 < 0 ? sinh(s * t) : sin(s * t)) / s;
    *y = 1 - exp(-a * t) * (wave + a * over);
    *rate = omega * omega * exp(-a * t) * over;
}

/* Computes coefficients of w / (q deflection_scale) and, unless NULL, of its rate at time
 * t: only even modes respond to a uniform load. Allocates *c, *v of [family[0].n]. */
static enum status coefficients(const struct kirchhoff *k, double alpha, double t,
                                double **c, double **v)
{
    const struct family *f = &k->family[0];

    *c = table(f->n);
    if (v)
        *v = table(f->n);
    if (!*c || (v && !*v))
        return STATUS_MEMORY;
    for (int i = f->n - 1; i >= 0; i--) {
        const double *mode = f->mode + (size_t)i * f->n;
        double omega = k->frequency_scale / sqrt(f->mu[i]), y, rate;
        step_response(omega, alpha, t, &y, &rate);
        for (int j = 0; j < f->n; j++) {
            (*c)[j] += y * f->load[i] * mode[j];
            if (v)
                (*v)[j] += rate * f->load[i] * mode[j];
        }
    }
    return STATUS_OK;
}

double kirchhoff_transient(const struct kirchhoff *k, double q, double alpha, double t,
                           double x, double y)
{
    const struct family *f = &k->family[0];
    double X[RITZ_MAX], Y[RITZ_MAX], sum = 0;

    assert(t >= 0 && alpha >= 0);
    ritz_eval(&k->along, 0, x / k->plate.length, X);
    ritz_eval(&k->across, 0, y / k->plate.width, Y);
    for (int i = f->n - 1; i >= 0; i--) {
        double omega = k->frequency_scale / sqrt(f->mu[i]), grown, rate;
        step_response(omega, alpha, t, &grown, &rate);
        sum += grown * f->load[i] * combine(k, f, f->mode + (size_t)i * f->n, X, Y);
    }
    return q * k->deflection_scale * sum;
}

double kirchhoff_static(const struct kirchhoff *k, double q, double x, double y)
{
    return kirchhoff_transient(k, q, 0, INFINITY, x, y);
}

/* Fills out[ny][nx] = scale sum c_ab X_a(x) Y_b(y), derivatives of order dx and dy. */
static void tabulate(const struct kirchhoff *k, const double *c, double scale, int dx,
                     int dy, int nx, const double *x, int ny, const double *y, double *out)
{
    double X[RITZ_MAX], Y[RITZ_MAX];

    for (int j = 0; j < ny; j++) {
        ritz_eval(&k->across, dy, y[j] / k->plate.width, Y);
        for (int i = 0; i < nx; i++) {
            ritz_eval(&k->along, dx, x[i] / k->plate.length, X);
            out[j * nx + i] = scale * combine(k, &k->family[0], c, X, Y);
        }
    }
}

enum status kirchhoff_grid(const struct kirchhoff *k, double q, double alpha, double t,
                           int nx, const double *x, int ny, const double *y, double *w,
                           double *w_x, double *w_y)
{
    enum status st;
    const double scale = q * k->deflection_scale;
    double *c = NULL;

    assert(t >= 0 && alpha >= 0);
    TRY(coefficients(k, alpha, t, &c, NULL));
    tabulate(k, c, scale, 0, 0, nx, x, ny, y, w);
    tabulate(k, c, scale / k->plate.length, 1, 0, nx, x, ny, y, w_x);
    tabulate(k, c, scale / k->plate.width, 0, 1, nx, x, ny, y, w_y);
out:
    free(c);
    return st;
}

static double quadratic(int n, const double *A, const double *c)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        double row = 0;
        for (int j = 0; j < n; j++)
            row += A[(size_t)i * n + j] * c[j];
        sum += c[i] * row;
    }
    return sum;
}

enum status kirchhoff_energy(const struct kirchhoff *k, double q, double alpha, double t,
                             struct energy *energy)
{
    enum status st;
    const struct family *f = &k->family[0];
    const struct kirchhoff_plate *plate = &k->plate;
    const double area = plate->length * plate->width, w = q * k->deflection_scale;
    double *c = NULL, *v = NULL, mean = 0;

    TRY(coefficients(k, alpha, t, &c, &v));
    for (int a = 0; a < k->along.count; a++)
        for (int b = 0; b < f->ny; b++)
            mean += c[a * f->ny + b] * ritz_integral(&k->along, a) *
                    ritz_integral(&k->across, 2 * b);
    energy->kinetic =
        plate->density * plate->thickness * area * w * w * quadratic(f->n, f->mass, v) / 2;
    energy->elastic =
        area * w * w / k->deflection_scale * quadratic(f->n, f->stiffness, c) / 2;
    energy->potential = -q * area * w * mean;
out:
    free(c);
    free(v);
    return st;
}

#include "fem_ref/kirchhoff.h"
#include "fem_ref/ritz.h"

#include <assert.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

/* A uniform load moves the modes that are even in y - W/2, and no others: unknown (a, b) of
 * nx x ny multiplies phi_a(x / L) psi_2b(y / W). Everything here is dimensionless: lengths
 * over L and W, K over D W / L^3, M over rho h L W, so that mu = 1 / lambda^2 with
 * lambda = omega L^2 sqrt(rho h / D). */
struct kirchhoff {
    struct kirchhoff_plate plate;
    double deflection_scale; /* L^4 / D [m^3/N]                                       */
    double frequency_scale;  /* sqrt(D / rho h) / L^2 [1/s]                           */
    struct ritz along, across;
    int ny, n;    /* n = nx ny                                                        */
    double *mode; /* [n][n]; mode[i] is K-orthonormal, highest frequency first        */
    double *mu;   /* [n] ascending                                                    */
    double *load; /* [n] mode[i] . (integrals of the functions)                       */
};

/* --- Building --- */

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

/* Fills M[n][n] and K[n][n]; the bending energy is, with r = L / W,
 *   w_xx^2 + r^4 w_yy^2 + 2 nu r^2 w_xx w_yy + 2 (1 - nu) r^2 w_xy^2. */
static enum status fill_matrices(const struct kirchhoff *k, double *M, double *K)
{
    const int nx = k->along.count, ny = k->ny;
    const double nu = k->plate.poisson;
    const double r = k->plate.length / k->plate.width, r2 = r * r;
    struct pair *across = calloc((size_t)ny * ny, sizeof *across);

    if (!across)
        return STATUS_MEMORY;
    for (int n = 0; n < ny * ny; n++)
        across[n] = pair_of(&k->across, 2 * (n / ny), 2 * (n % ny));
    for (int ac = 0; ac < nx * nx; ac++) {
        const int a = ac / nx, c = ac % nx;
        const struct pair x = pair_of(&k->along, a, c);
        for (int n = 0; n < ny * ny; n++) {
            const struct pair y = across[n];
            size_t at = (size_t)(a * ny + n / ny) * k->n + c * ny + n % ny;
            M[at] = x.mass * y.mass;
            K[at] = x.bend * y.mass + r2 * r2 * x.mass * y.bend +
                    nu * r2 * (x.mixed * y.mixed_back + x.mixed_back * y.mixed) +
                    2 * (1 - nu) * r2 * x.slope * y.slope;
        }
    }
    free(across);
    return STATUS_OK;
}

/* Solves M c = mu K c; the eigenvectors come out K-orthonormal, one a row of `mode`. */
static enum status solve_modes(struct kirchhoff *k)
{
    double *K = table((size_t)k->n * k->n);
    enum status st = K ? fill_matrices(k, k->mode, K) : STATUS_MEMORY;

    if (st == STATUS_OK &&
        LAPACKE_dsygvd(LAPACK_COL_MAJOR, 1, 'V', 'L', k->n, k->mode, k->n, K, k->n, k->mu))
        st = STATUS_LIBRARY;
    free(K);
    return st;
}

static void load_modes(struct kirchhoff *k)
{
    for (int i = 0; i < k->n; i++) {
        const double *c = k->mode + (size_t)i * k->n;
        for (int a = 0; a < k->along.count; a++)
            for (int b = 0; b < k->ny; b++)
                k->load[i] += c[a * k->ny + b] * ritz_integral(&k->along, a) *
                              ritz_integral(&k->across, 2 * b);
        /* Round-off of the largest mu exceeds the smallest, which are kept finite. */
        k->mu[i] = fmax(k->mu[i], DBL_EPSILON * k->mu[k->n - 1]);
    }
}

void kirchhoff_destroy(struct kirchhoff *k)
{
    if (!k)
        return;
    ritz_clear(&k->along);
    ritz_clear(&k->across);
    free(k->mode);
    free(k->mu);
    free(k->load);
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
    k->ny = (terms + 1) / 2;
    k->n = terms * k->ny;
    TRY(ritz_init(&k->along, RITZ_CLAMPED_FREE, terms));
    TRY(ritz_init(&k->across, RITZ_FREE_FREE, terms));
    k->mode = table((size_t)k->n * k->n);
    k->mu = table(k->n);
    k->load = table(k->n);
    TRY(k->mode && k->mu && k->load ? STATUS_OK : STATUS_MEMORY);
    TRY(solve_modes(k));
    load_modes(k);
    *out = k, k = NULL;
out:
    kirchhoff_destroy(k);
    return st;
}

/* --- Motion --- */

/* Returns sum c_ab X_a Y_b for functions already evaluated. */
static double combine(const struct kirchhoff *k, const double *c, const double *X,
                      const double *Y)
{
    double sum = 0;
    for (int a = 0; a < k->along.count; a++) {
        double row = 0;
        for (int b = 0; b < k->ny; b++)
            row += c[a * k->ny + b] * Y[2 * b];
        sum += X[a] * row;
    }
    return sum;
}

/* Returns y(t) of y'' + alpha y' + omega^2 y = omega^2, from rest. */
static double step_response(double omega, double alpha, double t)
{
    const double a = alpha / 2, s2 = omega * omega - a * a, s = sqrt(fabs(s2));

    if (isinf(t))
        return 1;
    if (a == 0) {
        const double half = sin(omega * t / 2); /* 1 - cos, without cancellation */
        return 2 * half * half;
    }
    if (s2 < 0 && s * t > 1) { /* both exponentials decay: no overflow at large t */
        const double slow = omega * omega / (a + s), fast = a + s;
        return 1 - (fast * exp(-slow * t) - slow * exp(-fast * t)) / (2 * s);
    }
    const double wave = s2 < 0 ? cosh(s * t) : cos(s * t);
    const double over = s == 0 ? t : (s2 < 0 ? sinh(s * t) : sin(s * t)) / s;
    return 1 - exp(-a * t) * (wave + a * over);
}

/* Returns how much of its static answer mode i has at t, times its load. */
static double response(const struct kirchhoff *k, int i, double alpha, double t)
{
    return step_response(k->frequency_scale / sqrt(k->mu[i]), alpha, t) * k->load[i];
}

double kirchhoff_transient(const struct kirchhoff *k, double q, double alpha, double t,
                           double x, double y)
{
    double X[RITZ_MAX], Y[RITZ_MAX], sum = 0;

    assert(t >= 0 && alpha >= 0);
    ritz_eval(&k->along, 0, x / k->plate.length, X);
    ritz_eval(&k->across, 0, y / k->plate.width, Y);
    for (int i = k->n - 1; i >= 0; i--)
        sum += response(k, i, alpha, t) * combine(k, k->mode + (size_t)i * k->n, X, Y);
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
            out[j * nx + i] = scale * combine(k, c, X, Y);
        }
    }
}

enum status kirchhoff_grid(const struct kirchhoff *k, double q, double alpha, double t,
                           int nx, const double *x, int ny, const double *y, double *w,
                           double *w_x, double *w_y)
{
    const double scale = q * k->deflection_scale;
    double *c = table(k->n); /* coefficients of w / scale */

    assert(t >= 0 && alpha >= 0);
    if (!c)
        return STATUS_MEMORY;
    for (int i = k->n - 1; i >= 0; i--) {
        const double grown = response(k, i, alpha, t), *mode = k->mode + (size_t)i * k->n;
        for (int j = 0; j < k->n; j++)
            c[j] += grown * mode[j];
    }
    tabulate(k, c, scale, 0, 0, nx, x, ny, y, w);
    tabulate(k, c, scale / k->plate.length, 1, 0, nx, x, ny, y, w_x);
    tabulate(k, c, scale / k->plate.width, 0, 1, nx, x, ny, y, w_y);
    free(c);
    return STATUS_OK;
}

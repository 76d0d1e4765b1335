#include "fem_ref/kirchhoff.h"

#include <assert.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "models/grid.h"
#include "models/vector.h"

/* Computes the Legendre series of the integral from 0 to x, x = (s + 1) / 2: int P_k ds =
 * (P_{k+1} - P_{k-1}) / (2k + 1), and dx = ds / 2. */
static void integrate(int terms, const double *from, double *to)
{
    for (int k = 0; k < terms; k++)
        to[k] = 0;
    for (int k = 0; k < terms; k++) {
        double c = from[k] / (2 * (2 * k + 1));
        if (c == 0)
            continue;
        assert(k + 1 < terms);
        to[k + 1] += c;
        to[k > 0 ? k - 1 : 0] += k > 0 ? -c : c;
    }
}

static void legendre(int count, double s, double *p)
{
    p[0] = 1;
    p[1] = s;
    for (int k = 1; k + 1 < count; k++)
        p[k + 1] = ((2 * k + 1) * s * p[k] - k * p[k - 1]) / (k + 1);
}

/* Sets phi'' = sqrt(2d + 1) P_d, integrated twice from x = 0. */
static void set_integrated(struct ritz *r, int i, int d)
{
    double *c[3];
    for (int a = 0; a < 3; a++)
        c[a] = r->coefficient[a] + i * r->terms;
    c[2][d] = sqrt(2 * d + 1);
    integrate(r->terms, c[2], c[1]);
    integrate(r->terms, c[1], c[0]);
}

/* Sets the first four free functions: rigid motions, then a quadratic and a cubic
 * orthogonal to them. P_2'' = 12 and P_3'' = 60 s in x; P_2' = 6 s, P_3' = 2 + 10 P_2. */
static void set_low_free(struct ritz *r)
{
    const int n = r->terms;
    double *value = r->coefficient[0], *slope = r->coefficient[1],
           *bend = r->coefficient[2];
    const double two = 12, three = 60 / sqrt(3); /* norms of P_2'' and P_3'' */

    value[0] = 1;
    value[n + 1] = 0.5; /* x - 1/2 */
    slope[n] = 1;
    value[2 * n + 2] = 1 / two;
    slope[2 * n + 1] = 6 / two;
    bend[2 * n] = 1;
    value[3 * n + 3] = 1 / three;
    slope[3 * n] = 2 / three;
    slope[3 * n + 2] = 10 / three;
    bend[3 * n + 1] = sqrt(3);
}

void ritz_clear(struct ritz *r)
{
    for (int a = 0; a < 3; a++)
        free(r->coefficient[a]);
    *r = (struct ritz){0};
}

enum status ritz_init(struct ritz *r, enum ritz_end end, int count)
{
    assert(count >= 4 && count <= RITZ_MAX);
    *r = (struct ritz){.count = count, .terms = count + 3};
    for (int a = 0; a < 3; a++) {
        r->coefficient[a] = calloc((size_t)count * r->terms, sizeof(double));
        if (!r->coefficient[a]) {
            ritz_clear(r);
            return STATUS_MEMORY;
        }
    }
    if (end == RITZ_CLAMPED_FREE) {
        for (int i = 0; i < count; i++)
            set_integrated(r, i, i);
    } else {
        set_low_free(r);
        for (int i = 4; i < count; i++) /* P_{i-2} is orthogonal to 1 and x: ends free */
            set_integrated(r, i, i - 2);
    }
    return STATUS_OK;
}

void ritz_eval(const struct ritz *r, int d, double x, double *out)
{
    double p[RITZ_MAX + 3];

    assert(d >= 0 && d <= 2 && x >= 0 && x <= 1);
    legendre(r->terms, 2 * x - 1, p);
    for (int i = 0; i < r->count; i++) {
        const double *c = r->coefficient[d] + i * r->terms;
        double sum = 0;
        for (int k = 0; k < r->terms; k++)
            sum += c[k] * p[k];
        out[i] = sum;
    }
}

double ritz_product(const struct ritz *r, int a, int i, int b, int j)
{
    const double *c = r->coefficient[a] + i * r->terms;
    const double *d = r->coefficient[b] + j * r->terms;
    double sum = 0;

    for (int k = 0; k < r->terms; k++)
        sum += c[k] * d[k] / (2 * k + 1);
    return sum;
}

double ritz_integral(const struct ritz *r, int i)
{
    return r->coefficient[0][i * r->terms];
}

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

/* Computes row_a = sum_b c_ab Y_b for functions already evaluated. */
static void sum_across(const struct kirchhoff *k, const double *c, const double *Y,
                       double *row)
{
    for (int a = 0; a < k->along.count; a++) {
        row[a] = 0;
        for (int b = 0; b < k->ny; b++)
            row[a] += c[a * k->ny + b] * Y[2 * b];
    }
}

/* Returns sum X_a row_a. */
static double sum_along(const struct kirchhoff *k, const double *X, const double *row)
{
    double sum = 0;

    for (int a = 0; a < k->along.count; a++)
        sum += X[a] * row[a];
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
    double X[RITZ_MAX], Y[RITZ_MAX], row[RITZ_MAX], sum = 0;

    assert(t >= 0 && alpha >= 0);
    ritz_eval(&k->along, 0, x / k->plate.length, X);
    ritz_eval(&k->across, 0, y / k->plate.width, Y);
    for (int i = k->n - 1; i >= 0; i--) {
        sum_across(k, k->mode + (size_t)i * k->n, Y, row);
        sum += response(k, i, alpha, t) * sum_along(k, X, row);
    }
    return q * k->deflection_scale * sum;
}

double kirchhoff_static(const struct kirchhoff *k, double q, double x, double y)
{
    return kirchhoff_transient(k, q, 0, INFINITY, x, y);
}

/* Fills out[ny][nx] = scale sum c_ab X_a(x) Y_b(y), derivatives of order dx and dy. Behind
 * the coefficients c has room for ny sums across the plate. */
static void tabulate(const struct kirchhoff *k, double *c, double scale, int dx, int dy,
                     int nx, const double *x, int ny, const double *y, double *out)
{
    double X[RITZ_MAX], Y[RITZ_MAX], *row = c + k->n;
    const int count = k->along.count;

    for (int j = 0; j < ny; j++) {
        ritz_eval(&k->across, dy, y[j] / k->plate.width, Y);
        sum_across(k, c, Y, row + j * count);
    }
    for (int i = 0; i < nx; i++) {
        ritz_eval(&k->along, dx, x[i] / k->plate.length, X);
        for (int j = 0; j < ny; j++)
            out[j * nx + i] = scale * sum_along(k, X, row + j * count);
    }
}

enum status kirchhoff_grid(const struct kirchhoff *k, double q, double alpha, double t,
                           int nx, const double *x, int ny, const double *y, double *w,
                           double *w_x, double *w_y)
{
    const double scale = q * k->deflection_scale;
    double *c = table((size_t)k->n + (size_t)ny * k->along.count); /* of w / scale */

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

enum status kirchhoff_field_plate(const struct scene *scene, struct kirchhoff_plate *plate,
                                  struct message *why)
{
    /* The rounding of axes given with 16 digits. */
    const double in_plane = 1e-14 * sqrt(vector_dot(scene->gravity, scene->gravity));

    if (scene->shape != SCENE_FLAT)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth knows flat sheets only");
    if (!scene_is_cantilever(scene))
        return status_fail(
            why, STATUS_UNSUPPORTED,
            "the Kirchhoff truth knows one sheet with one support, the whole "
            "edge u = 0");
    if (fabs(vector_dot(scene->gravity, scene->axis_u)) > in_plane ||
        fabs(vector_dot(scene->gravity, scene->axis_v)) > in_plane)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth needs gravity normal to the sheet");
    if (scene->obstacle_count || scene->load_count || scene->drag != 0 ||
        scene->air.density > 0)
        return status_fail(
            why, STATUS_UNSUPPORTED,
            "the Kirchhoff truth knows no obstacles, no loads, no drag and no air");
    if (scene_needs(scene) & SCENE_NEED_INITIAL_MOTION)
        return status_fail(why, STATUS_UNSUPPORTED, "the Kirchhoff truth begins at rest");
    if (scene->damping.kind != DAMPING_NONE && scene->damping.kind != DAMPING_MASS)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth knows mass damping only");
    if (scene->is_fabric)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth is of isotropic sheets");
    if (scene->poisson < 0)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the Kirchhoff truth is verified for 0 <= nu < 0.5 only");
    *plate = (struct kirchhoff_plate){.length = scene->length,
                                      .width = scene->width,
                                      .thickness = scene->thickness,
                                      .young = scene->young,
                                      .poisson = scene->poisson,
                                      .density = scene->density};
    return STATUS_OK;
}

static enum status sample(const struct kirchhoff *k, const struct scene *scene, double t,
                          double *xyz)
{
    enum status st;
    static const double half[GRID_W] = {-0.5, 0.5};
    double w[GRID_V][GRID_U], wx[GRID_V][GRID_U], wy[GRID_V][GRID_U]; /* 240 kB */
    double x[GRID_U], y[GRID_V], n[3];

    scene_normal(scene, n);
    const double q = scene->density * scene->thickness * vector_dot(scene->gravity, n);
    const double alpha = scene->damping.kind == DAMPING_MASS ? scene->damping.value : 0;
    for (int i = 0; i < GRID_U; i++)
        x[i] = scene->length * i / (GRID_U - 1);
    for (int j = 0; j < GRID_V; j++)
        y[j] = scene->width * j / (GRID_V - 1);
    TRY(kirchhoff_grid(k, q, alpha, t, GRID_U, x, GRID_V, y, w[0], wx[0], wy[0]));
    for (int p = 0; p < GRID_POINTS; p++) {
        int i = p % GRID_U, j = p / GRID_U % GRID_V;
        double uvw[3], z = half[p / (GRID_U * GRID_V)] * scene->thickness;
        grid_point(p, uvw);
        scene_rest_point(scene, uvw, xyz + 3 * p);
        for (int c = 0; c < 3; c++)
            xyz[3 * p + c] += w[j][i] * n[c] - z * (wx[j][i] * scene->axis_u[c] +
                                                    wy[j][i] * scene->axis_v[c]);
    }
out:
    return st;
}

enum status kirchhoff_field(const struct scene *scene, int terms, int times,
                            const double *time, double *const *xyz, struct message *why)
{
    struct kirchhoff_plate plate;
    struct kirchhoff *k = NULL;
    enum status st;

    TRY(kirchhoff_field_plate(scene, &plate, why));
    TRY(kirchhoff_create(&plate, terms, &k));
    for (int n = 0; n < times; n++)
        TRY(sample(k, scene, time[n], xyz[n]));
out:
    kirchhoff_destroy(k);
    return st;
}

/* Kirchhoff plate, one edge clamped: closed forms at nu = 0, frequencies computed
 * elsewhere, convergence of the series, energy and orthogonality. */
#include "fem_ref/kirchhoff.h"
#include "fem_ref/reference.h"
#include "fem_ref/ritz.h"
#include "models/linalg/gauss.h"
#include "tests/check.h"

/* Sums of a few thousand terms of order 1, conditioned like terms^2. */
#define TOL_CLOSED 1e-10

/* The plate of scene cantilever_transient. */
static const struct kirchhoff_plate sheet = {.length = 1,
                                             .width = 1,
                                             .thickness = 0.001177,
                                             .young = 1e5,
                                             .poisson = 0.3,
                                             .density = 0.5};
static const double times[] = {0.1, 0.2, 0.3, 0.4};
enum { TIMES = 4, SIDE = 21 };

static double stiffness(const struct kirchhoff_plate *p)
{
    return p->young * pow(p->thickness, 3) / (12 * (1 - p->poisson * p->poisson));
}

static double weight(const struct kirchhoff_plate *p)
{
    return -9.81 * p->density * p->thickness;
}

static struct kirchhoff *make(const struct kirchhoff_plate *p, int terms)
{
    struct kirchhoff *k = NULL;
    REQUIRE(kirchhoff_create(p, terms, &k) == STATUS_OK);
    return k;
}

/* ------------------------------------------------------------- one direction ------- */

/* Integrals against Gauss, 6 panels of 16 points: exact for the degrees used here. */
static void check_ritz(enum ritz_end end)
{
    enum { COUNT = 12 };
    struct ritz r;
    double x[16], w[16], f[3][COUNT], sum[3][3][COUNT][COUNT] = {0}, mean[COUNT] = {0};

    gauss_rule(16, x, w);
    REQUIRE(ritz_init(&r, end, COUNT) == STATUS_OK);
    for (int g = 0; g < 16; g++) {
        for (int d = 0; d < 3; d++)
            ritz_eval(&r, d, x[g], f[d]);
        for (int i = 0; i < COUNT; i++)
            mean[i] += w[g] * f[0][i];
        for (int n = 0; n < 9 * COUNT * COUNT; n++) {
            int a = n / 3 % 3, b = n % 3, i = n / 9 / COUNT, j = n / 9 % COUNT;
            sum[a][b][i][j] += w[g] * f[a][i] * f[b][j];
        }
    }
    for (int n = 0; n < 9 * COUNT * COUNT; n++) {
        int a = n / 3 % 3, b = n % 3, i = n / 9 / COUNT, j = n / 9 % COUNT;
        CHECK_NEAR(ritz_product(&r, a, i, b, j), sum[a][b][i][j], TOL_CLOSED);
    }
    for (int i = 0; i < COUNT; i++) {
        CHECK_NEAR(ritz_integral(&r, i), mean[i], TOL_CLOSED);
        if (end == RITZ_CLAMPED_FREE || i > 1)
            CHECK_NEAR(ritz_product(&r, 2, i, 2, i), 1, TOL_CLOSED);
    }
    if (end == RITZ_CLAMPED_FREE) {
        ritz_eval(&r, 0, 0, f[0]);
        ritz_eval(&r, 1, 0, f[1]);
        for (int i = 0; i < COUNT; i++) {
            CHECK_NEAR(f[0][i], 0, TOL_CLOSED);
            CHECK_NEAR(f[1][i], 0, TOL_CLOSED);
        }
    }
    ritz_clear(&r);
}

/* ------------------------------------------------------------- nu = 0: a beam ------- */

/* Root n = 1, 2, ... of cos(b) cosh(b) = -1, as cos(b) = -1 / cosh(b). */
static double beam_root(int n)
{
    double b = (n - 0.5) * acos(-1);
    for (int i = 0; i < 50; i++)
        b -= (cos(b) + 1 / cosh(b)) / (-sin(b) - tanh(b) / cosh(b));
    return b;
}

/* Clamped-free beam function cosh - cos - s (sinh - sin) at x, mean square 1; `load` is
 * its mean. Written with decaying exponentials only: cosh and sinh overflow and cancel. */
static double beam_mode(int n, double x, double *load)
{
    const double b = beam_root(n), e = exp(-b);
    const double top = e + cos(b) + sin(b), bottom = 1 + e * e + 2 * e * cos(b);
    const double s = 1 - 2 * e * top / bottom;
    *load = 2 * s / b;
    return top / bottom * exp(b * (x - 1)) + (1 + s) * exp(-b * x) / 2 - cos(b * x) +
           s * sin(b * x);
}

static double beam_transient(const struct kirchhoff_plate *p, double t, double x)
{
    const double D = stiffness(p), m = p->density * p->thickness;
    double sum = 0, load;

    for (int n = 400; n >= 1; n--) { /* the tail goes as n^-5 */
        double b = beam_root(n), omega = b * b * sqrt(D / m);
        double mode = beam_mode(n, x, &load), half = sin(omega * t / 2);
        sum += 2 * half * half * load * mode * weight(p) / (m * omega * omega);
    }
    return sum;
}

static void check_beam(void)
{
    static const int uniform[] = {0, 2, 6}; /* modes that do not vary across (leissa) */
    struct kirchhoff_plate p = sheet;
    p.poisson = 0;
    struct kirchhoff *k = make(&p, KIRCHHOFF_TERMS);
    const double D = stiffness(&p), unit = sqrt(D / (p.density * p.thickness));

    CHECK_NEAR(kirchhoff_static(k, D, 1, 0), 0.125, TOL_CLOSED);
    for (double x = 0; x <= 1; x += 0.125)
        CHECK_NEAR(kirchhoff_static(k, D, x, 0.3), x * x * (x * x - 4 * x + 6) / 24,
                   TOL_CLOSED);
    for (int i = 0; i < 3; i++) {
        double b = beam_root(i + 1);
        CHECK_RELATIVE(kirchhoff_frequency(k, uniform[i]), b * b * unit, TOL_CLOSED);
    }
    for (int i = 0; i < TIMES; i++) {
        enum { POINTS = 33 };
        double sum = 0, most = fabs(beam_transient(&p, times[i], 1));
        for (int n = 0; n < POINTS; n++) {
            double x = n / (POINTS - 1.0);
            double error = kirchhoff_transient(k, weight(&p), 0, times[i], x, 0.8) -
                           beam_transient(&p, times[i], x);
            sum += error * error;
        }
        CHECK_NEAR(sqrt(sum / POINTS) / most, 0, KIRCHHOFF_TRANSIENT_ERROR);
    }
    kirchhoff_destroy(k);
}

/* ------------------------------------------------------------- frequencies ---------- */

/* The table's n = 24 values are upper bounds with 8 digits. The error falls as a power of
 * n, slowest for nu = 0.49, about n^-1.5: e(24) = (e(20) - e(24)) / (1.2^1.5 - 1) = 3.2
 * steps. */
static double allowed(double step, double lambda)
{
    return 4 * step + 1e-7 * lambda;
}

static void check_frequencies(void)
{
    struct reference *t = NULL;
    struct kirchhoff *k = NULL;
    double nu = NAN, width = NAN;
    int found = 0;

    REQUIRE(!reference_open(REFERENCE_DIR "/leissa_plate_frequencies.csv", &t, NULL));
    for (int row = reference_find(t, 0, "bc", "CFFF"); row >= 0;
         row = reference_find(t, row + 1, "bc", "CFFF"), found++) {
        if (nu != reference_number(t, row, "nu") ||
            width != reference_number(t, row, "Ly")) {
            nu = reference_number(t, row, "nu"), width = reference_number(t, row, "Ly");
            kirchhoff_destroy(k); /* in other units than the table's */
            struct kirchhoff_plate p = {2, 2 * width, 0.01, 3, nu, 7};
            k = make(&p, 28);
        }
        struct kirchhoff_plate p = {2, 2 * width, 0.01, 3, nu, 7};
        double unit = sqrt(stiffness(&p) / (p.density * p.thickness)) / 4;
        double lambda = reference_number(t, row, "lambda");
        const double TOL_TABLE = allowed(reference_number(t, row, "est_err"), lambda);
        int mode = (int)reference_number(t, row, "mode") - 1;
        CHECK_NEAR(kirchhoff_frequency(k, mode) / unit, lambda, TOL_TABLE);
    }
    CHECK(found >= 24);
    kirchhoff_destroy(k);
    reference_close(t);
}

/* ------------------------------------------------------------- nu = 0.3 ------------- */

static void sample(const struct kirchhoff *k, double t, double w[SIDE * SIDE])
{
    static double wx[SIDE * SIDE], wy[SIDE * SIDE];
    double x[SIDE];
    for (int i = 0; i < SIDE; i++)
        x[i] = i / (SIDE - 1.0);
    REQUIRE(!kirchhoff_grid(k, weight(&sheet), 0, t, SIDE, x, SIDE, x, w, wx, wy));
}

/* What kirchhoff.h claims: the answer with KIRCHHOFF_TERMS against one with more.
 */
static void check_convergence(const struct kirchhoff *k)
{
    struct kirchhoff *fine = make(&sheet, KIRCHHOFF_TERMS + 8);
    const double D = stiffness(&sheet);
    /* two outside values, cut after 6 decimals */
    const double TOL_PRINTED = 1e-6, TOL_STATIC = KIRCHHOFF_ERROR * 0.129;
    static double a[SIDE * SIDE], b[SIDE * SIDE];

    CHECK_NEAR(kirchhoff_static(k, D, 1, 0), 0.127235, TOL_PRINTED);
    CHECK_NEAR(kirchhoff_static(k, D, 1, 0.5), 0.129074, TOL_PRINTED);
    CHECK_NEAR(kirchhoff_static(k, D, 1, 0), kirchhoff_static(fine, D, 1, 0), TOL_STATIC);
    CHECK_NEAR(kirchhoff_static(k, D, 1, 1), kirchhoff_static(fine, D, 1, 0), TOL_STATIC);
    CHECK_NEAR(kirchhoff_static(k, D, 1, 0.5), kirchhoff_static(fine, D, 1, 0.5),
               TOL_STATIC);
    printf("q L^4/D: corner %.10f (%d) %.10f (%d), mid edge %.10f %.10f\n",
           kirchhoff_static(k, D, 1, 0), KIRCHHOFF_TERMS, kirchhoff_static(fine, D, 1, 0),
           KIRCHHOFF_TERMS + 8, kirchhoff_static(k, D, 1, 0.5),
           kirchhoff_static(fine, D, 1, 0.5));
    for (int i = 0; i < TIMES; i++) {
        double sum = 0, most = 0;
        sample(k, times[i], a);
        sample(fine, times[i], b);
        for (int n = 0; n < SIDE * SIDE; n++) {
            sum += (a[n] - b[n]) * (a[n] - b[n]);
            most = fmax(most, fabs(b[n]));
        }
        double rms = sqrt(sum / (SIDE * SIDE)) / most;
        printf("t = %.1f s: largest deflection %.6f m, %d against %d functions %.1e\n",
               times[i], most, KIRCHHOFF_TERMS, KIRCHHOFF_TERMS + 8, rms);
        CHECK_NEAR(rms, 0, KIRCHHOFF_TRANSIENT_ERROR);
    }
    kirchhoff_destroy(fine);
}

/* Undamped: kinetic + elastic + potential = 0. Damped: its rate is -2 alpha kinetic, also
 * where the lowest modes creep (alpha / 2 > omega) while the others swing. */
static void check_energy(const struct kirchhoff *k)
{
    static const double alphas[] = {0.5, 2, 60};
    const double q = weight(&sheet), t = 0.3;
    struct energy e, before, after;

    for (int i = 0; i < TIMES; i++) {
        REQUIRE(!kirchhoff_energy(k, q, 0, times[i], &e));
        const double TOL_ENERGY = TOL_CLOSED * fabs(e.potential);
        CHECK(e.kinetic > 0 && e.elastic > 0 && e.potential < 0);
        CHECK_NEAR(e.kinetic + e.elastic, -e.potential, TOL_ENERGY);
    }
    for (int i = 0; i < 3; i++) {
        const double step =
            1e-5; /* the energy's rate is smooth: error (omega step)^2 / 6 */
        const double TOL_RATE = 1e-4;
        double rate = 0;
        REQUIRE(!kirchhoff_energy(k, q, alphas[i], t - step, &before));
        REQUIRE(!kirchhoff_energy(k, q, alphas[i], t + step, &after));
        REQUIRE(!kirchhoff_energy(k, q, alphas[i], t, &e));
        rate += (after.kinetic - before.kinetic) / (2 * step);
        rate += (after.elastic - before.elastic) / (2 * step);
        rate += (after.potential - before.potential) / (2 * step);
        CHECK_RELATIVE(rate, -2 * alphas[i] * e.kinetic, TOL_RATE);
    }
    const double still = kirchhoff_static(k, q, 1, 0);
    CHECK_RELATIVE(kirchhoff_transient(k, q, 2, 400, 1, 0), still, TOL_CLOSED);
    CHECK_RELATIVE(kirchhoff_transient(k, q, 60, 1e5, 1, 0), still, TOL_CLOSED);
}

static void check_modes(const struct kirchhoff *k)
{
    enum { MODES = 6, PANELS = 3, POINTS = 16 * PANELS };
    double x[POINTS], w[POINTS], product[MODES][MODES] = {0};

    gauss_rule(16, x, w);
    for (int i = POINTS - 1; i >= 0; i--) {
        x[i] = (x[i % 16] + i / 16) / PANELS;
        w[i] = w[i % 16] / PANELS;
    }
    for (int n = 0; n < POINTS * POINTS; n++) {
        double f[MODES], weight_here = w[n % POINTS] * w[n / POINTS];
        for (int i = 0; i < MODES; i++)
            f[i] = kirchhoff_mode(k, i, x[n % POINTS], x[n / POINTS]);
        for (int i = 0; i < MODES; i++)
            for (int j = 0; j < MODES; j++)
                product[i][j] += weight_here * f[i] * f[j];
    }
    /* K-orthonormal vectors have the M-products of modes i, j to round-off of the largest
     * mu, scaled here by 1 / sqrt(mu_i mu_j): (27.2 / 3.47)^2 times worse. */
    const double TOL_MODES = 100 * TOL_CLOSED;
    for (int i = 0; i < MODES; i++)
        for (int j = 0; j < MODES; j++)
            CHECK_NEAR(product[i][j], i == j, TOL_MODES);
}

int main(void)
{
    check_ritz(RITZ_CLAMPED_FREE);
    check_ritz(RITZ_FREE_FREE);
    check_beam();
    check_frequencies();
    struct kirchhoff *k = make(&sheet, KIRCHHOFF_TERMS);
    check_convergence(k);
    check_energy(k);
    check_modes(k);
    kirchhoff_destroy(k);
    return check_result();
}

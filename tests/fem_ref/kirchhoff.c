/* Kirchhoff plate, one edge clamped: closed forms at nu = 0, lowest frequencies computed
 * elsewhere, convergence of the series. */
#include "fem_ref/kirchhoff.h"
#include "fem_ref/reference.h"
#include "models/linalg/gauss.h"
#include "tests/check.h"

#include <complex.h>

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

/* 1 - (r e^(p t) - p e^(r t)) / (r - p) with the roots p and r of x^2 + alpha x + omega^2.
 */
static double step_response(double omega, double alpha, double t)
{
    const double complex root = csqrt(alpha * alpha / 4 - omega * omega);
    const double complex r = -alpha / 2 + root, p = -alpha / 2 - root;

    return creal(1 - (r * cexp(p * t) - p * cexp(r * t)) / (r - p));
}

static double beam_transient(const struct kirchhoff_plate *p, double alpha, double t,
                             double x)
{
    const double D = stiffness(p), m = p->density * p->thickness;
    double sum = 0, load;

    for (int n = 400; n >= 1; n--) { /* the tail goes as n^-5 */
        double b = beam_root(n), omega = b * b * sqrt(D / m);
        double mode = beam_mode(n, x, &load);
        sum +=
            step_response(omega, alpha, t) * load * mode * weight(p) / (m * omega * omega);
    }
    return sum;
}

/* Undamped; and damped so that all modes swing, the first creeps, or the first four do. */
static void check_beam(void)
{
    static const double alphas[] = {0, 0.5, 2, 60};
    enum { POINTS = 33 };
    struct kirchhoff_plate p = sheet;
    p.poisson = 0;
    struct kirchhoff *k = make(&p, KIRCHHOFF_TERMS);
    const double D = stiffness(&p), q = weight(&p);

    CHECK_NEAR(kirchhoff_static(k, D, 1, 0), 0.125, TOL_CLOSED);
    for (double x = 0; x <= 1; x += 0.125)
        CHECK_NEAR(kirchhoff_static(k, D, x, 0.3), x * x * (x * x - 4 * x + 6) / 24,
                   TOL_CLOSED);
    for (int n = 0; n < 4 * TIMES; n++) {
        const double alpha = alphas[n / TIMES], t = times[n % TIMES];
        double sum = 0, most = fabs(beam_transient(&p, alpha, t, 1));
        for (int i = 0; i < POINTS; i++) {
            double x = i / (POINTS - 1.0);
            double error = kirchhoff_transient(k, q, alpha, t, x, 0.8) -
                           beam_transient(&p, alpha, t, x);
            sum += error * error;
        }
        CHECK_NEAR(sqrt(sum / POINTS) / most, 0, KIRCHHOFF_TRANSIENT_ERROR);
    }
    CHECK_RELATIVE(kirchhoff_transient(k, q, 60, 1e5, 1, 0), kirchhoff_static(k, q, 1, 0),
                   TOL_CLOSED);
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

/* The lowest frequency, in units of 1 / s of the plate: under this much damping the first
 * mode creeps, and from t = 3 on the others have ended (e^-30). */
static double lowest(const struct kirchhoff *k, double unit)
{
    const double alpha = 20 * unit, still = kirchhoff_static(k, 1, 2, 0);
    const double rate = log((still - kirchhoff_transient(k, 1, alpha, 3 / unit, 2, 0)) /
                            (still - kirchhoff_transient(k, 1, alpha, 4 / unit, 2, 0))) *
                        unit;

    return sqrt(alpha * rate - rate * rate) / unit;
}

static void check_frequencies(void)
{
    struct reference *t = NULL;
    int found = 0;

    REQUIRE(!reference_open(REFERENCE_DIR "/leissa_plate_frequencies.csv", &t, NULL));
    for (int row = reference_find(t, 0, "bc", "CFFF"); row >= 0;
         row = reference_find(t, row + 1, "bc", "CFFF")) {
        if (reference_number(t, row, "mode") != 1)
            continue;
        const struct kirchhoff_plate p = {2, 2 * reference_number(t, row, "Ly"), 0.01,
                                          3, reference_number(t, row, "nu"),     7};
        struct kirchhoff *k = make(&p, 28);
        const double lambda = reference_number(t, row, "lambda");
        const double TOL_TABLE = allowed(reference_number(t, row, "est_err"), lambda);
        const double unit = sqrt(stiffness(&p) / (p.density * p.thickness)) / 4;
        CHECK_NEAR(lowest(k, unit), lambda, TOL_TABLE);
        kirchhoff_destroy(k);
        found++;
    }
    CHECK(found == 9);
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

/* Holds the answer with KIRCHHOFF_TERMS against one with more. */
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

int main(void)
{
    check_ritz(RITZ_CLAMPED_FREE);
    check_ritz(RITZ_FREE_FREE);
    check_beam();
    check_frequencies();
    struct kirchhoff *k = make(&sheet, KIRCHHOFF_TERMS);
    check_convergence(k);
    kirchhoff_destroy(k);
    return check_result();
}

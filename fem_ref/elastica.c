#include "fem_ref/elastica.h"

#include <math.h>

/* The degree of the series. A step is a quarter of the solution's length scale 1 / (1 +
 * sqrt(tau)): terms fall like 4^-k / k!^(1/2) or faster, to nothing at 24. */
enum { DEGREE = 24 };

struct state {
    double tau, psi, slope;
    double across, down; /* integrals of sin psi and cos psi from the tip */
};

/* Computes Taylor coefficients of psi, sin psi, cos psi about the state, by psi'' = tau sin
 * psi, (sin psi)' = psi' cos psi, (cos psi)' = -psi' sin psi. */
static void series(const struct state *a, double psi[], double sine[], double cosine[])
{
    psi[0] = a->psi, psi[1] = a->slope;
    sine[0] = sin(a->psi), cosine[0] = cos(a->psi);
    for (int k = 0; k < DEGREE; k++) {
        double s = 0, c = 0;
        for (int j = 0; j <= k; j++) {
            s += (j + 1) * psi[j + 1] * cosine[k - j];
            c -= (j + 1) * psi[j + 1] * sine[k - j];
        }
        sine[k + 1] = s / (k + 1);
        cosine[k + 1] = c / (k + 1);
        psi[k + 2] =
            (a->tau * sine[k] + (k > 0 ? sine[k - 1] : 0)) / ((k + 1.0) * (k + 2.0));
    }
}

static void step(struct state *a, double h)
{
    double psi[DEGREE + 2], sine[DEGREE + 1], cosine[DEGREE + 1];
    double value = 0, slope = 0, across = 0, down = 0;

    series(a, psi, sine, cosine);
    for (int k = DEGREE; k >= 0; k--) {
        value = value * h + psi[k];
        slope = slope * h + (k + 1) * psi[k + 1];
        across = across * h + sine[k] / (k + 1);
        down = down * h + cosine[k] / (k + 1);
    }
    a->tau += h;
    a->psi = value;
    a->slope = slope;
    a->across += across * h;
    a->down += down * h;
}

/* Returns the longest step from here. */
static double reach_of(const struct state *a)
{
    return 0.25 / (1 + sqrt(a->tau));
}

static void march(struct state *a, double end)
{
    while (a->tau < end)
        step(a, fmin(end - a->tau, reach_of(a)));
}

/* Integrates from the tip to tau = end; true if psi has passed pi/2 for good before. */
static bool shoot(double log_psi, double end, struct state *a)
{
    *a = (struct state){.psi = exp(log_psi)};
    while (a->tau < end) {
        double h = reach_of(a), left = end - a->tau;
        if (a->psi > 2) /* psi grows as long as it is below pi */
            return true;
        step(a, left < 1.5 * h ? left : h);
        if (left < 1.5 * h)
            break;
    }
    return a->psi > acos(0);
}

/* Returns log psi(0), from below. */
static double aim(double gamma)
{
    double low = -sqrt(gamma) - 5, high = log(acos(0)); /* brackets it */
    struct state a;

    for (double middle; middle = (low + high) / 2, low < middle && middle < high;) {
        if (shoot(middle, cbrt(gamma), &a))
            high = middle;
        else
            low = middle;
    }
    return low;
}

static bool is_known(double gamma)
{
    return gamma >= ELASTICA_MIN && gamma <= ELASTICA_MAX;
}

enum status elastica_curve(double gamma, int count, const double *s,
                           struct elastica_point *point)
{
    const double end = cbrt(gamma);
    struct state a;

    if (!is_known(gamma))
        return STATUS_INPUT;
    a = (struct state){.psi = exp(aim(gamma))};
    for (int n = count - 1; n >= 0; n--) {
        march(&a, end * (1 - s[n]));
        point[n] = (struct elastica_point){a.across, a.down, acos(0) - a.psi};
    }
    march(&a, end);
    for (int n = 0; n < count; n++) {
        point[n].reach = (a.across - point[n].reach) / end;
        point[n].drop = (a.down - point[n].drop) / end;
    }
    return STATUS_OK;
}

enum status elastica_solve(double gamma, struct elastica_point *tip)
{
    return elastica_curve(gamma, 1, (double[]){1}, tip);
}

/* Computes the complete elliptic integrals K and E of modulus k (arithmetic-geometric
 * mean). */
static void elliptic(double k, double *K, double *E)
{
    double a = 1, b = sqrt(1 - k * k), sum = k * k / 2, power = 1;

    for (int n = 0; n < 40 && fabs(a - b) > 1e-16 * a; n++) {
        const double c = (a - b) / 2, mean = (a + b) / 2;
        b = sqrt(a * b), a = mean;
        sum += power * c * c;
        power *= 2;
    }
    *K = acos(0) / a;
    *E = *K * (1 - sum);
}

double elastica_buckled(double shortening)
{
    double low = 0, high = 1, K, E;

    if (!(shortening > 0 && shortening <= 0.9))
        return NAN;
    for (double k; k = (low + high) / 2, low < k && k < high;) {
        elliptic(k, &K, &E);
        if (2 - 2 * E / K < shortening)
            low = k;
        else
            high = k;
    }
    elliptic(low, &K, &E);
    return low / K;
}

/* Steps of the coarser of two integrations; tries of Newton's method and of the bisection,
 * both up to round-off. */
enum { STEPS = 200, NEWTON = 12, HALVES = 50 };

/* A change of the curvature that is round-off, over the curvature. */
static const double ROUNDING = 1e-14;

/* Improves the curvatures k (k_uu, k_vv, 2 k_uv) under the moments (moment, 0, 0). */
static void bend(const struct law *law, double moment, double k[3])
{
    const double *B = law->matrix[LAW_BENDING];

    for (int n = 0; n < NEWTON; n++) {
        double left[3], change[3], tangent[LAW_ENTRIES], inverse[LAW_ENTRIES];
        law_stress(B, k, left);
        left[0] -= moment;
        for (int e = 0; e < LAW_ENTRIES; e++)
            tangent[e] = B[e];
        for (int d = 0; d < 2; d++) {
            const double *a = law->along[d];
            double more, at = a[0] * k[0] + a[1] * k[1] + a[2] * k[2];
            const double pull = law_soft_moment(&law->soft[d], at, &more);
            for (int i = 0, e = 0; i < 3; i++) {
                left[i] += pull * a[i];
                for (int j = i; j < 3; j++, e++)
                    tangent[e] += more * a[i] * a[j];
            }
        }
        law_invert(tangent, inverse);
        law_stress(inverse, left, change);
        for (int i = 0; i < 3; i++)
            k[i] -= change[i];
        if (fabs(change[0]) <= ROUNDING * fabs(k[0]))
            return;
    }
}

/* Integrates from the tip at a slope to the root; returns the slope there. */
static double shoot_soft(const struct law *law, double weight, double slope, int steps,
                         struct elastica_point *tip)
{
    const double step = 1. / steps;
    double moment = 0, k[3] = {0};

    *tip = (struct elastica_point){.angle = slope};
    for (int n = 0; n < steps; n++) {
        const double here = weight * (n + 0.5) * step;
        bend(law, moment, k);
        const double half = slope - k[0] * step / 2;
        bend(law, moment + here * cos(slope) * step / 2, k);
        moment += here * cos(half) * step;
        slope -= k[0] * step;
        tip->reach += cos(half) * step, tip->drop += sin(half) * step;
    }
    return slope;
}

static void solve(const struct law *law, double weight, int steps,
                  struct elastica_point *tip)
{
    double low = 0, high = acos(0);

    for (int n = 0; n < HALVES; n++) {
        const double middle = (low + high) / 2;
        *(shoot_soft(law, weight, middle, steps, tip) < 0 ? &low : &high) = middle;
    }
}

double elastica_soft(const struct law *law, double weight, struct elastica_point *tip)
{
    struct elastica_point coarse;

    solve(law, weight, STEPS, &coarse);
    solve(law, weight, 2 * STEPS, tip);
    return hypot(tip->reach - coarse.reach, tip->drop - coarse.drop);
}

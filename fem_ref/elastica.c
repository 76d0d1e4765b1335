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

#include "models/linalg/gauss.h"

#include <assert.h>
#include <math.h>
#include <stdbool.h>

/* Evaluates P_n(t) and P_n'(t), |t| < 1, by the three-term recurrence. */
static double legendre(int n, double t, double *slope)
{
    double before = 1.0, now = t;
    for (int k = 2; k <= n; k++) {
        double next = ((2 * k - 1) * t * now - (k - 1) * before) / k;
        before = now;
        now = next;
    }
    *slope = n * (before - t * now) / ((1.0 - t) * (1.0 + t));
    return now;
}

void gauss_rule(int n, double *x, double *w)
{
    const double pi = acos(-1.0);
    assert(1 <= n && n <= GAUSS_MAX);
    for (int i = 0; i < (n + 1) / 2; i++) {
        /* Tricomi's first guess is within Newton's reach of the i-th root from the right;
         * the middle root of an odd rule is zero exactly. */
        double slope = 0.0;
        double t = (1.0 - (n - 1.0) / (8.0 * n * n * n)) * cos(pi * (i + 0.75) / (n + 0.5));
        bool middle = 2 * i + 1 == n;
        if (middle)
            t = 0.0;
        for (int step = 0; step < 8 && !middle; step++) {
            double value = legendre(n, t, &slope);
            t -= value / slope;
        }
        legendre(n, t, &slope);
        double weight =
            1.0 / ((1.0 - t) * (1.0 + t) * slope * slope); /* half of [-1,1]'s */
        x[i] = 0.5 * (1.0 - t);
        x[n - 1 - i] = 0.5 * (1.0 + t);
        w[i] = w[n - 1 - i] = weight;
    }
}

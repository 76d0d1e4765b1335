#include "fem_ref/elastica_soft.h"

#include <math.h>

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
static double shoot(const struct law *law, double weight, double slope, int steps,
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
        *(shoot(law, weight, middle, steps, tip) < 0 ? &low : &high) = middle;
    }
}

double elastica_soft(const struct law *law, double weight, struct elastica_point *tip)
{
    struct elastica_point coarse;

    solve(law, weight, STEPS, &coarse);
    solve(law, weight, 2 * STEPS, tip);
    return hypot(tip->reach - coarse.reach, tip->drop - coarse.drop);
}

#include "models/net/hinge_rule.h"

#include <math.h>

/* The most of A and C that z may be: beyond, a rule has no stiffnesses above 0. */
static const double MOST = 0.9;

/* Returns the stiffness at a clamp of edges that bend with P, over those of the net. There
 * y is 0 in the held row and differs from that of an even moment by lambda^n in row n,
 * where lambda + 1/lambda = -(2 + 4 Q/R). The angle over the held row is that of half a
 * cell if
 *
 *     1/k = (1/P + 1/(Q + R)) / 2 + lambda / (1 - lambda) / (Q + R).
 */
static double held(double P, double Q, double R)
{
    const double t = -(2 + 4 * Q / R), lambda = (t + sqrt(t * t - 4)) / 2;

    return 1 / ((1 / P + 1 / (Q + R)) / 2 + lambda / (1 - lambda) / (Q + R));
}

struct hinge_rule hinge_rule_of(const double bending[LAW_ENTRIES], double a, double b)
{
    const double A = bending[LAW_11] * b * b * b * b, C = bending[LAW_22] * a * a * a * a;
    const double G = (2 * bending[LAW_12] + 4 * bending[LAW_33]) * a * a * b * b;
    const double right = (sqrt(G * G + 12 * A * C) - G) / 6, most = MOST * fmin(A, C);
    const double z = fmin(right, most), sum = A * C - z * z;
    const double P = sum / (C - z), Q = sum / (A - z), R = sum / z;

    return (struct hinge_rule){.u = Q / (a * a * a * b),
                               .v = P / (a * b * b * b),
                               .diagonal = R / (a * b * (a * a + b * b)),
                               .held_u = held(Q, P, R) / (a * a * a * b),
                               .held_v = held(P, Q, R) / (a * b * b * b),
                               .everywhere = right <= most};
}

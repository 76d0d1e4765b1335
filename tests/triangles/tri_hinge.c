/* The angle between two triangles and its derivatives (triangles/tri_hinge.h), by
 * themselves. */
#include "triangles/tri_hinge.h"

#include "tests/check.h"

/* Sums of some ten products. */
static const double ROUND_OFF = 1e-14;

/* The best of a sweep of central differences, of functions of size 1. */
static const double SWEPT = 1e-9;

/* Two triangles over an edge from the origin along x, the second turned up by `angle`. */
static void fold(double angle, double x[4][3])
{
    const double flat[4][3] = {{0, 0, 0}, {1.3, 0, 0}, {0.4, 0.9, 0}, {0.7, -0.6, 0}};

    memcpy(x, flat, sizeof flat);
    x[3][1] = -0.6 * cos(angle), x[3][2] = 0.6 * sin(angle);
}

/* All angles, whose sign tells the side, wherever the hinge is. */
static void check_angles(void)
{
    for (int n = -31; n <= 31; n++) {
        const double angle = n / 10.;
        double x[4][3], y[4][3];
        fold(angle, x);
        CHECK_NEAR(fabs(tri_hinge_angle((const double(*)[3])x)), fabs(angle), ROUND_OFF);
        if (n)
            CHECK((tri_hinge_angle((const double(*)[3])x) > 0) == (angle < 0));
        for (int k = 0; k < 12; k++) /* a turn of axes, and a shift */
            y[k / 3][k % 3] = x[k / 3][(k + 1) % 3] + 0.5;
        CHECK_NEAR(tri_hinge_angle((const double(*)[3])y),
                   tri_hinge_angle((const double(*)[3])x), 10 * ROUND_OFF);
    }
    const double none[4][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
    CHECK(isnan(tri_hinge_angle(none)));
}

/* Derivatives are those of the angle where nothing is flat; a shift changes nothing. */
static void check_derivatives(double angle)
{
    double x[4][3], g[12], H[12][12], side[2][12], off[2] = {INFINITY, INFINITY}, sum = 0;

    fold(angle, x);
    x[1][1] += 0.2, x[2][2] -= 0.3, x[0][0] += 0.1;
    tri_hinge_gradient((const double(*)[3])x, g);
    tri_hinge_hessian((const double(*)[3])x, H);
    for (double step = 1e-3; step > 1e-7; step /= 4) {
        double worst[2] = {0};
        for (int k = 0; k < 12; k++) {
            double at[2];
            for (int s = 0; s < 2; s++) {
                x[k / 3][k % 3] += s ? 2 * step : -step;
                at[s] = tri_hinge_angle((const double(*)[3])x);
                tri_hinge_gradient((const double(*)[3])x, side[s]);
            }
            x[k / 3][k % 3] -= step;
            worst[0] = fmax(worst[0], fabs((at[1] - at[0]) / (2 * step) - g[k]));
            for (int j = 0; j < 12; j++)
                worst[1] =
                    fmax(worst[1], fabs((side[1][j] - side[0][j]) / (2 * step) - H[k][j]));
        }
        off[0] = fmin(off[0], worst[0]), off[1] = fmin(off[1], worst[1]);
    }
    CHECK_NEAR(off[0], 0, SWEPT);
    CHECK_NEAR(off[1], 0, 10 * SWEPT); /* second derivatives are of size 10 */
    for (int k = 0; k < 12; k++)
        sum += g[k];
    CHECK_NEAR(sum, 0, 10 * ROUND_OFF);
}

int main(void)
{
    check_angles();
    check_derivatives(0.4);
    check_derivatives(-2.2);
    return check_result();
}

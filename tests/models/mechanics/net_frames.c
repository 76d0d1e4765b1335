/* Tests the frames of a net's columns: orthonormal, along the thickness and next to the
 * lines of u, and they turn with the net. */
#include "models/mechanics/frames.h"

#include "models/vector.h"
#include "tests/check.h"

enum { N = 4, M = 3, L = 2, NODES = N * M * L };

static const double ROUND_OFF = 1e-14;

/* A net that is bent along u, sheared and thicker where v is more. */
static void shape(bool legendre, double *x)
{
    for (int a = 0; a < NODES; a++) {
        const double u = a / (M * L), v = a / L % M, w = a % L ? 0.1 * (1 + v) : 0;
        const double up[3] = {-w * sin(0.3 * u), 0, w * cos(0.3 * u)},
                     at[3] = {u + 0.4 * v, v, 0.15 * u * u};
        for (int i = 0; i < 3; i++)
            x[3 * a + i] = legendre && a % L ? up[i] / 2 : at[i] + up[i];
    }
}

/* Turns by a right angle about x: exact. */
static void turn(const double from[3], double to[3])
{
    to[0] = from[0], to[1] = -from[2], to[2] = from[1];
}

static void check_frames(bool legendre)
{
    const int points[] = {N, M, L};
    double x[3 * NODES], y[3 * NODES], Q[NODES][9], R[NODES][9];

    shape(legendre, x);
    for (int a = 0; a < NODES; a++)
        turn(x + 3 * a, y + 3 * a);
    frames_of_net(points, legendre, x, Q);
    frames_of_net(points, legendre, y, R);
    for (int a = 0; a < NODES; a++) {
        double axis[3][3], turned[3], cross[3];
        for (int t = 0; t < 9; t++)
            axis[t % 3][t / 3] = Q[a][t];
        vector_cross(axis[0], axis[1], cross);
        for (int i = 0; i < 3; i++) {
            CHECK_NEAR(cross[i], axis[2][i], ROUND_OFF); /* a rotation, with the next */
            CHECK_NEAR(vector_dot(axis[i], axis[i]), 1, ROUND_OFF);
            turn(axis[i], turned);
            for (int j = 0; j < 3; j++)
                CHECK_NEAR(R[a][3 * j + i], turned[j], ROUND_OFF);
        }
        const double lean = 0.3 * (a / (M * L)); /* of the thickness */
        CHECK_NEAR(axis[2][0], -sin(lean), ROUND_OFF);
        CHECK_NEAR(axis[2][2], cos(lean), ROUND_OFF);
        CHECK_NEAR(axis[0][1], 0, ROUND_OFF); /* lines of u lie in planes of y */
        CHECK(axis[0][0] > 0);
    }
}

/* A net that has folded to a point has the unit matrix. */
static void check_folded(void)
{
    const int points[] = {N, M, L};
    const double x[3 * NODES] = {0};
    double Q[NODES][9];

    frames_of_net(points, false, x, Q);
    for (int t = 0; t < 9 * NODES; t++)
        CHECK(Q[t / 9][t % 9] == (t % 9 % 4 == 0));
}

int main(void)
{
    check_frames(false);
    check_frames(true);
    check_folded();
    return check_result();
}

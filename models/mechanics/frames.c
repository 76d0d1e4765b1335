#include "models/mechanics/frames.h"

#include <math.h>
#include <string.h>

#include "models/vector.h"

static bool normalise(double a[3])
{
    double length = vector_length(a);

    for (int i = 0; i < 3; i++)
        a[i] /= length;
    return length > 0 && isfinite(1 / length);
}

/* Computes e from the column before a to the one behind, `stride` apart; at the ends of a
 * line one of them is a itself. */
static void along(const double *x, long a, int at, int count, long stride, double e[3])
{
    const double *from = x + 3 * (a - (at > 0 ? stride : 0));
    const double *to = x + 3 * (a + (at < count - 1 ? stride : 0));

    for (int i = 0; i < 3; i++)
        e[i] = to[i] - from[i];
}

static bool frame(const int points[3], bool legendre, const double *x, int i, int j,
                  double Q[9])
{
    const long l = points[2], a = ((long)i * points[1] + j) * l;
    double u[3], v[3], w[3], side[3];

    along(x, a, i, points[0], points[1] * l, u);
    along(x, a, j, points[1], l, v);
    vector_cross(u, v, w);
    for (int c = 0; l > 1 && c < 3; c++)
        w[c] = x[3 * (a + (legendre ? 1 : l - 1)) + c] - (legendre ? 0 : x[3 * a + c]);
    if (!normalise(w))
        return false;
    double out = vector_dot(u, w);
    for (int c = 0; c < 3; c++)
        u[c] -= out * w[c];
    if (!normalise(u))
        return false;
    vector_cross(w, u, side);
    for (int c = 0; c < 3; c++)
        Q[3 * c] = u[c], Q[3 * c + 1] = side[c], Q[3 * c + 2] = w[c];
    return true;
}

void frames_of_net(const int points[3], bool legendre, const double *x, double (*Q)[9])
{
    static const double unit[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};

    for (int i = 0; i < points[0]; i++)
        for (int j = 0; j < points[1]; j++, Q += points[2]) {
            if (!frame(points, legendre, x, i, j, Q[0]))
                memcpy(Q[0], unit, sizeof unit);
            for (int k = 1; k < points[2]; k++)
                memcpy(Q[k], Q[0], sizeof *Q);
        }
}

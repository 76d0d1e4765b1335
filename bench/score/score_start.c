#include "bench/score/score_start.h"

#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/grid.h"
#include "models/vector.h"

/* --- vertices out of place ---
 *
 * At the start each vertex is known to be at its material point of the sheet at rest. */

/* Strays are so many times as far off as the median, and by a thousandth of the length;
 * they are a tenth of all at most. */
#define STRAY_TIMES 10
#define STRAY_LEAST 1e-3
#define STRAY_MOST  0.1

static int compare_doubles(const void *a, const void *b)
{
    const double left = *(const double *)a, right = *(const double *)b;

    return (left > right) - (left < right);
}

/* Returns whether a vertex at x is at the point of another stray, each of which is more
 * than `least` off its own. */
static bool stands_at_other(int vertices, const double *point, const double *off,
                            double least, int vertex, const double x[3])
{
    for (int n = 0; n < vertices; n++)
        if (n != vertex && off[n] > least &&
            vector_distance(point + 3L * n, x) < off[vertex] / STRAY_TIMES)
            return true;
    return false;
}

/* Fills the strays among vertices[count], off[count] from point[count][3] [m]. */
static void count_strays(int count, const double *xyz, const double *point,
                         const double *off, double least, struct score_strays *strays)
{
    int *far = strays->vertex;

    for (int n = 0; n < count; n++) {
        if (!(off[n] > least))
            continue;
        if (!strays->count++ || off[n] > off[far[0]])
            far[1] = far[0], far[0] = n;
        else if (strays->count == 2 || off[n] > off[far[1]])
            far[1] = n;
    }
    if (strays->count > STRAY_MOST * count)
        strays->count = 0;
    strays->exchanged = strays->count > 1;
    for (int n = 0; n < count && strays->exchanged; n++)
        strays->exchanged =
            !(off[n] > least) || stands_at_other(count, point, off, least, n, xyz + 3L * n);
}

void score_start_strays(const struct scene *scene, const struct score_net *net,
                        const double *rest, const double *xyz, struct score_strays *strays)
{
    const size_t count = (size_t)net->vertices;
    struct arena own SCOPED(arena_clear) = {0};
    double *off = arena_take(&own, 5 * count, sizeof *off);

    *strays = (struct score_strays){0};
    double *sorted = off + count, *point = sorted + count;
    for (size_t n = 0; n < count; n++) {
        const double *uv = net->uv + 2 * n;
        const bool inside = fmin(uv[0], uv[1]) >= 0 && fmax(uv[0], uv[1]) <= 1;
        score_net_sample(scene->sheets, GRID_U, GRID_V, rest, uv, point + 3 * n);
        off[n] = inside ? vector_distance(point + 3 * n, xyz + 3 * n) : 0;
    }
    memcpy(sorted, off, count * sizeof *off);
    qsort(sorted, count, sizeof *sorted, compare_doubles);
    strays->others = sorted[count / 2] / scene->length;
    count_strays(net->vertices, xyz, point, off,
                 (STRAY_TIMES * strays->others + STRAY_LEAST) * scene->length, strays);
    strays->off = off[strays->vertex[0]] / scene->length;
}

/* --- a turned sheet --- */

/* A first frame is the sheet at rest, turned, if that leaves at most this share of the
 * distance, which is more than a hundredth of the length. */
#define TURN_LEFT  0.02
#define TURN_LEAST 0.01

/* Fills the unit quaternion of the rotation that turns points b into a best (Horn 1987):
 * the eigenvector of the largest eigenvalue. h[3][3] = sum of b_i a_j. */
static void find_rotation(double h[3][3], double q[4])
{
    double m[4][4] = {{h[0][0] + h[1][1] + h[2][2], h[1][2] - h[2][1], h[2][0] - h[0][2],
                       h[0][1] - h[1][0]}},
           value[4];

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[i + 1][j + 1] = h[i][j] + h[j][i] - (i == j ? m[0][0] : 0);
    LAPACKE_dsyevd(LAPACK_ROW_MAJOR, 'V', 'U', 4, *m, 4, value); /* in ascending order */
    for (int i = 0; i < 4; i++)
        q[i] = m[i][3];
}

/* Rotates a vector: q x q*. */
static void rotate(const double q[4], const double x[3], double to[3])
{
    double a[3], b[3];

    vector_cross(q + 1, x, a);
    for (int c = 0; c < 3; c++)
        a[c] += q[0] * x[c];
    vector_cross(q + 1, a, b);
    for (int c = 0; c < 3; c++)
        to[c] = x[c] + 2 * b[c];
}

void score_start_turn(int points, const double *rest, const double *got, double start,
                      double length, struct score_turn *turn)
{
    double mean[2][3] = {{0}}, h[3][3] = {{0}}, q[4], left = 0;

    *turn = (struct score_turn){0};
    for (int n = 0; n < 3 * points; n++) {
        mean[0][n % 3] += rest[n] / points;
        mean[1][n % 3] += got[n] / points;
    }
    for (int n = 0; n < 9 * points; n++) {
        const int i = n % 3, j = n / 3 % 3, at = n / 9 * 3;
        h[i][j] += (rest[at + i] - mean[0][i]) * (got[at + j] - mean[1][j]);
    }
    find_rotation(h, q);
    for (int n = 0; n < points; n++) {
        double from[3], to[3];
        vector_between(mean[0], rest + 3L * n, from);
        rotate(q, from, to);
        for (int c = 0; c < 3; c++)
            left += pow(to[c] + mean[1][c] - got[3 * n + c], 2);
    }
    const double sine = vector_length(q + 1), sign = q[0] < 0 ? -1 : 1;
    if (!(start > TURN_LEAST * length && sqrt(left / points) < TURN_LEFT * start &&
          sine > 0))
        return;
    turn->angle = 2 * atan2(sine, fabs(q[0])) * 180 / acos(-1);
    for (int c = 0; c < 3; c++)
        turn->axis[c] = sign * q[c + 1] / sine;
}

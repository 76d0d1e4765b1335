#include "bench/score/score_start.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* Returns whether a vertex stands at the material point of another stray. */
static bool stands_at_other(const struct score *s, const double *xyz, const double *off,
                            double least, int vertex)
{
    for (int n = 0; n < s->net.vertices; n++) {
        double x[3];
        if (n == vertex || !(off[n] > least))
            continue;
        score_net_sample(s->truth.scene.sheets, GRID_U, GRID_V, s->truth.rest,
                         s->net.uv + 2L * n, x);
        if (vector_distance(x, xyz + 3L * vertex) < off[vertex] / STRAY_TIMES)
            return true;
    }
    return false;
}

/* Fills the strays from off[vertices], whose median is `others`. */
static void count_strays(struct score *s, const double *xyz, const double *off,
                         double others)
{
    const double length = s->truth.scene.length,
                 least = STRAY_TIMES * others + STRAY_LEAST * length;
    struct score_strays *strays = &s->strays;

    *strays = (struct score_strays){.exchanged = true, .others = others / length};
    for (int n = 0; n < s->net.vertices; n++) {
        if (!(off[n] > least))
            continue;
        if (!strays->count++ || off[n] > off[strays->vertex[0]])
            strays->vertex[1] = strays->vertex[0], strays->vertex[0] = n;
        else if (strays->count == 2 || off[n] > off[strays->vertex[1]])
            strays->vertex[1] = n;
    }
    if (strays->count > STRAY_MOST * s->net.vertices)
        strays->count = 0;
    for (int n = 0; n < s->net.vertices && strays->count; n++)
        if (off[n] > least)
            strays->exchanged = strays->exchanged && stands_at_other(s, xyz, off, least, n);
    strays->off = off[strays->vertex[0]] / length;
}

static enum status find_strays(struct score *s, const double *xyz)
{
    const size_t count = (size_t)s->net.vertices;
    double *off = malloc(2 * count * sizeof *off);

    if (!off)
        return STATUS_MEMORY;
    for (size_t n = 0; n < count; n++) {
        const double *uv = s->net.uv + 2 * n;
        double x[3];
        score_net_sample(s->truth.scene.sheets, GRID_U, GRID_V, s->truth.rest, uv, x);
        const bool inside = fmin(uv[0], uv[1]) >= 0 && fmax(uv[0], uv[1]) <= 1;
        off[n] = off[count + n] = inside ? vector_distance(x, xyz + 3 * n) : 0;
    }
    qsort(off + count, count, sizeof *off, compare_doubles);
    if (fabs(s->first) <= SCORE_SAME_TIME && !s->net.by_position)
        count_strays(s, xyz, off, off[count + count / 2]);
    free(off);
    return STATUS_OK;
}

/* --- a turned sheet --- */

/* A first frame is the sheet at rest, turned, if that leaves at most this share of the
 * distance, which is more than a hundredth of the length. */
#define TURN_LEFT  0.02
#define TURN_LEAST 0.01

/* Fills the unit quaternion of the rotation that turns points b into a best (Horn 1987):
 * the eigenvector of the largest eigenvalue, by squaring. h[3][3] = sum of b_i a_j. */
static void find_rotation(double h[3][3], double q[4])
{
    double m[4][4] = {{h[0][0] + h[1][1] + h[2][2], h[1][2] - h[2][1], h[2][0] - h[0][2],
                       h[0][1] - h[1][0]}},
           most = 0, square[4][4];
    int best = 0;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            m[i + 1][j + 1] = h[i][j] + h[j][i] - (i == j ? m[0][0] : 0);
    for (int i = 1; i < 4; i++)
        m[i][0] = m[0][i];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            most += fabs(m[i][j]);
    for (int i = 0; i < 4; i++)
        m[i][i] += most; /* all eigenvalues are positive */
    for (int n = 0; n < 60; n++) {
        double trace = 0;
        for (int i = 0; i < 4; i++)
            trace += m[i][i];
        for (int i = 0; i < 4; i++)
            for (int j = 0; j < 4; j++) {
                square[i][j] = 0;
                for (int k = 0; k < 4; k++)
                    square[i][j] += m[i][k] / trace * (m[k][j] / trace);
            }
        memcpy(m, square, sizeof m);
    }
    for (int i = 1; i < 4; i++)
        best = m[i][i] > m[best][best] ? i : best;
    for (int i = 0; i < 4; i++)
        q[i] = m[i][best] / sqrt(m[best][best] * (m[0][0] + m[1][1] + m[2][2] + m[3][3]));
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

/* Finds the rotation of the first frame, got[LADDER_POINTS][3], from the sheet at rest. */
static void find_turn(struct score *s, const double *rest, const double *got)
{
    double mean[2][3] = {{0}}, h[3][3] = {{0}}, q[4], left = 0;

    for (int n = 0; n < 3 * LADDER_POINTS; n++) {
        mean[0][n % 3] += rest[n] / LADDER_POINTS;
        mean[1][n % 3] += got[n] / LADDER_POINTS;
    }
    for (int n = 0; n < 9 * LADDER_POINTS; n++) {
        const int i = n % 3, j = n / 3 % 3, at = n / 9 * 3;
        h[i][j] += (rest[at + i] - mean[0][i]) * (got[at + j] - mean[1][j]);
    }
    find_rotation(h, q);
    for (int n = 0; n < LADDER_POINTS; n++) {
        double from[3], to[3];
        vector_between(mean[0], rest + 3 * n, from);
        rotate(q, from, to);
        for (int c = 0; c < 3; c++)
            left += pow(to[c] + mean[1][c] - got[3 * n + c], 2);
    }
    left = sqrt(left / LADDER_POINTS);
    const double size = vector_length(q + 1) * (q[0] < 0 ? -1 : 1);
    if (!(s->start > TURN_LEAST * s->truth.scene.length && left < TURN_LEFT * s->start &&
          size != 0))
        return;
    s->turn.angle = 2 * atan2(fabs(size), fabs(q[0])) * 180 / acos(-1);
    for (int c = 0; c < 3; c++)
        s->turn.axis[c] = q[c + 1] / size;
}

enum status score_start_find(struct score *s, const double *xyz)
{
    double rest[3 * LADDER_POINTS], *part = score_view_field(&s->fine, s->fine.times);

    score_coarse_rest(s, rest);
    score_map_apply(&s->fine.map, xyz, part);
    for (int n = 0; n < 3 * LADDER_POINTS; n++)
        s->begin[n % 3] += (part[n] - rest[n]) / LADDER_POINTS;
    s->start =
        fabs(s->first) <= SCORE_SAME_TIME ? score_rms(LADDER_POINTS, part, rest) : NAN;
    find_turn(s, rest, part);
    return find_strays(s, xyz);
}

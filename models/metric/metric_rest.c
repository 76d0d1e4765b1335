#include "models/metric/metric_rest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/grid.h"
#include "models/pattern.h"
#include "models/vector.h"

void metric_rest_clear(struct metric_rest *rest)
{
    free(rest->xyz);
    memset(rest, 0, sizeof *rest);
}

enum status metric_rest_init(struct metric_rest *rest, const struct scene *scene)
{
    *rest = (struct metric_rest){.scene = scene};
    if (scene->shape == SCENE_FLAT)
        return STATUS_OK;
    rest->xyz = malloc(3 * GRID_U * GRID_V * sizeof *rest->xyz);
    if (!rest->xyz)
        return STATUS_MEMORY;
    for (int n = 0; n < GRID_U * GRID_V; n++) {
        double uvw[3];

        grid_point(n, uvw);
        uvw[2] = 0.5;
        scene_rest_point(scene, uvw, rest->xyz + 3 * n);
    }
    return STATUS_OK;
}

static const double *at(const struct metric_rest *rest, int i, int j)
{
    return rest->xyz + 3 * (j * GRID_U + i);
}

struct metric_rest_step metric_rest_step(const struct metric_rest *rest, int i, int j,
                                         int i0, int i1, int j0, int j1)
{
    const struct scene *scene = rest->scene;
    double along[3], across[3];
    int column[2];

    grid_columns(scene_sheets(scene), grid_sheet(scene->sheets, i), column);
    struct metric_rest_step s = {.a = (i1 - i0) * scene->length / (column[1] - column[0]),
                                 .b = (j1 - j0) * scene->width / (GRID_V - 1)};

    if (!rest->xyz)
        return s;
    for (int c = 0; c < 3; c++) {
        along[c] = at(rest, i1, j)[c] - at(rest, i0, j)[c];
        across[c] = at(rest, i, j1)[c] - at(rest, i, j0)[c];
    }
    s.a = vector_length(along);
    s.shear = vector_dot(along, across) / s.a;
    s.b = sqrt(vector_dot(across, across) - s.shear * s.shear);
    return s;
}

/* Central differences in steps of the grid: two tangents; second derivatives aa, ab, bb. */
struct differences {
    double first[2][3], second[3][3];
};

static struct differences difference(double x[3][3][3])
{
    struct differences d;

    for (int c = 0; c < 3; c++) {
        d.first[0][c] = (x[1][2][c] - x[1][0][c]) / 2;
        d.first[1][c] = (x[2][1][c] - x[0][1][c]) / 2;
        d.second[0][c] = x[1][2][c] - 2 * x[1][1][c] + x[1][0][c];
        d.second[1][c] = (x[2][2][c] - x[2][0][c] - x[0][2][c] + x[0][0][c]) / 4;
        d.second[2][c] = x[2][1][c] - 2 * x[1][1][c] + x[0][1][c];
    }
    return d;
}

double metric_rest_bending(const struct metric_rest *rest, int i, int j, double x[3][3][3])
{
    double X[3][3][3], sum = 0;

    for (int q = 0; q < 3; q++)
        for (int p = 0; p < 3; p++)
            memcpy(X[q][p], at(rest, i + p - 1, j + q - 1), sizeof X[q][p]);
    struct differences now = difference(x), then = difference(X);
    const double *s = then.first[0], *t = then.first[1];
    double g[3] = {vector_dot(s, s), vector_dot(s, t), vector_dot(t, t)};
    double area = g[0] * g[2] - g[1] * g[1];
    double along = sqrt(g[0]), shear = g[1] / along, across = sqrt(area / g[0]);

    for (int k = 0; k < 3; k++) { /* less the Christoffel symbols times the tangents */
        double on_s = vector_dot(then.second[k], s), on_t = vector_dot(then.second[k], t);
        double by_s = (g[2] * on_s - g[1] * on_t) / area;
        double by_t = (g[0] * on_t - g[1] * on_s) / area;
        for (int c = 0; c < 3; c++)
            now.second[k][c] -= by_s * now.first[0][c] + by_t * now.first[1][c];
    }
    for (int c = 0; c < 3; c++) { /* into the orthonormal frame along a and across it */
        double *aa = now.second[0], *ab = now.second[1], *bb = now.second[2];
        double one = aa[c] / (along * along);
        double mixed = (ab[c] - shear * along * one) / (along * across);
        double two =
            (bb[c] - shear * shear * one - 2 * shear * across * mixed) / (across * across);
        sum += one * one + 2 * mixed * mixed + two * two;
    }
    return sum;
}

/* Computes the part of the box [lo, hi] of (u,v,w) that is in a sheet; false: nothing is.
 */
static bool part_in(const struct scene *scene, int sheet, const double lo[3],
                    const double hi[3], double from[3], double to[3])
{
    memcpy(from, lo, 3 * sizeof *from);
    memcpy(to, hi, 3 * sizeof *to);
    if (scene->sheets > 1) {
        from[0] = fmax(lo[0], scene_sheet_u(scene, sheet, 0));
        to[0] = fmin(hi[0], scene_sheet_u(scene, sheet, 1));
    }
    return from[0] <= to[0];
}

/* Returns the height of the highest rest point of a box in one sheet. */
static double highest_in(const struct scene *scene, const double lo[3], const double hi[3],
                         const double down[3])
{
    const int parts = scene->shape == SCENE_FLAT ? 1 : 32; /* flat: at a corner */
    double top = -INFINITY;

    for (int i = 0; i <= parts; i++)
        for (int j = 0; j <= parts; j++) {
            double uvw[3] = {i == parts ? hi[0] : lo[0] + i * (hi[0] - lo[0]) / parts,
                             j == parts ? hi[1] : lo[1] + j * (hi[1] - lo[1]) / parts, 0.5};
            double x[3];

            scene_rest_point(scene, uvw, x);
            top = fmax(top, -vector_dot(x, down));
        }
    return top;
}

/* Returns the height of the highest point of a sheet with an outline: of those of the box's
 * corners that are on it, and of the outline's points in the box. */
static double highest_of(const struct scene *scene, const double lo[3], const double hi[3],
                         const double down[3])
{
    const struct pattern *p = scene->pattern;
    const double size[2] = {scene->length, scene->width};
    double top = -INFINITY;

    for (int n = -4; n < p->points; n++) {
        const int corner = n + 4;
        const double uvw[3] = {n >= 0       ? p->at[n][0] / size[0]
                               : corner % 2 ? hi[0]
                                            : lo[0],
                               n >= 0       ? p->at[n][1] / size[1]
                               : corner / 2 ? hi[1]
                                            : lo[1],
                               0.5};
        const bool there = n < 0 ? pattern_has(p, uvw[0] * size[0], uvw[1] * size[1])
                                 : uvw[0] >= lo[0] && uvw[0] <= hi[0] && uvw[1] >= lo[1] &&
                                       uvw[1] <= hi[1];
        double x[3];
        scene_rest_point(scene, uvw, x);
        if (there)
            top = fmax(top, -vector_dot(x, down));
    }
    return top;
}

double metric_rest_highest(const struct scene *scene, const double lo[3],
                           const double hi[3], const double down[3])
{
    double top = -INFINITY, from[3], to[3];

    if (scene->pattern)
        return highest_of(scene, lo, hi, down);
    for (int k = 0; k < scene_sheets(scene); k++)
        if (part_in(scene, k, lo, hi, from, to))
            top = fmax(top, highest_in(scene, from, to, down));
    return top;
}

/* Returns the squared distance from a box of (s,v,w) of one flat sheet. */
static double distance_flat(const struct scene *scene, const struct scene_pose *pose,
                            const double lo[3], const double hi[3], const double x[3])
{
    double size[3] = {scene->length, scene->width, scene->thickness}, w[3], d[3], local[3];
    double sum = 0;

    vector_cross(pose->axis_u, pose->axis_v, w);
    for (int c = 0; c < 3; c++)
        d[c] = x[c] - pose->origin[c];
    local[0] = vector_dot(d, pose->axis_u);
    local[1] = vector_dot(d, pose->axis_v);
    local[2] = vector_dot(d, w) + 0.5 * scene->thickness;
    for (int c = 0; c < 3; c++) {
        double nearest = fmin(fmax(local[c], lo[c] * size[c]), hi[c] * size[c]);
        sum += (local[c] - nearest) * (local[c] - nearest);
    }
    return sum;
}

double metric_rest_distance(const struct scene *scene, const double lo[3],
                            const double hi[3], double near, const double x[3])
{
    double nearest = INFINITY, from[3], to[3];

    for (int k = 0; k < scene_sheets(scene) && scene_starts_flat(scene); k++)
        if (part_in(scene, k, lo, hi, from, to)) {
            scene_sheet_at(scene, from[0], &from[0]);
            scene_sheet_at(scene, to[0], &to[0]);
            nearest = fmin(nearest, distance_flat(scene, &scene->pose[k], from, to, x));
        }
    if (scene_starts_flat(scene))
        return nearest;
    for (int n = 0; n < 9 && !(nearest < near * near); n++) {
        double uvw[3] = {lo[0] + n / 3 * (hi[0] - lo[0]) / 2,
                         lo[1] + n % 3 * (hi[1] - lo[1]) / 2, (lo[2] + hi[2]) / 2};
        double d[3];

        scene_rest_point(scene, uvw, d);
        for (int c = 0; c < 3; c++)
            d[c] -= x[c];
        nearest = fmin(nearest, vector_dot(d, d));
    }
    return nearest;
}

double *metric_rest_field(const struct scene *scene)
{
    double *xyz = malloc(3 * GRID_POINTS * sizeof *xyz);

    for (int n = 0; xyz && n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(scene, uvw, xyz + 3 * (size_t)n);
        for (int c = 0; scene_void(scene, n % GRID_U, n / GRID_U % GRID_V) && c < 3; c++)
            xyz[3 * n + c] = NAN;
    }
    return xyz;
}

#include "models/mesh/mesh.h"

#include <math.h>
#include <string.h>

#include "models/grid.h"
#include "models/pattern.h"
#include "models/vector.h"

/* So near, in steps, a place is a point of the material grid. */
static const double ON_GRID = 1e-9;

/* One sheet of a grid. */
struct sheet {
    int n, m; /* points along u, v                                                      */
    struct mesh_field at;
};

static const double *point(const struct sheet *net, int i, int j)
{
    return net->at.x + (ptrdiff_t)(i * net->m + j) * net->at.node;
}

static void normal_at(const struct sheet *net, int i, int j, double normal[3])
{
    const double *before_u = point(net, i ? i - 1 : 0, j);
    const double *behind_u = point(net, i < net->n - 1 ? i + 1 : i, j);
    const double *before_v = point(net, i, j ? j - 1 : 0);
    const double *behind_v = point(net, i, j < net->m - 1 ? j + 1 : j);
    double u[3], v[3];

    for (int c = 0; c < 3; c++) {
        ptrdiff_t at = c * net->at.component;
        u[c] = behind_u[at] - before_u[at];
        v[c] = behind_v[at] - before_v[at];
    }
    vector_cross(u, v, normal);
    double length = vector_length(normal);
    for (int c = 0; c < 3; c++)
        normal[c] = length > 0 ? normal[c] / length : 0;
}

/* Evaluates the surface and its normal, not of length one, at (u, v). */
static void evaluate(const struct sheet *net, double u, double v, double middle[3],
                     double normal[3])
{
    double weight[2][2];
    int i = grid_cell(net->n, u, weight[0]), j = grid_cell(net->m, v, weight[1]);

    for (int c = 0; c < 3; c++)
        middle[c] = normal[c] = 0;
    for (int s = 0; s < 4; s++) {
        double share = weight[0][s / 2] * weight[1][s % 2], its[3];
        if (share == 0)
            continue;
        const double *x = point(net, i + s / 2, j + s % 2);
        normal_at(net, i + s / 2, j + s % 2, its);
        for (int c = 0; c < 3; c++) {
            middle[c] += share * x[c * net->at.component];
            normal[c] += share * its[c];
        }
    }
}

/* Fills weight[4] and slope[4] of the uniform B-spline's control points *first, ... at a
 * place of `count` points on [0, 1]; slope: their derivatives by the place in cells. */
static void spline(int degree, int count, double place, int *first, double weight[4],
                   double slope[4])
{
    const double at = place * (count - 1);
    const int cell = (int)fmin(fmax(floor(degree == 2 ? at + 0.5 : at), 0),
                               degree == 2 ? count - 1 : count - 2);
    const double t = at - cell, r = 1 - t, a = 0.5 - t, b = 0.5 + t;
    const double quadratic[2][4] = {{a * a / 2, 0.75 - t * t, b * b / 2}, {-a, -2 * t, b}};
    const double cubic[2][4] = {
        {r * r * r / 6, (4 - 6 * t * t + 3 * t * t * t) / 6,
         (4 - 6 * r * r + 3 * r * r * r) / 6, t * t * t / 6},
        {-r * r / 2, 1.5 * t * t - 2 * t, 2 * r - 1.5 * r * r, t * t / 2}};
    const double(*which)[4] = degree == 2 ? quadratic : cubic;

    *first = cell - 1;
    memcpy(weight, which[0], 4 * sizeof *weight);
    memcpy(slope, which[1], 4 * sizeof *slope);
}

/* Finds a component of the point (i, j), beyond the rims straight on. */
static double beyond(const struct sheet *net, int i, int j, int c)
{
    if (i < 0)
        return 2 * beyond(net, 0, j, c) - beyond(net, -i, j, c);
    if (i >= net->n)
        return 2 * beyond(net, net->n - 1, j, c) - beyond(net, 2 * (net->n - 1) - i, j, c);
    if (j < 0)
        return 2 * beyond(net, i, 0, c) - beyond(net, i, -j, c);
    if (j >= net->m)
        return 2 * beyond(net, i, net->m - 1, c) - beyond(net, i, 2 * (net->m - 1) - j, c);
    return point(net, i, j)[c * net->at.component];
}

/* Evaluates the B-spline and its normal, not of length one, at (u, v). */
static void evaluate_spline(const struct sheet *net, double u, double v, double middle[3],
                            double normal[3])
{
    double weight[2][4], slope[2][4], along[3] = {0}, across[3] = {0};
    int i, j;

    spline(net->at.degree, net->n, u, &i, weight[0], slope[0]);
    spline(net->at.degree, net->m, v, &j, weight[1], slope[1]);
    middle[0] = middle[1] = middle[2] = 0;
    for (int s = 0; s < (net->at.degree + 1) * (net->at.degree + 1); s++) {
        const int a = s / (net->at.degree + 1), b = s % (net->at.degree + 1);
        for (int c = 0; c < 3; c++) {
            const double x = beyond(net, i + a, j + b, c);
            middle[c] += weight[0][a] * weight[1][b] * x;
            along[c] += slope[0][a] * weight[1][b] * x;
            across[c] += weight[0][a] * slope[1][b] * x;
        }
    }
    vector_cross(along, across, normal);
}

/* Adds the normal of a triangle, as long as twice its area. */
static void add_normal(const struct mesh *mesh, const struct mesh_field *field, int t,
                       double normal[3])
{
    const int *v = mesh->flat.triangle[t];
    double e[2][3], n[3];

    for (int c = 0; c < 3; c++) {
        const double *x = field->x + c * field->component;
        for (int k = 0; k < 2; k++)
            e[k][c] = x[v[1 + k] * field->node] - x[v[0] * field->node];
    }
    vector_cross(e[0], e[1], n);
    for (int c = 0; c < 3; c++)
        normal[c] += n[c];
}

/* Tells whether a place is beside a sheet with an outline, which a triangle at these
 * weights may have been found to be nearest to; or is of a layer of a garment's grid, which
 * leaves out what is near borders. */
static bool is_beside(const struct scene *scene, const double *uv, int t,
                      const double weight[3])
{
    const bool within = t >= 0 && fmin(weight[0], fmin(weight[1], weight[2])) >= 0;
    const bool layer = uv[2] == 0 || uv[2] == 1;

    if (!scene->pattern || (within && !(layer && pattern_starts_in_space(scene->pattern))))
        return false;
    const double i = uv[0] * (GRID_U - 1), j = uv[1] * (GRID_V - 1);
    if (fabs(i - round(i)) < ON_GRID && fabs(j - round(j)) < ON_GRID)
        return scene_void(scene, (int)round(i), (int)round(j));
    return t < 0 || (!within && !pattern_has(scene->pattern, uv[0] * scene->length,
                                             uv[1] * scene->width));
}

/* Evaluates the triangles and the mean normal of their points, added to off; NaN beside the
 * sheet. */
static void evaluate_triangle(const struct mesh *mesh, const struct scene *scene,
                              const struct mesh_field *field, const double *uv,
                              double xyz[3], double *off)
{
    double weight[3];
    const int t = mesh_find(mesh, uv, weight);

    if (is_beside(scene, uv, t, weight)) {
        xyz[0] = xyz[1] = xyz[2] = NAN;
        return;
    }
    const int *v = mesh->flat.triangle[t];
    for (int c = 0; c < 3; c++) {
        const double *x = field->x + c * field->component;
        xyz[c] = weight[0] * x[v[0] * field->node] + weight[1] * x[v[1] * field->node] +
                 weight[2] * x[v[2] * field->node];
    }
    for (int k = 0; k < 3; k++) {
        double its[3] = {0};
        for (int n = mesh->ring_at[v[k]]; n < mesh->ring_at[v[k] + 1]; n++)
            add_normal(mesh, field, mesh->ring[n], its);
        const double length = vector_length(its);
        for (int c = 0; c < 3 && length > 0; c++)
            off[c] += weight[k] * its[c] / length;
    }
}

void mesh_sample(const struct mesh *mesh, const struct scene *scene,
                 const struct mesh_field *field, int n, const double *uvw, double *xyz)
{
    for (int t = 0; t < n; t++, uvw += 3, xyz += 3) {
        struct sheet sheet = {mesh->rows, mesh->points[1], *field};
        double off[3] = {0}, u;
        if (mesh->rows) {
            sheet.at.x +=
                scene_sheet_at(scene, uvw[0], &u) * sheet.n * sheet.m * field->node;
            (field->degree ? evaluate_spline : evaluate)(&sheet, u, uvw[1], xyz, off);
        } else {
            evaluate_triangle(mesh, scene, field, uvw, xyz, off);
        }
        double length = vector_length(off);
        for (int c = 0; c < 3 && length > 0; c++)
            xyz[c] += (uvw[2] - 0.5) * scene->thickness * (off[c] / length);
    }
}

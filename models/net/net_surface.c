#include "models/net/net_surface.h"

#include <math.h>

#include "models/grid.h"
#include "models/vector.h"

static const double *point(const struct net_surface *net, int i, int j)
{
    return net->x + (ptrdiff_t)(i * net->m + j) * net->node;
}

static void normal_at(const struct net_surface *net, int i, int j, double normal[3])
{
    const double *before_u = point(net, i ? i - 1 : 0, j);
    const double *behind_u = point(net, i < net->n - 1 ? i + 1 : i, j);
    const double *before_v = point(net, i, j ? j - 1 : 0);
    const double *behind_v = point(net, i, j < net->m - 1 ? j + 1 : j);
    double u[3], v[3];

    for (int c = 0; c < 3; c++) {
        ptrdiff_t at = c * net->component;
        u[c] = behind_u[at] - before_u[at];
        v[c] = behind_v[at] - before_v[at];
    }
    vector_cross(u, v, normal);
    double length = vector_length(normal);
    for (int c = 0; c < 3; c++)
        normal[c] = length > 0 ? normal[c] / length : 0;
}

/* Evaluates the surface and its normal, not of length one, at (u, v). */
static void evaluate(const struct net_surface *net, double u, double v, double middle[3],
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
            middle[c] += share * x[c * net->component];
            normal[c] += share * its[c];
        }
    }
}

void net_surface_points(const struct net_surface *net, const struct scene *scene, int n,
                        const double *uvw, double *xyz)
{
    for (int t = 0; t < n; t++, uvw += 3, xyz += 3) {
        struct net_surface sheet = *net;
        double off[3], u;
        sheet.x += scene_sheet_at(scene, uvw[0], &u) * net->n * net->m * net->node;
        evaluate(&sheet, u, uvw[1], xyz, off);
        double length = vector_length(off);
        for (int c = 0; c < 3 && length > 0; c++)
            xyz[c] += (uvw[2] - 0.5) * scene->thickness * (off[c] / length);
    }
}

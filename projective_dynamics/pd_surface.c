#include "projective_dynamics/pd_surface.h"

#include <math.h>

/* Cell of s in [0,1] among `points` nodes, and the share of its far end. */
static int cell(int points, double s, double *share)
{
    double at = s * (points - 1);
    int i = at < 0 ? 0 : (int)at;

    if (i > points - 2)
        i = points - 2;
    *share = at - i;
    return i;
}

static void normalise(double a[3])
{
    double length = sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);

    for (int c = 0; c < 3 && length > 0; c++)
        a[c] /= length;
}

/* Unit normal at a node, from the differences over its neighbours; zero if there is none.
 */
static void node_normal(const struct pd_net *net, const double *x, int i, int j,
                        double normal[3])
{
    int m = net->m, before_u = i > 0, behind_u = i<net->n - 1, before_v = j> 0,
        behind_v = j < m - 1, k = i * m + j;
    double u[3], v[3];

    for (int c = 0; c < 3; c++, x += pd_net_stride(net)) {
        u[c] = x[k + behind_u * m] - x[k - before_u * m];
        v[c] = x[k + behind_v] - x[k - before_v];
    }
    for (int c = 0; c < 3; c++)
        normal[c] = u[(c + 1) % 3] * v[(c + 2) % 3] - u[(c + 2) % 3] * v[(c + 1) % 3];
    normalise(normal);
}

static void point(const struct pd_net *net, const double *x, double thickness,
                  const double uvw[3], double xyz[3])
{
    double s, t, normal[3] = {0};
    int i = cell(net->n, uvw[0], &s), j = cell(net->m, uvw[1], &t);

    xyz[0] = xyz[1] = xyz[2] = 0;
    for (int corner = 0; corner < 4; corner++) {
        int a = corner >> 1, b = corner & 1, k = (i + a) * net->m + j + b;
        double weight = (a ? s : 1 - s) * (b ? t : 1 - t), at[3];
        if (weight == 0)
            continue;
        node_normal(net, x, i + a, j + b, at);
        for (int c = 0; c < 3; c++) {
            xyz[c] += weight * x[c * pd_net_stride(net) + k];
            normal[c] += weight * at[c];
        }
    }
    normalise(normal);
    for (int c = 0; c < 3; c++)
        xyz[c] += (uvw[2] - 0.5) * thickness * normal[c];
}

void pd_surface_points(const struct pd_net *net, const double *x, double thickness, int n,
                       const double *uvw, double *xyz)
{
    for (int t = 0; t < n; t++)
        point(net, x, thickness, uvw + 3 * t, xyz + 3 * t);
}

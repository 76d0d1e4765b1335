#include "projective_dynamics/pd_surface.h"

#include <math.h>

#include "models/net.h"

void pd_surface_points(const struct pd_net *net, const double *x, double thickness, int n,
                       const double *uvw, double *xyz)
{
    const struct net surface = {net->n, net->m, x, 1, pd_net_stride(net)};

    for (int t = 0; t < n; t++, uvw += 3, xyz += 3) {
        double off[3];
        net_surface(&surface, uvw[0], uvw[1], xyz, off);
        double length = sqrt(off[0] * off[0] + off[1] * off[1] + off[2] * off[2]);
        for (int c = 0; c < 3 && length > 0; c++)
            xyz[c] += (uvw[2] - 0.5) * thickness * (off[c] / length);
    }
}

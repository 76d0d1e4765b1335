/* net.h - a net of points on the mid-surface as a surface: bilinear in each cell, with
 * bilinear normals too, so that a thick sheet has no gaps between cells. */
#ifndef NET_H
#define NET_H

#include <stddef.h>

/* Component c of point (i, j) at x[(i m + j) node + c component]; x is borrowed. */
struct net {
    int n, m; /* points along u, v; >= 2                                               */
    const double *x;
    ptrdiff_t node, component;
};

/* Evaluates the surface at (u, v), and there the mean of the four points' unit normals: of
 * tangents by central differences, one-sided on the rim; zero where they are parallel. */
void net_surface(const struct net *net, double u, double v, double middle[3],
                 double normal[3]);

/* Evaluates material points uvw[n][3] of a sheet of this thickness, xyz[n][3]: the surface
 * and (w - 1/2) thickness along the unit normal. */
void net_points(const struct net *net, double thickness, int n, const double *uvw,
                double *xyz);

#endif

/* net_surface.h - nets of points on the mid-surfaces of sheets as surfaces: bilinear in
 * each cell, with bilinear normals too, so that a thick sheet has no gaps between cells; or
 * uniform B-splines whose control points they are (Li et al. 2019 have springs between
 * these).
 *
 * Beyond a rim such a net goes on straight, which is a spline's natural end: a flat net is
 * the sheet itself, rims are splines of the points on them, and its corners are points. */
#ifndef NET_SURFACE_H
#define NET_SURFACE_H

#include <stddef.h>

#include "models/scene.h"

/* Component c of point (i, j) at x[(i m + j) node + c component]; x is borrowed. Row n is
 * the first of the second sheet. */
struct net_surface {
    int n, m; /* points of a sheet along u, v; >= 2                                    */
    const double *x;
    ptrdiff_t node, component;
    int degree; /* 2 or 3: a B-spline's; 0: bilinear                                    */
};

/* Evaluates material points uvw[n][3] of the scene's sheets, xyz[n][3]: the surface and
 * (w - 1/2) thickness along its unit normal, the mean of the cell's four points'
 * normals: of tangents by central differences, one-sided on the rim. No normal where they
 * are parallel. */
void net_surface_points(const struct net_surface *net, const struct scene *scene, int n,
                        const double *uvw, double *xyz);

#endif

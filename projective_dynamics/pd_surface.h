/* pd_surface.h - the sheet between the nodes: bilinear in (u,v), and half a thickness along
 * the normal to either side. */
#ifndef PD_SURFACE_H
#define PD_SURFACE_H

#include "projective_dynamics/pd_net.h"

/* Positions of material points uvw[n][3] into xyz[n][3]: mid-surface + (w - 1/2) thickness
 * times the unit normal, which is bilinear between those of the nodes. x: three fields. */
void pd_surface_points(const struct pd_net *net, const double *x, double thickness, int n,
                       const double *uvw, double *xyz);

#endif

/* cloak_net.h - control points and weights of the curved rest shape `cloak`
 * (models/scene.h) in given B-spline spaces.
 *
 * u and w are affine and v is a quotient of quadratics: spaces of degree 2 or more in v,
 * whatever their knots, contain the shape exactly, and the parameters are the material
 * coordinates. Degree 1 in v gives polygons: points of the shape, joined.
 *
 * A closed cloak has a closed basis along v and no weights. Splines of degree p with even
 * knots then follow the circle to 2 (n - 1)^-(p + 1) of its radius, n points around: 5e-8
 * for 80 points of degree 3. The parameter is the angle, and no place around differs from
 * another.
 */
#ifndef CLOAK_NET_H
#define CLOAK_NET_H

#include <stdbool.h>

#include "iga/bspline.h"
#include "models/scene.h"

/* Returns whether functions of this basis along v contain the shape. */
bool cloak_net_exact(const struct bspline *v);

/* Computes point[n u][n v][layers][3] [m] and weight[n u][n v][layers], for layers at
 * w[layers]. STATUS_INPUT, with a sentence, if a weight is not positive: an opening of 180
 * degrees or more on too few points along v. Without cloak_net_exact all weights are 1. */
enum status cloak_net(const struct scene *scene, const struct bspline *u,
                      const struct bspline *v, int layers, const double *w, double *point,
                      double *weight, struct message *why);

#endif

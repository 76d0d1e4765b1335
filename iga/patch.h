/* patch.h - a trivariate B-spline or NURBS solid V(u,v,w) (Ren et al. 2024, eq. 1-2, 10).
 *
 * Control points are numbered w fastest: node = (i m + j) l + k for i < n, j < m, k < l.
 * The basis of v may be closed; m then counts its different functions.
 */
#ifndef PATCH_H
#define PATCH_H

#include "iga/bspline.h"

struct patch {
    struct bspline basis[3]; /* u, v, w                                                */
    double *point;           /* control points [nodes][3]                  [m] owned   */
    double *weight;          /* [nodes] > 0; NULL: all 1 (B-spline)            owned   */
};

enum { PATCH_MAX_LOCAL = BSPLINE_MAX_ORDER * BSPLINE_MAX_ORDER * BSPLINE_MAX_ORDER };

int patch_nodes(const struct patch *p);
int patch_local(const struct patch *p); /* (p+1)(q+1)(r+1) functions per element       */

/* Copies the bases; control points are zero, weights NULL. */
enum status patch_init(struct patch *patch, const struct bspline basis[3]);
void patch_clear(struct patch *patch);

/* Sets the box origin + a u + b v + c w with parameter = affine coordinate: control points
 * at Greville abscissae. Weights stay as they are (with weights != 1 the map is no longer
 * affine, though the shape is the same box). */
void patch_set_box(struct patch *patch, const double origin[3], const double a[3],
                   const double b[3], const double c[3]);

/* Lists the nodes alive on the spans (knot indices) span[3], ascending local order (a n2 +
 * b) n3 + c like the global one, in node[patch_local]. */
void patch_local_nodes(const struct patch *patch, const int span[3], int *node);

/* Evaluates the alive functions at (u,v,w): values R[local], parametric gradients
 * dR[3][local] (either may be NULL), spans span[3]. Rational if weights are given. */
void patch_basis(const struct patch *patch, const double uvw[3], int span[3], double *R,
                 double *dR);

/* Computes the position [m] and, if J is not NULL, J[i][j] = d x_i / d u_j. */
void patch_point(const struct patch *patch, const double uvw[3], double x[3],
                 double J[3][3]);

/* Finds the parameters of the point x: Newton from the start value in uvw, with shorter
 * steps where they do not help, kept in [0,1]^3. STATUS_DIVERGED if |V(uvw) - x| >
 * tolerance [m] after 50 tries; uvw is then the best one. */
enum status patch_invert(const struct patch *patch, const double x[3], double tolerance,
                         double uvw[3]);

#endif

/* solid_hinge.h - supports of the mid-surface of a net that has no node there: in the
 * columns that they take, one element through the thickness, x(w = 1/2) = sum_k N_k(1/2)
 * x_k = m is an unknown in place of the node c with the largest N_k(1/2): with x_c = (m -
 * sum_{k != c} N_k(1/2) x_k) / N_c(1/2) the functions that go with the unknowns are N_c /
 * N_c(1/2) for m and N_k - N_k(1/2) N_c / N_c(1/2) for the others. The support then holds m
 * as it would a node, exactly, and nothing above the functions is another. (The thickness
 * basis has m among its unknowns and needs none of this.)
 */
#ifndef SOLID_HINGE_H
#define SOLID_HINGE_H

#include "models/scene.h"
#include "models/solid/solid_space.h"

/* Finds the columns of `layers` nodes that the scene hinges, and replaces their node by m
 * in rest coefficients and parameters; middle[layers] is copied. STATUS_UNSUPPORTED with a
 * sentence where another support takes a part of such a column's thickness. */
enum status solid_hinge_init(struct solid_space *space, const struct scene *scene,
                             int layers, const double *middle, struct message *why);

/* Turns functions of the nodes of an element into those of the unknowns, in place:
 * f[rows][row], whatever derivatives they are. Pure. */
void solid_hinge_functions(const struct solid_space *space, int element, int rows, int row,
                           double *f);

/* Turns values shape[used] of the functions of whole columns, node[used], likewise, and
 * drops those that are zero; returns how many are left. */
int solid_hinge_row(const struct solid_space *space, int used, int *node, double *shape);

/* Turns forces f[nodes][3] on the nodes likewise. */
void solid_hinge_forces(const struct solid_space *space, double *f);

/* Returns component i of a node, of coefficients x[nodes][3]: x itself without a hinge. */
double solid_hinge_point(const struct solid_space *space, const double *x, int node, int i);

#endif

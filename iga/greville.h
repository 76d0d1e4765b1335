/* greville.h - quadrature with as many points as a spline space has functions. */
#ifndef GREVILLE_H
#define GREVILLE_H

#include "iga/bspline.h"

/* Computes, in at[n], the Greville abscissae of the functions of *b or, with `derivative`,
 * of the space of their derivatives (degree p - 1, n - 1 functions), ascending, and, in
 * weight[n], weights that integrate every spline of that space exactly: those of its
 * interpolant (Greville 1967; as points of collocation: Johnson, Appl. Numer. Math. 52,
 * 2005). Returns how many, 0: no memory. Where knots are so uneven that a weight comes out
 * negative, all are the integrals of the functions themselves, exact for straight lines. */
int greville_rule(const struct bspline *b, bool derivative, double *at, double *weight);

#endif

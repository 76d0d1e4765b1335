/* net_matrix.h - made-up symmetric positive definite matrices with the pattern of a cloth
 * solid: a net of points_u x points_v x 2 nodes with 3 unknowns each, numbered
 * ((i points_v + j) 2 + k) 3 + c, each node coupled to all within +-reach in i and j and to
 * both k (reach = degree for B-splines, 1 for trilinear hexahedra).
 *
 * Values are pseudo-random and diagonally dominant: what factors and solves cost depends on
 * the pattern alone.
 */
#ifndef NET_MATRIX_H
#define NET_MATRIX_H

#include <stdbool.h>
#include "models/status.h"

struct net_shape {
    int points_u, points_v, reach;
    bool held_edge; /* the nodes i = 0 are no unknowns                                 */
    bool split;     /* membrane and bending uncoupled: c = 0,1 of k = 0 with c = 2 of
                       k = 1, and the rest (a flat sheet, Legendre through the thickness) */
};

/* Lower triangle by columns, as in factor_pattern. All arrays owned. */
struct net_matrix {
    int n;
    long *start;   /* [n + 1]      */
    int *row;      /* [start[n]]   */
    double *value; /* [start[n]]   */
};

enum status net_matrix_create(const struct net_shape *shape, struct net_matrix *a);
void net_matrix_clear(struct net_matrix *a); /* all-zero is allowed and left */

/* y = A x; x[n], y[n]. */
void net_matrix_multiply(const struct net_matrix *a, const double *x, double *y);

#endif

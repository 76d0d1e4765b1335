/* verify_box.h - stiffness and mass of a box as products of three matrices of one variable:
 *   int N_a,i N_b,j dV = A_0 A_1 A_2,
 * with A_d the mass matrix of direction d, its stiffness (d = i = j), or int N_a' N_b
 * (d = i) and its transpose (d = j). Made from bspline_eval alone: no element's code. */
#ifndef VERIFY_BOX_H
#define VERIFY_BOX_H

#include "iga/bspline.h"

struct verify_box {
    const struct bspline *basis[3]; /* NULL: one function, constant        borrowed    */
    double size[3];                 /* edges [m]                                       */
    double lambda, mu, density;     /* Lame [Pa], [kg/m^3]                             */
};

int verify_box_nodes(const struct verify_box *box);

/* All of K [3 nodes][3 nodes] and M [nodes][nodes], node = (i m + j) l + k; either may be
 * NULL. STATUS_MEMORY. */
enum status verify_box_matrices(const struct verify_box *box, double *K, double *M);

#endif

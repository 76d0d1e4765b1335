/* verify_box.h - stiffness and mass of a box as products of three matrices of one variable:
 *   int N_a,i N_b,j dV = A_0 A_1 A_2,
 * with A_d the mass matrix of direction d, its stiffness (d = i = j), or int N_a' N_b
 * (d = i) and its transpose (d = j). It uses bspline_eval alone, and no element's code. */
#ifndef VERIFY_BOX_H
#define VERIFY_BOX_H

#include "iga/bspline.h"

struct verify_box {
    int degree[3], points[3];   /* uniform splines; 0 points: one function, constant   */
    double size[3];             /* edges [m]                                           */
    double lambda, mu, density; /* Lame [Pa], [kg/m^3]                                 */
};

/* Computes K, or M times the identity, full[3 nodes][3 nodes], node = (i m + j) l + k.
 * STATUS_MEMORY; STATUS_INPUT, with a sentence, if there are no such splines. */
enum status verify_box_matrix(const struct verify_box *box, bool mass, double *full,
                              struct message *why);

#endif

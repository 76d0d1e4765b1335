/* ritz.h - polynomial functions of one direction, for plates by Ritz's method.
 *
 * On x in [0,1] the functions phi_0 .. phi_{count-1} are double integrals of Legendre
 * polynomials, normalised so that the integral of (phi_i'')^2 is 1: phi_i'' is the
 * orthonormal Legendre polynomial of some degree. Their stiffness matrix is the identity
 * and only neighbours couple in the mass matrix, so that high degrees stay well
 * conditioned where powers of x are hopeless beyond degree 10. Every function is held as
 * its Legendre coefficients; integrals follow from orthogonality, without quadrature.
 *
 * Source: integrated Legendre (hierarchic) shape functions, Szabo and Babuska, Finite
 * Element Analysis, 1991, section 3.1, integrated twice here for C1 conformity.
 */
#ifndef RITZ_H
#define RITZ_H

#include "models/status.h"

enum { RITZ_MAX = 96 };

enum ritz_end {
    RITZ_CLAMPED_FREE, /* phi(0) = phi'(0) = 0, free at 1                             */
    RITZ_FREE_FREE,    /* 1, x - 1/2, then the others; even i: even about 1/2         */
};

struct ritz {
    int count;              /* functions                                              */
    int terms;              /* Legendre coefficients of each, count + 3               */
    double *coefficient[3]; /* [d][count][terms]: of d^d phi_i / dx^d in P_k(2x - 1)  */
};

/* Makes functions of every degree up to count + 1 (clamped) or count - 1 (free). 4 <= count
 * <= RITZ_MAX. Caller owns; ritz_clear accepts all-zero. */
enum status ritz_init(struct ritz *r, enum ritz_end end, int count);
void ritz_clear(struct ritz *r);

/* Evaluates derivatives of order d (0..2) of all functions at x in [0,1], out[count]. */
void ritz_eval(const struct ritz *r, int d, double x, double *out);

/* Returns the integral over [0,1] of (d^a phi_i) (d^b phi_j). */
double ritz_product(const struct ritz *r, int a, int i, int b, int j);

/* Returns the integral over [0,1] of phi_i. */
double ritz_integral(const struct ritz *r, int i);

#endif

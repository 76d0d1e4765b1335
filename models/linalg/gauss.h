/* gauss.h - Gauss-Legendre rules on [0, 1]. */
#ifndef GAUSS_H
#define GAUSS_H

enum { GAUSS_MAX = 16 };

/* Computes abscissae x[n] (ascending) and weights w[n] of the n-point rule on [0,1], exact
 * for polynomials of degree 2n - 1; weights sum to 1. 1 <= n <= GAUSS_MAX. Newton on the
 * Legendre recurrence, round-off accurate, symmetric bit for bit (x[i] = 1 - x[n-1-i] up to
 * one rounding, w[i] = w[n-1-i] exactly). */
void gauss_rule(int n, double *x, double *w);

#endif

/* eigen.h - the lowest eigenpairs of K x = lambda M x, both symmetric, M positive definite,
 * K positive definite or not: a sheet under stress may be about to buckle.
 *
 * Dense LAPACK (dsygvx) up to EIGEN_DENSE_MAX unknowns, ARPACK shift-invert above it, with
 * a start vector of its own: the same bits every run.
 */
#ifndef EIGEN_H
#define EIGEN_H

#include "models/status.h"

enum { EIGEN_DENSE_MAX = 1500 };

/* Two symmetric sparse matrices of one pattern, lower triangle by columns:
 * row[start[j]..start[j+1]) >= j, ascending, diagonal present; K, M [start[n]]. Borrowed.
 */
struct eigen_pair {
    int n;
    const long *start;
    const int *row;
    const double *K, *M;
};

/* Finds the `count` smallest lambda, ascending, lambda[count]; eigenvectors, M-normalised,
 * vector[count][n] unless NULL. 1 <= count <= n.
 *
 * K may be singular (free body): the shift is -1e-12 of the mean |k_ii| / m_ii, far below
 * the modes of the thinnest sheet, and grows a hundredfold while round-off or negative
 * lambdas leave K - shift M indefinite. Errors in lambda are about 1e-15 of the largest
 * lambda, however small the wanted ones are.
 *
 * STATUS_INDEFINITE if K - shift M stays so, or the diagonal of M is not positive (no more
 * of M is checked above EIGEN_DENSE_MAX); STATUS_DIVERGED if LAPACK or ARPACK gives up;
 * sentence in *why. Not for two threads at once (ARPACK keeps state). */
enum status eigen_lowest(const struct eigen_pair *pair, int count, double *lambda,
                         double *vector, struct message *why);

#endif

/* eigen.h - the lowest eigenpairs of K x = lambda M x, both symmetric, M positive definite.
 *
 * Dense LAPACK (dsygvx) up to EIGEN_DENSE_MAX unknowns, ARPACK shift-invert above it.
 */
#ifndef EIGEN_H
#define EIGEN_H

#include "models/status.h"

enum { EIGEN_DENSE_MAX = 1500 };

/* Symmetric sparse matrix, lower triangle by columns: row[start[j]..start[j+1]) >= j,
 * ascending, diagonal present; value[start[n]]. Borrowed. */
struct eigen_matrix {
    int n;
    const long *start;
    const int *row;
    const double *value;
};

/* The `count` smallest lambda, ascending, into lambda[count]; eigenvectors, M-normalised,
 * into vector[count][n] unless NULL. K may be singular (free body): the shift is
 * -scale * 1e-6 with scale from the diagonals. 1 <= count <= n. STATUS_DIVERGED if ARPACK
 * gives up (sentence in *why). */
enum status eigen_lowest(const struct eigen_matrix *K, const struct eigen_matrix *M,
                         int count, double *lambda, double *vector, struct message *why);

#endif

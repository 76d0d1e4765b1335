/* bench_factor.h - what a factor and a solve cost on matrices of a cloth solid's pattern.
 */
#ifndef BENCH_FACTOR_H
#define BENCH_FACTOR_H

#include "bench/speed/net_matrix.h"
#include "models/clock.h"
#include "models/linalg/factor.h"

/* Symmetric positive definite matrix: lower triangle by columns (factor.h). Borrowed. */
struct bench_matrix {
    int n;
    const long *start;
    const int *row;
    const double *value;
};

struct bench_factor_row {
    struct net_shape shape;
    enum solver asked;
    const char *method; /* "banded", "supernodal", ...: what ran                static */
    int unknowns, parts, half_bandwidth;
    long entries, bytes;           /* of L; held by the factor                         */
    double flops;                  /* of one factorisation                             */
    double residual;               /* |b - A x| / (a_ii |x|), largest: the answer held */
    struct clock_summary analyse;  /* [s], once                                        */
    struct clock_summary refactor; /* [s], filling the values not counted              */
    struct clock_summary solve;    /* [s]                                              */
};

/* Measures one matrix with one method: analysis, `repeats` refactors and as many solves
 * (more where they are short), after one of each untimed; x[n] = A^-1 b. order[n]: given to
 * the factor, or NULL. Leaves shape and residual zero. */
enum status bench_factor_matrix(const struct bench_matrix *A, enum solver method,
                                const int *order, int repeats, const double *b, double *x,
                                struct bench_factor_row *row);

/* The same for one made-up net. nested: order_nested is given; else CHOLMOD orders. */
enum status bench_factor_measure(const struct net_shape *shape, enum solver method,
                                 bool nested, int repeats, struct bench_factor_row *row);

/* The nets the rule of SOLVER_AUTO was measured on. Static storage. */
const struct net_shape *bench_factor_shapes(int *count);

#endif

/* bench_factor.h - what a factor and a solve cost on matrices of a cloth solid's pattern.
 */
#ifndef BENCH_FACTOR_H
#define BENCH_FACTOR_H

#include "bench/speed/net_matrix.h"
#include "models/clock.h"
#include "models/linalg/factor.h"

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

/* Measures one net with one method: `repeats` refactors and as many solves (more where they
 * are short), after one of each untimed. nested: order_nested is given; else CHOLMOD
 * orders. */
enum status bench_factor_measure(const struct net_shape *shape, enum solver method,
                                 bool nested, int repeats, struct bench_factor_row *row);

/* The nets the rule of SOLVER_AUTO was measured on. Static storage. */
const struct net_shape *bench_factor_shapes(int *count);

#endif

/* bench_solid.h - runs and times the phases of a solid model's step, each by itself: K and
 * M, the factor, the solve.
 */
#ifndef BENCH_SOLID_H
#define BENCH_SOLID_H

#include "models/status.h"

enum bench_solid_phase {
    BENCH_SOLID_ASSEMBLE, /* K and M on the rest shape                                 */
    BENCH_SOLID_FACTOR,
    BENCH_SOLID_SOLVE,
    BENCH_SOLID_FRAME /* how many there are                                            */
};

/* Runs one phase on a solid's state. Assembly comes first; the matrices are afterwards
 * those of the rest shape. */
enum status bench_solid_run(void *state, enum bench_solid_phase phase);

/* Measures seconds[repeats] of a phase, after an untimed one; a sample is the mean of as
 * many calls as make up a millisecond. */
enum status bench_solid_time(void *state, enum bench_solid_phase phase, int repeats,
                             double *seconds);

/* Returns the step's matrix M + dt^2/4 K of the free unknowns, lower triangle by columns
 * (models/linalg/factor.h); all freed by the receiver. */
enum status bench_solid_matrix(void *state, int *n, long **start, int **row,
                               double **value);

#endif

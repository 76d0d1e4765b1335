/* bench_solid.h - times the phases of a solid model's step, each by itself: K and
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

/* Measures seconds[repeats] of a phase of a solid's state, after an untimed one; a sample
 * is the mean of as many calls as make up a millisecond. Assembly comes first. */
enum status bench_solid_time(void *state, enum bench_solid_phase phase, int repeats,
                             double *seconds);

#endif

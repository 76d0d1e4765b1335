/* bench_baseline.h - the linear algebra of a frame by libraries used as they come, run
 * beside ours on the same numbers: named baselines for speed ratios.
 */
#ifndef BENCH_BASELINE_H
#define BENCH_BASELINE_H

#include "bench/speed/bench_factor.h"

struct bench_baseline {
    struct clock_summary factor, solve; /* [s]                                         */
    long entries;                       /* numbers stored in L                         */
};

/* LAPACK dpbtrf and dpbtrs on the whole band, natural order. */
enum status bench_baseline_lapack(const struct bench_matrix *A, int repeats,
                                  struct bench_baseline *b);

/* CHOLMOD with its defaults (AMD, METIS; supernodal where it thinks fit), as
 * discretization.solver=cholmod runs it; analysis not counted. */
enum status bench_baseline_cholmod(const struct bench_matrix *A, int repeats,
                                   struct bench_baseline *b);

#endif

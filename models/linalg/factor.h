/* factor.h - Cholesky factorisation of a symmetric positive definite matrix whose pattern
 * never changes: analyse once, fill values, refactor, solve.
 *
 * Two ways behind one face: a band of tiles for small nets, CHOLMOD for large ones.
 * Independent sub-systems (connected components of the pattern, such as membrane and
 * bending of a flat sheet) are found and factored one by one, each with its own band or
 * order: leave couplings that are always zero out of the pattern. One thread inside; the
 * result does not depend on any thread count.
 *
 * The caller fills the numbers in place: slot = factor_slot(f, i, j) once at set-up, then
 * factor_values(f)[slot] += a_ij after factor_clear_values, before every factor_refactor.
 * Slots make the copy from any other storage one indexed loop.
 */
#ifndef FACTOR_H
#define FACTOR_H

#include <stdbool.h>
#include <stddef.h>
#include "models/discretization.h"
#include "models/status.h"

/* The nonzero pattern of a symmetric matrix: its lower triangle by columns, row[start[j] ..
 * start[j+1]) >= j, ascending, diagonal present.
 */
struct factor_pattern {
    int n;
    const long *start; /* [n + 1]       borrowed during create                         */
    const int *row;    /* [start[n]]                                                   */
    const int *order;  /* [n] an order of elimination, order[new] = old, or NULL. The band
                          takes the narrower of this and the natural order; CHOLMOD orders
                          by itself.                                                   */
};

struct factor;

/* Analyses a pattern. SOLVER_AUTO and SOLVER_DIRECT pick the band where it costs less (the
 * rule and its measurement: factor.c), SOLVER_CG and SOLVER_GMRES the factor to iterate on.
 * n >= 1. Sets BLAS to one thread for the process.
 * Owned by the caller, freed with factor_destroy; *f is untouched on failure. */
enum status factor_create(const struct factor_pattern *pattern, enum solver method,
                          struct factor **f);
void factor_destroy(struct factor *f); /* NULL is allowed */

/* Returns the place of entry (i,j) of the lower triangle (i >= j; either order is accepted)
 * in factor_values. O(log) or O(1); for set-up. The entry must be in the pattern. */
ptrdiff_t factor_slot(const struct factor *f, int i, int j);

/* Returns a slot that is never read: the destination for entries of held unknowns. */
ptrdiff_t factor_dump(const struct factor *f);

/* Returns the values to fill, all slots; call factor_clear_values before summing into them,
 * every time: factor_refactor overwrites them (bands are factored in place). Borrowed. */
double *factor_values(struct factor *f);
void factor_clear_values(struct factor *f);

/* Factors. STATUS_INDEFINITE if not positive definite (or not finite). */
enum status factor_refactor(struct factor *f);

/* Chooses the precision of L from the next factor_refactor on: single takes about half the
 * time, for callers that iterate on the residual. CHOLMOD stays in double. */
void factor_single(struct factor *f, bool single);

/* Solves A x = b in place, b[n]. Only after a successful refactor. */
enum status factor_solve(struct factor *f, double *b);

/* Solves A x = b in place for `count` right-hand sides b + c stride, c = 0 .. count - 1.
 * A band solves three together, reading L once; the first time after a refactor prepares
 * for it (and may return STATUS_MEMORY). Three sides agree with factor_solve to round-off
 * only.
 */
enum status factor_solve_many(struct factor *f, int count, double *b, ptrdiff_t stride);

struct factor_info {
    const char *method; /* "banded", "cholmod" or "mixed"; static storage            */
    long entries;       /* numbers stored in L, padding included                       */
    double flops;       /* operations of one factorisation                             */
    int parts;          /* independent sub-systems                                       */
    int half_bandwidth; /* banded only                                                 */
    long bytes;         /* held by the factor                                          */
};
void factor_describe(const struct factor *f, struct factor_info *info);

#endif

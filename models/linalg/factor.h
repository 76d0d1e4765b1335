/* factor.h - Cholesky factorisation of a symmetric positive definite matrix whose pattern
 * never changes: analyse once, fill values, refactor, solve.
 *
 * Two ways behind one face: LAPACK's blocked banded Cholesky for small nets (natural or
 * given order), CHOLMOD (supernodal, nested dissection) for large ones. One thread inside;
 * the result does not depend on any thread count.
 *
 * The caller fills the numbers in place: slot = factor_slot(f, i, j) once at set-up, then
 * factor_values(f)[slot] += a_ij before every factor_refactor. Slots make the copy from any
 * other storage one indexed loop.
 */
#ifndef FACTOR_H
#define FACTOR_H

#include <stddef.h>
#include "models/discretization.h"

struct factor;

/* Lower triangle by columns: row[start[j] .. start[j+1]) >= j, ascending, diagonal present. */
struct factor_pattern {
    int n;
    const long *start; /* [n + 1]       borrowed during create                         */
    const int *row;    /* [start[n]]                                                   */
    const int *order;  /* [n] fill-reducing permutation, order[new] = old; or NULL: natural
                          for the band, METIS/AMD for CHOLMOD                          */
};

/* SOLVER_AUTO picks the band when it costs less (see the rule in factor.c, measured by
 * `clothbench bench`). Owned by the caller, freed with factor_destroy. */
enum status factor_create(const struct factor_pattern *pattern, enum solver method,
                          struct factor **f);
void factor_destroy(struct factor *f); /* NULL is allowed */

/* Where entry (i,j) of the lower triangle (i >= j; either order is accepted) lives in
 * factor_values. O(log) or O(1); for set-up. The entry must be in the pattern. */
ptrdiff_t factor_slot(const struct factor *f, int i, int j);

/* A slot that is never read: the destination for entries of held unknowns. */
ptrdiff_t factor_dump(const struct factor *f);

/* The values to fill, all slots; call factor_clear_values before summing into them.
 * factor_refactor may overwrite them (banded factors in place). Borrowed. */
double *factor_values(struct factor *f);
void factor_clear_values(struct factor *f);

/* STATUS_INDEFINITE if not positive definite (or not finite). */
enum status factor_refactor(struct factor *f);

/* Solves A x = b in place, b[n]. Only after a successful refactor. */
enum status factor_solve(struct factor *f, double *b);

struct factor_info {
    const char *method; /* "banded", "cholmod"; static                                 */
    long entries;       /* numbers stored in L                                         */
    double flops;       /* of one factorisation                                        */
    int parts;          /* independent sub-systems                                       */
    int half_bandwidth; /* banded only                                                 */
    long bytes;         /* held by the factor                                          */
};
void factor_describe(const struct factor *f, struct factor_info *info);

#endif

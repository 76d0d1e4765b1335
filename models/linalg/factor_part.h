/* factor_part.h - inside factor.h: one independent sub-system (connected component of the
 * pattern), factored by one method. Private to models/linalg.
 *
 * A part numbers its unknowns 0..n-1 in the order of elimination: position[i] says where
 * unknown i of the part's pattern went.
 */
#ifndef FACTOR_PART_H
#define FACTOR_PART_H

#include <stddef.h>
#include "models/status.h"

struct factor_info;
struct factor_part;
struct factor_pattern;

struct factor_method {
    const char *name;

    /* Analyses `pattern` (order: a permutation or NULL) and writes position[n]. */
    enum status (*create)(const struct factor_pattern *pattern, int *position,
                          struct factor_part *part);

    /* Returns the place of entry (i,j), i >= j, in positions, in the part's values. */
    ptrdiff_t (*slot)(const struct factor_part *part, int i, int j);

    enum status (*refactor)(struct factor_part *part, double *value);

    /* Solves A x = b in place; b[rows] by position, 64-byte aligned, zeros behind n. */
    enum status (*solve)(struct factor_part *part, const double *value, double *b);

    /* Solves A x = b in place for three sides: b in blocks (tile_three.h), by position,
     * zeros behind n. `prepare_three` comes once after a refactor. NULL: it cannot. */
    enum status (*prepare_three)(struct factor_part *part, const double *value);
    enum status (*solve_three)(struct factor_part *part, const double *value, double *b);

    /* Factor and solve in single precision; NULL: the method cannot. */
    enum status (*refactor_single)(struct factor_part *part, float *value);
    enum status (*solve_single)(struct factor_part *part, const float *value, float *b);

    /* Adds to *info. */
    void (*describe)(const struct factor_part *part, struct factor_info *info);

    void (*destroy)(struct factor_part *part); /* frees part->state, which may be NULL */
};

struct factor_part {
    const struct factor_method *method;
    int n;
    int rows;        /* rows of its right-hand side: n, more with padding; set by create */
    ptrdiff_t slots; /* numbers it needs in factor_values, set by create               */
    void *state;     /* the method's own                                     owned    */
};

/* Allocates count numbers: zeros, aligned to cache lines, on huge pages where that pays.
 * Owned by the caller, freed with free; NULL if there is no memory. */
double *factor_numbers(ptrdiff_t count);

extern const struct factor_method factor_banded;
extern const struct factor_method factor_cholmod;

#endif

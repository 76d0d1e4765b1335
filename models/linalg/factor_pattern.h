/* factor_pattern.h - the nonzero pattern of a symmetric matrix, and its components. */
#ifndef FACTOR_PATTERN_H
#define FACTOR_PATTERN_H

#include "models/status.h"

/* Lower triangle by columns: row[start[j] .. start[j+1]) >= j, ascending, diagonal present.
 */
struct factor_pattern {
    int n;
    const long *start; /* [n + 1]       borrowed during create                         */
    const int *row;    /* [start[n]]                                                   */
    const int *order;  /* [n] an order of elimination, order[new] = old, or NULL. The band
                          takes the narrower of this and the natural order; supernodes the
                          best of this (order_nested's, say), AMD's and METIS's; CHOLMOD
                          orders by itself.                                            */
};

/* Finds the components, part_of[n], numbered by their first unknown; parent[n] is work.
 * Returns their number. */
int factor_pattern_parts(const struct factor_pattern *a, int *parent, int *part_of);

/* The pattern of one part alone. */
struct factor_pattern_part {
    struct factor_pattern pattern;
    void *room; /* memory of its arrays                                      owned     */
};

/* Restricts to a part; unknown[n]: its unknowns, ascending; local: their inverse. */
enum status factor_pattern_restrict(const struct factor_pattern *a, const int *unknown,
                                    int n, const int *local, const int *part_of,
                                    struct factor_pattern_part *p);
void factor_pattern_clear(struct factor_pattern_part *p);

#endif

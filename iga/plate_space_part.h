/* plate_space_part.h - what plate_space.c and plate_space_cure.c share; nobody else's. */
#ifndef PLATE_SPACE_PART_H
#define PLATE_SPACE_PART_H

#include <stdbool.h>

#include "models/status.h"

struct bspline;
struct plate_direction;
struct reduced_rule;
struct solid_space;

/* Points of `rule`, at most `gauss` a span (its counts are taken over), or NULL: Gauss
 * points, so many. */
enum status plate_space_direction(struct plate_direction *d, const struct bspline *b,
                                  int gauss, struct reduced_rule *rule, bool legendre);

/* R_a = w_a N_a / W and its gradient at one Gauss point, in place. In the thickness basis,
 * weights are equal through a column and its first function, 1, stands for the sum of all.
 */
void plate_space_rational(const struct solid_space *space, int element, double *N,
                          double *G, int row);

#endif

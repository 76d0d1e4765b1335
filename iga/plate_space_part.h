/* plate_space_part.h - shared by plate_space.c and plate_space_cure.c; private to them. */
#ifndef PLATE_SPACE_PART_H
#define PLATE_SPACE_PART_H

#include <stdbool.h>

#include "models/status.h"

struct bspline;
struct plate_direction;
struct line_rule;
struct solid_space;

/* Makes tables at the points of `rule`, which is cleared; fails if `st` does. */
enum status plate_space_direction(struct plate_direction *d, const struct bspline *b,
                                  enum status st, struct line_rule *rule, bool legendre);

/* Computes R_a = w_a N_a / W and its gradient at one Gauss point, in place. In the
 * thickness basis, weights are equal through a column and its first function, 1, represents
 * the sum of all. */
void plate_space_rational(const struct solid_space *space, int element, double *N,
                          double *G, int row);

#endif

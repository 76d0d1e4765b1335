/* lumped_mass.h - row sums of a mass matrix, by which explicit steps divide. Those of
 * B-splines are positive: the functions are, and sum to one. */
#ifndef LUMPED_MASS_H
#define LUMPED_MASS_H

#include "models/discretization.h"
#include "models/linalg/blocks.h"

/* Replaces M[pairs] by row sums if d's steps are explicit, on the diagonal, zero elsewhere.
 * STATUS_UNSUPPORTED with a sentence where one is not positive. */
enum status lumped_mass_make(const struct discretization *d, const struct blocks *graph,
                             double *M, struct message *why);

#endif

/* spring_frequency.h - the largest natural frequency of a net, which limits explicit steps.
 */
#ifndef SPRING_FREQUENCY_H
#define SPRING_FREQUENCY_H

#include "models/linalg/blocks.h"
#include "models/mechanics/supports.h"

/* By Lanczos' method, without reorthogonalisation (the extreme value does not need it),
 * from below, in 200 steps at most. mass[nodes], K[pairs of graph][9]. 0 if nothing can
 * move. */
enum status spring_frequency_largest(const struct blocks *graph,
                                     const struct supports *supports, const double *mass,
                                     const double (*K)[9], double *omega);

#endif

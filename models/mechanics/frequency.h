/* frequency.h - the largest natural frequency of a body, which limits explicit steps.
 * Lanczos' method finds it from below, without reorthogonalisation (the extreme value does
 * not need it), in 200 steps at most. */
#ifndef FREQUENCY_H
#define FREQUENCY_H

#include "models/linalg/blocks.h"
#include "models/mechanics/supports.h"

/* Finds it with lumped mass[nodes]; K[pairs of graph][9]. 0 if nothing can move. */
enum status frequency_largest(const struct blocks *graph, const struct supports *supports,
                              const double *mass, const double (*K)[9], double *omega);

#endif

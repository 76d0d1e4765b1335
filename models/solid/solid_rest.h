/* solid_rest.h - results that need no time stepping: static equilibrium, natural
 * frequencies, and the matrices of the rest shape. */
#ifndef SOLID_REST_H
#define SOLID_REST_H

#include "models/solid/solid_motion.h"

/* Moves to static equilibrium under the loads, supports where the scene ends; velocity
 * becomes zero. One step of iterative refinement measures the digits left:
 * STATUS_INDEFINITE (with sentence) if fewer than two, STATUS_INPUT without any support. */
enum status solid_rest_equilibrium(struct solid_motion *m, struct counters *counters,
                                   struct message *why);

/* Finds the `count` lowest angular frequencies [rad/s], ascending, as in model.h. */
enum status solid_rest_modes(struct solid_motion *m, int count, double *omega,
                             struct message *why);

/* Copies all of K and M of the rest shape, lower triangle (model.h); before the first step,
 * and with control points as unknowns. */
enum status solid_rest_matrices(const struct solid_motion *m, struct matrix *K,
                                struct matrix *M);

#endif

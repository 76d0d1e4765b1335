/* large_rest.h - static equilibrium of a body at large displacements (large_motion.h). */
#ifndef LARGE_REST_H
#define LARGE_REST_H

#include "models/linalg/large_motion.h"

/* Moves m->x to equilibrium under the loads, supports at their shift of time 0; v and a
 * become zero. The load grows from nothing, the next shape guessed along the last two;
 * where that leads nowhere (a sheet that hangs from a hinge has no stiffness at first), by
 * pseudo-transient continuation. STATUS_INPUT without supports; deaths with a sentence. */
enum status large_rest_equilibrium(struct large_motion *m, struct counters *counters,
                                   struct message *why);

/* model.h's modes about m->x: of its tangent, stress and all. */
enum status large_rest_modes(struct large_motion *m, int count, double *omega,
                             struct message *why);

#endif

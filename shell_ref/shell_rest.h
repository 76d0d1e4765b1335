/* shell_rest.h - results without time stepping: model.h's entries of these names for a
 * state that begins with a struct shell_motion. */
#ifndef SHELL_REST_H
#define SHELL_REST_H

#include "shell_ref/shell_motion.h"

/* Moves the state to equilibrium under the scene's loads, supports where it ends, at rest.
 * Linear: one solve, one pass of refinement. Nonlinear: from the rest shape by growing
 * loads, in shorter increments where Newton's method fails, at last by steps downhill (a
 * sheet on a hinge). STATUS_INPUT without supports. */
enum status shell_rest_equilibrium(void *state, struct counters *counters,
                                   struct message *why);
enum status shell_rest_modes(void *state, int count, double *omega, struct message *why);
enum status shell_rest_matrices(const void *state, struct matrix *K, struct matrix *M);

#endif

/* shell_rest.h - results without time stepping: equilibrium, natural modes, matrices. */
#ifndef SHELL_REST_H
#define SHELL_REST_H

#include "shell_ref/shell_motion.h"

/* Moves the state to equilibrium under the scene's loads, supports where it ends, at rest.
 * Linear: one solve, one pass of refinement. Nonlinear: from the rest shape by growing
 * loads, in shorter increments where Newton's method fails, at last by steps downhill (a
 * sheet on a hinge). STATUS_INPUT without supports. */
enum status shell_rest_equilibrium(struct shell_motion *m, struct counters *counters,
                                   struct message *why);

/* Compute model.h's modes, and its matrices, of the rest shape. */
enum status shell_rest_modes(struct shell_motion *m, int count, double *omega,
                             struct message *why);
enum status shell_rest_matrices(const struct shell_motion *m, struct matrix *K,
                                struct matrix *M);

#endif

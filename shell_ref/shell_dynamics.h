/* shell_dynamics.h - one step of the nonlinear shell in time.
 *
 * Simo and Tarnow's energy-momentum scheme (ZAMP 43, 1992): between x_0 and x_1 of a step
 *   M (v_1 - v_0)/dt + alpha M (x_1 - x_0)/dt + f = load,   v_0 + v_1 = 2 (x_1 - x_0)/dt,
 * where f are the forces of the mean stress (not of the mean shape) on the mean geometry:
 * a sheet that turns rigidly is not strained by it, as the mid-point rule would. Momenta are
 * kept exactly. Energy is lost by the membrane's algorithmic viscosity alone (MEMBRANE_LAG;
 * without it the membrane, whose strains are quadratic in x, would keep it exactly) and kept
 * by bending to third order in the step. Stiffness damping is beta times the rate of
 * stress, which knows no rigid motion either.
 */
#ifndef SHELL_DYNAMICS_H
#define SHELL_DYNAMICS_H

#include "shell_ref/shell_motion.h"

/* Advances x and v by scene->step, in halved substeps where Newton's method fails. Leaves
 * m->time to the caller. STATUS_DIVERGED, _INDEFINITE, _INVERTED or _NAN if step / 256 fails
 * too. */
enum status shell_dynamics_step(struct shell_motion *m, struct counters *counters);

#endif

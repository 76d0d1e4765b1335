/* large_return.h - gives the energy back that the algorithmic viscosity of a step took.
 *
 * The viscosity damps waves of the membrane that are far shorter than a step. Nothing
 * physical takes their energy: it came from the slower motion, which is to have it back.
 * After a step the scheme has lost f . (x_1 - x_0) - (U_1 - U_0), with the forces f of the
 * step (stiffness damping apart) and the elastic energy U. The velocities then change along
 * the step's mean velocity, in which waves that change their sign from step to step are
 * not, v <- v + c w,   w = (x_1 - x_0)/dt less the velocity of the supports or, where
 * nothing is held, the rigid motion of the same momenta, by the c for which the kinetic
 * energy grows by that loss: momentum and angular momentum of a free sheet stay, and no
 * frame of reference is preferred. Supports, loads, bodies that are touched and physical
 * damping do their own work. This is a projection upon the energy (Hairer, Lubich, Wanner,
 * Geometric Numerical Integration, IV.4), in one step's balance.
 */
#ifndef LARGE_RETURN_H
#define LARGE_RETURN_H

#include "models/mechanics/large_body.h"

/* The viscosity of bodies that have its loss back, in steps (large_motion_lag). */
extern const double large_return_lag;

/* Takes the elastic energy at m->x as that before the first step; nothing is owed. The
 * codes of the body. */
enum status large_return_begin(struct large_motion *m);

/* Changes the velocities at the end of a step of dt [s] from x_old[nodes][3], while
 * m->strain_old is still that of x_old. work[3][nodes][3]. What is more than a share of the
 * motion's energy stays owed. The codes of the body. */
enum status large_return_give(struct large_motion *m, double dt, const double *x_old,
                              double *work);

#endif

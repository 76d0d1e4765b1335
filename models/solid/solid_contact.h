/* solid_contact.h - steps of a solid in a scene with obstacles, control points against
 * obstacles (the paper's detection on the control net; the sheet lies in its points' convex
 * hull, so that the net touches first).
 *
 * `linear`: contact_step.h.
 *
 * `nonlinear`: large_motion.h.
 *
 * `printed`: points in contact are prescribed as the paper prescribes moving supports (eq.
 * 20-22), the rate of d included; `incremental`: the same, then such a point's normal
 * velocity and acceleration are those of the obstacle, zero. Neither has an energy, and no
 * bound.
 */
#ifndef SOLID_CONTACT_H
#define SOLID_CONTACT_H

#include "models/solid/solid_state.h"

/* Takes one step of m->kinematics from m->x, without the velocity's damping. `held`: motion
 * of the held unknowns at its end, NULL at rest. Uses the rebuilt kinematics' present
 * matrices. */
enum status solid_contact_linear(struct solid_motion *m, const struct newmark_held *held,
                                 struct counters *counters);
enum status solid_contact_rebuilt(struct solid_motion *m, const struct newmark_held *held,
                                  struct counters *counters);

#endif

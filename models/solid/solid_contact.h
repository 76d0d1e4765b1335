/* solid_contact.h - steps of a solid in a scene with obstacles, control points against
 * obstacles (the paper's detection on the control net; the sheet lies in its points' convex
 * hull, so that the net touches first).
 *
 * `linear`: the trapezoidal rule with a contact force r constant over the step,
 *     M (v1 - v0) / dt = f - K (d0 + d1) / 2 - C (v0 + v1) / 2 + r,
 *     d1 - d0 = dt (v0 + v1) / 2,
 * that is average acceleration with the contact force taken wholly at the step's end (Kane,
 * Repetto, Ortiz, Marsden 1999, Comput. Methods Appl. Mech. Engrg. 180; Kane, Marsden,
 * Ortiz, West 2000), which spares it the half of the last step's force that makes Newmark's
 * method gain energy. Then what is left of the velocity of points in contact, into the
 * obstacle or off it, is taken away in the norm of M: an inelastic impact, without which
 * points in contact would be thrown back at every step (the oscillation that Deuflhard,
 * Krause, Ertel 2008, Int. J. Numer. Meth. Engng. 73, remove by projecting the predictor).
 * Bound: E1 - E0 = -sum r_n gap0 - friction - damping - impact <= 0 up to round-off, for
 * every step size, with E = v'Mv/2 + d'Kd/2 - f'd: a point that r carries has moved by
 * exactly its gap, and a projection shortens. Impact loses the energy of the points that
 * touch, which is none in the limit of a fine net.
 *
 * `printed`: points in contact are prescribed as the paper prescribes moving supports (eq.
 * 20-22), the rate of d included; `incremental`: the same, then such a point's normal
 * velocity and acceleration are those of the obstacle, zero. Neither has an energy, and no
 * bound.
 */
#ifndef SOLID_CONTACT_H
#define SOLID_CONTACT_H

#include "models/solid/solid_motion.h"

/* One step of m->kinematics from m->x, without the velocity's damping. `held`: motion of
 * the held unknowns at its end, NULL at rest. On the rebuilt kinematics' present matrices.
 */
enum status solid_contact_linear(struct solid_motion *m, const struct newmark_held *held,
                                 struct counters *counters);
enum status solid_contact_rebuilt(struct solid_motion *m, const struct newmark_held *held,
                                  struct counters *counters);

#endif

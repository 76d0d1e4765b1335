/* solid_large.h - a solid_motion at large displacements: `nonlinear` kinematics (DESIGN:
 * total Lagrangian, Green strain, St. Venant-Kirchhoff), by solid_green.h and
 * large_motion.h. Only motions of that kinematics pay for it.
 */
#ifndef SOLID_LARGE_H
#define SOLID_LARGE_H

#include "models/solid/solid_state.h"

/* After the rest of *m is there and in its place. STATUS_INVERTED; what
 * large_leapfrog_make says. */
enum status solid_large_create(struct solid_motion *m, const struct discretization *d,
                               struct solid_large **large, struct message *why);
void solid_large_destroy(struct solid_large *large); /* NULL is allowed */

/* One step of the scene from m->time. */
enum status solid_large_step(struct solid_motion *m, struct counters *counters);

/* In a scene with obstacles. */
void solid_large_contact(const struct solid_motion *m, struct model_contact *contact);

/* large_leapfrog.h */
void solid_large_describe(const struct solid_motion *m, struct message *line);

/* large_rest.h */
enum status solid_large_equilibrium(struct solid_motion *m, struct counters *counters,
                                    struct message *why);
enum status solid_large_modes(struct solid_motion *m, int count, double *omega,
                              struct message *why);

/* Whether x is an equilibrium that solid_large_equilibrium found. */
bool solid_large_rested(const struct solid_motion *m);

/* Elastic energy of the present shape [J]; NaN if it has none. */
double solid_large_energy(const struct solid_motion *m);

#endif

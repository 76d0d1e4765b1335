/* solid_large.h - a solid_motion at large displacements: `nonlinear` kinematics (DESIGN:
 * total Lagrangian, Green strain, St. Venant-Kirchhoff), by solid_green.h and
 * large_motion.h. Motions of other kinematics do not allocate it. */
#ifndef SOLID_LARGE_H
#define SOLID_LARGE_H

#include "models/solid/solid_state.h"

/* Creates it, when the rest of *m is complete and in its final place. STATUS_INVERTED; the
 * statuses of large_leapfrog_make. */
enum status solid_large_create(struct solid_motion *m, const struct discretization *d,
                               struct solid_large **large, struct message *why);
void solid_large_destroy(struct solid_large *large); /* NULL is allowed */

/* Takes one step of the scene from m->time. */
enum status solid_large_step(struct solid_motion *m, struct counters *counters);

/* Reports contact; only in a scene with obstacles. */
void solid_large_contact(const struct solid_motion *m, struct model_contact *contact);

/* Calls large_leapfrog.h's. */
void solid_large_describe(const struct solid_motion *m, struct message *line);

/* Call large_rest.h's functions. */
enum status solid_large_equilibrium(struct solid_motion *m, struct counters *counters,
                                    struct message *why);
enum status solid_large_modes(struct solid_motion *m, int count, double *omega,
                              struct message *why);

/* Whether x is an equilibrium that solid_large_equilibrium found. */
bool solid_large_rested(const struct solid_motion *m);

/* Returns elastic energy of the present shape [J]; NaN if it has none. */
double solid_large_energy(const struct solid_motion *m);

#endif

/* large_leapfrog.h - a body at large displacements in time by explicit leapfrog steps
 * (central differences; Hughes 2000, The Finite Element Method, 9.1), second order:
 *     v(n+1/2) = ((1 - alpha dt/2) v(n-1/2) + dt a(n)) / (1 + alpha dt/2),
 *     x(n+1) = x(n) + dt v(n+1/2),   M a(n) = load - f(x(n)),
 * whose first and last kicks in a frame are half ones, v(n) the mean of v(n-1/2) and
 * v(n+1/2): v belongs to x at its ends.
 * Stiffness damping takes the rate of strain of half a step ago: first order in beta. No
 * tangent is made in a step.
 *
 * Mass. Row sums (lumped_mass.h): M is diagonal, and a step costs its forces. Of a body
 * that says what is beyond them (large_body.h) M^-1 is D^-1 + D^-1 beyond D^-1, D the row
 * sums: symmetric, and positive where the mass D - beyond is below 2 D.
 *
 * Steps. A frame has as many as keep 0.95 of the greatest stable step about rest,
 * sqrt(beta^2 + 4 / omega^2) - beta, omega the largest frequency by Lanczos' method. A
 * sheet that is stretched is stiffer: after every frame its energy is compared with the
 * least it has had since, the work of supports and pressure apart. A frame that has
 * gained is done again in twice as many steps, which then stay; one that gains in 256 times
 * as many, or in the number that was asked for, is a death.
 *
 * Contact moves the nodes at the end of each step (contact_project).
 */
#ifndef LARGE_LEAPFROG_H
#define LARGE_LEAPFROG_H

#include "models/mechanics/large_body.h"

/* Refuses for shell and solids what model_refuse_options does, and an integrator,
 * kinematics and number of substeps that do not go together. */
enum status large_leapfrog_refuse(const struct discretization *d, struct message *why);

/* Makes steps of *m, initialised and at rest, explicit if d says so: m->leapfrog, which
 * large_motion_clear frees. Overwrites m->K. STATUS_INPUT with a sentence if a frame needs
 * more than a million steps. */
enum status large_leapfrog_make(struct large_motion *m, const struct discretization *d,
                                struct message *why);
void large_leapfrog_free(struct large_leapfrog *l);

/* Returns the kinetic energy of the free unknowns, by the mass of the steps [J]. */
double large_leapfrog_kinetic(const struct large_motion *m);

/* Describes its steps and mass in a line; none if steps are implicit. */
void large_leapfrog_describe(const struct large_motion *m, struct message *line);

/* Does for explicit steps what large_motion_step promises. */
enum status large_leapfrog_step(struct large_motion *m, double t,
                                struct counters *counters);

#endif

/* spring_contact.h - impulses that keep the points of a net out of obstacles.
 *
 * A point that a step would take nearer to an obstacle than half a thickness is set back
 * along the normal so that the gap just closes: an impulse m dx / dt, after which it comes
 * no faster than it came. Friction sets it back across the normal by mu times as much, or
 * until it has not moved at all (Coulomb; Bridson, Fedkiw, Anderson 2002). Neither adds
 * kinetic energy. The surface that is sampled lies at -/+ h/2 of the points.
 */
#ifndef SPRING_CONTACT_H
#define SPRING_CONTACT_H

#include "models/mechanics/supports.h"
#include "models/model.h"

/* Moves x[nodes][3], start[nodes][3] where the step began; held components stay.
 * force[3] += sum of weight[node] dx: with weight m/dt^2, newtons. Returns how many points
 * were set back. */
int spring_contact_push(const struct scene *scene, const struct supports *supports,
                        const double *weight, const double *start, double *x,
                        double force[3]);

/* Least gap of the points, less h/2 [m]. */
double spring_contact_gap(const struct scene *scene, long nodes, const double *x);

#endif

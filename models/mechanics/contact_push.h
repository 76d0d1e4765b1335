/* contact_push.h - impulses that keep points out of obstacles.
 *
 * A point that a step would take nearer to an obstacle than the offset is set back along
 * the normal so that the gap just closes: an impulse m dx / dt, after which it comes
 * no faster than it came. Friction sets it back across the normal by mu times as much, or
 * until it has not moved at all (Coulomb; Bridson, Fedkiw, Anderson 2002). Neither adds
 * kinetic energy. The surface that is sampled lies at -/+ h/2 of a mid-surface's points.
 */
#ifndef CONTACT_PUSH_H
#define CONTACT_PUSH_H

#include "models/mechanics/supports.h"
#include "models/model.h"

/* Moves x[nodes][3] out of obstacles; start[nodes][3]: where the step began; held
 * components stay. offset: distance that points keep, h/2 of a mid-surface [m]. force[3] +=
 * sum of weight[node] dx: with weight m/dt^2, newtons. Returns how many points were set
 * back. */
int contact_push_out(const struct scene *scene, const struct supports *supports,
                     double offset, const double *weight, const double *start, double *x,
                     double force[3]);

/* Returns the least gap of the points, less h/2 [m]. */
double contact_push_gap(const struct scene *scene, long nodes, const double *x);

#endif

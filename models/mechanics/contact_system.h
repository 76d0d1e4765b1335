/* contact_system.h - the contact of a sheet in Newton's method: its part of the tangent. */
#ifndef CONTACT_SYSTEM_H
#define CONTACT_SYSTEM_H

#include "models/contact/contact.h"
#include "models/linalg/blocks.h"

/* Adds the stiffness of the touches of the last contact_find to K[pairs]: of the pressure
 * along the normals, without its turning, and of friction across them. Positive
 * semidefinite. `error` is how far x may be from the solution [m], INFINITY at first: far
 * from it friction has the stiffness that would end the slip, with which Newton's method
 * can't go back and forth between two directions of it; close to it, and in a search for
 * rest, where without inertia that would take small steps, its tangent. */
void contact_system_tangent(const struct contact *c, double error,
                            const struct blocks *graph, double (*K)[9]);

/* Adds the same at rest with the turning of the normals of bodies at x[nodes][3], where
 * contact_find looked: what leans on a round body may slide off. */
void contact_system_turned(const struct contact *c, const double *x,
                           const struct blocks *graph, double (*K)[9]);

/* Changes v[nodes][3] by contact_landing, and the contact's force with it, as far as that
 * takes kinetic energy from the mass M. work[6 nodes]. */
void contact_system_land(struct contact *c, const struct blocks *graph, const double *M,
                         const int *held, const double *x, double *v, double *work);

#endif

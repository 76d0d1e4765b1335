/* contact_system.h - the contact of a sheet in Newton's method: its part of the tangent. */
#ifndef CONTACT_SYSTEM_H
#define CONTACT_SYSTEM_H

#include "models/contact/contact.h"
#include "models/linalg/blocks.h"

/* Adds the stiffness of the touches of the last contact_find to K[pairs]: of the pressure
 * along the normals, without its turning, and of friction across them. Positive
 * semidefinite. Returns false, with K spoilt, if the graph lacks a pair of a touch. */
bool contact_system_tangent(const struct contact *c, const struct blocks *graph,
                            double (*K)[9]);

/* Adds the same with the turning of the normals of bodies at x[nodes][3], where
 * contact_find looked: what leans on a round body may slide off. */
bool contact_system_turned(const struct contact *c, const double *x,
                           const struct blocks *graph, double (*K)[9]);

#endif

/* contact_system.h - the contact of a sheet in Newton's method: its part of the tangent. */
#ifndef CONTACT_SYSTEM_H
#define CONTACT_SYSTEM_H

#include "models/contact/contact.h"
#include "models/linalg/blocks.h"
#include "models/supports.h"

/* Adds the stiffness of the touches of the last contact_find to K[pairs]: of the pressure
 * along the normals and of friction across them; with x NULL without the normals' turning,
 * so that it is positive semidefinite.
 *
 * The turning at x[nodes][3], where contact_find looked, lets what leans on a round body
 * slide off, and one side of a sheet slide along the other. It leaves out a net of points
 * with itself, which has no gradient of an energy (contact_foot.h), and rims.
 *
 * Returns false, with K spoilt, if the graph lacks a pair of a touch. */
bool contact_system_tangent(const struct contact *c, const double *x,
                            const struct blocks *graph, double (*K)[9]);

/* Changes v[nodes][3] by contact_landing, and the bodies' forces with it (landed), as far
 * as that takes kinetic energy from the mass M. work[9 nodes]. */
void contact_system_land(struct contact *c, const struct blocks *graph, const double *M,
                         const struct supports *held, const double *x, double *v,
                         double *work);

#endif

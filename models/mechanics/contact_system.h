/* contact_system.h - the contact of a sheet in Newton's method: its part of the tangent. */
#ifndef CONTACT_SYSTEM_H
#define CONTACT_SYSTEM_H

#include "models/contact/contact.h"
#include "models/linalg/blocks.h"

/* Adds the stiffness of the touches of the last contact_find to K[pairs]: of the pressure
 * along the normals, without its turning, and of friction across them. Positive
 * semidefinite.
 */
bool contact_system_tangent(const struct contact *c, const struct blocks *graph,
                            double (*K)[9]);

#endif

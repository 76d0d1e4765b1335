/* contact.h - the geometry of obstacles. Model-free; all of them convex (half-spaces and
 * balls), so that the tangent plane at the nearest point keeps a point outside.
 */
#ifndef CONTACT_H
#define CONTACT_H

#include "models/scene.h"

/* Returns the signed distance of x from the obstacle's surface [m], negative inside, and
 * the outward unit normal at the nearest point, the gap's gradient. At a sphere's centre,
 * where every direction is as good, the normal is z. `normal` may be NULL. */
double contact_gap(const struct scene_obstacle *obstacle, const double x[3],
                   double normal[3]);

/* Returns how far a sheet at rest reaches into an obstacle [m], 0 if it does not: half the
 * thickness less the least gap of its middle surface, which is exact. Every model refuses a
 * scene whose sheet begins in an obstacle (model_refuse), as the reader of scenes does,
 * with the line. */
double contact_rest_depth(const struct scene *scene, const struct scene_obstacle *obstacle);
#define CONTACT_REST_DEPTH "the sheet at rest reaches %.3g m into obstacle %d"

/* Returns the least gap of x[count][3] to any obstacle of the scene [m]: INFINITY without
 * obstacles or points, NaN if a coordinate is NaN. */
double contact_least_gap(const struct scene *scene, long count, const double *x);

#endif

/* body_shape.h - the geometry of bodies: distance and normal; it knows of no model. */
#ifndef BODY_SHAPE_H
#define BODY_SHAPE_H

#include "models/scene.h"

/* Returns the signed distance of x from the body's surface [m], negative inside, and the
 * outward unit normal at the nearest point, the distance's gradient; where it has none (a
 * sphere's centre, a box's middle) one of those as good as the others. Capsule: distance
 * from a segment less the radius; box: nearest point outside, nearest face inside; mesh:
 * body_mesh.h, INFINITY if it is not loaded. `normal` and `pose` (the scene's place) may
 * be NULL. NaN if x is NaN. */
double body_shape_distance(const struct scene_obstacle *o,
                           const struct scene_placement *pose, const double x[3],
                           double normal[3]);

/* Returns the same if it is less than `most` [m], else some number from `most` up to it,
 * with any normal: without a search for points off a mesh. */
double body_shape_near(const struct scene_obstacle *o, const struct scene_placement *pose,
                       const double x[3], double most, double normal[3]);

/* Returns where the body's point that is at x in the pose `to` was, or will be, in the pose
 * `from`. */
void body_shape_carry(const struct scene_placement *to, const struct scene_placement *from,
                      const double x[3], double y[3]);

/* Returns the least distance of x[count][3] to any body of the scene at time t [m]:
 * INFINITY without bodies or points, NaN if a coordinate is NaN. */
double body_shape_least_gap(const struct scene *scene, double t, long count,
                            const double *x);

#endif

/* pattern_mesh.h - triangles in a pattern that has none of its own.
 *
 * Sides are divided evenly, and where supports end on them. The border is cut into
 * triangles by clipping ears, holes being joined to it first (Eberly 1998); then the points
 * of an even lattice that are not too near are put in, one by one, edges being turned until
 * they are Delaunay's; last, points move to the mean of their neighbours.
 */
#ifndef PATTERN_MESH_H
#define PATTERN_MESH_H

#include "models/pattern.h"
#include "models/scene.h"

/* Makes triangles with edges about `width` long [m] for the scene's pattern; another seed
 * turns and shifts the lattice. */
enum status pattern_mesh(const struct scene *scene, double width, int seed,
                         struct mesh_flat *flat);

#endif

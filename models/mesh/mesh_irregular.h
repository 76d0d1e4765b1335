/* mesh_irregular.h - a grid of triangles made irregular. */
#ifndef MESH_IRREGULAR_H
#define MESH_IRREGULAR_H

#include "models/mesh_flat.h"
#include "models/scene.h"

/* Moves the points of mesh_flat_grid by up to 0.3 cells, those on the rim and on the edges
 * of supports along it, and makes the triangles Delaunay's; the same for the same seed. */
enum status mesh_irregular(struct mesh_flat *flat, const struct scene *scene,
                           const int points[2], int seed);

#endif

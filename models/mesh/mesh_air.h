/* mesh_air.h - the air against a net: triangles or cells are integrated at their corners,
 * so that each point has its own velocity, and the normals beside it, as it has its own
 * mass. */
#ifndef MESH_AIR_H
#define MESH_AIR_H

#include "models/mechanics/air.h"
#include "models/mesh/mesh.h"

/* Makes the air of a scene; nothing if it has none. */
enum status mesh_air(const struct mesh *mesh, const struct scene *scene, struct air *air);

#endif

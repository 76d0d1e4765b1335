/* body_mesh.h - bodies of triangles, and the signed distance from them.
 *
 * A tree of boxes over the triangles finds the nearest one. The sign is that of the
 * pseudonormal of the face, edge or vertex that has the nearest point: a face's own normal,
 * an edge's sum of two, a vertex's sum weighted by angle (Baerentzen & Aanaes 2005, IEEE
 * Trans. Vis. Comput. Graph. 11(3), who prove that it is right for closed meshes). So a
 * closed mesh has an inside; one that faces inward is a room around the sheet. An open mesh
 * has a back only where the nearest point is not on its rim: the distance from a rim is
 * positive, and jumps behind it.
 */
#ifndef BODY_MESH_H
#define BODY_MESH_H

#include <stdbool.h>
#include <stdint.h>

#include "models/status.h"

struct obstacle_mesh;

/* A mesh has at most so many triangles, and vertices. */
enum { BODY_MESH_MOST = 1000000, BODY_MESH_MOST_VERTICES = 3000000 };

/* Makes a mesh of finite vertex[vertices][3] [m] and triangle[triangles][3], whose corners
 * are numbered from 0 and go round counter-clockwise seen from outside; both are copied.
 * Vertices at the same place become one, and triangles with two corners at one place are
 * left out. *mesh is freed by the receiver with free, NULL on failure.
 * STATUS_INPUT with a sentence: no triangle is left, corners on a line, an edge at which
 * more than two triangles meet or two that face opposite ways. STATUS_MEMORY. */
enum status body_mesh_make(int vertices, const double (*vertex)[3], int triangles,
                           const int (*triangle)[3], struct obstacle_mesh **mesh,
                           struct message *why);

/* Returns the signed distance of x [m] if it is less than `most` [m], else some number from
 * `most` up to the distance: found without a search where x is off the box of a closed mesh
 * that faces outwards by as much. *normal is the distance's gradient, of length 1, and only
 * set in the first case. NaN if x is. */
double body_mesh_distance(const struct obstacle_mesh *mesh, const double x[3], double most,
                          double normal[3]);

/* This is the mesh as it was made; the arrays belong to it. */
struct body_mesh_view {
    int vertices, triangles;
    const double (*vertex)[3]; /* [vertices]                                    [m]   */
    const int (*triangle)[3];  /* [triangles]                                          */
    const double (*bend)[3];   /* [vertices] along their pseudonormals; 0 on a rim     */
    uint64_t mark;             /* a number made from all of these                      */
};
struct body_mesh_view body_mesh_view(const struct obstacle_mesh *mesh);

/* Computes a vector along the pseudonormal of the edge from corner side % 3 of the triangle
 * side / 3 to the next, 0 on a rim; false: the edge is told by its other triangle. */
bool body_mesh_edge(const struct obstacle_mesh *mesh, int side, double normal[3]);

#endif

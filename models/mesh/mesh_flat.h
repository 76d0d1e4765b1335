/* mesh_flat.h - triangles in the plane of a rectangular sheet, before they are a mesh: made
 * from a grid, made irregular, read, refined.
 */
#ifndef MESH_FLAT_H
#define MESH_FLAT_H

#include "models/scene.h"

struct mesh_flat {
    int nodes, triangles;
    double (*at)[2];    /* [nodes] along u and v                              [m]   */
    int (*triangle)[3]; /* [triangles] counter-clockwise; both owned                */
};

/* An edge: its ends, and the points across from it in its first triangle, which has the
 * ends in this order, and in its second; -1 where it is on the rim. */
struct mesh_edge {
    int node[4], triangle[2];
};

void mesh_flat_clear(struct mesh_flat *flat);

/* Finds the edges: (*edge)[*count], and (*side)[triangles][3], the edges across from a
 * triangle's points; both owned by the caller. STATUS_INPUT where three triangles meet at
 * an edge: *count is then its first triangle. */
enum status mesh_flat_edges(const struct mesh_flat *flat, struct mesh_edge **edge,
                            int *count, int (**side)[3]);

/* Cuts the cells of n x m points, number i m + j, by diagonals: neighbouring cells by
 * different ones, so that they meet at points with even i + j, or all by the same. */
enum status mesh_flat_grid(struct mesh_flat *flat, const struct scene *scene,
                           const int points[2], bool alternate);

/* Moves the points of such a grid by up to 0.3 cells, those on the rim and on the edges of
 * supports along it, and makes the triangles Delaunay's; the same for the same seed. */
enum status mesh_flat_jitter(struct mesh_flat *flat, const struct scene *scene,
                             const int points[2], int seed);

/* Cuts each triangle into four. */
enum status mesh_flat_refine(struct mesh_flat *flat);

/* Reads a Wavefront OBJ file: lines `v x y z`, `vt u v` and `f a b c ...`, a may go on as
 * in a/b/c; other lines are skipped. The plane is u times the length and v times the width
 * of the sheet, where faces name vt, else x and y in metres. Points are those that faces
 * name, in the file's order; triangles the file's. It must be the whole rectangle.
 * STATUS_INPUT with a sentence `path:line: ...` or `path: ...`. */
enum status mesh_flat_read(struct mesh_flat *flat, const struct scene *scene,
                           const char *path, struct message *why);

#endif

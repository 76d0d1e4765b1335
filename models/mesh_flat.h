/* mesh_flat.h - triangles in the plane of a sheet, before they are a mesh: made from a
 * grid, turned, refined.
 *
 * Where a sheet is sewn together, a node on a seam lies in several panels: each triangle
 * then keeps the places of its corners, and the node has its place in its first triangle.
 */
#ifndef MESH_FLAT_H
#define MESH_FLAT_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>

#include "models/status.h"

struct mesh_flat {
    int nodes, triangles;
    double (*at)[2];        /* [nodes] along u and v                              [m]   */
    int (*triangle)[3];     /* [triangles] counter-clockwise; both owned                */
    double (*corner)[3][2]; /* [triangles] places of corners; NULL: those of nodes  owned */
    double (*start)[3];     /* [nodes] where they begin along u, v and the normal; NULL: in
                               the plane                                        [m]   owned */
};

/* An edge has two ends, and two points across from it: in its first triangle, which has
 * the ends in this order, and in its second; -1 where it is on the rim. */
struct mesh_edge {
    int node[4], triangle[2];
};

/* Returns where a triangle's corner is in the plane [m]. */
static inline const double *mesh_flat_place(const struct mesh_flat *flat, int triangle,
                                            int corner)
{
    return flat->corner ? flat->corner[triangle][corner]
                        : flat->at[flat->triangle[triangle][corner]];
}

/* Returns which corner of a triangle a node is. */
static inline int mesh_flat_corner(const int triangle[3], int node)
{
    return triangle[0] == node ? 0 : triangle[1] == node ? 1 : 2;
}

/* Adds room for a start in space and for corners' places; both are 0 still. */
enum status mesh_flat_raise(struct mesh_flat *flat);

/* Makes room for so many nodes and triangles, of which there are none yet. */
enum status mesh_flat_make(struct mesh_flat *flat, int nodes, int triangles);
void mesh_flat_clear(struct mesh_flat *flat);

/* Finds the edges: (*edge)[*count], and, unless NULL, (*side)[triangles][3], the edges
 * across from a triangle's points; both are owned by the caller. STATUS_INPUT where three
 * triangles meet at an edge: *count is then the third of them. */
enum status mesh_flat_edges(const struct mesh_flat *flat, struct mesh_edge **edge,
                            int *count, int (**side)[3]);

/* Fills next[nodes] with the node that follows each along the rim, which has the sheet to
 * its left; -1 inside. Returns a triangle at a node that the rim passes twice, or -1. */
int mesh_flat_rim(const struct mesh_flat *flat, const struct mesh_edge *edge, int edges,
                  int *next);

/* Fills piece[nodes] with the least node of the piece that each is in. */
void mesh_flat_pieces(const struct mesh_flat *flat, int *piece);

/* Returns how far c lies to the left of the way from a to b, times its length: twice the
 * area of the three. */
static inline double mesh_flat_left(const double a[2], const double b[2], const double c[2])
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/* Computes the weights of a triangle's corners at p in the plane; returns the least. */
double mesh_flat_weigh(const struct mesh_flat *flat, int triangle, const double p[2],
                       double weight[3]);

/* Returns the square of the distance of p from the segment from a to b. */
static inline double mesh_flat_off2(const double a[2], const double b[2], const double p[2])
{
    const double d[2] = {b[0] - a[0], b[1] - a[1]}, e[2] = {p[0] - a[0], p[1] - a[1]};
    const double square = d[0] * d[0] + d[1] * d[1];
    const double along = square > 0 ? (e[0] * d[0] + e[1] * d[1]) / square : 0;
    const double s = fmin(fmax(along, 0), 1);
    const double off[2] = {e[0] - s * d[0], e[1] - s * d[1]};

    return off[0] * off[0] + off[1] * off[1];
}

/* Returns twice the area of three nodes, positive if counter-clockwise. */
double mesh_flat_area2(const struct mesh_flat *flat, int a, int b, int c);

/* Tells whether all triangles have more than twice an area. */
bool mesh_flat_good(const struct mesh_flat *flat, double least);

/* Turns the edge k, between two triangles, into their other diagonal; tells whether that
 * makes it Delaunay's, and turns edges until all are (Lawson 1977); scale: a triangle's
 * area squared. */
void mesh_flat_turn(struct mesh_flat *flat, struct mesh_edge *edge, int (*side)[3], int k);
bool mesh_flat_turns(const struct mesh_flat *flat, const struct mesh_edge *edge,
                     double scale);
void mesh_flat_improve(struct mesh_flat *flat, struct mesh_edge *edge, int edges,
                       int (*side)[3], double scale);

/* Returns the next number in [-1, 1]: splitmix64 (Steele, Lea and Flood 2014). */
double mesh_flat_random(uint64_t *state);

/* Cuts the cells of n x m points, number i m + j, by diagonals: neighbouring cells by
 * different ones, so that they meet at points with even i + j, or all by the same. */
enum status mesh_flat_grid(struct mesh_flat *flat, const double size[2],
                           const int points[2], bool alternate);

/* Cuts each triangle into four. */
enum status mesh_flat_refine(struct mesh_flat *flat);

#endif

/* mesh_cells.h - the triangles of a mesh and what is beside them, for who goes from one to
 * the next; all of it borrowed from the mesh.
 *
 * Points have one place each in the flat pattern. A sheet that is sewn together, whose
 * points may have several, has the places where it starts instead: distances along it are
 * those, straight across, which is no farther.
 */
#ifndef MESH_CELLS_H
#define MESH_CELLS_H

#include "models/mesh_flat.h"

struct mesh_cells {
    int count;                    /* triangles                                            */
    const int (*corner)[3];       /* [count] counter-clockwise in the pattern             */
    const int (*side)[3];         /* [count] edges across from corners                    */
    const struct mesh_edge *edge; /* mesh_flat.h                                          */
    const int *ring_at, *ring;    /* [points + 1] triangles around points                 */
    const double (*at)[2];        /* [points] places in the flat pattern            [m]   */
    const double (*start)[3];     /* [points] where a sheet begins that is sewn together;
                                     NULL: at its places in the pattern             [m]   */
    const double *area;           /* [points] a third of the triangles around       [m^2] */
};

/* Returns the triangle on the other side of the edge across from a corner, -1 at the
 * border.
 */
int mesh_cells_across(const struct mesh_cells *c, int triangle, int corner);

/* Returns the triangle with the next edge of the border beyond a point, from that with the
 * one before, of which `last` is the other end: goes round the point. */
int mesh_cells_round(const struct mesh_cells *c, int triangle, int point, int last);

/* List the points of which a triangle is the first one around them, the edges of which it
 * is the first one beside them, and the numbers of its edges on the border; return how
 * many. */
int mesh_cells_points(const struct mesh_cells *c, int triangle, int point[3]);
int mesh_cells_edges(const struct mesh_cells *c, int triangle, int edge[3][2]);
int mesh_cells_rims(const struct mesh_cells *c, int triangle, int edge[3]);

/* Computes the mean normal of the triangles around a point by their areas, as long as they
 * are stretched: of length 1 on a sheet at rest, at the border, too. */
void mesh_cells_normal(const struct mesh_cells *c, const double *y, int point,
                       double normal[3]);

/* Returns by how much this normal changes at most, over how far the points move against
 * each other, up to `most`. */
double mesh_cells_turn(const struct mesh_cells *c, const double *y, int point, double most);

/* Computes the derivatives of places y[points][3] in a triangle by those in the pattern. */
void mesh_cells_slopes(const struct mesh_cells *c, const double *y, int triangle,
                       double along_u[3], double along_v[3]);

#endif

/* mesh.h - a net of points over the mid-surface of each sheet: where they are, what is
 * theirs of the area, which of them are clamped, and the surface between them. Nobody else
 * knows how points are numbered, but for what goes over a grid's rows and says so.
 *
 * A mesh has triangles and edges, in any order, and may have a turn at each edge's middle,
 * or a slope (triangles/tri_shell.h): nodes behind the points, whose first component is the
 * unknown, or all three are.
 *
 * A grid has n x m points a sheet, node i m + j of the first at (u,v) = (i/(n-1),
 * j/(m-1)). The rows of several sheets follow each other, and nothing connects the last
 * row of one with the first of the next.
 *
 * A point has no rotation, so that holding it does not clamp the sheet there; but a solid's
 * column, held through the whole thickness in x, y and z, cannot turn. Points of such
 * columns are clamped: who bends the sheet keeps its direction there.
 */
#ifndef MESH_H
#define MESH_H

#include <stddef.h>

#include "models/contact/contact_surface.h"
#include "models/discretization.h"
#include "models/supports.h"
#include "models/mesh_flat.h"

struct mesh {
    int nodes;      /* points, and turns behind them                                   */
    int vertices;   /* the points among them                                           */
    int points[2];  /* of a grid: rows of all sheets, points of a row; a mesh is one row */
    int rows;       /* of one sheet; 0: it is no grid                                   */
    double cell[2]; /* a_u, a_v; of a mesh the mean width of a point, twice     [m]     */
    void *room;     /* memory of the arrays                                    owned   */
    double (*uvw)[3]; /* [nodes] material parameters, w = 1/2                          */
    double *rest;     /* [nodes][3]                                            [m]     */
    double *area;     /* [nodes] of the sheet that is theirs                   [m^2]   */
    bool *clamped;    /* [nodes] of held columns that cannot turn                      */
    struct mesh_flat flat;  /* triangles; none of a grid without turns          owned   */
    struct mesh_edge *edge; /* [edges]                                          owned   */
    int edges, (*side)[3];  /* [triangles] mesh_flat.h                          owned   */
    double scale;   /* of turns and slopes: the mean width of a point          [m]     */
    double size[2]; /* of the sheet                                            [m]     */
    void *lists;    /* memory of ring and bin                                  owned   */
    int *ring_at, *ring; /* [vertices + 1] triangles around points                      */
    int *bin_at, *bin, bins[2]; /* triangles that reach bins of the plane, to find them */
};

/* Makes the grid of a scene; points: n, m >= 2 of a sheet. */
enum status mesh_init(struct mesh *mesh, const struct scene *scene, const int points[2]);

/* A mesh has no nodes at its edges, or turns there, which are 0 at rest, or the sheet's
 * slopes across them. A slope is at rest the direction outward from the first triangle, as
 * long as mesh->scale. */
enum mesh_edges { MESH_NO_NODES, MESH_TURNS, MESH_SLOPES };

/* Makes the mesh that a discretization asks for, which has nodes at edges only where the
 * sheet is flat and the only one. STATUS_INPUT with a sentence. */
enum status mesh_make(struct mesh *mesh, const struct scene *scene,
                      const struct discretization *d, enum mesh_edges at_edges,
                      struct message *why);
void mesh_clear(struct mesh *mesh);

/* Tells whether a discretization asks for a grid, which a sheet with an outline has not. */
bool mesh_is_grid(const struct scene *scene, const struct discretization *d);

/* A triangle in the sheet's plane: its area, and of the sides across from its points the
 * lengths, directions and outward normals. */
struct mesh_plane {
    double area, length[3], along[3][2], out[3][2];
};

struct mesh_plane mesh_plane_of(const struct mesh *mesh, int triangle);

/* Tells whether the plane ends at an edge: at the rim, and at a seam. */
bool mesh_edge_ends(const struct mesh *mesh, int edge);

/* Returns an edge's length at rest, of a seam the mean of both sides' [m]. */
double mesh_edge_length(const struct mesh *mesh, int edge);

/* Returns how the hat function of point j rises along the normal out of side i [1/m]. */
double mesh_plane_rise(const struct mesh_plane *p, int i, int j);

/* Returns the triangle at u, v of a mesh with triangles, or the nearest that its bin has,
 * and the weights of its points; -1: the bin has none. */
int mesh_find(const struct mesh *mesh, const double uv[2], double weight[3]);

/* Returns the node di rows and dj places from (i, j), or -1 beyond the rim of its sheet. */
int mesh_beside(const struct mesh *mesh, int i, int j, int di, int dj);

/* Tells whether the node (i, j) lies on a rim of its sheet along u (0) or v (1). */
bool mesh_on_rim(const struct mesh *mesh, int i, int j, int along);

/* Tells whether the net has what can bend: three points in line, or a clamp. */
bool mesh_bends(const struct mesh *mesh);

/* Adds what nodes at edges have in explicit steps to mass[nodes], for `areal` kg/m^2: that
 * of Morley's cubic, A h^2 / 30 times it from each triangle beside, h its height over the
 * edge. */
void mesh_weigh_edges(const struct mesh *mesh, double areal, double *mass);

/* Marks the clamped points. */
void mesh_clamp(struct mesh *mesh, const struct scene *scene);

/* Adds the scene's loads to f[vertices][3] of a mesh with triangles. STATUS_INPUT where one
 * lies beside them, which the scene's reader refuses with a sentence. */
enum status mesh_add_loads(const struct mesh *mesh, const struct scene *scene, double *f);

/* Computes the scene's loads on the points, by their hat functions: *dead[nodes][3] [N],
 * owned by the caller; NULL if there are none. */
enum status mesh_loads(const struct mesh *mesh, const struct scene *scene, double **dead);

/* Makes the surface that contact sees, whose samples are the points. The mesh must stay
 * where it is. */
enum status mesh_contact(const struct mesh *mesh, const struct scene *scene,
                         struct contact_surface *surface);

/* Makes an order of the nodes for a factorisation, owned by the caller; NULL: any. */
enum status mesh_order(const struct mesh *mesh, int **order);

/* Makes it for a mesh with triangles: along the longer side of the sheet. */
enum status mesh_order_plane(const struct mesh *mesh, int **order);

/* Positions of a net: component c of node a at x[a node + c component], borrowed. */
struct mesh_field {
    const double *x;
    ptrdiff_t node, component;
    int degree; /* 2 or 3: points are a B-spline's control points (a grid's only); 0: the
                   surface is bilinear in each cell                                     */
};

/* Evaluates material points uvw[n][3] of the scene's sheets, xyz[n][3]: the surface and
 * (w - 1/2) thickness along its unit normal. In cells that is the mean of the cell's four
 * points' normals, so that a thick sheet has no gaps between cells: of tangents by central
 * differences, one-sided on the rim. No normal where they are parallel.
 *
 * Beyond a rim a control net (Li et al. 2019 have springs between these) goes on straight,
 * which is a spline's natural end: a flat net is the sheet itself, rims are splines of the
 * points on them, and its corners are points. */
void mesh_sample(const struct mesh *mesh, const struct scene *scene,
                 const struct mesh_field *field, int n, const double *uvw, double *xyz);

#endif

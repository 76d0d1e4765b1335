/* tri_body.h - strains, internal forces and tangents of a whole net of triangles: constant
 * strain in each, and bending. The elements of the large body
 * are the net's strips.
 */
#ifndef TRI_BODY_H
#define TRI_BODY_H

#include "models/mechanics/large_body.h"
#include "models/net/spring_plate.h"
#include "models/net/spring_form.h"
#include "models/net/spring_sweep.h"
#include "models/scene.h"

/* A triangle's membrane strain, as a function of how its material directions u and v are
 * stretched: with the tangents X_u, X_v per metre of material, C = (X_u . X_u, X_v . X_v,
 * X_u . X_v), and strains e = (along u, along v, shear) that vanish for C = (1, 1, 0) and
 * there have the same first derivatives, so that all are one law for small strains.
 *
 *   green          (C - I) / 2: St. Venant and Kirchhoff's energy, no root; weak under
 *                  strong pressure.
 *   corotational   U - I, U = sqrt(C) (Biot's strain; the energy |F - R|^2 of corotational
 *                  methods, R the rotation next to F).
 *   baraff_witkin  |X_u| - 1, |X_v| - 1 and X_u . X_v: the conditions of Baraff and Witkin
 *                  1998 (Kim 2020, "A finite element formulation of Baraff-Witkin cloth").
 *                  They are not coupled: tri_strain_stiffness leaves C12 out.
 */

struct tri_strain {
    double e[3];       /* [1] */
    double J[3][3];    /* de_k / dC_l                                                     */
    double H[3][3][3]; /* d2e_k / dC_l dC_m                                            */
};

/* A grid (mesh.h) as triangles, with what bends it.
 *
 * Every cell is cut along one diagonal, and neighbouring cells along different ones: the
 * diagonals meet at the points with even i + j, which have eight triangles, four of them
 * across from the right angles that the other points have ("union jack"). So none is
 * preferred over the net as a whole, as one diagonal throughout would be, and the net can
 * fold along the lines and both diagonals; both diagonals in every cell would make rigid
 * plates of the cells (six lengths hold four points), and a point in the middle of each
 * cell would double the points and halve the explicit step.
 * Every point has the same part of the area, and cells have exactly the stiffness of plane
 * stress under homogeneous strain, for every nu.
 *
 * Bending, per point or edge:
 *   quadratic  spring_plate.h: a constant second derivative, the scene's D and nu.
 *   hinge      k theta^2 / 2 at inner edges (tri_hinge.h). With its right angles at one of
 *              its ends, an edge along v between cells turns by a_u x_uu there, one along u
 *              by a_v x_vv; a diagonal of length l turns by l x_uv. Edges count with either
 *              end, cells with either diagonal, half each: at every point the same. (The
 *              cut's own angles alone measure x_uu at every other point of a line, which
 *              then folds at the others for next to nothing.) With k = D a_v / 2 a_u,
 *              D a_u / 2 a_v and D a_u a_v / l^2 the energy is
 *                  D/2 int |x_uu|^2 + |x_vv|^2 + 2 |x_uv|^2,
 *              D under bending about any axis, and the Gaussian curvature of a plate with
 *              nu = 0. (On square cells that is a third of Grinspun et al.'s
 *              3 |e|^2 / (A_1 + A_2) of each edge, which is meant for irregular triangles.)
 * Clamps are those of spring_plate.h in both.
 */

/* Node 0 has the right angle; 1 lies beside it along u, 2 along v. */
struct tri_triangle {
    int node[3];
    double side[2]; /* +-1: node 1 (2) has the larger u (v), or the smaller            */
    long pair[6];   /* (0,0), (0,1), (0,2), (1,1), (1,2), (2,2) in the graph           */
};

struct tri_hinge {
    int node[4]; /* tri_hinge.h                                                        */
    double stiffness; /*                                                       [N m]   */
    long pair[10];
};

/* A net of triangles, in strips: strip i has what has its least row of points at row i, and
 * reaches rows i to i + 2. */
struct tri_net {
    const struct mesh *mesh; /*                                               borrowed */
    void *room;              /* of the arrays                                 owned   */
    int triangle_count, hinge_count;
    struct tri_triangle *triangles;
    struct tri_hinge *hinges;
    int *triangle_at, *hinge_at; /* [n + 1] first of each strip                       */
    struct spring_forms forms;   /* of the plate, by strips                    owned   */
    struct spring_soft soft;     /*                                            owned   */
    struct blocks graph;
    double *plate; /* [pairs] second derivative of forms, times the identity
                      [N/m], owned                                                     */
};

/* Makes the triangles of a mesh, which must stay where it is. */
enum status tri_net_init(struct tri_net *net, const struct scene *scene,
                         const struct mesh *mesh, enum bending bending);
void tri_net_clear(struct tri_net *net);

struct tri_body {
    const struct tri_net *net; /* borrowed                                             */
    enum membrane membrane;
    double D[SCENE_MAX_SHEETS][LAW_ENTRIES]; /* tri_strain_stiffness of sheets [N/m]   */
    double area; /* of a triangle                                              [m^2]   */
    int forms_from, hinges_from; /* where a strip's strains of bending start             */
    struct large_body body;      /* the lag is for the membrane                        */
    int *slab;                   /*                                            owned   */
    struct tri_body_room *work;  /* [threads]                                  owned   */
};

/* Prepares; `net`, *b must stay where they are. Threads: as many as OpenMP would give
 * now. */
enum status tri_body_init(struct tri_body *b, const struct scene *scene,
                          const struct tri_net *net, enum membrane membrane);
void tri_body_clear(struct tri_body *b);

/* Returns elastic energy at x[nodes][3] [J]: NaN where a triangle has no area. */
double tri_body_energy(const struct tri_body *b, const double *x);

#endif

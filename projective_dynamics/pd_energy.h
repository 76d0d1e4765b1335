/* pd_energy.h - the sheet's elastic energy as projective dynamics writes it: sums of
 * squared distances to sets on which a constraint holds (Bouaziz et al. 2014, eq. 8).
 *
 * Stretch by edges: 1/2 k (|x_b - x_a| - l)^2 on structural and diagonal edges; the set is
 * a sphere. Or by triangles, two a cell, F = [x_u/du, x_v/dv] with singular values s1, s2:
 *   A [ deviator (s1 - s2)^2 / 4 + trace (s1 + s2 - 2)^2 / 4 ],
 * the distances to the conformal F and to those of mean stretch 1. Equal weights give the
 * distance to the rotations, Bouaziz's strain constraint with the range [1,1].
 *
 * Bending by rows 1/2 w |sum_k c_k x_k - target|^2 of second differences: on a flat rest
 * shape the length of the mean-curvature vector that is kept is zero, so that the nearest
 * point of the set is a constant (Bergou et al. 2006: isometric bending is quadratic) and
 * bending lies in the constant matrix alone.
 *
 * Parameter sets:
 *   paper    weights 10 and 10, total mass 1 kg (Ren et al. 2024, Fig. 6). What a weight
 *            multiplies is not said. Ours: each constraint is w times a strain, squared,
 * over its part of the sheet, as in the solver that Bouaziz's group published: 1/2 w^2 l
 * (|e|/l - 1)^2 for an edge, 1/2 w^2 A |F - R|^2 for a triangle; bending 1/2 w A |x_uu +
 * x_vv|^2 with the scale 1 m^2. matched  triangles: deviator E h/(1 + nu), trace E h/(1 -
 * nu): small strains cost what plane stress costs, at every nu. Edges: springs with the
 * C11, C22 and C33 of plane stress; their C12 equals C33, which is right at nu = 1/3 only.
 * Bending: the plate's D and nu.
 *
 * Clamps: a clamped node (mesh.h) with a clamped neighbour keeps the slope across the line
 * through both, which in an area are two: a mirrored ghost node gives the row 1/2 w |2 (x_1
 * - x_0 - du e_u) / du^2|^2. A point support, and one on part of the thickness (a hinge),
 * keep positions only; so do all supports of the paper's set.
 *
 * A mesh that is no grid has F = sum of x_j times the gradient of j's hat function; its
 * edges are spring_net.h's, and bending is spring_plate.h's, with slopes that are nodes
 * without mass.
 */
#ifndef PD_ENERGY_H
#define PD_ENERGY_H

#include "models/discretization.h"
#include "models/scene.h"
#include "projective_dynamics/pd_net.h"

/* The constraints that resist stretching; auto: edges for fabrics, whose warp and weft
 * triangles, which know but E and nu, can't tell apart. */
enum constraint { CONSTRAINT_AUTO, CONSTRAINT_TRIANGLES, CONSTRAINT_EDGES };
extern const char *const pd_energy_constraints[]; /* NULL ends */

enum { PD_ROW = 6 };

struct pd_row {
    int count, node[PD_ROW];
    double coefficient[PD_ROW]; /* [1/m^2]                                             */
    double weight;              /* [N m^3]                                             */
    double target[3];           /* [1/m] zero, but for clamps                          */
};

/* A part of the constant matrix, k g g^T, g = x_b - x_a. */
struct pd_link {
    int a, b;
    ptrdiff_t at;  /* of a grid: pd_local.h's weight, kind pd_net_stride + k           */
    double weight; /* k                                                        [N/m]   */
    double length; /*                                                          [m]     */
};

struct pd_triangle {
    int node[3];
    double size;       /* its area over that of those below                            */
    double rise[3][2]; /* gradients of the hat functions                       [1/m]   */
};

struct pd_energy {
    const struct mesh *mesh; /*                                              borrowed  */
    struct pd_net net;
    enum constraint constraint;
    double *fields; /* memory of the next two                               owned     */
    double *mass;   /* lumped, per node [kg]                                          */
    double *rest;   /* [3] fields                                                     */
    void *room;     /* memory of the next two                               owned     */
    struct pd_link *links;         /* edges that resist, those of triangles, too       */
    struct pd_triangle *triangles; /* those of a mesh that is no grid                  */
    int link_count, triangle_count;
    double deviator, trace; /* weights of a triangle of half a cell, its area included
                               [N m]                                                   */
    double areal;           /* mass of an area                               [kg/m^2]  */
    int row_count;
    struct pd_row *rows; /* bending and clamps                               owned     */
    double rest_value;   /* energy at rest, from rounding alone [J]                    */
};

/* Makes the energy of a mesh, which must stay where it is. */
enum status pd_energy_init(struct pd_energy *e, const struct scene *scene,
                           const struct mesh *mesh, enum constraint constraint,
                           enum parameters parameters);
void pd_energy_clear(struct pd_energy *e);

/* Computes a triangle's tangents along u and v at x, three fields. */
void pd_energy_strain(const struct pd_energy *e, const struct pd_triangle *t,
                      const double *x, double F[2][3]);

/* Returns elastic energy [J] of positions x, three fields; 0 for the rest shape. */
double pd_energy_value(const struct pd_energy *e, const double *x);

#endif

/* tri_shell.h - a thin sheet on triangles of any shape: constant strains in each, and
 * bending by angles at edges, or by constant curvatures.
 *
 * Membrane: Green's strain, with St. Venant and Kirchhoff's energy. It is that of the three
 * edges, e_i = (|x_i|^2 - l_i^2) / 2 l_i^2, energy 1/2 e P e with a constant P. As springs,
 * edges know nothing of each other: P is diagonal, sqrt(3)/4 E h l_i^2 of each triangle
 * (Lloyd, Szekely and Harders 2007, which is exact for equilateral triangles and nu = 1/3).
 *
 * Bending, theta the angle between the normals of an edge's two triangles:
 *   hinge    k theta^2 / 2 with k = D l^2 / (A1 + A2) (Seung and Nelson 1988, for
 *            equilateral triangles). It bends as the mesh is drawn: cut one way throughout,
 *            3 % too soft on the finest nets, too.
 *   midedge  Morley's element (1968) at large displacements (Grinspun, Gingold, Reisman,
 *            Zorin 2006): an edge has one unknown, its turn phi, by which the direction at
 *            its middle leans from the mean of both normals: from a triangle's own outward
 *            by al = theta / 2 + phi in the first, theta / 2 - phi in the second, al = phi
 *            on a rim. The curvature of a triangle, sum over its edges of (l / A) al n n^t,
 *            n their normals in the plane, is constant; energy 1/2 al Q al with a constant
 *            Q, for any bending matrix. It converges with second order on every mesh.
 *   quadratic  spring_plate.h: Morley's element for each component of the places.
 *
 * Arcs: a triangle that bends is flat, and its edges are chords; between points that a
 * bent sheet has, they are shorter than the sheet by (k l)^2 / 24 of their length l, k the
 * curvature along them, so that the membrane locks: its energy over bending's is k^2 l^4 /
 * 48 h^2. With `arc` that is added to e_i, k the mean of the triangles on both sides (each
 * triangle's own would be as many constraints as there are unknowns). It cures what bends
 * evenly over several triangles, and spoils what wrinkles in one or two.
 *
 * Clamps: an edge of which both ends are clamped keeps the direction that the triangle had
 * at rest, and its angle counts whole: al = theta.
 *
 * The unknown of a turn or slope is that times mesh->scale, a length, so that all are
 * lengths. In implicit steps turns have no mass; in explicit ones mesh_weigh_edges's.
 */
#ifndef TRI_SHELL_H
#define TRI_SHELL_H

#include "models/linalg/blocks.h"
#include "models/mechanics/large_body.h"
#include "models/mesh/mesh.h"
#include "models/net/spring_plate.h"
#include "models/net/spring_sweep.h"

struct tri_shell {
    const struct mesh *mesh; /*                                              borrowed  */
    enum bending bending;
    struct blocks graph;
    struct large_body body; /* one element, the whole: one thread's                     */
    void *room;             /* of the arrays                                   owned   */
    struct tri_shell_triangle *triangle; /* [triangles]                                */
    struct tri_shell_angle *angle;
    int angles;
    long (*pairs)[9], (*angle_pairs)[4]; /* of all triangles and angles                 */
    struct spring_forms forms; /* of bending=quadratic                         owned   */
    double *plate;             /* [pairs] their second derivatives; or NULL    owned   */
    bool arc;
    int arcs;           /* [arcs] of edges, and of clamps from each side            */
    double *bow, *pull; /* work: [arcs] k [1/m]; the membrane's on it times l^2/12
                           [N m]; NULL without arcs                                 */
    double *x[2], *strain, *moment; /* work: at x, of the geometry [nodes][3]; strains of
                                       membrane, angles, turns; [angles]                */
    double (*gradient)[12]; /* work: [angles]                                           */
    double *angle_now;      /* work: angles and turns of the geometry; NULL without arcs */
};

/* Makes the sheet of a flat scene with one sheet; membrane: green or springs; arc: with
 * midedge and green only. mesh has triangles, and turns with midedge, slopes with
 * quadratic; it and *s must stay where they are. */
enum status tri_shell_init(struct tri_shell *s, const struct scene *scene,
                           const struct mesh *mesh, enum membrane membrane,
                           enum bending bending, bool arc);
void tri_shell_clear(struct tri_shell *s);

/* Returns elastic energy at x[nodes][3] [J]: NaN where a triangle has no area. */
double tri_shell_energy(const struct tri_shell *s, const double *x);

#endif

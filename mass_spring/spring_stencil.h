/* spring_stencil.h - a net as what each point feels of its neighbours, for explicit steps.
 *
 * Membrane: the net's springs with an energy in squares of lengths, which needs no root:
 *     k (l^2 - r^2)^2 / 8 r^2,  force  k (l^2 - r^2) / 2 r^2  times the edge,
 * k (l - r)^2 / 2 for small strains, and stiffer by (3 (l/r)^2 - 1) / 2 when stretched.
 *
 * Bending: Kirchhoff's plate by differences about the flat rest shape, quadratic in the
 * positions (after Bergou et al. 2006, "A quadratic bending model for inextensible
 * surfaces", here on a regular net), exact in the scene's nu:
 *     B/2 int |x_uu|^2 + |x_vv|^2 + 2 nu x_uu x_vv + 2 (1 - nu) |x_uv|^2,
 * x_uu and x_vv at points, x_uv in cells. Along a rim, across which no moment is borne, the
 * strip bends as a beam: factor 1 - nu^2 and no nu x_uu x_vv.
 *
 * Clamps: at a held column that cannot turn, the curvature of the cubic that leaves the
 * point x0 along e with the free neighbours x1, x2 on it,
 *     kappa a^2 = 4 (x1 - x0 - a e) - (x2 - x0 - 2 a e) / 2,
 * over half a cell; with one free neighbour alone that of the parabola, 2 (x1 - x0 - a e).
 */
#ifndef SPRING_STENCIL_H
#define SPRING_STENCIL_H

#include "mass_spring/spring_net.h"

enum { SPRING_STENCIL_NEAR = 8, SPRING_STENCIL_ALL = 12 };

/* Steps (in i, in j) to the neighbours: those that share a cell first. */
extern const int spring_stencil_step[SPRING_STENCIL_ALL][2];

struct spring_stencil {
    const struct spring_net *net; /* borrowed                                          */
    void *room;                   /* of the arrays                             owned   */
    double (*spring)[SPRING_STENCIL_ALL]; /* [nodes] k / 2 r^2; 0: none [N/m^3]  */
    double square[SPRING_STENCIL_ALL]; /* r^2                                      [m^2]  */
    double (*bend)[SPRING_STENCIL_ALL]; /* [nodes] force towards a neighbour, per metre of
                                    edge                                     [N/m]    */
    double (*clamp)[3]; /* [nodes] constant force of clamps          [N]     */
};

/* After spring_net_init; `net` must stay where it is. No bending where its law has none. */
enum status spring_stencil_init(struct spring_stencil *s, const struct scene *scene,
                                const struct spring_net *net);
void spring_stencil_clear(struct spring_stencil *s);

/* The neighbour's node, or -1 beyond the rim. */
int spring_stencil_node(const struct spring_net *net, int node, int neighbour);

/* Elastic energy at x[nodes][3] [J], zero at rest up to round-off. */
double spring_stencil_energy(const struct spring_stencil *s, const double *x);

/* f[nodes][3] -= its derivative [N]. */
void spring_stencil_force_add(const struct spring_stencil *s, const double *x, double *f);

/* Its second derivative at x, K[pairs of net->graph][9] [N/m]; pairs with held points that
 * the graph leaves out are left out. clamped: springs that are pressed do not push aside,
 * and K is positive semi-definite. */
void spring_stencil_jacobian(const struct spring_stencil *s, const double *x, bool clamped,
                             double (*K)[9]);

/* Largest (l/r)^2 of a spring at x[nodes][3] [1]. */
double spring_stencil_stretch2(const struct spring_stencil *s, const double *x);

#endif

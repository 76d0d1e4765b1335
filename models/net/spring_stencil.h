/* spring_stencil.h - a net as what each point feels of its neighbours, for explicit steps.
 *
 * Membrane: the net's springs with an energy in squares of lengths, which needs no root:
 *     k (l^2 - r^2)^2 / 8 r^2,  force  k (l^2 - r^2) / 2 r^2  times the edge,
 * k (l - r)^2 / 2 for small strains, and stiffer by (3 (l/r)^2 - 1) / 2 when stretched.
 *
 * Bending and clamps: the quadratic plate of spring_plate.h.
 */
#ifndef SPRING_STENCIL_H
#define SPRING_STENCIL_H

#include "models/net/spring_net.h"
#include "models/net/spring_plate.h"

enum { SPRING_STENCIL_NEAR = 8, SPRING_STENCIL_ALL = 12 };

/* Steps (in i, in j) to the neighbours: those that share a cell first. */
extern const int spring_stencil_step[SPRING_STENCIL_ALL][2];

struct spring_stencil {
    const struct mesh *mesh;          /* borrowed                                      */
    const struct spring_net *springs; /* or NULL                              borrowed */
    void *room; /* memory of the arrays                      owned   */
    double (*spring)[SPRING_STENCIL_ALL]; /* [nodes] k / 2 r^2; 0: none [N/m^3]  */
    double square[SPRING_STENCIL_ALL]; /* r^2 of edges                             [m^2]  */
    double (*bend)[SPRING_STENCIL_ALL]; /* [nodes] force towards a neighbour, per metre of
                                    edge                                     [N/m]    */
    double (*clamp)[3];      /* [nodes] constant force of clamps          [N]     */
    struct spring_soft soft; /* explicit steps do not know it                 owned  */
};

/* Initialises with the springs of a mesh, or NULL, and these forms. Springs and mesh must
 * stay where they are. */
enum status spring_stencil_init(struct spring_stencil *s, const struct scene *scene,
                                const struct mesh *mesh, const struct spring_net *springs,
                                const struct spring_forms *forms);
void spring_stencil_clear(struct spring_stencil *s);

/* Returns the neighbour's node, or -1 beyond the rim. */
int spring_stencil_node(const struct mesh *mesh, int node, int neighbour);

/* Returns elastic energy at x[nodes][3] [J], zero at rest up to round-off. */
double spring_stencil_energy(const struct spring_stencil *s, const double *x);

/* Returns the largest (l/r)^2 of an edge at x[nodes][3] [1]. */
double spring_stencil_stretch2(const struct spring_stencil *s, const double *x);

#endif

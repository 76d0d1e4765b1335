/* vb_body.h - a net of points as each of its points sees it: the elements beside a point,
 * the force on it, and the block of the tangent that is its own (Chen, Liu, Yang, Yuksel
 * 2024, "Vertex block descent", ACM Trans. Graph. 43(4), eq. 6-8).
 *
 * Elements are triangles of constant Green strain, or springs; bending is the quadratic
 * form of spring_plate.h, or hinges. Of a block that part of the geometric stiffness is
 * left out that could make it indefinite: all of a hinge's, and that of pressure; forces
 * are exact, so that what iterations end at does not depend on it.
 */
#ifndef VB_BODY_H
#define VB_BODY_H

#include "models/net/spring_net.h"
#include "triangles/tri_body.h"

/* A triangle at one of its corners: of the tangents X_u and X_v, a change of the corner
 * changes `share`. With e_d = x_node[1 + d] - x_node[0], X_d = side[d] e_d + skew[d]
 * e_(1-d); a grid's have no skew. */
struct vb_corner {
    int node[3];
    double area, side[2], skew[2], share[2]; /*                         [m^2], [1/m]   */
};

struct vb_spring {
    int other;
    double stiffness, length; /*                                        [N/m], [m]     */
};

/* An entry of the plate's constant matrix. */
struct vb_plate {
    int other;
    double stiffness; /*                                                       [N/m]   */
};

struct vb_hinge {
    const struct tri_hinge *hinge; /*                                        borrowed  */
    int corner;                    /* of its four nodes                                */
};

struct vb_body {
    int nodes;
    double D[3][3]; /* plane stress                                             [N/m]  */
    void *room;     /* of the arrays                                            owned  */
    /* [nodes + 1] where the elements of each node begin in the lists below */
    int *corners_from, *springs_from, *plates_from, *hinges_from;
    struct vb_corner *corner;
    struct vb_spring *spring;
    struct vb_plate *plate; /* with the node itself                                    */
    struct vb_hinge *hinge;
    double *pull; /* [nodes][3] constant force of clamps                    [N]   */
    int colours;
    int *order;        /* [nodes] by colour: those of one colour share no element      */
    int *colours_from; /* [nodes + 1] the first colours + 1 are used                    */
};

/* A body is made of these, which are borrowed until it is cleared. */
struct vb_parts {
    const struct mesh *mesh;
    const double *D;                  /* [LAW_ENTRIES] of the membrane         [N/m]   */
    const struct spring_forms *forms; /* bending, with its matrix                      */
    const struct blocks *graph;
    const double *plate;
    const struct tri_net
        *net; /* triangles of a grid, and hinges; NULL: those of the mesh */
    const struct spring_net *springs; /* in place of triangles, unless NULL            */
};

/* Lists the elements of a net. */
enum status vb_body_init(struct vb_body *b, const struct vb_parts *parts);
void vb_body_clear(struct vb_body *b);

/* The step's function: sum of inertia |x - target|^2 / 2 over the nodes, and the energy. */
struct vb_step {
    const double *inertia; /* [nodes]                                          [N/m]   */
    const double *target;  /* [nodes][3]                                       [m]     */
    const int *place;      /* [nodes][3] negative: held                                */
};

/* Moves each point of x[nodes][3] once to where the step's function, quadratic in its
 * place alone, is least: colour by colour. The same bits for every number of threads. */
void vb_body_sweep(const struct vb_body *b, const struct vb_step *s, double *x);

/* Computes the step's force at every point, force[nodes][3] [N]. */
void vb_body_force(const struct vb_body *b, const struct vb_step *s, const double *x,
                   double *force);

#endif

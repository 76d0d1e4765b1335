/* pd_bending.h - bending and clamps as quadratic rows of second differences (pd_energy.h).
 */
#ifndef PD_BENDING_H
#define PD_BENDING_H

#include "models/scene.h"
#include "projective_dynamics/pd_net.h"

struct pd_row {
    int count, node[5];
    double coefficient[5]; /* [1/m^2]                                                  */
    double weight;         /* [N m^3]                                                  */
    double target[3];      /* [1/m] zero, but for clamps                               */
};

/* The list to which rows are added. */
struct pd_bending {
    const struct pd_net *net; /*                                             borrowed */
    const double *area;       /* [nodes]                            [m^2]    borrowed */
    struct pd_row *rows;      /* room for PD_BENDING_ROWS a node             borrowed */
    int count;
};

/* The most rows of a node: two curvatures, a twist, two clamps. */
enum { PD_BENDING_ROWS = 5 };

/* Adds the plate's energy with the scene's D and nu, and clamps at `clamped` nodes. */
void pd_bending_plate(struct pd_bending *b, const struct scene *scene, const bool *clamped);

/* Adds weight/2 area |x_uu + x_vv|^2 at every node; along the rim the term that exists. */
void pd_bending_mean_curvature(struct pd_bending *b, double weight);

#endif

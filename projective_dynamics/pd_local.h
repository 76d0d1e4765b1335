/* pd_local.h - the local step: finds every constraint's nearest point and sums per node.
 *
 * Chunks of nodes are fixed by the net and handed out to threads; a chunk computes all the
 * projections that its nodes need, a few of them its neighbour's too, and sums them per
 * node in fixed order. The result does not depend on the number of threads. A mesh that is
 * no grid is done by one.
 */
#ifndef PD_LOCAL_H
#define PD_LOCAL_H

#include "projective_dynamics/pd_energy.h"

struct pd_local {
    const struct pd_energy *energy; /*                                       borrowed  */
    double factor;                  /* on all weights                                  */
    double *weight;                 /* fields: factor k l of each kind of edge, or the share
                                       of triangles at k that exist (0 or 1)  owned     */
    int chunk, threads;
    double *buffer; /* [threads][fields of a chunk]                          owned     */
    /* Split triangles: weight of the split over the larger one of the two that resist, and
     * [12] fields, six of each triangle at k: what stretch its elastic force lets them lack
     * at that weight, now and next (of a mesh that is no grid: [triangles][6], in place);
     * share 0 and NULL without                                                   owned  */
    double share;
    double *dual, *dual_next;
};

enum status pd_local_init(struct pd_local *local, const struct pd_energy *energy,
                          double factor, double share);
void pd_local_clear(struct pd_local *local);

/* Computes b = base + factor sum over the stretch constraints of w G^T p(G x), p the
 * nearest point. x, base and b: three fields each, of pd_net_stride.
 *
 * Split, as ADMM has it (Overby, Brown, Li, Narain 2017), with a weight W of its own:
 *     z = argmin U(z) + W/2 |G x + u - z|^2,  u <- u + G x - z,  w p becomes W (z - u).
 * With W = w that takes as many iterations as above; with the geometric mean of w and of
 * what inertia resists with, the root of that. u stays from step to step. */
void pd_local_step(struct pd_local *local, const double *x, const double *base, double *b);

/* Computes the same b without the split, for its matrix: A x - b is then the slope of the
 * step's energy. */
void pd_local_forces(struct pd_local *local, const double *x, const double *base,
                     double *b);

#endif

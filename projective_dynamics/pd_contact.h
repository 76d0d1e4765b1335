/* pd_contact.h - obstacles in the global step: of all positions outside the obstacles the
 * nearest, in the metric of the constant matrix, to what the step would give without them.
 *
 * Nodes stay half a thickness off: the surface that is sampled lies at -/+ h/2 along the
 * normal of the mid-surface, and touches where the sheet lies flat on an obstacle.
 *
 * Each iteration replaces an obstacle by its tangent plane at the nearest point of the last
 * iterate (the step's start in the first), which lies outside a convex obstacle, so that no
 * node is inside it after any iteration. With y the free result, C the active normals and
 * g(y) the gaps there, x = y + A^-1 C^T p, where
 *     S p = -g(y) on the active set, p >= 0, g(x) >= 0, p g(x) = 0,   S = C A^-1 C^T:
 * the dual of a strictly convex quadratic program; the matrix of the global step stays as
 * it was factored. The active set is found by block pivoting, all that is wrong swapped at
 * once; when that stops getting better, one by one, which ends for every positive definite
 * S (Murty 1974; Judice and Pires 1994). Bouaziz et al. 2014 meet obstacles with weighted
 * constraints in the local step, which give way; Ly et al. 2020 split A for contact, which
 * is exact in the limit of many iterations only.
 *
 * Friction (Coulomb), in turns with the above, the forces of the one fixed in the other:
 * the tangents of nodes that stick are held to where they were at the step's start, S
 * again; the force of one that slips follows projected gradients on the disc of radius mu
 * p, p of the last turn, and so ends against its way. Sticking ends when it takes more than
 * mu p, slipping when the way is along the force. On planes of one direction neither sees
 * the other; where the turns do not settle at once, the next iteration goes on. After a
 * fixed number of iterations friction on a curved obstacle may exceed mu p by what p still
 * changes; at a small tolerance it does not
 * (tests/projective_dynamics/projective_dynamics_contact.c).
 */
#ifndef PD_CONTACT_H
#define PD_CONTACT_H

#include "projective_dynamics/pd_dual.h"

enum pd_rub { PD_RUB_NONE, PD_RUB_STICK, PD_RUB_SLIP };

/* The most times that a node may come to stick in a step; later it slips. */
enum { PD_CONTACT_CHANGES = 4 };

/* One node before one obstacle: number = obstacle x nodes + node. */
struct pd_touch {
    bool closed;
    enum pd_rub rub;
    int changes;       /* changes to sticking in this step                             */
    double press;      /* p >= 0 if closed                                     [kg m]  */
    double tangent[3]; /* force across the normal, in the same unit                    */
};

struct pd_contact {
    const struct scene *scene; /*                                            borrowed  */
    struct pd_system *system;  /*                                            borrowed  */
    const double *mass;        /* [nodes]                               [kg] borrowed  */
    struct pd_dual dual;
    double scale;           /* Chebyshev's weight, by which x is overshot; else 1      */
    bool friction;          /* any obstacle has it                                     */
    int nodes, count;       /* touches                                                 */
    struct pd_touch *touch; /* [count]                                       owned     */
    int row_count, row_room;
    void *row_memory;              /* of the rows                            owned     */
    struct pd_push *row;           /* of the present active set                        */
    int *row_touch;                /* [rows]                                           */
    double *row_value, *row_error; /* [rows]                                           */
    /* three fields each: without obstacles' forces; with those of slipping nodes; the push
     * of the present rows                                                     owned   */
    double *alone, *free, *way;
    bool stale;      /* free holds tangents that are no more                        */
    double force[3]; /* on the sheet in the last iteration                  [kg m]  */
    int pressed;     /* nodes that carried any of it                                */
};

/* Gaps are closed to this share of the sheet's length: round-off of solving with A. */
#define PD_CONTACT_CLOSED 1e-12

/* Initialises. STATUS_INPUT with a sentence if a node of the rest shape, three fields, lies
 * in an obstacle. */
enum status pd_contact_init(struct pd_contact *c, const struct scene *scene,
                            struct pd_system *system, const double *mass,
                            const double *rest, struct message *why);
void pd_contact_clear(struct pd_contact *c);

/* Moves x, three fields, the free result of a global step, out of the obstacles. from: the
 * last iterate, start: the step's start. STATUS_DIVERGED if no active set was found. */
enum status pd_contact_apply(struct pd_contact *c, const double *from, const double *start,
                             double *x);

/* Return for touch t: its obstacle; the gap of its node at x [m], with the obstacle's
 * normal there, which may be NULL. */
const struct scene_obstacle *pd_contact_obstacle(const struct pd_contact *c, int t);
double pd_contact_normal(const struct pd_contact *c, int t, const double *x,
                         double normal[3]);

/* Make room for so many rows to be solved; add one, `error`: what is missing along it. */
enum status pd_contact_room(struct pd_contact *c, int rows);
void pd_contact_row(struct pd_contact *c, int t, const double direction[3], double error);

/* Judges Coulomb friction (pd_contact_rub.c) at x, three fields: who sticks, who slips and
 * which way, and the forces; *changed unless all was right. */
enum status pd_contact_rub(struct pd_contact *c, const double *from, const double *start,
                           const double *x, int *changed);

/* Returns the least gap of nodes at x to any obstacle, less h/2 [m]. */
double pd_contact_gap(const struct pd_contact *c, const double *x);

#endif

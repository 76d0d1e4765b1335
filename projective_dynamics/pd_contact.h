/* pd_contact.h - a global step that meets bodies by the law of the scene (models/contact).
 *
 * Here A is the constant matrix of the global step, y its free result, s^2 the square of
 * its span, C the rows of the touches and f(x) the forces at them, A x = A y + s^2 C^T
 * f(x). Newton's method starts from the last iterate, which is outside of every wall, and
 * takes the forces f - K C d for a change d: (A + s^2 C^T K C) d = A (y - x) + s^2 C^T f.
 * A remains as it was factored: with R = s sqrt(K), S = C A^-1 C^T and the change d_0 by
 * the forces as they are,
 *     d = d_0 - A^-1 C^T R u,    (1 + R S R) u = R C d_0,
 * by conjugate gradients, each product a solve with A. K is symmetric: of friction it has
 * the drag of the last iterate.
 *
 * A change may end in a wall, or where forces are others by far. The next one then begins
 * where each touch with a body has the force of the law by itself (contact_project_bodies),
 * the others those of this change; on the way there nodes leave a tenth of their distance
 * to a wall. Where a body has moved over the sheet, the step's first change begins so, too.
 *
 * The features of bodies that are thinner than the net are met where the step has ended, as
 * by position_based: triangles that meet one share nodes, so that what each of them does by
 * itself throws the nodes through the body, and what is cut short of its change at every
 * touch stalls.
 *
 * No loop goes to its end: the next iteration of projective dynamics goes on where they
 * stopped. Where the iterations end, a step of implicit Euler has the forces of the law
 * (tests/projective_dynamics/projective_dynamics_contact.c). Beside this, Bouaziz et al.
 * 2014 meet obstacles with weighted constraints in the local step, and Ly et al. 2020 split
 * A for contact, which is exact in the limit of many iterations only.
 */
#ifndef PD_CONTACT_H
#define PD_CONTACT_H

#include "models/contact/contact.h"
#include "projective_dynamics/pd_system.h"

struct pd_contact {
    struct contact law;
    struct pd_system *system; /* NULL: nothing to meet                       borrowed  */
    const int *free_index;    /* [nodes][3] negative: held                   borrowed  */
    int features;             /* of thin bodies, which contact_thin.h's list has at the end
                                 of a step only                                        */
    double factor;            /* of forces, in the present global step       [s^2]     */
    bool begun;               /* the touches are those at `at`                         */
    void *room;               /* memory of the next seven                     owned     */
    double *at, *change;      /* [nodes][3] last iterate; its change         [m]       */
    double *pushed;           /* [nodes][3] A^-1 C^T v                       [m]       */
    double *force;            /* [nodes][3] minus those that make the change [N]       */
    double *goal;             /* [nodes][3] where it ends                    [m]       */
    double *alone;            /* [nodes][3] see find_change                  [m]       */
    double *compliance;       /* [nodes] by a force, others held             [m/N]     */
    double *field;            /* three fields, work                          owned     */
    int rows;                 /* numbers for which there is room                       */
    void *row_room;           /* memory of the next five                     owned     */
    double *residual, *scaled, *direction, *product, *start; /* [touches][3] */
    long solves; /* with A so far                  */
};

/* Initialises for a scene that has something to meet. */
enum status pd_contact_init(struct pd_contact *c, const struct scene *scene,
                            struct pd_system *system, const struct mesh *mesh,
                            const int *free_index);
void pd_contact_clear(struct pd_contact *c);

/* Begins a step [t, t + dt] at `start`, three fields. */
void pd_contact_begin(struct pd_contact *c, double t, double dt, const double *start);

/* Moves x, three fields, from the free result of a global step to where contact takes it.
 * factor: s^2, times the weight by which the result was overshot. */
enum status pd_contact_apply(struct pd_contact *c, double factor, double *x);

/* Ends a step at x, three fields, outside of what is thinner than the net; adds `share` of
 * the forces by that to body[obstacles]. factor: the move of a unit of mass by a unit of
 * force. */
enum status pd_contact_end(struct pd_contact *c, double factor, double *x, double share,
                           double (*body)[6]);

/* Finds touches and forces at x, three fields. */
enum status pd_contact_find(struct pd_contact *c, const double *x);

#endif

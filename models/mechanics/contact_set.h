/* contact_set.h - the nodes of a model that touch obstacles: an active set for steps whose
 * matrix stays symmetric positive definite.
 *
 * A node may not move beyond the tangent plane of an obstacle at its nearest point:
 *     n . (x_new - x_old) >= -(gap(x_old) - offset),
 * and obstacles are convex, so that the new gap is at least what the plane says. Where such
 * a pair of node and obstacle is active, the inequality is an equation, whose multiplier is
 * the contact force. A node touches as many obstacles at once as have independent normals;
 * nodes whose components are all held by supports touch none.
 *
 * Friction is Coulomb's, as a drag on the motion along the surface (contact_solve.h).
 */
#ifndef CONTACT_SET_H
#define CONTACT_SET_H

#include "models/linalg/blocks.h"
#include "models/mechanics/supports.h"
#include "models/model.h"

struct contact_pair {
    double gap;       /* less the offset, where the step starts               [m]      */
    double normal[3]; /* there                                                         */
    double lambda;    /* multiplier; zero if not active                                */
    bool active;
};

struct contact_node {
    int touches;        /* independent active pairs                             0..3    */
    int obstacle[3];    /* [touches] theirs                                             */
    double base[3][3];  /* [touches] orthonormal, spans their normals                   */
    double dual[3][3];  /* [touches] in that span, dual[i] . normal[j] = delta_ij       */
    double drag;        /* friction is -drag times x - still along the surface          */
    double friction[3]; /* the force of that                                           */
    int trend;   /* passes of this step in which the drag has grown; shrunk: negative    */
    bool sticks; /* it is below its limit                                        */
    double force[3]; /* of all obstacles on the node, friction included              */
};

/* Multipliers and forces are in the units of the right-hand side. */
struct contact_set {
    const struct scene *scene;   /* borrowed                                           */
    const struct supports *held; /* borrowed                                           */
    int nodes, obstacles;
    double offset;   /* distance that nodes keep: 0, or h/2 of a mid-surface     [m]   */
    double rounding; /* round-off of positions, 1e-13 of the scene's size (sheet and
                        obstacles): gaps are closed to it                        [m]   */
    void *room;      /* of the arrays                                owned   */
    struct contact_pair *pair; /* [nodes][obstacles]                                   */
    struct contact_node *node; /* [nodes]                                              */
    double (*projector)[9];    /* [nodes] onto the directions left free                */
    unsigned char *touched;    /* [nodes] projector is not the identity                */
    double (*drag)[9];         /* [nodes] friction's part of the matrix                */
    double (*factored)[18];    /* [nodes] projector and drag of the present factor     */
    bool is_factored;
    bool settled;   /* the last solve left friction as it found it                     */
    long unsettled; /* steps whose friction was cut short (contact_solve.h)            */
    double *work;   /* [5][nodes][3]                                                   */
};

/* A normal adds a direction to others if the part of it outside their span is longer. */
static const double CONTACT_SET_INDEPENDENT = 1e-3;

/* Initialises; allocates nothing without obstacles: contact_set_used then says false. */
enum status contact_set_init(struct contact_set *c, const struct scene *scene,
                             const struct supports *held, double offset);
void contact_set_clear(struct contact_set *c);

bool contact_set_used(const struct contact_set *c);

/* Finds gaps and normals at the start of a step, x[nodes][3]. Keeps which pairs are active:
 * the step's first guess. */
void contact_set_detect(struct contact_set *c, const double *x);

/* Makes bases and projectors of the active pairs. Returns whether they or the drags differ
 * from those of the present factor. */
bool contact_set_project(struct contact_set *c);

/* Notes that the present projectors and drags are those of the factor. */
void contact_set_remember(struct contact_set *c);

/* Notes that the system's matrix is no longer the one that was factored. */
void contact_set_forget(struct contact_set *c);

/* Returns whether an obstacle carries any node. */
bool contact_set_any(const struct contact_set *c);

/* Computes v <- P v for P[nodes][9], c->projector or the like, v[nodes][3]. */
void contact_set_apply(const struct contact_set *c, const double (*P)[9], double *v);

/* Finds the smallest change[nodes][3] that takes from the rates v what the set forbids:
 * motion along normals, and any motion of nodes that stick. Returns its largest component;
 * the projectors P[nodes] leave what it may not touch. */
double contact_set_arrest(const struct contact_set *c, const double *v, double *change,
                          double (*P)[9]);

/* Subtracts from v[3] of node a its parts in held components and along its normals. */
void contact_set_along(const struct contact_set *c, int a, double v[3]);

/* Finds reactions at x[nodes][3] to the forces F[nodes][3] on a body at rest: those that
 * obstacles may have - they push, along normals, and rub within Coulomb's limit - and that
 * leave least of F, are subtracted from it and kept in lambda, force and sticks (below the
 * limit). Pairs farther apart than `touching` [m] become inactive. */
void contact_set_balance(struct contact_set *c, const double *x, double touching,
                         double *F);

/* Adds the obstacles' part of the tangent of a body at rest, after contact_set_balance:
 * springs of `stiffness` [N/m] along normals, and in all directions where a node sticks;
 * and where a ball pushes lambda / R, which destabilizes the more the smaller its radius
 * (the second derivative of the gap). K[pairs], diagonal blocks first in each of graph's
 * columns. */
void contact_set_stiffen(const struct contact_set *c, const struct blocks *graph,
                         double stiffness, double (*K)[9]);

/* Fills *report; x[nodes][3] are present positions, and forces are multiplied by `unit`. */
void contact_set_report(const struct contact_set *c, const double *x, double unit,
                        struct model_contact *report);

#endif

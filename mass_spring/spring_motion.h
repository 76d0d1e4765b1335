/* spring_motion.h - a net of springs in time.
 *
 * implicit   Euler's implicit method, in its variational form (spring_newton.h):
 *            m (x - x0 - dt v0) / dt^2 + c (x - x0) / dt = load + F(x),  v = (x - x0) / dt.
 * explicit   symplectic Euler: v from the forces at x0 (c implicit, for free), x from v.
 *            Stable up to a greatest step, `limit`. Without a number of sub-
 *            steps it takes as many as keep LIMIT_SHARE of it; with one, it may blow up.
 *
 * leapfrog   second order, fast, springs in squares of lengths and a quadratic bending
 *            (spring_leapfrog.h).
 *
 * momentum   implicit energy-momentum steps, second order, of leapfrog's springs and
 *            bending (march.h, spring_strips.h). It keeps its energy
 *            (clothbench verify energy); the membrane's viscosity takes what crumples.
 *
 * Contact is part of what Euler's implicit step minimises (spring_newton.h), and of
 * momentum's equation; it ends an explicit step, after strains are limited
 * (contact_project).
 *
 * Damping: mass and alpha are c = alpha m; beta is beta K V with the clamped Jacobian at
 * the start of the step, which is positive semi-definite: it only takes energy.
 * velocity_scale and velocity_rate act once a frame, whatever the substeps, on the velocity
 * of its end. Body drag is a force on each point. The paper's set has its own drag on
 * points and leaves the scene's damping out.
 */
#ifndef SPRING_MOTION_H
#define SPRING_MOTION_H

#include "models/mechanics/march.h"
#include "models/net/spring_leapfrog.h"
#include "mass_spring/spring_newton.h"
#include "mass_spring/spring_strips.h"

/* The surface of the net: the net itself, or the B-spline whose control points it has. */
enum spring_surface { SURFACE_NET, SURFACE_QUADRATIC, SURFACE_CUBIC };

struct spring_own {      /* choices of its own (models/option.h) */
    double strain_limit; /* Provot 1995: greatest elongation of a spring [1]; 0: none  */
    enum spring_surface surface;
};

enum { SPRING_GAINS = 5 };

struct spring_motion {
    struct march march; /* first: march.h; momentum only                        */
    struct net net;
    struct spring_net springs;
    struct spring_newton newton;
    enum integrator integrator;
    int degree; /* of the surface; 0: bilinear                                         */
    struct spring_limits limits;
    int substeps;
    double dt;              /* length of a substep                                 [s]   */
    double strain_limit;    /* 0: none                                                   */
    double limit;           /* greatest stable step of explicit methods about rest [s]   */
    double rest_energy;     /* round-off of the energy at rest                     [J]   */
    void *room;             /* memory of the arrays                         owned   */
    double *weight;         /* [nodes] m / dt^2 + c / dt                     [N/m]     */
    double *start, *target; /* [nodes][3] work                                         */
    double *gain;   /* [SPRING_GAINS][nodes][3] of velocity in the last step, and its
                       backward differences of orders 1, 2, ...                   [m/s] */
    int gains;      /* those that would have foretold the last gain best, in their sum  */
    double (*V)[9]; /* [pairs] with beta, else NULL                            */
    struct spring_stencil stencil;    /* leapfrog and momentum                         */
    struct spring_leapfrog *leapfrog; /* steps of that integrator, else NULL   owned   */
    struct spring_strips strips;      /* momentum only, as what follows                */
    long substep; /* taken so far                                                     */
};

/* Initialises; *m must stay where it is: it holds pointers into itself. */
enum status spring_motion_init(struct spring_motion *m, const struct scene *scene,
                               const struct discretization *d, struct message *why);
void spring_motion_clear(void *motion);

/* Implement model.h's entries for a struct spring_motion: step that of advance. */
enum status spring_motion_step(void *motion, struct counters *counters);
void spring_motion_contact(const void *motion, struct model_contact *contact);
void spring_motion_energy(const void *motion, struct energy *energy);

/* Returns leapfrog's and momentum's net; NULL: the net's own springs in lengths and
 * struts. */
const struct spring_stencil *spring_motion_stencil(const struct spring_motion *m);

/* Returns the elastic energy of x [J], with its round-off at rest. */
double spring_motion_elastic(const struct spring_motion *m);

/* Notes that the net stands still at x at time t [s]. */
void spring_motion_place(struct spring_motion *m, double t);

/* Moves free points of x[nodes][3] until no spring is longer than (1 + limit) times its
 * rest length; limit > 0. */
void spring_motion_limit(const struct spring_net *net, const struct supports *supports,
                         double limit, double *x);

#endif

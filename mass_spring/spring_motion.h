/* spring_motion.h - a net of springs in time.
 *
 * implicit   Euler's implicit method, of springs in lengths and of struts, by the march
 *            (spring_lengths.h); one Newton iteration of it (iterations = 1) is the
 *            linearised step of Baraff and Witkin 1998.
 * explicit   leapfrog steps of the same springs and struts, by the march
 *            (integrator_leapfrog.c).
 *
 * leapfrog   the same scheme, fast, of springs in squares of lengths and a quadratic
 *            bending (spring_leapfrog.h).
 *
 * momentum   implicit energy-momentum steps, second order, of leapfrog's springs and
 *            bending (march.h, spring_strips.h). It keeps its energy
 *            (clothbench verify energy); the membrane's viscosity takes what crumples.
 *
 * On a mesh that is no grid the same four step springs along its edges (spring_net.h) and
 * have a quadratic bending (spring_plate.h); in squares they are tri_shell.h's, in leapfrog
 * steps without a sweep.
 *
 * Strains are limited once a frame (Provot 1995).
 *
 * Damping: mass and alpha are c = alpha m; beta is beta V v with the clamped Jacobian at
 * the start of the step, which is positive semi-definite: it only takes energy.
 * velocity_scale and velocity_rate act once a frame, whatever the substeps, on the velocity
 * of its end. Body drag is a force on each point. The paper's set has its own drag on
 * points and leaves the scene's damping out.
 */
#ifndef SPRING_MOTION_H
#define SPRING_MOTION_H

#include "models/mechanics/march.h"
#include "models/net/spring_leapfrog.h"
#include "mass_spring/spring_lengths.h"
#include "mass_spring/spring_strips.h"
#include "triangles/tri_shell.h"

/* The surface of the net: the net itself, or the B-spline whose control points it has. */
enum spring_surface { SURFACE_NET, SURFACE_QUADRATIC, SURFACE_CUBIC };

struct spring_own {      /* choices of its own (models/option.h) */
    double strain_limit; /* Provot 1995: greatest elongation of a spring [1]; 0: none  */
    enum spring_surface surface;
};

struct spring_motion {
    struct march march; /* first: march.h                                              */
    const struct discretization *asked; /* borrowed                                    */
    struct net net;
    struct spring_net springs;
    enum integrator integrator;
    int degree; /* of the surface; 0: bilinear                                         */
    double strain_limit; /* 0: none                                                   */
    struct spring_lengths lengths; /* implicit and explicit                         */
    struct spring_stencil stencil; /* leapfrog and momentum, as what follows        */
    struct spring_strips strips;
    struct spring_body swept; /* leapfrog's                                           */
    struct tri_shell shell;   /* leapfrog and momentum on a mesh that is no grid         */
};

/* Initialises; *m must stay where it is: it holds pointers into itself. */
enum status spring_motion_init(struct spring_motion *m, const struct scene *scene,
                               const struct discretization *d, struct message *why);
void spring_motion_clear(void *motion);

/* Implement model.h's entries for a struct spring_motion: step that of advance. */
enum status spring_motion_step(void *motion, struct counters *counters);
void spring_motion_energy(const void *motion, struct energy *energy);

/* Moves free points of x[nodes][3] until no spring is longer than (1 + limit) times its
 * rest length; limit > 0. */
void spring_motion_limit(const struct spring_net *net, const struct supports *supports,
                         double limit, double *x);

#endif

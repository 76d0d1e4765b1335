/* spring_leapfrog.h - a net in time by explicit leapfrog steps, second order:
 *     v(n+1/2) = ((1 - c dt/2) v(n-1/2) + dt a(x(n))) / (1 + c dt/2),
 *     x(n+1) = x(n) + dt v(n+1/2),  v(n) = (v(n-1/2) + v(n+1/2)) / 2,
 * c the mass damping and drag of a point over its mass; the first kick is half a one.
 *
 * The steps of a frame are as many as keep 0.95 of the greatest stable step about rest,
 * sqrt(beta^2 + 4 / omega^2) - beta with stiffness damping beta. After every frame the
 * longest spring says how much stiffer the net has become, and the next frame takes more
 * steps if they would come within 2 % of the limit. A number of steps that was asked for is
 * kept: then it may blow up. Contact ends each step (contact_project).
 */
#ifndef SPRING_LEAPFROG_H
#define SPRING_LEAPFROG_H

#include "models/mechanics/march.h"
#include "models/net/net.h"
#include "models/net/spring_stencil.h"
#include "models/net/spring_sweep.h"

/* The net to be moved, the march's `moved`; all borrowed, and must outlive it. */
struct spring_body {
    struct net *net;
    const struct spring_stencil *stencil;
    const struct spring_cells *cells; /* NULL: the stencil's springs; else in their place */
};

/* The march's `own`. */
struct spring_leapfrog {
    struct spring_body body;
    const struct scene *scene; /* the net's                                            */
    struct net *net;           /* the body's                                           */
    struct spring_sweep *sweep;
    int asked, substeps;
    double limit, dt; /* [s] */
    long frame;
    void *room;
    double (*c)[SWEEP_COUNT];     /* [nodes]                                            */
    double *x, *v;                /* [nodes][3] of the sweep                            */
    double *before;               /* [nodes][3] positions before a step                 */
    double *now, *kicked, *ahead; /* [nodes][3] work                                   */
    double *shift;                /* [held_count] of held points now                    */
    double *next;                 /* [held_count] work                                  */
};

/* Starts from the net's x and v at time 0. */
extern const struct march_integrator spring_leapfrog_integrator;

/* Tells whether a scene has what the sweeps do not know: air, and supports that take hold
 * or let go. The march's explicit steps then take their place. */
bool spring_leapfrog_lacks(const struct scene *scene);

/* Notes that the net is at rest at its x at time t [s], a whole number of frames. */
void spring_leapfrog_place(struct spring_leapfrog *l, double t);

#endif

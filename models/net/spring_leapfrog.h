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

#include "models/net/net.h"
#include "models/net/spring_stencil.h"
#include "models/net/spring_sweep.h"

/* The net to be moved; all borrowed, and must outlive it. */
struct spring_body {
    struct net *net;
    const struct spring_stencil *stencil;
    const struct spring_cells *cells; /* NULL: the stencil's springs; else in their place */
};

struct spring_leapfrog; /* opaque */

/* Starts from the net's x and v at time 0. substeps: of a frame, 0: as many as are needed.
 * STATUS_INPUT with a sentence if they are more than a million. */
enum status spring_leapfrog_make(const struct spring_body *body, enum precision precision,
                                 int substeps, struct spring_leapfrog **leapfrog,
                                 struct message *why);
void spring_leapfrog_free(struct spring_leapfrog *l);

/* Moves one frame, scene->step; then damps the velocity. Positions go to the net's x.
 * STATUS_NAN, STATUS_MEMORY. */
enum status spring_leapfrog_frame(struct spring_leapfrog *l, struct counters *counters);

/* Notes that the net is at rest at its x at time t [s], a whole number of frames. */
void spring_leapfrog_place(struct spring_leapfrog *l, double t);

/* Computes the present velocities v[nodes][3]. */
void spring_leapfrog_velocity(const struct spring_leapfrog *l, double *v);

/* Return the step [s], and the greatest stable one about rest. */
double spring_leapfrog_step(const struct spring_leapfrog *l);
double spring_leapfrog_limit(const struct spring_leapfrog *l);

#endif

/* position_based_model.h - the model `position_based`. */
#ifndef POSITION_BASED_MODEL_H
#define POSITION_BASED_MODEL_H

#include "models/net/net.h"
#include "models/net/spring_net.h"
#include "models/net/spring_plate.h"
#include "position_based/pb_sweep.h"

/* A net in time by constraints on positions: XPBD (Macklin, Mueller, Chentanez 2016) in
 * small steps (Macklin et al. 2019), and PBD (Mueller et al. 2007).
 *
 * A step of dt: d <- (m dt v + dt^2 f) / (m + c dt), then every constraint C(x + d) = 0 is
 * projected in turn (pb_sweep.h), until the step has arrived (arrival.h) or as often as was
 * chosen; x <- x + d, v = d / dt. With
 * so many iterations that nothing moves this is implicit Euler's step but for one thing: a
 * spring has pulled along the directions that it had on the way, not along the last one.
 * That is of second order in what it turns in a step: 1e-6 of the way for steps of 4 ms,
 * 1e-4 of 16 ms (tests/position_based/position_based.c).
 *
 * Constraints and what compliance means. The springs of spring_law.h, C = l - r [m], have
 * the energy C^2 / 2 alpha with the compliance alpha = 1 / k [m/N]; on square cells
 *     alpha = 2 (1 - nu) / (E h)   along u and v,
 *     alpha = 2 (1 + nu) / (E h)   along diagonals,
 * whatever the cell's size. In pascals: a strip of width b, length a and thickness h has
 * E = a / (alpha b h); and if C is written as a strain, (l - r) / r, alpha is 1 / (E V), V
 * the volume that the spring stands for. Springs are plane stress at nu = 1/3 only
 * (spring_law.h). Bending: the sums of spring_plate.h, C = sum weight x [m] in each
 * component with alpha = 1 / stiffness: a^3 / (B b) for a strip, B = E h^3 / 12 (1 - nu^2).
 * A cantilever under a small load droops 1.35 % and 0.36 % too far on 9 and 17 rows.
 *
 * On a mesh that is no grid springs are its edges (spring_net.h), and bending the sums of
 * spring_plate.h for triangles, with slopes of mesh_weigh_edges's mass. They are projected
 * in their order, and backwards every other time.
 *
 * What an iteration leaves. A constraint that is projected once gives way as if its
 * compliance were greater by about dt^2 sum w: springs of mass m at both ends by 2 dt^2 /
 * m. Over alpha, that is the softening 2 k dt^2 / m, which goes with the square of the
 * step: small steps do more than iterations. Unless their number is given, there are so
 * many substeps that it is 10 at most. A cloth that hardly stretches does not mind; but
 * springs so soft store more than they push with, and a hard impact seems to add energy, on
 * the ball of tests/physics/contact_truth.c 1.4 times that of the fall at a softening of
 * 6.4, 23 % at 1.6, 3 % at 0.7 and none at 0.4; on the thinner sheet of `sphere` without
 * damping 84 % at 10, 3 % at 1 and 0.9 % at 0.4. It did so with impulses in place of the
 * law of contact, too. With contact the softening is 0.4 at most, for five times as many
 * substeps.
 * What is left of a step are the forces of implicit Euler's equation,
 *     (m + c dt) d / dt^2 - m v / dt - f + grad V(x + d),
 * V with as much bending as the substep has (below), and beta's resistance.
 *
 * Bending is soft, and is projected in every n-th substep with the strength of n: as long
 * as a bound of its fastest mode's phase from one to the next is 0.4 at most (an impulse
 * method; Grubmueller et al. 1991), which adds 3/8 0.4^2 = 6 % to its compliance at most.
 * Where a single substep is more, there are more substeps.
 *
 * PBD has no compliance: an iteration goes a share s of the way, so that stiffness depends
 * on step, mass and iterations. Here s is chosen so that one iteration goes as far as one
 * of XPBD does, s1 = sum w / (sum w + alpha / dt^2), and n iterations go
 * s = 1 - (1 - s1)^(1/n) each (Mueller et al. 2007, sec. 3.3).
 *
 * Damping: mass and alpha, and drag, are c; beta makes gamma = beta / dt of each constraint
 * (Macklin et al. 2016, eq. 26), its rate of change resisted, which turning is not. PBD has
 * none of that kind. velocity_scale and velocity_rate act once a frame. Contact ends
 * each step, after the projections (contact_project).
 *
 * Single precision: velocities as differences of positions of order L are wrong by 6e-8 L /
 * dt a step, a walk that after N steps has led N^1.5 / sqrt(3) * 6e-8 L away: edge_drop on
 * 16 x 16 points is 0.2 % of L off after 8000 steps and 44 % after 32000. Here d is kept by
 * itself, and what is left is the rounding of x, sqrt(N) * 6e-8 L: 0.002 and 0.005 %.
 */

/* The ways to move points back to constraints. */
enum projection {
    PROJECTION_XPBD, /* compliance (Macklin et al. 2016)                               */
    PROJECTION_PBD,  /* a share of the way an iteration (Mueller et al. 2007)          */
};

struct pb_own { /* choices of its own (models/option.h) */
    enum projection projection;
};

struct pb_motion {
    struct net net; /* first: net.h                                                    */
    struct spring_net springs;
    struct spring_forms forms; /*                                              owned   */
    struct pb_odd *odd;        /* the clamps among them; on a mesh all         owned   */
    struct pb_link *link;      /* on a mesh the springs                        owned   */
    struct pb_sweep *sweep;
    enum projection projection;
    struct arrival arrival;
    int substeps;
    int bending_every;   /* so many substeps                                           */
    double dt;           /* length of a substep                                  [s]    */
    double way[3];       /* of the sweep's origin in it                          [m]    */
    double softening;    /* greatest share that one iteration adds to a compliance [1]  */
    double rest_energy;  /* round-off of the energy at rest                      [J]    */
    long substep, frame; /* taken so far                                               */
    void *room;
    double *before, *work; /* [3][nodes][3]                                            */
};

/* Initialises; *m must stay where it is: it holds pointers into itself. */
enum status pb_motion_init(struct pb_motion *m, const struct scene *scene,
                           const struct discretization *d, struct message *why);
void pb_motion_clear(void *motion);

/* Implement model.h's entries for a struct pb_motion: frame that of advance. STATUS_NAN. */
enum status pb_motion_frame(void *motion, struct counters *counters);
void pb_motion_energy(const void *motion, struct energy *energy);

extern const struct model position_based_model;

#endif

/* tri_motion.h - a net of triangles in time.
 *
 * momentum  large_motion.h: energy-momentum steps, second order, Newton's method.
 * implicit  Euler's implicit steps, Newton's method; iterations = 1: one linear solve a
 *           step (Baraff and Witkin 1998).
 * leapfrog  explicit, second order: spring_leapfrog.h's sweeps; with hinges, whose forces
 *           no sweep knows, large_leapfrog.h's steps.
 *
 * Mass is lumped: every point has its part of the area. A point has no slope to hold: where
 * a column is held whole, clamps hold it (spring_plate.h); a support that takes the
 * mid-surface or single components alone is a hinge.
 */
#ifndef TRI_MOTION_H
#define TRI_MOTION_H

#include "models/net/spring_large.h"
#include "models/net/spring_leapfrog.h"
#include "triangles/tri_body.h"

struct tri_own { /* choices of its own (models/option.h) */
    enum membrane membrane;
};

struct tri_motion {
    const struct scene *scene;   /* borrowed                                             */
    bool swept;                  /* steps of spring_leapfrog.h                           */
    struct discretization asked; /* integrator, substeps, iterations, solver           */
    struct tri_net net;
    struct tri_body body;
    struct spring_load load;
    struct supports supports;
    struct spring_large large; /* empty in swept steps                                 */
    void *room;                /* of the arrays                                owned   */
    double *x;                 /* [nodes][3] present points                    [m]     */
    struct spring_cells cells; /* swept only, as what follows                        */
    struct spring_stencil stencil;
    struct spring_leapfrog *leapfrog; /*                                       owned   */
    double *v;                        /* [nodes][3] work                         [m/s] */
    long frame;
    double rest_energy; /* round-off of the energy at rest                       [J]   */
};

/* Initialises; *m must stay where it is: it holds pointers into itself. */
enum status tri_motion_init(struct tri_motion *m, const struct scene *scene,
                            const struct discretization *d, struct message *why);
void tri_motion_clear(void *motion);

/* Implement model.h's entries advance, equilibrium, modes, matrices, contact and energy;
 * the state is a struct tri_motion. */
enum status tri_motion_step(void *state, struct counters *counters);
enum status tri_motion_rest(void *state, struct counters *counters, struct message *why);
enum status tri_motion_modes(void *state, int count, double *omega, struct message *why);
enum status tri_motion_matrices(const void *state, struct matrix *K, struct matrix *M);
void tri_motion_contact(const void *state, struct model_contact *contact);
void tri_motion_energy(const void *state, struct energy *energy);

#endif

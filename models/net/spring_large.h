/* spring_large.h - nets of points in implicit steps at large displacements: large_motion.h
 * with lumped masses, for springs and for triangles. Energy-momentum steps, second order,
 * or (integrator=implicit) Euler's; with large_leapfrog_make's explicit ones.
 */
#ifndef SPRING_LARGE_H
#define SPRING_LARGE_H

#include "models/net/spring_load.h"
#include "models/mechanics/large_motion.h"

/* The parts of the moving net; all borrowed, and must outlive it. */
struct spring_large_plan {
    const struct spring_load *load;
    const struct blocks *graph; /* couplings that elements reach, 2 rows at most       */
    const struct large_body *body;
    struct supports *supports;
    const struct discretization *d; /* integrator, substeps, iterations, solver        */
    double *x;                      /* [nodes][3] present points                 [m]   */
};

struct spring_large {
    const struct spring_load *load; /* borrowed                                        */
    int substeps;
    struct large_motion motion;
    struct newmark newmark;
    struct system system;
    struct contact contact; /* all zero where there is nothing to meet            */
    void *room;             /* memory of the arrays                       owned   */
    double *M;              /* [pairs] lumped mass                        [kg]    */
    double *held;           /* [4][held_count] work                               */
    double (*K)[9];         /* [pairs] room for tangents                  [N/m]   */
};

/* Initialises at rest. *l must stay where it is: it holds pointers into itself.
 * STATUS_INPUT if the sheet begins in an obstacle. */
enum status spring_large_init(struct spring_large *l, const struct spring_large_plan *plan);
void spring_large_clear(struct spring_large *l);

/* Notes that x is at rest: no velocity, and no history of steps. */
void spring_large_still(struct spring_large *l);

/* Takes one step of scene->step from time t. */
enum status spring_large_frame(struct spring_large *l, double t, struct counters *counters);

#endif

/* stress_run.h - a run of a hard case, on its way to an error. */
#ifndef STRESS_RUN_H
#define STRESS_RUN_H

#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "bench/stress/stress_result.h"
#include "bench/truth/truth.h"
#include "fem_ref/kirchhoff.h"

struct stress_run {
    const struct stress_job *job; /*                                          borrowed */
    struct run run;
    struct stress_result *result; /* to be filled                             borrowed */
    double *xyz, *first;          /* fields (grid.h), room for judges            owned */
    struct kirchhoff *plate;      /* of the judges that need it                  owned */
    double load;                  /* on that plate [N/m^2]                             */
    struct energy *energies;      /* [frame_count + 1]                           owned */
    int frames;                   /* of energies                                       */
    struct truth *truth;          /* of STRESS_SHELL                             owned */
    motion_watcher *watch;
};

/* The case's scene and the contestant's numerics, E from Gamma; errors as run_read. */
enum status stress_run_read(const struct stress_job *job, struct run *run,
                            struct message *why);

/* Through the scene's motion, watch(run) at every frame (NULL: nobody); a death leaves its
 * time and sentence. */
enum status stress_run_move(struct stress_run *r, motion_watcher *watch,
                            struct message *why);

/* To static equilibrium; by damped motion where the model has no other way. */
enum status stress_run_settle(struct stress_run *r, struct message *why);

/* How far a material point has come from rest [m]. */
void stress_run_displacement(const struct stress_run *r, const double uvw[3], double d[3]);

/* The error at a frame: the greatest is the run's, and the bound is kept until its first
 * above that. */
void stress_run_note(struct stress_run *r, double time, double error);

#endif

/* timing.h - times several runs fairly: repeats interleaved (run 1, 2, ..., 1, 2, ...)
 * against drift of the machine, each on a fresh state, warm-up steps not counted. Seconds
 * of steps are those of the processor, on one thread (timing_alone): another program that
 * takes turns with this one does not count, though it may slow it down. */
#ifndef TIMING_H
#define TIMING_H

#include "bench/harness/run.h"

/* The repeats of runs that take up to TIMING_SHORT seconds, and of longer ones. */
enum { TIMING_REPEATS = 9, TIMING_REPEATS_LONG = 3, TIMING_REPEATS_QUICK = 3 };
#define TIMING_SHORT 0.2

/* Returns the number of repeats of a run that takes so many seconds. */
int timing_repeats(double seconds, bool quick);

struct timing_case {
    const struct run *run; /* read; a fresh state is built for every repeat    borrowed */
    int warmup, frames;    /* steps not counted, and counted, of each repeat            */
    bool rest;             /* static equilibrium is timed instead: frames = 1           */
    int repeats;           /* 0: by the rule above, from the first repeat's seconds      */
    double until;          /* when a motion is stopped (deadline.h); 0: never            */
    double *create;        /* [repeats]           set-up                   [s]           */
    double *advance; /* [repeats][frames]   one time step each; NaN after a death         */
    double bytes;    /* that the model holds after the last step (clock_allocated)       */
    struct arena arena; /* of create and advance                                  owned  */
};

struct timing_plan {
    bool quick; /* three repeats of everything that says 0 */
    /* Called after each repeat of a run; NULL: not called. */
    void (*progress)(void *context, int done, int total);
    void *context;
};

/* Fills repeats, create and advance of every case. Every step of them must have been judged
 * before (motion.h): frames beyond a death are not asked for. On failure they are freed and
 * NULL. */
enum status timing_run(const struct timing_plan *plan, int count, struct timing_case *cases,
                       struct message *why);
void timing_clear(struct timing_case *c);

/* Limits the program to one thread on one processor: timings compare models, not
 * schedulers. */
void timing_alone(void);

/* Takes that back in a process of its own, which stays on one thread. */
void timing_apart(void);

/* Returns the number of processors that the program may use, before timing_alone or now. */
int timing_processors(void);

#endif

/* timing.h - seconds of several cases, fairly: repeats interleaved (case 1, 2, ..., 1, 2,
 * ...) against drift of the machine, each on a fresh state, warm-up steps not counted.
 */
#ifndef OLDTIMING_H
#define OLDTIMING_H

#include <stdbool.h>

#include "models/model.h"

struct oldtiming_case {
    const struct model *model;
    const struct scene *scene; /* borrowed                                */
    const struct discretization *discretization; /* borrowed                           */
    int frames;      /* of a repeat, where a frame's cost changes along the motion; 0: the
                        plan's, after its warm-up                                      */
    bool rest;       /* static equilibrium is timed instead: frames = 1                */
    double *create;  /* [repeats]           set-up                    [s]      owned   */
    double *advance; /* [repeats][frames]   one time step each; NaN after a death  owned */
};

struct oldtiming_plan {
    int repeats, warmup, frames;
    /* Called after each run of a case; NULL: not. */
    void (*progress)(void *context, int done, int total);
    void *context;
};

/* Fills create and advance of every case. On failure they are freed and NULL. */
enum status oldtiming_run(const struct oldtiming_plan *plan, int count,
                          struct oldtiming_case *cases, struct message *why);
void oldtiming_clear(struct oldtiming_case *c);

/* Keeps this thread on the processor it runs on; returns its number, -1 if that is refused.
 */
int oldtiming_pin(void);

#endif

/* run.h - a case (case.h) as it is run. Every number of the program comes from runs. They
 * are opened here, moved by motion.h, stored by run_file.h. */
#ifndef RUN_H
#define RUN_H

#include "bench/harness/case.h"

struct run {
    const struct contestant *contestant;
    const struct model *model;
    struct scene scene;
    struct discretization discretization;
    void *state; /* of the model; NULL: it could not be built                */
    double create_seconds;
    struct message adapted; /* where defaults gave way to settings; empty: nowhere      */
};

/* Opens a run; *run is overwritten. On failure it keeps what was read so far: the scene if
 * only the model could not be built on it. Call run_close in any case. */
enum status run_open(struct run *run, const struct case_plan *c, struct message *why);

/* The two halves of run_open, for callers that change run->scene or run->discretization
 * between: reading them, then building the model. Errors as above. */
enum status run_read(struct run *run, const struct case_plan *c, struct message *why);
enum status run_build(struct run *run, struct message *why);

/* Moves to static equilibrium. STATUS_UNSUPPORTED with a sentence: the model has none. */
enum status run_settle(struct run *run, struct counters *work, struct message *why);

/* Finds the `count` lowest angular frequencies omega[] (model.h). Errors as above. */
enum status run_modes(struct run *run, int count, double *omega, struct message *why);

void run_close(struct run *run);

#endif

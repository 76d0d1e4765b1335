/* run.h - what every number of the program comes from: a contestant on a scene, with
 * settings. Opened here, moved by motion.h, kept by run_file.h.
 */
#ifndef RUN_H
#define RUN_H

#include "bench/harness/contestant.h"

struct run_plan {     /* all borrowed */
    const char *path; /* of the scene file, or a scene's name                           */
    const struct contestant *contestant;
    const struct settings *settings; /* on top of the contestant's; NULL: none          */
    double end;                      /* instead of the scene's; 0: the scene's [s]      */
};

struct run {
    const struct contestant *contestant;
    const struct model *model;
    struct scene scene;
    struct discretization discretization;
    void *state; /* of the model; NULL: it could not be built                */
    double create_seconds;
    struct message adapted; /* where defaults gave way to settings; empty: nowhere      */
};

/* *run is overwritten. In case of failure it keeps what was read so far: the scene if only
 * the model could not be built on it. Call run_close in any case. */
enum status run_open(struct run *run, const struct run_plan *plan, struct message *why);

/* The two halves of it, for who changes something in between: run->scene and
 * run->discretization as read; then the model. Errors as above. */
enum status run_read(struct run *run, const struct run_plan *plan, struct message *why);
enum status run_build(struct run *run, struct message *why);

/* To static equilibrium. STATUS_UNSUPPORTED with a sentence: the model has none. */
enum status run_settle(struct run *run, struct counters *work, struct message *why);

/* The `count` lowest angular frequencies into omega[] (model.h). Likewise. */
enum status run_modes(struct run *run, int count, double *omega, struct message *why);

void run_close(struct run *run);

#endif

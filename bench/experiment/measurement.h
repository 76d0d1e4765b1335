/* measurement.h - runs that are measured together: each is followed once, judged at every
 * frame and kept as a result file, then all are timed in turn (timing.h) and their seconds,
 * every repeat, go into the files.
 */
#ifndef MEASUREMENT_H
#define MEASUREMENT_H

#include <stdio.h>

#include "bench/harness/run_file.h"

enum measurement_frames {
    MEASUREMENT_FAIR, /* WHOLE where the cost of a frame changes along the motion (Newton's
                         iterations, contact), SOME where it does not                   */
    MEASUREMENT_SOME, /* twenty after two: where a frame costs the same all along the motion
                       */
    MEASUREMENT_WHOLE, /* all that it lives through */
    MEASUREMENT_UNTIMED,
};

struct measurement_case {
    struct run_plan plan;
    struct run_keep keep; /* its file is needed                                        */
    bool rest;            /* static equilibrium instead of motion                      */
    enum measurement_frames timed;
    int repeats; /* 0: as the options have it                                          */
    bool phases; /* a solid that is rebuilt: also its phases, apart                    */
};

struct measurement_options {
    const char *what; /* for the progress bar                                          */
    bool quick;       /* fewer repeats and frames                                      */
    int repeats;      /* 0: as the cases or timing.h have them                         */
    void (*progress)(void *context, const char *what, int done, int total); /* or NULL */
    void *context;
};

/* Deaths and refusals are results. */
enum status measurement_run(const struct measurement_options *options, int count,
                            const struct measurement_case *cases, struct message *why);

/* Words on how much of `all` seconds a processor was had: milliseconds of a busy machine
 * are too long, and a reader should know. */
void measurement_share(double processor, double all, FILE *file);

/* A line on where the run in a result file was measured; nothing if it cannot be read. */
void measurement_machine(const char *path, FILE *file);

#endif

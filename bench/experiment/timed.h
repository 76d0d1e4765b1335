/* timed.h - cases whose frames are timed together (timing.h), and the result file (store.h)
 * that each of them leaves: what was built, positions and work done at some times, seconds
 * of every repeat.
 */
#ifndef TIMED_H
#define TIMED_H

#include <stdio.h>

#include "bench/speed/bench_solid.h"
#include "bench/experiment/exhibit.h"
#include "bench/files/provenance.h"
#include "bench/files/store_read.h"
#include "models/clock.h"

enum { TIMED_PATH = 4096 };

struct timed_case {
    const struct model *model;
    const struct scene *scene; /* NULL: the case is left out                 borrowed  */
    struct discretization d;   /* owns nothing                                         */
    char path[TIMED_PATH];     /* of the result file, NAME.h5                          */
    int times;                 /* 0: static equilibrium is kept, and timed if `rest`   */
    bool rest;
    const double *time; /* [times] kept, increasing                 [s] borrowed */
    int frames;         /* as in timing.h; 0: twenty, after two untimed          */
    bool phases;        /* a solid that is rebuilt: also its phases, apart       */

    struct store *store; /* timed.c's                                                  */
};

/* Follows every case over its times, then times all in turn: nine repeats, three if quick.
 * `what` is for the progress bar. Deaths are results. What a model does not serve is, too:
 * a sentence in NAME.txt instead of NAME.h5. */
enum status timed_measure(const struct experiment_options *options, const char *what,
                          const struct provenance *provenance, int count,
                          struct timed_case *cases, struct message *why);

/* Leaves a sentence in NAME.txt instead of a run in NAME.h5. */
enum status timed_refuse(const char *path, const char *sentence, struct message *why);

/* What a table needs of such a file. */
struct timed_result {
    char *refused; /* the model's sentence; then nothing else is there           owned */
    char *outcome; /* "done" or the sentence of a death, with its time           owned */
    double unknowns, factor_entries;
    struct counters work; /* up to the last frame kept                                 */
    struct clock_summary create, step;             /* [s]; count = 0: not timed; step: a
                                                      frame, or the equilibrium      */
    struct clock_summary phase[BENCH_SOLID_FRAME]; /* [s]; count = 0: not timed     */
};
enum status timed_read(const char *path, struct timed_result *r, struct message *why);
void timed_clear(struct timed_result *r);

/* Summary, over the repeats, of each one's mean over its frames (a death leaves some out)
 * of seconds/NAME in the file; untouched if there is no such array. */
enum status timed_seconds(const struct store_read *file, const char *name,
                          struct clock_summary *summary, struct message *why);

/* A line on where the run in a result file was measured; nothing if it cannot be read. */
void timed_machine(const char *path, FILE *file);

#endif

/* measurement.h - measures runs together: each is followed once, judged at every frame and
 * kept as a result file, then all are timed in turn (timing.h) and their seconds, every
 * repeat, go into the files.
 */
#ifndef MEASUREMENT_H
#define MEASUREMENT_H

#include <stdio.h>

#include "bench/harness/pool.h"
#include "bench/harness/run_file.h"

/* The share of a timing in which the program must have had a processor, for its seconds to
 * be judged: programs that take turns also empty each other's caches. */
#define MEASUREMENT_PROCESSOR 0.9

/* Numbers of cases: those that an earlier call had finished, and all. */
struct measurement_taken {
    int taken, cases;
};

struct measurement_options {
    const char *what; /* words for the progress bar; NULL: none is shown               */
    bool quick;       /* fewer repeats and frames                                      */
    bool again;       /* files of earlier calls are not taken                          */
    double until;     /* of the budget (deadline.h); 0: there is none                   */
    struct measurement_taken *taken; /* is added to; NULL: not told                    */
    bool truth; /* looks of what is not timed keep their distance from the scene's truth */
    /* Slots, ranks and time limit of what is not timed; what that cost is left here. A case
       that comes to no result is one, too: its file has the sentence why, and the case's
       key unless it was cut short and has to be run again. NULL: as many slots as there are
       processors, and such a case ends all. */
    struct pool *pool;
};

/* Runs and times all cases, each into its file. Deaths and refusals are results. Files of
 * an earlier call are taken if their key is that of the case (case_key). Cases are timed in
 * turn in groups of some seconds, and a group's files are there as soon as it
 * is over: who stops it loses one group. Without a budget those that are not timed are
 * followed first, each in a process of its own. Other ranks than 0 do what that one hands
 * out, and nothing else.
 * STATUS_LATE: the budget was over before all were done. */
enum status measurement_run(const struct measurement_options *options, int count,
                            struct case_plan *cases, struct message *why);

/* Says on standard error "compare: 3 of 40 cases were taken from DIR"; nothing if none was.
 */
void measurement_tell(const char *what, const struct measurement_taken *taken,
                      const char *folder);

/* Prints a line on where the run in a result file was measured; nothing if it cannot be
 * read. */
void measurement_machine(const char *path, FILE *file);

#endif

/* run_result.h - the results of a run, as run_file.h left them or as read from its file. */
#ifndef RUN_RESULT_H
#define RUN_RESULT_H

#include "bench/files/arena.h"
#include "bench/harness/measures.h"
#include "models/clock.h"
#include "models/model.h"

enum { RUN_RESULT_PHASES = 3 }; /* "assemble", "factor", "solve" of store.h */

struct run_result {
    enum status outcome;     /* STATUS_OK; a death; what else run_build says: refused   */
    struct message sentence; /* "done"; "not_arrived: ..."; the death; the refusal      */
    double death_time;       /* [s]; NaN: it did not die                                */
    double value[MEASURES];
    struct message distrust; /* why it cannot be right (distrust.h); ""                 */
    struct counters work; /* up to the last look                                        */
    double create_seconds, step_seconds, look_seconds; /* of the first repeat           */
    long steps;
    bool quick; /* a quick run's: smaller than what it is named after (run_file.h)     */

    /* The following come from the file alone: */
    char made_for[128]; /* run_keep's made_for; ""                                      */
    struct scene scene; /* that it was made with                                 owned  */
    int points[3];      /* of its net; 0: it has no third axis                          */
    bool linear;        /* its kinematics                                               */
    double unknowns, factor_entries;
    double bytes; /* that the model held after its last step (timing.h); NaN: not timed */
    struct clock_summary create; /* over the repeats [s]; count = 0: not timed          */
    struct clock_summary step;   /* likewise of their mean steps, or of the equilibrium */
    struct clock_summary phase[RUN_RESULT_PHASES];
    double processor; /* share of the timing in which it had a processor; NaN: not timed  */
    int frames;   /* fields kept; fewer than asked for after a death                   */
    double *time; /* [frames] [s]                                                      */
    double **xyz; /* [frames] (grid.h) [m]; NULL unless asked for                      */
    struct arena arena; /* of these                                             owned  */
};

/* Returns whether the model refused; nothing else is known then but the sentence. */
bool run_result_refused(const struct run_result *r);

/* Returns whether steps ended before their iterations had arrived
 * (models/mechanics/arrival.h).
 */
bool run_result_missed(const struct run_result *r);

/* Fills the sentence from outcome, death_time and work; `refusal` is the model's. */
void run_result_tell(struct run_result *r, const char *refusal);

/* Reads the same numbers, bit for bit, from the file of a run, with its fields or without.
 * STATUS_FILE: there is none; STATUS_INPUT: it is not that of a run; with a sentence. */
enum status run_result_read(const char *path, bool fields, struct run_result *r,
                            struct message *why);
void run_result_clear(struct run_result *r); /* all-zero is allowed */

#endif

/* study.h - measures the studies of a plan (plan.h) together, keeps a result file of each
 * level, FOLDER/STUDY_LEVEL.h5, and reads the files as numbers.
 */
#ifndef STUDY_H
#define STUDY_H

#include <stddef.h>

#include "bench/experiment/measurement.h"
#include "bench/experiment/plan.h"
#include "bench/experiment/quantity.h"
#include "bench/harness/run.h"
#include "bench/harness/run_result.h"
#include "bench/truth/truth.h"
#include "bench/ui/table.h"

struct study_row {
    const struct plan_level *level; /*                                        borrowed  */
    bool left_out; /* by a quick run: there is nothing else                            */
    struct run_result result; /* with its fields                                 owned  */
    struct run run;           /* scene and discretization of the level           owned  */
    double
        theory; /* drop of a cantilever's tip at rest over L (truth_plate_drop), or NaN */
    const double *xyz[PLAN_STUDY_TIMES]; /* sheet (grid.h) [m]; NULL after a death      */
    double value[PLAN_STUDY_TIMES][QUANTITIES]; /* as far as known (quantity_at)        */
    bool known[PLAN_STUDY_TIMES][QUANTITIES];
};

struct study {
    const struct plan_study *plan; /*                                         borrowed  */
    int frames;              /* kept of a level that lives: its times, or 1: at rest */
    const double *time;      /* [frames] [s]; NULL: at rest             borrowed  */
    double gamma, length;    /* of its scene: [1], [m]                            */
    struct truth *truth;     /* owned; NULL: none was asked for, or there is none */
    struct message no_truth; /* why not                                           */
    struct study_row *row;   /* [plan->level_count]; one more for the truth, whose
                                label is "truth" and which has sheets alone      owned */
};

struct study_results {
    const struct plan *plan; /*                                               borrowed  */
    int count;
    struct study *study; /* [count]                                              owned  */
    bool quick;          /* judge.h: some of it is of less than the plan says           */
    char machine[4096];  /* a file whose provenance holds for all                       */
};

/* A level of a study at one of the study's times, both from 0. */
struct place {
    const struct study_results *d;
    const struct study *s;
    int level, time;
};

/* Runs and times all levels of all studies, interleaved, and their truths. Deaths and
 * refusals are results. */
enum status study_measure(const struct plan *plan, const char *folder,
                          const struct measurement_options *options, struct message *why);

/* Reads the numbers from the files that study_measure left in `folder`. *r is overwritten;
 * free it with study_clear, which accepts all-zero. */
enum status study_read(const struct plan *plan, const char *folder, struct study_results *r,
                       struct message *why);
void study_clear(struct study_results *r);

/* Returns the level that the plan has this one compared with; -1: there is none. */
int study_reference(const struct study_results *r, const struct study *s, int level);

/* Returns the rms distance of two levels at the first one's time over its length; NaN: one
 * did not live to see it. */
double study_distance(const struct place *a, const struct place *b);

#endif

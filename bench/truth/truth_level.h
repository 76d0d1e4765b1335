/* truth_level.h - one run towards a truth: a model on a net with a step, kept in a folder
 * and found again there. */
#ifndef TRUTH_LEVEL_H
#define TRUTH_LEVEL_H

#include <stdbool.h>

#include "bench/harness/rung.h"

/* Of gravity, in the direction (1,1,1): whatever symmetry a scene has is gone. */
#define TRUTH_PERTURBATION 1e-6

enum { TRUTH_MOST_SETTINGS = 256, TRUTH_LEVEL_SETTINGS = 6, TRUTH_LEVEL_TEXT = 96 };

struct truth_level {
    const char *model; /* "iga" or "shell": nonlinear, the solid cured of locking      */
    int degree, side;  /* along u and v                                                */
    double step;       /* [s]                                                          */
    bool perturbed;    /* by TRUTH_PERTURBATION                                        */
};

/* What all runs of a scene share; borrowed. */
struct truth_runs {
    const char *path; /* of the scene                                                  */
    int setting_count;
    const char *const *settings;
    int times;
    const double *time; /* multiples of every step [s]                                 */
    const char *folder; /* where result files are kept; exists                         */
};

/* The settings of a level behind those of the runs; all[TRUTH_MOST_SETTINGS] points into
 * text. Returns their number. STATUS of the scene for a perturbed level. */
enum status truth_level_settings(const struct truth_runs *runs,
                                 const struct truth_level *level,
                                 char text[TRUTH_LEVEL_SETTINGS][TRUTH_LEVEL_TEXT],
                                 const char **all, int *count, struct message *why);

/* Reads the level's file if it is of this physics and has these times (r->frames may be
 * more than them), else runs it, unless `read_only`: STATUS_FILE then. STATUS_DIVERGED with
 * a sentence: it died on the way. */
enum status truth_level_find(const struct truth_runs *runs, const struct truth_level *level,
                             bool read_only, struct rung_result *r, struct message *why);

#endif

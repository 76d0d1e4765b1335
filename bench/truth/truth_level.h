/* truth_level.h - one run towards a truth: a contestant on a net with a step, kept in a
 * folder and found again there. */
#ifndef TRUTH_LEVEL_H
#define TRUTH_LEVEL_H

#include "bench/harness/contestant.h"
#include "bench/harness/run_result.h"

/* Whose runs truths are made of: the nonlinear solid, cured of locking by reduced
 * integration, and the nonlinear shell; truth_sharp.h takes the solid whose bending has a
 * rule of its own (on a clamped sheet's 9 spans it is nearer than the other on 27, and
 * costs the same) and the shell cured of locking. */
enum truth_model {
    TRUTH_SOLID,
    TRUTH_SHELL,
    TRUTH_MODELS,
    TRUTH_CURED = TRUTH_MODELS,
    TRUTH_SELECTIVE
};

/* TRUTH_SOLID or TRUTH_SHELL. */
enum truth_model truth_level_kind(enum truth_model model);

struct truth_level {
    enum truth_model model;
    int degree, side; /* along u and v                                                 */
    double step;      /* [s]                                                           */
    bool perturbed;   /* truth_push.h, number 0                                         */
    double grade;     /* knots along u at (i/n)^grade: dense at u = 0; 0: evenly       */
    int repeats;      /* of the points, for knots that repeat at supports' ends        */
};

/* What all runs of a scene share; borrowed. */
struct truth_runs {
    const char *path; /* of the scene                                                  */
    const struct settings *settings;
    int times;
    const double *time; /* multiples of every step [s]                                 */
    const char *folder; /* where result files are kept; exists                         */
    bool ours;          /* those of other solvers are made again                       */
};

const struct contestant *truth_level_contestant(enum truth_model model);

/* The settings of a level, those of the runs among them, on top of the contestant's. STATUS
 * of the scene for a perturbed level. */
enum status truth_level_settings(const struct truth_runs *runs,
                                 const struct truth_level *level, struct settings *settings,
                                 struct message *why);

/* Reads the level's file, with its fields, if it is of this physics and these settings of
 * the discretization, whole, and has these times
 * (r->frames may be more than them), else runs it, unless `read_only`: STATUS_FILE then.
 * STATUS_DIVERGED with a sentence: it died on the way. STATUS_UNSUPPORTED: it would not
 * begin. STATUS_INPUT: scene or settings are impossible. */
enum status truth_level_find(const struct truth_runs *runs, const struct truth_level *level,
                             bool read_only, struct run_result *r, struct message *why);

#endif

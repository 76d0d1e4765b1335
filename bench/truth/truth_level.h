/* truth_level.h - one run towards a truth: a contestant on a net with a step, kept in a
 * folder and found again there. */
#ifndef TRUTH_LEVEL_H
#define TRUTH_LEVEL_H

#include <stdio.h>

#include "bench/harness/contestant.h"
#include "bench/harness/run_result.h"

/* Whose runs truths are made of: the nonlinear solid whose bending has a rule of its own
 * (on a clamped sheet's 9 spans it is nearer than one with reduced integration on 27, and
 * costs the same), and the nonlinear shell cured of locking. They share the B-spline basis
 * and the Newton solver, nothing of their mechanics. */
enum truth_model { TRUTH_SOLID, TRUTH_SHELL, TRUTH_MODELS };

struct truth_level {
    enum truth_model model;
    int degree, side; /* along u and v                                                 */
    double step;      /* [s]                                                           */
    bool perturbed;   /* truth_level_push, number 0   */
    int repeats;      /* of the points, for knots that repeat at supports' ends        */
};

/* What all runs of a scene share; borrowed. */
struct truth_runs {
    const char *path; /* of the scene                                                  */
    const struct settings *settings;
    int times;
    const double *time; /* multiples of every step [s]                                 */
    const char *folder; /* where result files are kept; exists                         */
    double frame;       /* what all steps divide [s]                                   */
    FILE *say;          /* a line a run; NULL: nothing                                 */
    bool ours;          /* those of other solvers are made again                       */
};

const struct contestant *truth_level_contestant(enum truth_model model);

/* Of gravity, or of 9.81 m/s^2 where there is none; a rounding of its sixth digit. */
#define TRUTH_PERTURBATION 1e-6

/* The unit vector of a push times sqrt(3). Number 0 is (1,1,1): whatever symmetry a scene
 * has is gone. Others come from a hash of the number (Steele, Lea, Flood 2014, SplitMix64)
 * and are uniform on the sphere (von Neumann 1951, rejection); only sums, products and
 * square roots: the same bits on every machine. */
void truth_level_direction(int number, double direction[3]);

/* The gravity of the scene at `path` with settings `given`, changed by TRUTH_PERTURBATION
 * of its size, into `settings`: how fast such a change grows says how long a motion can be
 * predicted. Those of the scene: STATUS_INPUT, STATUS_MEMORY. */
enum status truth_level_push(const char *path, const struct settings *given, int number,
                             struct settings *settings, struct message *why);

/* The settings of a level, those of the runs among them, on top of the contestant's. STATUS
 * of the scene for a perturbed level. */
enum status truth_level_settings(const struct truth_runs *runs,
                                 const struct truth_level *level, struct settings *settings,
                                 struct message *why);

/* Reads the level's file, with its fields, if it is of this physics and these settings of
 * the discretization, whole, and has these times
 * (r->frames may be more than them), else runs it.
 * STATUS_DIVERGED with a sentence: it died on the way. STATUS_UNSUPPORTED: it would not
 * begin. STATUS_INPUT: scene or settings are impossible. */
enum status truth_level_find(const struct truth_runs *runs, const struct truth_level *level,
                             struct run_result *r, struct message *why);

#endif

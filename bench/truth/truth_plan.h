/* truth_plan.h - which nets and steps make a scene's truth, and at which times it is told.
 */
#ifndef TRUTH_PLAN_H
#define TRUTH_PLAN_H

#include <stdbool.h>

#include "bench/truth/truth_level.h"

/* Of one model: three nets at `step`; on the middle one twice and four times the step, too.
 */
struct truth_ladder {
    int degree, side[3];
    double step; /* [s]                                                                */
};

struct truth_plan {
    const char *scene; /* name; NULL: of all others                                    */
    double until;      /* [s]                                                          */
    double watch;      /* at most so long for the growth of a change [s] */
    struct truth_ladder ladder[TRUTH_MODELS];
};

/* Of a scene by its name; `quick`: far coarser. */
struct truth_plan truth_plan_of(const char *scene, bool quick);

/* Every tenth of a second, and the scene's snapshots, up to the plan's end, as far as they
 * are multiples of the longest step. *time is freed by the receiver; its count, or -1: no
 * memory. */
int truth_plan_times(const struct truth_plan *plan, const struct scene *scene,
                     double **time);

/* A factor on the velocity after each step is no physics: under every step and scheme it
 * means another damping, and no truth can be had. Such a scene's truth moves undamped: the
 * setting that says so, or NULL where the damping is a rate. */
const char *truth_plan_damping(const struct scene *scene);

/* A scene as its truth moves: the settings get that one, too. *scene is overwritten. */
enum status truth_plan_scene(const char *path, struct settings *settings,
                             struct scene *scene, struct message *why);

#endif

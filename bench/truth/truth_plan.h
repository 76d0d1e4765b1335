/* truth_plan.h - which nets and steps make a scene's truth, and at which times it is told.
 */
#ifndef TRUTH_PLAN_H
#define TRUTH_PLAN_H

#include <stdbool.h>

#include "bench/truth/truth_level.h"

/* Frames of a truth that is stored [s]. */
#define TRUTH_PLAN_FRAME 0.02

/* Every 20 ms, and the scene's snapshots, up to `until`, as far as they are multiples of
 * the longest step. *time is freed by the receiver; its count, or -1: no memory. */
int truth_plan_times(double until, double longest, const struct scene *scene,
                     double **time);

/* Whether tables judge at a time of a truth: every tenth of a second, and the scene's
 * snapshots, however many frames are stored. */
bool truth_plan_judges(const struct scene *scene, double time);

/* Nets and steps that shrink alike, of a truth that is to be as sharp as is asked for: the
 * k-th, from coarse to fine; false past the last. Nets have a knot at every edge of what is
 * held, if it lies at a multiple of 1/20 or more of the sheet. The frame is what all steps
 * divide [s]. */
bool truth_plan_rung(const struct scene *scene, double frame, int k,
                     struct truth_level *level);

/* The longest step of 20 ms divided that is no longer than the scene's. */
double truth_plan_frame(const struct scene *scene);

/* A truth is a limit under refinement, and what is held at points has none: a point of a
 * solid holds nothing. Nor has a drape, a sheet that nothing holds and that lies on an
 * obstacle from the start on. STATUS_UNSUPPORTED with a sentence. */
enum status truth_plan_check(const struct scene *scene, struct message *why);

/* A factor on the velocity after each step is no physics: under every step and scheme it
 * means another damping, and no truth can be had. Such a scene's truth moves undamped: the
 * setting that says so, or NULL where the damping is a rate. */
const char *truth_plan_damping(const struct scene *scene);

/* A scene as its truth moves: the settings get that one, too. *scene is overwritten. */
enum status truth_plan_scene(const char *path, struct settings *settings,
                             struct scene *scene, struct message *why);

#endif

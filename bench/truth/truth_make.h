/* truth_make.h - a scene's truth made: the nonlinear solid and the nonlinear shell, each on
 * three nets and three steps, against each other, and one of them pushed a little.
 *
 * The two share the B-spline basis and the Newton solver, nothing of their mechanics. The
 * field kept is that of the model with the smaller bar of its own; the error bar is the
 * largest of the two own bars and of the difference of the two models.
 */
#ifndef TRUTH_MAKE_H
#define TRUTH_MAKE_H

#include "bench/truth/truth_made.h"
#include "bench/truth/truth_plan.h"

/* Runs what is not in the folder yet; `quiet`: no progress bar. STATUS_DIVERGED: a run
 * died; STATUS_UNSUPPORTED: a model cannot serve the scene. Free with truth_made_clear. */
enum status truth_make(const struct truth_plan *plan, const struct truth_runs *runs,
                       const struct scene *scene, bool quiet, struct truth_made *made,
                       struct message *why);

#endif

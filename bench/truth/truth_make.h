/* truth_make.h - a scene's truth made: the nonlinear solid and the nonlinear shell, each on
 * three nets and three steps, against each other, and one of them pushed a little.
 *
 * The two share the B-spline basis and the Newton solver, nothing of their mechanics. The
 * field kept is that of the model with the smaller bar of its own; the error bar is the
 * largest of the two own bars and of the difference of the two models.
 */
#ifndef TRUTH_MAKE_H
#define TRUTH_MAKE_H

#include <stdio.h>

#include "bench/truth/truth_made.h"
#include "bench/truth/truth_plan.h"

struct truth_make_how {
    FILE *say;      /* what comes next and how long it takes; NULL: nothing            */
    double seconds; /* that all its runs may take, those that are kept included; 0: any */
};

/* Runs what is not in the folder yet, from cheap to dear. STATUS_FAILED with a sentence:
 * the budget forbids the next run; those before it are kept. STATUS_DIVERGED: a run died;
 * STATUS_UNSUPPORTED: a model cannot serve the scene. Free with truth_made_clear. */
enum status truth_make(const struct truth_plan *plan, const struct truth_runs *runs,
                       const struct scene *scene, const struct truth_make_how *how,
                       struct truth_made *made, struct message *why);

#endif

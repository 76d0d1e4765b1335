/* verify_refine.h - one subject on its nets and with steps that are refined, against
 * positions over time: the finest run's error as a row, with the order observed in space;
 * the change that halving the step makes as another, with the order in time.
 */
#ifndef VERIFY_REFINE_H
#define VERIFY_REFINE_H

#include "bench/verify/verify_trial.h"

enum { VERIFY_REFINE_STEPS = 3 };

/* Nets of the subject have half the spacing of the one before. */
struct verify_refine {
    const char *scene;
    const char *const *settings; /* KEY=VALUE, ends with NULL                          */
    int steps;                   /* 1 .. VERIFY_REFINE_STEPS                           */
    double step;                 /* the finest; the others are 2, 4, .. times it [s]   */
    int times;
    const double *time; /* [times] multiples of the coarsest step               [s]    */
    int n;
    const double *uvw;   /* [n][3] material points                                     */
    const double *truth; /* [times][n][3]                                       [m]    */
    double bar;          /* of the truth, as `measure` has it                          */

    /* How far a is from b, both [times][n][3]. */
    double (*measure)(const void *context, const double *a, const double *b);
    const void *context;
    double *field;      /* [times][n][3] the finest run's, for more rows; or NULL      */
    const char *beyond; /* why the subject's theory does not reach so far; NULL: it does */
};

/* Adds the rows, `quantity` their name: the error of the finest run, judged, and, with
 * several steps, what the last halving changed, not judged. Whether that run got to its
 * end. */
bool verify_refine(const struct verify_subject *subject, const struct verify_refine *r,
                   const char *quantity);

#endif

/* verify_trial.h - the runs behind rows. Seconds go into the row, and so does a refusal or
 * a death, which is no error: `lived` is false then, as all functions tell. What is neither
 * goes to the sheet (verify_sheet_holds). verify_check.h has an example.
 */
#ifndef VERIFY_TRIAL_H
#define VERIFY_TRIAL_H

#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "bench/verify/verify_sheet.h"

struct verify_trial {
    struct verify_row *row;
    const struct verify_subject *subject;
    const char *scene;        /* a name of `list scenes`                                  */
    int net;                  /* which of the subject's                                   */
    struct settings settings; /* of the check, before the subject's; each of the functions
                                 below uses them up and leaves it empty                   */
    double end;               /* instead of the scene's; 0: the scene's [s]               */
    bool lived;               /* it got to its end                                        */
    struct run run;           /* from verify_trial_open and _settle to run_close          */
};

/* With a row of its own, as verify_sheet_add makes it. */
struct verify_trial verify_trial_of(const struct verify_subject *subject, const char *scene,
                                    const char *quantity, ...)
    __attribute__((format(printf, 3, 4)));

/* The scene of that name, as it stands; scene_clear it. */
enum status verify_trial_scene(const char *name, struct scene *scene, struct message *why);

/* Opens the model; the same moved to static equilibrium. run_close in any case. */
bool verify_trial_open(struct verify_trial *t);
bool verify_trial_settle(struct verify_trial *t);

/* Static equilibrium: material points uvw[n][3] into xyz[n][3] [m]. */
bool verify_trial_equilibrium(struct verify_trial *t, int n, const double *uvw,
                              double *xyz);

/* The same of the middle of the edge u = 1 alone. */
bool verify_trial_tip(struct verify_trial *t, double xyz[3]);

/* The `count` lowest angular frequencies about the rest shape into omega[] [rad/s];
 * settled: about static equilibrium, under its stress: -s where a mode grows as exp(s t).
 */
bool verify_trial_modes(struct verify_trial *t, bool settled, int count, double *omega);

/* Motion from the scene's start to t->end, looked at by `watch` (motion.h). */
bool verify_trial_watch(struct verify_trial *t, motion_watcher *watch, void *context);

/* Motion from the scene's start: the points at time[times] (multiples of the scene's step,
 * increasing) into xyz[times][n][3]. */
bool verify_trial_motion(struct verify_trial *t, int times, const double *time, int n,
                         const double *uvw, double *xyz);

/* A number on one net of a subject: fills settings and runs. Any if it did not live. */
typedef double verify_trial_measure(struct verify_trial *t, void *context);

/* All nets, from coarse to fine: the finest one's value is judged, with the order. A truth
 * of NAN: the values are errors. */
bool verify_trial_nets(struct verify_trial *t, verify_trial_measure *measure, void *context,
                       double truth, double bar);

/* A motion on the nets of a subject and with steps that are refined, against positions over
 * time: the finest run's error as a row, with the order observed in space; the change that
 * halving the step makes as another, with the order in time. */
enum { VERIFY_TRIAL_STEPS = 3 };

/* Nets of the subject have half the spacing of the one before. */
struct verify_trial_refine {
    const char *scene;
    const char *const *settings; /* KEY=VALUE, ends with NULL                          */
    int steps;                   /* 1 .. VERIFY_TRIAL_STEPS                            */
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
bool verify_trial_refine(const struct verify_subject *subject,
                         const struct verify_trial_refine *r, const char *quantity);

#endif

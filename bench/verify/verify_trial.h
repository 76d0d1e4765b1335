/* verify_trial.h - the runs behind rows. Seconds go into the row, and so does a refusal or
 * a death, which is no error: `lived` is false then.
 *
 *     struct verify_trial t = {row, subject, "cantilever", .net = 1};
 *     settings_number(&t.settings, "sheet.thickness", h);
 *     TRY(verify_trial_equilibrium(&t, 1, tip, xyz, why));
 *     if (t.lived)
 *         verify_row_judge(row, xyz[2], truth, bar);
 */
#ifndef VERIFY_TRIAL_H
#define VERIFY_TRIAL_H

#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "bench/verify/verify_row.h"
#include "bench/verify/verify_subject.h"

struct verify_trial {
    struct verify_row *row;
    const struct verify_subject *subject;
    const char *scene;        /* a name of `list scenes`                                  */
    int net;                  /* which of the subject's                                   */
    struct settings settings; /* of the check, before the subject's; each of the functions
                                 below uses them up and leaves it empty                   */
    double end;               /* instead of the scene's; 0: the scene's [s]               */
    bool lived;               /* it got to its end                                        */
    struct run run;           /* from verify_trial_open and _settle to _close             */
};

/* The scene of that name, as it stands; scene_clear it. */
enum status verify_trial_scene(const char *name, struct scene *scene, struct message *why);

/* Opens the model; the same moved to static equilibrium. verify_trial_close in any case. */
enum status verify_trial_open(struct verify_trial *t, struct message *why);
enum status verify_trial_settle(struct verify_trial *t, struct message *why);
void verify_trial_close(struct verify_trial *t);

/* Static equilibrium: material points uvw[n][3] into xyz[n][3] [m]. */
enum status verify_trial_equilibrium(struct verify_trial *t, int n, const double *uvw,
                                     double *xyz, struct message *why);

/* The `count` lowest angular frequencies about the rest shape into omega[] [rad/s]; about
 * static equilibrium, under its stress: -s where a mode grows as exp(s t). */
enum status verify_trial_modes(struct verify_trial *t, int count, double *omega,
                               struct message *why);
enum status verify_trial_settled_modes(struct verify_trial *t, int count, double *omega,
                                       struct message *why);

/* Motion from the scene's start to t->end, looked at by `watch` (motion.h). */
enum status verify_trial_watch(struct verify_trial *t, motion_watcher *watch, void *context,
                               struct message *why);

/* Motion from the scene's start: the points at time[times] (multiples of the scene's step,
 * increasing) into xyz[times][n][3]. */
enum status verify_trial_motion(struct verify_trial *t, int times, const double *time,
                                int n, const double *uvw, double *xyz, struct message *why);

/* A number on one net of a subject: fills settings and runs. */
typedef enum status verify_trial_measure(struct verify_trial *t, void *context,
                                         double *value, struct message *why);

/* All nets, from coarse to fine: the finest one's value is judged, with the order. A truth
 * of NAN: the values are errors. t->lived tells whether all of them came. */
enum status verify_trial_nets(struct verify_trial *t, verify_trial_measure *measure,
                              void *context, double truth, double bar, struct message *why);

#endif

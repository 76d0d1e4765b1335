/* compare.h - the command `compare`: speed against error, all contestants, one scene. */
#ifndef COMPARE_H
#define COMPARE_H

#include "bench/compare/contest.h"
#include "bench/experiment/measurement.h"
#include "bench/ui/command.h"
#include "bench/data/printer.h"

/* --- one scene: its contest, from the ladder over the search to the limits --- */

struct compare_job {
    struct contest contest;
    struct scene scene;
    char *path;         /* of the scene file                                  owned */
    const char *folder; /* of the result files                             borrowed */
    int times;
    double time[CONTEST_TIMES]; /* at which runs are held against the truth [s]     */
    struct settings user;       /* the user's                                       */
    struct settings truth;      /* these, and how the truth is damped               */
    struct truth *found;        /* owned; NULL: none                                */
    struct truth none;          /* stands in for a truth that could not be had      */
    double until;               /* of the budget (deadline.h); 0: there is none     */
    bool read_only;             /* rows are filled from files of an earlier call    */
    struct measurement_taken taken;
};

/* Reads a scene with a user's settings and chooses how it is damped and at which times it
 * is held against its truth: five up to `until` [s] or, if that is NaN, those of a stored
 * truth up to half a second, else five up to there. `quick` and `user` are set before; free
 * with compare_job_close. STATUS_INPUT with a sentence. */
enum status compare_job_open(struct compare_job *j, const char *scene, double until,
                             struct message *why);
void compare_job_close(struct compare_job *j); /* all-zero is allowed */

/* Adds the ladders of a choice of --models (contestant_chosen), model by model: at most
 * `rungs` rungs of each, with the paper's own scheme or without. STATUS_INPUT with a
 * sentence. */
enum status compare_job_enter(struct compare_job *j, const char *models, int rungs,
                              bool paper_scheme, struct message *why);

/* Finds or makes the truth within wish->seconds, which begin now: j->until. Where none can
 * be had, contest.truth stays NULL and *said says why. */
enum status compare_job_truth(struct compare_job *j, const struct truth_wish *wish,
                              struct message *said, struct message *why);

/* Runs and times all rows of a job from `first` on that the folder has no file of, and
 * fills them: a contest_measure. STATUS_LATE with a sentence: the budget was over before,
 * and some are absent. */
enum status compare_job_rows(void *job, int first, struct message *why);

/* --- what is printed --- */

/* Prints the table of all runs, what each contestant needs for given errors, and what
 * limits it; as compare.csv, compare_targets.csv and compare_limits.csv in the folder, too.
 */
enum status compare_print(const struct contest *c, struct printer *p, struct message *why);

#endif

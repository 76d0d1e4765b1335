/* compare_job.h - one scene's part of `compare`: its contest, from the ladder over the
 * search to what limits each contestant.
 */
#ifndef COMPARE_JOB_H
#define COMPARE_JOB_H

#include "bench/compare/contest.h"
#include "bench/harness/settings.h"

struct compare_job {
    struct contest contest;
    struct scene scene;
    char *path;
    const char *folder;
    int times;
    double time[CONTEST_TIMES];
    struct settings user;  /* the user's                                               */
    struct settings truth; /* these, and how the truth is damped                       */
    struct truth *found;   /* owned                                                    */
    struct truth none;     /* stands in for a truth that could not be had              */
    bool read_only;
};

/* The ladders of a choice of --models (contestant_chosen), model by model; within a budget
 * the least rung of each. */
enum status compare_job_ladder(struct compare_job *j, const char *models,
                               struct message *why);

/* Runs and times the ladder, what it makes worth a try (contest_search_all), then, untimed,
 * what tells the limits of each, and the best again with more threads; read_only: fills
 * them from the files of an earlier call.
 */
enum status compare_job_measure(struct compare_job *j, struct message *why);

#endif

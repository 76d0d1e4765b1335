/* compare.h - the command `compare`: speed against error, all contestants, one scene. */
#ifndef COMPARE_H
#define COMPARE_H

#include "bench/compare/contest.h"
#include "bench/experiment/measurement.h"
#include "bench/ui/command.h"
#include "bench/ui/table.h"

extern const struct command compare_command;

/* --- one scene: its contest, from the ladder over the search to the limits --- */

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
    struct measurement_taken taken;
};

/* Reads a scene with a user's settings and chooses how it is damped and at which times it
 * is held against its truth: five up to `until` [s] or, if that is NaN, those of a stored
 * truth up to half a second, else five up to there. `quick` and `user` are set before; free
 * with compare_job_close. */
enum status compare_job_open(struct compare_job *j, const char *scene, double until,
                             struct message *why);
void compare_job_close(struct compare_job *j); /* all-zero is allowed */

/* The ladders of a choice of --models (contestant_chosen), model by model; within a budget
 * the least rung of each. */
enum status compare_job_ladder(struct compare_job *j, const char *models,
                               struct message *why);

/* Runs and times all rows from `first` on that the folder has no file of, and fills them.
 * STATUS_LATE with a sentence: the budget was over before, and some are absent. */
enum status compare_job_rows(struct compare_job *j, int first, struct message *why);

/* Makes a row of each run that contest_search proposes for any contestant. */
enum status compare_job_propose(struct compare_job *j, const struct contest_wish *wish);

/* Runs and times the ladder, what it makes worth a try (contest_search_all), then, untimed,
 * what tells the limits of each, and the best again with more threads; read_only: fills
 * them from the files of an earlier call.
 */
enum status compare_job_measure(struct compare_job *j, struct message *why);

/* --- what is printed --- */

/* The table of all runs to `file` and as compare.csv in the folder, what each contestant
 * needs for given errors (compare_targets.csv) and what limits it (compare_limits.csv);
 * charts compare.png and compare_models.png as it goes. */
enum status compare_print(const struct contest *c, const char *folder,
                          enum table_format format, FILE *file, struct message *why);

/* The best rows with each number of threads, and compare_threads.csv; nothing where they
 * were not asked for. */
enum status compare_threads(const struct contest *c, const char *folder,
                            enum table_format format, FILE *file, struct message *why);

#endif

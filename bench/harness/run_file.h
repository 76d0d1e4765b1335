/* run_file.h - a run on its way into its result file (store.h), the only kind there is: the
 * looks that were taken at it (looks.h), some or all with their fields, seconds, work and
 * how it ended. run_result.h reads it back.
 *
 *     struct run_result r;
 *     TRY(run_file_write(&(struct case_plan){...}, &r, why));
 *
 * Callers that do more on the way (probes, timed repeats) open, watch and close themselves.
 */
#ifndef RUN_FILE_H
#define RUN_FILE_H

#include "bench/files/scope.h"
#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "bench/harness/run_result.h"

struct run_file;

/* Starts the file of a run that was read, built or not. *file is untouched on failure;
 * `run` and `keep` are borrowed until the end. STATUS_FILE, STATUS_MEMORY with a
 * sentence. */
enum status run_file_open(const struct run *run, const struct run_keep *keep,
                          struct run_file **file, struct message *why);

/* Takes the looks that are due: a motion_watcher with the run_file as its context. */
enum status run_file_watch(void *file, const struct motion *m, struct message *why);

/* Takes the only look of a run at rest. */
enum status run_file_rest(struct run_file *file, const struct counters *work,
                          struct message *why);

/* Ends the looks: the run's state may then be destroyed, and little memory is held any
 * more. run_file_close does it itself. */
enum status run_file_end(struct run_file *file, struct message *why);

/* Stores raw seconds[repeats][columns] of a phase (store.h) in place of those of the run
 * itself ("create", "advance"). */
enum status run_file_seconds(struct run_file *file, const char *phase,
                             const double *seconds, int repeats, int columns,
                             struct message *why);

/* Stores the bytes that the model holds (timing.h). */
enum status run_file_bytes(struct run_file *file, double bytes, struct message *why);

/* Completes the file and fills *result (may be NULL), without fields. `m` is NULL for a
 * state that did not move. Frees in any case; on failure nothing is left of the file. */
enum status run_file_close(struct run_file *file, const struct motion *m,
                           struct run_result *result, struct message *why);
void run_file_discard(struct run_file *file); /* gives it up; NULL is allowed */
SCOPE_OF(run_file_discard, struct run_file)

/* Returns whether the model refused the run, or died before its first step. */
bool run_file_refused(const struct run_file *file);

/* Builds a run that was read, and follows it to its end, or to its equilibrium: a death is
 * a result, and so is a model that refuses. *m is all-zero before; `run` must outlive
 * *file, and m->model stays NULL if nothing moved. On failure there is no file, and
 * run_close and motion_clear are the caller's still. */
enum status run_file_follow(const struct case_plan *c, struct run *run, struct motion *m,
                            struct run_file **file, struct message *why);

/* Does the whole of a run that was read: run_file_follow, then run_file_close. The bits are
 * the same with and without file, fields kept or not, but for the last look of
 * RUN_FIELDS_ALL. */
enum status run_file_make(const struct case_plan *c, struct run *run,
                          struct run_result *result, struct message *why);

/* The same for a case whose scene nobody has read. STATUS_INPUT: scene or settings are
 * impossible. */
enum status run_file_write(const struct case_plan *c, struct run_result *result,
                           struct message *why);

/* Leaves the file of a run that was read and came to no result: its sentence says why. */
enum status run_file_lost(const struct case_plan *c, const struct run *run,
                          const struct message *said, struct message *why);

#endif

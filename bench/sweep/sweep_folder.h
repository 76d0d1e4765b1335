/* sweep_folder.h - where a sweep keeps what it has done, so that it can go on after
 * anything.
 *
 *   manifest.txt       the plan and the scenes, as they were read at the beginning
 *   case_000001.h5     the result file of a case (run_file.h), or
 *   case_000001.txt    one sentence: why there is none (time limit, signal, no such scene)
 *   log.txt            `start N`, `end N`, `failed N`: a line each, in the order of events
 *   table.csv, seconds.csv, map.png      made from these in the end
 *
 * A case is done when one of its two files is there and whole; both get their names only
 * then.
 */
#ifndef SWEEP_FOLDER_H
#define SWEEP_FOLDER_H

#include "bench/experiment/plan.h"
#include "bench/harness/run_result.h"

enum { SWEEP_FOLDER_PATH = 1000 }; /* fits a message */

struct sweep_folder {
    char path[SWEEP_FOLDER_PATH];
    int lock, log; /* files kept open by the process that leads; -1                    */
};

/* What is known of a case. */
struct sweep_row {
    bool there;
    bool
        ran; /* `result` holds; else `why`: there is none, or it was impossible to set up */
    struct run_result result; /* without fields; free with run_result_clear           */
    struct message why;
};

/* Makes the folder and its manifest, or, with `resume`, compares: STATUS_INPUT with a
 * sentence if it belongs to another plan, or has results and is not to be resumed;
 * STATUS_FILE: cannot be written, or another sweep is at work in it. Removes what a killed
 * one left half done. Close it with sweep_folder_close. */
enum status sweep_folder_open(struct sweep_folder *folder, const char *path,
                              const struct plan *plan, bool resume, struct message *why);
void sweep_folder_close(struct sweep_folder *folder);

/* Name of the file of case `number` (from 0), "h5" or "txt", into path. */
void sweep_folder_file(const struct sweep_folder *folder, long number, const char *ending,
                       char path[SWEEP_FOLDER_PATH]);

/* Reads a case; a file that is not whole is as if it were not there, and is removed if
 * `repair`. */
void sweep_folder_read(const struct sweep_folder *folder, long number, bool repair,
                       struct sweep_row *row);

/* Keeps the sentence of a case that came to no result. STATUS_FILE. */
enum status sweep_folder_fail(const struct sweep_folder *folder, long number,
                              const char *sentence, struct message *why);

/* A line of the log: "start", "end" or "failed". STATUS_FILE. */
enum status sweep_folder_log(const struct sweep_folder *folder, const char *event,
                             long number, struct message *why);

#endif

/* sweep_folder.h - where a sweep keeps what it has done, so that it can go on after
 * anything.
 *
 *   manifest.txt       the plan and the scenes, as they were read at the beginning, and the
 *                      program
 *   case_000001.h5     the result file of a case (run_file.h), or
 *   case_000001.txt    one sentence: why there is none (time limit, signal, no such scene)
 *   log.txt            `start N`, `end N`, `failed N`: a line each, in the order of events
 *   lock               held while a sweep is at work
 *   table.csv, seconds.csv, falls.csv, map.png      made from these in the end
 *
 * Other files in the folder are left alone. A link that stands where one of these is to be
 * written is replaced, what it leads to is left alone, too.
 */
#ifndef SWEEP_FOLDER_H
#define SWEEP_FOLDER_H

#include "bench/experiment/plan.h"

enum { SWEEP_FOLDER_PATH = 1000 }; /* fits a message */

struct sweep_folder {
    char path[SWEEP_FOLDER_PATH];
    int lock, log; /* files kept open by the process that leads; -1                    */
    unsigned long plan, program; /* sums of the plan with its scenes, of the program   */
};

/* What is done with what is there: it is refused, gone on with, removed. */
enum sweep_start { SWEEP_NEW, SWEEP_RESUME, SWEEP_AGAIN };

/* Fills in the sums: for who works in a folder that another process leads. STATUS_INPUT: a
 * scene cannot be read; STATUS_FILE: nor can the program's own file. */
enum status sweep_folder_identify(struct sweep_folder *folder, const struct plan *plan,
                                  struct message *why);

/* Makes the folder and its manifest, or, to resume, compares: STATUS_INPUT with a
 * sentence if it belongs to another plan or program, or has results and is not to be
 * resumed; STATUS_FILE: cannot be written, or another sweep is at work in it. Removes what
 * a killed one left half done. Close it with sweep_folder_close. */
enum status sweep_folder_open(struct sweep_folder *folder, const char *path,
                              const struct plan *plan, enum sweep_start start,
                              struct message *why);
void sweep_folder_close(struct sweep_folder *folder);

/* Removes what processes that were killed left half done, when none is at work any more. */
void sweep_folder_tidy(const struct sweep_folder *folder);

/* Name of the file of case `number` (from 0), "h5" or "txt", into path. */
void sweep_folder_file(const struct sweep_folder *folder, long number, const char *ending,
                       char path[SWEEP_FOLDER_PATH]);

/* A line of the log: "start", "end" or "failed". STATUS_FILE. */
enum status sweep_folder_log(const struct sweep_folder *folder, const char *event,
                             long number, struct message *why);

#endif

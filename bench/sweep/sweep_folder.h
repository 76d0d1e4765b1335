/* sweep_folder.h - where a sweep keeps what it has done, so that it can go on after
 * anything.
 *
 *   manifest.txt       the plan and the scenes, as they were read at the beginning, and the
 *                      program
 *   case_000001.h5     the result file of a case (run_file.h), or
 *   case_000001.txt    one sentence: why there is none (time limit, signal, no such scene);
 *                      both are sealed and carry sums of the case, of the plan with its
 *                      scenes and of the program: what is damaged is run again, what is of
 *                      another sweep is refused
 *   log.txt            `start N`, `end N`, `failed N`: a line each, in the order of events
 *   lock               held while a sweep is at work
 *   table.csv, seconds.csv, falls.csv, map.png      made from these in the end
 *
 * Other files in the folder are left alone. A link that stands where one of these is to be
 * written is replaced, what it leads to is left alone, too.
 */
#ifndef SWEEP_FOLDER_H
#define SWEEP_FOLDER_H

#include "bench/experiment/plan_case.h"
#include "bench/harness/run_result.h"

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

/* --- Cases, from their files. */

enum sweep_row_state {
    SWEEP_ROW_GONE,    /* there is no file                                             */
    SWEEP_ROW_DAMAGED, /* it is no longer as it was written                            */
    SWEEP_ROW_FOREIGN, /* it was made for another case or plan, or by another program  */
    SWEEP_ROW_CUT,     /* killed, suspended, out of memory: says nothing of the case   */
    SWEEP_ROW_FAILED,  /* no result: timed out, crashed, impossible to set up          */
    SWEEP_ROW_RAN,     /* `result` holds                                               */
};

/* What is known of a case. */
struct sweep_row {
    enum sweep_row_state state;
    struct run_result result; /* free with run_result_clear                            */
    struct message why;       /* how it ended, or why there is nothing                 */
};

/* Whether a sweep that is resumed runs it. */
bool sweep_row_is_open(const struct sweep_row *row);

enum { SWEEP_ROW_MADE_FOR = 80 };

/* What the files of a case (its `given` is enough) are made for: sums of case, plan,
 * program. */
const char *sweep_row_made_for(const struct sweep_folder *folder, const struct plan *plan,
                               const struct plan_case *c, char text[SWEEP_ROW_MADE_FOR]);

/* Reads case `number`, with its fields or without. `made_for` NULL: whatever it is.
 * STATUS_MEMORY: nothing is known of its file, and *row is empty. */
enum status sweep_row_read(const struct sweep_folder *folder, long number,
                           const char *made_for, bool fields, struct sweep_row *row);

/* Keeps the sentence of a case that came to no result, SWEEP_ROW_FAILED or _CUT.
 * STATUS_FILE. */
enum status sweep_row_write(const struct sweep_folder *folder, long number,
                            const char *made_for, enum sweep_row_state state,
                            const char *sentence, struct message *why);

/* Takes away what there is of a case that is to be run again. */
void sweep_row_remove(const struct sweep_folder *folder, long number);

#endif

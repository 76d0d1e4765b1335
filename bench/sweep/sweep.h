/* sweep.h - the command `sweep`: a plan's cases, run once each whatever happens, and what
 * they say.
 *
 *     plan --> cases --> pool of processes --> a file a case in the folder (sweep_folder.c)
 *                                                            |
 *                  table.csv, summary <-- rows in memory (sweep_rows.c)
 */
#ifndef SWEEP_H
#define SWEEP_H

#include "bench/experiment/plan.h"
#include "bench/harness/pool.h"
#include "bench/harness/run_result.h"
#include "bench/ui/command.h"
#include "bench/data/printer.h"

/* --- The folder (sweep_folder.c), in which a sweep keeps what it has done, so that it can
 * go on after anything.
 *
 *   case_000001.h5     the result file of a case (run_file.h), or
 *   case_000001.txt    one sentence: why there is none (time limit, signal, no such scene);
 *                      both are sealed and have the case's key (measurement.h): a damaged
 *                      one, and one with another key, is run again
 *   lock               held while a sweep is at work
 *   table.csv          made from the cases in the end
 *
 * Other files in the folder are left alone. A link that stands where one of these is to be
 * written is replaced; its target is left alone, too.
 */
enum { SWEEP_FOLDER_PATH = 1000 }; /* fits a message */

struct sweep_folder {
    char path[SWEEP_FOLDER_PATH];
    int lock; /* a file of the process that leads; -1: closed                          */
};

/* Makes the folder and locks it. STATUS_FILE: it cannot be written, or another sweep is at
 * work in it. Removes files that a killed sweep left half done. *folder is overwritten;
 * close it in any case. */
enum status sweep_folder_open(struct sweep_folder *folder, const char *path,
                              struct message *why);
void sweep_folder_close(struct sweep_folder *folder);

/* Removes the files that killed processes left half done, when none is at work any more,
 * and links where the sweep will write. */
void sweep_folder_tidy(const struct sweep_folder *folder);

/* Writes the name of the file of case `number` (from 0), "h5" or "txt", into path. */
void sweep_folder_file(const struct sweep_folder *folder, long number, const char *ending,
                       char path[SWEEP_FOLDER_PATH]);

/* Returns whether case `number` has a file. */
bool sweep_folder_has(const struct sweep_folder *folder, long number);

enum sweep_state {
    SWEEP_OPEN,   /* there is no file, it is damaged or another case's, or the case was
                     cut short: killed, suspended, out of memory; the next sweep runs it  */
    SWEEP_FAILED, /* no result: timed out, crashed, impossible to set up               */
    SWEEP_RAN,    /* there is a result                                                 */
};

/* Reads case `number`: its result, empty unless it ran (free with run_result_clear), with
 * its fields or without, and the sentence on how it ended or why there is nothing. `key`:
 * the case's; NULL: it is not compared. STATUS_MEMORY: nothing is known of it. */
enum status sweep_folder_read(const struct sweep_folder *folder, long number,
                              const char *key, bool fields, enum sweep_state *state,
                              struct run_result *result, struct message *sentence);

/* Keeps the sentence of a case that came to no result, or was `cut` short. STATUS_FILE.
 */
enum status sweep_folder_write(const struct sweep_folder *folder, long number,
                               const char *key, bool cut, const char *sentence,
                               struct message *why);

/* Removes the files of a case that is to be run again. */
void sweep_folder_remove(const struct sweep_folder *folder, long number);

/* --- Rows (sweep_rows.c): the cases of a sweep in memory. */

struct sweep_row {
    enum sweep_state state;
    enum status outcome;    /* of a run                                                */
    double value[MEASURES]; /* NaN unless it ran                                       */
    struct ruling verdict;  /* by the plan's rules                                    */
    const char *label;      /* "feasible", "died", ..., "no result", "run again"       */
    const char *why;        /* how it ended, or why there is nothing                   */
};

struct sweep_rows {
    const struct plan *plan; /*                                               borrowed */
    long count;              /* cases of the plan                                      */
    struct sweep_row *row;   /* [count]                                                */
    struct arena arena;      /* of them and their words                          owned */
};

/* Makes empty rows. *rows is overwritten. */
void sweep_rows_init(struct sweep_rows *rows, const struct plan *plan);

/* Fills row `number` and judges it; its strings are copied. */
void sweep_rows_set(struct sweep_rows *rows, long number, enum sweep_state state,
                    const struct run_result *result, const char *why);

/* Refuses a reference whose fields are not kept: STATUS_INPUT with a sentence. */
enum status sweep_rows_check(const struct plan *plan, struct message *why);

/* Reads all rows from the files of their cases, and compares each with its reference if
 * the plan has one. *rows is overwritten; clear its arena in any case. */
enum status sweep_rows_read(struct sweep_rows *rows, const struct plan *plan,
                            const struct sweep_folder *folder);

/* Writes FOLDER/table.csv, every key and measure to 17 digits, verdict, labels and end:
 * the same bits however it came about. STATUS_FILE, STATUS_MEMORY. */
enum status sweep_rows_save(const struct sweep_rows *rows, const struct printer *p,
                            struct message *why);

/* Prints the plan, and how many cases have which label and end. */
void sweep_rows_print(const struct sweep_rows *rows, FILE *file);

#endif

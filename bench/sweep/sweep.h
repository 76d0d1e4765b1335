/* sweep.h - the command `sweep`: a plan's cases, run once each whatever happens, and what
 * they say. Tables that are plans (Table 4) use sweep_run and read the folder. */
#ifndef SWEEP_H
#define SWEEP_H

#include "bench/experiment/plan.h"
#include "bench/files/output.h"
#include "bench/harness/pool.h"
#include "bench/harness/run_result.h"
#include "bench/ui/chart.h"
#include "bench/ui/command.h"
#include "bench/ui/table.h"

/* --- The folder (sweep_folder.c): where a sweep keeps what it has done, so that it can go
 * on after anything.
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

/* --- What falls (sweep_falls.c): whether a measure falls along an axis of a plan
 * (`falls`): a row for each choice of the other keys, the values of the axis as columns,
 * and where it grows.
 */
struct sweep_falls;

/* *falls is NULL for a plan in which nothing is to fall, and all else then does nothing.
 * STATUS_MEMORY. */
enum status sweep_falls_create(struct sweep_falls **falls, const struct plan *plan);
void sweep_falls_destroy(struct sweep_falls *falls);

/* Takes over what is known of a case. */
void sweep_falls_row(struct sweep_falls *falls, long number, const struct sweep_row *row);

/* Judges all rows and writes falls.csv into the folder. A value grows if it is above the
 * smallest one before it in its row by more than the plan's `by` at that case; a death
 * grows if a value stands before it. What has no value is not judged. STATUS_FILE,
 * STATUS_MEMORY. */
enum status sweep_falls_judge(struct sweep_falls *falls, const char *folder,
                              struct message *why);

/* The table and a sentence; nothing before it is judged. */
enum status sweep_falls_print(const struct sweep_falls *falls, FILE *file);

/* STATUS_FAILED with a sentence: the measure grows in some row. */
enum status sweep_falls_check(const struct sweep_falls *falls, struct message *why);

/* --- The tables (sweep_table.c): what a sweep found: table.csv with every key and measure
 * to 17 digits, the verdict, the labels and how the case ended; seconds.csv; and words for
 * people. Seconds stand apart so that the table is the same bits however it came about.
 */
enum { SWEEP_TABLES = 2 }; /* table.csv, seconds.csv */

struct sweep_table {
    const struct plan *plan; /* borrowed                                               */
    struct table *table[SWEEP_TABLES];
    struct output *file[SWEEP_TABLES];

    /* counted row by row */
    long died, unsupported, failed, open, feasible, unjudged;
    long learnt; /* feasible by the plan's second opinion                              */
    long judged; /* cases that rules were applied to                                   */
    long labels[VERDICT_MOST];  /* cases with the label of this rule                   */
    long lacking[VERDICT_MOST]; /* cases of which nobody can say whether they have it  */
};

/* Begins both files in the folder. STATUS_FILE. */
enum status sweep_table_open(struct sweep_table *t, const struct plan *plan,
                             const struct sweep_folder *folder, struct message *why);

/* A case. Its labels (verdict_text), "no result" or "run again" also go into labels[size].
 * Returns whether it is feasible by the plan's second opinion. */
bool sweep_table_row(struct sweep_table *t, const struct plan_case *c,
                     const struct sweep_row *row, char *labels, int size);
enum status sweep_table_close(struct sweep_table *t, struct message *why);
void sweep_table_discard(struct sweep_table *t); /* all-zero is allowed */

/* The plan, how many cases have which label and end, what falls (NULL: nothing is to), what
 * they cost, where they are. `plot`: why there is no picture, or "". STATUS_FILE: the file
 * cannot be written. */
enum status sweep_table_print(const struct plan *plan, const struct sweep_folder *folder,
                              const struct pool *pool, const struct sweep_table *table,
                              const struct sweep_falls *falls, const char *plot,
                              FILE *file);

/* --- The map (sweep_map.c): the feasibility map: labels in colours over two keys or
 * measures, a panel for each value of a third, with the plan's marks on it; hatched where
 * the plan's second opinion, if it has one, finds nothing against a case.
 */
struct sweep_map;

/* *map is NULL for a plan that asks for none, and so all else does nothing. `best`: the
 * label that comes first in the legend, even if no case has it. STATUS_MEMORY. */
enum status sweep_map_create(struct sweep_map **map, const struct plan *plan,
                             const char *best);
void sweep_map_destroy(struct sweep_map *map);

/* `labels`: of the case, its colour; `learnt`: it is hatched. STATUS_MEMORY. */
enum status sweep_map_row(struct sweep_map *map, const struct plan_case *c,
                          const struct sweep_row *row, const char *labels, bool learnt);

/* As a chart; NULL: there is no map. STATUS_INPUT: a mark; STATUS_MEMORY. */
enum status sweep_map_chart(const struct sweep_map *map, struct chart **chart,
                            struct message *why);

/* --- The sweep. */

struct sweep_options {
    const char *folder; /* NULL: results/sweep_NAME                                    */
    enum sweep_start start;
    int jobs;   /* cases at a time; 0: as many as there are processors         */
    bool quiet; /* no progress bar, no summary                                 */
};

/* Runs what is not done yet of a plan, writes table.csv, seconds.csv and the map, prints a
 * summary. Alone, without the ranks of mpirun. STATUS_FILE: a result could not be
 * written; what is done stays. A signal that asks to stop ends the program as ever, after a
 * sentence. */
enum status sweep_run(const struct plan *plan, const struct sweep_options *options,
                      struct message *why);

extern const struct command sweep_command;

#endif

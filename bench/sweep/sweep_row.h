/* sweep_row.h - the file of a case in a sweep's folder, and what is known from it.
 *
 * Both kinds, result file and sentence, are sealed and carry sums of the case, of the plan
 * with its scenes and of the program: what is damaged is run again, what is of another
 * sweep is refused.
 */
#ifndef SWEEP_ROW_H
#define SWEEP_ROW_H

#include "bench/experiment/plan_case.h"
#include "bench/harness/run_result.h"
#include "bench/sweep/sweep_folder.h"

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

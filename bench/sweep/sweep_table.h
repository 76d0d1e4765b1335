/* sweep_table.h - what a sweep found: table.csv with every key and measure to 17 digits,
 * the verdict, the labels and how the case ended; seconds.csv; and words for people.
 * Seconds stand apart so that the table is the same bits however it came about.
 */
#ifndef SWEEP_TABLE_H
#define SWEEP_TABLE_H

#include "bench/files/output.h"
#include "bench/harness/pool.h"
#include "bench/sweep/sweep_falls.h"

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

#endif

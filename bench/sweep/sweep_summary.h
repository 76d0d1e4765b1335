/* sweep_summary.h - what a sweep found, in words for people. */
#ifndef SWEEP_SUMMARY_H
#define SWEEP_SUMMARY_H

#include <stdio.h>

#include "bench/harness/pool.h"
#include "bench/sweep/sweep_table.h"

/* Cases, verdicts, labels, processor time and where the files are. `plot`: why there is no
 * picture, or "". STATUS_FILE: `file` does not take it. */
enum status sweep_summary_print(const struct plan *plan, const struct sweep_folder *folder,
                                const struct pool *pool, const struct sweep_table *table,
                                const char *plot, FILE *file);

#endif

/* sweep_print.h - what a sweep found, in words for people. */
#ifndef SWEEP_PRINT_H
#define SWEEP_PRINT_H

#include <stdio.h>

#include "bench/harness/pool.h"
#include "bench/sweep/sweep_falls.h"
#include "bench/sweep/sweep_table.h"

/* The plan, how many cases have which label and end, what falls (NULL: nothing is to), what
 * they cost, where they are. `plot`: why there is no picture, or "". STATUS_FILE: the file
 * cannot be written. */
enum status sweep_print(const struct plan *plan, const struct sweep_folder *folder,
                        const struct pool *pool, const struct sweep_table *table,
                        const struct sweep_falls *falls, const char *plot, FILE *file);

#endif

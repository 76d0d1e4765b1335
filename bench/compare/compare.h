/* compare.h - the command `compare`: speed against error, all contestants, one scene. */
#ifndef COMPARE_H
#define COMPARE_H

#include "bench/compare/contest.h"
#include "bench/ui/command.h"
#include "bench/ui/table.h"

extern const struct command compare_command;

/* The table of all runs to `file` and as compare.csv in the folder, what each contestant
 * needs for given errors (compare_targets.csv) and what limits it (compare_limits.csv);
 * charts compare.png and compare_models.png as it goes. */
enum status compare_print(const struct contest *c, const char *folder,
                          enum table_format format, FILE *file, struct message *why);

/* The best rows with each number of threads, and compare_threads.csv; nothing where they
 * were not asked for. */
enum status compare_threads(const struct contest *c, const char *folder,
                            enum table_format format, FILE *file, struct message *why);

#endif

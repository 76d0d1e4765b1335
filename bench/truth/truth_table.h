/* truth_table.h - reference tables (fem_ref/reference.h) by name, "heavy_elastica": in
 * $CLOTHBENCH_REFERENCE, as installed, or in tests/reference. */
#ifndef TRUTH_TABLE_H
#define TRUTH_TABLE_H

#include "fem_ref/reference.h"

/* The caller closes it. */
enum status truth_table_open(const char *name, struct reference **table,
                             struct message *why);

/* Where it is, for readers of their own; freed by the caller. */
enum status truth_table_path(const char *name, char **path, struct message *why);

/* The number of a note, `# key: 0.01`; NaN: there is none. */
double truth_table_note(const struct reference *table, const char *key);

#endif

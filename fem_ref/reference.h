/* reference.h - strict reader of reference tables (tests/reference/): values computed or
 * printed elsewhere, with their provenance.
 *
 * Format: UTF-8 text. First comment lines, `#` in column 1; then one line of distinct
 * column names; then rows with exactly as many cells, separated by commas
 * (models/reader/csv.h). No blanks around cells, no blank lines; comments are allowed
 * between rows. A cell is text, a number or empty. A comment `# key: value` is a note.
 */
#ifndef REFERENCE_H
#define REFERENCE_H

#include "models/status.h"

struct reference;

/* Reads the whole file. STATUS_FILE if it cannot be read, STATUS_INPUT with `file:line:
 * what` if it breaks the format. *table is owned by the caller: reference_close (NULL is
 * allowed). On failure *table is untouched. */
enum status reference_open(const char *path, struct reference **table, struct message *why);
void reference_close(struct reference *table);

int reference_rows(const struct reference *table);

/* Returns the index of a column, -1 if there is none of that name. */
int reference_column(const struct reference *table, const char *name);

/* Returns a cell, borrowed; "" if empty, and if there is no such row or column. */
const char *reference_text(const struct reference *table, int row, const char *column);

/* Returns the cell as a number; NaN unless the whole cell is one finite decimal number. */
double reference_number(const struct reference *table, int row, const char *column);

/* Fails with STATUS_INPUT and `file:line: what` if any earlier call asked for a missing row
 * or column, or for a number where a text stands: call it when all is read. */
enum status reference_fault(const struct reference *table, struct message *why);

/* Returns the first row >= from whose cell in `column` is exactly `text`; -1 if none. */
int reference_find(const struct reference *table, int from, const char *column,
                   const char *text);

/* Returns the first comment `# key: value`'s value, borrowed, NULL if there is none; and
 * the number with which it begins, NaN if there is none. */
const char *reference_note(const struct reference *table, const char *key);
double reference_note_number(const struct reference *table, const char *key);

/* Finds the file of a table by its name, "heavy_elastica": in $CLOTHBENCH_REFERENCE, as
 * installed, or in tests/reference; *path is freed by the receiver. Opens that table.
 * STATUS_INPUT with a sentence that lists the known ones, and as reference_open. */
enum status reference_path(const char *name, char **path, struct message *why);
enum status reference_open_named(const char *name, struct reference **table,
                                 struct message *why);

#endif

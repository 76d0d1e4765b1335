/* table.h - a dataset as a table, in the formats that people and programs read. Called by
 * the printer alone.
 */
#ifndef TABLE_H
#define TABLE_H

#include <stdio.h>

#include "bench/data/dataset.h"
#include "models/status.h"

enum table_format { TABLE_TEXT, TABLE_CSV, TABLE_MARKDOWN, TABLE_LATEX, TABLE_JSON };

/* Prints it. In JSON it is an object {"caption", "units": {KEY: UNIT}, "rows": [{KEY:
 * VALUE}], "notes"}. STATUS_FILE if the stream fails (it is not flushed). */
enum status table_print(const struct dataset *t, enum table_format format, FILE *file);

/* Prints a line of keys and a line each row, as CSV without caption and notes. */
void table_lines(const struct dataset *t, FILE *file);

#endif

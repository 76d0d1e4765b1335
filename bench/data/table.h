/* table.h - a dataset as a table, in the formats that people and programs read. Called by
 * the printer alone.
 */
#ifndef TABLE_H
#define TABLE_H

#include <stdio.h>

#include "bench/data/dataset.h"
#include "models/status.h"

/* The formats: code, and the word for it, by which table.c finds its function. */
#define TABLE_FORMATS(X)                                                                   \
    X(TEXT, text) X(CSV, csv) X(MARKDOWN, markdown) X(LATEX, latex) X(JSON, json)
#define TABLE_CODE(code, word) TABLE_##code,
enum table_format { TABLE_FORMATS(TABLE_CODE) TABLE_KINDS };

/* Prints it. In JSON it is an object {"caption", "units": {KEY: UNIT}, "rows": [{KEY:
 * VALUE}], "notes"}. STATUS_FILE if the stream fails (it is not flushed). */
enum status table_print(const struct dataset *t, enum table_format format, FILE *file);

/* Prints a line of keys and a line each row, as CSV without caption and notes. */
void table_lines(const struct dataset *t, FILE *file);

#endif

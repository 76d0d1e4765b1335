/* table.h - tables of results, printed as aligned text, CSV, Markdown or LaTeX.
 *
 * A table is filled row by row, cell by cell, and printed at the end. Running out of memory
 * on the way is remembered and told by table_print, so that filling needs no checks:
 *
 *     struct table *t = table_create(COUNT(columns), columns, "Cost of a frame");
 *     table_row(t);
 *     table_text(t, "%s", model->title);
 *     table_number(t, 0.0123456, 3);
 *     table_note(t, "Median of %d repeats.", repeats);
 *     TRY(table_print(t, TABLE_TEXT, stdout));
 *     table_destroy(t);
 */
#ifndef TABLE_H
#define TABLE_H

#include <stdbool.h>
#include <stdio.h>

#include "models/status.h"

enum table_format { TABLE_TEXT, TABLE_CSV, TABLE_MARKDOWN, TABLE_LATEX };

/* The words of --format. STATUS_INPUT with a sentence that lists them. */
enum status table_format_parse(const char *word, enum table_format *format,
                               struct message *why);

enum table_align { TABLE_RIGHT, TABLE_LEFT };

struct table_column {
    const char *header;     /* borrowed until destroy; [a-z] words, short              */
    const char *unit;       /* "ms", "1", ...; NULL: none, as for names       borrowed */
    enum table_align align; /* right is for numbers                                    */
};

struct table;

/* Columns are copied, their strings borrowed. NULL without memory: every function below
 * takes that, and table_print says STATUS_MEMORY. The caption may be NULL. */
struct table *table_create(int column_count, const struct table_column *columns,
                           const char *caption);
void table_destroy(struct table *t); /* NULL is allowed */

/* Starts a row; cells left out at its end are empty. At most column_count cells fit. */
void table_row(struct table *t);

/* A line between the rows before and after (text and LaTeX). */
void table_rule(struct table *t);

/* The next cell of the row: words; a number to `digits` significant digits, trailing zeros
 * kept; a number to `decimals` places; a whole number; a number that does not exist for a
 * reason told elsewhere (a dash; nothing in CSV). CSV has numbers with 17 digits whatever
 * the digits asked for; NaN and infinities are printed as such. */
void table_text(struct table *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void table_number(struct table *t, double value, int digits);
void table_fixed(struct table *t, double value, int decimals);
void table_integer(struct table *t, long value);
void table_dash(struct table *t);

/* A sentence or paragraph below the table; wrapped in text, `# ` lines below CSV. */
void table_note(struct table *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* STATUS_MEMORY, or STATUS_FILE if the stream does not take it (the stream is not flushed).
 */
enum status table_print(const struct table *t, enum table_format format, FILE *file);

/* Words as notes are printed in text: lines of at most its width, then a line end. */
void table_print_wrapped(const char *text, FILE *file);

#endif

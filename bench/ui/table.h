/* table.h - data of results in named columns: the one way out for people (aligned text,
 * Markdown, LaTeX), for machines (CSV, JSON) and, as CSV, to charts.
 *
 * A table is filled row by row, cell by cell, and printed at the end; it lies in an arena
 * of its own (arena.h):
 *
 *     static const struct table_column columns[] = {
 *         {"model", NULL, TABLE_LEFT},
 *         {"a frame", "ms", .key = "frame_s", .key_unit = "s", .scale = 1e3},
 *         {"unknowns", .readers = TABLE_MACHINES}};
 *     struct table *t = TABLE_OF(columns, "Cost of a frame");
 *     table_line(t, "%s|%.3g|%d", model->title, 0.0123456, 540);
 *     table_note(t, "Median of %d repeats.", repeats);
 *     TRY(table_save(t, folder, "cost", why));
 *     TRY(table_finish(t, TABLE_TEXT, stdout));
 */
#ifndef TABLE_H
#define TABLE_H

#include <stdbool.h>
#include <stdio.h>

#include "models/status.h"

enum table_format { TABLE_TEXT, TABLE_CSV, TABLE_MARKDOWN, TABLE_LATEX, TABLE_JSON };

/* The values of --format, for tables of options. */
#define TABLE_FORMATS "text|csv|markdown|latex|json"

/* Reads a value of --format. STATUS_INPUT with a sentence that lists them. */
enum status table_format_parse(const char *word, enum table_format *format,
                               struct message *why);

/* Returns whether sentences may stand beside the tables (text, Markdown). CSV, JSON and
 * LaTeX, which other programs read, have tables with their captions and notes, and nothing
 * else. */
bool table_format_is_prose(enum table_format format);

/* Returns whether the format is CSV or JSON: one table with everything, where people get
 * several. */
bool table_format_is_data(enum table_format format);

enum table_align { TABLE_RIGHT, TABLE_LEFT };

/* The readers of a column: people read text, Markdown and LaTeX, machines CSV and JSON; a
 * column for nobody is filled but not printed. */
enum table_readers { TABLE_ALL, TABLE_PEOPLE, TABLE_MACHINES, TABLE_NOBODY };

struct table_column {
    const char *header;     /* borrowed until destroy; [a-z] words, short              */
    const char *unit;       /* "ms", "1", ...; NULL: none, as for names       borrowed */
    enum table_align align; /* right is for numbers                                    */

    /* The key for machines: "frame_ms", with the unit where there is one. NULL: made of
     * header and unit, `a frame` in `ms` gives a_frame_ms; a second one of that name gets
     * _2. */
    const char *key;
    enum table_readers readers;
    double scale;         /* people see value * scale, in `unit`; 0: 1                   */
    const char *key_unit; /* of the value itself, in JSON; NULL: `unit`                  */
};

struct table;

/* Creates a table. Columns are copied, their strings borrowed. The caption may be NULL. */
struct table *table_create(int column_count, const struct table_column *columns,
                           const char *caption);
void table_destroy(struct table *t); /* NULL is allowed */

/* Creates one of an array of columns. */
#define TABLE_OF(columns, caption)                                                         \
    table_create((int)(sizeof(columns) / sizeof *(columns)), columns, caption)

/* Starts a row; cells left out at its end are empty. At most column_count cells fit. */
void table_row(struct table *t);

/* Draws a line between the rows before and after (text and LaTeX). */
void table_rule(struct table *t);

/* Fills the next cells of the row, `|` between them, as printf has them. A cell that is one
 * conversion is a number: %.3g to significant digits, trailing zeros kept, %.2f to decimal
 * places (%.0f for whole numbers that may be missing), %d or %ld a whole one. Machines get
 * 17 digits in any case. NaN is a number that does not exist: a dash, empty in CSV, null in
 * JSON. Infinities are `inf`. `-` is a cell where there is nothing to show, and all else is
 * text. _line starts a row first. */
void table_add(struct table *t, const char *cells, ...)
    __attribute__((format(printf, 2, 3)));
#define table_line(t, ...) (table_row(t), table_add(t, __VA_ARGS__))

/* Fill the next cell with text, also of numbers alone; with words that say why there is
 * nothing to show, empty in CSV, null in JSON. */
void table_text(struct table *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void table_missing(struct table *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds a sentence or paragraph below the table; wrapped in text, `# ` lines below CSV. */
void table_note(struct table *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Prints the table. STATUS_FILE if the stream fails (it is not flushed). */
enum status table_print(const struct table *t, enum table_format format, FILE *file);

/* Print a table and destroy it; _finish: with an empty line after it, as one of several. In
 * JSON a table is an object {"caption", "units": {KEY: UNIT}, "rows": [{KEY: VALUE}],
 * "notes"}. */
enum status table_end(struct table *t, enum table_format format, FILE *file);
enum status table_finish(struct table *t, enum table_format format, FILE *file);

/* Returns the stream for the next object of JSON that goes to `file`. Those of standard
 * output are held back until table_json_close, which prints one as it is and several as
 * one array, so that the whole is JSON. */
FILE *table_json_open(FILE *file);
void table_json_close(void);

/* Prints a text as JSON, with its quotes. */
void table_json_string(const char *text, FILE *file);

/* Writes FOLDER/NAME.csv: a line of keys, a line each row, as many cells in each; no
 * caption and no notes. STATUS_FILE (as output.h). */
enum status table_save(const struct table *t, const char *folder, const char *name,
                       struct message *why);

/* Calls table_save, then table_finish; the table is destroyed in any case. */
enum status table_publish(struct table *t, const char *folder, const char *name,
                          enum table_format format, FILE *file, struct message *why);

/* Return the number of rows, and the column with a key (that of CSV), -1 if there is none.
 */
int table_rows(const struct table *t);
int table_find(const struct table *t, const char *key);

/* Returns the columns that words take on a screen: bytes that do not continue a character
 * of UTF-8; 0 for NULL. */
int table_width(const char *text);

/* Prints words as text's notes: lines of at most its width, then a line end. */
void table_print_wrapped(const char *text, FILE *file);

/* Prints a name, and from this column on text, wrapped to the width of a line of tables. */
void table_print_item(const char *name, int column, const char *text, FILE *file);

/* Prints printf's words wrapped: a sentence beside the tables, in a line of its own. */
void table_say(FILE *file, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif

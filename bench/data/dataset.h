/* dataset.h - labels by quantities: what people and programs get to read, held in memory as
 * rows of named columns. It prints nothing; printer.h does, in any format.
 *
 * A dataset is filled row by row, cell by cell; it lies in an arena of its own (arena.h):
 *
 *     static const struct dataset_column columns[] = {
 *         {"model"},
 *         {"a frame", "ms", .key = "frame_s", .key_unit = "s", .scale = 1e3},
 *         {"unknowns", .readers = DATASET_MACHINES}};
 *     struct dataset *t = DATASET_OF(columns, "Cost of a frame");
 *     dataset_line(t, "%s|%.3g|%d", model->title, 0.0123456, 540);
 *     dataset_note(t, "Median of %d repeats.", repeats);
 *     TRY(printer_table(printer, t, "cost", why));
 */
#ifndef DATASET_H
#define DATASET_H

#include <stdbool.h>

#include "bench/files/arena.h"

/* The readers of a column: people read text, Markdown and LaTeX, machines CSV and JSON; a
 * column for nobody is filled but not printed. */
enum dataset_readers { DATASET_ALL, DATASET_PEOPLE, DATASET_MACHINES, DATASET_NOBODY };

struct dataset_column {
    const char *header; /* borrowed until destroy; [a-z] words, short                  */
    const char *unit;   /* "ms", "1", ...; NULL: none, as for names           borrowed */

    /* The key for machines: "frame_ms", with the unit where there is one. NULL: made of
     * header and unit, `a frame` in `ms` gives a_frame_ms; a second one of that name gets
     * _2. */
    const char *key;
    enum dataset_readers readers;
    double scale;         /* people see value * scale, in `unit`; 0: 1                   */
    const char *key_unit; /* of the value itself, in JSON; NULL: `unit`                  */
};

struct dataset_cell {
    char *text; /* as people see it, or why it is missing; NULL: left out              */
    enum { DATASET_CELL_MISSING, DATASET_CELL_TEXT, DATASET_CELL_NUMBER } kind;
    double value; /* of a number, as machines get it                                   */
};

struct dataset_row {
    bool ruled; /* a rule above it */
    struct dataset_cell cell[];
};

struct dataset {
    int column_count, row_count, note_count;
    int filled;                     /* cells of the last row                             */
    bool rule_next;                 /* above the row to come                             */
    struct dataset_column *columns; /* [column_count], each with a key                   */
    int *width;                     /* [column_count] of the widest text so far          */
    bool *numeric;                  /* [column_count] some cell is a number              */
    struct dataset_row **rows;      /* [row_count]                                       */
    char *caption;                  /* NULL: none                                        */
    char **notes;                   /* [note_count]                                      */
    struct arena arena;             /*                                             owned */
};

/* Creates a table. Columns are copied, their strings borrowed. The caption may be NULL. */
struct dataset *dataset_create(int column_count, const struct dataset_column *columns,
                               const char *caption);
void dataset_destroy(struct dataset *t); /* NULL is allowed */
SCOPE_OF(dataset_destroy, struct dataset)

/* Creates one of an array of columns. */
#define DATASET_OF(columns, caption)                                                       \
    dataset_create((int)(sizeof(columns) / sizeof *(columns)), columns, caption)

/* Starts a row; cells left out at its end are empty. At most column_count cells fit. */
void dataset_row(struct dataset *t);

/* Draws a line between the rows before and after (text and LaTeX). */
void dataset_rule(struct dataset *t);

/* Fills the next cells of the row, `|` between them, as printf has them. A cell that is one
 * conversion is a number: %.3g to significant digits, trailing zeros kept, %.2f to decimal
 * places (%.0f for whole numbers that may be missing), %d or %ld a whole one. Machines get
 * 17 digits in any case. NaN is a number that does not exist: a dash, empty in CSV, null in
 * JSON. Infinities are `inf`. `-` is a cell where there is nothing to show, and all else is
 * text. _line starts a row first. */
void dataset_add(struct dataset *t, const char *cells, ...)
    __attribute__((format(printf, 2, 3)));
#define dataset_line(t, ...) (dataset_row(t), dataset_add(t, __VA_ARGS__))

/* Fill the next cell with text, also of numbers alone; with words that say why there is
 * nothing to show, empty in CSV, null in JSON. */
void dataset_text(struct dataset *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
void dataset_missing(struct dataset *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Adds a sentence or paragraph below the table; wrapped in text, `# ` lines below CSV. */
void dataset_note(struct dataset *t, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Return the number of rows, and the column with a key (that of CSV), -1 if there is none.
 */
int dataset_count(const struct dataset *t);
int dataset_find(const struct dataset *t, const char *key);

#endif

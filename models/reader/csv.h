/* csv.h - reads tables of values separated by commas: reference tables, and what
 * bench/data/table.h writes for machines. Tables stand one below the other, an empty line
 * between them. `# ` lines above a line of keys are its caption, those below its notes.
 * Cells may stand in quotes. The only reader of CSV with words in it.
 */
#ifndef CSV_H
#define CSV_H

#include <stdbool.h>

#include "models/status.h"

struct csv_table {
    char *caption, *notes; /* lines; "": none                                  borrowed */
    int columns, rows;     /* columns >= 1                                              */
    char **cell;           /* [1 + rows][columns], the keys first                 owned */
    int *line;             /* [1 + rows] in the file                              owned */
};

struct csv {
    int count;
    struct csv_table *table; /* [count]                                           owned */
    bool whole;              /* the last line has an end                               */
    char *text;              /* in which all strings lie                          owned */
};

/* Reads a file, which is no link. STATUS_FILE: it cannot be read; STATUS_INPUT: too long, a
 * byte 0, a quote without end, a row with more or fewer cells than keys; each a sentence
 * with file and line. *csv is then all-zero. Free with csv_clear. */
enum status csv_read(const char *path, struct csv *csv, struct message *why);
void csv_clear(struct csv *csv); /* all-zero is allowed */

/* Returns the index of a key, -1: there is none. */
int csv_column(const struct csv_table *t, const char *key);

/* Return a cell: as words ("" if there is none), as a number (NaN if it is none); _of: of a
 * column by its key. */
const char *csv_words(const struct csv_table *t, int row, int column);
double csv_number(const struct csv_table *t, int row, int column);
const char *csv_words_of(const struct csv_table *t, int row, const char *key);
double csv_number_of(const struct csv_table *t, int row, const char *key);

#endif

/* table_parts.h - what table.c fills, table_print.c and table_machine.c print; no business
 * of others. */
#ifndef TABLE_PARTS_H
#define TABLE_PARTS_H

#include "bench/ui/table.h"

struct table_cell {
    char *text; /* as people see it, or why it is missing; NULL: left out        owned */
    enum { TABLE_CELL_MISSING, TABLE_CELL_TEXT, TABLE_CELL_NUMBER } kind;
    double value; /* of a number, as machines get it                                   */
};

struct table {
    int column_count, row_count, note_count;
    int room, filled;             /* rows allocated; cells of the last row             */
    bool failed;                  /* out of memory somewhere                           */
    bool flushed;                 /* table_flush has printed the keys                  */
    struct table_column *columns; /* [column_count], each with a key             owned */
    int *width;                   /* [column_count] of the widest text so far    owned */
    struct table_cell *cells;     /* [room][column_count]                        owned */
    bool *ruled;                  /* [room]: a rule above this row               owned */
    char *caption;                /*                                             owned */
    char **notes;                 /* [note_count]                                owned */
};

/* Of table.c. */
const struct table_cell *table_cell(const struct table *t, int row, int column);

/* Of table_print.c: the cells of one row that these readers, people or machines, get, with
 * what stands before, between and behind them. The row of headers or keys comes first. */
enum { TABLE_UNITS = -2, TABLE_HEADERS = -1 };
struct table_line {
    enum table_readers readers;
    const char *before, *between, *behind;
    void (*print)(const struct table *t, int row, int column, FILE *file);
};
bool table_print_has(const struct table *t, int column, enum table_readers readers);
void table_print_line(const struct table *t, const struct table_line *line, int row,
                      FILE *file);

/* A text with something else for some of its characters. */
void table_print_escaped(const char *text, const char *const escaped[128], FILE *file);

/* table_machine.c, called by table_print. */
void table_machine_csv(const struct table *t, FILE *file);
void table_machine_json(const struct table *t, FILE *file);

/* The key of the n-th of these columns, which has none, into memory of the caller's. NULL
 * without memory. */
char *table_machine_key(const struct table_column *columns, int n);

#endif

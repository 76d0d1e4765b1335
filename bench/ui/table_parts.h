/* table_parts.h - what table.c fills, table_print.c and table_machine.c print; no business
 * of others. */
#ifndef TABLE_PARTS_H
#define TABLE_PARTS_H

#include "bench/ui/table.h"

enum table_cell_kind {
    TABLE_CELL_MISSING, /* left out, or its text says why                              */
    TABLE_CELL_TEXT,
    TABLE_CELL_NUMBER
};

struct table_cell {
    char *text; /* as people see it; NULL: empty                                 owned */
    enum table_cell_kind kind;
    double value; /* of a number, as machines get it                                   */
};

struct table {
    int column_count, row_count, note_count;
    int room, filled;             /* rows allocated; cells of the last row             */
    bool failed;                  /* out of memory somewhere                           */
    bool flushed;                 /* table_flush has printed the keys                  */
    struct table_column *columns; /* [column_count], each with a key             owned */
    struct table_cell *cells;     /* [room][column_count]                        owned */
    bool *ruled;                  /* [room]: a rule above this row               owned */
    char *caption;                /*                                             owned */
    char **notes;                 /* [note_count]                                owned */
};

/* Of table.c: whether these readers, people or machines, get a column. */
bool table_has(const struct table *t, int column, enum table_readers readers);

/* table_machine.c, called by table_print. */
void table_machine_csv(const struct table *t, FILE *file);
void table_machine_json(const struct table *t, FILE *file);

/* The key of a column that has none, and is the n-th of `count`, into memory of the
 * caller's. NULL without memory. */
char *table_machine_key(const struct table_column *columns, int n);

#endif

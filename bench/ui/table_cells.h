/* table_cells.h - what table.c fills and table_print.c prints; no business of others. */
#ifndef TABLE_CELLS_H
#define TABLE_CELLS_H

#include "bench/ui/table.h"

enum table_cell_kind { TABLE_CELL_TEXT, TABLE_CELL_NUMBER, TABLE_CELL_DASH };

struct table_cell {
    char *text; /* as printed, except in CSV; NULL: empty                       owned  */
    enum table_cell_kind kind;
    double value; /* of a number                                                       */
};

struct table {
    int column_count, row_count, note_count;
    int room, filled;             /* rows allocated; cells of the last row             */
    bool failed;                  /* out of memory somewhere                           */
    struct table_column *columns; /* [column_count]                              owned */
    struct table_cell *cells;     /* [row_count][column_count]                   owned */
    bool *ruled;                  /* [room]: a rule above this row               owned */
    char *caption;                /*                                             owned */
    char **notes;                 /* [note_count]                                owned */
};

#endif

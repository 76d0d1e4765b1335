/* export_numbers.h - the numbers of a net of points, as a table. */
#ifndef EXPORT_NUMBERS_H
#define EXPORT_NUMBERS_H

#include "bench/export/export_sheet.h"
#include "bench/ui/table.h"

/* Makes a table of the numbers of a net of points (export_numbers.c): equal ones share a
 * row with their count; owned by the caller. STATUS_MEMORY. */
enum status export_numbers_table(const struct export_sheet *s, struct table **table);

#endif

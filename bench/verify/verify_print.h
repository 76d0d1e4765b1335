/* verify_print.h - rows of checks for people, and how many end how. */
#ifndef VERIFY_PRINT_H
#define VERIFY_PRINT_H

#include "bench/ui/table.h"
#include "bench/verify/verify_check.h"

/* Tables of sheets[count], and below them how many rows of each check end how. CSV: one
 * table. */
enum status verify_print(int count, const struct verify_check *const *checks,
                         const struct verify_sheet *sheets, enum table_format format,
                         FILE *file);

#endif

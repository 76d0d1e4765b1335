/* verify_sheet.h - the rows of a verification: made by checks, kept in a file, printed from
 * it. */
#ifndef VERIFY_SHEET_H
#define VERIFY_SHEET_H

#include "bench/ui/table.h"
#include "bench/verify/verify.h"

struct verify_sheet {
    const struct verify_check *check; /* whose rows they are                  borrowed */
    const char *models;               /* "iga,hex"; NULL: all                 borrowed */
    bool quick;
    int count, room;
    struct verify_row *rows; /* [count]                                       owned    */
    struct verify_row spare; /* where rows go when memory is out                       */
    bool failed;             /* it is                                                  */
};

void verify_sheet_clear(struct verify_sheet *sheet); /* all-zero is allowed */

/* FOLDER/CHECK.csv: a reference table (reference.h) with provenance in its comments. */
enum status verify_sheet_write(const struct verify_sheet *sheet, const char *folder,
                               struct message *why);

/* The same rows from the file; *sheet is overwritten. STATUS_FILE: there is none. */
enum status verify_sheet_read(const struct verify_check *check, const char *folder,
                              struct verify_sheet *sheet, struct message *why);

/* Tables of sheets[count], and below them how many rows of each check end how. CSV: one
 * table. */
enum status verify_sheet_print(const struct verify_sheet *sheets, int count,
                               enum table_format format, FILE *file, struct message *why);

#endif

/* verify_file.h - rows of a check as a table: printed, written to a file, read from it. */
#ifndef VERIFY_FILE_H
#define VERIFY_FILE_H

#include "bench/ui/table.h"
#include "bench/verify/verify_check.h"

/* An empty table of rows (table_create), and one more row of it. Check, source and remark
 * are columns for machines. */
struct table *verify_file_table(const char *caption);
void verify_file_row(struct table *t, const struct verify_check *check,
                     const struct verify_row *row);

/* FOLDER/CHECK.csv: the table, with provenance in comments above it. */
enum status verify_file_write(const struct verify_check *check,
                              const struct verify_sheet *sheet, const char *folder,
                              struct message *why);

/* The same rows from the file; *sheet is overwritten. STATUS_FILE: there is none;
 * STATUS_INPUT: it is none of these. */
enum status verify_file_read(const struct verify_check *check, const char *folder,
                             struct verify_sheet *sheet, struct message *why);

#endif

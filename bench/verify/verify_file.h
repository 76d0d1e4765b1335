/* verify_file.h - rows of a check as a file, and as tables for people. */
#ifndef VERIFY_FILE_H
#define VERIFY_FILE_H

#include "bench/verify/verify_sheet.h"

/* FOLDER/NAME.csv: a reference table (reference.h) with provenance in its comments. */
enum status verify_file_write(const struct verify_sheet *sheet, const char *name,
                              const char *folder, struct message *why);

/* The same rows from the file; *sheet is overwritten. STATUS_FILE: there is none. */
enum status verify_file_read(const char *name, const char *folder,
                             struct verify_sheet *sheet, struct message *why);

#endif

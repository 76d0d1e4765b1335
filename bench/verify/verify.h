/* verify.h - `clothbench verify`: every contestant against every truth that applies. */
#ifndef VERIFY_H
#define VERIFY_H

#include "bench/verify/verify_check.h"

/* All checks of bench/verify/checks. */
extern const struct command verify_command;

/* The command on other checks (NULL ends them), with tables to `out`. STATUS_FAILED: rows
 * were judged, and a claim is missed or died; the sentence says how many, and where. */
enum status verify_run(const struct verify_check *const *known,
                       const struct command_line *line, FILE *out, struct message *why);

/* FOLDER/CHECK.csv: the rows of a check, with provenance in comments above them. */
enum status verify_file_write(const struct verify_check *check,
                              const struct verify_sheet *sheet, const char *folder,
                              struct message *why);

/* The same rows from the file; *sheet is overwritten. STATUS_FILE: there is none;
 * STATUS_INPUT: it is none of these. */
enum status verify_file_read(const struct verify_check *check, const char *folder,
                             struct verify_sheet *sheet, struct message *why);

#endif

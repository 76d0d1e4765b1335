/* verify.h - `clothbench verify`: holds every contestant against every truth that applies.
 */
#ifndef VERIFY_H
#define VERIFY_H

#include "bench/verify/verify_check.h"

/* A set has the checks that a command runs. */
struct verify_set {
    const char *command, *item;               /* words for it, and for one of its checks  */
    const struct verify_check *const *checks; /* NULL ends them                           */
    const char *folder;                       /* unless --out or --from names one         */
    const char *note;                         /* below the count of verdicts              */
    bool apart; /* every row in a process of its own: checks have one part and one row a
                   subject; nothing was promised, and the command does not fail           */
};

/* The options of such a command, of which the first is for one whose rows are apart. */
extern const struct command_option verify_options[];

/* Runs the command and prints its tables. STATUS_FAILED: claims are missed or died;
 * the sentence says how many, and where. */
enum status verify_run(const struct verify_set *set, struct command_line *line,
                       struct message *why);

/* Writes the rows of a check to FOLDER/CHECK.csv, with the command and provenance in
 * comments above. */
enum status verify_file_write(const char *command, const struct verify_check *check,
                              const struct verify_sheet *sheet, const char *folder,
                              struct message *why);

/* Reads them back; *sheet is overwritten. STATUS_FILE: there is no file; STATUS_INPUT: it
 * holds no such rows. */
enum status verify_file_read(const struct verify_check *check, const char *folder,
                             struct verify_sheet *sheet, struct message *why);

#endif

/* kept.h - keeps the tables of a command in its folder for the report: FOLDER/printed.csv
 * has its tables with captions and notes (csv.h) and, as a last one, the statements that
 * were judged (judge.h).
 */
#ifndef KEPT_H
#define KEPT_H

#include "models/status.h"

#define KEPT_NAME      "printed.csv"
#define KEPT_SENTENCES "Sentences of the paper"

struct kept;

/* Starts to keep all tables that are printed. In a folder that cannot be written to nothing
 * is kept: *kept is NULL then. */
void kept_open(const char *folder, const char *command, const char *word,
               struct kept **kept);

/* Completes the file; *kept is NULL afterwards, and may be before. STATUS_FILE. */
enum status kept_close(struct kept **kept, struct message *why);

/* Leaves the file as it was before. *kept as above. */
void kept_discard(struct kept **kept);

#endif

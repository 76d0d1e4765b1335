/* kept.h - what a command prints, kept in its folder for the report: FOLDER/printed.csv has
 * its tables with captions and notes (csv.h) and, as a last one, the paper's sentences that
 * were judged (judge.h).
 */
#ifndef KEPT_H
#define KEPT_H

#include "models/status.h"

#define KEPT_NAME      "printed.csv"
#define KEPT_SENTENCES "Sentences of the paper"

struct kept;

/* From now on all that is printed is kept. A folder that cannot be written to is none that
 * anything is kept in: *kept is NULL then, and what is printed is as good. */
void kept_open(const char *folder, const char *command, const char *word,
               struct kept **kept);

/* Completes the file, *kept is NULL afterwards, and may be before. STATUS_FILE. */
enum status kept_close(struct kept **kept, struct message *why);
void kept_discard(struct kept **kept); /* the file stays as it was before */

#endif

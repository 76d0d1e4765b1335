/* kept.h - prints what a command has to tell, and keeps it in its folder for the report:
 * FOLDER/printed.csv has its tables with captions and notes (csv.h) and, as a last one, the
 * statements that were judged (judge.h).
 */
#ifndef KEPT_H
#define KEPT_H

#include "bench/experiment/judge.h"
#include "bench/data/printer.h"

#define KEPT_NAME      "printed.csv"
#define KEPT_SENTENCES "Sentences of the paper"

struct kept;

/* Prints a statement that was judged, where the printer prints, and keeps it; kept NULL:
 * not.
 */
void kept_told(const struct printer *p, struct kept *kept, const struct judge_told *told);

/* Starts a file, which gets a copy of the tables of *p from then on. In a folder that
 * cannot be written to nothing is kept: *kept is NULL then. */
void kept_open(const char *folder, const char *command, const char *word, struct printer *p,
               struct kept **kept);

/* Completes the file; *kept is NULL afterwards, and may be before. STATUS_FILE. */
enum status kept_close(struct kept **kept, struct message *why);

/* Leaves the file as it was before. *kept as above. */
void kept_discard(struct kept **kept);

#endif

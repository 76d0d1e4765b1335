/* peers.h - the times of other people's programs for the same work:
 * tests/reference/peers.csv, measured elsewhere side by side with ours; named, with version
 * and solver, and never in a ratio with what is measured here. */
#ifndef PEERS_H
#define PEERS_H

#include "bench/ui/table.h"

/* Adds a note on everybody in the file who did the work `name`; nothing if there is nobody.
 * NULL is allowed for the table, as in table.h. Errors as reference_open_named. */
enum status peers_note(struct table *t, const char *name, struct message *why);

#endif

/* peers.h - what other people's programs take for the same work: tests/reference/peers.csv,
 * measured side by side with ours, elsewhere; named, with version and solver, and never in
 * a ratio with what is measured here. */
#ifndef PEERS_H
#define PEERS_H

#include "bench/ui/table.h"

/* A note on everybody in the file who did the work `name`; nothing if there is nobody. NULL
 * is allowed for the table, as in table.h. Errors as truth_table_open. */
enum status peers_note(struct table *t, const char *name, struct message *why);

#endif

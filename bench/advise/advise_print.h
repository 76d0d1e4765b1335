/* advise_print.h - what the search of `advise` came to: the command to use, who else
 * serves, who does not and why. */
#ifndef ADVISE_PRINT_H
#define ADVISE_PRINT_H

#include "bench/advise/advise_search.h"
#include "bench/ui/table.h"

/* The table of all contestants, best first, to `file` and as advise.csv in the folder; in
 * prose formats with the answer above it. */
enum status advise_print(const struct advise_search *s, enum table_format format,
                         FILE *file, struct message *why);

#endif

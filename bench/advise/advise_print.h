/* advise_print.h - what the search of `advise` came to: the command to use, who else
 * serves, who does not and why. */
#ifndef ADVISE_PRINT_H
#define ADVISE_PRINT_H

#include "bench/advise/advise_search.h"
#include "bench/ui/table.h"

/* The table of all contestants, best first, to `file` and as advise.csv in the folder; in
 * prose formats with the answer above it, and the parameters of the best one's net, if that
 * is one of points; they are advise_net.csv in the folder. */
enum status advise_print(const struct advise_search *s, enum table_format format,
                         FILE *file, struct message *why);

#endif

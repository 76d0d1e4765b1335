/* league.h - contestants over several scenes: what each takes for the same error, who is
 * cheapest where, and by how much.
 */
#ifndef LEAGUE_H
#define LEAGUE_H

#include "bench/compare/contest.h"
#include "bench/data/printer.h"

/* Returns the error over the length that is compared where the truth has this bar: one per
 * cent, or the least of contest_target that the truth is known to; NaN: none. */
double league_target(double bar);

/* Prints the contests of scenes side by side: for people a row a contestant and a column a
 * scene; for machines, and as compare_scenes.csv in the folder, a row for each of both.
 */
enum status league_print(int count, const struct contest *const *contests,
                         struct printer *p, struct message *why);

#endif

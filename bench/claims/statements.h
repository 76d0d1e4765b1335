/* statements.h - what the paper states, of all plans, in one table: by section, with its
 * primary reading, our numbers, the verdict, what another reading turns, and ours beside.
 */
#ifndef STATEMENTS_H
#define STATEMENTS_H

#include "bench/claims/claim.h"

struct statements;

/* Makes an empty one. NULL without memory, which the others accept. */
struct statements *statements_create(void);
void statements_destroy(struct statements *s);

/* Judges all claims on a plan and adds those of the paper. STATUS_MEMORY. */
enum status statements_add(struct statements *s, const struct study_results *r);

/* Prints them by section; for people with their count, in all other formats as a table. */
enum status statements_print(struct statements *s, struct printer *p, struct message *why);

#endif

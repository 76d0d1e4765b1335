/* statements.h - what the paper states, of all plans, in one table: by section, with its
 * primary reading, our numbers, the verdict, what another reading turns, and ours beside.
 */
#ifndef STATEMENTS_H
#define STATEMENTS_H

#include "bench/claims/claim.h"

/* All-zero: none. */
struct statements {
    struct arena arena; /* of all texts                                          owned */
    int count;
    struct judge_told *told; /* [count]                                                */
    char machine[4096];      /* a file whose provenance holds for all                  */
};

/* Judges all claims on a plan and adds those of the paper. */
void statements_add(struct statements *s, const struct study_results *r);

/* Prints them by section; for people with their count, in all other formats as a table. */
enum status statements_print(struct statements *s, struct printer *p, struct message *why);

#endif

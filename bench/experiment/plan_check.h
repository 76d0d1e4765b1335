/* plan_check.h - what a plan must be beyond its schema: no key from two places, no more
 * cases than anybody can want, and every value good in a case with all else at its first.
 */
#ifndef PLAN_CHECK_H
#define PLAN_CHECK_H

#include "bench/experiment/plan.h"

/* Fills plan->keys and checks. STATUS_INPUT with a sentence `plan:line: ...`. */
enum status plan_check(struct plan *plan, struct message *why);

#endif

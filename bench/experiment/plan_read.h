/* plan_read.h - plans that can be run: no key from two places, no more cases than anybody
 * can want, and every value good in a case with all else at its first.
 */
#ifndef PLAN_READ_H
#define PLAN_READ_H

#include "bench/experiment/plan.h"

/* plan_parse, plan->keys, and the checks. STATUS_INPUT with a sentence `plan:line: ...`. */
enum status plan_read(const char *path, struct plan *plan, struct message *why);

#endif

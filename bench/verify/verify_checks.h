/* verify_checks.h - the checks there are. */
#ifndef VERIFY_CHECKS_H
#define VERIFY_CHECKS_H

#include "bench/verify/verify_check.h"

extern const struct verify_check *const verify_checks[]; /* ends with NULL */

/* The same as the command's items. */
extern const struct command_item *const verify_checks_items[];

#endif

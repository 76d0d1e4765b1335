/* verify.h - `clothbench verify`: every contestant against every truth that applies. */
#ifndef VERIFY_H
#define VERIFY_H

#include "bench/verify/verify_check.h"

/* All checks of bench/verify/checks. */
extern const struct command verify_command;

/* The command on other checks (NULL ends them), with tables to `out`. STATUS_FAILED: rows
 * were judged, and a claim is missed or died; the sentence says how many, and where. */
enum status verify_run(const struct verify_check *const *known,
                       const struct command_line *line, FILE *out, struct message *why);

#endif

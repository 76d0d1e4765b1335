/* report_summary.h - what was found, in three sentences: the paper's claims, speed at equal
 * error, and the checks. */
#ifndef REPORT_SUMMARY_H
#define REPORT_SUMMARY_H

#include "bench/report/report_claim.h"

/* Writes "found":[three sentences],"best":[the title of each model's best contestant], for
 * the parts `compare` and `verify`. STATUS_MEMORY. */
enum status report_summary_write(FILE *file, const struct report_tally *claims,
                                 const struct report_found *compare,
                                 const struct report_found *verify);

#endif

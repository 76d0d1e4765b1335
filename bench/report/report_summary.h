/* report_summary.h - the paper's claims with each one's verdict by the commands (kept.h),
 * and what was found, in three sentences: those claims, speed at equal error, and the
 * checks. */
#ifndef REPORT_SUMMARY_H
#define REPORT_SUMMARY_H

#include "bench/report/report_part.h"

/* Writes "claims":[{"part", "claim", "verdict", "text", "quick"}, ...], "found":[three
 * sentences], "best":[the title of each model's best contestant]; `found` is in the order
 * of report_part_list. STATUS_MEMORY. */
enum status report_summary_write(FILE *file, const struct report_found *found);

#endif

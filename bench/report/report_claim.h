/* report_claim.h - the paper's claims, and each one's verdict by the commands (kept.h). */
#ifndef REPORT_CLAIM_H
#define REPORT_CLAIM_H

#include "bench/report/report_part.h"

/* Counts of claims. */
struct report_tally {
    int all, hold, fail;
};

/* Writes members of an array of JSON, {"part", "claim", "verdict", "text", "quick"}, a line
 * a claim, and counts them; `found` is in the order of report_part_list. A part that was
 * not run, or cannot be read, has one line that says so. */
void report_claim_write(FILE *file, const struct report_found *found,
                        struct report_tally *tally);

#endif

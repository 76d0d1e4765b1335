/* report_summary.h - the paper's claims with each one's verdict by the commands (kept.h),
 * and what was found, in four sentences: those claims, speed at equal error, the checks and
 * contact. */
#ifndef REPORT_SUMMARY_H
#define REPORT_SUMMARY_H

#include "bench/report/report_part.h"

/* A contestant's run; words are borrowed from its table. */
struct report_run {
    const char *title, *contestant, *model;
    double seconds, error; /* [s], over the length                                       */
};

/* Returns the table of speed against error; NULL: there is none. */
const struct csv_table *report_summary_runs(const struct report_found *compare);

/* Finds the best run of each model in a table of runs, best first; returns their count.
 * best[rows of the table]. */
int report_summary_best(const struct csv_table *t, struct report_run *best);

enum { REPORT_SENTENCES = 4, REPORT_SENTENCE = 512 };

/* Writes "claims":[{"part", "claim", "verdict", "text", "quick"}, ...], "found":[the
 * sentences on claims, speed at equal error, checks and contact], and fills `said` with
 * these sentences; `found` is in the order of report_part_list. STATUS_MEMORY. */
enum status report_summary_write(FILE *file, const struct report_found *found,
                                 char said[REPORT_SENTENCES][REPORT_SENTENCE]);

#endif

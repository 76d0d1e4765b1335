/* results.h - reads the results of a plan's studies as rows that labels name, for tables
 * and claims.
 *
 * The labels of a level are its study's name on the axis "study", and its label on each
 * axis of the study. A row is a level at the study's last time unless {"at", "0.5"} names
 * another, or {"at", "*"} all of them.
 *
 *     results_at(d, QUANTITY_FRAME, WHERE({"solver", "direct"}, {"net", "5x5x2"}))
 */
#ifndef RESULTS_H
#define RESULTS_H

#include "bench/experiment/kept.h"
#include "bench/experiment/study.h"

/* Returns the label of a level on an axis; NULL: its study has no such axis. */
const char *results_label(const struct study *s, int level, const char *axis);

/* Lists at most `most` labels of an axis, each once, in the plan's order; returns how many.
 */
int results_labels(const struct study_results *d, const char *axis, int most,
                   const char **label);

/* Returns the value in the row that all labels name; NaN if none or several are named. */
double results_at(const struct study_results *d, enum quantity q,
                  const struct where *where);

/* Judges whether the plan's rules give that row's run a label (rules.h); NULL: whether
 * they call it feasible. Open: no such row, or nothing to judge by. */
enum verdict results_verdict(const struct study_results *d, const char *label,
                             const struct where *where);

/* Return the largest and the smallest value of all rows that the labels name and that have
 * one; NaN if there is none. The third returns the largest, and NaN if a row has none. */
double results_most(const struct study_results *d, enum quantity q,
                    const struct where *where);
double results_least(const struct study_results *d, enum quantity q,
                     const struct where *where);
double results_all_most(const struct study_results *d, enum quantity q,
                        const struct where *where);

/* Lists the values of the first `most` rows that the labels name, in the plan's order, and
 * returns how many. The second writes all of them as "2.1, died, 5.6". */
int results_values(const struct study_results *d, enum quantity q,
                   const struct where *where, int most, double *values);
void results_write(const struct study_results *d, enum quantity q,
                   const struct where *where, FILE *file);

/* Returns the value of one row over that of another; NaN unless each names one row. */
double results_ratio(const struct study_results *d, enum quantity q, const struct where *a,
                     const struct where *b);

/* Returns the rms distance of two rows at the first one's time over the length; NaN unless
 * each names one row. */
double results_apart(const struct study_results *d, const struct where *a,
                     const struct where *b);

/* Returns the slope of log y over log x in the rows that the labels name; NaN with fewer
 * than two. */
double results_exponent(const struct study_results *d, enum quantity x, enum quantity y,
                        const struct where *where);

/* Checks that the plan's table and chart name quantities. STATUS_INPUT with a sentence
 * `plan:line: ...`. */
enum status results_check(const struct plan *plan, struct message *why);

/* Prints the table that the plan asks for, also as FOLDER/NAME.csv, and writes the points
 * of its chart as FOLDER/NAME_chart.csv; NAME is the plan's. Studies
 * of a plan without a table are printed one by one, under their names: cost and differences
 * of the levels, with observed orders. */
enum status results_print(const struct study_results *d, struct printer *p,
                          struct message *why);

#endif

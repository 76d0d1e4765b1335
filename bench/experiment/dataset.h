/* dataset.h - the results of a plan's studies as rows that labels name: what tables print
 * and claims ask.
 *
 * The labels of a level are its study's name on the axis "study", and its label on each
 * axis of the study, or on the axis "level" where levels are listed. A row is a level at
 * the study's last time unless {"at", "0.5"} names another, or {"at", "*"} all of them.
 *
 *     dataset_at(d, QUANTITY_FRAME, WHERE({"solver", "direct"}, {"net", "5x5x2"}))
 */
#ifndef DATASET_H
#define DATASET_H

#include "bench/experiment/judge.h"
#include "bench/experiment/quantity.h"
#include "bench/experiment/study.h"

struct where {
    const char *axis, *label; /* "!LABEL": any other; "WORD*": any that begins so      */
};
#define WHERE(...) ((const struct where[]){__VA_ARGS__, {NULL, NULL}})

/* Label of a level on an axis; NULL: its study has no such axis. */
const char *dataset_label(const struct study *s, int level, const char *axis);

/* The labels of an axis, each once, in the plan's order: those of at most `most`. */
int dataset_labels(const struct study_results *d, const char *axis, int most,
                   const char **label);

/* The value in the row that all labels name; NaN if no row or more than one is named. */
double dataset_at(const struct study_results *d, enum quantity q,
                  const struct where *where);

/* Whether the plan's rules give that row's run a label (verdict.h); NULL: call it feasible.
 * Open: no such row, or nothing to judge by. */
enum judge dataset_verdict(const struct study_results *d, const char *label,
                           const struct where *where);

/* The largest and the smallest of all rows that the labels name and that have one; NaN if
 * there is none. The third is the largest, and NaN if a row has none. */
double dataset_most(const struct study_results *d, enum quantity q,
                    const struct where *where);
double dataset_least(const struct study_results *d, enum quantity q,
                     const struct where *where);
double dataset_all_most(const struct study_results *d, enum quantity q,
                        const struct where *where);

/* The values of the first `most` rows that the labels name, in the plan's order; returns
 * how many there are. The second writes them as "2.1, died, 5.6". */
int dataset_values(const struct study_results *d, enum quantity q,
                   const struct where *where, int most, double *values);
void dataset_write(const struct study_results *d, enum quantity q,
                   const struct where *where, FILE *file);

/* The value of one row over that of another; NaN unless both are one. */
double dataset_ratio(const struct study_results *d, enum quantity q, const struct where *a,
                     const struct where *b);

/* rms distance of two rows at the first one's time, over the length; NaN unless both are
 * one. */
double dataset_apart(const struct study_results *d, const struct where *a,
                     const struct where *b);

/* Slope of log y over log x in the rows that the labels name; NaN with fewer than two. */
double dataset_exponent(const struct study_results *d, enum quantity x, enum quantity y,
                        const struct where *where);

/* STATUS_INPUT with a sentence `plan:line: ...`: the plan's table or chart asks for what is
 * no quantity. */
enum status dataset_check(const struct plan *plan, struct message *why);

/* The table that the plan asks for, also as FOLDER/PLAN.csv; of a plan that asks for none,
 * study_print_all. The chart that it asks for is drawn as FOLDER/PLAN.png; or under
 * the name that the plan gives them. */
enum status dataset_print(const struct study_results *d, const char *folder,
                          enum table_format format, FILE *file, struct message *why);

#endif

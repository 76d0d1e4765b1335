/* dataset.h - the results of a plan's studies as rows that labels name: what tables print
 * and claims ask.
 *
 * The labels of a level are its study's name on the axis "study", and its label on each
 * axis of the study, or on the axis "level" where levels are listed.
 *
 *     dataset_at(d, QUANTITY_FRAME, WHERE({"solver", "direct"}, {"net", "5x5x2"}))
 */
#ifndef DATASET_H
#define DATASET_H

#include "bench/experiment/judge.h"
#include "bench/experiment/quantity.h"
#include "bench/experiment/study.h"

struct where {
    const char *axis, *label; /* "!LABEL": any other                                   */
};
#define WHERE(...) ((const struct where[]){__VA_ARGS__, {NULL, NULL}})

/* Label of a level on an axis; NULL: its study has no such axis. */
const char *dataset_label(const struct study *s, int level, const char *axis);

/* The labels of an axis, each once, in the plan's order: those of at most `most`. */
int dataset_labels(const struct study_results *d, const char *axis, int most,
                   const char **label);

/* The value in the row that all labels name, at its study's last time; NaN if no row or
 * more than one is named. */
double dataset_at(const struct study_results *d, enum quantity q,
                  const struct where *where);

/* How many times that row has, and its value at one of them, from 0. */
int dataset_times(const struct study_results *d, const struct where *where);
double dataset_at_time(const struct study_results *d, enum quantity q, int time,
                       const struct where *where);

/* Whether the plan's rules give that row's run a label (verdict.h); NULL: call it feasible.
 * Open: no such row, or nothing to judge by. */
enum judge dataset_verdict(const struct study_results *d, const char *label,
                           const struct where *where);

/* The largest and the smallest of all rows that the labels name; NaN if there is none. */
double dataset_most(const struct study_results *d, enum quantity q,
                    const struct where *where);
double dataset_least(const struct study_results *d, enum quantity q,
                     const struct where *where);

/* rms distance of two rows at their last time, over the length; NaN unless both are one. */
double dataset_apart(const struct study_results *d, const struct where *a,
                     const struct where *b);

/* Slope of log y over log x in the rows that the labels name; NaN with fewer than two. */
double dataset_exponent(const struct study_results *d, enum quantity x, enum quantity y,
                        const struct where *where);

/* STATUS_INPUT with a sentence `plan:line: ...`: the plan's table or chart asks for what is
 * no quantity. */
enum status dataset_check(const struct plan *plan, struct message *why);

/* The table that the plan asks for, also as FOLDER/PLAN.csv; of a plan that asks for none,
 * study_print_all. */
enum status dataset_print(const struct study_results *d, const char *folder,
                          enum table_format format, FILE *file, struct message *why);

#endif

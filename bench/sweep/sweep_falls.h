/* sweep_falls.h - whether a measure falls along an axis of a plan (`falls`): a row for each
 * choice of the other keys, the values of the axis as columns, and where it grows.
 */
#ifndef SWEEP_FALLS_H
#define SWEEP_FALLS_H

#include "bench/sweep/sweep_folder.h"
#include "bench/ui/table.h"

struct sweep_falls;

/* *falls is NULL for a plan in which nothing is to fall, and all else then does nothing.
 * STATUS_MEMORY. */
enum status sweep_falls_create(struct sweep_falls **falls, const struct plan *plan);
void sweep_falls_destroy(struct sweep_falls *falls);

/* Takes over what is known of a case. */
void sweep_falls_row(struct sweep_falls *falls, long number, const struct sweep_row *row);

/* Judges all rows and writes falls.csv into the folder. A value grows if it is above the
 * smallest one before it in its row by more than the plan's `by` at that case; a death
 * grows if a value stands before it. What has no value is not judged. STATUS_FILE,
 * STATUS_MEMORY. */
enum status sweep_falls_judge(struct sweep_falls *falls, const char *folder,
                              struct message *why);

/* The table and a sentence; nothing before it is judged. */
enum status sweep_falls_print(const struct sweep_falls *falls, FILE *file);

/* STATUS_FAILED with a sentence: the measure grows in some row. */
enum status sweep_falls_check(const struct sweep_falls *falls, struct message *why);

#endif

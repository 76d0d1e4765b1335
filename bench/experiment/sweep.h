/* sweep.h - what the cases of a sweep say: their table, and how many end how. */
#ifndef SWEEP_H
#define SWEEP_H

#include "bench/data/printer.h"
#include "bench/experiment/study.h"

/* Writes FOLDER/table.csv of the printer's folder, every key and measure to 17 digits,
 * verdict, labels and end: the same bits however it came about. STATUS_FILE. */
enum status sweep_save(const struct study_results *d, const struct printer *p,
                       struct message *why);

/* Prints the plan, and how many cases have which label and end. */
void sweep_print(const struct study_results *d, FILE *file);

#endif

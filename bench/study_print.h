/* study_print.h - a study's tables, CSV, plot, picture and verdicts. */
#ifndef STUDY_PRINT_H
#define STUDY_PRINT_H

#include "bench/study.h"

/* Two tables: cost of the levels; differences, error and metrics at every time, with
 * observed orders and the truth's source below. */
enum status study_print(const struct study *study, const struct study_result *r,
                        enum table_format format, FILE *file);

/* NAME.csv, a row for each level and time; NAME.gp and NAME.png, error (without truth: the
 * difference from the finest) against seconds; NAME_sheets.png with .gp and .dat
 * (picture.h), a row for each time, a column for each level and one for the truth. What is
 * missing because gnuplot is, is told on standard error. */
enum status study_print_files(const struct study *study, const struct study_result *r,
                              const char *folder, struct message *why);

/* All of it: study_read, study_print, study_print_files. *r is there for verdicts, and
 * freed by the receiver with study_result_clear. */
enum status study_print_all(const struct study *study, const char *folder,
                            enum table_format format, FILE *file, struct study_result *r,
                            struct message *why);

/* `- "QUOTE": holds. SENTENCE`, or `does not hold`; the sentence has the numbers. */
void study_print_verdict(FILE *file, const char *quote, bool holds, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

#endif

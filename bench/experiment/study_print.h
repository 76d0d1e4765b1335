/* study_print.h - a study's tables, CSV, plot, picture and verdicts. */
#ifndef STUDY_PRINT_H
#define STUDY_PRINT_H

#include <stddef.h>

#include "bench/experiment/study.h"

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

/* A number of every level at a time, for a verdict. */
struct study_trend {
    char text[160]; /* "2.1, 3.9, 5.6"                                                   */
    int sign;       /* 1: larger from each level to the next; -1: smaller; 0: neither    */
};

/* Of a member of study_frame: offsetof(struct study_frame, roughness). */
struct study_trend study_print_trend(const struct study *study,
                                     const struct study_result *r, int time, size_t member);

/* `- "QUOTE": holds. SENTENCE`, or `does not hold`; the sentence has the numbers. */
void study_print_verdict(FILE *file, const char *quote, bool holds, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

#endif

/* study_print.h - a study's tables, CSV, chart, picture and verdicts. */
#ifndef STUDY_PRINT_H
#define STUDY_PRINT_H

#include <stddef.h>

#include "bench/experiment/study.h"
#include "bench/ui/table.h"

/* Two tables: cost of the levels; differences, error and metrics at every time, with
 * observed orders and the truth's source below. */
enum status study_print(const struct study *s, enum table_format format, FILE *file);

/* NAME.csv, a row for each level and time; NAME.png, error (without truth: the difference
 * from the finest) against seconds; NAME_sheets.png (picture.h), a row for each time, a
 * column for each level and one for the truth. */
enum status study_print_files(const struct study *s, const char *folder,
                              struct message *why);

/* Both, of all studies. */
enum status study_print_all(const struct study_results *r, const char *folder,
                            enum table_format format, FILE *file, struct message *why);

/* The next cells of a row: a number for each digit, to so many significant ones. */
void study_print_numbers(struct table *t, const char *digits, const double *value);

/* A number of every level at a time, for a verdict. */
struct study_trend {
    char text[160]; /* "2.1, 3.9, 5.6"                                                   */
    int sign;       /* 1: larger from each level to the next; -1: smaller; 0: neither    */
};

/* Of a member of study_frame: offsetof(struct study_frame, roughness); at the last time. */
struct study_trend study_print_trend(const struct study *s, int time, size_t member);
struct study_trend study_print_last(const struct study *s, size_t member);

/* `- "QUOTE": holds. SENTENCE`, or `does not hold`; the sentence has the numbers. */
void study_print_verdict(FILE *file, const char *quote, bool holds, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

#endif

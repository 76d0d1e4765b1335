/* judge.h - judges sentences by numbers, in the same way in every study, and prints them. A
 * number that did not come (NaN, after a death) speaks neither for a sentence nor against.
 */
#ifndef JUDGE_H
#define JUDGE_H

#include <stdbool.h>
#include <stdio.h>

#include "bench/data/verdict.h"

struct dataset;

/* Returns the larger of two, NaN if either is. */
double judge_most(double a, double b);

/* Judges whether each of value[count] is larger than the one before that came (sign 1), or
 * smaller
 * (-1), by more than `bar`, the error of a difference: one that goes the other way settles
 * it, one within the bar leaves it open, as fewer than two values do. */
enum verdict judge_order(int count, const double *value, int sign, double bar);

/* Judges value < bound. */
enum verdict judge_below(double value, double bound);

/* Judges whether a ratio of two times agrees with that of another machine: on the same side
 * of 1, unless theirs lies in .9 to 1.1, and within a factor of 2. */
enum verdict judge_ratio(double ours, double paper);

/* Judges whether the exponent of a time over a size agrees so: within .25. */
enum verdict judge_exponent(double ours, double paper);

/* Joins two judgements, both of which must hold. */
enum verdict judge_both(enum verdict a, enum verdict b);

/* A statement that was judged. */
struct judge_told {
    const char *source; /* section of the paper; "": the statement is ours                */
    const char *quote;  /* what is stated                                                 */
    enum verdict turn;
    char *reading; /* of what the paper leaves open, and why; ""                          */
    char *here;    /* the numbers that decide it                                          */
    char *turns;   /* the readings that have another verdict, and their numbers; ""       */
    char *ours;    /* the numbers of what we would do instead; ""                         */
};

/* Makes a table for statements that were judged, and adds one to it: source, claim,
 * reading, verdict, sentence, turns, ours. NULL without memory, as dataset_create. */
struct dataset *judge_table(const char *caption);
void judge_add(struct dataset *rows, const struct judge_told *told);

/* Prints `- SOURCE: QUOTE: holds. HERE TURNS OURS Reading: READING`. */
void judge_print(FILE *file, const struct judge_told *told);

#endif

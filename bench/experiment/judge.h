/* judge.h - judges sentences by numbers, in the same way in every study, and prints them. A
 * number that did not come (NaN, after a death) speaks neither for a sentence nor against.
 */
#ifndef JUDGE_H
#define JUDGE_H

#include <stdbool.h>
#include <stdio.h>

struct table;

enum judge {
    JUDGE_FAILS,
    JUDGE_HOLDS,
    JUDGE_OPEN,  /* cannot be judged: a number is missing or within the error bars      */
    JUDGE_QUICK, /* a quick run simulates less than the sentence is about               */
};

/* Returns the larger of two, NaN if either is. */
double judge_most(double a, double b);

/* Judges whether each of value[count] is larger than the one before that came (sign 1), or
 * smaller
 * (-1), by more than `bar`, the error of a difference: one that goes the other way settles
 * it, one within the bar leaves it open, as fewer than two values do. */
enum judge judge_order(int count, const double *value, int sign, double bar);

/* Judges value < bound. */
enum judge judge_below(double value, double bound);

/* Judges whether ours is within a tenth of the paper's. */
enum judge judge_near(double ours, double paper);

/* Joins two judgements, both of which must hold. */
enum judge judge_both(enum judge a, enum judge b);

/* Returns the word for a judgement: holds, fails or open. */
const char *judge_words(enum judge turn, const char *holds, const char *fails,
                        const char *open);

/* Prints `- "QUOTE": holds. SENTENCE`, or `does not hold`, `cannot be judged`, `not judged:
 * quick`; the sentence has the numbers. */
void judge_print(FILE *file, const char *quote, enum judge turn, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Adds whatever is printed from now on to this table, too, a row of quote, verdict and
 * sentence; NULL: no more. */
void judge_keep(struct table *rows);

/* Mark a folder as that of a quick run, by FOLDER/quick.txt, and tell whether it is marked.
 * The mark is set before the first run of a quick job and removed after the last run of a
 * full one. */
void judge_mark(const char *folder, bool quick);
bool judge_marked(const char *folder);

#endif

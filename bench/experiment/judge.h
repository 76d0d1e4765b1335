/* judge.h - how a sentence turns: numbers in, a word out, the same way in every study. A
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

/* The larger of two, NaN if either is. */
double judge_most(double a, double b);

/* Each of value[count] > 1 is larger than the one before that came (sign 1), or smaller
 * (-1), by more than `bar`, the error of a difference: one that goes the other way settles
 * it, one within the bar leaves it open. */
enum judge judge_order(int count, const double *value, int sign, double bar);

/* value < bound. */
enum judge judge_below(double value, double bound);

/* Ours is within a tenth of the paper's. */
enum judge judge_near(double ours, double paper);

/* Both of two. */
enum judge judge_both(enum judge a, enum judge b);

/* One of three: if it holds, if it does not, and else. */
const char *judge_words(enum judge turn, const char *holds, const char *fails,
                        const char *open);

/* `- "QUOTE": holds. SENTENCE`; or `does not hold`, `cannot be judged`, `not judged:
 * quick`; the sentence has the numbers. */
void judge_print(FILE *file, const char *quote, enum judge turn, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* What it prints from now on becomes rows of this table, too: quote, verdict, sentence;
 * NULL: no more. */
void judge_keep(struct table *rows);

/* FOLDER/quick.txt says that what is there is of a quick run: set before the first run of a
 * quick one, taken away after the last of a full one. */
void judge_mark(const char *folder, bool quick);
bool judge_marked(const char *folder);

#endif

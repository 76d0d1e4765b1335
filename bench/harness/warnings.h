/* warnings.h - what a user should know of a run before its numbers are believed: where its
 * discretization is known to lock, is out of its range, or is limited by its step. One
 * table of rules; each names the source that measured or proved it. */
#ifndef WARNINGS_H
#define WARNINGS_H

#include <stdio.h>

#include "bench/harness/run.h"

enum { WARNINGS_NUMBERS = 2 };

struct warnings_rule {
    const char *name;
    const char *source; /* who measured or proved it                                 */

    /* Returns whether the rule applies to a run (as of run_read); then with the numbers of
     * its sentence. */
    bool (*holds)(const struct run *run, double number[WARNINGS_NUMBERS]);
    char sentence[320]; /* as of printf, for these numbers */

    /* Where it can be so grave that the result is wrong (distrust.h): returns whether it
     * is, for these numbers; and a clause that says so. NULL: never. */
    bool (*is_grave)(const struct run *run, const double number[WARNINGS_NUMBERS]);
    const char *grave;
};

/* name NULL ends. */
extern const struct warnings_rule warnings_rules[];

/* Returns the spans of a run's net along u (0) or v (1). */
int warnings_spans(const struct run *run, int along);

/* Prints the sentences of all rules that apply, each a line after `before`. */
void warnings_print(const struct run *run, const char *before, FILE *file);

#endif

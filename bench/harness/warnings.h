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
};

/* name NULL ends. */
extern const struct warnings_rule warnings_rules[];

/* Prints the sentences of all rules that apply, each a line after `before`. */
void warnings_print(const struct run *run, const char *before, FILE *file);

#endif

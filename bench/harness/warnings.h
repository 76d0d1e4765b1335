/* warnings.h - what should be known of a run before its numbers are believed: where its
 * discretization is known to lock, is out of its range, or is limited by its step.
 *
 * One table of rules; each measured or proven elsewhere, which its source tells.
 */
#ifndef WARNINGS_H
#define WARNINGS_H

#include <stdio.h>

#include "bench/harness/run.h"

struct warnings_rule {
    const char *name;
    const char *source; /* where it is known from                                      */

    /* Whether it holds of a run that was read (run_read); then with its sentence. */
    bool (*holds)(const struct run *run, struct message *sentence);
};

/* name NULL ends. */
extern const struct warnings_rule warnings_rules[];

/* The sentences of all that hold, each a line after `before`. */
void warnings_print(const struct run *run, const char *before, FILE *file);

#endif

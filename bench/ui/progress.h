/* progress.h - shows how far a long job is, with the time it still takes: one line on
 * standard error that is rewritten in place, or a line a minute where that is no terminal.
 */
#ifndef PROGRESS_H
#define PROGRESS_H

#include <stdbool.h>

struct progress {
    const char *label; /* borrowed                                                     */
    long total;
    double start, shown; /* [s]                                                        */
    bool on, terminal, drawn;
};

/* Starts a bar; `quiet`: nothing is shown. */
struct progress progress_start(const char *label, long total, bool quiet);

/* Shows `done` of total; draws at most ten times a second, without a terminal
 * once a minute. */
void progress_update(struct progress *p, long done);

/* Wipes the line. */
void progress_end(struct progress *p);

#endif

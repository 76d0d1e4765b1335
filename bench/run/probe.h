/* probe.h - material points followed through a motion, as CSV: t,u,v,w,x,y,z with 17
 * digits, one line a point and frame. */
#ifndef PROBE_H
#define PROBE_H

#include <stdio.h>

#include "bench/harness/run.h"
#include "bench/ui/table.h"

struct probe {
    int count;
    double *uvw, *xyz;   /* [count][3] owned */
    struct table *table; /* owned            */
};

/* Reads texts[count] "u,v,w", numbers in [0,1]. STATUS_INPUT with a sentence. */
enum status probe_init(struct probe *p, int count, const char *const *texts,
                       struct message *why);
void probe_clear(struct probe *p); /* all-zero is allowed */

/* Where the points are now, below the names of the columns the first time. STATUS_FILE with
 * a sentence if the file does not take it. */
enum status probe_print(struct probe *p, const struct run *run, double t, FILE *file,
                        struct message *why);

#endif

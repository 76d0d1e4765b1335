/* child.h - runs work in a process of its own, so that a crash, a hang or a kill ends
 * nothing else. The child works on one thread, leaves its results in files, and dies with
 * its parent. The parent does not touch HDF5 meanwhile. */
#ifndef CHILD_H
#define CHILD_H

#include <stdbool.h>
#include <sys/types.h>

#include "models/status.h"

enum child_outcome {
    CHILD_DONE,   /* the work came to STATUS_OK                                        */
    CHILD_FAILED, /* it did not, `why` says why                                        */
    CHILD_CUT,    /* it was cut short, `why` says by what: killed from outside, out of
                     memory; another time it may come to its end                       */
    CHILD_STUCK,  /* a file could not be written, `why` says why: no use going on      */
    CHILD_ASKED,  /* it was asked to end (SIGINT, SIGTERM, SIGHUP)                     */
};

struct child_end {
    enum child_outcome outcome;
    bool overdue;   /* failed: the limit of child_limit was over                       */
    double seconds; /* of processor time                                               */
    double reached; /* last value of child_reached; NaN: none                          */
    struct message why;
};

struct child {
    pid_t pid;               /* 0: none runs                                           */
    struct child_note *note; /* memory shared with the child                     owned */
};

enum status child_init(struct child *c);
void child_clear(struct child *c); /* kills what runs; all-zero is allowed */

/* Starts work(context) in a new process. STATUS_LIBRARY with a sentence: it cannot. */
enum status child_start(struct child *c, enum status (*work)(void *, struct message *),
                        void *context, struct message *why);

/* Records in the child how far the work is, in case it does not end; elsewhere nothing. */
void child_reached(double how_far);

/* Ends the child after so many seconds of processor time: CHILD_FAILED, overdue. Time in
 * which it is suspended, or in which the machine sleeps or does something else, does not
 * count. INFINITY: no limit. Called in the child; another call may lower it. */
void child_limit(double seconds);

/* Returns whether it has ended, and how. Does not wait. */
bool child_poll(struct child *c, struct child_end *end);

#endif

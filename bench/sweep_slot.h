/* sweep_slot.h - one case in a process of its own, so that whatever it does ends there.
 *
 * The child runs the case on one thread and leaves its file; it dies with its parent. The
 * parent does not touch HDF5 meanwhile.
 */
#ifndef SWEEP_SLOT_H
#define SWEEP_SLOT_H

#include <sys/types.h>

#include "bench/sweep_folder.h"

enum sweep_slot_outcome {
    SWEEP_SLOT_DONE,   /* its file is there                                            */
    SWEEP_SLOT_FAILED, /* it came to no result, `why` says why: a row                  */
    SWEEP_SLOT_STUCK,  /* its file could not be written, `why` says why: no use going on */
    SWEEP_SLOT_ASKED,  /* it was asked to end (SIGINT, SIGTERM, SIGHUP)                */
};

struct sweep_slot_end {
    long number;
    enum sweep_slot_outcome outcome;
    double seconds; /* of processor time                                               */
    struct message why;
};

struct sweep_slot {
    pid_t pid; /* 0: free                                                           */
    long number;
    double start; /* clock_now()                                                       */
    bool overdue;
    struct sweep_slot_note *note; /* memory shared with the child                owned */
};

enum status sweep_slot_init(struct sweep_slot *slot);
void sweep_slot_clear(struct sweep_slot *slot); /* kills what runs; all-zero is allowed */

/* Starts a case. STATUS_LIBRARY with a sentence: no process to be had. STATUS_INPUT: the
 * case's settings make no scene; then it goes to *why and nothing was started. */
enum status sweep_slot_start(struct sweep_slot *slot, const struct plan *plan,
                             const struct sweep_folder *folder, long number,
                             struct message *why);

/* Whether the case has ended, and how; kills it when its time is over. Does not wait. */
bool sweep_slot_poll(struct sweep_slot *slot, double time_limit,
                     struct sweep_slot_end *end);

#endif

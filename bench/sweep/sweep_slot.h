/* sweep_slot.h - one case of a sweep in a process of its own (child.h), which leaves its
 * file. */
#ifndef SWEEP_SLOT_H
#define SWEEP_SLOT_H

#include "bench/harness/child.h"
#include "bench/sweep/sweep_folder.h"

struct sweep_slot {
    struct child child; /* all-zero is allowed in child_clear                          */
    long number;
};

/* Starts a case. STATUS_LIBRARY with a sentence: no process to be had. STATUS_INPUT: the
 * case's settings make no scene; then it goes to *why and nothing was started. */
enum status sweep_slot_start(struct sweep_slot *slot, const struct plan *plan,
                             const struct sweep_folder *folder, long number,
                             struct message *why);

#endif

/* sweep_queue.h - hands out the cases of a sweep that are not done yet, to processes here
 * and to the ranks of mpirun, whoever is free first.
 *
 * Order and place do not reach the results: a case is a process of its own, on one thread.
 */
#ifndef SWEEP_QUEUE_H
#define SWEEP_QUEUE_H

#include "bench/sweep/ranks.h"
#include "bench/sweep/sweep_folder.h"

struct sweep_queue {
    const struct plan *plan;           /*                                     borrowed */
    const struct sweep_folder *folder; /*                                     borrowed */
    const struct ranks *ranks;         /* NULL: this process alone            borrowed */
    int jobs;                          /* cases at a time in this process              */
    const bool *done;                  /* [plan_case_count]                   borrowed */
    bool quiet;

    int hands;      /* cases at a time everywhere                                      */
    long ran;       /* cases that ended while the queue ran                            */
    double seconds; /* of processor time they took                                     */
    double wall;    /* [s] from first to last                                          */
    int stopped_by; /* the signal that asked to stop, 0: none                          */
};

/* Runs them all. On STATUS_FILE a result could not be written: what was running is given
 * up, with a sentence. STATUS_OK with stopped_by: the user stopped it. */
enum status sweep_queue_run(struct sweep_queue *queue, struct message *why);

/* What the other ranks do meanwhile, until rank 0 says that it is over: the plan is read
 * when the first case comes. */
enum status sweep_queue_serve(const struct ranks *ranks, const char *plan_path,
                              struct message *why);

/* Tells the other ranks that it is over. */
void sweep_queue_dismiss(const struct ranks *ranks);

#endif

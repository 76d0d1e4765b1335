/* pool.h - jobs, each in a process of its own (child.h), handed out to processes here and
 * to the ranks of mpirun, whoever is free first.
 *
 * Order and place do not reach the results: a job is alone in its process, on one thread.
 */
#ifndef POOL_H
#define POOL_H

#include "bench/harness/child.h"
#include "bench/harness/ranks.h"

struct pool {
    long count;                /* jobs 0, 1, ...                                       */
    const bool *done;          /* [count] needs no run; NULL: all do          borrowed */
    int slots;                 /* jobs at a time in this process                       */
    const struct ranks *ranks; /* NULL: this process alone                    borrowed */
    double time_limit;         /* of a job, processor time [s]; INFINITY: none         */
    bool quiet;                /* no progress bar                                      */

    void *context; /* of the calls                                            borrowed */
    /* Does a job in a process of its own; its results go to files. */
    enum status (*work)(void *context, long job, struct message *why);
    /* Called after a job's end, CHILD_DONE, CHILD_FAILED or CHILD_CUT. Anything but
     * STATUS_OK ends the pool. */
    enum status (*settle)(void *context, long job, const struct child_end *end,
                          struct message *why);

    int hands;      /* jobs at a time everywhere                                       */
    long ran;       /* jobs that ended while the pool ran                              */
    double seconds; /* of processor time they took                                     */
    double wall;    /* [s] from first to last                                          */
    int stopped_by; /* the signal that asked to stop, 0: none                          */
};

/* Runs all jobs. STATUS_FILE, with a sentence: a result could not be written, and the jobs
 * that were running are given up. STATUS_OK with stopped_by: the user stopped it. */
enum status pool_run(struct pool *pool, struct message *why);

/* Ends the program as the signal that stopped the pool would have, with a sentence. */
void pool_raise(const struct pool *pool);

/* Serves rank 0 on the other ranks until it says that it is over: does `work` of the jobs
 * that come, or answers with the trouble because of which it can do none (NULL: it can). */
enum status pool_serve(struct pool *pool, const char *trouble, struct message *why);

/* Tells the other ranks that it is over. */
void pool_dismiss(const struct ranks *ranks);

#endif

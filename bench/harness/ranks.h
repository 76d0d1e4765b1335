/* ranks.h - messages between the processes that mpirun starts. Only they load the MPI
 * library: nothing else of the program needs it or waits for it.
 * bench/harness/mpi/ranks_mpi.c is built into clothbench_mpi.so, beside the program, where
 * CMake finds Open MPI. */
#ifndef RANKS_H
#define RANKS_H

#include <stdbool.h>

#include "bench/harness/child.h"

/* A message is sent as bytes: all machines are of one kind. */
struct ranks_message {
    int kind; /* pool.c says which there are                                           */
    long job;
    struct child_end end; /* of the job, if it has ended                               */
};

struct ranks {
    int rank, size;
    void (*send)(int to, const struct ranks_message *message);
    /* Receives the next message, if there is one; does not wait. */
    bool (*receive)(int *from, struct ranks_message *message);
    void (*finish)(void); /* last; all ranks */
};

/* Finds the ranks that mpirun started, this one among them; NULL without mpirun.
 * STATUS_UNSUPPORTED with a sentence: the program was built without MPI. Static storage. */
enum status ranks_start(const struct ranks **ranks, struct message *why);

/* Joins the ranks; exported by clothbench_mpi.so. NULL: MPI does not start. */
const struct ranks *ranks_mpi_start(void);

#endif

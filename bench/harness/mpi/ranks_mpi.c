/* ranks_mpi.c - messages by MPI. A library of its own, loaded by bench/harness/ranks.c. */
#include "bench/harness/ranks.h"

#include <mpi.h>
#include <stdlib.h>

static void send(int to, const struct ranks_message *message)
{
    MPI_Send(message, sizeof *message, MPI_BYTE, to, 0, MPI_COMM_WORLD);
}

static bool receive(int *from, struct ranks_message *message)
{
    int there = 0;
    MPI_Status status;

    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &there, &status);
    if (!there)
        return false;
    *from = status.MPI_SOURCE;
    MPI_Recv(message, sizeof *message, MPI_BYTE, *from, 0, MPI_COMM_WORLD, &status);
    return true;
}

static void finish(void)
{
    MPI_Finalize();
}

const struct ranks *ranks_mpi_start(void)
{
    static struct ranks ranks = {.send = send, .receive = receive, .finish = finish};

    /* children of a rank never call MPI, so a fork is harmless */
    setenv("OMPI_MCA_mpi_warn_on_fork", "0", 0);
    if (MPI_Init(NULL, NULL) != MPI_SUCCESS)
        return NULL;
    MPI_Comm_rank(MPI_COMM_WORLD, &ranks.rank);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks.size);
    return &ranks;
}

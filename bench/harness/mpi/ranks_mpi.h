/* ranks_mpi.h - what clothbench_mpi.so exports. */
#ifndef RANKS_MPI_H
#define RANKS_MPI_H

#include "bench/harness/ranks.h"

/* Joins the ranks; NULL: MPI does not start. Static storage. */
const struct ranks *ranks_mpi_start(void);

#endif

#include "bench/harness/ranks.h"

#include <dlfcn.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Returns whether mpirun's environment variables are set: Open MPI's, others'. */
static bool started_by_mpirun(void)
{
    return getenv("OMPI_COMM_WORLD_SIZE") || getenv("PMIX_RANK") || getenv("PMI_SIZE");
}

/* Loads the library from the program's folder, as built, or from where it is installed. */
static void *open_library(void)
{
    static const char *const places[] = {"", RANKS_FROM_PROGRAM "/"};
    char program[PATH_MAX / 2] = "", path[PATH_MAX];
    void *library = NULL;

    if (readlink("/proc/self/exe", program, sizeof program - 1) < 0)
        return NULL;
    program[strrchr(program, '/') ? strrchr(program, '/') - program : 0] = '\0';
    for (int n = 0; n < 2 && !library; n++) {
        snprintf(path, sizeof path, "%s/%sclothbench_mpi.so", program, places[n]);
        if (access(path, F_OK) == 0)
            library = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
    }
    return library;
}

enum status ranks_start(const struct ranks **ranks, struct message *why)
{
    const struct ranks *(*start)(void);
    void *library;

    *ranks = NULL;
    if (!started_by_mpirun())
        return STATUS_OK;
    library = open_library();
    if (!library)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "started by mpirun, but this program was built without MPI "
                           "(Debian: openmpi-bin, libopenmpi-dev), or clothbench_mpi.so is "
                           "not beside it");
    *(void **)&start = dlsym(library, "ranks_mpi_start");
    *ranks = start ? start() : NULL;
    return *ranks ? STATUS_OK : status_fail(why, STATUS_LIBRARY, "MPI does not start");
}

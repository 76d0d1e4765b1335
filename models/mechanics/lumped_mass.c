#include "models/mechanics/lumped_mass.h"

#include <stdlib.h>

#include "models/mechanics/march.h"

enum status lumped_mass_make(const struct discretization *d, const struct blocks *graph,
                             double *M, struct message *why)
{
    enum status st = STATUS_OK;
    double *sum = NULL;

    if (!march_explicit(d))
        return STATUS_OK;
    sum = calloc((size_t)graph->nodes + 1, sizeof *sum);
    if (!sum)
        return STATUS_MEMORY;
    for (int a = 0; a < graph->nodes; a++)
        for (long n = graph->start[a]; n < graph->start[a + 1]; n++) {
            sum[a] += M[n];
            if (n > graph->start[a])
                sum[graph->node[n]] += M[n];
            M[n] = 0;
        }
    for (int a = 0; a < graph->nodes; a++) {
        if (!(sum[a] > 0))
            TRY(status_fail(why, STATUS_UNSUPPORTED,
                            "integrator=leapfrog: the mass's row of node %d sums to %g kg, "
                            "and an explicit step needs masses > 0; use "
                            "integrator=implicit",
                            a, sum[a]));
        M[graph->start[a]] = sum[a];
    }
out:
    free(sum);
    return st;
}

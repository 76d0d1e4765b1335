/* discretization.c - ownership of discretizations. */
#include "models/discretization.h"

#include <stdlib.h>
#include <string.h>

void discretization_clear(struct discretization *d)
{
    for (int i = 0; i < 3; i++)
        free(d->knots[i]);
    free(d->weights);
    free(d->mesh);
    memset(d, 0, sizeof *d);
}

/* Copies values[count]; NULL stays NULL. */
static enum status copy_array(const double *values, int count, double **copy)
{
    *copy = NULL;
    if (!values)
        return STATUS_OK;
    *copy = malloc((size_t)count * sizeof **copy);
    if (!*copy)
        return STATUS_MEMORY;
    memcpy(*copy, values, (size_t)count * sizeof **copy);
    return STATUS_OK;
}

enum status discretization_copy(const struct discretization *from,
                                struct discretization *to)
{
    enum status st = STATUS_OK;
    struct discretization copy = *from;

    copy.weights = NULL, copy.mesh = NULL;
    memset(copy.knots, 0, sizeof copy.knots);
    for (int i = 0; i < 3; i++)
        TRY(copy_array(from->knots[i], from->knot_count[i], &copy.knots[i]));
    TRY(copy_array(from->weights, from->weight_count, &copy.weights));
    if (from->mesh && !(copy.mesh = strdup(from->mesh)))
        TRY(STATUS_MEMORY);
out:
    if (st != STATUS_OK)
        discretization_clear(&copy);
    *to = copy;
    return st;
}

#include "models/solid/solid_space.h"

#include <stdlib.h>
#include <string.h>

void solid_space_clear(struct solid_space *space)
{
    if (!space)
        return;
    free(space->ien);
    free(space->slab);
    free(space->uvw);
    free(space->rest);
    free(space->parity);
    memset(space, 0, sizeof *space);
}

enum status solid_space_set_slabs(struct solid_space *space, int per_column, int width)
{
    int columns = space->elements / per_column, wide = width > 0 ? width : 1;

    space->slabs = (columns + wide - 1) / wide;
    space->slab = malloc(((size_t)space->slabs + 1) * sizeof *space->slab);
    if (!space->slab)
        return STATUS_MEMORY;
    for (int s = 0; s < space->slabs; s++)
        space->slab[s] = s * wide * per_column;
    space->slab[space->slabs] = space->elements;
    return STATUS_OK;
}

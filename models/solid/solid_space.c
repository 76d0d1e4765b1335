#include "models/solid/solid_space.h"

#include <stdlib.h>
#include <string.h>

#include "models/linalg/blocks.h"

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
    return blocks_slabs(space->elements, per_column, width > 0 ? width : 1, &space->slabs,
                        &space->slab);
}

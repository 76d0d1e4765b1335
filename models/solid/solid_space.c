#include "models/solid/solid_space.h"

#include <stdlib.h>
#include <string.h>

#include "models/linalg/blocks.h"
#include "models/room.h"

void solid_space_clear(struct solid_space *space)
{
    free(space->room);
    free(space->slab);
    free(space->parity);
    free(space->hinge.room);
    memset(space, 0, sizeof *space);
}

enum status solid_space_allocate(struct solid_space *space, int per_column, int width)
{
    enum status st;

    TRY(room_cut(&space->room, ROOM(space->ien, space->elements * (size_t)space->local),
                 ROOM(space->uvw, space->nodes),
                 ROOM(space->rest, 3 * (size_t)space->nodes)));
    TRY(blocks_slabs(space->elements, per_column, width > 0 ? width : 1, &space->slabs,
                     &space->slab));
out:
    return st;
}

void solid_space_spread(struct solid_space *space, const struct scene *scene)
{
    for (int n = 0; scene->sheets > 1 && n < space->nodes; n++)
        space->uvw[n][0] =
            scene_sheet_u(scene, n / (space->nodes / scene->sheets), space->uvw[n][0]);
}

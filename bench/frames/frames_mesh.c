#include "bench/frames/frames_parts.h"

#include <stdlib.h>
#include <string.h>

void frames_mesh_clear(struct frames_mesh *mesh)
{
    free(mesh->xyz);
    free(mesh->uv);
    free(mesh->triangle);
    *mesh = (struct frames_mesh){0};
}

enum status frames_mesh_face(struct frames_mesh *mesh, int count, const long *vertex)
{
    for (int n = 0; n < count; n++)
        mesh->corner =
            (mesh->corner ^ (unsigned long long)(vertex[n] + 1)) * 0x100000001b3ULL;
    for (int n = 2; n < count; n++) {
        int(*more)[3] = frames_bytes_grow(mesh->triangle, &mesh->triangle_room,
                                          mesh->triangles, sizeof *more);
        if (!more)
            return STATUS_MEMORY;
        mesh->triangle = more;
        int *corner = more[mesh->triangles++];
        corner[0] = (int)vertex[0];
        corner[1] = (int)vertex[n - 1];
        corner[2] = (int)vertex[n];
    }
    return STATUS_OK;
}

enum status frames_mesh_read(const char *path, struct frames_mesh *mesh,
                             struct message *why)
{
    struct frames_bytes bytes = {0};
    const size_t length = strlen(path);
    enum status st;

    *mesh = (struct frames_mesh){.corner = 0xcbf29ce484222325ULL};
    TRY(frames_bytes_open(path, &bytes, why));
    if (length > 4 && !strcmp(path + length - 4, ".ply"))
        TRY(frames_mesh_ply(&bytes, mesh, why));
    else if (length > 4 && !strcmp(path + length - 4, ".obj"))
        TRY(frames_mesh_obj(&bytes, mesh, why));
    else
        TRY(status_fail(why, STATUS_INPUT, "%s: is no mesh; an .obj or .ply would be right",
                        path));
    if (!mesh->vertices)
        TRY(status_fail(why, STATUS_INPUT, "%s: has no vertices", path));
out:
    frames_bytes_close(&bytes);
    if (st != STATUS_OK)
        frames_mesh_clear(mesh);
    return st;
}

/* Takes the points, uv and triangles of an OBJ file. */
#include "bench/frames/frames_reader.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/reader/obj_file.h"

/* Takes uv of each vertex from the vt that faces give it, and refuses a seam, which gives
 * one vertex two. */
static enum status take_uv(const struct obj_file *o, const char *path,
                           struct frames_mesh *m, struct message *why)
{
    for (int n = 0; n < o->corners; n++)
        for (int i = 0; o->corner[n].vt >= 0 && i < 2; i++) {
            double *uv = &m->uv[2 * o->corner[n].v + i];
            const double vt = o->texture[o->corner[n].vt][i];
            if (!isnan(*uv) && fabs(*uv - vt) > 1e-6)
                return status_fail(why, STATUS_INPUT,
                                   "%s:%d: gives a vertex a second vt; one material point "
                                   "a vertex, without seams, would be right",
                                   path, o->corner[n].line);
            *uv = vt;
        }
    return STATUS_OK;
}

/* Takes the vt of each corner, if the file has any. */
static enum status take_corners(const struct obj_file *o, const char *path,
                                struct frames_mesh *m, struct message *why)
{
    if (!m->triangles || !o->textures)
        return STATUS_OK;
    m->corner = arena_take(m->arena, (size_t)m->triangles, sizeof *m->corner);
    for (int n = 0; n < o->corners; n++) {
        if (o->corner[n].vt < 0)
            return status_fail(why, STATUS_INPUT,
                               "%s:%d: gives a corner no vt; one for each would be right",
                               path, o->corner[n].line);
        memcpy(m->corner[n / 3][n % 3], o->texture[o->corner[n].vt],
               sizeof m->corner[n / 3][n % 3]);
    }
    return STATUS_OK;
}

enum status frames_mesh_obj(const char *path, struct frames_mesh *mesh, struct message *why)
{
    struct obj_file o SCOPED(obj_file_clear) = {0};

    CALL(obj_file_read(path, &o, why));
    mesh->vertices = o.vertices;
    mesh->triangles = o.corners / 3;
    mesh->xyz = arena_take(mesh->arena, (size_t)o.vertices, 3 * sizeof *mesh->xyz);
    mesh->uv = arena_take(mesh->arena, (size_t)o.vertices, 2 * sizeof *mesh->uv);
    if (mesh->triangles) /* else there is no list, as without faces of other formats */
        mesh->triangle =
            arena_take(mesh->arena, (size_t)mesh->triangles, sizeof *mesh->triangle);
    /* Texture points that no face pairs with vertices belong to them in order. */
    const bool paired = o.corners || o.textures != o.vertices;
    for (int n = 0; n < o.vertices; n++) {
        memcpy(mesh->xyz + 3 * n, o.vertex[n].at, sizeof o.vertex[n].at);
        for (int i = 0; i < 2; i++)
            mesh->uv[2 * n + i] = paired ? NAN : o.texture[n][i];
    }
    if (mesh->seams)
        CALL(take_corners(&o, path, mesh, why));
    if (mesh->corner)
        mesh->uv = NULL;
    else
        CALL(take_uv(&o, path, mesh, why));
    for (int n = 0; n < o.corners; n++)
        mesh->triangle[n / 3][n % 3] = o.corner[n].v;
    for (int n = 0; mesh->uv && n < 2 * o.vertices; n++)
        if (isnan(mesh->uv[n])) /* a vertex of no face */
            mesh->uv = NULL;
    return STATUS_OK;
}

#include "models/mesh/mesh.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/order.h"
#include "models/mechanics/dead_load.h"
#include "models/room.h"

int mesh_beside(const struct mesh *mesh, int i, int j, int di, int dj)
{
    const int row = i % mesh->rows + di, place = j + dj;

    return row < 0 || place < 0 || row >= mesh->rows || place >= mesh->points[1]
               ? -1
               : (i + di) * mesh->points[1] + place;
}

bool mesh_on_rim(const struct mesh *mesh, int i, int j, int along)
{
    const int at = along ? i % mesh->rows : j;

    return at == 0 || at == (along ? mesh->rows : mesh->points[1]) - 1;
}

bool mesh_bends(const struct mesh *mesh)
{
    bool bends = mesh->rows > 2 || mesh->points[1] > 2;

    for (int a = 0; a < mesh->nodes; a++)
        bends |= mesh->clamped[a];
    return bends;
}

static void set_nodes(struct mesh *mesh, const struct scene *scene)
{
    const int n = mesh->rows, m = mesh->points[1];

    for (int a = 0; a < mesh->nodes; a++) {
        const int i = a / m, j = a % m;
        const double share =
            (mesh_on_rim(mesh, i, j, 1) ? 0.5 : 1) * (mesh_on_rim(mesh, i, j, 0) ? 0.5 : 1);
        mesh->uvw[a][0] = scene_sheet_u(scene, i / n, (double)(i % n) / (n - 1));
        mesh->uvw[a][1] = (double)j / (m - 1);
        mesh->uvw[a][2] = 0.5;
        scene_rest_point(scene, mesh->uvw[a], mesh->rest + 3 * (size_t)a);
        mesh->area[a] = share * mesh->cell[0] * mesh->cell[1];
    }
}

/* Marks nodes of columns that are held whole, and in all components, by one support or by
 * several, no grippers. */
void mesh_clamp(struct mesh *mesh, const struct scene *scene)
{
    for (int a = 0; a < mesh->vertices; a++) {
        int fixed = 0;
        for (const struct scene_support *s = scene->supports;
             s < scene->supports + scene->support_count; s++)
            if (s->lo[2] <= 0 && s->hi[2] >= 1 && !scene_grips(s) &&
                supports_covers(s, mesh->uvw[a]))
                fixed |= s->fix;
        mesh->clamped[a] = fixed == FIX_XYZ;
    }
}

void mesh_clear(struct mesh *mesh)
{
    mesh_flat_clear(&mesh->flat);
    free(mesh->edge);
    free(mesh->side);
    free(mesh->ring_at);
    free(mesh->bin_at);
    free(mesh->lists);
    free(mesh->room);
    memset(mesh, 0, sizeof *mesh);
}

enum status mesh_init(struct mesh *mesh, const struct scene *scene, const int points[2])
{
    const int sheets = scene_sheets(scene), nodes = sheets * points[0] * points[1];
    struct mesh new = {
        .nodes = nodes,
        .vertices = nodes,
        .points = {sheets * points[0], points[1]},
        .rows = points[0],
        .cell = {scene->length / (points[0] - 1), scene->width / (points[1] - 1)}};
    enum status st;

    assert(points[0] >= 2 && points[1] >= 2);
    TRY(room_cut(&new.room, ROOM(new.uvw, nodes), ROOM(new.rest, 3 * nodes),
                 ROOM(new.area, nodes), ROOM(new.clamped, nodes)));
    set_nodes(&new, scene);
    mesh_clamp(&new, scene);
    HAND_OVER(mesh, new);
out:
    mesh_clear(&new);
    return st;
}

enum status mesh_loads(const struct mesh *mesh, const struct scene *scene, double **dead)
{
    const struct dead_load_line line[3] = {
        {.n = mesh->rows, .degree = 1}, {.n = mesh->points[1], .degree = 1}, {.n = 1}};

    *dead = NULL;
    if (!scene->load_count)
        return STATUS_OK;
    *dead = calloc(3 * (size_t)mesh->nodes, sizeof **dead);
    if (!*dead)
        return STATUS_MEMORY;
    return mesh->rows ? dead_load_add(scene, line, *dead)
                      : mesh_add_loads(mesh, scene, *dead);
}

enum status mesh_contact(const struct mesh *mesh, const struct scene *scene,
                         struct contact_surface *surface)
{
    if (mesh->rows)
        return contact_surface_init_net(surface, scene, mesh->points);
    return contact_surface_init_mesh(
        surface, mesh->nodes, mesh->vertices,
        &(struct mesh_cells){.count = mesh->flat.triangles,
                             .corner = (const int(*)[3])mesh->flat.triangle,
                             .side = (const int(*)[3])mesh->side,
                             .edge = mesh->edge,
                             .ring_at = mesh->ring_at,
                             .ring = mesh->ring,
                             .at = (const double(*)[2])mesh->flat.at,
                             .start = (const double(*)[3])mesh->flat.start,
                             .area = mesh->area},
        mesh->scale);
}

enum status mesh_order(const struct mesh *mesh, int **order)
{
    return mesh->flat.triangles ? mesh_order_plane(mesh, order)
                                : order_wide(mesh->points[0], mesh->points[1], 1, order);
}

#include "models/mesh/mesh_irregular.h"

#include <math.h>
#include <stdlib.h>

/* The most that a point moves, in cells, and the parts in which it does: in each triangles
 * stay such that turning edges makes them Delaunay's again. */
static const double MOST = 0.3;
enum { PARTS = 24 };

/* Tells whether a coordinate of a node is fixed, since it is that of a support's edge. */
static bool is_edge(const struct scene *scene, const double uv[2], int along)
{
    const double near = 1e-9;

    for (const struct scene_support *s = scene->supports;
         s < scene->supports + scene->support_count; s++)
        if ((fabs(uv[along] - s->lo[along]) < near ||
             fabs(uv[along] - s->hi[along]) < near) &&
            uv[1 - along] > s->lo[1 - along] - near &&
            uv[1 - along] < s->hi[1 - along] + near)
            return true;
    return uv[along] < near || uv[along] > 1 - near;
}

static void move(struct mesh_flat *flat, const double (*way)[2], double part)
{
    for (int a = 0; a < flat->nodes; a++)
        for (int i = 0; i < 2; i++)
            flat->at[a][i] += part * way[a][i];
}

enum status mesh_irregular(struct mesh_flat *flat, const struct scene *scene,
                           const int points[2], int seed)
{
    const double size[2] = {scene->length, scene->width};
    const double cell[2] = {size[0] / (points[0] - 1), size[1] / (points[1] - 1)};
    const double area = cell[0] * cell[1], sliver = 0.02;
    double(*way)[2] = malloc((size_t)flat->nodes * sizeof *way);
    struct mesh_edge *edge = NULL;
    int edges, (*side)[3] = NULL;
    uint64_t state = (uint64_t)seed;
    enum status st = STATUS_MEMORY;

    if (!way)
        goto out;
    TRY(mesh_flat_edges(flat, &edge, &edges, &side));
    for (int a = 0; a < flat->nodes; a++)
        for (int i = 0; i < 2; i++) {
            const double uv[2] = {flat->at[a][0] / size[0], flat->at[a][1] / size[1]};
            const double by = mesh_flat_random(&state);
            way[a][i] = is_edge(scene, uv, i) ? 0 : MOST * cell[i] * by / PARTS;
        }
    for (int n = 0; n < PARTS; n++) {
        move(flat, (const double(*)[2])way, 1);
        if (!mesh_flat_good(flat, sliver * area)) { /* never seen; what is there will do */
            move(flat, (const double(*)[2])way, -1);
            break;
        }
        mesh_flat_improve(flat, edge, edges, side, area * area);
    }
out:
    free(way);
    free(edge);
    free(side);
    return st;
}

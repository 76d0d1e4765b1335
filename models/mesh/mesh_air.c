#include "models/mesh/mesh_air.h"

#include <string.h>

/* Fills in the functions of an element whose corner c is between the corners u[c][2], from
 * and to along u, and v[c][2]. */
static void fill_corners(struct air *air, int element, double weight, const int (*u)[2],
                         const int (*v)[2])
{
    const size_t local = (size_t)air->local;
    double *N = air->shape + 3 * (size_t)element * local * local;

    for (int c = 0; c < air->local; c++, N += 3 * local) {
        N[c] = weight;
        N[local + (size_t)u[c][0]]--, N[local + (size_t)u[c][1]]++;
        N[2 * local + (size_t)v[c][0]]--, N[2 * local + (size_t)v[c][1]]++;
    }
}

static enum status make_triangles(const struct mesh *mesh, const struct scene *scene,
                                  struct air *air)
{
    static const int u[3][2] = {{0, 1}, {0, 1}, {0, 1}}, v[3][2] = {{0, 2}, {0, 2}, {0, 2}};
    const double sixth = 1.0 / 6; /* a third of half a parallelogram */
    const int count = mesh->flat.triangles;
    const enum status st = air_init(air, scene, count, 3, 3);

    for (int n = 0; air->node && n < count; n++) {
        memcpy(air->node + 3 * n, mesh->flat.triangle[n], 3 * sizeof *air->node);
        fill_corners(air, n, sixth, u, v);
    }
    return st;
}

/* Corner 2 i + j of a cell is i rows and j places on. */
static enum status make_cells(const struct mesh *mesh, const struct scene *scene,
                              struct air *air)
{
    static const int u[4][2] = {{0, 2}, {1, 3}, {0, 2}, {1, 3}},
                     v[4][2] = {{0, 1}, {0, 1}, {2, 3}, {2, 3}};
    const int m = mesh->points[1], sheets = mesh->points[0] / mesh->rows,
              cells = sheets * (mesh->rows - 1) * (m - 1);
    const enum status st = air_init(air, scene, cells, 4, 4);
    int n = 0;

    for (int i = 0; air->node && i < mesh->points[0]; i++)
        for (int j = 0; (i + 1) % mesh->rows && j < m - 1; j++, n++) {
            for (int c = 0; c < 4; c++)
                air->node[4 * n + c] = (i + c / 2) * m + j + c % 2;
            fill_corners(air, n, 0.25, u, v);
        }
    return st;
}

enum status mesh_air(const struct mesh *mesh, const struct scene *scene, struct air *air)
{
    return mesh->flat.triangles ? make_triangles(mesh, scene, air)
                                : make_cells(mesh, scene, air);
}

/* mesh_surface_fixture.h - surfaces of contact on meshes: a grid's points, with the same
 * numbers, as a mesh, and meshes of outlines. */
#ifndef MESH_SURFACE_FIXTURE_H
#define MESH_SURFACE_FIXTURE_H

#include "models/mesh/mesh.h"
#include "models/pattern.h"
#include "tests/check.h"

/* Makes the mesh of a scene that has a pattern, and its surface, which borrows from it. */
static inline void surface_of_pattern(struct scene *scene, const int points[2], int seed,
                                      struct mesh *mesh, struct contact_surface *surface)
{
    struct discretization d = {.points = {points[0], points[1], 1}, .seed = seed};
    struct pattern_blame blame;
    double size[2];

    REQUIRE(pattern_finish(scene->pattern, size, &blame) == STATUS_OK);
    scene->length = size[0], scene->width = size[1];
    REQUIRE(mesh_make(mesh, scene, &d, MESH_NO_NODES, NULL) == STATUS_OK);
    REQUIRE(mesh_contact(mesh, scene, surface) == STATUS_OK);
}

/* Makes the mesh of a grid of n[0] x n[1] points on the scene's sheet, cut by
 * the same diagonals. */
static inline void surface_of_grid(struct scene *scene, const int n[2], struct mesh *mesh,
                                   struct contact_surface *surface)
{
    struct mesh_flat flat;
    int triangle;

    REQUIRE(mesh_flat_grid(&flat, (double[2]){scene->length, scene->width}, n, false) ==
            STATUS_OK);
    scene->pattern = pattern_make();
    REQUIRE(scene->pattern &&
            pattern_add_mesh(scene->pattern, &flat, &triangle) == STATUS_OK);
    surface_of_pattern(scene, n, 0, mesh, surface);
}

/* Makes the mesh of lines of points, each ended by an INFINITY, the last by two. */
static inline void surface_of_lines(struct scene *scene, const double *number,
                                    const int points[2], int seed, struct mesh *mesh,
                                    struct contact_surface *surface)
{
    double at[64][2];

    scene->pattern = pattern_make();
    REQUIRE(scene->pattern);
    for (; isfinite(*number); number++) {
        int count = 0;
        for (; isfinite(*number); number += 2, count++)
            at[count][0] = number[0], at[count][1] = number[1];
        REQUIRE(!pattern_add_line(scene->pattern, count, (const double(*)[2])at));
    }
    surface_of_pattern(scene, points, seed, mesh, surface);
}

#endif

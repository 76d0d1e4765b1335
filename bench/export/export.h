/* export.h - a scene's sheets as nets of vertices on their mid-surfaces.
 *
 * Vertex j n + i of n x m is at (u,v) = (i/(n-1), j/(m-1)): u fastest. Several sheets stand
 * in one row, n vertices each, and no cell connects two: vertex j K n + k n + i is the
 * point (s,v) = (i/(n-1), j/(m-1)) of sheet k, and its u is the scene's. Files of vertices
 * count from 0, OBJ from 1. Of a mesh of triangles they are its points.
 */
#ifndef EXPORT_H
#define EXPORT_H

#include "bench/data/printer.h"
#include "models/mesh/mesh.h"
#include "models/scene.h"

/* The most points a direction: a quarter of a million vertices and a million springs. */
enum { EXPORT_SHEET_MOST = 500 };

struct export_sheet {
    const struct scene *scene; /*                                             borrowed */
    int points[2];             /* n, m of each sheet; >= 2                             */
    const struct mesh *mesh;   /* somebody's triangles in place of these; or NULL      */
    double (*outside)[2];      /* [m] of its vertices outside, along u and v           */
    double (*mirrored)[3];     /* [m] where they start, of a sheet that starts in space */
};

/* Makes a table of the numbers of a net of points: equal ones share a row with their count;
 * owned by the caller. */
struct dataset *export_numbers_table(const struct export_sheet *s);

#endif

/* export_sheet.h - a scene's sheets as nets of vertices on their mid-surfaces.
 *
 * Vertex j n + i of n x m is at (u,v) = (i/(n-1), j/(m-1)): u fastest. Several sheets stand
 * in one row, n vertices each, and no cell connects two: vertex j K n + k n + i is the
 * point (s,v) = (i/(n-1), j/(m-1)) of sheet k, and its u is the scene's. Files of vertices
 * count from 0, OBJ from 1.
 */
#ifndef EXPORT_SHEET_H
#define EXPORT_SHEET_H

#include "models/scene.h"

/* The most points a direction: a quarter of a million vertices and a million springs. */
enum { EXPORT_SHEET_MOST = 500 };

struct export_sheet {
    const struct scene *scene; /*                                             borrowed */
    int points[2];             /* n, m of each sheet; >= 2                             */
};

/* Returns the vertices in a row, K n. */
int export_sheet_columns(const struct export_sheet *s);

int export_sheet_vertices(const struct export_sheet *s);

/* Returns the place i of column n of the row. Places have room for one more before and
 * behind each sheet: from -1 on, n + 2 a sheet. */
int export_sheet_place(const struct export_sheet *s, int column);

/* Tells whether the place i, j is in a net, and not outside of its edges. */
bool export_sheet_has(const struct export_sheet *s, int i, int j);

/* Returns parameters (u,v,1/2) of the place i, j, and its rest position [m]. */
void export_sheet_point(const struct export_sheet *s, int i, int j, double uvw[3],
                        double xyz[3]);

/* Returns the same of a vertex of the net. */
void export_sheet_vertex(const struct export_sheet *s, int vertex, double uvw[3],
                         double xyz[3]);

/* Returns the part of the sheet that belongs to a vertex: half a cell to each side [m^2].
 * It is exact on flat sheets and cones; all add up to the sheet. */
double export_sheet_area(const struct export_sheet *s, int vertex);

/* Returns the words x, y, z of FIX_X... bits, in this order, for printing. */
const char *export_sheet_axes(unsigned fix);

#endif

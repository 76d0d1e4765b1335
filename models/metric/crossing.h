/* crossing.h - tells how deep a sheet passes through itself, and touching from passing
 * through.
 *
 * Pairs of triangles that meet (intersection.h) and have triangles in common form a
 * crossing. The edges that pass through a triangle cut the sheet into parts. The depth of a
 * part is the largest distance of one of its vertices from the triangles that have no
 * vertex in it: how far it has come through the rest. The depth of a crossing is the
 * smallest among the parts that it bounds, without the largest part of the sheet: the least
 * way back. Where it cuts nothing off, as two edges that are slit into each other, it is a
 * lower bound: the largest distance by which both ends of an edge lie beyond the triangle
 * that it passes through. A crossing with no edge beyond by more than a tolerance only
 * touches: a closed tube along its seam, or a sheet that lies on itself without a gap.
 *
 * Source of the parts: Baraff, Witkin, Kass, Untangling cloth, ACM Trans. Graph. 22 (2003).
 */
#ifndef CROSSING_H
#define CROSSING_H

#include "models/metric/intersection.h"

/* The tolerance for positions of a sheet of about a metre: what files with six digits or
 * 32-bit floats round away [m]. */
#define CROSSING_TOLERANCE 1e-6

/* The most pairs a triangle that are worth a count (intersection.h): a sheet that lies on
 * itself twice has five. */
enum { CROSSING_PAIRS_MOST = 8 };

struct crossing {
    long pairs;    /* pairs of triangles in crossings that do not only touch           */
    int triangles; /* triangles in these pairs                                         */
    double depth;  /* depth of the deepest crossing                               [m]   */
};

/* Measures the crossings after a count with keep_pairs; tolerance [m] > 0, above
 * what positions are rounded to. STATUS_MEMORY. */
enum status crossing_measure(const struct intersection *s, double tolerance,
                             struct crossing *crossing);

#endif

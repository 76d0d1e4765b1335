/* triangle.h - decides exactly whether two triangles in space have points in common.
 *
 * A triangle is the convex hull of its three corners, border included; three corners on a
 * line make it a segment, three equal ones a point, and they are decided as such. Touching
 * in a single point is having it in common. Corners are const double[3], with the sizes
 * that predicate.h asks for. Pure: safe to call from any thread.
 *
 * Two triangles of a mesh that share corners always have those in common. They are asked
 * for more: a point outside the hull of the shared corners. Two faces of a dihedral have
 * none unless it is folded flat; two faces at a vertex have one if one passes through the
 * other or they overlap in their plane.
 */
#ifndef TRIANGLE_H
#define TRIANGLE_H

#include <stdbool.h>

/* Tells whether p and q, which share no corner, meet. */
bool triangle_meets(const double *const p[3], const double *const q[3]);

/* Tells whether p and q, with the corner p[0] = q[0], have any other common point. */
bool triangle_meets_beyond_vertex(const double *const p[3], const double *const q[3]);

/* Tells whether p and q, with corners p[0], p[1] = q[0], q[1], share a point off the edge.
 */
bool triangle_meets_beyond_edge(const double *const p[3], const double *const q[3]);

/* Returns the distance of x from the nearest point of p, which becomes foot[3]; in floating
 * point. */
double triangle_distance(const double *const p[3], const double x[3], double foot[3]);

#endif

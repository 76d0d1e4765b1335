/* support_lines.h - the lines inside a sheet where supports end and loads lie, and nets
 * that have lines there. A net holds only its points: between the last line of points
 * within a support and the next one, the sheet hangs as if the support ended there, up to a
 * cell too far, and a load on a line goes to the lines beside it; errors of first order
 * that go up and down as the net is refined. */
#ifndef SUPPORT_LINES_H
#define SUPPORT_LINES_H

#include <stdbool.h>

#include "models/scene.h"

/* Places closer than this [sides] are the same: a scene's 0.333 and 0.3333 are not. */
#define SUPPORT_LINES_APART 1e-4

/* Returns whether a support clamps a line inside the sheet across direction i. */
bool support_lines_clamped(const struct scene_support *s, int i);

/* Returns whether a load lies on a line inside the sheet across direction i, and computes
 * its u (of its sheet) or v; *at has room all the same. */
bool support_lines_loaded(const struct scene *scene, int load, int i, double *at);

/* Returns the least number of points along u (0) or v (1), at least `points` > degree and
 * up to twice the spans, with a line at each end of each support and each line of loads; 0:
 * there is none. Splines of degree 2 and more have knots at the ends of areas and at
 * clamped and loaded lines by themselves (iga/support_knots.h): theirs fit if they have a
 * line at each hinge or point that is held. */
int support_lines_points(const struct scene *scene, int along, int points, int degree);

#endif

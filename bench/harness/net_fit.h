/* net_fit.h - finds nets with lines where supports begin and end and where loads lie. A net
 * holds only its points: between the last line of points within a support and the next one,
 * the sheet hangs as if the support ended there, up to a cell too far, an error of first
 * order that goes up and down as the net is refined. */
#ifndef NET_FIT_H
#define NET_FIT_H

#include "models/scene.h"

/* Returns the least number of points along u (0) or v (1), at least `points` > degree and
 * up to twice the spans, with a line at each end of each support and each line of loads; 0:
 * there is none. Splines of degree 2 and more have knots at the ends of areas and at
 * clamped and loaded lines by themselves (support_knots.h): theirs fit if they have a line
 * at each hinge or point that is held. */
int net_fit_points(const struct scene *scene, int along, int points, int degree);

#endif

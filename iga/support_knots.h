/* support_knots.h - splines that begin and end supports, and bend under loads, where the
 * scene does.
 *
 * Where an area that is held begins or ends inside the sheet, the sheet curves at once
 * beyond it. A spline that is smoother there, or that has functions free which do not
 * vanish on the area, puts the border elsewhere: an error of first order. So the ends are
 * knots, which repeat, and a support holds every function that does not vanish on it. A
 * shell of degree p has p - 1 knots at an end and is C^1: it leaves with place and slope
 * held, and its curvature is free. A solid has p and is C^0: place and director are held,
 * but the director's slope, which is the curvature, is free. (C^1 solids were 10 % too
 * stiff in the frequency of a strip's wings on 22 points and 4 % on 43: first order again.)
 *
 * A line inside the sheet that is clamped is an area without width: it has knots and holds
 * functions likewise. (Where it held the control points that lie on it, a shell turned
 * about it, and solids were 4 % too soft in frequency on 43 points: first order, too.) A
 * line inside the sheet that is loaded has the same knots, since the sheet bends there.
 */
#ifndef SUPPORT_KNOTS_H
#define SUPPORT_KNOTS_H

#include "iga/bspline.h"
#include "models/scene.h"

/* The continuity of a sheet at an end: C^0 or C^1. */
enum support_knots_border { SUPPORT_KNOTS_SOLID, SUPPORT_KNOTS_SHELL };

/* Makes direction i (u or v) of a discretization: its knots; or as many as make its points,
 * at supports' ends as above and between them in spans as even as can be. Several sheets
 * have a part each along u, with the ends of all their supports. Ends nearer to
 * one another than 1e-4 are one; where points are too few, all ends' knots repeat less. */
enum status support_knots_basis(struct bspline *b, const struct scene *scene,
                                const struct discretization *d, int i,
                                enum support_knots_border border, struct message *why);

/* Returns u (direction 0) or v of the Greville abscissa of function i of a scene's basis.
 */
double support_knots_at(const struct scene *scene, const struct bspline *b, int direction,
                        int i);

/* Returns how many of the knots of a sheet are full repeats at ends between 0 and 1. */
int support_knots_repeats(const struct scene *scene, int i, int degree,
                          enum support_knots_border border);

/* Makes *held, owned: the scene's supports (paths are borrowed) with areas as wide as the
 * Greville abscissae of all functions that do not vanish on them, and lines that are
 * clamped inside the sheet likewise. Edges, hinges and points stay. */
enum status support_knots_hold(const struct scene *scene, const struct bspline basis[2],
                               struct scene_support **held);

#endif

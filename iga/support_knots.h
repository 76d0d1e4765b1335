/* support_knots.h - splines that begin and end supports where the scene does.
 *
 * A sheet that leaves a support's border has no value and no slope there, but at once a
 * curvature: it is C^1 and no smoother. So of each direction the places where supports
 * begin and end inside the sheet are knots repeated p - 1 times (once at degree 1), and a
 * support holds every function that does not vanish on it. (On a smoother spline, or with
 * such functions free, the border lies where it is not, an error of first order.)
 */
#ifndef SUPPORT_KNOTS_H
#define SUPPORT_KNOTS_H

#include "iga/bspline.h"
#include "models/scene.h"

/* What leaves a border with no more than its place: the sheet's mid-surface and director,
 * each C^0; or with its slope, too: a shell's mid-surface alone, C^1. */
enum support_knots_border { SUPPORT_KNOTS_SOLID, SUPPORT_KNOTS_SHELL };

/* Direction i (u or v) of a discretization: its knots; or as many as make its points, at
 * supports' ends as above and between them in spans as even as can be. Ends nearer to one
 * another than 1e-4 are one; where points are too few, all ends' knots repeat less. */
enum status support_knots_basis(struct bspline *b, const struct scene *scene,
                                const struct discretization *d, int i,
                                enum support_knots_border border, struct message *why);

/* How many knots, of those between 0 and 1, repeat at ends in full. */
int support_knots_repeats(const struct scene *scene, int i, int degree,
                          enum support_knots_border border);

/* Into *held, owned, the scene's supports (paths are borrowed) with areas as wide as the
 * Greville abscissae of all functions that do not vanish on them. Edges and points stay. */
enum status support_knots_hold(const struct scene *scene, const struct bspline basis[2],
                               struct scene_support **held);

#endif

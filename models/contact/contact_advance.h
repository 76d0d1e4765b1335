/* contact_advance.h - how much of a change of a sheet keeps it from coming through itself.
 *
 * Each sample and triangle, and each two edges of triangles, keep half of their distance
 * over the wall, or half of the range where that is less; those already nearer than the
 * wall half of their distance. Where they move by w relative to each other, their distance
 * changes by at most w: what may be used up, over w, is a safe share, and from where it
 * leads it is looked for again (conservative advancement: Mirtich, Impulse-based dynamic
 * simulation, 1996, section 2.3). No root is looked for, and rounding does no harm. Left
 * out are pairs with a common sample, and those whose closest points are nearer along the
 * sheet than the tree's `apart`, as in contact; on a smooth surface two cells more.
 */
#ifndef CONTACT_ADVANCE_H
#define CONTACT_ADVANCE_H

#include "models/contact/contact_tree.h"

/* Computes the share, 0 to 1, of the change d[samples][3] of y[samples][3]; wall >= 0 [m].
 * Fits the tree. STATUS_NAN. */
enum status contact_advance_share(struct contact_tree *tree, const double *y,
                                  const double *d, double wall, double range,
                                  double *share);

#endif

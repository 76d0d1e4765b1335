/* refine.h - knot insertion and degree elevation; neither changes the shape or its
 * parametrisation, beyond round-off. Sources: Piegl & Tiller 1997, sec. 5.2-5.5; the
 * blossom of Ramshaw 1989 and the Oslo algorithm of Cohen, Lyche, Riesenfeld 1980.
 *
 * Every function takes direction 0, 1 or 2, and on failure leaves the patch unchanged.
 */
#ifndef REFINE_H
#define REFINE_H

#include "iga/patch.h"

/* Inserts the knots u[count], non-decreasing, in (0,1). STATUS_INPUT if they are not, or if
 * a knot would exceed multiplicity p. */
enum status refine_insert(struct patch *patch, int direction, int count, const double *u,
                          struct message *why);

/* Raises the degree in a direction by `by`; the continuity at inner knots is kept (their
 * multiplicity grows by `by` >= 0). STATUS_INPUT past BSPLINE_MAX_DEGREE. */
enum status refine_elevate(struct patch *patch, int direction, int by, struct message *why);

/* Splits every non-empty span of a direction into `parts` >= 1 equal ones. */
enum status refine_split(struct patch *patch, int direction, int parts,
                         struct message *why);

/* Refines by k: elevates first, then splits, so that the new knots have continuity C^{p-1}
 * (Hughes, Cottrell, Bazilevs 2005). One step: both happen or neither. */
enum status refine_k(struct patch *patch, int direction, int elevate_by, int parts,
                     struct message *why);

#endif

/* refine.h - knot insertion and degree elevation; neither changes the shape or its
 * parametrisation. Source: Piegl & Tiller 1997, sec. 5.2-5.5 (A5.1, A5.4, A5.9).
 */
#ifndef REFINE_H
#define REFINE_H

#include "iga/patch.h"

/* Inserts the knots u[count] (non-decreasing, in (0,1)) in direction 0, 1 or 2.
 * STATUS_INPUT if a knot would exceed multiplicity p. On failure the patch is unchanged. */
enum status refine_insert(struct patch *patch, int direction, int count, const double *u,
                          struct message *why);

/* Raises the degree in a direction by `by`; the continuity at inner knots is kept (their
 * multiplicity grows by `by`). STATUS_INPUT past BSPLINE_MAX_DEGREE. */
enum status refine_elevate(struct patch *patch, int direction, int by, struct message *why);

/* Splits every non-empty span of a direction into `parts` equal ones. */
enum status refine_split(struct patch *patch, int direction, int parts, struct message *why);

/* k-refinement: elevate first, then insert, so that the new knots have continuity C^{p-1}
 * (Hughes, Cottrell, Bazilevs 2005). */
enum status refine_k(struct patch *patch, int direction, int elevate_by, int parts,
                     struct message *why);

#endif

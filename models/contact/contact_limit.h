/* contact_limit.h - how much of a change a way to a body allows.
 */
#ifndef CONTACT_LIMIT_H
#define CONTACT_LIMIT_H

/* Returns the distance over the law's wall after a share of the change, and its slope by
 * the share [m]. */
typedef double contact_limit_distance(void *self, double share, double *slope);

/* Returns the largest share of the change, at most `share`, that leaves half of the
 * distance over the wall, or half of the range where that is less; all where the distance
 * is not above 0. Distances to convex bodies lie over their tangents. */
double contact_limit_share(void *self, contact_limit_distance *distance, double range,
                           double share);

#endif

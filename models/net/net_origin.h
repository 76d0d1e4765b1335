/* net_origin.h - the point from which a net in single precision counts its places, and how
 * fast it goes.
 *
 * Single precision has seven digits: places counted from a point that is a thousand lengths
 * away keep four of the length, and steps of a velocity of a hundred metres a second keep
 * four of what a step adds to it. So the point goes with the sheet. It is the scene's
 * origin, at rest, as long as the sheet is within a few lengths of that. Then it goes to a
 * place near the sheet, by a whole number of steps of a power of two, which single
 * precision takes without rounding, and on with the sheet's mean velocity where nothing is
 * held: what is left for single precision is the sheet's shape and how it changes.
 *
 * Whoever puts and gets places and velocities speaks of the scene's. Place and velocity of
 * the point are doubles, found by one thread from those of the nodes: the same bits from
 * any number of threads.
 */
#ifndef NET_ORIGIN_H
#define NET_ORIGIN_H

#include <stdbool.h>

struct net_origin {
    double length;             /* of the sheet; 0: the scene's origin for ever  [m]   */
    bool carried;              /* nothing is held: it takes the velocity, too         */
    double at[3], velocity[3]; /*                                         [m], [m/s]  */
};

/* Returns whether the point need not follow a net at x[nodes][3]. */
bool net_origin_stays(const struct net_origin *origin, int nodes, const double *x);

/* Follows a net at x[nodes][3] with velocities v[nodes][3]. Returns whether the point is
 * now another, or goes otherwise: places and velocities must then be put again. */
bool net_origin_follow(struct net_origin *origin, int nodes, const double *x,
                       const double *v);

#endif

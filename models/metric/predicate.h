/* predicate.h - decides on which side a point lies, without round-off.
 *
 * Signs of determinants of doubles: floating point with a bound on its error first, then,
 * where that leaves the sign open, exact sums of doubles (expansions). Source: Shewchuk,
 * Adaptive precision floating-point arithmetic and fast robust geometric predicates,
 * Discrete Comput. Geom. 18 (1997), sections 2 and 4.
 *
 * Exact for coordinates that are 0 or between 2^-247 and 2^300 in size: no product of
 * three differences then over- or underflows. Pure: safe to call from any thread.
 */
#ifndef PREDICATE_H
#define PREDICATE_H

/* Returns the sign, -1, 0 or 1, of det [b - a; c - a], with the coordinate `axis` (0..2)
 * left out: of the component `axis` of (b - a) x (c - a). */
int predicate_turn(int axis, const double a[3], const double b[3], const double c[3]);

/* Returns the sign, -1, 0 or 1, of det [a - d; b - d; c - d]: 1 if, seen from d, the
 * triangle a b c turns counterclockwise (d lies on the side that (b - a) x (c - a) points
 * away from), 0 if all four lie in a plane. */
int predicate_side(const double a[3], const double b[3], const double c[3],
                   const double d[3]);

/* Returns 1 if a, b, c lie on a line (or coincide). */
int predicate_collinear(const double a[3], const double b[3], const double c[3]);

#endif

/* truth_closed.h - scenes whose motion, or whose shape once they have come to rest, is a
 * closed form or a curve solved to round-off:
 *
 *   fall      nothing holds a sheet that does not spin: it moves as one body, by gravity,
 *             body drag and mass damping. Known at all times.
 *   hanging   a flat sheet of nu = 0 held along u = 0, gravity along u: every fibre is a
 *             bar. St. Venant-Kirchhoff: rho g L (1 - s) = E l (l^2 - 1) / 2, stretch l.
 *             Known once mass damping has brought it to rest.
 *   cantilever  likewise, gravity normal to it: the heavy elastica (fem_ref/elastica.h).
 *
 * By what they are, not by name: --set may make any scene one of them.
 */
#ifndef TRUTH_CLOSED_H
#define TRUTH_CLOSED_H

#include "bench/truth/truth_made.h"

enum { TRUTH_CLOSED_SOURCE = 400 };

/* Fields xyz[times] (grid.h) and their rms error bars [m] at time[times], and the sentence
 * on them. STATUS_UNSUPPORTED: no closed form, or not at one of these times; what was
 * written is then of no use. */
enum status truth_closed_fields(const struct scene *scene, int times, const double *time,
                                double *const *xyz, double *error,
                                char source[TRUTH_CLOSED_SOURCE]);

/* The same as a truth that was made, `closed`: at the scene's snapshots and its end where
 * it falls, at the end where it has come to rest. STATUS_UNSUPPORTED: there is none.
 * Free with truth_made_clear. */
enum status truth_closed_make(const struct scene *scene, struct truth_made *made);

#endif

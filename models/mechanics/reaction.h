/* reaction.h - the forces with which supports hold a sheet (model.h's `forces`).
 *
 * A support exerts on what it holds what the equation of motion lacks there: minus `left`,
 * which loads, contact, elastic forces and inertia leave over. Forces are conjugate to
 * coefficients: as the functions add up to 1, their sum is the force, and the sum of their
 * moments at the coefficients is the moment, also of control points.
 */
#ifndef REACTION_H
#define REACTION_H

#include "models/supports.h"

/* Adds `share` of the force [N] and the moment about the origin [N m] that each support
 * exerts to support[][6]: it is minus left[nodes][3] at the held components of the places
 * at[nodes][3]. A held difference has a moment only. All of `left` counts at a node with a
 * frame, since it has nothing along the way that is free. */
void reaction_add(const struct supports *s, const double *left, const double *at,
                  double share, double (*support)[6]);

/* Subtracts from left[nodes][3] the inertia and the drag of held points that move, on their
 * way at time t by differences over +-dt. mass[nodes] [kg], drag[nodes] [N s/m];
 * shift[held_count] is work. */
void reaction_inertia(const struct supports *s, const struct scene *scene, double t,
                      double dt, const double *mass, const double *drag, double *shift,
                      double *left);

/* Adds the couple by which clamps of a net keep it from turning, which acts on no point:
 * only by it has slope[nodes][3], that of the elastic energy at at[nodes][3], a moment. If
 * there are several supports, no moment is known, and all become NaN. */
void reaction_clamps(const struct scene *scene, int nodes, const double *slope,
                     const double *at, double share, double (*support)[6]);

#endif

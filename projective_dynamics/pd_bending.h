/* pd_bending.h - bending and clamps as quadratic rows of second differences (pd_energy.h).
 */
#ifndef PD_BENDING_H
#define PD_BENDING_H

#include "projective_dynamics/pd_energy.h"

/* Room in e->rows for these, per node: two curvatures, a twist, two clamps. */
enum { PD_BENDING_ROWS = 5 };

/* Both add to e->rows; e->net and e->area are set. */

/* The plate's energy with the scene's D and nu, and clamps at `clamped` nodes. */
void pd_bending_plate(struct pd_energy *e, const struct scene *scene, const bool *clamped);

/* weight/2 area |x_uu + x_vv|^2 at every node; along the rim where that is all there is. */
void pd_bending_mean_curvature(struct pd_energy *e, double weight);

#endif

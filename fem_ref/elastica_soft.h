/* elastica_soft.h - the heavy elastica (elastica.h) of a narrow strip 1 m long whose
 * bending softens (law.h). Its sides are free, so that its curvature follows from the
 * moment alone: it minimises the energy less moment k_uu over k_vv and k_uv. theta' =
 * -k(M),  M' = weight s cos theta,  s from the free end, is shot by the mid-point rule.
 */
#ifndef ELASTICA_SOFT_H
#define ELASTICA_SOFT_H

#include "fem_ref/elastica.h"
#include "models/scene.h"

/* Solves for the tip under a weight [N/m^2]; returns the error left by the step [m]. */
double elastica_soft(const struct law *law, double weight, struct elastica_point *tip);

#endif

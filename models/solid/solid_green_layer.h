/* solid_green_layer.h - one layer of linear functions (solid_layer.h) at large
 * displacements: strains, energy, forces and tangent where
 * the space has a layer, as solid_green_element.h has them elsewhere. */
#ifndef SOLID_GREEN_LAYER_H
#define SOLID_GREEN_LAYER_H

#include "models/solid/solid_green_element.h"

/* Checks for det F <= 0 only at the points of SOLID_ACROSS, which see the director's
 * length; between them a fold within a span may shorten it to nothing, which does no harm.
 */
bool solid_green_layer_strain(struct solid_green_element *e,
                              const struct solid_layer_rest *rest, bool change);
double solid_green_layer_energy(const struct solid_green_element *e,
                                const struct solid_material *material,
                                const struct solid_layer_rest *rest);
void solid_green_layer_force(struct solid_green_element *e,
                             const struct solid_material *material,
                             const struct solid_layer_rest *rest);
void solid_green_layer_stiffness(struct solid_green_element *e,
                                 const struct solid_material *material,
                                 const struct solid_layer_rest *rest,
                                 double geometry_share);
void solid_green_layer_blocks(const struct solid_green_element *e, double stress_share,
                              int a, int first, int last, double (*K)[9]);

#endif

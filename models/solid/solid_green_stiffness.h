/* solid_green_stiffness.h - the tangent stiffness of a solid_green_element. */
#ifndef SOLID_GREEN_STIFFNESS_H
#define SOLID_GREEN_STIFFNESS_H

#include "models/solid/solid_green_room.h"

/* Computes, on the geometry e->U[1], stress_share times the material part and
 * geometry_share times the geometric part with the stress of e->strain. Kept in *e for
 * solid_green_stiffness_blocks. */
void solid_green_stiffness_compute(struct solid_green_element *e,
                                   const struct solid_material *material,
                                   const struct solid_green_rest *rest, double stress_share,
                                   double geometry_share);

/* Adds K_ab for b = first .. last - 1, all >= a, row-major, to K[last - first][9]. */
void solid_green_stiffness_blocks(const struct solid_green_element *e,
                                  const struct solid_material *material,
                                  double stress_share, int a, int first, int last,
                                  double (*K)[9]);

#endif

/* solid_green_element.h - strains, forces and tangent of one solid element at large
 * displacements: total Lagrangian, Green strain, St. Venant-Kirchhoff law.
 *
 * Displacement functions have rest gradients g_a. With D = sum u_a g_a^T, F = I + D:
 *   E = (D + D^T + D^T D)/2,   S = lambda tr(E) I + 2 mu E (plane_stress: solid_element.h),
 * f_a = int F S g_a dV, K_ab = int lambda p_a p_b^T + mu p_b p_a^T + mu (g_a.g_b) F F^T +
 * (g_a.S g_b) I dV, p_a = F g_a (Holzapfel 2000, sec. 8.4, with the isotropic law written
 * out).
 *
 * Internal modes (solid_space.h) are strains sym(alpha_m g_m^T) added to E: with this law
 * alpha is a linear function of E, so that nothing has to be iterated or remembered
 * (Klinkel, Wagner 1997); at small displacements it is the incompatible element.
 *
 * In a space with a layer (solid_layer.h) strains, energy and forces are the layer's.
 */
#ifndef SOLID_GREEN_ELEMENT_H
#define SOLID_GREEN_ELEMENT_H

#include "models/solid/solid_green_room.h"

enum status solid_green_element_init(struct solid_green_element *e,
                                     const struct solid_space *space);
void solid_green_element_clear(struct solid_green_element *e);

/* Computes the factored stiffness of the internal modes, A. For set-up. */
void solid_green_element_modes(const struct solid_green_element *e,
                               const struct solid_material *material,
                               const struct solid_green_rest *rest, double *A);

/* Computes e->strain of the displacement e->U[0]: zero, to the bit, at rest. False if it is
 * not finite or det F <= 0 somewhere. With `change`, less the product of e->U[1] and
 * e->U[2], `beside` and `change` of large_foresight: the strain as a linearisation foresaw
 * it (Magisano, Leonetti, Garcea, CMAME 313, 2017). Modes included. */
bool solid_green_element_strain(struct solid_green_element *e,
                                const struct solid_material *material,
                                const struct solid_green_rest *rest, bool change);

/* Returns the elastic energy of e->strain [J]. */
double solid_green_element_energy(const struct solid_green_element *e,
                                  const struct solid_material *material,
                                  const struct solid_green_rest *rest);

/* Computes e->f of the stress of e->strain on the geometry e->U[1]. */
void solid_green_element_force(struct solid_green_element *e,
                               const struct solid_material *material,
                               const struct solid_green_rest *rest);

#endif

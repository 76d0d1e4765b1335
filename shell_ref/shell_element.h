/* shell_element.h - strains, forces and tangent of one element of the rotation-free
 * Kirchhoff-Love shell with a St. Venant-Kirchhoff law (Kiendl, Bletzinger, Linhard,
 * Wuechner, CMAME 198, 2009), with exact first and second variations.
 *
 * Mid-surface x(u,v): a_1 = x_u, a_2 = x_v, unit normal n, a_ab = a_a . a_b,
 * b_ab = x_ab . n; capitals at rest. With c = 11, 22, 12 (shear doubled):
 *   membrane strain (a_ab - A_ab)/2,   bending strain B_ab - b_ab,
 *   resultants h C e and h^3/12 C k,   C the plane-stress law in the metric A^ab.
 * With phi_ab = N_ab - Gamma^c_ab N_c the variations are  d b_ab = phi_ab n  and
 *   d d' b_ab = -(n.da_c)(a^c.phi'_ab) - (n.da'_c)(a^c.phi_ab) - b_ab a^cd
 * (n.da_c)(n.da'_d).
 */
#ifndef SHELL_ELEMENT_H
#define SHELL_ELEMENT_H

#include "shell_ref/shell_room.h"

enum status shell_element_init(struct shell_element *e, const struct shell_space *space);
void shell_element_clear(struct shell_element *e);

/* Loads the element's functions of the first so many rules; before the other calls. */
void shell_element_load(struct shell_element *e, const struct shell_space *space,
                        int element, int rules);

/* Computes rest[SHELL_REST_ROWS][padded] of a rule from the element's control points
 * e->X[0] and place[]. STATUS_INPUT if the surface has no normal there. */
enum status shell_element_rest(struct shell_element *e, int rule,
                               const struct shell_material *material,
                               const struct shell_place *place, double *rest);

/* Computes e->strain on the control points e->X[0]. rest[SHELL_PARTS], here and below: of
 * membrane and bending. False if they are not finite or the surface has no normal. */
bool shell_element_strain(struct shell_element *e, const double *const rest[]);

/* Returns the elastic energy of e->strain [J]. */
double shell_element_energy(const struct shell_element *e,
                            const struct shell_material *material,
                            const double *const rest[]);

/* Computes e->f: forces of the stress of e->strain on the geometry e->X[1]. */
void shell_element_force(struct shell_element *e, const struct shell_material *material,
                         const double *const rest[]);

/* Subtracts half the product of the change e->X[2] and e->X[1] (large_foresight's beside)
 * from e->strain in the membrane: this is the strain as the tangent foresaw it. Magisano,
 * Leonetti, Garcea 2017 base the geometric part on it: Newton's method on thin shells then
 * needs far fewer steps. */
void shell_element_foresee(struct shell_element *e);

#endif

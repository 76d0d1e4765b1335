/* tri_strain.h - a triangle's membrane strain, as a function of how its material directions
 * u and v are stretched: with the tangents X_u, X_v per metre of material,
 *     C = (X_u . X_u, X_v . X_v, X_u . X_v),
 * and strains e = (along u, along v, shear) that vanish for C = (1, 1, 0) and there have
 * the same first derivatives, so that all are one law for small strains.
 *
 *   green          (C - I) / 2: St. Venant and Kirchhoff's energy, no root; weak under
 *                  strong pressure.
 *   corotational   U - I, U = sqrt(C) (Biot's strain; the energy |F - R|^2 of corotational
 *                  methods, R the rotation next to F).
 *   baraff_witkin  |X_u| - 1, |X_v| - 1 and X_u . X_v: the conditions of Baraff and Witkin
 *                  1998 (Kim 2020, "A finite element formulation of Baraff-Witkin cloth").
 *                  They are not coupled: tri_strain_stiffness leaves C12 out.
 */
#ifndef TRI_STRAIN_H
#define TRI_STRAIN_H

#include "models/net/spring_sweep.h"
#include "models/scene.h"

struct tri_strain {
    double e[3];       /* [1] */
    double J[3][3];    /* de_k / dC_l                                                     */
    double H[3][3][3]; /* d2e_k / dC_l dC_m                                            */
};

/* Computes strains; false where the triangle has no area, or C is not finite. */
bool tri_strain_at(enum membrane membrane, const double C[3], struct tri_strain *s);

/* Computes a sheet's stiffness, energy e . D e / 2 per area [N/m]. */
void tri_strain_stiffness(const struct scene *scene, enum membrane membrane,
                          double D[LAW_ENTRIES]);

#endif

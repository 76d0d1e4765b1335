/* spring_soft.h - bending of a net that softens (law.h), on top of its plate: the energy of
 * the curvature along warp and weft,
 *     k = a^2 x_uu + b^2 x_vv + 2 a b x_uv,
 * (a, b) the direction in u and v, at free points and clamps; x_uv is the mean of the cells
 * around, and zero at clamps, as is the curvature along a clamped line. Along a rim, across
 * which no moment acts, the curvature across is that of the linear law:
 *     x_vv = -(B12 x_uu + 2 B23 x_uv) / B22.
 */
#ifndef SPRING_SOFT_H
#define SPRING_SOFT_H

#include "models/net/spring_form.h"

struct spring_soft {
    struct law_soft law[2];    /* along the warp, the weft                            */
    struct spring_forms forms; /* their curvatures by rows; `kind`: law        owned   */
};

/* Initialises; there are no forms where nothing softens. */
enum status spring_soft_init(struct spring_soft *s, const struct scene *scene,
                             const struct spring_net *net);
void spring_soft_clear(struct spring_soft *s);

/* Return, add or subtract [J], [N], [N/m] of form k at its value: the energy; `sign` times
 * its derivative to f[nodes][3]; `factor` times the second derivative to K, by the pairs of
 * the graph, without those that it leaves out. */
double spring_soft_energy(const struct spring_soft *s, int k, const double value[3]);
void spring_soft_force(const struct spring_soft *s, int k, const double value[3],
                       double sign, double *f);
void spring_soft_tangent(const struct spring_soft *s, int k, const double value[3],
                         double factor, const struct blocks *graph, double (*K)[9]);

#endif

/* elastica.h - the heavy elastica: an inextensible strip clamped horizontally at one end,
 * hanging under its own weight; equilibrium at any Gamma = rho g h L^3 / D (scene.h).
 *
 * Angle below the horizontal theta(s), s in units of L:
 *   theta'' = -Gamma (1 - s) cos theta,  theta(0) = 0,  theta'(1) = 0.
 * With tau = Gamma^(1/3) (1 - s) and psi = pi/2 - theta Gamma leaves the equation,
 *   psi'' = tau sin psi,  psi'(0) = 0,  psi(Gamma^(1/3)) = pi/2,
 * which is shot from the free end by Taylor series of high order. psi(0) is found by its
 * logarithm: a limp strip hangs vertically to within exp(-2/3 sqrt(Gamma)).
 */
#ifndef ELASTICA_H
#define ELASTICA_H

#include "models/scene.h"
#include "models/status.h"

#define ELASTICA_MIN 1e-4
#define ELASTICA_MAX 1e6

/* A point of the strip: how far it is out and below, over L, and how far it has turned
 * below the horizontal [rad]. */
struct elastica_point {
    double reach, drop, angle;
};

/* Solves for the points at s[count], increasing from 0 (the clamp) to 1 (the tip), with
 * ELASTICA_MIN <= gamma <= ELASTICA_MAX; otherwise STATUS_INPUT. Relative error below 1e-10
 * (tests/fem_ref/elastica.c). At most 0.3 s; allocates nothing. */
enum status elastica_curve(double gamma, int count, const double *s,
                           struct elastica_point *point);

/* Solves for the tip alone. */
enum status elastica_solve(double gamma, struct elastica_point *tip);

/* Returns how far the middle stands out, over L, of an inextensible strip without weight
 * whose ends, clamped or hinged, are nearer by shortening L, 0 < shortening <= 0.9:
 *   shortening = 2 - 2 E(k) / K(k),  middle = k / K(k),
 * with k the sine of half the greatest slope (Euler 1744; Love, Theory of Elasticity, sec.
 * 262-263). Relative error below 1e-12; NaN outside that range. */
double elastica_buckled(double shortening);

/* The heavy elastica of a narrow strip 1 m long whose bending softens (law.h). Its sides
 * are free, so that its curvature follows from the moment alone: it minimises the energy
 * less moment k_uu over k_vv and k_uv. theta' = -k(M),  M' = weight s cos theta,  s from
 * the free end, is shot by the mid-point rule. */

/* Solves for the tip under a weight [N/m^2]; returns the error left by the step [m]. */
double elastica_soft(const struct law *law, double weight, struct elastica_point *tip);

#endif

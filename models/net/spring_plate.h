/* spring_plate.h - the bending of a net as squares of sums of its points: Kirchhoff's plate
 * by differences about the flat rest shape, quadratic in the positions (after Bergou et al.
 * 2006, "A quadratic bending model for inextensible surfaces", here on a regular net),
 * exact in the scene's nu:
 *     B/2 int |x_uu|^2 + |x_vv|^2 + 2 nu x_uu x_vv + 2 (1 - nu) |x_uv|^2,
 * x_uu and x_vv at points, x_uv in cells; what has both is, with s the sign of nu,
 *     (1 - |nu|) (|x_uu|^2 + |x_vv|^2) + |nu| |x_uu + s x_vv|^2.
 * It counts the curvature of lines in the surface, too, as a plate does not: a strip as
 * wide as W resists bending in its plane with Y W^2 / 12 and B more. Along a rim, across
 * which no moment acts, the strip bends as a beam: factor 1 - nu^2 and no nu x_uu x_vv.
 * B13 and B23 couple bending to twist where the warp runs along neither edge: with
 *     (s_u, s_v) = (B11 B12; B12 B22)^-1 (B13, B23)
 * the energy is that of x_uu + 2 s_u x_uv and x_vv + 2 s_v x_uv at points, whose x_uv is
 * the mean of the cells around, and of x_uv in cells with what is left of B33,
 * B33 - s_u B13 - s_v B23 > 0: exact where the curvature is constant, and no part is
 * negative.
 *
 * Softening adds to it: spring_form.h.
 *
 * On a mesh that is no grid the form is Morley's triangle (1968) for each component of the
 * places: an edge has the sheet's slope across it (mesh.h), and al is that less the
 * triangle's own, outward. The curvature of a triangle, sum over its sides of (l / A) al n
 * n^t, n their normals in the plane, is constant, and the energy is that of any bending
 * matrix. Slopes at clamped edges are held.
 *
 * Clamps: at a held column that cannot turn, the curvature of the cubic that leaves the
 * point x0 along e with the free neighbours x1, x2 on it,
 *     kappa a^2 = 4 (x1 - x0 - a e) - (x2 - x0 - 2 a e) / 2,
 * over a third of a cell, and that of the point beside it over 7/6: then a constant moment
 * holds the parabola that it should, as neither point is pulled,
 *     x1: 4 w_0 - 2 w_1 + 1 = 0,   x2: -w_0 / 2 + w_1 - 2 + 1 = 0,
 * and positions converge with second order. (The trapezoidal 1/2 and 1 bend the first cell
 * too far: first order; on nets as coarse as 16 x 16 that offsets what the net leaves
 * out of a bend.)
 * With one free neighbour alone the parabola's curvature, 2 (x1 - x0 - a e), over half a
 * cell.
 */
#ifndef SPRING_PLATE_H
#define SPRING_PLATE_H

#include "models/discretization.h"
#include "models/law/law.h"
#include "models/net/spring_form.h"

enum spring_plate_kind {
    SPRING_PLATE_U,     /* x_uu a_u^2: points before, at, after; those of x_uv, if any  */
    SPRING_PLATE_V,     /* x_vv a_v^2                                                   */
    SPRING_PLATE_TWIST, /* x_uv a_u a_v: points (i,j), (i,j+1), (i+1,j), (i+1,j+1)      */
    SPRING_PLATE_MEAN,  /* (x_uu + s x_vv) a_u a_v: at, before and after along u, v     */
    SPRING_PLATE_CLAMP, /* kappa a^2: the held point, its neighbour, the next           */
    SPRING_PLATE_SLOPE  /* of leans of a triangle over its sides                        */
};

/* Makes all forms of a net, of the energy stiffness |value|^2 / 2; none of the paper's.
 * Owned by the caller. */
enum status spring_plate_make(const struct scene *scene, const struct mesh *net,
                              enum parameters parameters, struct spring_forms *forms);

/* Computes of a triangle that leans by al over its sides, outward: the curvature bend al
 * (as law.h has strains), and Q, of the energy al Q al / 2 for the bending matrix B. */
void spring_plate_triangle(const struct mesh_plane *p, const double B[LAW_ENTRIES],
                           double bend[3][3], double Q[3][3]);

/* Computes the weights of SPRING_PLATE_MEAN: of neighbours along u and along v. */
void spring_plate_mean(const struct scene *scene, const double cell[2], double weight[2]);

#endif

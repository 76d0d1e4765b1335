/* hinge_rule.h - stiffnesses of hinges, k theta^2 / 2 over the angle theta between two
 * triangles, with which a net of rectangles with alternate diagonals bends as the sheet
 * does.
 *
 * Vertices of such a net have eight neighbours or four, by turns, and bending pushes the
 * first up against the second by c, which softens it: with the usual D |e|^2 / (A1 + A2)
 * (Seung and Nelson 1988, for equilateral triangles) a cylinder along an edge has 5/6 of D,
 * one at 45 degrees 4/3. In cells of a (along u) times b, with u = k11 a^2, v = k22 b^2,
 * t = k12 a b and y = 4 c, the folds are (u + y)/a, (v + y)/b and (+-t - y) |e|/a b, so
 * that the energy of a cell is [P (u + y)^2 + Q (v + y)^2 + R (t^2 + y^2)] / 2 (a b)^3 with
 * P = k_v a b^3, Q = k_u a^3 b, R = k_d a b |e|^2. In the least y it is, for what can be
 * developed, u v = t^2, that of the sheet in any direction, if
 *
 *     P - P^2/S = A = B11 b^4,   Q - Q^2/S = C = B22 a^4,
 *     R - 2 P Q/S = G = (2 B12 + 4 B33) a^2 b^2,   S = P + Q + R.
 *
 * A star of P, Q, R is a triangle of z = P Q/S, A - z and C - z, so that 3 z^2 + G z = A C,
 * P = (A C - z^2)/(C - z), Q = (A C - z^2)/(A - z), R = (A C - z^2)/z. Isotropic and
 * square: 4/3 D along edges, 4/3 D over diagonals, where the usual rule has D and 2 D. What
 * is doubly curved, a rim or a sheet that stretches, has a Poisson's ratio of -1/3 instead
 * of its own; that of hinges is always below 0.
 */
#ifndef HINGE_RULE_H
#define HINGE_RULE_H

#include <stdbool.h>

#include "models/law/law.h"

/* Stiffnesses [N m] of edges along u, along v and along a diagonal; of edges along u or v
 * between a triangle of the sheet and one that is held, at a clamp. */
struct hinge_rule {
    double u, v, diagonal, held_u, held_v;
    /* Every direction is right. In cells longer than 1.6 (of an isotropic sheet) it would
     * take stiffnesses below 0: u and v are right, directions between them are not. */
    bool everywhere;
};

/* Returns the rule for a bending matrix [N m] (law.h) in cells of a by b [m]. */
struct hinge_rule hinge_rule_of(const double bending[LAW_ENTRIES], double a, double b);

#endif

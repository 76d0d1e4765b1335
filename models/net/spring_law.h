/* spring_law.h - the strength of a net's springs, and the sheet that they amount to.
 *
 * A net has springs along u, along v and along both diagonals of every cell a_u x a_v, and
 * hinges: two springs in line with a strut across both (spring_net.h). Springs on the rim
 * belong to one cell only and have half the strength.
 *
 * Membrane. Under a homogeneous strain (e_u, e_v, g = 2 e_uv) the springs of one cell have
 * the energy (c, s: cosine and sine of the diagonal to u, l its length)
 *     k_u a_u^2 e_u^2 / 2 + k_v a_v^2 e_v^2 / 2
 *     + k_d l^2 [ (c^2 e_u + s^2 e_v)^2 + c^2 s^2 g^2 ],
 * so per area, with q = 2 k_d l^2 / (a_u a_v),
 *     C11 = k_u a_u / a_v + q c^4,   C22 = k_v a_v / a_u + q s^4,   C12 = C33 = q c^2 s^2.
 * C12 = C33 is Cauchy's relation: springs have it at any strength. In plane stress
 *     C11 = C22 = E h / (1 - nu^2),   C12 = nu C11,   C33 = (1 - nu) C11 / 2,
 * and C12 = C33 there means nu = 1/3. `matched` keeps C33 and, as cloth is pulled with its
 * sides free, what there is against tension along u and v, E1 = C11 - C12^2 / C22 and E2 =
 * C22 - C12^2 / C11: C22 = C11 E2 / E1 and C11 = [E1 + (E1^2 + 4 C33^2 E1 / E2)^(1/2)] / 2.
 * Isotropic, C11 is 1.21 times the sheet's at nu = 0, 1.03 at .3, .85 at .49; the net's own
 * Poisson ratio, C33 / C11, is .41, .34, .29. On square cells k_d = G h and
 * k_u = k_v = C11 - G h. Of a long cell the diagonals have most of C11, or all, and nothing
 * but springs along u holds one half of the points, of a chequered board, against the
 * other: diagonals join points of one colour, and springs along v, pressed by C12 e under
 * a strain e along u, push the colours apart along u. With a share t of C11 in springs
 * along u that is stable for e < t / (1 - t). Cells longer than some 1.2 times their width
 * therefore have weaker diagonals, which leave a share of .4, and C33 falls short: with r =
 * .6 (a_v / a_u)^2 < 1, C12 = C33 = r C11 and C11 = E1 / (1 - r^2 E1 / E2). Tension along u
 * and v stays the sheet's.
 *
 * Bending. A spring across two cells, unstrained at rest, has the energy k (a^3 / 4)^2
 * kappa^4 / 2: of fourth order. Such springs can't represent a bending stiffness D, which
 * is the second order, at any strength. A strut that pushes with a constant force P, held
 * in balance by tension P in the two springs beside it, can: its energy is
 *     P (|e1| + |e2| - |e1 + e2|) = P a theta^2 / 4 + O(theta^4)
 * for edges e1, e2 of length a at the angle theta = a kappa; zero if straight, and never
 * negative. (Choi and Ko 2002 reach the same force from the buckled shape of a beam.)
 * Hinges along the same four directions give a bending energy of the same form as the
 * membrane's, with C_ij h^2 / 12 for C_ij: Kirchhoff's plate at nu = 1/3 again, and the
 * right stiffness D in cylindrical bending along u or v for every nu. Diagonals end one
 * cell before the rim; hinges along the rim make up for them in cylindrical bending, but in
 * twist a strip half a cell wide is missing: an error of first order in the cell's size.
 *
 * `paper` (Ren et al. 2024, Fig. 6: "k = 100, damping 0.05, point mass density 1",
 * structural and shear springs, after Provot 1995). It gives no units and no sheet. Read
 * here as k = 100 N/m for every spring, rim or not; as in Provot a force -0.05 N s/m times
 * the velocity on every point; and 1 kg per m^2 of sheet, lumped (1 kg in all for 1 m^2,
 * like the total mass that the paper gives for projective dynamics. With 1 kg for each of
 * 100 points the two corners would hang by springs more than ten times their length.) No
 * bending.
 */
#ifndef SPRING_LAW_H
#define SPRING_LAW_H

#include "models/discretization.h"
#include "models/scene.h"

enum spring_direction { SPRING_U, SPRING_V, SPRING_DIAGONAL, SPRING_DIRECTIONS };

struct spring_law {
    double stiffness[SPRING_DIRECTIONS]; /* stiffness of a whole spring        [N/m]   */
    double strut[SPRING_DIRECTIONS];     /* P of a whole hinge                   [N]   */
    double rim; /* share of whole ones of springs and clamps on the rim [1]   */
    double rim_strut[SPRING_DIRECTIONS]; /* P of a hinge on the rim              [N]   */
};

/* Return a net's mass per area [kg/m^2], and the force on a point against its velocity
 * [N s/m]. */
double spring_law_mass(const struct scene *scene, enum parameters parameters);
double spring_law_drag(enum parameters parameters);

/* Makes the law of a net; cell: a_u, a_v [m] > 0. */
void spring_law_make(const struct scene *scene, enum parameters parameters,
                     const double cell[2], struct spring_law *law);

/* Stiffness of the membrane per width [N/m]; bending has the same, times h^2 / 12. */
struct spring_law_stiffness {
    double c11, c22, c12, c33;
};

/* Returns that of the net under small homogeneous strain. */
struct spring_law_stiffness spring_law_effective(const struct spring_law *law,
                                                 const double cell[2]);

/* Returns that of a sheet in plane stress. */
struct spring_law_stiffness spring_law_plane_stress(const struct scene *scene);

/* Writes for users how far the one is from the other. */
void spring_law_tell(const struct spring_law *law, const double cell[2],
                     const struct scene *scene, struct message *line);

#endif

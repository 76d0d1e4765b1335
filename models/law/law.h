/* law.h - the elastic law of a sheet. Models ask for the matrix that they work with; none
 * knows where it comes from.
 *
 * Energy per area of the mid-surface at rest: e.A e / 2 + k.B k / 2, with the
 * Green-Lagrange strain e = (e_11, e_22, 2 e_12) and the change of curvature k = (k_11,
 * k_22, 2 k_12). Fabric, 1 along the warp, 2 along the weft: A = Y11 Y12 0      B = B1  B12
 * 0 Y12 Y22 0          B12 B2  0 0   0   G          0   0   B66 so that the energy of shear
 * is 2 G e_12^2: G is engineering's shear modulus times the thickness, half the number in
 * tables that have G e_12^2. Published bending tests give B1, B2 and, on the bias, (B1 + B2
 * + 2 B12 + 4 B66) / 4. Isotropic E, nu, h: Y11 = Y22 = E h / (1 - nu^2), Y12 = nu Y11, G =
 * (1 - nu) Y11 / 2, and B = A h^2 / 12.
 *
 * Softening (Feng et al. 2022): along warp and weft the moment has C k |k| besides, C <= 0
 * [N m^2], and the energy C |k|^3 / 3, k the change of curvature along it. Feng's curves
 * end near k = 127 1/m; at k = B / 2 |C|, 186 1/m in the median, they would turn down, and
 * the sheet would fold into creases as sharp as the net allows. So the tangent stops
 * falling at the curvature `most`, where it is `least` of B, and stays: with r = |B12| /
 * sqrt(B1 B2), least = r + (1 - r) / 10 keeps the whole tangent positive definite, and
 * most = (1 - least) B / 2 |C|.
 *
 * A fabric has an effective thickness h_eff = sqrt(12 sqrt(B1 B2 / (Y11 Y22))): a solid as
 * thick, made of A / h_eff, bends with A h_eff^2 / 12, whose first two entries have the
 * mean of B1 and B2.
 */
#ifndef LAW_H
#define LAW_H

#include <stdbool.h>

/* Moduli of a fabric in the order of scene files: Y11, Y22, Y12, G or B1, B2, B12, B66. */
enum law_modulus { LAW_WARP, LAW_WEFT, LAW_CROSS, LAW_SHEAR, LAW_MODULI };

struct law_fabric {
    double membrane[LAW_MODULI]; /*                                           [N/m]   */
    double bending[LAW_MODULI];  /*                                           [N m]   */
    double warp;                 /* angle from u to the warp, towards v       [deg]   */
    double areal_density;        /* mass per area                          [kg/m^2]   */
    double softening[2];         /* C along warp and weft, 0 or less        [N m^2]   */
};

enum law_part { LAW_MEMBRANE, LAW_BENDING, LAW_PARTS };

/* Entries of a symmetric 3 x 3 matrix. */
enum { LAW_11, LAW_12, LAW_13, LAW_22, LAW_23, LAW_33, LAW_ENTRIES };

/* Softening along the warp or the weft. */
struct law_soft {
    double second; /* C                                                      [N m^2]   */
    double most;   /* greatest change of curvature of C k |k|, then straight on [1/m]  */
};

struct law {
    bool isotropic;
    double young, poisson; /* E, nu of an isotropic sheet; else of its mean, law_mean  */
    double thickness;      /* h or h_eff                                       [m]     */
    double matrix[LAW_PARTS][LAW_ENTRIES]; /* A [N/m], B [N m] in axes along u and v   */
    bool softens;
    struct law_soft soft[2]; /* along the warp, the weft                               */
    double along[2][3];      /* their change of curvature is along . k                 */
};

struct law law_isotropic(double young, double poisson, double thickness);
struct law law_of_fabric(const struct law_fabric *fabric);

/* Tells whether moduli have a positive energy for every strain: the first two and the last
 * are positive, and |cross| is less than LAW_MOST_CROSS of the mean of the first two. */
#define LAW_MOST_CROSS 0.99
bool law_definite(const double modulus[LAW_MODULI]);

/* Return what softening adds to the energy per area [N/m] at the change of curvature k
 * [1/m], and to the moment [N] and to the tangent [N m]. */
double law_soft_energy(const struct law_soft *s, double k);
double law_soft_moment(const struct law_soft *s, double k, double *tangent);

/* Returns the effective thickness [m]. */
double law_thickness(const struct law_fabric *fabric);

/* Returns B12 over the mean of B11 and B22: nu of an isotropic sheet. */
double law_cross(const struct law *law);

/* Tells whether warp and weft run along u and v, either way round. */
bool law_is_aligned(const struct law *law);

/* Computes A e of three strains or curvatures; here, as steps call it for each element. */
static inline void law_stress(const double m[LAW_ENTRIES], const double e[3], double s[3])
{
    s[0] = m[LAW_11] * e[0] + m[LAW_12] * e[1] + m[LAW_13] * e[2];
    s[1] = m[LAW_12] * e[0] + m[LAW_22] * e[1] + m[LAW_23] * e[2];
    s[2] = m[LAW_13] * e[0] + m[LAW_23] * e[1] + m[LAW_33] * e[2];
}

/* Returns e.A e / 2. */
double law_energy(const double matrix[LAW_ENTRIES], const double strain[3]);

/* Computes A = area T^t M T of columns of T that are strains. */
void law_square(const double matrix[LAW_ENTRIES], double T[3][3], double area,
                double A[3][3]);

/* Computes T^t M T, where T takes strains in other axes to those that M is for. */
void law_transform(const double matrix[LAW_ENTRIES], double T[3][3],
                   double out[LAW_ENTRIES]);

void law_invert(const double matrix[LAW_ENTRIES], double inverse[LAW_ENTRIES]);

/* Returns the stiffness 1 / (M^-1)_11 of a narrow strip along the first axis, whose sides
 * are free of stress and which shears or twists as it likes. One that is wide and does not
 * contract has M_11. */
double law_narrow(const double matrix[LAW_ENTRIES]);

/* Computes the matrix over h, or over h^3 / 12, [Pa] for covariant strains (e_uu, e_vv,
 * 2 e_uv) on a surface with the metric a_uu, a_vv, a_uv and its determinant. */
void law_on_surface(const struct law *law, enum law_part part, const double metric[3],
                    double determinant, double matrix[LAW_ENTRIES]);

/* Computes the parts of such a matrix's first and fourth entry that points along u and v
 * alone may take: the greatest equal shares of the stiffnesses under stress along u or v
 * alone that leave no negative rest, 1 / (1 + |r|), r the correlation of the two strains in
 * the inverse. */
void law_shares(const struct law *law, const double metric[3],
                const double matrix[LAW_ENTRIES], double share[2]);

#endif

#include "models/law/law.h"

#include <math.h>
#include <string.h>

/* Below 1/2, where a solid resists no more. */
static const double MOST_POISSON = 0.49;

/* Share of what is not coupled in bending that softening leaves. */
static const double SOFTEST = 0.1;

static const double DEGREE = 3.14159265358979323846 / 180;

struct law law_isotropic(double young, double poisson, double thickness)
{
    const double h = thickness, nu = poisson;
    struct law law = {.isotropic = true, .young = young, .poisson = nu, .thickness = h};
    double *A = law.matrix[LAW_MEMBRANE], *B = law.matrix[LAW_BENDING];

    A[LAW_11] = young * h / (1 - nu * nu);
    B[LAW_11] = young * h * h * h / (12 * (1 - nu * nu));
    for (int part = 0; part < LAW_PARTS; part++) {
        double *m = law.matrix[part];
        m[LAW_22] = m[LAW_11];
        m[LAW_12] = nu * m[LAW_11];
        m[LAW_33] = (1 - nu) / 2 * m[LAW_11];
    }
    return law;
}

/* Computes cosine and sine, exactly for right angles. */
static void turn_of(double degrees, double *c, double *s)
{
    const double right = degrees / 90;
    const bool exact = right == floor(right), odd = exact && fmod(right, 2) != 0;

    *c = exact ? !odd : cos(DEGREE * degrees);
    *s = exact ? odd : sin(DEGREE * degrees);
}

static void soften(const struct law_fabric *f, struct law *law)
{
    const double *B = f->bending;
    const double coupled = fabs(B[LAW_CROSS]) / sqrt(B[LAW_WARP] * B[LAW_WEFT]);
    const double least = coupled + SOFTEST * (1 - coupled);
    double c, s;

    turn_of(f->warp, &c, &s);
    for (int i = 0; i < 2; i++) {
        const double C = f->softening[i], a = i ? -s : c, b = i ? c : s;
        law->softens = law->softens || C < 0;
        law->soft[i].second = C;
        law->soft[i].most = C < 0 ? (1 - least) * B[i] / (-2 * C) : INFINITY;
        memcpy(law->along[i], (double[]){a * a, b * b, a * b}, sizeof law->along[i]);
    }
}

double law_soft_energy(const struct law_soft *s, double k)
{
    const double a = fabs(k), b = fmin(a, s->most);

    return s->second * b * (a * a - a * b + b * b / 3);
}

double law_soft_moment(const struct law_soft *s, double k, double *tangent)
{
    const double a = fabs(k), b = fmin(a, s->most);

    *tangent = 2 * s->second * b;
    return copysign(s->second * b * (2 * a - b), -k);
}

bool law_definite(const double m[LAW_MODULI])
{
    return m[LAW_WARP] > 0 && m[LAW_WEFT] > 0 && m[LAW_SHEAR] > 0 &&
           fabs(m[LAW_CROSS]) < LAW_MOST_CROSS * sqrt(m[LAW_WARP]) * sqrt(m[LAW_WEFT]);
}

double law_thickness(const struct law_fabric *f)
{
    const double *Y = f->membrane, *B = f->bending;

    return sqrt(12 * sqrt(B[LAW_WARP] / Y[LAW_WARP] * (B[LAW_WEFT] / Y[LAW_WEFT])));
}

/* Computes E [Pa] and nu of the isotropic sheet, h_eff thick, that has the mean over all
 * directions of the fabric's membrane; nu is 0.49 at most. */
static void law_mean(const struct law_fabric *f, double *young, double *poisson)
{
    const double *Y = f->membrane, both = Y[LAW_WARP] + Y[LAW_WEFT];
    const double along = (3 * both + 2 * Y[LAW_CROSS] + 4 * Y[LAW_SHEAR]) / 8;
    const double cross = (both + 6 * Y[LAW_CROSS] - 4 * Y[LAW_SHEAR]) / 8;

    *poisson = fmin(cross / along, MOST_POISSON);
    *young = (along - cross * *poisson) / law_thickness(f);
}

double law_cross(const struct law *law)
{
    const double *m = law->matrix[LAW_BENDING];

    return law->isotropic ? law->poisson : m[LAW_12] / sqrt(m[LAW_11] * m[LAW_22]);
}

bool law_is_aligned(const struct law *law)
{
    bool aligned = true;

    for (int part = 0; part < LAW_PARTS; part++)
        aligned =
            aligned && law->matrix[part][LAW_13] == 0 && law->matrix[part][LAW_23] == 0;
    return aligned;
}

double law_energy(const double m[LAW_ENTRIES], const double e[3])
{
    double s[3];

    law_stress(m, e, s);
    return (e[0] * s[0] + e[1] * s[1] + e[2] * s[2]) / 2;
}

void law_transform(const double matrix[LAW_ENTRIES], double T[3][3],
                   double out[LAW_ENTRIES])
{
    for (int i = 0, entry = 0; i < 3; i++)
        for (int j = i; j < 3; j++, entry++) {
            const double ei[3] = {T[0][i], T[1][i], T[2][i]};
            const double ej[3] = {T[0][j], T[1][j], T[2][j]};
            double s[3];
            law_stress(matrix, ej, s);
            out[entry] = ei[0] * s[0] + ei[1] * s[1] + ei[2] * s[2];
        }
}

void law_square(const double matrix[LAW_ENTRIES], double T[3][3], double area,
                double A[3][3])
{
    double out[LAW_ENTRIES];

    law_transform(matrix, T, out);
    for (int i = 0, entry = 0; i < 3; i++)
        for (int j = i; j < 3; j++, entry++)
            A[i][j] = A[j][i] = area * out[entry];
}

/* Computes a matrix in axes that are turned by `degrees` from its own: exactly for right
 * angles. */
static void law_turn(const double matrix[LAW_ENTRIES], double degrees,
                     double turned[LAW_ENTRIES])
{
    double c, s;
    turn_of(degrees, &c, &s);
    double T[3][3] = {{c * c, s * s, -c * s},
                      {s * s, c * c, c * s},
                      {2 * c * s, -2 * c * s, c * c - s * s}};

    law_transform(matrix, T, turned);
}

void law_invert(const double m[LAW_ENTRIES], double inverse[LAW_ENTRIES])
{
    inverse[LAW_11] = m[LAW_22] * m[LAW_33] - m[LAW_23] * m[LAW_23];
    inverse[LAW_12] = m[LAW_13] * m[LAW_23] - m[LAW_12] * m[LAW_33];
    inverse[LAW_13] = m[LAW_12] * m[LAW_23] - m[LAW_13] * m[LAW_22];
    inverse[LAW_22] = m[LAW_11] * m[LAW_33] - m[LAW_13] * m[LAW_13];
    inverse[LAW_23] = m[LAW_12] * m[LAW_13] - m[LAW_11] * m[LAW_23];
    inverse[LAW_33] = m[LAW_11] * m[LAW_22] - m[LAW_12] * m[LAW_12];
    const double determinant = m[LAW_11] * inverse[LAW_11] + m[LAW_12] * inverse[LAW_12] +
                               m[LAW_13] * inverse[LAW_13];
    for (int k = 0; k < LAW_ENTRIES; k++)
        inverse[k] /= determinant;
}

double law_narrow(const double matrix[LAW_ENTRIES])
{
    double inverse[LAW_ENTRIES];

    law_invert(matrix, inverse);
    return 1 / inverse[LAW_11];
}

struct law law_of_fabric(const struct law_fabric *fabric)
{
    struct law law = {.thickness = law_thickness(fabric)};

    law_mean(fabric, &law.young, &law.poisson);
    for (int part = 0; part < LAW_PARTS; part++) {
        const double *m = part == LAW_BENDING ? fabric->bending : fabric->membrane;
        const double own[LAW_ENTRIES] = {[LAW_11] = m[LAW_WARP],
                                         [LAW_12] = m[LAW_CROSS],
                                         [LAW_22] = m[LAW_WEFT],
                                         [LAW_33] = m[LAW_SHEAR]};
        law_turn(own, -fabric->warp, law.matrix[part]);
    }
    soften(fabric, &law);
    return law;
}

/* law_surface.c - the law on a curved surface with any parameters. Compiled with
 * -ffp-contract=fast, as shell_ref is, whose bits these are (CMakeLists.txt). */
#include "models/law/law.h"

#include <math.h>

/* Makes the matrix of plane stress for the inverse metric a, b, c (uu, vv, uv). */
static void isotropic(const struct law *law, double a, double b, double c,
                      double matrix[LAW_ENTRIES])
{
    double nu = law->poisson, factor = law->young / (1 - nu * nu);

    matrix[LAW_11] = factor * a * a;
    matrix[LAW_12] = factor * (nu * a * b + (1 - nu) * c * c);
    matrix[LAW_13] = factor * a * c;
    matrix[LAW_22] = factor * b * b;
    matrix[LAW_23] = factor * b * c;
    matrix[LAW_33] = factor * ((1 - nu) * a * b + (1 + nu) * c * c) / 2;
}

void law_on_surface(const struct law *law, enum law_part part, const double metric[3],
                    double determinant, double matrix[LAW_ENTRIES])
{
    const double h = law->thickness, u = sqrt(metric[0]), lean = metric[2] / u;
    const double v = sqrt(determinant) / u;
    const double over = part == LAW_BENDING ? 12 / (h * h * h) : 1 / h;
    /* strains along e_1 = a_u / u and e_2 = (a_v - lean e_1) / v */
    double T[3][3] = {{1 / (u * u), 0, 0},
                      {lean * lean / (u * u * v * v), 1 / (v * v), -lean / (u * v * v)},
                      {-2 * lean / (u * u * v), 0, 1 / (u * v)}};

    if (law->isotropic) {
        isotropic(law, metric[1] / determinant, metric[0] / determinant,
                  -metric[2] / determinant, matrix);
        return;
    }
    law_transform(law->matrix[part], T, matrix);
    for (int k = 0; k < LAW_ENTRIES; k++)
        matrix[k] *= over;
}

void law_shares(const struct law *law, const double metric[3],
                const double matrix[LAW_ENTRIES], double share[2])
{
    double nu = law->poisson, both = metric[0] * metric[1], inverse[LAW_ENTRIES];
    double r = (1 + nu) * metric[2] * metric[2] / both - nu, part = 1 / (1 + fabs(r));

    if (law->isotropic) {
        for (int i = 0; i < 2; i++)
            share[i] = part * law->young / (metric[i] * metric[i]);
        return;
    }
    law_invert(matrix, inverse);
    r = inverse[LAW_12] / sqrt(inverse[LAW_11] * inverse[LAW_22]);
    share[0] = 1 / (1 + fabs(r)) / inverse[LAW_11];
    share[1] = 1 / (1 + fabs(r)) / inverse[LAW_22];
}

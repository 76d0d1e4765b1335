#include "triangles/tri_strain.h"

#include <math.h>
#include <string.h>

/* Share of its rest area below which a triangle counts as having none. */
static const double LEAST_AREA = 1e-8;

static void green(const double C[3], struct tri_strain *s)
{
    s->e[0] = (C[0] - 1) / 2, s->e[1] = (C[1] - 1) / 2, s->e[2] = C[2];
    s->J[0][0] = s->J[1][1] = 0.5, s->J[2][2] = 1;
}

static void baraff_witkin(const double C[3], struct tri_strain *s)
{
    for (int k = 0; k < 2; k++) {
        double length = sqrt(C[k]);
        s->e[k] = length - 1;
        s->J[k][k] = 1 / (2 * length);
        s->H[k][k][k] = -1 / (4 * length * C[k]);
    }
    s->e[2] = C[2], s->J[2][2] = 1;
}

/* Computes U = (C + j I) / t with j = det U = sqrt(det C), t = tr U = sqrt(tr C + 2 j). */
static void corotational(const double C[3], double j, struct tri_strain *s)
{
    static const double PP[3][3] = {{0, 1, 0}, {1, 0, 0}, {0, 0, -2}};
    const double trace[3] = {1, 1, 0}, n[3] = {C[0] + j, C[1] + j, 2 * C[2]};
    const double j1[3] = {C[1] / (2 * j), C[0] / (2 * j), -C[2] / j};
    double t = sqrt(C[0] + C[1] + 2 * j), t1[3];

    for (int l = 0; l < 3; l++)
        t1[l] = (trace[l] + 2 * j1[l]) / (2 * t);
    for (int k = 0; k < 3; k++) {
        double U = n[k] / t;
        s->e[k] = U - (k < 2);
        for (int l = 0; l < 3; l++)
            s->J[k][l] = ((k == l) * (k < 2 ? 1 : 2) + (k < 2 ? j1[l] : 0) - U * t1[l]) / t;
        for (int l = 0; l < 3; l++)
            for (int m = l; m < 3; m++) {
                double j2 = (PP[l][m] / 2 - j1[l] * j1[m]) / j;
                double t2 = (j2 - t1[l] * t1[m]) / t;
                s->H[k][l][m] = s->H[k][m][l] =
                    ((k < 2 ? j2 : 0) - s->J[k][l] * t1[m] - s->J[k][m] * t1[l] - U * t2) /
                    t;
            }
    }
}

bool tri_strain_at(enum membrane membrane, const double C[3], struct tri_strain *s)
{
    double det = C[0] * C[1] - C[2] * C[2];

    memset(s, 0, sizeof *s);
    if (!(det > LEAST_AREA * LEAST_AREA) || !isfinite(det))
        return false;
    if (membrane == MEMBRANE_GREEN)
        green(C, s);
    else if (membrane == MEMBRANE_COROTATIONAL)
        corotational(C, sqrt(det), s);
    else
        baraff_witkin(C, s);
    return true;
}

void tri_strain_stiffness(const struct scene *scene, enum membrane membrane,
                          double D[LAW_ENTRIES])
{
    const struct law law = scene_law(scene);

    memcpy(D, law.matrix[LAW_MEMBRANE], LAW_ENTRIES * sizeof *D);
    if (membrane == MEMBRANE_BARAFF_WITKIN)
        D[LAW_12] = 0;
}

/* solid_green_point.h - work at a Gauss point that solid_green_element.c and
 * solid_green_stiffness.c share; private to them. Both are compiled with
 * -ffp-contract=fast, as solid_element.c is, and for the same reason. */
#ifndef SOLID_GREEN_POINT_H
#define SOLID_GREEN_POINT_H

#include <math.h>
#include <stddef.h>

#include "models/solid/solid_green_room.h"
#include "models/solid/solid_outer.h"

typedef solid_lanes lanes;

/* The place of the tensor component (i, j) among the strains. */
static const int PLACE[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};

/* Computes D[i][j] = sum_a U_ai g_j[a]. */
static inline void gradient(const struct solid_green_element *e, const double *U,
                            const double *g, double D[3][3])
{
    lanes column[3] = {{0}};

    for (int a = 0; a < e->local; a++) {
        lanes u = *(const lanes *)(U + SOLID_LANES * a);
        column[0] += g[a] * u;
        column[1] += g[e->row + a] * u;
        column[2] += g[2 * e->row + a] * u;
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            D[i][j] = column[j][i];
}

static inline void add_unit(double D[3][3])
{
    for (int i = 0; i < 3; i++)
        D[i][i] += 1;
}

/* Computes F of the geometry. */
static inline void deformation(const struct solid_green_element *e, const double *g,
                               double F[3][3])
{
    gradient(e, e->U[1], g, F);
    add_unit(F);
}

static inline void stress_of(const double *E, const struct solid_material *m,
                             const double *n, double S[6])
{
    double trace = E[0] + E[1] + E[2], pressure = m->lambda * trace, across = 0;

    if (n) {
        across = n[0] * (E[0] * n[0] + 2 * E[3] * n[1]) +
                 n[1] * (E[1] * n[1] + 2 * E[4] * n[2]) +
                 n[2] * (E[2] * n[2] + 2 * E[5] * n[0]);
        pressure = m->plane * (trace - across);
    }
    for (int t = 0; t < 6; t++)
        S[t] = 2 * m->mu * E[t] + (t < 3 ? pressure : 0);
    for (int i = 0; n && i < 3; i++)
        for (int j = i; j < 3; j++)
            S[PLACE[i][j]] += (m->across * across - pressure) * n[i] * n[j];
}

/* Returns the normal at a point; NULL for a law that needs none. */
static inline const double *normal_at(const struct solid_green_rest *rest, int q)
{
    return rest->plane_stress ? rest->n + 3 * q : NULL;
}

static inline const double *gradients_at(const struct solid_green_element *e,
                                         const struct solid_green_rest *rest, int q)
{
    return rest->g + (size_t)q * 3 * (size_t)e->row;
}

static inline const double *mode_at(const struct solid_green_element *e,
                                    const struct solid_green_rest *rest, int q, int m)
{
    return rest->mode + 3 * (q * e->modes + m);
}

/* Computes b <- A^-1 b with the Cholesky factor A; A^-T A^-1 b if `both`. */
static inline void solve_modes(int n, const double *A, double *b, bool both)
{
    for (int s = 0; s < n; s++) {
        for (int k = 0; k < s; k++)
            b[s] -= A[SOLID_GREEN_INTERNAL * s + k] * b[k];
        b[s] /= A[SOLID_GREEN_INTERNAL * s + s];
    }
    for (int s = n - 1; both && s >= 0; s--) {
        for (int k = s + 1; k < n; k++)
            b[s] -= A[SOLID_GREEN_INTERNAL * k + s] * b[k];
        b[s] /= A[SOLID_GREEN_INTERNAL * s + s];
    }
}

/* Computes the stress of sym(e_i m^T). */
static inline void mode_stress(const double *m, int i,
                               const struct solid_material *material, double S[6])
{
    double E[6] = {0};

    for (int j = 0; j < 3; j++)
        E[PLACE[i][j]] += i == j ? m[j] : m[j] / 2;
    stress_of(E, material, NULL, S);
}

/* Returns (S m)_i. */
static inline double traction(const double *S, const double *m, int i)
{
    return S[PLACE[i][0]] * m[0] + S[PLACE[i][1]] * m[1] + S[PLACE[i][2]] * m[2];
}

#endif

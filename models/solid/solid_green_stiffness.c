#include "models/solid/solid_green_stiffness.h"

#include <string.h>

#include "models/solid/solid_green_layer.h"
#include "models/solid/solid_green_point.h"

/* Computes p = F g and wp = w F g over the functions. */
static void push(const struct solid_green_element *e, double F[3][3], const double *g,
                 double w, double *restrict p, double *restrict wp)
{
    for (int i = 0; i < 3; i++)
        for (int a = 0; a < e->row; a++) {
            double s =
                F[i][0] * g[a] + F[i][1] * g[e->row + a] + F[i][2] * g[2 * e->row + a];
            p[i * e->row + a] = s;
            wp[i * e->row + a] = w * s;
        }
}

/* Adds weight mu g_a.g_b F F^T + (g_a.S g_b) I to C[a][.][b], from Sg = S g and B = F F^T,
 * both with their weights. */
static void add_symmetric(struct solid_green_element *e, const double *g, const double B[6])
{
    int row = e->row;

    for (int a = 0; a < e->local; a++)
        for (int c = a / SOLID_LANES * SOLID_LANES; c < row; c += SOLID_LANES) {
            double *C = e->C + (size_t)a * 6 * (size_t)row + c;
            lanes metric = g[a] * *(const lanes *)(g + c) +
                           g[row + a] * *(const lanes *)(g + row + c) +
                           g[2 * row + a] * *(const lanes *)(g + 2 * row + c);
            lanes load = g[a] * *(const lanes *)(e->Sg + c) +
                         g[row + a] * *(const lanes *)(e->Sg + row + c) +
                         g[2 * row + a] * *(const lanes *)(e->Sg + 2 * row + c);
            for (int t = 0; t < 6; t++) {
                lanes *to = (lanes *)(C + t * row);
                *to += t < 3 ? B[t] * metric + load : B[t] * metric;
            }
        }
}

/* Computes L, which plane_stress uses in place of lambda: y = F P g and F n (n.g). */
static void split(struct solid_green_element *e, const struct solid_material *material,
                  const struct solid_green_rest *rest)
{
    int row = e->row;

    for (int q = 0; q < rest->points; q++) {
        const double *g = gradients_at(e, rest, q), *n = normal_at(rest, q);
        const double *p = e->p + (size_t)q * 3 * (size_t)row;
        double F[3][3], plane = rest->dV[q] * material->plane;
        double stiff = rest->dV[q] * material->across;

        deformation(e, g, F);
        for (int i = 0; i < 3; i++) {
            double Fn = F[i][0] * n[0] + F[i][1] * n[1] + F[i][2] * n[2];
            double *along = e->y + (size_t)(6 * q + i) * (size_t)row;
            double *across = along + 3 * row, *weighted = e->wy + (along - e->y);
            for (int a = 0; a < row; a++) {
                double normal = n[0] * g[a] + n[1] * g[row + a] + n[2] * g[2 * row + a];
                across[a] = Fn * normal;
                along[a] = p[i * row + a] - across[a];
                weighted[a] = plane * along[a];
                weighted[3 * row + a] = stiff * across[a];
            }
        }
    }
    solid_outer(e->local, e->row, 2 * rest->points, e->wy, e->y, e->L);
}

/* Computes Y = L^-1 of the modes' coupling with the functions, A = L L^T. */
static void couple_modes(struct solid_green_element *e,
                         const struct solid_material *material,
                         const struct solid_green_rest *rest)
{
    int n = 3 * e->modes, columns = 3 * e->row;
    double F[3][3], S[6], P[3][3], column[SOLID_GREEN_INTERNAL];

    memset(e->Y, 0, (size_t)(n * columns) * sizeof *e->Y);
    for (int q = 0; q < rest->points; q++) {
        const double *g = gradients_at(e, rest, q);
        deformation(e, g, F);
        for (int s = 0; s < n; s++) {
            mode_stress(mode_at(e, rest, q, s / 3), s % 3, material, S);
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    P[i][j] = rest->dV[q] * traction(S, F[i], j);
            for (int b = 0; b < e->local; b++)
                for (int i = 0; i < 3; i++)
                    e->Y[s * columns + 3 * b + i] += P[i][0] * g[b] +
                                                     P[i][1] * g[e->row + b] +
                                                     P[i][2] * g[2 * e->row + b];
        }
    }
    for (int c = 0; c < 3 * e->local; c++) {
        for (int s = 0; s < n; s++)
            column[s] = e->Y[s * columns + c];
        solve_modes(n, rest->A, column, false);
        for (int s = 0; s < n; s++)
            e->Y[s * columns + c] = column[s];
    }
}

void solid_green_stiffness_compute(struct solid_green_element *e,
                                   const struct solid_material *material,
                                   const struct solid_green_rest *rest, double stress_share,
                                   double geometry_share)
{
    size_t row = (size_t)e->row;

    if (e->layer) {
        solid_green_layer_stiffness(e, material, &rest->layer, geometry_share);
        return;
    }
    memset(e->C, 0, row * 6 * row * sizeof *e->C);
    for (int q = 0; q < rest->points; q++) {
        const double *g = gradients_at(e, rest, q);
        double F[3][3], S[6], B[6], w = rest->dV[q];

        deformation(e, g, F);
        stress_of(e->strain + 6 * q, material, normal_at(rest, q), S);
        push(e, F, g, w, e->p + (size_t)q * 3 * row, e->wp + (size_t)q * 3 * row);
        for (int i = 0; i < 3; i++)
            for (int j = i; j < 3; j++)
                B[PLACE[i][j]] =
                    stress_share * w * material->mu *
                    (F[i][0] * F[j][0] + F[i][1] * F[j][1] + F[i][2] * F[j][2]);
        for (int i = 0; i < 3; i++)
            for (size_t a = 0; a < row; a++)
                e->Sg[(size_t)i * row + a] =
                    geometry_share * w *
                    (S[PLACE[i][0]] * g[a] + S[PLACE[i][1]] * g[row + a] +
                     S[PLACE[i][2]] * g[2 * row + a]);
        add_symmetric(e, g, B);
    }
    solid_outer(e->local, e->row, rest->points, e->wp, e->p, e->H);
    if (rest->plane_stress)
        split(e, material, rest);
    if (e->modes)
        couple_modes(e, material, rest);
}

void solid_green_stiffness_blocks(const struct solid_green_element *e,
                                  const struct solid_material *material,
                                  double stress_share, int a, int first, int last,
                                  double (*K)[9])
{
    const double *H = e->H + (size_t)a * 9 * (size_t)e->row;
    const double *C = e->C + (size_t)a * 6 * (size_t)e->row;
    double mu = stress_share * material->mu;
    /* the part of lambda: by L if there is one */
    double lambda = stress_share * (e->plane ? 1 : material->lambda);
    const double *G = e->plane ? e->L + (H - e->H) : H;
    int n = 3 * e->row;

    if (e->layer) {
        solid_green_layer_blocks(e, stress_share, a, first, last, K);
        return;
    }
    for (int b = first; b < last; b++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                double k = lambda * G[(3 * i + j) * e->row + b] +
                           mu * H[(3 * j + i) * e->row + b] + C[PLACE[i][j] * e->row + b];
                for (int s = 0; s < 3 * e->modes; s++)
                    k -= stress_share * e->Y[s * n + 3 * a + i] * e->Y[s * n + 3 * b + j];
                K[b - first][3 * i + j] += k;
            }
}

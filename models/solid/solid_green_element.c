#include "models/solid/solid_green_element.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/solid/solid_outer.h"

/* This file is compiled with -ffp-contract=fast, as solid_element.c is and for its reason.
 */

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

static inline void stress_of(const double *E, const struct solid_material *m, double S[6])
{
    const double pressure = m->lambda * (E[0] + E[1] + E[2]);

    for (int t = 0; t < 6; t++)
        S[t] = 2 * m->mu * E[t] + (t < 3 ? pressure : 0);
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
    stress_of(E, material, S);
}

/* Returns (S m)_i. */
static inline double traction(const double *S, const double *m, int i)
{
    return S[PLACE[i][0]] * m[0] + S[PLACE[i][1]] * m[1] + S[PLACE[i][2]] * m[2];
}

void solid_green_element_clear(struct solid_green_element *e)
{
    solid_layer_destroy(e->layer);
    free(e->memory);
    memset(e, 0, sizeof *e);
}

enum status solid_green_element_init(struct solid_green_element *e,
                                     const struct solid_space *space)
{
    enum status st;
    size_t row = SOLID_PADDED((size_t)space->local), gauss = (size_t)space->gauss;
    size_t strains =
        space->layer ? (size_t)solid_layer_strains(space->layer_points) : 6 * gauss;
    memset(e, 0, sizeof *e);
    TRY(room_cut(&e->memory, ROOM(e->U[0], 4 * row), ROOM(e->U[1], 4 * row),
                 ROOM(e->U[2], 4 * row), ROOM(e->f, 4 * row), ROOM(e->p, gauss * 3 * row),
                 ROOM(e->wp, gauss * 3 * row), ROOM(e->Sg, 3 * row),
                 ROOM(e->H, row * 9 * row), ROOM(e->C, row * 6 * row),
                 ROOM(e->Y, 3 * (size_t)space->modes * 3 * row),
                 ROOM(e->strain, (strains + 7) / 8 * 8)));
    e->local = space->local;
    e->row = (int)row;
    e->gauss = space->gauss;
    e->modes = space->modes;
    if (space->layer)
        TRY(solid_layer_create(space, &e->layer));
out:
    return st;
}

/* Adds factor (A^T B + B^T A) / 4 to E. */
static void add_product(double A[3][3], double B[3][3], double factor, double *E)
{
    for (int i = 0; i < 3; i++)
        for (int j = i; j < 3; j++)
            for (int k = 0; k < 3; k++)
                E[PLACE[i][j]] += factor / 4 * (A[k][i] * B[k][j] + B[k][i] * A[k][j]);
}

static double determinant(double F[3][3])
{
    return F[0][0] * (F[1][1] * F[2][2] - F[1][2] * F[2][1]) +
           F[0][1] * (F[1][2] * F[2][0] - F[1][0] * F[2][2]) +
           F[0][2] * (F[1][0] * F[2][1] - F[1][1] * F[2][0]);
}

enum status solid_green_element_modes(const struct solid_green_element *e,
                                      const struct solid_material *material,
                                      const struct solid_green_rest *rest, double *A)
{
    enum { N = SOLID_GREEN_INTERNAL };
    int n = 3 * e->modes;
    double S[6];

    assert(n <= N);
    memset(A, 0, N * N * sizeof *A);
    for (int q = 0; q < e->gauss; q++)
        for (int s = 0; s < n; s++) {
            mode_stress(mode_at(e, rest, q, s / 3), s % 3, material, S);
            for (int t = 0; t <= s; t++)
                A[N * s + t] +=
                    rest->dV[q] * traction(S, mode_at(e, rest, q, t / 3), t % 3);
        }
    for (int s = 0; s < n; s++)
        for (int t = 0; t <= s; t++) {
            double v = A[N * s + t];
            for (int k = 0; k < t; k++)
                v -= A[N * s + k] * A[N * t + k];
            if (s == t && !(v > 0))
                return STATUS_INDEFINITE;
            A[N * s + t] = s == t ? sqrt(v) : v / A[N * t + t];
        }
    return STATUS_OK;
}

/* Adds the strains of the internal modes that make their average stress vanish. */
static void add_modes(struct solid_green_element *e, const struct solid_material *material,
                      const struct solid_green_rest *rest)
{
    int n = 3 * e->modes;
    double alpha[SOLID_GREEN_INTERNAL] = {0}, S[6];

    for (int q = 0; q < e->gauss; q++) {
        stress_of(e->strain + 6 * q, material, S);
        for (int s = 0; s < n; s++)
            alpha[s] -= rest->dV[q] * traction(S, mode_at(e, rest, q, s / 3), s % 3);
    }
    solve_modes(n, rest->A, alpha, true);
    for (int q = 0; q < e->gauss; q++)
        for (int s = 0; s < n; s++)
            for (int j = 0; j < 3; j++)
                e->strain[6 * q + PLACE[s % 3][j]] +=
                    (s % 3 == j ? 1 : 0.5) * alpha[s] * mode_at(e, rest, q, s / 3)[j];
}

bool solid_green_element_strain(struct solid_green_element *e,
                                const struct solid_material *material,
                                const struct solid_green_rest *rest, bool change)
{
    for (int q = 0; q < e->gauss; q++) {
        const double *g = gradients_at(e, rest, q);
        double D[3][3], W[3][3], *E = e->strain + 6 * q;

        gradient(e, e->U[0], g, D);
        for (int i = 0; i < 3; i++)
            for (int j = i; j < 3; j++)
                E[PLACE[i][j]] = (D[i][j] + D[j][i]) / 2;
        add_product(D, D, 1, E);
        add_unit(D);
        if (!(determinant(D) > 0))
            return false;
        if (change) {
            gradient(e, e->U[1], g, W);
            gradient(e, e->U[2], g, D);
            add_product(W, D, -1, E);
        }
    }
    if (e->modes)
        add_modes(e, material, rest);
    return true;
}

double solid_green_element_energy(const struct solid_green_element *e,
                                  const struct solid_material *material,
                                  const struct solid_green_rest *rest)
{
    double energy = 0, S[6];

    for (int q = 0; q < e->gauss; q++) {
        const double *E = e->strain + 6 * q;
        stress_of(E, material, S);
        for (int t = 0; t < 6; t++)
            energy += rest->dV[q] * (t < 3 ? 0.5 : 1) * S[t] * E[t];
    }
    return energy;
}

void solid_green_element_force(struct solid_green_element *e,
                               const struct solid_material *material,
                               const struct solid_green_rest *rest)
{
    lanes *f = (lanes *)e->f;

    memset(e->f, 0, SOLID_LANES * (size_t)e->row * sizeof *e->f);
    for (int q = 0; q < e->gauss; q++) {
        const double *g = gradients_at(e, rest, q);
        double F[3][3], S[6];
        lanes P[3] = {{0}}; /* columns of dV F S */

        deformation(e, g, F);
        stress_of(e->strain + 6 * q, material, S);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                P[j][i] = rest->dV[q] * traction(S, F[i], j);
        for (int a = 0; a < e->local; a++)
            f[a] += g[a] * P[0] + g[e->row + a] * P[1] + g[2 * e->row + a] * P[2];
    }
}

/* --- the tangent -------------------------------------------------------------------------
 */

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

/* Computes Y = L^-1 of the modes' coupling with the functions, A = L L^T. */
static void couple_modes(struct solid_green_element *e,
                         const struct solid_material *material,
                         const struct solid_green_rest *rest, bool moved)
{
    int n = 3 * e->modes, columns = 3 * e->row;
    double F[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, S[6], P[3][3],
           column[SOLID_GREEN_INTERNAL];

    memset(e->Y, 0, (size_t)(n * columns) * sizeof *e->Y);
    for (int q = 0; q < e->gauss; q++) {
        const double *g = gradients_at(e, rest, q);
        if (moved)
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

/* Fills C and H on the moved geometry. */
static void stiffen(struct solid_green_element *e, const struct solid_material *material,
                    const struct solid_green_rest *rest, double stress_share,
                    double geometry_share)
{
    size_t row = (size_t)e->row;

    memset(e->C, 0, row * 6 * row * sizeof *e->C);
    for (int q = 0; q < e->gauss; q++) {
        const double *g = gradients_at(e, rest, q);
        double F[3][3], S[6], B[6], w = rest->dV[q];

        deformation(e, g, F);
        stress_of(e->strain + 6 * q, material, S);
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
    solid_outer(e->local, e->row, e->gauss, e->wp, e->p, e->H);
}

/* Fills C and H at rest, where what is symmetric is the trace of H. */
static void stiffen_rest(struct solid_green_element *e, double mu,
                         const struct solid_green_rest *rest)
{
    const int row = e->row;

    for (int q = 0; q < e->gauss; q++)
        for (int n = 0; n < 3 * row; n += SOLID_LANES)
            *(lanes *)(e->wp + q * 3 * row + n) =
                rest->dV[q] * *(const lanes *)(rest->g + q * 3 * row + n);
    solid_outer(e->local, row, e->gauss, e->wp, rest->g, e->H);
    for (int a = 0; a < e->local; a++)
        for (int b = a / SOLID_LANES * SOLID_LANES; b < row; b += SOLID_LANES) {
            const lanes *H = (const lanes *)(e->H + a * 9 * row + b);
            lanes *C = (lanes *)(e->C + a * 6 * row + b);
            const int next = row / SOLID_LANES;
            C[0] = C[next] = C[2 * next] = mu * (H[0] + H[4 * next] + H[8 * next]);
            C[3 * next] = C[4 * next] = C[5 * next] = (lanes){0};
        }
}

void solid_green_element_stiffness(struct solid_green_element *e,
                                   const struct solid_material *material,
                                   const struct solid_green_rest *rest, double stress_share,
                                   double geometry_share)
{
    const bool moved = geometry_share > 0;

    if (moved)
        stiffen(e, material, rest, stress_share, geometry_share);
    else
        stiffen_rest(e, stress_share * material->mu, rest);
    if (e->modes)
        couple_modes(e, material, rest, moved);
}

/* Subtracts the internal modes' part of K_ab from k. */
static inline void subtract_modes(const struct solid_green_element *e, double share, int a,
                                  int b, double k[9])
{
    for (int s = 0; s < 3 * e->modes; s++) {
        const double *Y = e->Y + s * 3 * e->row, *y = Y + 3 * b;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                k[3 * i + j] -= share * Y[3 * a + i] * y[j];
    }
}

void solid_green_element_blocks(const struct solid_green_element *e,
                                const struct solid_material *material, double stress_share,
                                int a, int first, int last, double (*K)[9])
{
    const double *H = e->H + (size_t)a * 9 * (size_t)e->row;
    const double *C = e->C + (size_t)a * 6 * (size_t)e->row;
    double mu = stress_share * material->mu, lambda = stress_share * material->lambda;

    for (int c = first / SOLID_LANES * SOLID_LANES; c < last; c += SOLID_LANES) {
        lanes k[9];
        for (int t = 0; t < 9; t++) { /* 3 i + j and its transpose 3 j + i */
            const int i = t / 3, j = t % 3;
            k[t] = lambda * *(const lanes *)(H + t * e->row + c) +
                   mu * *(const lanes *)(H + (3 * j + i) * e->row + c) +
                   *(const lanes *)(C + PLACE[i][j] * e->row + c);
        }
        for (int b = first > c ? first : c; b < last && b < c + SOLID_LANES; b++) {
            double sum[9];
            for (int t = 0; t < 9; t++)
                sum[t] = k[t][b - c];
            subtract_modes(e, stress_share, a, b, sum);
            for (int t = 0; t < 9; t++)
                K[b - first][t] += sum[t];
        }
    }
}

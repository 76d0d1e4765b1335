#include "models/solid/solid_green_element.h"
#include "models/room.h"
#include "models/solid/solid_green_layer.h"
#include "models/solid/solid_green_point.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    size_t plane = space->plane_stress;
    size_t strains =
        space->layer ? (size_t)solid_layer_strains(space->layer_points) : 6 * gauss;
    memset(e, 0, sizeof *e);
    TRY(room_cut(
        &e->memory, ROOM(e->U[0], 4 * row), ROOM(e->U[1], 4 * row), ROOM(e->U[2], 4 * row),
        ROOM(e->f, 4 * row), ROOM(e->p, gauss * 3 * row), ROOM(e->wp, gauss * 3 * row),
        ROOM(e->Sg, 3 * row), ROOM(e->H, row * 9 * row), ROOM(e->C, row * 6 * row),
        ROOM(e->Y, 3 * (size_t)space->modes * 3 * row), ROOM(e->y, plane * 6 * gauss * row),
        ROOM(e->wy, plane * 6 * gauss * row), ROOM(e->L, plane * row * 9 * row),
        ROOM(e->strain, (strains + 7) / 8 * 8)));
    e->local = space->local;
    e->row = (int)row;
    e->gauss = space->gauss;
    e->modes = space->modes;
    e->plane = space->plane_stress;
    if (space->layer)
        TRY(solid_layer_create(space, &e->layer));
out:
    if (st != STATUS_OK)
        solid_green_element_clear(e);
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

void solid_green_element_modes(const struct solid_green_element *e,
                               const struct solid_material *material,
                               const struct solid_green_rest *rest, double *A)
{
    enum { N = SOLID_GREEN_INTERNAL };
    int n = 3 * e->modes;
    double S[6];

    assert(n <= N);
    memset(A, 0, N * N * sizeof *A);
    for (int q = 0; q < rest->points; q++)
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
            A[N * s + t] = s == t ? sqrt(v) : v / A[N * t + t];
        }
}

/* Adds the strains of the internal modes that make their average stress vanish. */
static void add_modes(struct solid_green_element *e, const struct solid_material *material,
                      const struct solid_green_rest *rest)
{
    int n = 3 * e->modes;
    double alpha[SOLID_GREEN_INTERNAL] = {0}, S[6];

    for (int q = 0; q < rest->points; q++) {
        stress_of(e->strain + 6 * q, material, NULL, S);
        for (int s = 0; s < n; s++)
            alpha[s] -= rest->dV[q] * traction(S, mode_at(e, rest, q, s / 3), s % 3);
    }
    solve_modes(n, rest->A, alpha, true);
    for (int q = 0; q < rest->points; q++)
        for (int s = 0; s < n; s++)
            for (int j = 0; j < 3; j++)
                e->strain[6 * q + PLACE[s % 3][j]] +=
                    (s % 3 == j ? 1 : 0.5) * alpha[s] * mode_at(e, rest, q, s / 3)[j];
}

bool solid_green_element_strain(struct solid_green_element *e,
                                const struct solid_material *material,
                                const struct solid_green_rest *rest, bool change)
{
    if (e->layer)
        return solid_green_layer_strain(e, &rest->layer, change);
    for (int q = 0; q < rest->points; q++) {
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

    if (e->layer)
        return solid_green_layer_energy(e, material, &rest->layer);
    for (int q = 0; q < rest->points; q++) {
        const double *E = e->strain + 6 * q;
        stress_of(E, material, normal_at(rest, q), S);
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

    if (e->layer) {
        solid_green_layer_force(e, material, &rest->layer);
        return;
    }
    memset(e->f, 0, SOLID_LANES * (size_t)e->row * sizeof *e->f);
    for (int q = 0; q < rest->points; q++) {
        const double *g = gradients_at(e, rest, q);
        double F[3][3], S[6];
        lanes P[3] = {{0}}; /* columns of dV F S */

        deformation(e, g, F);
        stress_of(e->strain + 6 * q, material, normal_at(rest, q), S);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                P[j][i] = rest->dV[q] * traction(S, F[i], j);
        for (int a = 0; a < e->local; a++)
            f[a] += g[a] * P[0] + g[e->row + a] * P[1] + g[2 * e->row + a] * P[2];
    }
}

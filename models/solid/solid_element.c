#include "models/solid/solid_element.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/solid/solid_hinge.h"
#include "models/solid/solid_layer.h"
#include "models/solid/solid_outer.h"
#include "models/vector.h"

/* This file is compiled with -ffp-contract=fast (see CMakeLists.txt): its loops are nothing
 * but multiply-adds, and fused ones are twice as fast. */

typedef solid_lanes lanes;
_Static_assert(SOLID_LANES == 4, "a gathered position is one vector: x, y, z, 0");

static struct solid_material fabric(const struct law *law, double density)
{
    static const double flat[] = {1, 1, 0};
    const double *A = law->matrix[LAW_MEMBRANE];
    struct solid_material m = {.density = density, .is_fabric = true};

    m.mu = sqrt(A[LAW_11] * A[LAW_22]) / law->thickness / 2;
    for (int part = 0; part < LAW_PARTS; part++)
        law_on_surface(law, (enum law_part)part, flat, 1, m.fabric[part]);
    law_shares(law, flat, m.fabric[LAW_MEMBRANE], m.share);
    return m;
}

struct solid_material solid_element_material(const struct law *law, double density)
{
    double young = law->young, poisson = law->poisson;

    if (!law->isotropic)
        return fabric(law, density);
    return (struct solid_material){
        .lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson)),
        .mu = young / (2 * (1 + poisson)),
        .plane = young * poisson / (1 - poisson * poisson),
        .across = young - young / (1 + poisson),
        .density = density,
    };
}

void solid_element_clear(struct solid_element *e)
{
    solid_layer_destroy(e->layer);
    free(e->memory);
    memset(e, 0, sizeof *e);
}

enum status solid_element_init(struct solid_element *e, const struct solid_space *space)
{
    enum status st;
    size_t local = (size_t)space->local, gauss = (size_t)space->gauss;
    size_t columns = local + (size_t)space->modes;
    size_t padded = SOLID_PADDED(columns), row = SOLID_PADDED(local);

    memset(e, 0, sizeof *e);
    TRY(room_cut(
        &e->memory, ROOM(e->shape.N, gauss * row), ROOM(e->shape.G, gauss * 3 * row),
        ROOM(e->shape.weight, SOLID_PADDED(gauss)), ROOM(e->X, 4 * local),
        ROOM(e->centre, space->modes ? 3 * row : 0), ROOM(e->g, gauss * 3 * padded),
        ROOM(e->wg, gauss * 3 * padded), ROOM(e->dV, SOLID_PADDED(gauss)),
        ROOM(e->wN, gauss * row),
        ROOM(e->H, padded * 9 * padded) /* rows in pairs: one more than columns */,
        ROOM(e->M, local * row), ROOM(e->volume, row), ROOM(e->K, columns * padded * 9)));
    e->local = space->local;
    e->row = (int)row;
    e->padded = (int)padded;
    e->gauss = space->gauss;
    e->modes = space->modes;
    if (space->layer)
        TRY(solid_layer_create(space, &e->layer));
out:
    if (st != STATUS_OK)
        solid_element_clear(e);
    return st;
}

/* Computes J[j] = sum_a X_a N_a,j, its cofactors and det J; G's rows are `row` apart. */
static double jacobian(int local, int row, const double *X, const double *G,
                       double cofactor[3][3])
{
    lanes column[3] = {{0}};
    double J[3][SOLID_LANES];

    for (int a = 0; a < local; a++) {
        lanes x = *(const lanes *)(X + SOLID_LANES * a);
        column[0] += G[a] * x;
        column[1] += G[row + a] * x;
        column[2] += G[2 * row + a] * x;
    }
    memcpy(J, column, sizeof J);
    for (int j = 0; j < 3; j++)
        vector_cross(J[(j + 1) % 3], J[(j + 2) % 3], cofactor[j]);
    return J[0][0] * cofactor[0][0] + J[0][1] * cofactor[0][1] + J[0][2] * cofactor[0][2];
}

/* Computes T = J^-T. Returns det J. */
static double inverse_jacobian(int local, int row, const double *X, const double *G,
                               double T[3][3])
{
    double cofactor[3][3], det = jacobian(local, row, X, G, cofactor);

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[i][j] = cofactor[j][i] / det;
    return det;
}

/* Computes g_i = scale sum_j T_ij G_j and wg_i = dV g_i for `count` columns. */
static void push_forward(int count, double T[3][3], double scale, const double *G,
                         int G_row, double dV, double *restrict g, double *restrict wg,
                         int g_row)
{
    for (int i = 0; i < 3; i++) {
        double t0 = scale * T[i][0], t1 = scale * T[i][1], t2 = scale * T[i][2];
        for (int a = 0; a < count; a++) {
            double s = t0 * G[a] + t1 * G[G_row + a] + t2 * G[2 * G_row + a];
            g[i * g_row + a] = s;
            wg[i * g_row + a] = dV * s;
        }
    }
}

static enum status bad_jacobian(double det)
{
    return isnan(det) ? STATUS_NAN : STATUS_INVERTED;
}

/* Computes gradients at every Gauss point; internal modes are behind the functions. */
static enum status physical_gradients(struct solid_element *e,
                                      const struct solid_space *space, int element)
{
    int width = e->modes ? e->local : e->row;
    double centre[3][3], centre_det = 0;

    if (e->modes) {
        memcpy(e->centre, space->centre_gradient, 3 * (size_t)e->row * sizeof *e->centre);
        solid_hinge_functions(space, element, 3, e->row, e->centre);
        centre_det = inverse_jacobian(e->local, e->row, e->X, e->centre, centre);
        if (!(centre_det > 0))
            return bad_jacobian(centre_det);
    }
    for (int q = 0; q < e->gauss; q++) {
        const double *G = e->shape.G + (size_t)q * 3 * (size_t)e->row;
        double *g = e->g + (size_t)q * 3 * (size_t)e->padded;
        double *wg = e->wg + (size_t)q * 3 * (size_t)e->padded;
        double T[3][3], det = inverse_jacobian(e->local, e->row, e->X, G, T);

        if (!(det > 0))
            return bad_jacobian(det);
        e->dV[q] = e->shape.weight[q] * det;
        push_forward(width, T, 1, G, e->row, e->dV[q], g, wg, e->padded);
        if (e->modes) /* scaled so that their gradients integrate to zero: patch test */
            push_forward(e->modes, centre, centre_det / det,
                         space->mode_gradient + (size_t)q * 3 * (size_t)e->modes, e->modes,
                         e->dV[q], g + e->local, wg + e->local, e->padded);
    }
    return STATUS_OK;
}

/* Computes dV alone. */
static enum status volumes(struct solid_element *e)
{
    for (int q = 0; q < e->gauss; q++) {
        double cofactor[3][3],
            det = jacobian(e->local, e->row, e->X, e->shape.G + q * 3 * e->row, cofactor);
        if (!(det > 0))
            return bad_jacobian(det);
        e->dV[q] = e->shape.weight[q] * det;
    }
    return STATUS_OK;
}

/* Unpacks blocks of four columns, row-major, from their entries. */
static void unpack(const lanes k[9], double *K)
{
    for (int b = 0; b < SOLID_LANES; b++)
        for (int t = 0; t < 9; t++)
            K[9 * b + t] = k[t][b];
}

/* Computes K_ab from H_ab, four b at a time. */
static void stiffness(struct solid_element *e, const struct solid_material *material)
{
    double lambda = material->lambda, mu = material->mu;
    int rows = e->local + e->modes, n = e->padded;

    for (int a = 0; a < rows; a++)
        for (int c = a / SOLID_LANES * SOLID_LANES; c < n; c += SOLID_LANES) {
            const double *H = e->H + (size_t)a * 9 * (size_t)n + c;
            double *K = e->K + ((size_t)a * (size_t)n + (size_t)c) * 9;
            lanes h[9], k[9];

            for (int t = 0; t < 9; t++)
                h[t] = *(const lanes *)(H + t * n);
            for (int t = 0; t < 9; t++) /* 3 i + j and its transpose 3 j + i */
                k[t] = lambda * h[t] + mu * h[t % 3 * 3 + t / 3];
            lanes shear = mu * (h[0] + h[4] + h[8]);
            k[0] += shear, k[4] += shear, k[8] += shear;
            unpack(k, K);
        }
}

static void mass(struct solid_element *e, double density)
{
    int chunks = e->row / SOLID_LANES;

    for (int q = 0; q < e->gauss; q++)
        for (int a = 0; a < e->row; a++)
            e->wN[q * e->row + a] = density * e->dV[q] * e->shape.N[q * e->row + a];
    for (int a = 0; a < e->local; a++)
        for (int c = a / SOLID_LANES; c < chunks; c++) {
            const double *N = e->shape.N + c * SOLID_LANES, *wN = e->wN + a;
            lanes s = {0};
            for (int q = 0; q < e->gauss; q++, N += e->row, wN += e->row)
                s += *wN * *(const lanes *)N;
            *(lanes *)(e->M + (size_t)a * (size_t)e->row + c * SOLID_LANES) = s;
        }
    for (int c = 0; c < chunks; c++) {
        const double *N = e->shape.N + c * SOLID_LANES;
        lanes s = {0};
        for (int q = 0; q < e->gauss; q++, N += e->row)
            s += e->dV[q] * *(const lanes *)N;
        *(lanes *)(e->volume + c * SOLID_LANES) = s;
    }
}

/* Internal modes are a hexahedron's: three of them, eight functions. */
enum { MODES_MAX = 3, INTERNAL_MAX = 3 * MODES_MAX, CONDENSED_MAX = 3 * 8 };

/* Returns entry (mode m, component i; column b, component j) of the modes' stiffness. */
static double internal_entry(const struct solid_element *e, int m, int i, int b, int j)
{
    size_t row = (size_t)e->padded, p = (size_t)(e->local + m), c = (size_t)b;

    return c < p ? e->K[(c * row + p) * 9 + (size_t)(3 * j + i)]
                 : e->K[(p * row + c) * 9 + (size_t)(3 * i + j)];
}

/* Computes the Cholesky factor of the internal stiffness B, definite where det J > 0. */
static enum status internal_factor(const struct solid_element *e,
                                   double L[INTERNAL_MAX][INTERNAL_MAX])
{
    for (int s = 0; s < 3 * e->modes; s++)
        for (int t = 0; t <= s; t++) {
            double v = internal_entry(e, s / 3, s % 3, e->local + t / 3, t % 3);
            for (int k = 0; k < t; k++)
                v -= L[s][k] * L[t][k];
            if (s == t && !(v > 0))
                return STATUS_INDEFINITE;
            L[s][t] = s == t ? sqrt(v) : v / L[t][t];
        }
    return STATUS_OK;
}

/* Computes K_ab -= K_ai B^-1 K_ib: with Y = L^-1 K_ib, K -= Y^T Y. */
static enum status condense(struct solid_element *e)
{
    double L[INTERNAL_MAX][INTERNAL_MAX], Y[INTERNAL_MAX][CONDENSED_MAX];
    int n = 3 * e->modes, columns = 3 * e->local;

    assert(e->modes <= MODES_MAX && columns <= CONDENSED_MAX);
    if (internal_factor(e, L) != STATUS_OK)
        return STATUS_INDEFINITE;
    for (int c = 0; c < columns; c++)
        for (int s = 0; s < n; s++) {
            double v = internal_entry(e, s / 3, s % 3, c / 3, c % 3);
            for (int k = 0; k < s; k++)
                v -= L[s][k] * Y[k][c];
            Y[s][c] = v / L[s][s];
        }
    for (int a = 0; a < e->local; a++)
        for (int b = a; b < e->local; b++) {
            double *K = e->K + ((size_t)a * (size_t)e->padded + (size_t)b) * 9;
            for (int ij = 0; ij < 9; ij++)
                for (int s = 0; s < n; s++)
                    K[ij] -= Y[s][3 * a + ij / 3] * Y[s][3 * b + ij % 3];
        }
    return STATUS_OK;
}

/* Computes K of one layer as a plate. */
static enum status layer_stiffness(struct solid_element *e, const struct solid_space *space,
                                   int element, const struct solid_material *material)
{
    struct solid_layer *s = e->layer;
    enum status st = solid_layer_place(s, space, element, e->X);
    const struct solid_layer_rest rest = solid_layer_placed(s);
    double vectors[SOLID_LAYER_VECTORS][3];
    int strains = 0, n = e->padded;

    if (st != STATUS_OK)
        return st;
    for (int q = 0; q < solid_layer_points(rest.points); q++) {
        memcpy(vectors, rest.t + q * SOLID_LAYER_VECTORS * 3, sizeof vectors);
        strains += solid_layer_vary(s, &rest, q, vectors, material, strains);
    }
    solid_outer(e->local, n, strains, s->wb, s->b, e->H);
    for (int a = 0; a < e->local; a++)
        for (int c = a / SOLID_LANES * SOLID_LANES; c < n; c += SOLID_LANES) {
            const double *H = e->H + a * 9 * n + c;
            lanes k[9];
            for (int t = 0; t < 9; t++)
                k[t] = *(const lanes *)(H + t * n);
            unpack(k, e->K + (a * n + c) * 9);
        }
    return STATUS_OK;
}

static void hinge(struct solid_element *e, const struct solid_space *space, int element,
                  int points)
{
    solid_hinge_functions(space, element, points, e->row, e->shape.N);
    solid_hinge_functions(space, element, 3 * points, e->row, e->shape.G);
}

enum status solid_element_compute(struct solid_element *e, const struct solid_space *space,
                                  int element, const struct solid_material *material,
                                  const double *x)
{
    const int *node = space->ien + (size_t)element * (size_t)space->local;
    enum status st;

    space->functions(space, element, &e->shape);
    hinge(e, space, element, e->gauss);
    for (int a = 0; a < e->local; a++)
        for (int i = 0; i < 3; i++)
            e->X[SOLID_LANES * a + i] = x[3 * (size_t)node[a] + (size_t)i];
    st = space->layer ? volumes(e) : physical_gradients(e, space, element);
    if (st != STATUS_OK)
        return st;
    mass(e, material->density);
    if (space->layer)
        return layer_stiffness(e, space, element, material);
    solid_outer(e->local + e->modes, e->padded, e->gauss, e->wg, e->g, e->H);
    stiffness(e, material);
    return e->modes ? condense(e) : STATUS_OK;
}

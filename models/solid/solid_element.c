#include "models/solid/solid_element.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* This file is compiled with -ffp-contract=fast (see CMakeLists.txt): its loops are nothing
 * but multiply-adds, and fused ones are twice as fast. */

typedef double lanes __attribute__((vector_size(SOLID_LANES * sizeof(double))));

struct solid_material solid_element_material(double young, double poisson, double density)
{
    return (struct solid_material){
        .lambda = young * poisson / ((1 + poisson) * (1 - 2 * poisson)),
        .mu = young / (2 * (1 + poisson)),
        .density = density,
    };
}

enum status solid_element_init(struct solid_element *e, const struct solid_space *space)
{
    size_t local = (size_t)space->local, gauss = (size_t)space->gauss;
    size_t columns = local + (size_t)space->modes;
    size_t padded = SOLID_PADDED(columns), row = SOLID_PADDED(local);
    const struct {
        double **part;
        size_t count;
    } room[] = {
        {&e->shape.N, gauss * row},
        {&e->shape.G, gauss * 3 * row},
        {&e->shape.weight, SOLID_PADDED(gauss)},
        {&e->X, 3 * row},
        {&e->g, gauss * 3 * padded},
        {&e->wg, gauss * 3 * padded},
        {&e->dV, SOLID_PADDED(gauss)},
        {&e->H, columns * 9 * padded},
        {&e->M, local * row},
        {&e->volume, row},
        {&e->K, columns * padded * 9},
    };
    size_t total = 0, parts = sizeof room / sizeof *room;

    memset(e, 0, sizeof *e);
    for (size_t t = 0; t < parts; t++)
        total += room[t].count;
    total = (total + 7) / 8 * 8; /* aligned_alloc wants multiples of the 64 bytes */
    e->memory = aligned_alloc(64, total * sizeof(double));
    if (!e->memory)
        return STATUS_MEMORY;
    memset(e->memory, 0, total * sizeof(double));
    double *next = e->memory;
    for (size_t t = 0; t < parts; next += room[t++].count)
        *room[t].part = next;
    e->local = space->local;
    e->row = (int)row;
    e->padded = (int)padded;
    e->gauss = space->gauss;
    e->modes = space->modes;
    return STATUS_OK;
}

void solid_element_clear(struct solid_element *e)
{
    if (!e)
        return;
    free(e->memory);
    memset(e, 0, sizeof *e);
}

static double sum_lanes(const lanes *s)
{
    const lanes v = *s;

    return (v[0] + v[2]) + (v[1] + v[3]);
}

/* T = J^-T with J_ij = sum_a X_ai N_a,j over `row` columns. Returns det J. */
static double inverse_jacobian(int row, const double *X, const double *G, double T[3][3])
{
    double J[3][3], det;

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const lanes *x = (const lanes *)(X + i * row);
            const lanes *d = (const lanes *)(G + j * row);
            lanes s = {0};
            for (int c = 0; c < row / SOLID_LANES; c++)
                s += x[c] * d[c];
            J[i][j] = sum_lanes(&s);
        }
    for (int i = 0; i < 3; i++) /* cofactors */
        for (int j = 0; j < 3; j++) {
            int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            T[i][j] = J[i1][j1] * J[i2][j2] - J[i1][j2] * J[i2][j1];
        }
    det = J[0][0] * T[0][0] + J[0][1] * T[0][1] + J[0][2] * T[0][2];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[i][j] /= det;
    return det;
}

/* g_i = scale sum_j T_ij G_j and wg_i = dV g_i for `count` columns. */
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

/* Physical gradients at every Gauss point; internal modes behind the functions. */
static enum status physical_gradients(struct solid_element *e,
                                      const struct solid_space *space)
{
    int width = e->modes ? e->local : e->row;
    double centre[3][3], centre_det = 0;

    if (e->modes) {
        centre_det = inverse_jacobian(e->row, e->X, space->centre_gradient, centre);
        if (!(centre_det > 0))
            return bad_jacobian(centre_det);
    }
    for (int q = 0; q < e->gauss; q++) {
        const double *G = e->shape.G + (size_t)q * 3 * (size_t)e->row;
        double *g = e->g + (size_t)q * 3 * (size_t)e->padded;
        double *wg = e->wg + (size_t)q * 3 * (size_t)e->padded;
        double T[3][3], det = inverse_jacobian(e->row, e->X, G, T);

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

/* H[a][3 i + j][b] = sum_q wg_i[a] g_j[b], from the lanes that hold b = a on. */
static void outer_gradients(struct solid_element *e)
{
    int rows = e->local + e->modes, chunks = e->padded / SOLID_LANES;
    size_t stride = 3 * (size_t)e->padded;

    for (int a = 0; a < rows; a++)
        for (int c = a / SOLID_LANES; c < chunks; c++) {
            const double *wg = e->wg + a;
            const double *g = e->g + c * SOLID_LANES;
            double *H = e->H + (size_t)a * 9 * (size_t)e->padded + c * SOLID_LANES;
            lanes s[9] = {{0}};

            for (int q = 0; q < e->gauss; q++, wg += stride, g += stride) {
                lanes g0 = *(const lanes *)g, g1 = *(const lanes *)(g + e->padded),
                      g2 = *(const lanes *)(g + 2 * e->padded);
                double w0 = wg[0], w1 = wg[e->padded], w2 = wg[2 * e->padded];
                s[0] += w0 * g0, s[1] += w0 * g1, s[2] += w0 * g2;
                s[3] += w1 * g0, s[4] += w1 * g1, s[5] += w1 * g2;
                s[6] += w2 * g0, s[7] += w2 * g1, s[8] += w2 * g2;
            }
            for (int n = 0; n < 9; n++)
                *(lanes *)(H + n * e->padded) = s[n];
        }
}

static void stiffness(struct solid_element *e, const struct solid_material *material)
{
    double lambda = material->lambda, mu = material->mu;
    int rows = e->local + e->modes, n = e->padded;

    for (int a = 0; a < rows; a++) {
        const double *H = e->H + (size_t)a * 9 * (size_t)n;
        double *K = e->K + (size_t)a * (size_t)n * 9;
        for (int b = a; b < rows; b++) {
            double shear = mu * (H[b] + H[4 * n + b] + H[8 * n + b]);
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    K[9 * b + 3 * i + j] =
                        lambda * H[(3 * i + j) * n + b] + mu * H[(3 * j + i) * n + b];
            K[9 * b] += shear, K[9 * b + 4] += shear, K[9 * b + 8] += shear;
        }
    }
}

static void mass(struct solid_element *e, double density)
{
    int chunks = e->row / SOLID_LANES;

    for (int a = 0; a < e->local; a++)
        for (int c = a / SOLID_LANES; c < chunks; c++) {
            const double *N = e->shape.N;
            lanes s = {0};
            for (int q = 0; q < e->gauss; q++, N += e->row)
                s += (density * e->dV[q] * N[a]) * *(const lanes *)(N + c * SOLID_LANES);
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

/* Entry (mode m, component i; column b, component j) of the stiffness with its modes. */
static double internal_entry(const struct solid_element *e, int m, int i, int b, int j)
{
    size_t row = (size_t)e->padded, p = (size_t)(e->local + m), c = (size_t)b;

    return c < p ? e->K[(c * row + p) * 9 + (size_t)(3 * j + i)]
                 : e->K[(p * row + c) * 9 + (size_t)(3 * i + j)];
}

/* Cholesky factor of the internal stiffness B, positive definite where det J > 0. */
static void internal_factor(const struct solid_element *e,
                            double L[INTERNAL_MAX][INTERNAL_MAX])
{
    for (int s = 0; s < 3 * e->modes; s++)
        for (int t = 0; t <= s; t++) {
            double v = internal_entry(e, s / 3, s % 3, e->local + t / 3, t % 3);
            for (int k = 0; k < t; k++)
                v -= L[s][k] * L[t][k];
            L[s][t] = s == t ? sqrt(v) : v / L[t][t];
        }
}

/* K_ab -= K_ai B^-1 K_ib: with Y = L^-1 K_ib, K -= Y^T Y. */
static void condense(struct solid_element *e)
{
    double L[INTERNAL_MAX][INTERNAL_MAX], Y[INTERNAL_MAX][CONDENSED_MAX];
    int n = 3 * e->modes, columns = 3 * e->local;

    assert(e->modes <= MODES_MAX && columns <= CONDENSED_MAX);
    internal_factor(e, L);
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
}

enum status solid_element_compute(struct solid_element *e, const struct solid_space *space,
                                  int element, const struct solid_material *material,
                                  const double *x)
{
    const int *node = space->ien + (size_t)element * (size_t)space->local;
    enum status st;

    space->functions(space, element, &e->shape);
    for (int a = 0; a < e->local; a++)
        for (int i = 0; i < 3; i++)
            e->X[i * e->row + a] = x[3 * (size_t)node[a] + (size_t)i];
    st = physical_gradients(e, space);
    if (st != STATUS_OK)
        return st;
    outer_gradients(e);
    stiffness(e, material);
    if (e->modes)
        condense(e);
    mass(e, material->density);
    return STATUS_OK;
}

#include "models/solid/solid_batch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"

/* This file is compiled with -ffp-contract=fast, as solid_element.c is. */

#if defined(__AVX512VL__)
enum { LANES = 8 };
#elif defined(__AVX__)
enum { LANES = 4 };
#else
enum { LANES = 2 };
#endif

typedef double lanes __attribute__((vector_size(LANES * sizeof(double))));

enum { ROWS = 2 }; /* functions of a pass: they share the loads of the others          */

struct solid_batch {
    const struct solid_space *space;
    int order[3], points[3]; /* functions and points of the lines                      */
    lanes *line[3];          /* [points][2][order] values and slopes                   */
    lanes *weight[3];        /* [points]                                               */
    lanes *X;                /* [local][3]         geometry                      [m]   */
    lanes *G;                /* [3][local]         parametric gradients of one point   */
    lanes *N;                /* [local][gauss]     values                              */
    lanes *g;                /* [local][gauss][3]  physical gradients            [1/m] */
    lanes *dV;               /* [gauss]            weight det J                  [m^3] */
    lanes *w;                /* [gauss][ROWS][4] g dV and N rho dV of a pass           */
    void *room;
};

void solid_batch_destroy(struct solid_batch *b)
{
    if (b)
        free(b->room);
    free(b);
}

enum status solid_batch_create(const struct solid_space *space, struct solid_batch **out)
{
    const size_t local = (size_t)space->local, gauss = (size_t)space->gauss;
    size_t size[3], points[3];
    struct solid_batch *b;
    enum status st;

    if (!space->line || space->layer || space->hinge.column)
        return STATUS_OK;
    if (!(b = calloc(1, sizeof *b)))
        return STATUS_MEMORY;
    b->space = space;
    for (int i = 0; i < 3; i++) {
        const struct solid_line line = space->line(space, 0, i);
        b->order[i] = line.order, b->points[i] = line.points;
        points[i] = (size_t)line.points, size[i] = 2 * points[i] * (size_t)line.order;
    }
    TRY(room_cut(&b->room, ROOM(b->line[0], size[0]), ROOM(b->line[1], size[1]),
                 ROOM(b->line[2], size[2]), ROOM(b->weight[0], points[0]),
                 ROOM(b->weight[1], points[1]), ROOM(b->weight[2], points[2]),
                 ROOM(b->X, 3 * local), ROOM(b->G, 3 * local), ROOM(b->N, local * gauss),
                 ROOM(b->g, 3 * local * gauss), ROOM(b->dV, gauss),
                 ROOM(b->w, 4 * ROWS * gauss)));
    *out = b, b = NULL;
out:
    solid_batch_destroy(b);
    return st;
}

/* Gathers lines and geometry; lanes beyond `count` repeat the last element. */
static void gather(struct solid_batch *b, int count, const int *element, const double *x)
{
    const struct solid_space *space = b->space;

    for (int l = 0; l < LANES; l++) {
        const int e = element[l < count ? l : count - 1];
        const int *node = space->ien + (size_t)e * (size_t)space->local;
        for (int i = 0; i < 3; i++) {
            const struct solid_line line = space->line(space, e, i);
            for (int t = 0; t < 2 * line.points * line.order; t++)
                b->line[i][t][l] = line.value[t];
            for (int q = 0; q < line.points; q++)
                b->weight[i][q][l] = line.weight[q];
        }
        for (int a = 0; a < space->local; a++)
            for (int i = 0; i < 3; i++)
                b->X[3 * a + i][l] = x[3 * (size_t)node[a] + (size_t)i];
    }
}

/* Computes N and the parametric gradients at point q[3], number `point`. */
static void functions(struct solid_batch *b, const int q[3], int point)
{
    const lanes *V[3], *dV[3];
    const int local = b->space->local, gauss = b->space->gauss;
    int a = 0;

    for (int i = 0; i < 3; i++)
        V[i] = b->line[i] + 2 * q[i] * b->order[i], dV[i] = V[i] + b->order[i];
    for (int u = 0; u < b->order[0]; u++)
        for (int v = 0; v < b->order[1]; v++)
            for (int w = 0; w < b->order[2]; w++, a++) {
                const lanes both = V[1][v] * V[2][w];
                b->N[a * gauss + point] = V[0][u] * both;
                b->G[a] = dV[0][u] * both;
                b->G[local + a] = V[0][u] * (dV[1][v] * V[2][w]);
                b->G[2 * local + a] = V[0][u] * (V[1][v] * dV[2][w]);
            }
}

/* Pushes the gradients at a point forward to g; returns det J. */
static lanes push_forward(struct solid_batch *b, int point)
{
    const int local = b->space->local, gauss = b->space->gauss;
    const lanes *G = b->G;
    lanes J[3][3] = {{{0}}}, cofactor[3][3], T[3][3], det;

    for (int a = 0; a < local; a++)
        for (int j = 0; j < 3; j++)
            for (int i = 0; i < 3; i++)
                J[j][i] += G[j * local + a] * b->X[3 * a + i];
    for (int j = 0, k = 1, l = 2; j < 3; j++, k = l, l = (l + 1) % 3)
        for (int i = 0, m = 1, n = 2; i < 3; i++, m = n, n = (n + 1) % 3)
            cofactor[j][i] = J[k][m] * J[l][n] - J[k][n] * J[l][m];
    det = J[0][0] * cofactor[0][0] + J[0][1] * cofactor[0][1] + J[0][2] * cofactor[0][2];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[i][j] = cofactor[j][i] / det;
    for (int a = 0; a < local; a++) {
        lanes *g = b->g + 3 * (a * gauss + point);
        for (int i = 0; i < 3; i++)
            g[i] = T[i][0] * G[a] + T[i][1] * G[local + a] + T[i][2] * G[2 * local + a];
    }
    return det;
}

static enum status gradients(struct solid_batch *b, int count)
{
    const int *n = b->points;

    for (int point = 0; point < n[0] * n[1] * n[2]; point++) {
        const int q[3] = {point / (n[1] * n[2]), point / n[2] % n[1], point % n[2]};
        functions(b, q, point);
        const lanes det = push_forward(b, point);
        for (int l = 0; l < count; l++)
            if (!(det[l] > 0))
                return isnan(det[l]) ? STATUS_NAN : STATUS_INVERTED;
        b->dV[point] = b->weight[0][q[0]] * (b->weight[1][q[1]] * b->weight[2][q[2]]) * det;
    }
    return STATUS_OK;
}

/* Weights the gradients and values of function a, the row-th of a pass; adds its volume. */
static void weigh(struct solid_batch *b, const struct solid_batch_sums *s, int a, int row,
                  int count, const int *element)
{
    const int gauss = b->space->gauss, local = b->space->local;
    const lanes *g = b->g + 3 * a * gauss, *N = b->N + a * gauss;
    lanes *w = b->w + 4 * row, volume = {0};

    for (int q = 0; q < gauss; q++, g += 3, w += 4 * ROWS) {
        for (int i = 0; i < 3; i++)
            w[i] = b->dV[q] * g[i];
        w[3] = s->material.density * b->dV[q] * N[q];
        volume += b->dV[q] * N[q];
    }
    for (int l = 0; l < count; l++)
        s->volume[b->space->ien[element[l] * local + a]] += volume[l];
}

/* Computes int N_a,i N_c,j and the mass of the weighted functions a and function c. */
static inline void integrate(const struct solid_batch *b, int c, lanes sum[ROWS][10])
{
    const int gauss = b->space->gauss;
    const lanes *g = b->g + 3 * c * gauss, *N = b->N + c * gauss, *w = b->w;
    lanes s[10] = {{0}}, r[10] = {{0}};

    for (int q = 0; q < gauss; q++, g += 3, w += 4 * ROWS) {
        const lanes g0 = g[0], g1 = g[1], g2 = g[2];
        s[0] += w[0] * g0, s[1] += w[0] * g1, s[2] += w[0] * g2;
        s[3] += w[1] * g0, s[4] += w[1] * g1, s[5] += w[1] * g2;
        s[6] += w[2] * g0, s[7] += w[2] * g1, s[8] += w[2] * g2;
        r[0] += w[4] * g0, r[1] += w[4] * g1, r[2] += w[4] * g2;
        r[3] += w[5] * g0, r[4] += w[5] * g1, r[5] += w[5] * g2;
        r[6] += w[6] * g0, r[7] += w[6] * g1, r[8] += w[6] * g2;
        s[9] += w[3] * N[q], r[9] += w[7] * N[q];
    }
    memcpy(sum[0], s, sizeof s);
    memcpy(sum[1], r, sizeof r);
}

/* Computes the stiffness block, row-major, from the integrals h. */
static void stiffness(const struct solid_material *material, const lanes h[9], lanes k[9])
{
    const double lambda = material->lambda, mu = material->mu;
    const lanes shear = mu * (h[0] + h[4] + h[8]);

    for (int t = 0; t < 9; t++) /* 3 i + j and its transpose 3 j + i */
        k[t] = lambda * h[t] + mu * h[t % 3 * 3 + t / 3];
    k[0] += shear, k[4] += shear, k[8] += shear;
}

/* Eight numbers that may lie anywhere. */
typedef double eight __attribute__((vector_size(8 * sizeof(double)), aligned(8)));

/* Turns lanes into rows: row[l] gets lane l of k[0 .. 7]. */
static inline void turn(const lanes k[9], eight row[LANES])
{
#if defined(__AVX512VL__) && !defined(__clang__)
    typedef long long places __attribute__((vector_size(8 * sizeof(long long))));
    static const places low[] = {{0, 8, 2, 10, 4, 12, 6, 14},
                                 {0, 1, 8, 9, 4, 5, 12, 13},
                                 {0, 1, 2, 3, 8, 9, 10, 11}};

    for (int t = 0; t < 8; t++)
        row[t] = k[t];
#pragma GCC unroll 3
    for (int s = 0, d = 1; s < 3; s++, d *= 2)
#pragma GCC unroll 8
        for (int t = 0; t < 8; t++)
            if (!(t & d)) {
                const lanes a = row[t], b = row[t + d];
                row[t] = __builtin_shuffle(a, b, low[s]);
                row[t + d] = __builtin_shuffle(a, b, low[s] + d);
            }
#else
    for (int l = 0; l < LANES; l++)
        for (int t = 0; t < 8; t++)
            row[l][t] = k[t][l];
#endif
}

/* Adds the blocks of functions a and c. */
static void scatter(const struct solid_batch *b, const struct solid_batch_sums *s,
                    int count, const int *element, int a, int c, const lanes k[9],
                    lanes mass)
{
    const int local = b->space->local, runs = local / s->run, r = c / s->run;
    const int start = r * s->run > a ? r * s->run : a;
    eight row[LANES];

    turn(k, row);
    for (int l = 0; l < count; l++) {
        const int n = s->place[(element[l] * local + a) * runs + r] + c - start;
        *(eight *)s->K[n] += row[l];
        s->K[n][8] += k[8][l];
        s->M[n] += mass[l];
    }
}

static enum status add(struct solid_batch *b, const struct solid_batch_sums *s, int count,
                       const int *element, const double *x)
{
    const int local = b->space->local;
    enum status st;

    gather(b, count, element, x);
    TRY(gradients(b, count));
    /* Backwards: a pair of nodes gets its sums from the first element on. */
    for (int a = local - 1; a >= 0; a -= ROWS) {
        const int rows = a > 0 ? ROWS : 1;
        for (int i = 0; i < rows; i++)
            weigh(b, s, a - i, i, count, element);
        for (int c = local - 1; c > a - rows; c--) {
            lanes sum[ROWS][10], k[9];
            integrate(b, c, sum);
            for (int i = c < a; i < rows; i++) {
                stiffness(&s->material, sum[i], k);
                scatter(b, s, count, element, a - i, c, k, sum[i][9]);
            }
        }
    }
out:
    return st;
}

enum status solid_batch_add(struct solid_batch *b, const struct solid_batch_sums *s,
                            int slab, int end, const double *x)
{
    int element[LANES], count = 0;
    enum status st = STATUS_OK;

    for (; slab < end; slab += 2)
        for (int e = b->space->slab[slab]; e < b->space->slab[slab + 1]; e++) {
            element[count++] = e;
            if (count == LANES)
                TRY(add(b, s, count, element, x));
            count %= LANES;
        }
    if (count)
        st = add(b, s, count, element, x);
out:
    return st;
}

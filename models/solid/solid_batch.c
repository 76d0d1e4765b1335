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

    if (!space->line || space->reduced || space->layer || space->hinge.column)
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

static void cross(const lanes a[3], const lanes b[3], lanes c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
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
    for (int j = 0; j < 3; j++)
        cross(J[(j + 1) % 3], J[(j + 2) % 3], cofactor[j]);
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

static enum status judge(lanes det, int count)
{
    for (int l = 0; l < count; l++)
        if (!(det[l] > 0))
            return isnan(det[l]) ? STATUS_NAN : STATUS_INVERTED;
    return STATUS_OK;
}

static enum status gradients(struct solid_batch *b, int count)
{
    const int *n = b->points;

    for (int point = 0; point < n[0] * n[1] * n[2]; point++) {
        const int q[3] = {point / (n[1] * n[2]), point / n[2] % n[1], point % n[2]};
        functions(b, q, point);
        const lanes det = push_forward(b, point);
        const enum status st = judge(det, count);
        if (st != STATUS_OK)
            return st;
        b->dV[point] = b->weight[0][q[0]] * (b->weight[1][q[1]] * b->weight[2][q[2]]) * det;
    }
    return STATUS_OK;
}

/* Weights the gradients and values of function a, the row-th of a pass; adds its volume. */
static void weigh(struct solid_batch *b, int a, int row, int count, const int *element,
                  double density, const struct solid_batch_sums *to)
{
    const int gauss = b->space->gauss, local = b->space->local;
    const lanes *g = b->g + 3 * a * gauss, *N = b->N + a * gauss;
    lanes *w = b->w + 4 * row, volume = {0};

    for (int q = 0; q < gauss; q++, g += 3, w += 4 * ROWS) {
        for (int i = 0; i < 3; i++)
            w[i] = b->dV[q] * g[i];
        w[3] = density * b->dV[q] * N[q];
        volume += b->dV[q] * N[q];
    }
    for (int l = 0; l < count; l++)
        to->volume[b->space->ien[element[l] * local + a]] += volume[l];
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

/* Turns lanes into rows: row[l] has lane l of k[0 .. 7]. */
static inline void turn(const lanes k[9], eight row[LANES])
{
#if defined(__AVX512VL__)
#define LOW(a, b)   __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14)
#define HIGH(a, b)  __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15)
#define LOW2(a, b)  __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13)
#define HIGH2(a, b) __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15)
#define LOW4(a, b)  __builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11)
#define HIGH4(a, b) __builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15)
    lanes one[8], two[8];

    for (int t = 0; t < 8; t += 2)
        one[t] = LOW(k[t], k[t + 1]), one[t + 1] = HIGH(k[t], k[t + 1]);
    for (int t = 0; t < 8; t += 4)
        for (int s = t; s < t + 2; s++)
            two[s] = LOW2(one[s], one[s + 2]), two[s + 2] = HIGH2(one[s], one[s + 2]);
    for (int t = 0; t < 4; t++) {
        row[t] = LOW4(two[t], two[t + 4]);
        row[t + 4] = HIGH4(two[t], two[t + 4]);
    }
#else
    for (int l = 0; l < LANES; l++)
        for (int t = 0; t < 8; t++)
            row[l][t] = k[t][l];
#endif
}

/* Adds the blocks of functions a and c. */
static void scatter(const struct solid_batch *b, int count, const int *element, int a,
                    int c, const lanes k[9], lanes mass, const struct solid_batch_sums *to)
{
    const int local = b->space->local, runs = local / to->run, r = c / to->run;
    const int start = r * to->run > a ? r * to->run : a;
    eight row[LANES];

    turn(k, row);
    for (int l = 0; l < count; l++) {
        const int n = to->place[(element[l] * local + a) * runs + r] + c - start;
        *(eight *)to->K[n] += row[l];
        to->K[n][8] += k[8][l];
        to->M[n] += mass[l];
    }
}

enum status solid_batch_add(struct solid_batch *b, int elements, const int *element,
                            const struct solid_material *material, const double *x,
                            const struct solid_batch_sums *to)
{
    const int local = b->space->local;

    for (; elements > 0; elements -= LANES, element += LANES) {
        const int count = elements < LANES ? elements : LANES;
        gather(b, count, element, x);
        const enum status st = gradients(b, count);
        if (st != STATUS_OK)
            return st;
        /* Backwards: a pair of nodes gets its sums from the first element on, where
         * elements ascend. */
        for (int a = local - 1; a >= 0; a -= ROWS) {
            const int rows = a > 0 ? ROWS : 1;
            for (int i = 0; i < rows; i++)
                weigh(b, a - i, i, count, element, material->density, to);
            for (int c = local - 1; c > a - rows; c--) {
                lanes sum[ROWS][10], k[9];
                integrate(b, c, sum);
                for (int i = c < a; i < rows; i++) {
                    stiffness(material, sum[i], k);
                    scatter(b, count, element, a - i, c, k, sum[i][9], to);
                }
            }
        }
    }
    return STATUS_OK;
}

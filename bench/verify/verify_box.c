#include "bench/verify/verify_box.h"

#include <stdlib.h>

#include "models/linalg/gauss.h"

/* Of one direction, [n][n] each: int N_a N_b, int N_a' N_b, int N_a' N_b'. */
struct line {
    int n, below; /* functions; of the directions behind it, all together */
    double *of[3];
};

static void add_point(struct line *line, const struct bspline *b, int span, const double *N,
                      double weight, double size)
{
    const double *slope = N + b->p + 1;

    for (int a = 0; a <= b->p; a++)
        for (int c = 0; c <= b->p; c++) {
            int at = (span - b->p + a) * line->n + span - b->p + c;
            line->of[0][at] += weight * size * N[a] * N[c];
            line->of[1][at] += weight * slope[a] * N[c];
            line->of[2][at] += weight / size * slope[a] * slope[c];
        }
}

/* basis = NULL: the function 1. */
static enum status line_init(struct line *line, const struct bspline *b, double size)
{
    const int n = b ? b->n : 1;
    double x[GAUSS_MAX], w[GAUSS_MAX], N[2 * BSPLINE_MAX_ORDER];
    double *room = calloc(3 * (size_t)(n * n), sizeof *room);

    *line = (struct line){n, 1, {room, room + n * n, room + 2 * n * n}};
    if (!room)
        return STATUS_MEMORY;
    if (!b)
        *room = size;
    else
        gauss_rule(b->p + 3, x, w);
    for (int k = b ? b->p : n; k < n; k++) {
        const double edge = b->U[k + 1] - b->U[k];
        for (int q = 0; edge > 0 && q < b->p + 3; q++) {
            bspline_eval(b, k, b->U[k] + edge * x[q], 1, N);
            add_point(line, b, k, N, edge * w[q], size);
        }
    }
    return STATUS_OK;
}

/* int N_a,i N_b,j dV; i = j = 3: int N_a N_b dV. */
static double product(const struct line line[3], int a, int b, int i, int j)
{
    double value = 1;

    for (int d = 0; d < 3; d++) {
        const int n = line[d].n, p = a / line[d].below % n, q = b / line[d].below % n;
        const double *of = line[d].of[(d == i) + (d == j)];
        value *= d == j && d != i ? of[q * n + p] : of[p * n + q];
    }
    return value;
}

int verify_box_nodes(const struct verify_box *box)
{
    int nodes = 1;

    for (int d = 0; d < 3; d++)
        nodes *= box->basis[d] ? box->basis[d]->n : 1;
    return nodes;
}

enum status verify_box_matrices(const struct verify_box *box, double *K, double *M)
{
    enum status st = STATUS_OK;
    struct line line[3] = {{0}};
    const int nodes = verify_box_nodes(box);

    for (int d = 0; d < 3; d++)
        TRY(line_init(&line[d], box->basis[d], box->size[d]));
    line[1].below = line[2].n, line[0].below = line[1].n * line[2].n;
    for (int a = 0; a < nodes; a++)
        for (int b = 0; b < nodes; b++) {
            if (M)
                M[a * nodes + b] = box->density * product(line, a, b, 3, 3);
            for (int i = 0; K && i < 3; i++)
                for (int j = 0; j < 3; j++) {
                    double *entry = &K[(3 * a + i) * 3 * nodes + 3 * b + j];
                    *entry = box->lambda * product(line, a, b, i, j) +
                             box->mu * product(line, a, b, j, i);
                    for (int k = 0; i == j && k < 3; k++)
                        *entry += box->mu * product(line, a, b, k, k);
                }
        }
out:
    for (int d = 0; d < 3; d++)
        free(line[d].of[0]);
    return st;
}

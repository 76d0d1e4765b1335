#include "bench/verify/verify_box.h"

#include <stdlib.h>

#include "models/linalg/gauss.h"

/* mass, int N_a' N_b, stiffness of one direction, [n][n] each, functions of length `size`.
 */
struct line {
    int n;
    double *mass, *mixed, *stiffness;
};

static void add_point(struct line *line, const struct bspline *b, int span, const double *N,
                      double weight, double size)
{
    const double *slope = N + b->p + 1;

    for (int a = 0; a <= b->p; a++)
        for (int c = 0; c <= b->p; c++) {
            int at = (span - b->p + a) * line->n + span - b->p + c;
            line->mass[at] += weight * size * N[a] * N[c];
            line->mixed[at] += weight * slope[a] * N[c];
            line->stiffness[at] += weight / size * slope[a] * slope[c];
        }
}

/* basis = NULL: the function 1. */
static enum status line_init(struct line *line, const struct bspline *b, double size)
{
    int n = b ? b->n : 1;
    double x[GAUSS_MAX], w[GAUSS_MAX], N[2 * BSPLINE_MAX_ORDER];

    line->n = n;
    line->mass = calloc(3 * (size_t)(n * n), sizeof(double));
    if (!line->mass)
        return STATUS_MEMORY;
    line->mixed = line->mass + n * n;
    line->stiffness = line->mixed + n * n;
    if (!b) {
        *line->mass = size;
        return STATUS_OK;
    }
    gauss_rule(b->p + 3, x, w);
    for (int k = b->p; k < b->n; k++) {
        double edge = b->U[k + 1] - b->U[k];
        for (int q = 0; edge > 0 && q < b->p + 3; q++) {
            bspline_eval(b, k, b->U[k] + edge * x[q], 1, N);
            add_point(line, b, k, N, edge * w[q], size);
        }
    }
    return STATUS_OK;
}

/* int N_a,i N_b,j dV; i = j = 3: int N_a N_b dV. */
static double product(const struct line line[3], const int a[3], const int b[3], int i,
                      int j)
{
    double value = 1;

    for (int d = 0; d < 3; d++) {
        const struct line *l = &line[d];
        value *= d == i && d == j ? l->stiffness[a[d] * l->n + b[d]]
                 : d == i         ? l->mixed[a[d] * l->n + b[d]]
                 : d == j         ? l->mixed[b[d] * l->n + a[d]]
                                  : l->mass[a[d] * l->n + b[d]];
    }
    return value;
}

static double stiffness_entry(const struct line line[3], const struct verify_box *box,
                              const int a[3], const int b[3], int i, int j)
{
    double value =
        box->lambda * product(line, a, b, i, j) + box->mu * product(line, a, b, j, i);

    for (int k = 0; i == j && k < 3; k++)
        value += box->mu * product(line, a, b, k, k);
    return value;
}

int verify_box_nodes(const struct verify_box *box)
{
    int nodes = 1;

    for (int d = 0; d < 3; d++)
        nodes *= box->basis[d] ? box->basis[d]->n : 1;
    return nodes;
}

static void split(const struct line line[3], int node, int at[3])
{
    at[2] = node % line[2].n;
    at[1] = node / line[2].n % line[1].n;
    at[0] = node / (line[2].n * line[1].n);
}

enum status verify_box_matrices(const struct verify_box *box, double *K, double *M)
{
    enum status st = STATUS_OK;
    struct line line[3] = {{0}};
    int nodes = verify_box_nodes(box), at[3], bt[3];

    for (int d = 0; d < 3; d++)
        TRY(line_init(&line[d], box->basis[d], box->size[d]));
    for (int a = 0; a < nodes; a++)
        for (int b = 0; b < nodes; b++) {
            split(line, a, at);
            split(line, b, bt);
            if (M)
                M[a * nodes + b] = box->density * product(line, at, bt, 3, 3);
            for (int ij = 0; K && ij < 9; ij++)
                K[(3 * a + ij / 3) * 3 * nodes + 3 * b + ij % 3] =
                    stiffness_entry(line, box, at, bt, ij / 3, ij % 3);
        }
out:
    for (int d = 0; d < 3; d++)
        free(line[d].mass);
    return st;
}

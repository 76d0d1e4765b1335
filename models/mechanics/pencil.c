#include "models/mechanics/pencil.h"

#include <math.h>
#include <stdlib.h>

#include "models/linalg/eigen.h"
#include "models/mechanics/system.h"

enum status pencil_modes(const struct pencil *p, const struct supports *held,
                         const unsigned char *parity, int count, double *omega,
                         struct message *why)
{
    enum status st;
    long *start[2] = {NULL};
    int *row[2] = {NULL};
    double *value[2] = {NULL};

    if (!held->free_count)
        return status_fail(why, STATUS_INPUT,
                           "modes: the sheet is held everywhere; it has none");
    if (count < 1 || count > held->free_count)
        return status_fail(why, STATUS_INPUT, "modes: 1 to %d can be had, not %d",
                           held->free_count, count);
    TRY(system_columns(p->graph, held, parity, 1, p->K, 0, NULL, &start[0], &row[0],
                       &value[0]));
    TRY(system_columns(p->graph, held, parity, 0, p->K, 1, p->M, &start[1], &row[1],
                       &value[1]));
    const struct eigen_pair pair = {held->free_count, start[0], row[0], value[0], value[1]};
    TRY(eigen_lowest(&pair, count, omega, NULL, why));
    for (int n = 0; n < count; n++)
        omega[n] = omega[n] > 0 ? sqrt(omega[n]) : p->stressed ? -sqrt(-omega[n]) : 0;
out:
    for (int n = 0; n < 2; n++) {
        free(start[n]);
        free(row[n]);
        free(value[n]);
    }
    return st;
}

static enum status make(struct matrix *A, int rows, long entries)
{
    *A = (struct matrix){.rows = rows};
    A->row = malloc((size_t)entries * sizeof *A->row);
    A->column = malloc((size_t)entries * sizeof *A->column);
    A->value = malloc((size_t)entries * sizeof *A->value);
    return A->row && A->column && A->value ? STATUS_OK : STATUS_MEMORY;
}

static void add(struct matrix *A, int row, int column, double value)
{
    if (row < column)
        return;
    A->row[A->entries] = row;
    A->column[A->entries] = column;
    A->value[A->entries++] = value;
}

enum status pencil_matrices(const struct pencil *p, struct matrix *K, struct matrix *M)
{
    enum status st;
    const struct blocks *g = p->graph;
    long pairs = g->start[g->nodes];
    struct matrix k = {0}, mass = {0};

    TRY(make(&k, 3 * g->nodes, 9 * pairs));
    TRY(make(&mass, 3 * g->nodes, 3 * pairs));
    for (int a = 0; a < g->nodes; a++)
        for (long n = g->start[a]; n < g->start[a + 1]; n++)
            for (int t = 0; t < 9; t++) {
                int row = 3 * g->node[n] + t % 3, column = 3 * a + t / 3;
                add(&k, row, column, p->K[n][t]);
                if (t % 4 == 0)
                    add(&mass, row, column, p->M[n]);
            }
    *K = k;
    *M = mass;
    k = mass = (struct matrix){0};
out:
    matrix_clear(&k);
    matrix_clear(&mass);
    return st;
}

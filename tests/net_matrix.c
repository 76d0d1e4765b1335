#include "tests/net_matrix.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

struct node {
    int i, j, k, c;
};

static struct node node_of(const struct net_shape *shape, int unknown)
{
    int column = unknown / 6;
    return (struct node){.i = column / shape->points_v,
                         .j = column % shape->points_v,
                         .k = unknown / 3 % 2,
                         .c = unknown % 3};
}

static bool coupled(const struct net_shape *shape, struct node a, struct node b)
{
    bool near = abs(a.i - b.i) <= shape->reach && abs(a.j - b.j) <= shape->reach;
    bool alike = ((a.c == 2) ^ a.k) == ((b.c == 2) ^ b.k);
    return near && (alike || !shape->split);
}

/* A number in [-1, 1) that depends on the pair only (a mixing of 64 bits). */
static double noise(uint64_t i, uint64_t j)
{
    uint64_t z = (i << 32 | j) + 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (double)((z ^ z >> 31) >> 11) * 0x1p-52 - 1.0;
}

/* Entries of column j, rows into row (unless NULL). Only columns up to `reach` further in i
 * and j can be met: rows come ascending because unknowns ascend with (i, j, k, c). */
static long column_rows(const struct net_shape *shape, int n, int j, int *row)
{
    struct node b = node_of(shape, j);
    long count = 0;
    for (int i = b.i; i <= b.i + shape->reach; i++)
        for (int v = b.j - shape->reach; v <= b.j + shape->reach; v++) {
            if (v < 0 || v >= shape->points_v)
                continue;
            for (int s = 0; s < 6; s++) {
                int r = (i * shape->points_v + v) * 6 + s;
                if (r < j || r >= n || !coupled(shape, node_of(shape, r), b))
                    continue;
                if (row)
                    row[count] = r;
                count++;
            }
        }
    return count;
}

static void fill_values(struct net_matrix *a, double *sum)
{
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j] + 1; s < a->start[j + 1]; s++) {
            a->value[s] = noise(a->row[s], j);
            sum[j] += fabs(a->value[s]);
            sum[a->row[s]] += fabs(a->value[s]);
        }
    for (int j = 0; j < a->n; j++)
        a->value[a->start[j]] = 1.0 + sum[j];
}

enum status net_matrix_create(const struct net_shape *shape, struct net_matrix *a)
{
    /* Holding the edge i = 0 leaves the same net with one row less. */
    int n = (shape->points_u - shape->held_edge) * shape->points_v * 6;
    double *sum = calloc(n, sizeof *sum);

    memset(a, 0, sizeof *a);
    a->n = n;
    a->start = calloc(n + 1, sizeof *a->start);
    for (int j = 0; a->start && j < n; j++)
        a->start[j + 1] = a->start[j] + column_rows(shape, n, j, NULL);
    if (a->start) {
        a->row = malloc(a->start[n] * sizeof *a->row);
        a->value = malloc(a->start[n] * sizeof *a->value);
    }
    if (!sum || !a->row || !a->value) {
        free(sum);
        net_matrix_clear(a);
        return STATUS_MEMORY;
    }
    for (int j = 0; j < n; j++)
        column_rows(shape, n, j, a->row + a->start[j]);
    fill_values(a, sum);
    free(sum);
    return STATUS_OK;
}

void net_matrix_clear(struct net_matrix *a)
{
    free(a->start);
    free(a->row);
    free(a->value);
    memset(a, 0, sizeof *a);
}

void net_matrix_multiply(const struct net_matrix *a, const double *x, double *y)
{
    memset(y, 0, a->n * sizeof *y);
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j]; s < a->start[j + 1]; s++) {
            y[a->row[s]] += a->value[s] * x[j];
            if (a->row[s] != j)
                y[j] += a->value[s] * x[a->row[s]];
        }
}

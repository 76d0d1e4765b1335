#include "models/solid/solid_rest.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/eigen.h"

/* r = load - K d, zero at held unknowns. */
static void residual(const struct solid_motion *m, const double *d, double *r)
{
    size_t count = 3 * (size_t)m->space->nodes;

    blocks_multiply(&m->assembly.graph, (const double(*)[9])m->assembly.K, d, r);
    for (size_t t = 0; t < count; t++)
        r[t] = m->supports.free_index[t] < 0 ? 0 : m->load[t] - r[t];
}

static double largest(size_t count, const double *x)
{
    double most = 0;

    for (size_t t = 0; t < count; t++)
        if (!(fabs(x[t]) <= most))
            most = fabs(x[t]);
    return most;
}

/* Correction above this part of the solution: the system is singular to working accuracy. */
static const double LARGEST_CORRECTION = 1e-2;

enum status solid_rest_equilibrium(struct solid_motion *m, struct counters *counters,
                                   struct message *why)
{
    enum status st;
    struct newmark *n = &m->newmark;
    size_t count = 3 * (size_t)m->space->nodes;
    double *r = n->work, change = 0;

    if (!m->supports.held_count)
        return status_fail(why, STATUS_INPUT,
                           "static equilibrium needs supports, and the scene has none");
    memset(n->d, 0, 3 * count * sizeof *n->d); /* d, v and a */
    supports_shift(&m->supports, m->scene, 0, m->held);
    for (int h = 0; h < m->supports.held_count; h++)
        n->d[m->supports.held[h]] = m->held[h];
    m->started = false;
    m->time = 0;
    st = system_factor(&m->system, 1, (const double(*)[9])m->assembly.K, 0, NULL);
    counters->factorisations++;
    for (int pass = 0; st == STATUS_OK && pass < 2; pass++) {
        residual(m, n->d, r);
        TRY(system_solve(&m->system, r));
        counters->solves++;
        for (size_t t = 0; t < count; t++)
            n->d[t] += r[t];
        change = largest(count, r) / largest(count, n->d);
    }
    if (st == STATUS_OK && change > LARGEST_CORRECTION)
        st = STATUS_INDEFINITE;
    if (st == STATUS_INDEFINITE)
        status_fail(why, st,
                    "the stiffness is singular to working accuracy: the supports leave the "
                    "sheet free to move, or it is too thin for control points as unknowns "
                    "(discretization.unknowns=thickness is made for that)");
    for (size_t t = 0; t < count; t++)
        m->x[t] = m->space->rest[t] + n->d[t];
    if (m->kinematics != KINEMATICS_LINEAR) /* there d is the last step's increment */
        memset(n->d, 0, count * sizeof *n->d);
out:
    return st;
}

enum status solid_rest_modes(struct solid_motion *m, int count, double *omega,
                             struct message *why)
{
    enum status st;
    const double(*K)[9] = (const double(*)[9])m->assembly.K;
    const struct blocks *graph = &m->assembly.graph;
    const unsigned char *parity = m->system.parity;
    struct eigen_matrix k = {.n = m->supports.free_count}, mass = k;
    long *start[2] = {NULL};
    int *row[2] = {NULL};
    double *value[2] = {NULL};

    if (count < 1 || count > m->supports.free_count)
        return status_fail(why, STATUS_INPUT, "modes: 1 to %d can be had, not %d",
                           m->supports.free_count, count);
    TRY(system_columns(graph, &m->supports, parity, 1, K, 0, NULL, &start[0], &row[0],
                       &value[0]));
    TRY(system_columns(graph, &m->supports, parity, 0, K, 1, m->assembly.M, &start[1],
                       &row[1], &value[1]));
    k.start = start[0], k.row = row[0], k.value = value[0];
    mass.start = start[1], mass.row = row[1], mass.value = value[1];
    TRY(eigen_lowest(&k, &mass, count, omega, NULL, why));
    for (int n = 0; n < count; n++) /* a zero mode's eigenvalue is round-off of either sign */
        omega[n] = omega[n] > 0 ? sqrt(omega[n]) : 0;
out:
    for (int n = 0; n < 2; n++) {
        free(start[n]);
        free(row[n]);
        free(value[n]);
    }
    return st;
}

static enum status matrix_make(struct matrix *A, int rows, long entries)
{
    *A = (struct matrix){.rows = rows};
    A->row = malloc((size_t)entries * sizeof *A->row);
    A->column = malloc((size_t)entries * sizeof *A->column);
    A->value = malloc((size_t)entries * sizeof *A->value);
    return A->row && A->column && A->value ? STATUS_OK : STATUS_MEMORY;
}

static void matrix_add(struct matrix *A, int row, int column, double value)
{
    if (row < column)
        return;
    A->row[A->entries] = row;
    A->column[A->entries] = column;
    A->value[A->entries++] = value;
}

enum status solid_rest_matrices(const struct solid_motion *m, struct matrix *K,
                                struct matrix *M)
{
    enum status st;
    const struct blocks *g = &m->assembly.graph;
    long pairs = g->start[g->nodes];
    struct matrix k = {0}, mass = {0};

    assert(!m->space->thickness_basis && !m->time);
    TRY(matrix_make(&k, 3 * g->nodes, 9 * pairs));
    TRY(matrix_make(&mass, 3 * g->nodes, 3 * pairs));
    for (int a = 0; a < g->nodes; a++)
        for (long n = g->start[a]; n < g->start[a + 1]; n++)
            for (int t = 0; t < 9; t++) {
                int row = 3 * g->node[n] + t % 3, column = 3 * a + t / 3;
                matrix_add(&k, row, column, m->assembly.K[n][t]);
                if (t % 4 == 0)
                    matrix_add(&mass, row, column, m->assembly.M[n]);
            }
    *K = k;
    *M = mass;
    k = mass = (struct matrix){0};
out:
    matrix_clear(&k);
    matrix_clear(&mass);
    return st;
}

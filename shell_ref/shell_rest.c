#include "shell_ref/shell_rest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/eigen.h"
#include "shell_ref/shell_newton.h"

static const struct shell_path statics = {.rule = {.s1 = 1, .g1 = 1}};

/* First increment of the load, and the smallest before giving up. */
static const double FIRST_INCREMENT = 1.0 / 8, SMALLEST_INCREMENT = 1e-7;

/* To the tangent of the rest shape, wherever x is. */
static enum status rest_stiffness(const struct shell_motion *m, double (*K)[9])
{
    return shell_assembly_tangent(&m->assembly, &statics, m->space->rest,
                                  (struct shell_foresight){0}, K);
}

static void begin(struct shell_motion *m)
{
    struct newmark *n = &m->newmark;
    size_t count = 3 * (size_t)m->space->nodes;

    memset(n->d, 0, 3 * count * sizeof *n->d); /* d, v and a */
    memcpy(m->x, m->space->rest, count * sizeof *m->x);
    supports_shift(&m->supports, m->scene, 0, m->held);
    m->started = false;
    m->factored = -1;
    m->halvings = 0;
    m->time = 0;
}

static enum status linear(struct shell_motion *m, struct counters *counters)
{
    enum status st;
    struct newmark *n = &m->newmark;
    size_t count = 3 * (size_t)m->space->nodes;
    const double(*K)[9] = (const double(*)[9])m->K;
    double *r = n->work;

    for (int h = 0; h < m->supports.held_count; h++)
        n->d[m->supports.held[h]] = m->held[h];
    TRY(system_factor(&m->system, 1, K, 0, NULL));
    counters->factorisations++;
    for (int pass = 0; pass < 2; pass++) {
        blocks_multiply(&m->assembly.graph, K, n->d, r);
        for (size_t t = 0; t < count; t++)
            r[t] = m->load[t] - r[t];
        TRY(system_solve(&m->system, r));
        counters->solves++;
        for (size_t t = 0; t < count; t++)
            n->d[t] += r[t];
    }
    for (size_t t = 0; t < count; t++)
        m->x[t] = m->space->rest[t] + n->d[t];
out:
    return st;
}

/* Loads grow from 0 to 1; the next shape is guessed along the last two. */
static enum status nonlinear(struct shell_motion *m, struct counters *counters)
{
    enum status st = STATUS_OK;
    size_t count = 3 * (size_t)m->space->nodes;
    double *last = m->room, *before = m->room + count;
    double load = 0, increment = FIRST_INCREMENT, last_increment = 0;

    memcpy(last, m->x, count * sizeof *last);
    memcpy(before, m->x, count * sizeof *last);
    while (load < 1) {
        struct shell_equation q = {.path = statics, .limit = 30};
        long iterations = counters->iterations;
        q.load = fmin(1, load + increment);
        double ahead = last_increment > 0 ? (q.load - load) / last_increment : 0;
        TRY(shell_assembly_strain(&m->assembly, last, m->strain_old));
        for (size_t t = 0; t < count; t++)
            m->x[t] = last[t] + ahead * (last[t] - before[t]);
        for (int h = 0; h < m->supports.held_count; h++) {
            int u = m->supports.held[h];
            m->x[u] = m->space->rest[u] + q.load * m->held[h];
        }
        m->factored = -1;
        st = shell_newton_solve(m, &q, m->x, counters);
        if (st != STATUS_OK) {
            increment = (q.load - load) / 4;
            if (!status_is_death(st) || increment < SMALLEST_INCREMENT)
                break;
            continue;
        }
        last_increment = q.load - load;
        load = q.load;
        memcpy(before, last, count * sizeof *last);
        memcpy(last, m->x, count * sizeof *last);
        if (counters->iterations - iterations < 10)
            increment *= 2;
    }
out:
    memcpy(m->x, last, count * sizeof *last);
    m->factored = -1;
    return st;
}

/* Where growing loads do not lead: a sheet that hangs from a hinge or from corners has no
 * stiffness at first. Backward Euler steps that forget their velocity go downhill instead,
 * in growing steps, until one without mass arrives (pseudo-transient continuation). */
static enum status relax(struct shell_motion *m, struct counters *counters)
{
    enum { STEPS = 400 };
    enum status st = STATUS_DIVERGED;
    size_t count = 3 * (size_t)m->space->nodes;
    double *last = m->room, first = 1 / (m->scene->step * m->scene->step), mass = first;

    for (int n = 0; n < STEPS; n++) {
        bool final = mass < 1e-8 * first;
        const struct shell_equation q = {
            .path = statics, .mass = final ? 0 : mass, .hat = last, .load = 1, .limit = 30};
        memcpy(last, m->x, count * sizeof *last);
        TRY(shell_assembly_strain(&m->assembly, last, m->strain_old));
        m->factored = -1;
        st = shell_newton_solve(m, &q, m->x, counters);
        if (st == STATUS_OK && final)
            break;
        if (st != STATUS_OK && !status_is_death(st))
            break;
        if (st != STATUS_OK)
            memcpy(m->x, last, count * sizeof *last);
        mass *= st == STATUS_OK ? 0.5 : final ? 1e3 : 8;
    }
out:
    m->factored = -1;
    return st;
}

enum status shell_rest_equilibrium(struct shell_motion *m, struct counters *counters,
                                   struct message *why)
{
    enum status st;

    if (!m->supports.held_count)
        return status_fail(why, STATUS_INPUT,
                           "static equilibrium needs supports, and the scene has none");
    begin(m);
    st = m->kinematics == KINEMATICS_LINEAR ? linear(m, counters) : nonlinear(m, counters);
    if (m->kinematics == KINEMATICS_NONLINEAR && status_is_death(st)) {
        begin(m);
        for (int h = 0; h < m->supports.held_count; h++)
            m->x[m->supports.held[h]] += m->held[h];
        st = relax(m, counters);
    }
    if (st == STATUS_INDEFINITE)
        status_fail(why, st,
                    "the stiffness is singular to working accuracy: the supports "
                    "leave the sheet free to move");
    else if (status_is_death(st))
        status_fail(why, st, "static equilibrium not found: %s", status_text(st));
    return st;
}

enum status shell_rest_modes(struct shell_motion *m, int count, double *omega,
                             struct message *why)
{
    enum status st;
    const struct blocks *graph = &m->assembly.graph;
    struct eigen_matrix k = {.n = m->supports.free_count}, mass = k;
    long *start[2] = {NULL};
    int *row[2] = {NULL};
    double *value[2] = {NULL};
    double(*K)[9] = NULL;

    if (count < 1 || count > m->supports.free_count)
        return status_fail(why, STATUS_INPUT, "modes: 1 to %d can be had, not %d",
                           m->supports.free_count, count);
    K = malloc((size_t)graph->start[graph->nodes] * sizeof *K);
    if (!K)
        TRY(STATUS_MEMORY);
    TRY(rest_stiffness(m, K));
    TRY(system_columns(graph, &m->supports, m->parity, 1, (const double(*)[9])K, 0, NULL,
                       &start[0], &row[0], &value[0]));
    TRY(system_columns(graph, &m->supports, m->parity, 0, (const double(*)[9])K, 1,
                       m->assembly.M, &start[1], &row[1], &value[1]));
    k.start = start[0], k.row = row[0], k.value = value[0];
    mass.start = start[1], mass.row = row[1], mass.value = value[1];
    TRY(eigen_lowest(&k, &mass, count, omega, NULL, why));
    for (int n = 0; n < count;
         n++) /* a zero mode's eigenvalue is round-off of either sign */
        omega[n] = omega[n] > 0 ? sqrt(omega[n]) : 0;
out:
    free(K);
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

enum status shell_rest_matrices(const struct shell_motion *m, struct matrix *K,
                                struct matrix *M)
{
    enum status st;
    const struct blocks *g = &m->assembly.graph;
    long pairs = g->start[g->nodes];
    struct matrix k = {0}, mass = {0};
    double(*block)[9] = malloc((size_t)pairs * sizeof *block);

    if (!block)
        TRY(STATUS_MEMORY);
    TRY(rest_stiffness(m, block));
    TRY(matrix_make(&k, 3 * g->nodes, 9 * pairs));
    TRY(matrix_make(&mass, 3 * g->nodes, 3 * pairs));
    for (int a = 0; a < g->nodes; a++)
        for (long n = g->start[a]; n < g->start[a + 1]; n++)
            for (int t = 0; t < 9; t++) {
                int row = 3 * g->node[n] + t % 3, column = 3 * a + t / 3;
                matrix_add(&k, row, column, block[n][t]);
                if (t % 4 == 0)
                    matrix_add(&mass, row, column, m->assembly.M[n]);
            }
    *K = k;
    *M = mass;
    k = mass = (struct matrix){0};
out:
    free(block);
    matrix_clear(&k);
    matrix_clear(&mass);
    return st;
}

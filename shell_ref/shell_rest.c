#include "shell_ref/shell_rest.h"

#include <stdlib.h>
#include <string.h>

#include "models/mechanics/large_rest.h"
#include "models/mechanics/pencil.h"

static enum status linear(struct shell_motion *m, struct counters *counters)
{
    enum status st;
    struct newmark *n = &m->newmark;
    size_t count = 3 * (size_t)m->space->nodes;
    const double(*K)[9] = (const double(*)[9])m->K;
    double *r = n->work;

    memset(n->d, 0, 3 * count * sizeof *n->d); /* d, v and a */
    supports_shift(&m->supports, m->scene, m->time, m->held);
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

enum status shell_rest_equilibrium(void *state, struct counters *counters,
                                   struct message *why)
{
    struct shell_motion *m = state;
    enum status st;

    TRY(supports_allow_rest(&m->supports, m->scene, m->kinematics == KINEMATICS_NONLINEAR,
                            why));
    m->time = supports_rest_time(&m->supports, m->scene);
    m->started = false;
    if (m->kinematics == KINEMATICS_NONLINEAR)
        return large_rest_equilibrium(&m->large, counters, why);
    st = linear(m, counters);
    if (st == STATUS_INDEFINITE)
        status_fail(why, st,
                    "the stiffness is singular to working accuracy: the supports "
                    "leave the sheet free to move");
out:
    return st;
}

/* Makes the tangent of the rest shape, wherever x is: *K, owned by the caller. */
static enum status make_stiffness(const struct shell_motion *m, double (**K)[9])
{
    const struct large_path statics = {.s1 = 1, .g1 = 1};
    const struct blocks *graph = &m->assembly.graph;

    *K = malloc((size_t)graph->start[graph->nodes] * sizeof **K);
    return *K ? large_body_tangent(&m->assembly.body, &statics, m->space->rest,
                                   (struct large_foresight){0}, *K)
              : STATUS_MEMORY;
}

enum status shell_rest_modes(void *state, int count, double *omega, struct message *why)
{
    struct shell_motion *m = state;
    double(*K)[9];

    if (m->large.rested)
        return large_rest_modes(&m->large, count, omega, why);
    enum status st = make_stiffness(m, &K);
    if (st == STATUS_OK)
        st = pencil_modes(
            &(struct pencil){&m->assembly.graph, (const double(*)[9])K, m->assembly.M},
            &m->supports, m->parity, count, omega, why);
    free(K);
    return st;
}

enum status shell_rest_matrices(const void *state, struct matrix *K, struct matrix *M)
{
    const struct shell_motion *m = state;
    double(*block)[9];
    enum status st = make_stiffness(m, &block);

    if (st == STATUS_OK)
        st = pencil_matrices(
            &(struct pencil){&m->assembly.graph, (const double(*)[9])block, m->assembly.M},
            K, M);
    free(block);
    return st;
}

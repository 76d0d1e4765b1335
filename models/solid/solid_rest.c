#include "models/solid/solid_rest.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/mechanics/pencil.h"
#include "models/solid/solid_large.h"

/* Computes r = load - K d, zero at held unknowns. */
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

/* A correction above this part of the solution means a numerically singular system. */
static const double LARGEST_CORRECTION = 1e-2;

enum status solid_rest_equilibrium(struct solid_motion *m, struct counters *counters,
                                   struct message *why)
{
    enum status st;
    struct newmark *n = &m->newmark;
    size_t count = 3 * (size_t)m->space->nodes;
    double *r = n->work, change = 0;

    TRY(supports_allow_rest(&m->supports, m->scene, m->large, why));
    if (m->large)
        return solid_large_equilibrium(m, counters, why);
    memset(n->d, 0, 3 * count * sizeof *n->d); /* d, v and a */
    m->time = supports_rest_time(&m->supports, m->scene);
    supports_shift(&m->supports, m->scene, m->time, m->held);
    for (int h = 0; h < m->supports.held_count; h++)
        n->d[m->supports.held[h]] = m->held[h];
    m->started = false;
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

static struct pencil pencil_of(const struct solid_motion *m)
{
    return (struct pencil){&m->assembly.graph, (const double(*)[9])m->assembly.K,
                           m->assembly.M};
}

enum status solid_rest_modes(struct solid_motion *m, int count, double *omega,
                             struct message *why)
{
    const struct pencil p = pencil_of(m);

    if (m->large && solid_large_rested(m))
        return solid_large_modes(m, count, omega, why);
    return pencil_modes(&p, &m->supports, m->system.parity, count, omega, why);
}

enum status solid_rest_matrices(const struct solid_motion *m, struct matrix *K,
                                struct matrix *M)
{
    const struct pencil p = pencil_of(m);

    assert(!m->space->thickness_basis && !m->time);
    return pencil_matrices(&p, K, M);
}

#include "models/solid/solid_contact.h"

#include <math.h>
#include <string.h>

static const double (*stiffness(const struct solid_motion *m))[9]
{
    return (const double(*)[9])m->assembly.K;
}

/* b = 2 M v + dt (f - K d), less what held unknowns contribute; w: theirs, else anything.
 */
static void linear_side(struct solid_motion *m, const struct newmark_held *held, double *b,
                        double *w)
{
    const struct newmark *n = &m->newmark;
    const struct blocks *graph = &m->assembly.graph;
    size_t count = 3 * (size_t)m->space->nodes;
    double *x = n->work + 2 * count, dt = n->dt;

    blocks_multiply_mass(graph, m->assembly.M, n->v, b);
    blocks_multiply(graph, stiffness(m), n->d, x);
    for (size_t t = 0; t < count; t++) {
        b[t] = 2 * b[t] + dt * (m->load[t] - x[t]);
        w[t] = 0;
    }
    if (!held)
        return;
    memset(x, 0, count * sizeof *x);
    for (int h = 0; h < m->supports.held_count; h++) {
        int t = m->supports.held[h];
        x[t] = (1 + n->alpha * dt / 2) * (n->v[t] + held->v[h]);
    }
    blocks_multiply_mass(graph, m->assembly.M, x, w);
    for (size_t t = 0; t < count; t++)
        b[t] -= w[t];
    for (int h = 0; h < m->supports.held_count; h++) {
        int t = m->supports.held[h];
        x[t] = dt / 2 * (held->d[h] - n->d[t]) + n->beta * dt / 2 * (n->v[t] + held->v[h]);
    }
    blocks_multiply(graph, stiffness(m), x, w);
    for (size_t t = 0; t < count; t++)
        b[t] -= w[t];
    for (int h = 0; h < m->supports.held_count; h++) {
        int t = m->supports.held[h];
        w[t] = 2 * (held->d[h] - n->d[t]) / dt;
    }
}

/* The step's w = v0 + v1, and its forces, into d and v. */
static void linear_finish(struct solid_motion *m, const struct newmark_held *held,
                          const double *w)
{
    struct newmark *n = &m->newmark;
    size_t count = 3 * (size_t)m->space->nodes;

    for (size_t t = 0; t < count; t++) {
        if (m->supports.free_index[t] < 0)
            continue;
        n->d[t] += n->dt / 2 * w[t];
        n->v[t] = w[t] - n->v[t];
    }
    for (int h = 0; held && h < m->supports.held_count; h++) {
        int t = m->supports.held[h];
        n->d[t] = held->d[h], n->v[t] = held->v[h];
    }
}

/* Inelastic impact of the points in contact: the velocity nearest to v in the norm of M
 * that has none along what the set holds. Its impulse joins the set's forces. */
static enum status impact(struct solid_motion *m, struct counters *counters)
{
    enum status st = STATUS_OK;
    struct contact_set *c = &m->contact;
    const double(*P)[9] = (const double(*)[9])c->projector;
    struct newmark *n = &m->newmark;
    size_t count = 3 * (size_t)m->space->nodes;
    double *change = n->work, *r = n->work + count;

    if (contact_set_arrest(c, n->v, change) <= 2 * c->rounding / n->dt)
        return STATUS_OK;
    if (m->mass_version != c->version) {
        TRY(system_factor_projected(&m->mass, 0, stiffness(m), 1, m->assembly.M, P,
                                    c->touched));
        m->mass_version = c->version;
        counters->factorisations++;
    }
    blocks_multiply_mass(&m->assembly.graph, m->assembly.M, change, r);
    for (size_t t = 0; t < count; t++)
        r[t] = -r[t];
    contact_set_apply(c, r);
    TRY(system_solve(&m->mass, r));
    counters->solves++;
    contact_set_apply(c, r);
    for (size_t t = 0; t < count; t++) {
        change[t] += r[t];
        n->v[t] += change[t];
    }
    blocks_multiply_mass(&m->assembly.graph, m->assembly.M, change, r);
    for (size_t t = 0; t < count; t++)
        if (c->touched[t / 3] && m->supports.free_index[t] >= 0)
            c->node[t / 3].force[t % 3] += r[t];
out:
    return st;
}

enum status solid_contact_linear(struct solid_motion *m, const struct newmark_held *held,
                                 struct counters *counters)
{
    enum status st;
    struct newmark *n = &m->newmark;
    size_t count = 3 * (size_t)m->space->nodes;
    double *b = n->work, *w = n->work + count;
    const struct contact_problem problem = {.k = newmark_k(n),
                                            .K = stiffness(m),
                                            .m = newmark_m(n),
                                            .M = m->assembly.M,
                                            .b = b,
                                            .scale = 2 / n->dt};

    contact_set_detect(&m->contact, m->x);
    linear_side(m, held, b, w);
    TRY(contact_solve(&m->contact, &m->system, &problem, w, counters));
    m->force_unit = 1 / n->dt;
    linear_finish(m, held, w);
    TRY(impact(m, counters));
    for (size_t t = 0; t < count; t++)
        m->x[t] = m->space->rest[t] + n->d[t];
out:
    return st;
}

/* No motion in the terms of newmark.h's w: d1 = 0, v1 = 2 (d1 - d0) / dt - v0. */
static void still_values(const struct newmark *n, size_t count, double *still)
{
    for (size_t t = 0; t < count; t++)
        still[t] = -n->beta * (2 * n->d[t] / n->dt + n->v[t]) / newmark_k(n);
}

enum status solid_contact_rebuilt(struct solid_motion *m, const struct newmark_held *held,
                                  struct counters *counters)
{
    enum status st;
    struct newmark *n = &m->newmark;
    struct contact_set *c = &m->contact;
    size_t count = 3 * (size_t)m->space->nodes;
    double *w = n->work + count, *still = n->work + 2 * count, k = newmark_k(n);
    const struct contact_problem problem = {.k = k,
                                            .K = stiffness(m),
                                            .m = newmark_m(n),
                                            .M = m->assembly.M,
                                            .b = n->work,
                                            .scale = (1 + 2 * n->beta / n->dt) / k,
                                            .still = still};

    contact_set_detect(c, m->x);
    contact_set_forget(c);
    newmark_predict(n, &m->system, stiffness(m), m->assembly.M, m->load, held);
    still_values(n, count, still);
    memset(w, 0, count * sizeof *w);
    for (int h = 0; held && h < m->supports.held_count; h++)
        w[m->supports.held[h]] = (held->d[h] + n->beta * held->v[h]) / k;
    TRY(contact_solve(c, &m->system, &problem, w, counters));
    m->force_unit = 1;
    newmark_correct(n, &m->system, w, held);
    if (m->kinematics == KINEMATICS_INCREMENTAL && contact_set_any(c)) {
        contact_set_arrest(c, n->v, w);
        for (size_t t = 0; t < count; t++)
            n->v[t] += w[t];
        contact_set_arrest(c, n->a, w);
        for (size_t t = 0; t < count; t++)
            n->a[t] += w[t];
    }
    for (size_t t = 0; t < count; t++)
        m->x[t] += n->d[t];
out:
    return st;
}

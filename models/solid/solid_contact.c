#include "models/solid/solid_contact.h"

#include <string.h>

static const double (*stiffness(const struct solid_motion *m))[9]
{
    return (const double(*)[9])m->assembly.K;
}

/* Fills what newmark.h's w is without motion: d1 = 0, v1 = 2 (d1 - d0) / dt - v0. */
static void still_values(const struct newmark *n, size_t count, double *still)
{
    for (size_t t = 0; t < count; t++)
        still[t] = -n->beta * (2 * n->d[t] / n->dt + n->v[t]) / newmark_k(n);
}

enum status solid_contact_linear(struct solid_motion *m, const struct newmark_held *held,
                                 struct counters *counters)
{
    enum status st;
    size_t count = 3 * (size_t)m->space->nodes;

    TRY(contact_step_linear(&m->contact, &m->newmark, &m->system, stiffness(m),
                            m->assembly.M, m->load, held, m->x, counters));
    m->force_unit = 1 / m->newmark.dt;
    for (size_t t = 0; t < count; t++)
        m->x[t] = m->space->rest[t] + m->newmark.d[t];
out:
    return st;
}

enum status solid_contact_rebuilt(struct solid_motion *m, const struct newmark_held *held,
                                  struct counters *counters)
{
    enum status st;
    struct newmark *n = &m->newmark;
    struct contact_set *c = &m->contact.set;
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
        contact_set_arrest(c, n->v, w, m->contact.arrest);
        for (size_t t = 0; t < count; t++)
            n->v[t] += w[t];
        contact_set_arrest(c, n->a, w, m->contact.arrest);
        for (size_t t = 0; t < count; t++)
            n->a[t] += w[t];
    }
    for (size_t t = 0; t < count; t++)
        m->x[t] += n->d[t];
out:
    return st;
}

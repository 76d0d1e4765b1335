#include "models/mechanics/integrator_newmark.h"

#include <string.h>

#include "models/mechanics/march_rest.h"
#include "models/mechanics/reaction.h"

double integrator_newmark_k(const struct march *m)
{
    return m->dt * m->dt / 4 + m->beta * m->dt / 2;
}

double integrator_newmark_m(const struct march *m)
{
    return 1 + m->alpha * m->dt / 2 + m->gamma * m->dt * m->dt / 4;
}

/* Subtracts M (a + alpha v + gamma d) + K (d + beta v) of the held unknowns, whose motion
 * is given, from rhs. */
static void subtract_held(struct march *m, const struct march_held *held, double *rhs)
{
    const size_t count = march_count(m);
    double *x = m->work + count, *y = m->work + 2 * count;

    memset(x, 0, count * sizeof *x);
    for (int h = 0; h < m->supports->held_count; h++)
        supports_set(m->supports, h, x,
                     held->a[h] + m->alpha * held->v[h] + m->gamma * held->d[h]);
    blocks_multiply_mass(m->graph, m->M, x, y);
    for (size_t t = 0; t < count; t++)
        rhs[t] -= y[t];
    for (int h = 0; h < m->supports->held_count; h++)
        supports_set(m->supports, h, x, held->d[h] + m->beta * held->v[h]);
    blocks_multiply(m->graph, m->stiffness, x, y);
    for (size_t t = 0; t < count; t++)
        rhs[t] -= y[t];
}

/* Computes the right-hand side of
 *   (k K + m M) w = rhs,   k w = d + beta v at the end of the step,
 * in m->work. */
static void predict(struct march *m, const struct march_held *held)
{
    const size_t count = march_count(m);
    const double dt = m->dt, c = dt * dt / 4, k = integrator_newmark_k(m),
                 mass = integrator_newmark_m(m);
    double *w = m->work, *z = m->work + count;

    for (size_t t = 0; t < count; t++) {
        const double p = m->d[t] + dt * m->v[t] + c * m->a[t];
        const double q = m->v[t] + dt / 2 * m->a[t];
        w[t] = mass * ((p + m->beta * q) / k) - m->alpha * q - m->gamma * p;
    }
    supports_zero(m->supports, w);
    blocks_multiply_mass(m->graph, m->M, w, z);
    for (size_t t = 0; t < count; t++)
        w[t] = z[t] + m->load[t];
    if (held)
        subtract_held(m, held, w);
}

/* Turns w, in m->work, into the new d, v, a. */
static void correct(struct march *m, const struct march_held *held)
{
    const double dt = m->dt, c = dt * dt / 4, k = integrator_newmark_k(m), *w = m->work;

    for (size_t t = 0; t < march_count(m); t++) {
        const double p = m->d[t] + dt * m->v[t] + c * m->a[t];
        const double q = m->v[t] + dt / 2 * m->a[t];
        m->a[t] = w[t] - (p + m->beta * q) / k;
        m->d[t] = p + c * m->a[t];
        m->v[t] = q + dt / 2 * m->a[t];
    }
    for (int h = 0; h < m->supports->held_count; h++) {
        supports_set(m->supports, h, m->d, held ? held->d[h] : 0);
        supports_set(m->supports, h, m->v, held ? held->v[h] : 0);
        supports_set(m->supports, h, m->a, held ? held->a[h] : 0);
    }
}

enum status integrator_newmark_step(struct march *m, const struct march_held *held,
                                    struct counters *counters)
{
    enum status st;

    predict(m, held);
    TRY(system_solve(&m->system, m->work));
    counters->solves++;
    correct(m, held);
out:
    return st;
}

/* Computes the acceleration of the present d and v (rest, static equilibrium, any start):
 *   M a = load - M alpha v - K (d + beta v),
 * held unknowns on their paths; then factors the steps' system. */
static enum status begin(struct march *m, const struct march_held *held,
                         struct counters *counters)
{
    enum status st;
    const int held_count = held ? m->supports->held_count : 0;
    const size_t count = march_count(m);
    double *x = m->work, *y = m->work + count;

    for (int h = 0; h < held_count; h++) {
        supports_set(m->supports, h, m->d, held->d[h]);
        supports_set(m->supports, h, m->v, held->v[h]);
    }
    for (size_t t = 0; t < count; t++)
        x[t] = m->alpha * m->v[t];
    for (int h = 0; h < held_count; h++)
        supports_set(m->supports, h, x, supports_get(m->supports, h, x) + held->a[h]);
    blocks_multiply_mass(m->graph, m->M, x, y);
    for (size_t t = 0; t < count; t++) {
        m->a[t] = m->load[t] - y[t];
        x[t] = m->d[t] + m->beta * m->v[t];
    }
    blocks_multiply(m->graph, m->stiffness, x, y);
    for (size_t t = 0; t < count; t++)
        m->a[t] -= y[t];
    TRY(system_factor(&m->system, 0, m->stiffness, 1, m->M));
    TRY(system_solve(&m->system, m->a));
    for (int h = 0; h < held_count; h++)
        supports_set(m->supports, h, m->a, held->a[h]);
    TRY(system_factor(&m->system, integrator_newmark_k(m), m->stiffness,
                      integrator_newmark_m(m), m->M));
    counters->factorisations += 2;
    counters->solves++;
    m->started = true;
out:
    return st;
}

void integrator_newmark_weigh(struct march *m, double share)
{
    const size_t count = march_count(m);
    double *w = m->work, *force = w + count, *left = force + count;

    for (size_t t = 0; t < count; t++)
        w[t] = m->a[t] + m->alpha * m->v[t] + m->gamma * m->d[t];
    blocks_multiply_mass(m->graph, m->M, w, force);
    for (size_t t = 0; t < count; t++) {
        left[t] = m->load[t] - force[t];
        w[t] = m->d[t] + m->beta * m->v[t];
    }
    blocks_multiply(m->graph, m->stiffness, w, force);
    for (size_t t = 0; t < count; t++)
        left[t] -= force[t];
    reaction_add(m->supports, left, m->kinematics == KINEMATICS_LINEAR ? m->rest : m->x,
                 share, m->reaction);
}

static void place(struct march *m)
{
    for (size_t t = 0; t < march_count(m); t++)
        m->x[t] = m->rest[t] + m->d[t];
}

static enum status step(struct march *m, double t, struct counters *counters)
{
    enum status st;
    struct march_held held;
    const struct march_held *at = m->supports->moving ? &held : NULL;

    if (at && !m->started)
        held = march_path(m, t, m->dt);
    if (!m->started)
        TRY(begin(m, at, counters));
    if (m->weighed)
        integrator_newmark_weigh(m, 0.5);
    if (at)
        held = march_path(m, t + m->dt, m->dt);
    TRY(integrator_newmark_step(m, at, counters));
    if (m->weighed)
        integrator_newmark_weigh(m, 0.5);
    place(m);
out:
    return st;
}

const struct march_integrator integrator_newmark = {.step = step,
                                                    .rest = march_rest_linear};

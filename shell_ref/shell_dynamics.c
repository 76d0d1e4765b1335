#include "shell_ref/shell_dynamics.h"

#include <math.h>
#include <string.h>

#include "shell_ref/shell_newton.h"

/* Substeps are step / 2^0 ... step / 2^HALVINGS. */
enum { HALVINGS = 8, FINEST = 1 << HALVINGS };

/* The membrane's mean stress is taken from (1/2 + lag) of the step: a viscosity lag dt
 * against its ringing, which nothing else damps. Stretching is small wherever a thin sheet
 * can bend, so that positions do not notice (pendulums A5 and C0 at 2.5 ms: worst distance
 * the same to 1 % with lag 0, 0.1 and 1/2), but undamped swings of coarse nets need far
 * fewer assemblies (shipped cantilever, p = 3: 1259 for 8857). */
static const double MEMBRANE_LAG = 0.1;

static size_t count_of(const struct shell_motion *m)
{
    return 3 * (size_t)m->space->nodes;
}

/* Held unknowns at the step's end into x; hat such that mass (x - hat) is their inertia. */
static void move_supports(struct shell_motion *m, double t, double dt, double mass,
                          const double *x_old, double *hat)
{
    struct newmark *n = &m->newmark;
    struct newmark_held held = shell_motion_path(m, t + dt, dt);

    for (int h = 0; h < m->supports.held_count; h++) {
        int u = m->supports.held[h];
        m->x[u] = m->space->rest[u] + held.d[h];
        double rate = (m->x[u] - x_old[u]) / dt;
        hat[u] = m->x[u] - ((held.v[h] - n->v[u]) / dt + n->alpha * rate) / mass;
    }
}

/* New velocities; a keeps the mean acceleration of the step for the next predictor. */
static void finish(struct shell_motion *m, double dt, const double *x_old)
{
    struct newmark *n = &m->newmark;
    size_t count = count_of(m);
    double *v_held = m->held + m->supports.held_count;

    for (size_t t = 0; t < count; t++) {
        double v = 2 * (m->x[t] - x_old[t]) / dt - n->v[t];
        n->a[t] = (v - n->v[t]) / dt;
        n->v[t] = v;
    }
    for (int h = 0; h < m->supports.held_count; h++)
        n->v[m->supports.held[h]] = v_held[h];
}

static enum status substep(struct shell_motion *m, double t, double dt,
                           struct counters *counters)
{
    enum status st;
    struct newmark *n = &m->newmark;
    size_t count = count_of(m);
    double *x_old = m->room, *hat = m->room + count;
    double mass = 2 / (dt * dt) + n->alpha / dt, damping = n->beta / dt;
    const struct shell_equation equation = {
        .path = {.rule = {.s0 = 0.5 - damping,
                          .s1 = 0.5 + damping,
                          .g1 = 0.5,
                          .membrane = MEMBRANE_LAG},
                 .x_old = x_old,
                 .strain_old = m->strain_old},
        .mass = mass,
        .hat = hat,
        .load = 1,
        .chord = 0.4,
        .limit = 40,
    };

    memcpy(x_old, m->x, count * sizeof *x_old);
    for (size_t k = 0; k < count; k++) {
        hat[k] = x_old[k] + 2 * n->v[k] / dt / mass;
        m->x[k] += dt * (n->v[k] + dt / 2 * n->a[k]);
    }
    move_supports(m, t, dt, mass, x_old, hat);
    TRY(shell_newton_solve(m, &equation, m->x, counters));
    finish(m, dt, x_old);
    TRY(shell_assembly_strain(&m->assembly, m->x, m->strain_old));
    return STATUS_OK;
out:
    memcpy(m->x, x_old, count * sizeof *x_old);
    m->factored = -1;
    return st;
}

enum status shell_dynamics_step(struct shell_motion *m, struct counters *counters)
{
    enum status st;
    int done = 0;

    if (!m->started) {
        if (m->supports.moving) {
            struct newmark_held held = shell_motion_path(m, m->time, m->newmark.dt);
            for (int h = 0; h < m->supports.held_count; h++)
                m->newmark.v[m->supports.held[h]] = held.v[h];
        }
        st = shell_assembly_strain(&m->assembly, m->x, m->strain_old);
        if (st != STATUS_OK)
            return st;
        m->started = true;
    }
    while (done < FINEST) {
        int size = FINEST >> m->halvings;
        double dt = m->newmark.dt / (1 << m->halvings);
        double t = m->time + m->newmark.dt * done / FINEST;
        st = substep(m, t, dt, counters);
        if (st == STATUS_OK) {
            done += size;
            if (m->halvings && done % (2 * size) == 0)
                m->halvings--;
            continue;
        }
        if (!status_is_death(st) || m->halvings == HALVINGS)
            return st;
        m->halvings++;
    }
    return STATUS_OK;
}

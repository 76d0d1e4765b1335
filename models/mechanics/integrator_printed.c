/* integrator_printed.c - the paper's schemes, on matrices of the present shape:
 *
 *   printed      Ren et al. 2024, eq. 18-22 to the letter: K, M, b rebuilt on the present
 *                control points each step, d += dt v + dt^2/4 (a + a_new), P += d.
 *   incremental  the same with d = 0 after each step.
 *
 * Both start at d = v = a = 0 in a scene at rest. A free sheet under `printed` falls with
 * g (1 + mu) / (2 (1 - mu)): d is never reset, so it acts as velocity times dt, and K d as
 * a viscosity E dt. Body drag, of which the paper has none, therefore acts on d / dt there,
 * and on v elsewhere; and an initial velocity, which it has not either, begins as d / dt.
 *
 * Of contact, the paper says only that it is looked for at the control net (4.2), so
 * that `printed` and `incremental` do the least: after a step, and the damping of
 * velocities, what is inside a body, of the control points or samples of both faces, is put
 * on its surface (contact_outside.h), and velocities lose what points into the body. Let s
 * be the way of the body's point in the step, and n its normal. A body that goes on at its
 * speed s / dt is not entered by a point that goes on with it, under no force, if
 *
 *   printed      d . n >= s . n  and  v . n >= 0, where d is the increment of P, and v dt
 *                that of d, 0 at a constant speed;
 *   incremental  d . n >= s . n  and  v . n >= s . n / dt, where v is the velocity of P.
 *
 * d and v lose what they lack of that; so afterwards d is not the last increment of P, but
 * what goes on from it. a stays: contact is an impulse at the step's end, and a, by which
 * loads and stress move the sheet, has none of it. There is no friction, no energy, and no
 * force to report. The sheet does not meet itself: that it crosses is counted where it is
 * looked at.
 */
#include <string.h>

#include "models/mechanics/integrator_newmark.h"
#include "models/mechanics/march_rest.h"

/* Returns held motion: d brings them to the path. `printed` takes v and a from the paper's
 * eq. 21. */
static struct march_held path_of(struct march *m, double t)
{
    const struct march_held held = march_path(m, t, m->dt);
    const int count = m->supports->held_count;
    double *d = m->held, *v = d + count, *a = v + count, dt = m->dt;

    for (int h = 0; h < count; h++) {
        const int u = m->supports->held[h];
        d[h] = m->rest[u] + d[h] - m->x[u];
        if (m->kinematics != KINEMATICS_PRINTED)
            continue;
        a[h] = 4 / (dt * dt) * (d[h] - m->d[u] - dt * m->v[u]) - m->a[u];
        v[h] = m->v[u] + dt / 2 * (m->a[u] + a[h]);
    }
    return held;
}

static enum status step(struct march *m, double t, struct counters *counters)
{
    enum status st;
    struct march_held held;
    const size_t count = march_count(m);

    if (m->kinematics == KINEMATICS_INCREMENTAL)
        memset(m->d, 0, count * sizeof *m->d);
    TRY(m->rebuild(m));
    counters->assemblies++;
    march_weigh(m);
    if (m->supports->moving)
        held = path_of(m, t + m->dt);
    TRY(system_update(&m->system, integrator_newmark_k(m), m->stiffness,
                      integrator_newmark_m(m), m->M));
    TRY(integrator_newmark_step(m, m->supports->moving ? &held : NULL, counters));
    if (m->weighed)
        integrator_newmark_weigh(m, 1);
    for (size_t k = 0; k < count; k++)
        m->x[k] += m->d[k];
out:
    return st;
}

/* Puts what the step led into bodies back. */
static void end(struct march *m, struct counters *counters)
{
    const double v = m->kinematics == KINEMATICS_PRINTED ? 0 : 1 / m->dt;
    const struct contact_outside_rate rate[] = {{m->d, 1}, {m->v, v}};

    if (m->outside.face[0].count)
        contact_outside_put(&m->outside, m->scene, m->time, m->dt, m->supports->free_index,
                            m->x, rate, counters);
}

const struct march_integrator integrator_printed = {
    .step = step, .end = end, .rest = march_rest_linear};

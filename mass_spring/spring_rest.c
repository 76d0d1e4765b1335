#include "mass_spring/spring_rest.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The most iterations, and the most long steps that leave only round-off's forces. */
enum { MOST_ITERATIONS = 5000, MOST_IDLE = 50 };
/* The equilibria along the path of supports that move. */
enum { PATH = 32 };

/* The largest residual force, relative to the largest force on a point. In thin sheets
 * round-off of the membrane's forces exceeds it: then a long step that moves nothing, in
 * lengths of the sheet, shows that rest is reached. */
static const double FORCE_TOLERANCE = 1e-8, MOVE_TOLERANCE = 1e-9, LONG_STEP = 1e6;
/* Round-off of energies over their sum; of second differences of places, which softening
 * takes, where the others take those of displacements. */
static const double ROUND_OFF = 1e-13, ROUND_OFF_SOFT = 1e-11;
/* Factors on the time step: growth after a good step, cut after a bad one. */
static const double GROWTH = 4, CUT = 0.1;

struct search {
    struct spring_motion *m;
    double *r, *d, *from; /* [nodes][3] residual force, step, last good positions      */
    double energy;        /* elastic and of the loads, at `from`                 [J]   */
    double slack;         /* work of round-off's forces over no distance         [J]   */
    double step;          /* pseudo-time                                         [s]   */
    double move;          /* move of the last step, INFINITY unless it was long  [m]   */
};

static double total_energy(const struct spring_motion *m)
{
    double energy = spring_motion_elastic(m);

    for (size_t n = 0; n < 3 * (size_t)m->net.mesh.nodes; n++)
        energy -= m->net.load[n] * (m->net.x[n] - m->net.mesh.rest[n]);
    return energy;
}

/* Computes the residual force s->r; returns its largest component. */
static double residual(const struct search *s)
{
    const struct spring_motion *m = s->m;
    const int *place = m->net.supports.free_index;
    size_t count = 3 * (size_t)m->net.mesh.nodes;
    double most = 0;

    memcpy(s->r, m->net.load, count * sizeof *s->r);
    if (spring_motion_stencil(m))
        spring_stencil_force_add(spring_motion_stencil(m), m->net.x, s->r);
    else
        spring_force_add(&m->springs, m->net.x, s->r);
    for (size_t n = 0; n < count; n++) {
        if (place[n] < 0)
            s->r[n] = 0;
        if (!(fabs(s->r[n]) <= most))
            most = fabs(s->r[n]);
    }
    return most;
}

/* Computes the tolerated force, and the round-off of eight springs at a point. */
static void allowed_forces(const struct spring_motion *m, double *wanted, double *rounding)
{
    double load = 0, position = 0, stiffness = 0;

    for (size_t n = 0; n < 3 * (size_t)m->net.mesh.nodes; n++) {
        load = fmax(load, fabs(m->net.load[n]));
        position = fmax(position, fabs(m->net.mesh.rest[n]));
    }
    for (int n = 0; n < m->springs.spring_count; n++)
        stiffness = fmax(stiffness, m->springs.springs[n].stiffness);
    *wanted = FORCE_TOLERANCE * load;
    *rounding = 8 * DBL_EPSILON * stiffness * position;
}

static enum status factor(const struct search *s, bool clamped)
{
    struct spring_newton *newton = &s->m->newton;
    const struct spring_net *net = &s->m->springs;
    const struct blocks *g = &net->graph;

    if (spring_motion_stencil(s->m))
        spring_stencil_jacobian(spring_motion_stencil(s->m), s->m->net.x, clamped,
                                newton->K);
    else if (clamped)
        spring_force_clamped(net, s->m->net.x, newton->hinges, newton->K);
    else
        spring_force_jacobian(net, s->m->net.x, newton->K);
    for (int a = 0; a < g->nodes; a++)
        for (int i = 0; i < 3; i++)
            newton->K[g->start[a]][4 * i] += s->m->net.mass[a] / (s->step * s->step);
    newton->at = s->m->net.x;
    return system_factor(&newton->system, 1, (const double(*)[9])newton->K, 0, NULL);
}

/* Solves s->d = K^-1 r. */
static enum status solve(const struct search *s, bool clamped, struct counters *counters)
{
    enum status st = factor(s, clamped);

    counters->factorisations++;
    memcpy(s->d, s->r, 3 * (size_t)s->m->net.mesh.nodes * sizeof *s->d);
    if (st == STATUS_OK) {
        counters->solves++;
        st = system_solve(&s->m->newton.system, s->d);
    }
    return st;
}

static bool is_unsolved(enum status st)
{
    return st == STATUS_INDEFINITE || st == STATUS_UNSOLVED;
}

/* Takes one step of pseudo-time from s->from; x returns there if it leads up. A step is
 * bad, too, where round-off leaves its system without a solution, as of strips with cells a
 * thousand times longer than wide. */
static enum status advance(struct search *s, struct counters *counters)
{
    enum status st;
    struct spring_motion *m = s->m;
    size_t count = 3 * (size_t)m->net.mesh.nodes;

    counters->assemblies++, counters->iterations++;
    st = solve(s, false, counters);
    if (is_unsolved(st))
        st = solve(s, true, counters);
    if (is_unsolved(st)) {
        s->step *= CUT;
        s->move = INFINITY;
        return STATUS_OK;
    }
    if (st != STATUS_OK)
        return st;
    double scale = fabs(s->energy) + 1e-300, move = 0;
    for (size_t n = 0; n < count; n++) {
        scale += fabs(m->net.load[n] * (m->net.x[n] - m->net.mesh.rest[n]));
        m->net.x[n] += s->d[n];
        move = fmax(move, fabs(s->d[n]));
    }
    const double energy = total_energy(m);
    const double round_off = m->stencil.soft.forms.count ? ROUND_OFF_SOFT : ROUND_OFF;
    if (energy <= s->energy + s->slack + round_off * scale) {
        s->energy = energy;
        s->move = s->step >= LONG_STEP ? move : INFINITY;
        s->step = fmin(GROWTH * s->step, 1e12);
        memcpy(s->from, m->net.x, count * sizeof *m->net.x);
    } else {
        s->step *= CUT;
        s->move = INFINITY;
        memcpy(m->net.x, s->from, count * sizeof *m->net.x);
    }
    return STATUS_OK;
}

static enum status search(struct search *s, struct counters *counters, struct message *why)
{
    enum status st = STATUS_OK;
    struct spring_motion *m = s->m;
    double wanted, rounding, force = residual(s);
    double still = MOVE_TOLERANCE * m->net.scene->length;

    memcpy(s->from, m->net.x, 3 * (size_t)m->net.mesh.nodes * sizeof *m->net.x);
    s->energy = total_energy(m);
    s->step = m->net.scene->step;
    s->move = INFINITY;
    allowed_forces(m, &wanted, &rounding);
    s->slack = rounding * still;
    for (int n = 0, idle = 0; force > wanted && idle < MOST_IDLE; n++) {
        if (n == MOST_ITERATIONS)
            return status_fail(
                why, STATUS_DIVERGED,
                "no equilibrium after %d iterations: a force of %g N is left", n, force);
        TRY(advance(s, counters));
        force = residual(s);
        if (force <= rounding && s->move < INFINITY)
            idle = s->move <= still ? MOST_IDLE : idle + 1;
        if (!isfinite(force))
            TRY(STATUS_NAN);
    }
out:
    return st;
}

enum status spring_rest_equilibrium(void *motion, struct counters *counters,
                                    struct message *why)
{
    enum status st = STATUS_OK;
    struct spring_motion *m = motion;
    size_t count = 3 * (size_t)m->net.mesh.nodes;
    double end = supports_rest_time(&m->net.supports, m->net.scene);
    struct search s = {.m = m};

    TRY(supports_allow_rest(&m->net.supports, m->net.scene, false, why));
    TRY(spring_newton_system(&m->newton));
    s.r = m->start, s.d = m->target;
    s.from = malloc(count * sizeof *s.from);
    if (!s.from)
        return STATUS_MEMORY;
    for (int n = m->net.supports.moving ? 0 : PATH; n <= PATH; n++) {
        net_hold(&m->net, end * n / PATH);
        if (m->net.supports.free_count)
            TRY(search(&s, counters, why));
    }
    spring_motion_place(m, end);
out:
    iterative_forget(m->newton.system.iterative); /* its matrix is not that of steps */
    free(s.from);
    return st;
}

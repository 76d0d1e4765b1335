#include "models/linalg/large_rest.h"

#include <math.h>
#include <string.h>

#include "models/linalg/large_newton.h"
#include "models/linalg/pencil.h"

static const struct large_path statics = {.s1 = 1, .g1 = 1};

/* First increment of the load, and the smallest before giving up. */
static const double FIRST_INCREMENT = 1.0 / 8, SMALLEST_INCREMENT = 1e-7;

static void begin(struct large_motion *m)
{
    struct newmark *n = m->newmark;
    size_t count = 3 * (size_t)m->graph->nodes;

    memset(n->d, 0, 3 * count * sizeof *n->d); /* d, v and a */
    memcpy(m->x, m->rest, count * sizeof *m->x);
    supports_shift(m->supports, m->scene, 0, m->held);
    m->started = m->rested = false;
    m->factored = -1;
    m->halvings = 0;
}

/* Loads grow from 0 to 1; the next shape is guessed along the last two. */
static enum status load_steps(struct large_motion *m, struct counters *counters)
{
    enum status st = STATUS_OK;
    size_t count = 3 * (size_t)m->graph->nodes;
    double *last = m->room, *before = m->room + count;
    double load = 0, increment = FIRST_INCREMENT, last_increment = 0;

    memcpy(last, m->x, count * sizeof *last);
    memcpy(before, m->x, count * sizeof *last);
    while (load < 1) {
        struct large_equation q = {.path = statics, .limit = 30};
        long iterations = counters->iterations;
        q.load = fmin(1, load + increment);
        double ahead = last_increment > 0 ? (q.load - load) / last_increment : 0;
        TRY(m->body.strain(m->body.self, last, m->strain_old));
        for (size_t t = 0; t < count; t++)
            m->x[t] = last[t] + ahead * (last[t] - before[t]);
        for (int h = 0; h < m->supports->held_count; h++) {
            int u = m->supports->held[h];
            m->x[u] = m->rest[u] + q.load * m->held[h];
        }
        m->factored = -1;
        st = large_newton_solve(m, &q, m->x, counters);
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
static enum status relax(struct large_motion *m, struct counters *counters)
{
    enum { STEPS = 400 };
    enum status st = STATUS_DIVERGED;
    size_t count = 3 * (size_t)m->graph->nodes;
    double *last = m->room, first = 1 / (m->scene->step * m->scene->step), mass = first;

    for (int n = 0; n < STEPS; n++) {
        bool final = mass < 1e-8 * first;
        const struct large_equation q = {
            .path = statics, .mass = final ? 0 : mass, .hat = last, .load = 1, .limit = 30};
        memcpy(last, m->x, count * sizeof *last);
        TRY(m->body.strain(m->body.self, last, m->strain_old));
        m->factored = -1;
        st = large_newton_solve(m, &q, m->x, counters);
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

enum status large_rest_equilibrium(struct large_motion *m, struct counters *counters,
                                   struct message *why)
{
    enum status st;

    begin(m);
    st = load_steps(m, counters);
    if (status_is_death(st)) {
        begin(m);
        for (int h = 0; h < m->supports->held_count; h++)
            m->x[m->supports->held[h]] += m->held[h];
        st = relax(m, counters);
    }
    if (st == STATUS_INDEFINITE)
        status_fail(why, st,
                    "the stiffness is singular to working accuracy: the supports "
                    "leave the sheet free to move");
    else if (status_is_death(st))
        status_fail(why, st, "static equilibrium not found: %s", status_text(st));
    m->rested = st == STATUS_OK;
    return st;
}

enum status large_rest_modes(struct large_motion *m, int count, double *omega,
                             struct message *why)
{
    enum status st;
    const struct pencil p = {m->graph, (const double(*)[9])m->K, m->M, .stressed = true};

    m->factored = -1;
    TRY(m->body.tangent(m->body.self, &statics, m->x, (struct large_foresight){0}, m->K));
    TRY(pencil_modes(&p, m->supports, NULL, count, omega, why));
out:
    return st;
}

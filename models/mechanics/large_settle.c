#include "models/mechanics/large_settle.h"

#include <math.h>
#include <string.h>

#include "models/mechanics/large_newton.h"
#include "models/vector.h"

/* Rest: the unbalanced share of the loads and the supports' reactions is below this. */
static const double RESIDUAL = 1e-6;

/* The error of a step, in the slip from which friction is whole: friction is off by the
 * square of it. */
static const double SLIP = 1e-3;

/* The mass is multiplied by FAILED after a step that failed, by SHORTER where the step
 * needed a tangent without stress - a shape with an unstable way out is to be left - or
 * moved too far, and by GOOD where it went well. */
static const double FAILED = 8, SHORTER = 2, GOOD = 0.5;

/* The share of the length beyond which a node's move in a step makes the next one shorter;
 * less than half of it makes the next longer: the way down is followed, not leapt. */
static const double FARTHEST = 0.02;

/* The mass of the longest step, relative to that of the scene's step. */
static const double LONGEST = 1e-8;

enum { MOST_STEPS = 600 };

/* Begins a step at `last` as one of the scene's: friction is that of the way in its time.
 */
static void begin_contact(struct large_motion *m, const double *last)
{
    contact_begin_rest(m->contact, supports_rest_time(m->supports, m->scene),
                       m->scene->step, last);
}

/* Returns the slip of a step from which friction is whole, INFINITY without friction. */
static double whole_slip(const struct large_motion *m)
{
    return m->contact && contact_rubs(m->contact) ? m->contact->body.creep * m->scene->step
                                                  : INFINITY;
}

/* Returns the friction of what slips faster than friction lets creep what it holds. */
static double sliding(const struct contact *c)
{
    double sum = 0;

    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++)
        sum += t->grip > 0 ? 0 : vector_length(t->rub);
    return sum;
}

/* Computes the unbalanced share of the loads and the supports' reactions at m->x. */
static enum status unbalanced(struct large_motion *m, double *share)
{
    enum status st;
    const size_t count = 3 * (size_t)m->graph->nodes;
    double *f = m->room + 2 * count, *load = f + count, left = 0, borne = 0;

    memcpy(load, m->load, count * sizeof *load);
    if (m->pressure)
        pressure_force(m->pressure, 1, NULL, 1, m->x, load);
    TRY(large_body_force(&m->body, &large_path_statics, m->x, f));
    for (size_t t = 0; t < count; t++)
        f[t] = load[t] - f[t];
    if (m->contact) {
        TRY(contact_find(m->contact, m->x));
        contact_force(m->contact, f);
        left = sliding(m->contact);
    }
    for (int t = 0; t < 3 * m->graph->nodes; t++) {
        if (m->supports->free_index[t] >= 0)
            continue;
        borne += fabs(f[t]);
        f[t] = 0;
    }
    for (int a = 0; a < m->graph->nodes; a++) {
        left += vector_length(f + 3 * (size_t)a);
        borne += vector_length(load + 3 * (size_t)a);
    }
    *share = left > 0 ? left / borne : 0;
out:
    return st;
}

/* Steps from m->x, which stays there on failure; *moved: the farthest that a node moved. */
static enum status step(struct large_motion *m, double mass, double *moved,
                        struct counters *counters)
{
    enum status st;
    size_t count = 3 * (size_t)m->graph->nodes;
    double *last = m->room, *way = m->room + 2 * count;
    const struct large_equation q = {
        .path = {.s1 = 1, .g1 = 1, .x_old = last, .strain_old = m->strain_old},
        .mass = mass,
        .hat = last,
        .load = 1,
        .tolerance = SLIP * whole_slip(m),
        .limit = 30};

    memcpy(last, m->x, count * sizeof *last);
    if (m->contact)
        begin_contact(m, last);
    TRY(large_body_strain(&m->body, last, m->strain_old));
    m->factored = -1;
    st = large_newton_solve(m, &q, m->x, counters);
    for (size_t t = 0; t < count; t++)
        way[t] = m->x[t] - last[t];
    *moved = blocks_longest(m->graph->nodes, way);
    if (st != STATUS_OK)
        memcpy(m->x, last, count * sizeof *last);
out:
    return st;
}

/* Returns the factor from this step's mass to the next one's. */
static double growth(const struct large_motion *m, enum status st, double moved)
{
    double farthest = FARTHEST * m->scene->length;

    if (st != STATUS_OK)
        return FAILED;
    if (m->stressless || moved > farthest)
        return SHORTER;
    return moved < GOOD * farthest ? GOOD : 1;
}

enum status large_settle(struct large_motion *m, struct counters *counters,
                         struct message *why)
{
    enum status st = STATUS_OK;
    double first = 1 / (m->scene->step * m->scene->step), mass = first;
    double left = INFINITY, moved = 0;
    int n = 0;

    for (; n < MOST_STEPS && left > RESIDUAL; n++) {
        st = step(m, mass, &moved, counters);
        if (st != STATUS_OK && !status_is_death(st))
            goto out;
        mass = fmax(mass * growth(m, st, moved), LONGEST * first);
        if (st == STATUS_OK)
            TRY(unbalanced(m, &left));
    }
    if (left > RESIDUAL)
        TRY(status_fail(why, STATUS_DIVERGED,
                        "no equilibrium in %d steps: forces of %.3g of the loads are left",
                        n, left));
    if (m->contact)
        memcpy(m->push, m->contact->force, sizeof m->push);
    status_fail(why, STATUS_OK,
                "Relaxed in %d steps: forces of %.2g of the loads are left unbalanced.", n,
                left);
out:
    m->factored = -1;
    return st;
}

#include "models/mechanics/large_motion.h"

#include <stdlib.h>
#include <string.h>

#include "models/mechanics/contact_system.h"
#include "models/mechanics/large_leapfrog.h"
#include "models/mechanics/large_newton.h"

/* A step of Newton's method with an old tangent is good enough if it is this much shorter
 * than the last: an assembly and a factorisation cost as much as three or four of them. */
static const double CHORD = 0.4;

const double large_motion_lag = 1.0 / 16;

/* The most iterations of an easy substep: where nothing damps, harder ones would fail if
 * they were longer, and longer ones are not tried (edge_drop, undamped, no viscosity, to 2
 * s, shell 10x10, p = 3: .72 of the assemblies of trying each time; 6 and 10 do as well).
 */
enum { EASY = 8 };

/* The substeps that a viscosity stays for when it comes first: what is fast shrinks to a
 * third in each, and has 2e-5 left. Each time that it comes back it stays twice as long, so
 * that a sheet which needs it does not fail again and again. */
enum { STAY = 10, LONGEST = 1 << 20 };

/* Substeps are step / 2^0 ... step / 2^HALVINGS. */
enum { HALVINGS = 8, FINEST = 1 << HALVINGS };

void large_motion_clear(struct large_motion *m)
{
    large_leapfrog_free(m->leapfrog);
    contact_coupled_clear(&m->coupled);
    free(m->room);
    free(m->strain_old);
    memset(m, 0, sizeof *m);
}

enum status large_motion_init(struct large_motion *m)
{
    size_t bytes = 3 * (size_t)m->graph->nodes * sizeof(double);

    m->factored = -1;
    m->room = malloc(6 * bytes);
    size_t strains = large_body_strains(&m->body);
    const bool viscous = m->lag > 0 || m->relief;
    m->strain_old = malloc((1 + m->rings + viscous) * strains * sizeof *m->strain_old);
    m->strain_mean = m->rings && m->strain_old ? m->strain_old + strains : NULL;
    m->gain = viscous && m->strain_old ? m->strain_old + (1 + m->rings) * strains : NULL;
    return m->room && m->strain_old ? STATUS_OK : STATUS_MEMORY;
}

static size_t count_of(const struct large_motion *m)
{
    return 3 * (size_t)m->graph->nodes;
}

/* Moves held unknowns of x to the step's end; mass (x - hat) becomes their inertia. */
static void move_supports(struct large_motion *m, double t, double dt, double mass,
                          const double *x_old, double *hat)
{
    struct newmark *n = m->newmark;
    struct supports *s = m->supports;

    supports_turn(s, m->scene, t, t + dt, m->x);
    struct newmark_held held = newmark_follow(s, m->scene, t + dt, dt, m->held);
    for (int h = 0; h < s->held_count; h++) {
        const double x = supports_get(s, h, m->rest) + held.d[h];
        const double rate = (x - supports_get(s, h, x_old)) / dt;
        const double kick = (held.v[h] - supports_get(s, h, n->v)) / dt;
        supports_set(s, h, m->x, x);
        supports_set(s, h, hat, x - (kick + n->alpha * rate) / mass);
    }
    if (s->moving)
        supports_carry(s, x_old, m->x);
}

/* Computes new velocities; a keeps the step's mean acceleration for the next predictor.
 * Those of supports that turn grow with the way that the sheet is stretched in them. */
static void finish(struct large_motion *m, double t, double dt, const double *x_old)
{
    struct newmark *n = m->newmark;
    size_t count = count_of(m);
    const double *v_held = m->held + m->supports->held_count;

    if (m->supports->moving && m->supports->frame_count) {
        supports_turn(m->supports, m->scene, t, t + dt, m->x);
        v_held = newmark_follow(m->supports, m->scene, t + dt, dt, m->held).v;
    }
    for (size_t k = 0; k < count; k++) {
        double mean = (m->x[k] - x_old[k]) / dt, v = m->euler ? mean : 2 * mean - n->v[k];
        n->a[k] = (v - n->v[k]) / dt;
        n->v[k] = v;
    }
    for (int h = 0; h < m->supports->held_count; h++)
        supports_set(m->supports, h, n->v, v_held[h]);
}

/* Ends a substep that may touch, and adds its share of the step's force. */
static enum status end_contact(struct large_motion *m, double dt)
{
    enum status st = contact_find(m->contact, m->x);

    contact_system_land(m->contact, m->graph, m->M, m->supports, m->x, m->newmark->v,
                        m->newmark->work);
    for (int i = 0; i < 3; i++)
        m->push[i] += dt / m->newmark->dt * m->contact->force[i];
    return st;
}

void large_motion_contact(const struct large_motion *m, struct model_contact *contact)
{
    contact_report(m->contact, contact);
    memcpy(contact->force, m->push, sizeof contact->force);
}

/* Stores the strains where a step ends, and the mean and the gain of the step. */
static enum status keep_strains(struct large_motion *m, double dt)
{
    const size_t count = large_body_strains(&m->body);
    double *mean = m->strain_mean, *gain = m->gain;

    if (mean)
        memcpy(mean, m->strain_old, count * sizeof *mean);
    if (gain)
        memcpy(gain, m->strain_old, count * sizeof *gain);
    enum status st = large_body_strain(&m->body, m->x, m->strain_old);
    for (size_t n = 0; mean && n < count; n++)
        mean[n] = (mean[n] + m->strain_old[n]) / 2;
    for (size_t n = 0; gain && n < count; n++)
        gain[n] = m->strain_old[n] - gain[n];
    m->gain_dt = dt;
    return st;
}

static enum status substep(struct large_motion *m, double t, double dt,
                           struct counters *counters)
{
    enum status st;
    struct newmark *n = m->newmark;
    size_t count = count_of(m);
    double *x_old = m->room, *hat = m->room + count;
    double end = m->euler ? 1 : 0.5; /* where forces are taken, in steps from x_old */
    double mass = 1 / (end * dt * dt) + n->alpha / dt, damping = n->beta / dt;
    const struct large_equation equation = {
        .path = {.s0 = 1 - end - damping,
                 .s1 = end + damping,
                 .g1 = end,
                 .lag = m->lag,
                 /* a longer step would gain energy by more than the gain itself */
                 .back = dt < m->gain_dt ? m->lag * dt / m->gain_dt : m->lag,
                 .x_old = x_old,
                 .strain_old = m->strain_old,
                 .gain = m->lag > 0 ? m->gain : NULL},
        .mass = mass,
        .hat = hat,
        .load = 1,
        /* a step that no other Newton step will correct needs its own tangent */
        .chord = m->full || m->enough ? 0 : CHORD,
        .limit = 40,
        .enough = m->enough,
    };

    memcpy(x_old, m->x, count * sizeof *x_old);
    for (size_t k = 0; k < count; k++) {
        hat[k] = x_old[k] + n->v[k] / (end * dt) / mass;
        if (m->enough != 1)
            m->x[k] += dt * (n->v[k] + dt * end * n->a[k]);
    }
    if (m->contact) {
        contact_begin(m->contact, t, dt, x_old);
        m->contact->middle = !m->euler;
        contact_lead(m->contact, m->x);
    }
    move_supports(m, t, dt, mass, x_old, hat);
    TRY(large_newton_solve(m, &equation, m->x, counters));
    finish(m, t, dt, x_old);
    if (m->contact)
        TRY(end_contact(m, dt));
    TRY(keep_strains(m, dt));
    return STATUS_OK;
out:
    memcpy(m->x, x_old, count * sizeof *x_old);
    m->factored = -1;
    return st;
}

/* Takes the viscosity on for a while. */
static void relieve(struct large_motion *m)
{
    m->lag = large_motion_lag;
    m->stays = m->stays ? m->stays < LONGEST ? 2 * m->stays : LONGEST : STAY;
    m->stay = m->stays;
}

static enum status all_substeps(struct large_motion *m, double time,
                                struct counters *counters)
{
    enum status st;
    int done = 0;
    bool viscous = false;

    memset(m->push, 0, sizeof m->push);
    m->rested = false;
    if (!m->started) {
        large_body_follow(m, time);
        st = large_body_strain(&m->body, m->x, m->strain_old);
        if (st != STATUS_OK)
            return st;
        if (m->strain_mean)
            memcpy(m->strain_mean, m->strain_old,
                   large_body_strains(&m->body) * sizeof *m->strain_mean);
        if (m->gain)
            memset(m->gain, 0, large_body_strains(&m->body) * sizeof *m->gain);
        m->gain_dt = m->newmark->dt;
        m->started = true;
    }
    while (done < FINEST) {
        int size = FINEST >> m->halvings;
        double dt = m->newmark->dt / (1 << m->halvings);
        double t = time + m->newmark->dt * done / FINEST;
        long before = counters->iterations;
        st = substep(m, t, dt, counters);
        if (st == STATUS_OK) {
            done += size;
            counters->substeps++;
            viscous |= m->lag > 0;
            if (m->stay && !--m->stay)
                m->lag = 0;
            bool easy = !m->rings || counters->iterations - before <= EASY;
            if (m->halvings && done % (2 * size) == 0 && easy)
                m->halvings--;
            continue;
        }
        if (!status_is_death(st) || m->halvings == HALVINGS)
            return st;
        if (m->relief && m->lag == 0)
            relieve(m);
        else
            m->halvings++;
    }
    counters->viscous += m->relief && viscous;
    return STATUS_OK;
}

enum status large_motion_step(struct large_motion *m, double time,
                              struct counters *counters)
{
    enum status st = m->leapfrog ? large_leapfrog_step(m, time, counters)
                                 : all_substeps(m, time, counters);

    system_work(m->system, counters);
    return st;
}

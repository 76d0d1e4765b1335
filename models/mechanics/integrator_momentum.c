/* integrator_momentum.c - implicit steps at large displacements.
 *
 * Simo and Tarnow's energy-momentum scheme (ZAMP 43, 1992): between x_0 and x_1 of a step
 *   M (v_1 - v_0)/dt + alpha M (x_1 - x_0)/dt + f = load,   v_0 + v_1 = 2 (x_1 - x_0)/dt,
 * where f are the forces of the mean stress (not of the mean shape) on the mean geometry:
 * a sheet that turns rigidly is not strained by it, as the mid-point rule would. Momenta
 * are kept exactly. Where strains are quadratic in x (a solid's, a shell's membrane) energy
 * is lost by the algorithmic viscosity `lag` alone, against the ringing of a membrane,
 * which nothing else damps: beside the mean strain (e_0 + e_1)/2 the stress takes lag (e_1
 * - 2 e_0 + e_-1),   e_-1 the strain a step ago, which is of second order as the rest is.
 * With stress E e the energy and E/2 lag (e_1 - e_0)^2 fall together by E/2 lag (e_1 - 2
 * e_0 + e_-1)^2 in each step, of any length. What is far faster than the step shrinks by
 * the roots of (1/2 + lag) z^2 + (1/2 - 2 lag) z + lag: most with lag = 1/16, to a third.
 * Undamped swings of coarse nets then need far fewer assemblies (cantilever, shell_3 10x10:
 * 650 for 2038). A shell's bending keeps energy to third order in the step. Stiffness
 * damping is beta times the rate of stress, which knows no rigid motion.
 *
 * euler: implicit Euler instead, first order, which damps what is fast:
 *   M (v_1 - v_0)/dt + alpha M v_1 + f(x_1) + beta rate = load,   v_1 = (x_1 - x_0)/dt;
 * one Newton iteration of it (enough = 1), from x_0, is the step of Baraff and Witkin 1998.
 *
 * Contact adds the pressure at x_1: what it stores in a step is no more than the work that
 * the motion does on it, whatever the step. It acts along the mean normal of the step. The
 * normal at x_1 leans forward by half the turn that a sheet makes in a step as it slides
 * over a round body, and would push it on by p v dt / 2R: of first order, and large beside
 * friction (.04 p over a rod of 30 mm at .5 m/s in steps of 5 ms). Where the sheet meets
 * itself the normal is that at x_1: a place's own slip hides the turn of the pair.
 */
#include <math.h>
#include <string.h>

#include "models/mechanics/contact_system.h"
#include "models/mechanics/large_newton.h"
#include "models/mechanics/march_rest.h"

/* A step of Newton's method with an old tangent is good enough if it is this much shorter
 * than the last: an assembly and a factorisation cost as much as three or four of them,
 * which then shrink to .04, as far as a new tangent's first (newton.c). (tools/constants:
 * with .2 and .8 three sheets that swing take 3 to 11 % more work and 3 % less to 4 % more,
 * a tangent counted as 4.5 solutions.) */
static const double CHORD = 0.4;

/* The substeps that a viscosity stays for when it comes first: what is fast shrinks to a
 * third in each, and has 2e-5 left. Each time that it comes back it stays twice as long, so
 * that a sheet which needs it does not fail again and again. */
enum { STAY = 10, LONGEST = 1 << 20 };

/* Substeps are step / 2^0 ... step / 2^HALVINGS. */
enum { HALVINGS = 8, FINEST = 1 << HALVINGS };

/* Moves held unknowns of x to the step's end; mass (x - hat) becomes their inertia. */
static void move_supports(struct march *m, double t, double dt, double mass,
                          const double *x_old, double *hat)
{
    struct supports *s = m->supports;

    supports_turn(s, m->scene, t, t + dt, m->x);
    struct march_held held = march_path(m, t + dt, dt);
    for (int h = 0; h < s->held_count; h++) {
        const double x = supports_get(s, h, m->rest) + held.d[h];
        const double rate = (x - supports_get(s, h, x_old)) / dt;
        const double kick = (held.v[h] - supports_get(s, h, m->v)) / dt;
        supports_set(s, h, m->x, x);
        supports_set(s, h, hat, x - (kick + m->alpha * rate) / mass);
    }
    if (s->moving)
        supports_carry(s, x_old, m->x);
}

/* Computes new velocities; a keeps the step's mean acceleration for the next predictor.
 * Those of supports that turn grow with the way that the sheet is stretched in them. */
static void finish(struct march *m, double t, double dt, const double *x_old)
{
    size_t count = march_count(m);
    const double *v_held = m->held + m->supports->held_count;

    if (m->supports->moving && m->supports->frame_count) {
        supports_turn(m->supports, m->scene, t, t + dt, m->x);
        v_held = march_path(m, t + dt, dt).v;
    }
    for (size_t k = 0; k < count; k++) {
        double mean = (m->x[k] - x_old[k]) / dt, v = m->euler ? mean : 2 * mean - m->v[k];
        m->a[k] = (v - m->v[k]) / dt;
        m->v[k] = v;
    }
    for (int h = 0; h < m->supports->held_count; h++)
        supports_set(m->supports, h, m->v, v_held[h]);
}

/* Guesses the end of a step: its gain of velocity by a polynomial through the last ones,
 * and none where the last step touched, since what contact adds to it changes at once. */
static void guess(struct march *m, double dt, double end)
{
    const size_t count = march_count(m);

    if (m->contact && m->contact->count)
        end = 0;
    for (size_t t = 0; t < count; t++) {
        double gain = m->orders && dt == m->past_dt ? 0 : dt * m->a[t];
        for (int k = 0; k < m->orders && dt == m->past_dt; k++)
            gain += m->past[k * count + t];
        m->x[t] += dt * (m->v[t] + end * gain);
    }
}

/* Enters the gain of a step and chooses by how many differences the next is extrapolated:
 * as many as would have foretold this one best, which after a start, with zeros for what is
 * not known, is one. */
static void learn(struct march *m, double dt)
{
    const size_t count = march_count(m);
    double *change = m->work, least = INFINITY;

    if (dt != m->past_dt)
        memset(m->past, 0, MARCH_GAINS * count * sizeof *m->past);
    m->past_dt = dt;
    for (size_t t = 0; t < count; t++)
        change[t] = dt * m->a[t];
    for (int k = 0; k <= MARCH_GAINS; k++) {
        double *known = m->past + k * count, size = 0;
        for (size_t t = 0; t < count; t++)
            size += change[t] * change[t];
        if (k > 0 && size < least)
            least = size, m->orders = k;
        for (size_t t = 0; k < MARCH_GAINS && t < count; t++) {
            const double was = known[t];
            known[t] = change[t];
            change[t] -= was;
        }
    }
}

/* Ends a substep that may touch, and adds its share of the step's force. */
static enum status end_contact(struct march *m, double dt)
{
    enum status st = contact_find(m->contact, m->x);

    contact_system_land(m->contact, m->graph, m->M, m->supports, m->x, m->v, m->work);
    contact_force_bodies(m->contact, m->x, dt / m->scene->step, m->push);
    return st;
}

/* Stores the strains where a step ends, and the gain of the step. */
static enum status keep_strains(struct march *m, double dt)
{
    const size_t count = large_body_strains(&m->body);

    if (m->body.plain) /* nobody reads them */
        return STATUS_OK;
    double *gain = m->gain;

    if (gain)
        memcpy(gain, m->strain_old, count * sizeof *gain);
    enum status st = large_body_strain(&m->body, m->x, m->strain_old);
    for (size_t n = 0; gain && n < count; n++)
        gain[n] = m->strain_old[n] - gain[n];
    m->gain_dt = dt;
    return st;
}

static enum status substep(struct march *m, double t, double dt, struct counters *counters)
{
    enum status st;
    size_t count = march_count(m);
    double *x_old = m->newton, *hat = m->newton + count;
    double end = m->euler ? 1 : 0.5; /* where forces are taken, in steps from x_old */
    double mass = 1 / (end * dt * dt) + m->alpha / dt, damping = m->V ? 0 : m->beta / dt;
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
        .drag = 1 / dt,
        .viscosity = m->V ? m->beta / dt : 0,
        .tolerance = m->tolerance,
        /* a step that no other Newton step will correct needs its own tangent; touches that
         * couple have a factor even where the rest is iterated */
        .chord = (m->full && !m->coupled.used) || m->enough ? 0 : CHORD,
        .limit = 40,
        .enough = m->enough,
    };

    memcpy(x_old, m->x, count * sizeof *x_old);
    for (size_t k = 0; k < count; k++)
        hat[k] = x_old[k] + m->v[k] / (end * dt) / mass;
    if (m->V)
        TRY(large_body_tangent(&m->body, &equation.path, x_old, (struct large_foresight){0},
                               m->V));
    if (m->air.density > 0)
        air_blow(&m->air, m->scene, t + end * dt);
    if (m->enough != 1)
        guess(m, dt, end);
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
    if (m->weighed)
        TRY(large_newton_weigh(m, &equation, dt / m->scene->step));
    if (m->learns)
        learn(m, dt);
    TRY(keep_strains(m, dt));
    return STATUS_OK;
out:
    memcpy(m->x, x_old, count * sizeof *x_old);
    m->factored = -1;
    return st;
}

/* Takes the viscosity on for a while. */
static void relieve(struct march *m)
{
    m->lag = march_lag;
    m->stays = m->stays ? m->stays < LONGEST ? 2 * m->stays : LONGEST : STAY;
    m->stay = m->stays;
}

static enum status step(struct march *m, double time, struct counters *counters)
{
    enum status st;
    int done = 0;
    bool viscous = false;

    m->rested = false;
    if (!m->started) {
        march_follow(m, time);
        st = large_body_strain(&m->body, m->x, m->strain_old);
        if (st != STATUS_OK)
            return st;
        if (m->gain)
            memset(m->gain, 0, large_body_strains(&m->body) * sizeof *m->gain);
        m->gain_dt = m->dt;
        m->started = true;
    }
    while (done < FINEST) {
        int size = FINEST >> m->halvings;
        double dt = m->dt / (1 << m->halvings);
        double t = time + m->dt * done / FINEST;
        st = substep(m, t, dt, counters);
        if (st == STATUS_OK) {
            done += size;
            counters->substeps++;
            viscous |= m->lag > 0;
            if (m->stay && !--m->stay)
                m->lag = 0;
            if (m->halvings && done % (2 * size) == 0)
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

const struct march_integrator integrator_momentum = {
    .step = step, .rest = march_rest_equilibrium, .modes = march_rest_modes};

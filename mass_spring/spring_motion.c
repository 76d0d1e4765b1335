#include "mass_spring/spring_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/mechanics/frequency.h"
#include "models/room.h"
#include "models/vector.h"

/* The share of the explicit method's greatest step that it chooses: springs that turn and
 * stretch are a little stiffer than at rest. */
static const double LIMIT_SHARE = 0.8;

/* Newton's tolerance, in rest lengths of the shortest spring. */
static const double DEFAULT_TOLERANCE = 1e-6;

static enum status allocate(struct spring_motion *m)
{
    size_t nodes = (size_t)m->net.mesh.nodes;
    size_t pairs = (size_t)m->springs.graph.start[nodes];

    return room_cut(&m->room, ROOM(m->weight, nodes), ROOM(m->start, 3 * nodes),
                    ROOM(m->target, 3 * nodes), ROOM(m->gain, SPRING_GAINS * 3 * nodes),
                    ROOM(m->V, m->net.beta > 0 ? pairs : 0));
}

/* Finds the largest angular frequency about rest; newton.K is work. */
static enum status rest_frequency(struct spring_motion *m, double *omega)
{
    spring_force_jacobian(&m->springs, m->net.mesh.rest, m->newton.K);
    return frequency_largest(&m->springs.graph, &m->net.supports, m->net.mass, NULL,
                             (const double(*)[9])m->newton.K, omega);
}

/* Sets the length of a step. */
static void set_step(struct spring_motion *m, double dt)
{
    m->dt = dt;
    for (int a = 0; a < m->net.mesh.nodes; a++)
        m->weight[a] = m->net.mass[a] / (dt * dt) + m->net.drag[a] / dt;
    if (!m->net.contact)
        return;
    m->net.contact->steps = (int)lround(m->net.scene->step / dt), m->net.contact->dt = dt;
    for (int a = 0; a < m->net.mesh.nodes; a++)
        m->net.contact->compliance[a] = 1 / m->weight[a];
}

static enum status set_steps(struct spring_motion *m, const struct discretization *d,
                             struct message *why)
{
    enum status st = STATUS_OK;
    double omega;

    m->substeps = d->substeps > 0 ? d->substeps : 1;
    if (m->integrator == INTEGRATOR_EXPLICIT) {
        TRY(rest_frequency(m, &omega));
        m->limit = frequency_limit(omega, m->net.beta);
        TRY(frequency_steps(m->net.scene->step, m->limit, LIMIT_SHARE, d->substeps,
                            &m->substeps, why));
    }
    TRY(net_meet(&m->net));
    set_step(m, m->net.scene->step / m->substeps);
out:
    return st;
}

/* Makes leapfrog's and momentum's net. */
static enum status make_stencil(struct spring_motion *m, const struct discretization *d)
{
    enum status st;
    struct spring_forms forms = {0};

    TRY(spring_plate_make(m->net.scene, &m->net.mesh, d->parameters, &forms));
    TRY(spring_stencil_init(&m->stencil, m->net.scene, &m->net.mesh, &m->springs, &forms));
out:
    spring_forms_clear(&forms);
    return st;
}

static enum status make_leapfrog(struct spring_motion *m, const struct discretization *d,
                                 struct message *why)
{
    enum status st;
    const struct spring_body body = {.net = &m->net, .stencil = &m->stencil};

    TRY(make_stencil(m, d));
    TRY(spring_leapfrog_make(&body, d->precision, d->substeps, &m->leapfrog, why));
    m->limit = spring_leapfrog_limit(m->leapfrog);
out:
    return st;
}

static enum status make_march(struct spring_motion *m, const struct discretization *d,
                              struct message *why)
{
    enum status st;

    m->dt = m->net.scene->step;
    TRY(make_stencil(m, d));
    TRY(spring_strips_init(&m->strips, &m->stencil));
    m->march = (struct march){
        .body = m->strips.body,
        .scene = m->net.scene,
        .graph = &m->springs.graph,
        .mass = m->net.mass,
        .rest = m->net.mesh.rest,
        .x = m->net.x,
        .load = m->net.load,
        .net = {m->net.mesh.points[0], m->net.mesh.points[1], 1},
        .supports = &m->net.supports,
        .unknowns = "mid-surface points",
    };
    TRY(march_init_net(&m->march, d, why));
out:
    return st;
}

void spring_motion_clear(void *motion)
{
    struct spring_motion *m = motion;

    march_clear(&m->march);
    spring_strips_clear(&m->strips);
    spring_stencil_clear(&m->stencil);
    spring_leapfrog_free(m->leapfrog);
    spring_newton_clear(&m->newton);
    spring_net_clear(&m->springs);
    net_clear(&m->net);
    free(m->room);
    memset(m, 0, sizeof *m);
}

enum status spring_motion_init(struct spring_motion *m, const struct scene *scene,
                               const struct discretization *d, struct message *why)
{
    enum status st;
    bool squares =
        d->integrator == INTEGRATOR_LEAPFROG || d->integrator == INTEGRATOR_MOMENTUM;

    *m = (struct spring_motion){.integrator = d->integrator,
                                .degree = (int[]){0, 2, 3}[OWN(spring_own, d)->surface],
                                .strain_limit = OWN(spring_own, d)->strain_limit};
    TRY(net_init(&m->net, scene, d, why));
    TRY(spring_net_init(&m->springs, scene, &m->net.mesh, d->parameters, squares));
    TRY(spring_newton_init(&m->newton, &m->springs, &m->net.supports, d));
    if (!squares)
        TRY(spring_newton_system(&m->newton));
    TRY(allocate(m));
    m->limits.iterations = d->iterations;
    m->limits.tolerance = (d->tolerance > 0 ? d->tolerance : DEFAULT_TOLERANCE) *
                          fmin(m->net.mesh.cell[0], m->net.mesh.cell[1]);
    if (m->integrator == INTEGRATOR_LEAPFROG)
        TRY(make_leapfrog(m, d, why));
    else if (m->integrator == INTEGRATOR_MOMENTUM)
        TRY(make_march(m, d, why));
    else
        TRY(set_steps(m, d, why));
    m->rest_energy = spring_motion_elastic(m);
out:
    if (st != STATUS_OK)
        spring_motion_clear(m);
    return st;
}

/* Takes it where a step begins: what the step solves for is then the minimum of a
 * potential, and of first order all the same, as Euler's methods are
 * (tests/physics/time_order.c). */
static void damping_matrix(struct spring_motion *m)
{
    if (m->net.beta > 0)
        spring_force_clamped(&m->springs, m->net.x, m->newton.hinges, m->V);
}

/* Guesses the end of an implicit step: its velocity by extrapolating the last ones' gains,
 * by a polynomial. Not where a step is linearised once, at its start. */
static void guess(struct spring_motion *m)
{
    size_t count = 3 * (size_t)m->net.mesh.nodes;

    if (m->limits.iterations == 1)
        return;
    for (size_t n = 0; n < count; n++) {
        double v = m->net.v[n];
        for (int k = 0; k < m->gains; k++)
            v += m->gain[k * count + n];
        m->net.x[n] += m->dt * v;
    }
}

/* Enters the last gain, change[nodes][3], which is used up, and chooses by how many
 * differences the next is extrapolated: as many as would have foretold this one best, which
 * after a start, with zeros for what is not known, is one; none under contact. */
static void learn(struct spring_motion *m, double *change)
{
    size_t count = 3 * (size_t)m->net.mesh.nodes;
    double least = INFINITY;

    for (int k = 0; k <= SPRING_GAINS; k++) {
        double *known = m->gain + k * count, size = 0;
        for (size_t n = 0; n < count; n++)
            size += change[n] * change[n];
        if (k > 0 && size < least)
            least = size, m->gains = k;
        for (size_t n = 0; k < SPRING_GAINS && n < count; n++) {
            double was = known[n];
            known[n] = change[n];
            change[n] -= was;
        }
    }
    if (m->net.contact && m->net.contact->law.count)
        m->gains = 0;
}

/* Computes v. */
static enum status end_step(struct spring_motion *m)
{
    size_t count = 3 * (size_t)m->net.mesh.nodes;
    double *change = m->start;
    enum status st = STATUS_OK;

    for (size_t n = 0; n < count; n++) {
        double v = (m->net.x[n] - m->start[n]) / m->dt;
        change[n] = v - m->net.v[n];
        m->net.v[n] = v;
        if (!isfinite(v))
            st = STATUS_NAN;
    }
    if (m->integrator == INTEGRATOR_IMPLICIT && m->limits.iterations != 1)
        learn(m, change);
    return st;
}

static enum status step_implicit(struct spring_motion *m, double t,
                                 struct counters *counters)
{
    size_t count = 3 * (size_t)m->net.mesh.nodes;
    double dt = m->dt;
    struct spring_problem p = {.weight = m->weight,
                               .target = m->target,
                               .load = m->net.load,
                               .viscosity = m->net.beta / dt,
                               .V = (const double(*)[9])m->V,
                               .start = m->start,
                               .contact = m->net.contact ? &m->net.contact->law : NULL};

    damping_matrix(m);
    for (size_t n = 0; n < count; n++)
        m->target[n] =
            m->net.x[n] + m->net.v[n] * (m->net.mass[n / 3] / (dt * m->weight[n / 3]));
    guess(m);
    net_contact_begin(m->net.contact, t, m->start);
    if (m->net.contact && m->limits.iterations != 1)
        contact_lead(&m->net.contact->law, m->net.x);
    net_hold(&m->net, t);
    return spring_newton_solve(&m->newton, &p, &m->limits, m->net.x, counters);
}

static enum status step_explicit(struct spring_motion *m, double t,
                                 struct counters *counters)
{
    size_t count = 3 * (size_t)m->net.mesh.nodes;
    double *f = m->target, dt = m->dt;

    damping_matrix(m);
    if (m->net.beta > 0)
        blocks_multiply(&m->springs.graph, (const double(*)[9])m->V, m->net.v, f);
    for (size_t n = 0; n < count; n++)
        f[n] = m->net.load[n] - (m->net.beta > 0 ? m->net.beta * f[n] : 0);
    spring_force_add(&m->springs, m->net.x, f);
    for (size_t n = 0; n < count; n++) {
        double mass = m->net.mass[n / 3], drag = m->net.drag[n / 3];
        m->net.x[n] += dt * (mass * m->net.v[n] + dt * f[n]) / (mass + dt * drag);
    }
    net_hold(&m->net, t);
    counters->assemblies++;
    counters->solves++;
    return STATUS_OK;
}

/* --- Provot's inverse procedure (Provot 1995, section 4.2) -------------------------------
 *
 * After a step, the ends of every spring that has become longer than (1 + limit) times its
 * rest length are moved together along it, each half way, or one alone if the other is
 * held.
 *
 * Provot sweeps once and does not say what becomes of the velocities. Here sweeps go on, in
 * the order of the springs and back, until all springs keep the limit to a part in 1000 of
 * it, 1000 sweeps at most; the velocity is that of the corrected points, so that a net at
 * its limit does not gather speed.
 */

enum { MOST_SWEEPS = 1000 };

/* A spring is still too long if it exceeds the limit by more than this share of it. */
static const double SLACK = 1e-3;

/* Shortens a spring; returns whether it was too long and could be moved. */
static bool shorten(const struct spring *s, const struct supports *supports, double limit,
                    double *x)
{
    double e[3];
    const int *place = supports->free_index;
    bool moved = false;

    vector_between(x + 3 * (size_t)s->a, x + 3 * (size_t)s->b, e);
    double length = vector_length(e), excess = length - (1 + limit) * s->length;
    if (!(excess > SLACK * limit * s->length))
        return false;
    for (int i = 0; i < 3; i++) {
        size_t a = 3 * (size_t)s->a + (size_t)i, b = 3 * (size_t)s->b + (size_t)i;
        double by = excess / length * e[i];
        bool a_free = place[a] >= 0, b_free = place[b] >= 0;
        if (a_free)
            x[a] += b_free ? by / 2 : by;
        if (b_free)
            x[b] -= a_free ? by / 2 : by;
        moved |= a_free || b_free;
    }
    return moved;
}

void spring_motion_limit(const struct spring_net *net, const struct supports *supports,
                         double limit, double *x)
{
    bool moved = true;

    for (int sweep = 0; moved && sweep < MOST_SWEEPS; sweep++) {
        moved = false;
        for (int n = 0; n < net->spring_count; n++) {
            int at = sweep % 2 ? net->spring_count - 1 - n : n;
            moved |= shorten(&net->springs[at], supports, limit, x);
        }
    }
}

/* --- steps ---------------------------------------------------------------------------
 */

/* The most times that a step which dies is halved, with its halves in turn. */
enum { HALVINGS = 8 };

/* Takes a step that ends at t. */
static enum status substep(struct spring_motion *m, double t, int halvings,
                           struct counters *counters)
{
    enum status st;
    const size_t count = 3 * (size_t)m->net.mesh.nodes;
    const double dt = m->dt;

    memcpy(m->start, m->net.x, count * sizeof *m->net.x);
    if (m->integrator == INTEGRATOR_EXPLICIT)
        TRY(step_explicit(m, t, counters));
    else
        TRY(step_implicit(m, t, counters));
    if (m->strain_limit > 0)
        spring_motion_limit(&m->springs, &m->net.supports, m->strain_limit, m->net.x);
    if (m->integrator == INTEGRATOR_EXPLICIT)
        TRY(net_contact_project(m->net.contact, t, m->start, m->net.x));
    else
        net_contact_end(m->net.contact);
    counters->substeps++;
    return end_step(m);
out:
    if (m->integrator == INTEGRATOR_EXPLICIT || !status_is_death(st) ||
        halvings == HALVINGS)
        return st;
    memcpy(m->net.x, m->start, count * sizeof *m->net.x);
    m->gains = 0; /* of steps as long */
    set_step(m, dt / 2);
    st = substep(m, t - dt / 2, halvings + 1, counters);
    if (st == STATUS_OK)
        st = substep(m, t, halvings + 1, counters);
    set_step(m, dt);
    return st;
}

/* Computes v <- factor v. The explicit method's v is that of half a step ago: the present
 * forces bring it up to now and back again, or modes near the limit that keep step with the
 * frames would take energy from the scaling. */
static void scale_velocity(struct spring_motion *m, double factor)
{
    size_t count = 3 * (size_t)m->net.mesh.nodes;
    bool behind = m->integrator == INTEGRATOR_EXPLICIT;
    double *f = m->target;

    if (factor == 1)
        return;
    memcpy(f, m->net.load, count * sizeof *f);
    if (behind)
        spring_force_add(&m->springs, m->net.x, f);
    for (size_t n = 0; n < count; n++) {
        double lag = behind ? m->dt / 2 * f[n] / m->net.mass[n / 3] : 0;
        if (m->net.supports.free_index[n] >= 0)
            m->net.v[n] = factor * (m->net.v[n] + lag) - lag;
    }
}

enum status spring_motion_step(void *motion, struct counters *counters)
{
    enum status st = STATUS_OK;
    struct spring_motion *m = motion;

    if (m->leapfrog) {
        counters->steps++;
        return spring_leapfrog_frame(m->leapfrog, counters);
    }
    if (m->integrator == INTEGRATOR_MOMENTUM)
        return march_step(motion, counters);
    net_contact_frame(m->net.contact);
    for (int n = 0; n < m->substeps; n++, m->substep++)
        TRY(substep(m, (double)(m->substep + 1) / m->substeps * m->net.scene->step, 0,
                    counters));
    scale_velocity(m, m->net.keep);
    counters->steps++;
out:
    return st;
}

void spring_motion_contact(const void *motion, struct model_contact *contact)
{
    const struct spring_motion *m = motion;

    if (m->integrator == INTEGRATOR_MOMENTUM)
        march_contact(motion, contact);
    else
        net_touches(&m->net, contact);
}

const struct spring_stencil *spring_motion_stencil(const struct spring_motion *m)
{
    return m->stencil.mesh ? &m->stencil : NULL;
}

double spring_motion_elastic(const struct spring_motion *m)
{
    const struct spring_stencil *stencil = spring_motion_stencil(m);

    return stencil ? spring_stencil_energy(stencil, m->net.x)
                   : spring_force_energy(&m->springs, m->net.x);
}

void spring_motion_place(struct spring_motion *m, double t)
{
    memset(m->net.v, 0, 3 * (size_t)m->net.mesh.nodes * sizeof *m->net.v);
    m->substep = lround(t / m->dt);
    if (m->leapfrog)
        spring_leapfrog_place(m->leapfrog, t);
    if (m->integrator == INTEGRATOR_MOMENTUM)
        march_still(&m->march, t);
}

void spring_motion_energy(const void *motion, struct energy *energy)
{
    const struct spring_motion *m = motion;
    const double *v = m->integrator == INTEGRATOR_MOMENTUM ? m->march.v : m->net.v;

    if (m->leapfrog)
        spring_leapfrog_velocity(m->leapfrog, m->net.v);
    net_energy(&m->net, v, energy);
    energy->elastic = spring_motion_elastic(m) - m->rest_energy;
}

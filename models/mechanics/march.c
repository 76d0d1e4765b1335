#include "models/mechanics/march.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/damping.h"
#include "models/linalg/order.h"
#include "models/mechanics/pencil.h"
#include "models/room.h"

const double march_lag = 1.0 / 16; /* integrator_momentum.c */

/* --- life ----------------------------------------------------------------------------- */

#define NAMED(name, word, file) [INTEGRATOR_##name] = &integrator_##file,

static const struct march_integrator *integrator_of(const struct discretization *d)
{
    static const struct march_integrator *const named[] = {INTEGRATORS(NAMED)};

    return d->kinematics == KINEMATICS_NONLINEAR ? named[d->integrator]
           : d->kinematics == KINEMATICS_LINEAR  ? &integrator_newmark
                                                 : &integrator_printed;
}

bool march_explicit(const struct discretization *d)
{
    return integrator_of(d)->explicit;
}

void march_clear(struct march *m)
{
    if (m->own)
        m->integrator->clear(m);
    system_clear(&m->system);
    contact_coupled_clear(&m->coupled);
    if (m->contact)
        contact_clear(m->contact);
    free(m->contact);
    contact_outside_clear(&m->outside);
    pressure_clear(&m->pressure);
    air_clear(&m->air);
    free(m->dead);
    free(m->tangents);
    free(m->room);
    memset(m, 0, sizeof *m);
}

static enum status make_room(struct march *m)
{
    enum status st;
    const size_t count = march_count(m), pairs = (size_t)m->graph->start[m->graph->nodes];
    double *x = NULL, *load = NULL, *M = NULL;

    TRY(room_cut(&m->room, ROOM(m->d, 3 * count), ROOM(m->work, 3 * count),
                 ROOM(x, m->x ? 0 : count), ROOM(load, m->load ? 0 : count),
                 ROOM(M, m->mass ? pairs : 0),
                 ROOM(m->held, 4 * (size_t)supports_most(m->supports)),
                 ROOM(m->push, m->scene->obstacle_count),
                 ROOM(m->reaction, m->scene->support_count)));
    m->v = m->d + count, m->a = m->v + count;
    if (x)
        m->x = memcpy(x, m->rest, count * sizeof *x);
    if (M)
        m->M = M;
    for (int a = 0; M && a < m->graph->nodes; a++)
        M[m->graph->start[a]] = m->mass[a];
    if (load) {
        m->load = load;
        march_weigh(m);
    }
out:
    return st;
}

static enum status make_tangents(struct march *m)
{
    const size_t count = march_count(m), pairs = (size_t)m->graph->start[m->graph->nodes];
    const bool large = m->kinematics == KINEMATICS_NONLINEAR,
               viscous = m->lag > 0 || m->relief;
    const size_t strains = large ? large_body_strains(&m->body) : 0;
    const enum status st =
        room_cut(&m->tangents, ROOM(m->past, large && m->learns ? MARCH_GAINS * count : 0),
                 ROOM(m->V, large && m->body.plain && m->beta > 0 ? pairs : 0),
                 ROOM(m->newton, large ? (3 + NEWTON_ROOM) * count : 0),
                 ROOM(m->strain_old, (1 + viscous) * strains),
                 ROOM(m->K, large || !m->stiffness ? pairs : 0));

    m->gain = large && viscous ? m->strain_old + strains : NULL;
    m->factored = large ? -1 : 0;
    return st;
}

static enum status make_contact(struct march *m)
{
    enum status st;
    struct contact_surface surface;

    if (!contact_wanted(m->scene) || m->kinematics != KINEMATICS_NONLINEAR)
        return STATUS_OK;
    if (!(m->contact = calloc(1, sizeof *m->contact)))
        return STATUS_MEMORY;
    if (!m->surface)
        return STATUS_OK; /* the owner makes it from its own */
    TRY(m->surface(m->sheet, m->scene, &surface));
    TRY(contact_init(m->contact, m->scene, &surface));
out:
    return st;
}

/* Makes, once, what forces, tangents and contact need. */
static enum status make_newton(struct march *m)
{
    enum status st;

    if (m->tangents)
        return STATUS_OK;
    TRY(make_tangents(m));
    TRY(make_contact(m));
    if (!m->stiffness && m->kinematics == KINEMATICS_LINEAR) {
        TRY(large_body_tangent(&m->body, &large_path_statics, m->rest,
                               (struct large_foresight){0}, m->K));
        m->stiffness = (const double(*)[9])m->K;
    }
out:
    return st;
}

/* Makes, once, what solves with tangents. */
static enum status make_system(struct march *m)
{
    enum status st = STATUS_OK;
    int *order = NULL;

    if (m->system.graph)
        return st;
    if (!m->order)
        TRY(order_wide(m->net[0], m->net[1], m->net[2], &order));
    TRY(system_init(&m->system, m->graph, m->supports,
                    m->kinematics == KINEMATICS_LINEAR ? m->parity : NULL,
                    m->order ? m->order : order, &m->asked));
out:
    free(order);
    return st;
}

/* Sets the damping. Body drag is C = (c / rho) M, but not under `printed`, whose v is not
 * the sheet's velocity: there d / dt is, and drag a multiple of M d. */
static void set_damping(struct march *m)
{
    const struct scene *s = m->scene;
    const double drag = damping_drag(s);
    const bool on_d = m->kinematics == KINEMATICS_PRINTED;

    m->keep = m->drag ? 1 : damping_velocity(s);
    m->alpha = m->drag ? 0 : damping_mass(s) + (on_d ? 0 : drag);
    m->beta = m->drag ? 0 : damping_stiffness(s);
    m->gamma = on_d ? drag / s->step : 0;
}

/* Sets the initial velocity, which `printed` has as d / dt. */
static void start_moving(struct march *m)
{
    const bool printed = m->kinematics == KINEMATICS_PRINTED;
    double *v = printed ? m->d : m->v;

    if (!(scene_needs(m->scene) & SCENE_NEED_INITIAL_MOTION))
        return;
    supports_initial_velocity(m->supports, m->scene, m->rest, m->uvw, v);
    for (size_t t = 0; t < march_count(m); t++)
        if (m->kinematics == KINEMATICS_INCREMENTAL)
            m->d[t] = m->dt * v[t]; /* for the energy, until a step */
        else if (printed)
            v[t] *= m->dt;
}

/* Refuses at small displacements what follows the sheet, or its supports. */
static enum status check(const struct scene *scene, const struct discretization *d,
                         struct message *why)
{
    const unsigned large = scene_needs(scene) & (SCENE_NEED_AIR | SCENE_NEED_GRIPPERS);
    char text[SCENE_NEEDS_TEXT];

    if (!large || d->kinematics == KINEMATICS_NONLINEAR)
        return STATUS_OK;
    scene_needs_text(large, text, sizeof text);
    return status_fail(why, STATUS_UNSUPPORTED, "%s: with kinematics=nonlinear only", text);
}

enum status march_init(struct march *m, const struct discretization *d, struct message *why)
{
    enum status st;

    TRY(check(m->scene, d, why));
    m->kinematics = d->kinematics;
    m->integrator = m->integrator ? m->integrator : integrator_of(d);
    m->asked = (struct discretization){.kinematics = d->kinematics,
                                       .solver = d->solver,
                                       .preconditioner = d->preconditioner};
    m->full = d->newton == NEWTON_FULL;
    m->substeps = m->substeps ? m->substeps : 1;
    m->dt = m->scene->step / m->substeps;
    for (int k = 0; k < scene_sheets(m->scene); k++)
        m->density[k] = scene_sheet(m->scene, k).density;
    set_damping(m);
    TRY(make_room(m));
    start_moving(m);
    if (!m->integrator->contact)
        TRY(make_newton(m));
    if (!m->integrator->explicit || (m->tangents && solver_iterates(d->solver)))
        TRY(make_system(m)); /* iterations are set up by the owner, after this */
    if (m->integrator->make)
        TRY(m->integrator->make(m, d, why));
out:
    return st;
}

void march_still(struct march *m, double t)
{
    memset(m->d, 0, 3 * march_count(m) * sizeof *m->d); /* d, v and a */
    m->time = t;
    m->started = false;
    m->orders = 0;
    m->past_dt = 0;
    m->factored = -1;
}

/* --- loads ---------------------------------------------------------------------------- */

/* Returns the density at a node [kg/m^3]. */
static double density_at(const struct march *m, int node)
{
    return m->density[scene_sheet_of(m->scene, node, m->graph->nodes)];
}

void march_weigh(struct march *m)
{
    const struct scene *s = m->scene;

    for (int a = 0; a < m->graph->nodes; a++)
        for (int i = 0; i < 3; i++) {
            const double force =
                (density_at(m, a) * s->gravity[i] + s->drag * s->wind[i]) * m->depth;
            m->load[3 * a + i] = force * m->measure[a];
        }
    for (size_t t = 0; m->dead && t < march_count(m); t++)
        m->load[t] += m->dead[t];
}

enum status march_load(struct march *m, const struct dead_load_line line[3])
{
    return dead_load_make(m->scene, line, &m->dead, m->load);
}

/* --- supports ------------------------------------------------------------------------- */

struct march_held march_path(struct march *m, double t, double dt)
{
    const struct supports *s = m->supports;
    const int count = s->held_count;
    double *d = m->held, *v = d + count, *a = v + count, *work = a + count;

    supports_shift(s, m->scene, t, d);
    supports_shift(s, m->scene, t + dt, v);
    supports_shift(s, m->scene, t - dt, work);
    for (int h = 0; h < count; h++) {
        const double ahead = v[h], behind = work[h];
        v[h] = (ahead - behind) / (2 * dt);
        a[h] = (ahead - 2 * d[h] + behind) / (dt * dt);
    }
    return (struct march_held){d, v, a};
}

void march_follow(struct march *m, double t)
{
    if (!m->supports->moving)
        return;
    supports_turn(m->supports, m->scene, t, t, m->x);
    const struct march_held held = march_path(m, t, m->dt);
    for (int h = 0; h < m->supports->held_count; h++)
        supports_set(m->supports, h, m->v, held.v[h]);
}

/* --- entries of struct model ---------------------------------------------------------- */

void march_forget(struct march *m)
{
    for (int n = 0; n < m->scene->support_count; n++)
        memset(m->reaction[n], 0, sizeof *m->reaction);
    for (int o = 0; o < m->scene->obstacle_count; o++)
        memset(m->push[o], 0, sizeof *m->push);
}

/* Scales velocities by the scene's damping of velocities; under `printed` all of them: the
 * paper's scheme knows no support here. */
static void damp(struct march *m)
{
    if (m->kinematics != KINEMATICS_PRINTED)
        supports_damp(m->supports, m->keep, m->v);
    else
        for (size_t t = 0; t < march_count(m); t++)
            m->v[t] *= m->keep;
}

/* Begins anew at time t where grippers took hold or let go. */
static enum status change_hands(struct march *m, double t)
{
    enum status st = STATUS_OK;

    if (!supports_change(m->supports, m->scene, t, m->x))
        return st;
    m->started = false;
    m->orders = 0;
    m->past_dt = 0;
    m->factored = -1;
    contact_coupled_clear(&m->coupled);
    if (m->system.graph) {
        system_clear(&m->system);
        TRY(make_system(m));
        if (m->follow)
            TRY(m->follow(m));
    }
    if (m->integrator->hold)
        TRY(m->integrator->hold(m));
out:
    return st;
}

enum status march_step(void *state, struct counters *counters)
{
    enum status st = STATUS_OK;
    struct march *m = state;

    march_forget(m);
    m->weighed = m->weighs;
    m->weighs = false;
    for (int n = 0; n < m->substeps && st == STATUS_OK; n++) {
        TRY(change_hands(m, m->time + n * m->dt));
        st = m->integrator->step(m, m->time + n * m->dt, counters);
        system_work(&m->system, counters);
    }
    TRY(st);
    damp(m);
    if (m->integrator->end)
        m->integrator->end(m, counters);
    m->time += m->scene->step;
    counters->steps++;
out:
    m->weighed &= st == STATUS_OK;
    return st;
}

void march_contact(const void *state, struct model_contact *contact)
{
    const struct march *m = state;

    if (m->integrator->contact && !m->rested) {
        m->integrator->contact(m, contact);
        return;
    }
    if (!m->contact) {
        contact_outside_report(&m->outside, contact);
        return;
    }
    contact_report(m->contact, contact);
    contact_force_sum(m->contact, (const double(*)[6])m->push, contact->force);
}

enum status march_forces(void *state, double (*support)[6], double (*body)[6])
{
    struct march *m = state;

    m->weighs |= !support && !body;
    for (int n = 0; support && n < 6 * m->scene->support_count; n++)
        support[n / 6][n % 6] = m->weighed ? m->reaction[n / 6][n % 6] : NAN;
    for (int n = 0; body && n < 6 * m->scene->obstacle_count; n++)
        body[n / 6][n % 6] =
            m->weighed && !m->outside.face[0].count ? m->push[n / 6][n % 6] : NAN;
    return STATUS_OK;
}

static double product(size_t count, const double *a, const double *b)
{
    double sum = 0;

    for (size_t t = 0; t < count; t++)
        sum += a[t] * b[t] / 2;
    return sum;
}

void march_energy(const void *state, struct energy *energy)
{
    const struct march *m = state;
    const struct scene *s = m->scene;
    const size_t count = march_count(m);
    const bool rebuilt = kinematics_rebuilds(m->kinematics);
    const double *v = rebuilt ? m->d : m->v; /* there d is the last step's increment */
    double potential = 0;

    blocks_multiply_mass(m->graph, m->M, v, m->work);
    energy->kinetic = product(count, v, m->work);
    if (rebuilt)
        energy->kinetic /= m->dt * m->dt;
    if (m->beyond)
        energy->kinetic = m->integrator->kinetic(m);
    for (size_t t = 0; t < count; t++) {
        const double sheet = density_at(m, (int)(t / 3)) * m->depth;
        const double weight =
            sheet * s->gravity[t % 3] * m->measure[t / 3] + (m->dead ? m->dead[t] : 0);
        potential -= weight * (m->x[t] - m->rest[t]);
    }
    if (m->pressure.value != 0)
        potential += pressure_energy(&m->pressure, m->rest, m->x);
    energy->potential = potential;
    energy->elastic = NAN;
    if (m->kinematics == KINEMATICS_LINEAR) {
        blocks_multiply(m->graph, m->stiffness, m->d, m->work);
        energy->elastic = product(count, m->d, m->work);
    } else if (!rebuilt &&
               m->body.energy(m->body.self, m->x, &energy->elastic) != STATUS_OK) {
        energy->elastic = NAN;
    }
}

const double *march_velocity(const struct march *m)
{
    if (m->integrator->look)
        m->integrator->look(m);
    return m->v;
}

void march_size(const void *state, struct model_size *size)
{
    const struct march *m = state;
    const struct system none = {.held = m->supports};

    *size = system_size(m->system.graph ? &m->system : &none, m->unknowns);
}

void march_describe(const void *state, struct message *line)
{
    const struct march *m = state;

    *line->text = '\0';
    if (m->own)
        m->integrator->describe(m, line);
}

enum status march_equilibrium(void *state, struct counters *counters, struct message *why)
{
    enum status st;
    struct march *m = state;

    TRY(supports_allow_rest(m->supports, m->scene, m->kinematics == KINEMATICS_NONLINEAR,
                            why));
    TRY(make_newton(m));
    TRY(make_system(m));
    m->time = supports_rest_time(m->supports, m->scene);
    if (m->air.density > 0)
        air_blow(&m->air, m->scene, m->time);
    m->started = false;
    march_forget(m);
    m->weighed = false;
    TRY(m->integrator->rest(m, counters, why));
    m->weighed = true;
out:
    return st;
}

/* Fills *p with mass and stiffness about rest; *own, freed by the caller, is its memory. */
static enum status pencil_of(const struct march *m, struct pencil *p, void **own)
{
    const size_t pairs = (size_t)m->graph->start[m->graph->nodes];
    double(*K)[9];

    *p = (struct pencil){m->graph, m->stiffness, m->M};
    if (m->stiffness)
        return STATUS_OK;
    *own = K = malloc(pairs * sizeof *K);
    p->K = (const double(*)[9])K;
    return K ? large_body_tangent(&m->body, &large_path_statics, m->rest,
                                  (struct large_foresight){0}, K)
             : STATUS_MEMORY;
}

enum status march_modes(void *state, int count, double *omega, struct message *why)
{
    enum status st;
    struct march *m = state;
    struct pencil p;
    void *own = NULL;

    if (m->rested)
        return m->integrator->modes(m, count, omega, why);
    TRY(pencil_of(m, &p, &own));
    supports_turn_back(m->supports);
    TRY(pencil_modes(&p, m->supports, m->system.parity, count, omega, why));
out:
    free(own);
    return st;
}

enum status march_matrices(const void *state, struct matrix *K, struct matrix *M)
{
    enum status st;
    struct pencil p;
    void *own = NULL;

    TRY(pencil_of(state, &p, &own));
    TRY(pencil_matrices(&p, K, M));
out:
    free(own);
    return st;
}

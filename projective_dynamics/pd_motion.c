#include "projective_dynamics/pd_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/damping.h"
#include "models/mechanics/reaction.h"
#include "models/mesh/mesh_air.h"
#include "models/room.h"

static const double PAPER_DAMPING = 0.005; /* share of the velocity lost a frame       */

/* A step has so many iterations at most, unless the settings tell how many; then what they
 * leave is measured each time after so many frames. */
enum { MOST_ITERATIONS = 1000, MEASURED = 10 };

/* Returns the place of an unknown in three fields. */
static ptrdiff_t place(const struct pd_motion *m, int unknown)
{
    return unknown % 3 * pd_net_stride(&m->energy.net) + unknown / 3;
}

/* Returns the acceleration of a free node on which no neighbour pulls, component c, its
 * place `at` in three fields, less damping [m/s^2]. */
static double fall(const struct pd_motion *m, int c, ptrdiff_t at)
{
    const struct scene *scene = m->scene;
    double wind = scene->drag * scene->thickness * m->mesh.area[0] / m->energy.mass[0];

    return scene->gravity[c] + wind * scene->wind[c] + (m->dead ? m->dead[at] : 0) +
           (m->blow ? m->blow[at] : 0);
}

/* --- Chebyshev's acceleration (Wang 2015), held back where the sheet folds: it waits for
 * some iterations, and what does not descend is taken back -------------------------------
 */

enum { DELAY = 10, GUARD = 5 };

/* Finds the factor by which the slowest error shrinks: the largest eigenvalue of A^-1
 * K_stretch about the rest shape, across the sheet, where edges resist nothing. Power
 * iteration. */
static enum status find_radius(struct pd_motion *m)
{
    enum { TURNS = 200 };
    const struct pd_net *net = &m->energy.net;
    ptrdiff_t stride = pd_net_stride(net);
    double *z = m->next, *y = m->before;

    memset(z, 0, (size_t)stride * sizeof *z);
    for (int k = 0; k < net->nodes; k++)
        z[k] = (k * 7 % 11) - 5;
    for (int turn = 0; turn < TURNS; turn++) {
        double size = 0;
        memset(y, 0, (size_t)(3 * stride - net->pad) * sizeof *y);
        for (int n = 0; n < m->energy.link_count; n++) {
            const struct pd_link *l = &m->energy.links[n];
            const double pull = m->local.factor * l->weight * (z[l->b] - z[l->a]);
            y[l->b] += pull;
            y[l->a] -= pull;
        }
        for (int k = 0; k < net->nodes; k++)
            y[k] = m->system.held[k] ? 0 : y[k];
        enum status st = pd_system_solve(&m->system, y);
        if (st != STATUS_OK)
            return st;
        for (int k = 0; k < net->nodes; k++)
            size += y[k] * y[k];
        m->radius = sqrt(size); /* z has length 1, but for the first turn */
        for (int k = 0; k < net->nodes; k++)
            z[k] = m->radius > 0 ? y[k] / m->radius : 0;
    }
    m->radius = fmin(m->radius, 1 - 1e-9);
    return STATUS_OK;
}

/* Returns Chebyshev's weight of iteration `number`, from the one before (Wang 2015,
 * algorithm 1): none for the first DELAY, in which folds that grow at first would be thrown
 * too far. */
static double chebyshev_weight(int number, double radius, double before)
{
    if (number < DELAY)
        return 1;
    return number == DELAY ? 2 / (2 - radius * radius) : 4 / (4 - radius * radius * before);
}

/* Computes next <- w (next - before) + before. */
static void overshoot(struct pd_motion *m, int number)
{
    const struct pd_net *net = &m->energy.net;

    m->weight = chebyshev_weight(number, m->radius, m->weight);
    for (int c = 0; number >= DELAY && c < 3; c++) {
        double *next = m->next + c * pd_net_stride(net);
        const double *before = m->before + c * pd_net_stride(net);
        for (int k = 0; k < net->nodes; k++)
            next[k] = m->weight * (next[k] - before[k]) + before[k];
    }
}

double pd_motion_objective(const struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;
    double span = m->span, inert = 1 + m->alpha * span, sum = 0;

    for (int c = 0; c < 3; c++)
        for (int k = 0; k < net->nodes; k++) {
            ptrdiff_t at = c * pd_net_stride(net) + k;
            double flight = span * m->speed[at] + span * span * fall(m, c, at);
            double off = m->x[at] - m->origin[at] - flight / inert;
            if (!m->system.held[c * net->nodes + k])
                sum += m->energy.mass[k] * off * off;
        }
    return sum * inert / (2 * span * span) + pd_energy_value(&m->energy, m->x);
}

/* Guards the acceleration, after every GUARD iterations and the last: if the step's
 * objective has grown, which plain iterations never let it, the last ones are taken back,
 * and the next are plain (as Peng et al. 2018). *number counts from there, *value is the
 * least so far. */
bool pd_motion_take_back(struct pd_motion *m, bool last, int *number, double *value)
{
    const struct pd_net *net = &m->energy.net;
    const size_t size = (size_t)(3 * pd_net_stride(net)) * sizeof *m->x;

    if (!last && *number % GUARD)
        return false;
    const double now = pd_motion_objective(m);
    if (now <= *value || *number <= DELAY) {
        memcpy(m->saved - net->pad, m->x - net->pad, size);
        *value = now;
        return false;
    }
    memcpy(m->x - net->pad, m->saved - net->pad, size);
    *number = 0;
    return true;
}

/* --- air ---------------------------------------------------------------------------------
 */

/* Makes what the air needs; after the loads. */
static enum status make_air(struct pd_motion *m)
{
    enum status st = mesh_air(&m->mesh, m->scene, &m->air);
    const struct pd_net *net = &m->energy.net;
    const size_t nodes = (size_t)net->nodes;
    double *load, *drag;

    if (st != STATUS_OK || m->air.density == 0)
        return st;
    TRY(room_cut(&m->gust_room, ROOM(m->gust_x, 3 * nodes), ROOM(m->gust_v, 3 * nodes),
                 ROOM(m->gust_from, 3 * nodes), ROOM(m->gust.force, 3 * nodes),
                 ROOM(m->gust.hold, nodes), ROOM(load, 3 * nodes), ROOM(drag, nodes)));
    for (int k = 0; k < net->nodes; k++) {
        drag[k] = m->alpha * m->energy.mass[k];
        for (int c = 0; c < 3; c++)
            load[3 * k + c] = m->energy.mass[k] * fall(m, c, place(m, 3 * k + c));
    }
    m->gust.nodes = net->nodes, m->gust.mass = m->energy.mass;
    m->gust.load = load, m->gust.drag = drag;
    m->gust.x = m->gust_x, m->gust.v = m->gust_v, m->gust.from = m->gust_from;
    if (!(m->blow = pd_net_fields(net, 3)))
        st = STATUS_MEMORY;
out:
    return st;
}

/* Computes the air's force in a step of `span` from the velocities `from`, on the shape to
 * which v leads from x in dt; now if both are 0. */
static void meet_air(struct pd_motion *m, const double *x, double dt, const double *from,
                     double span)
{
    const struct pd_net *net = &m->energy.net;

    if (!m->blow)
        return;
    for (int n = 0; n < 3 * net->nodes; n++) {
        const ptrdiff_t at = place(m, n);
        m->gust_v[n] = m->v[at], m->gust_from[n] = from[at];
        m->gust_x[n] = x[at] + dt * m->v[at];
    }
    m->gust.dt = span;
    air_blow(&m->air, m->scene, m->time + dt);
    air_ahead(&m->air, &m->gust);
    for (int n = 0; n < 3 * net->nodes; n++)
        if (m->energy.mass[n / 3] > 0)
            m->blow[place(m, n)] = m->gust.force[n] / m->energy.mass[n / 3];
}

/* --- BDF2 (pd_motion.h) ------------------------------------------------------------------
 */

/* Computes origin and speed of the step from start and v, which then are those of a step
 * ago. */
static void begin_backward(struct pd_motion *m)
{
    struct pd_backward *b = &m->backward;

    for (size_t n = 0; n < b->count; n++) {
        b->origin[n] = m->start[n] + (m->start[n] - b->x[n]) / 3;
        b->speed[n] = m->v[n] + (m->v[n] - b->v[n]) / 3;
        b->x[n] = m->start[n];
        b->v[n] = m->v[n];
    }
}

/* Makes the history of an unknown on which no neighbour pulls. */
static void remember(struct pd_motion *m, int c, int node)
{
    const ptrdiff_t at = c * pd_net_stride(&m->energy.net) + node;
    const double gain = m->dt * (fall(m, c, at) - m->alpha * m->v[at]);

    m->backward.v[at] = m->v[at] - gain;
    m->backward.x[at] = m->x[at] - m->dt * (m->v[at] - gain / 2);
}

/* Makes the history before the start. */
static enum status make_history(struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;
    struct pd_backward *b = &m->backward;
    enum status st;

    b->count = (size_t)(3 * pd_net_stride(net) - net->pad);
    TRY(room_cut(&b->room, ROOM(b->x, b->count), ROOM(b->v, b->count),
                 ROOM(b->origin, b->count), ROOM(b->speed, b->count)));
    meet_air(m, m->x, 0, m->v, 0);
    memcpy(b->x, m->x, b->count * sizeof *b->x);
    for (int n = 0; n < 3 * net->nodes; n++)
        if (!m->system.held[n])
            remember(m, n / net->nodes, n % net->nodes);
out:
    return st;
}

/* --- grippers ----------------------------------------------------------------------------
 */

static enum status make_system(struct pd_motion *m)
{
    return pd_system_init(&m->system, &m->energy, &m->supports, 1 + m->alpha * m->span,
                          m->span * m->span, m->share > 0 ? m->share : 1,
                          m->options.solver);
}

/* Gives what is held the velocity of its support, now and a step ago; what was let go has
 * had that of a flight. */
static void lead(struct pd_motion *m)
{
    const struct supports *s = &m->supports;
    struct pd_backward *b = &m->backward;
    const int nodes = m->energy.net.nodes;

    for (int n = 0; m->options.second && n < 3 * nodes; n++)
        if (m->system.held[n] && s->free_index[n % nodes * 3 + n / nodes] >= 0)
            remember(m, n / nodes, n % nodes);
    for (int side = -1; side < 2; side += 2) {
        supports_shift(s, m->scene, m->time + side * m->dt, m->shift);
        for (int h = 0; h < s->held_count; h++) {
            const ptrdiff_t at = place(m, s->held[h]);
            m->v[at] = (side < 0 ? 0 : m->v[at]) + side * m->shift[h] / (2 * m->dt);
            if (m->options.second && side > 0)
                b->v[at] = m->v[at], b->x[at] = m->x[at] - m->dt * m->v[at];
        }
    }
}

/* Lets grippers take hold and let go, at the start of a step. */
static enum status change_hands(struct pd_motion *m)
{
    enum status st = STATUS_OK;

    for (int n = 0; m->spread && n < 3 * m->energy.net.nodes; n++)
        m->spread[n] = m->x[place(m, n)];
    if (!m->spread || !supports_change(&m->supports, m->scene, m->time, m->spread))
        return st;
    lead(m);
    pd_system_clear(&m->system);
    TRY(make_system(m));
    m->counted = false;
    if (m->options.chebyshev)
        TRY(find_radius(m));
out:
    return st;
}

/* --- life --------------------------------------------------------------------------------
 */

static double mass_damping(const struct scene *scene, const struct pd_energy *e,
                           enum parameters parameters)
{
    double alpha = scene->drag * scene->thickness * e->mesh->area[0] / e->mass[0];

    if (parameters == PARAMETERS_MATCHED)
        alpha += damping_mass(scene);
    return alpha;
}

/* Returns the factor on the velocity after each frame. */
static double velocity_factor(const struct pd_motion *m)
{
    return m->options.parameters == PARAMETERS_PAPER ? 1 - PAPER_DAMPING
                                                     : damping_velocity(m->scene);
}

static enum status allocate(struct pd_motion *m)
{
    double **fields[] = {&m->x,    &m->v,      &m->base, &m->start,
                         &m->next, &m->before, &m->saved};
    enum { COUNT = sizeof fields / sizeof *fields };
    const struct pd_net *net = &m->energy.net;
    const struct supports *s = &m->supports;

    if (!(m->fields = pd_net_fields(net, 3 * COUNT)))
        return STATUS_MEMORY;
    for (int n = 0; n < COUNT; n++)
        *fields[n] = m->fields + 3 * n * pd_net_stride(net);
    return room_cut(&m->room, ROOM(m->shift, supports_most(s)),
                    ROOM(m->spread, s->whose ? 3 * (size_t)net->nodes : 0),
                    ROOM(m->push, m->scene->obstacle_count + 1));
}

static enum status add_loads(struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;
    double *force = NULL;
    enum status st = mesh_loads(&m->mesh, m->scene, &force);

    if (st != STATUS_OK || !force)
        return st;
    m->dead = pd_net_fields(net, 3);
    for (int n = 0; m->dead && n < 3 * net->nodes; n++)
        if (m->energy.mass[n / 3] > 0) /* a slope has none */
            m->dead[place(m, n)] = force[n] / m->energy.mass[n / 3];
    free(force);
    return m->dead ? STATUS_OK : STATUS_MEMORY;
}

/* Starts at rest, with the scene's initial velocity where nothing is held. */
static void start(struct pd_motion *m)
{
    const ptrdiff_t stride = pd_net_stride(&m->energy.net);
    double xyz[3], v[3];

    for (int k = 0; k < m->energy.net.nodes; k++) {
        for (int c = 0; c < 3; c++)
            xyz[c] = m->x[c * stride + k] = m->energy.rest[c * stride + k];
        scene_initial_velocity(m->scene, xyz, v);
        for (int c = 0; c < 3; c++)
            if (m->supports.free_index[3 * k + c] >= 0)
                m->v[c * stride + k] = v[c];
    }
}

/* Returns for ADMM the weight of the split over that of stretching, once span and energy
 * are known: the geometric mean of a net's shortest wave's resistance by inertia, and by
 * both. Less does better still where a sheet swings as one; where it folds it loses the
 * motion (corners_patch at 5 ms, a tenth of it: by 2 to 4 % at 10 to 50 iterations). */
static double find_share(const struct pd_motion *m)
{
    const struct pd_energy *e = &m->energy;
    const double du = e->net.du, dv = e->net.dv, mass = e->areal * (du * dv), s = m->span,
                 stretch =
                     8 * fmax(e->deviator, e->trace) * (1 / (du * du) + 1 / (dv * dv));

    return 1 / sqrt(1 + s * s * stretch / mass);
}

static void make_arrival(struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;
    double loads = 0, mass = 0;

    for (int k = 0; k < net->nodes; k++) {
        double square = 0;
        for (int c = 0; c < 3; c++) {
            const double g = fall(m, c, c * pd_net_stride(net) + k);
            square += m->system.held[c * net->nodes + k] ? 0 : g * g;
        }
        mass += m->energy.mass[k];
        loads += m->energy.mass[k] * sqrt(square);
    }
    arrival_init(&m->arrival, m->options.iterations, MOST_ITERATIONS, loads, mass,
                 net->nodes, m->scene, m->span);
    m->arrival.descends = !m->options.split && !m->options.chebyshev;
}

void pd_motion_clear(void *motion)
{
    struct pd_motion *m = motion;

    pd_net_free_fields(&m->energy.net, m->fields);
    pd_net_free_fields(&m->energy.net, m->dead);
    pd_net_free_fields(&m->energy.net, m->blow);
    air_clear(&m->air);
    free(m->gust_room);
    free(m->room);
    free(m->backward.room);
    pd_contact_clear(&m->contact);
    pd_local_clear(&m->local);
    pd_system_clear(&m->system);
    pd_energy_clear(&m->energy);
    supports_clear(&m->supports);
    mesh_clear(&m->mesh);
    memset(m, 0, sizeof *m);
}

enum status pd_motion_init(struct pd_motion *m, const struct scene *scene,
                           const struct pd_options *options, struct message *why)
{
    enum status st;
    const struct mesh *mesh = &m->mesh;
    const struct discretization d = {.points = {options->points[0], options->points[1], 1},
                                     .mesh = options->mesh,
                                     .seed = options->seed,
                                     .refine = options->refine};

    *m = (struct pd_motion){.scene = scene, .options = *options};
    m->dt = scene->step / options->substeps;
    m->span = options->second ? 2 * m->dt / 3 : m->dt;
    TRY(mesh_make(&m->mesh, scene, &d,
                  mesh_is_grid(scene, &d) ? MESH_NO_NODES : MESH_SLOPES, why));
    TRY(supports_init(&m->supports, scene, mesh->nodes, mesh->uvw, mesh->rest, why));
    TRY(pd_energy_init(&m->energy, scene, mesh, options->constraint, options->parameters));
    m->alpha = mass_damping(scene, &m->energy, options->parameters);
    if (options->split)
        m->share = find_share(m);
    TRY(make_system(m));
    TRY(pd_local_init(&m->local, &m->energy, m->span * m->span, m->share));
    if (contact_wanted(scene))
        TRY(pd_contact_init(&m->contact, scene, &m->system, mesh, m->supports.free_index));
    TRY(allocate(m));
    TRY(add_loads(m));
    TRY(make_air(m));
    make_arrival(m);
    if (options->chebyshev)
        TRY(find_radius(m));
    start(m);
    if (options->second)
        TRY(make_history(m));
out:
    return st;
}

/* --- the step ----------------------------------------------------------------------------
 */

static void exchange(double **a, double **b)
{
    double *keep = *a;
    *a = *b;
    *b = keep;
}

void pd_motion_begin(struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;
    double span = m->span, inert = 1 + m->alpha * span;

    exchange(&m->x, &m->start);
    m->origin = m->start, m->speed = m->v;
    if (m->options.second) {
        begin_backward(m);
        m->origin = m->backward.origin, m->speed = m->backward.speed;
    }
    meet_air(m, m->start, m->dt, m->speed, span);
    for (int c = 0; c < 3; c++) {
        ptrdiff_t first = c * pd_net_stride(net);
        for (int k = 0; k < net->nodes; k++) {
            ptrdiff_t at = first + k;
            double flight =
                inert * m->origin[at] + span * m->speed[at] + span * span * fall(m, c, at);
            m->base[at] = m->energy.mass[k] * flight + m->system.constant[at];
            m->x[at] = flight / inert;
        }
    }
    supports_shift(&m->supports, m->scene, m->time + m->dt, m->shift);
    for (int h = 0; h < m->supports.held_count; h++) {
        ptrdiff_t at = place(m, m->supports.held[h]);
        m->x[at] = m->base[at] = m->energy.rest[at] + m->shift[h];
    }
    pd_system_hold(&m->system, m->base);
    if (m->contact.system)
        pd_contact_begin(&m->contact, m->time, m->dt, m->start);
}

static double farthest(const struct pd_motion *m, const double *a, const double *b)
{
    const struct pd_net *net = &m->energy.net;
    ptrdiff_t stride = pd_net_stride(net);
    double most = 0;

    for (int k = 0; k < net->nodes; k++) {
        double sum = 0;
        for (int c = 0; c < 3; c++)
            sum += (a[c * stride + k] - b[c * stride + k]) *
                   (a[c * stride + k] - b[c * stride + k]);
        most = sum > most ? sum : most;
    }
    return sqrt(most);
}

enum status pd_motion_iterate(struct pd_motion *m, int number, double *moved)
{
    enum status st;

    pd_local_step(&m->local, m->x, m->base, m->next);
    for (int h = 0; h < m->supports.held_count; h++) {
        ptrdiff_t at = place(m, m->supports.held[h]);
        m->next[at] = m->base[at];
    }
    TRY(pd_system_solve(&m->system, m->next));
    if (m->options.chebyshev)
        overshoot(m, number);
    if (m->contact.system)
        TRY(pd_contact_apply(&m->contact,
                             m->span * m->span * (m->options.chebyshev ? m->weight : 1),
                             m->next));
    if (moved)
        *moved = farthest(m, m->next, m->x);
    if (m->options.chebyshev) {
        exchange(&m->before, &m->x);
        exchange(&m->x, &m->next);
    } else
        exchange(&m->x, &m->next);
out:
    return st;
}

/* Ends a step's contact: finds its forces, and adds their share of the frame's mean. */
static enum status add_push(struct pd_motion *m)
{
    enum status st;
    const double factor = m->span * m->span / (1 + m->alpha * m->span);
    const double share = 1.0 / m->options.substeps;

    if (m->contact.features)
        TRY(pd_contact_end(&m->contact, factor, m->x, share, m->push));
    TRY(pd_contact_find(&m->contact, m->x));
    contact_force_bodies(&m->contact.law, m->contact.at, share, m->push);
out:
    return st;
}

/* Computes in next minus the step's equation at x, times span^2: b(x) - A x, and what
 * contact pushes. */
static enum status find_forces(struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;
    const ptrdiff_t stride = pd_net_stride(net);
    const struct contact *law = &m->contact.law;
    enum status st = STATUS_OK;

    pd_local_forces(&m->local, m->x, m->base, m->next);
    pd_system_subtract(&m->system, m->x, m->next);
    if (!m->contact.system)
        return st;
    TRY(pd_contact_find(&m->contact, m->x));
    for (const struct contact_touch *t = law->touch; t < law->touch + law->count; t++)
        for (int n = t->first; n < t->first + t->count; n++)
            for (int c = 0; c < 3; c++)
                if (!m->system.held[c * net->nodes + law->node[n]])
                    m->next[c * stride + law->node[n]] +=
                        m->span * m->span * law->weight[n] *
                        (t->push * t->normal[c] + t->rub[c]);
out:
    return st;
}

/* Returns, at a held unknown after find_forces, minus the slope of the elastic energy. */
static double held_pull(const struct pd_motion *m, int k, ptrdiff_t at)
{
    const double inert = 1 + m->alpha * m->span;

    return (m->next[at] + m->system.constant[at] - m->base[at] +
            inert * m->energy.mass[k] * m->x[at]) /
           (m->span * m->span);
}

/* Finds whether the step ends after `done` iterations (arrival.h). */
static enum status look(struct pd_motion *m, int done, bool *ends)
{
    const struct pd_net *net = &m->energy.net;
    const double square = m->span * m->span;
    struct arrival_forces sum = {0};
    enum status st;

    TRY(find_forces(m));
    for (int k = 0; k < net->nodes; k++) {
        double left = 0, held = 0, gain = 0;
        for (int c = 0; c < 3; c++) {
            const ptrdiff_t at = c * pd_net_stride(net) + k;
            const double v = (m->x[at] - m->origin[at]) / m->span - m->speed[at],
                         f = m->next[at] / square, pull = held_pull(m, k, at);
            if (m->system.held[c * net->nodes + k])
                held += pull * pull;
            else
                left += f * f, gain += v * v;
        }
        sum.left += sqrt(left);
        sum.held += sqrt(held);
        sum.momentum += m->energy.mass[k] * sqrt(gain) / m->span;
    }
    *ends = arrival_ends(&m->arrival, done, &sum, m->time + m->dt);
out:
    return st;
}

/* Computes velocities at the end of the span. */
static void arrive(struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;

    for (int c = 0; c < 3; c++) {
        ptrdiff_t at = c * pd_net_stride(net);
        for (int k = 0; k < net->nodes; k++)
            m->v[at + k] = (m->x[at + k] - m->origin[at + k]) / m->span;
    }
}

/* Corrects BDF2's history after a step: a node on which contact pushes, which comes without
 * notice, has Euler's velocity along the normal, and had it a step ago. */
static void touch(struct pd_motion *m)
{
    const ptrdiff_t stride = pd_net_stride(&m->energy.net);
    const struct contact *law = &m->contact.law;

    for (const struct contact_touch *t = law->touch; t < law->touch + law->count; t++)
        for (int n = t->first; t->push > 0 && n < t->first + t->count; n++) {
            double more = 0, ago = 0;
            for (int c = 0; c < 3; c++) {
                const ptrdiff_t k = c * stride + law->node[n];
                const double v = (m->x[k] - m->start[k]) / m->dt;
                more += t->normal[c] * (v - m->v[k]);
                ago += t->normal[c] * (v - m->backward.v[k]);
            }
            for (int c = 0; c < 3; c++) {
                const ptrdiff_t k = c * stride + law->node[n];
                m->v[k] += more * t->normal[c];
                m->backward.v[k] += ago * t->normal[c];
            }
        }
}

/* Iterates until the step has arrived, or as the settings say. */
static enum status iterate(struct pd_motion *m, struct counters *counters)
{
    const struct pd_options *o = &m->options;
    const double near = o->tolerance * m->scene->length;
    const bool fixed = m->arrival.fixed;
    double moved = INFINITY, value = INFINITY;
    bool ends = fixed && m->frame % MEASURED;
    int number = 0, done = 0;
    enum status st = STATUS_OK;

    do {
        for (int until = arrival_next(&m->arrival, done); done < until && moved > near;) {
            TRY(pd_motion_iterate(m, number++, near > 0 ? &moved : NULL));
            done++;
            if (o->chebyshev && pd_motion_take_back(m, done == until, &number, &value))
                moved = INFINITY;
        }
        if (!ends)
            TRY(look(m, fixed ? o->iterations : done, &ends));
    } while (!ends);
    counters->iterations += done;
    counters->solves += done;
out:
    return st;
}

static enum status step(struct pd_motion *m, struct counters *counters)
{
    enum status st;
    long pushes = m->contact.solves;

    TRY(change_hands(m));
    pd_motion_begin(m);
    TRY(iterate(m, counters));
    counters->solves += m->contact.solves - pushes;
    if (m->contact.system)
        TRY(add_push(m));
    arrive(m);
    if (m->options.second)
        touch(m);
    m->time += m->dt;
out:
    return st;
}

/* Damps velocities of what is not held; returns whether all are finite, as their sum is.
 * BDF2 follows as an impulse: a step ago the sheet was as much slower, and the acceleration
 * stays. */
static bool finish_frame(struct pd_motion *m)
{
    const struct pd_net *net = &m->energy.net;
    const double factor = velocity_factor(m);
    double sum = 0;

    for (int c = 0; c < 3; c++)
        for (int k = 0; k < net->nodes; k++) {
            const ptrdiff_t at = c * pd_net_stride(net) + k;
            const double keep = m->supports.free_index[3 * k + c] < 0 ? 1 : factor,
                         blow = (keep - 1) * m->v[at];
            if (m->options.second) {
                m->backward.v[at] += blow;
                m->backward.x[at] -= m->dt * blow;
            }
            sum += fabs(m->v[at] *= keep);
        }
    return isfinite(sum);
}

enum status pd_motion_frame(void *motion, struct counters *counters)
{
    enum status st = STATUS_OK;
    struct pd_motion *m = motion;

    for (int o = 0; o < m->scene->obstacle_count; o++)
        memset(m->push[o], 0, sizeof *m->push);
    for (int n = 0; n < m->options.substeps; n++)
        TRY(step(m, counters));
    counters->factorisations += m->counted ? 0 : m->system.group_count;
    m->counted = true;
    if (!finish_frame(m))
        return STATUS_NAN;
    counters->steps++;
    counters->substeps += m->options.substeps;
    m->frame++;
    arrival_count(&m->arrival, counters);
out:
    return st;
}

/* --- what came of it ---------------------------------------------------------------------
 */

void pd_motion_energy(const void *motion, struct energy *energy)
{
    const struct pd_motion *m = motion;
    const struct pd_net *net = &m->energy.net;
    double kinetic = 0, potential = 0;

    for (int c = 0; c < 3; c++)
        for (int k = 0; k < net->nodes; k++) {
            ptrdiff_t at = c * pd_net_stride(net) + k;
            kinetic += m->energy.mass[k] * m->v[at] * m->v[at] / 2;
            double pull = m->scene->gravity[c] + (m->dead ? m->dead[at] : 0);
            potential -= m->energy.mass[k] * pull * (m->x[at] - m->energy.rest[at]);
        }
    *energy = (struct energy){kinetic, pd_energy_value(&m->energy, m->x), potential};
}

void pd_motion_size(const void *motion, struct model_size *size)
{
    const struct pd_motion *m = motion;

    *size = (struct model_size){.nodes = m->energy.net.nodes,
                                .unknowns = m->supports.free_count,
                                .unknown_basis = "nodes"};
    for (int n = 0; n < m->system.group_count; n++) {
        struct factor_info info;
        factor_describe(m->system.group[n].factor, &info);
        size->factor_entries += info.entries;
        size->solver = info.method;
    }
}

void pd_motion_contact(const void *motion, struct model_contact *contact)
{
    const struct pd_motion *m = motion;

    contact_report(&m->contact.law, contact);
    if (m->contact.system)
        contact_force_sum(&m->contact.law, (const double(*)[6])m->push, contact->force);
}

enum status pd_motion_forces(void *motion, double (*support)[6], double (*body)[6])
{
    struct pd_motion *m = motion;
    const struct scene *scene = m->scene;
    const int nodes = m->energy.net.nodes;
    double *left, *x, *drag;
    void *room = NULL;
    enum status st = STATUS_OK;

    if (!support || !body)
        return st;
    for (int n = 0; n < 6 * scene->support_count; n++) /* moments lack those of clamps */
        support[n / 6][n % 6] = m->frame && n % 6 < 3 ? 0 : NAN;
    memcpy(body, m->push, (size_t)scene->obstacle_count * sizeof *body);
    if (!m->frame)
        return st;
    TRY(room_cut(&room, ROOM(left, 3 * nodes), ROOM(x, 3 * nodes), ROOM(drag, nodes)));
    TRY(find_forces(m));
    for (int u = 0; u < 3 * nodes; u++) {
        const ptrdiff_t at = place(m, u);
        x[u] = m->x[at];
        drag[u / 3] = m->alpha * m->energy.mass[u / 3];
        left[u] = held_pull(m, u / 3, at) + m->energy.mass[u / 3] * fall(m, u % 3, at);
    }
    if (m->contact.system)
        contact_force(&m->contact.law, left);
    reaction_inertia(&m->supports, scene, m->time, m->dt, m->energy.mass, drag, m->shift,
                     left);
    reaction_add(&m->supports, left, x, 1, support);
out:
    free(room);
    return st;
}

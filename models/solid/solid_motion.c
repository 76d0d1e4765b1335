#include "models/solid/solid_motion.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/damping.h"
#include "models/mechanics/frames.h"
#include "models/mechanics/large_leapfrog.h"
#include "models/mechanics/lumped_mass.h"
#include "models/room.h"
#include "models/solid/solid_hinge.h"

/* Returns alpha. Body drag is C = (c / rho) M, but not under `printed`, whose v is not the
 * sheet's velocity: there d / dt is, see drag_on_d. */
static double mass_damping(const struct scene *scene, enum kinematics kinematics)
{
    double drag = kinematics == KINEMATICS_PRINTED ? 0 : damping_drag(scene);

    return damping_mass(scene) + drag;
}

/* Returns drag c d / dt under `printed`, as a multiple of M d. */
static double drag_on_d(const struct scene *scene, enum kinematics kinematics)
{
    return kinematics == KINEMATICS_PRINTED ? damping_drag(scene) / scene->step : 0;
}

static void compute_load(struct solid_motion *m)
{
    const struct scene *s = m->scene;

    for (int i = 0; i < 3; i++) {
        double force = s->density * s->gravity[i] + s->drag * s->wind[i];
        for (int a = 0; a < m->space->nodes; a++)
            m->load[3 * a + i] = force * m->assembly.volume[a];
    }
    for (int t = 0; m->dead && t < 3 * m->space->nodes; t++)
        m->load[t] += m->dead[t];
}

enum status solid_motion_add_loads(struct solid_motion *m,
                                   const struct dead_load_line line[3])
{
    enum status st = dead_load_make(m->scene, line, &m->dead, m->load);

    if (m->dead && m->space->hinge.column) {
        solid_hinge_forces(m->space, m->dead);
        compute_load(m);
    }
    return st;
}

/* Sets the initial velocity; `printed` has it as d / dt (solid_motion.h). */
static void start_moving(struct solid_motion *m)
{
    const size_t count = 3 * (size_t)m->space->nodes;
    const bool printed = m->kinematics == KINEMATICS_PRINTED;
    double *v = printed ? m->newmark.d : m->newmark.v;

    supports_initial_velocity(&m->supports, m->scene, m->space->rest,
                              (const double(*)[3])m->space->uvw, v);
    for (size_t t = 0; t < count; t++)
        if (m->kinematics == KINEMATICS_INCREMENTAL)
            m->newmark.d[t] = m->newmark.dt * v[t]; /* for the energy, until a step */
        else if (printed)
            v[t] *= m->newmark.dt;
}

void solid_motion_clear(struct solid_motion *m)
{
    large_motion_clear(&m->large);
    solid_green_clear(&m->green);
    system_clear(&m->system);
    contact_outside_clear(&m->outside);
    contact_clear(&m->contact);
    newmark_clear(&m->newmark);
    supports_clear(&m->supports);
    solid_assembly_clear(&m->assembly);
    free(m->room);
    free(m->dead);
    memset(m, 0, sizeof *m);
}

static void frames(const void *body, double (*Q)[9])
{
    const struct solid_motion *m = body;
    const int sheet = m->points[0] * m->points[1] * m->points[2];

    for (int a = 0; a < m->space->nodes; a += sheet)
        frames_of_net(m->points, m->space->thickness_basis, m->x + 3 * (size_t)a, Q + a);
}

/* Sets up an iterated system; its solutions are increments of d, or steps of Newton. */
static enum status follow(struct solid_motion *m)
{
    /* Conjugate gradients measure energy; in the norm of GMRES stiff motion hides the soft
     * one. */
    static const double CG_TOLERANCE = 1e-6, GMRES_TOLERANCE = 1e-8, STEP_TOLERANCE = 1e-3;
    const bool rebuilt = kinematics_rebuilds(m->kinematics);
    struct iterative *it = m->system.iterative;

    if (m->kinematics == KINEMATICS_LINEAR || !it)
        return STATUS_OK;
    iterative_tolerate(it,
                       !rebuilt                            ? STEP_TOLERANCE
                       : iterative_method(it) == SOLVER_CG ? CG_TOLERANCE
                                                           : GMRES_TOLERANCE,
                       0);
    return iterative_follow(it, frames, m, rebuilt);
}

/* Makes what nonlinear kinematics need, when the rest of *m is complete and in its place.
 */
static enum status make_large(struct solid_motion *m, const struct discretization *d,
                              struct message *why)
{
    enum status st;

    TRY(solid_green_init(&m->green, &m->assembly));
    m->large = (struct large_motion){
        .body = m->green.body,
        .scene = m->scene,
        .graph = &m->assembly.graph,
        .M = m->assembly.M,
        .rest = m->space->rest,
        .load = m->load,
        .supports = &m->supports,
        .system = &m->system,
        .newmark = &m->newmark,
        .K = m->tangent,
        .x = m->x,
        .held = m->held,
        .relief = d->viscosity == VISCOSITY_MEMBRANE,
        .full = d->newton == NEWTON_FULL,
        .contact = contact_wanted(m->scene) ? &m->contact : NULL,
    };
    TRY(large_motion_init(&m->large));
    TRY(large_leapfrog_make(&m->large, d, why));
out:
    return st;
}

enum status solid_motion_init(struct solid_motion *m, const struct scene *scene,
                              const struct solid_space *space,
                              const struct discretization *d, const int *order,
                              struct message *why)
{
    enum status st;
    const size_t count = 3 * (size_t)space->nodes;
    const bool nonlinear = d->kinematics == KINEMATICS_NONLINEAR;
    struct solid_motion new = {.scene = scene, .space = space, .kinematics = d->kinematics};
    memcpy(new.points, d->points, sizeof new.points);
    const struct law law = scene_law(scene);
    struct solid_material material = solid_element_material(&law, scene->density);

    TRY(solid_assembly_init(&new.assembly, space, &material));
    const struct blocks *graph = &new.assembly.graph;
    const size_t pairs = (size_t)graph->start[graph->nodes];
    TRY(supports_init(&new.supports, scene, space->nodes, space->uvw, space->rest, why));
    TRY(newmark_init(&new.newmark, space->nodes, scene->step,
                     mass_damping(scene, d->kinematics), damping_stiffness(scene)));
    new.newmark.gamma = drag_on_d(scene, d->kinematics);
    TRY(room_cut(&new.room, ROOM(new.x, count), ROOM(new.load, count),
                 ROOM(new.held, 4 * (size_t) new.supports.held_count),
                 ROOM(new.tangent, nonlinear ? pairs : 0)));
    memcpy(new.x, space->rest, count * sizeof *new.x);
    st = solid_assembly_compute(&new.assembly, new.x);
    if (st != STATUS_OK) {
        status_fail(why, st, "the rest shape is folded: %s", status_text(st));
        goto out;
    }
    TRY(lumped_mass_make(d, graph, new.assembly.M, why));
    compute_load(&new);
    if (scene_needs(scene) & SCENE_NEED_INITIAL_MOTION)
        start_moving(&new);
    *m = new; /* before the system, which keeps pointers into it */
    memset(&new, 0, sizeof new);
    st = system_init(&m->system, &m->assembly.graph, &m->supports,
                     d->kinematics == KINEMATICS_LINEAR ? space->parity : NULL, order, d);
    if (st == STATUS_OK && d->solver == SOLVER_AUTO && kinematics_rebuilds(d->kinematics))
        st = system_iterate(&m->system);
    if (st == STATUS_OK)
        st = follow(m);
    if (st == STATUS_OK && nonlinear)
        st = make_large(m, d, why);
    if (st != STATUS_OK)
        solid_motion_clear(m);
out:
    solid_motion_clear(&new);
    return st;
}

const struct solid_face *solid_motion_face(struct solid_motion *m, const void *body,
                                           int face)
{
    const bool both = kinematics_rebuilds(m->kinematics);

    if (!contact_wanted(m->scene) || face > both)
        return NULL;
    m->face[face] = (struct solid_face){body, both ? face : 0.5};
    return &m->face[face];
}

enum status solid_motion_meet(struct solid_motion *m, const struct solid_face *face,
                              struct contact_surface *surface)
{
    if (!kinematics_rebuilds(m->kinematics))
        return contact_init(&m->contact, m->scene, surface);
    m->outside.face[face - m->face] = *surface;
    m->outside.layers = m->points[2];
    m->outside.first_only = m->space->thickness_basis;
    return STATUS_OK;
}

static double *held_row(struct solid_motion *m, int row)
{
    return m->held + (size_t)row * (size_t)m->supports.held_count;
}

/* Returns the motion by the supports' paths at time t, in m->held. */
static struct newmark_held path_motion(struct solid_motion *m, double t)
{
    return newmark_follow(&m->supports, m->scene, t, m->newmark.dt, m->held);
}

/* Returns held motion for kinematics that add d to the control points: d brings them to the
 * path. `printed` takes v and a from the paper's eq. 21. */
static struct newmark_held step_motion(struct solid_motion *m, double t)
{
    struct newmark_held held = path_motion(m, t);
    const struct newmark *n = &m->newmark;
    double *d = held_row(m, 0), *v = held_row(m, 1), *a = held_row(m, 2), dt = n->dt;

    for (int h = 0; h < m->supports.held_count; h++) {
        int u = m->supports.held[h];
        d[h] = m->space->rest[u] + d[h] - m->x[u];
        if (m->kinematics != KINEMATICS_PRINTED)
            continue;
        a[h] = 4 / (dt * dt) * (d[h] - n->d[u] - dt * n->v[u]) - n->a[u];
        v[h] = n->v[u] + dt / 2 * (n->a[u] + a[h]);
    }
    return held;
}

static const double (*stiffness(const struct solid_motion *m))[9]
{
    return (const double(*)[9])m->assembly.K;
}

/* Computes the first acceleration, then the constant system of the steps. */
static enum status start_linear(struct solid_motion *m, struct counters *counters)
{
    enum status st;
    struct newmark *n = &m->newmark;
    struct newmark_held held;

    if (m->supports.moving)
        held = path_motion(m, m->time);
    TRY(newmark_begin(n, &m->system, stiffness(m), m->assembly.M, m->load,
                      m->supports.moving ? &held : NULL, counters));
    m->started = true;
out:
    return st;
}

static void damp_velocity(struct solid_motion *m)
{
    const double factor = damping_velocity(m->scene);
    double *v = m->newmark.v;

    supports_damp(&m->supports, factor, v);
    for (int h = 0; m->kinematics == KINEMATICS_PRINTED && h < m->supports.held_count; h++)
        v[m->supports.held[h]] *= factor; /* the paper's scheme knows no support here */
}

static enum status step_linear(struct solid_motion *m, struct counters *counters)
{
    enum status st;
    struct newmark_held held;
    size_t count = 3 * (size_t)m->space->nodes;

    if (!m->started)
        TRY(start_linear(m, counters));
    if (m->supports.moving)
        held = path_motion(m, m->time + m->newmark.dt);
    const struct newmark_held *at = m->supports.moving ? &held : NULL;
    TRY(newmark_step(&m->newmark, &m->system, stiffness(m), m->assembly.M, m->load, at));
    counters->solves++;
    for (size_t t = 0; t < count; t++)
        m->x[t] = m->space->rest[t] + m->newmark.d[t];
out:
    return st;
}

static enum status step_rebuilt(struct solid_motion *m, struct counters *counters)
{
    enum status st;
    struct newmark *n = &m->newmark;
    struct newmark_held held;
    size_t count = 3 * (size_t)m->space->nodes;

    if (m->kinematics == KINEMATICS_INCREMENTAL)
        memset(n->d, 0, count * sizeof *n->d);
    TRY(solid_assembly_compute(&m->assembly, m->x));
    counters->assemblies++;
    compute_load(m);
    if (m->supports.moving)
        held = step_motion(m, m->time + n->dt);
    const struct newmark_held *at = m->supports.moving ? &held : NULL;
    TRY(system_update(&m->system, newmark_k(n), stiffness(m), newmark_m(n), m->assembly.M));
    TRY(newmark_step(n, &m->system, stiffness(m), m->assembly.M, m->load, at));
    counters->solves++;
    for (size_t t = 0; t < count; t++)
        m->x[t] += n->d[t];
out:
    return st;
}

/* Puts what the step led into bodies back (solid_motion.h). */
static void put_outside(struct solid_motion *m, struct counters *counters)
{
    const struct newmark *n = &m->newmark;
    const double v = m->kinematics == KINEMATICS_PRINTED ? 0 : 1 / n->dt;
    const struct contact_outside_rate rate[] = {{n->d, 1}, {n->v, v}};

    contact_outside_put(&m->outside, m->scene, m->time, n->dt, m->supports.free_index, m->x,
                        rate, counters);
}

enum status solid_motion_step(void *motion, struct counters *counters)
{
    struct solid_motion *m = motion;
    enum status st = m->kinematics == KINEMATICS_LINEAR ? step_linear(m, counters)
                     : m->kinematics == KINEMATICS_NONLINEAR
                         ? large_motion_step(&m->large, m->time, counters)
                         : step_rebuilt(m, counters);
    system_work(&m->system, counters);
    if (st != STATUS_OK)
        return st;
    damp_velocity(m);
    if (m->outside.face[0].count)
        put_outside(m, counters);
    m->time += m->newmark.dt;
    counters->steps++;
    return STATUS_OK;
}

void solid_motion_energy(const void *motion, struct energy *energy)
{
    const struct solid_motion *m = motion;
    const struct newmark *n = &m->newmark;
    const struct blocks *graph = &m->assembly.graph;
    size_t count = 3 * (size_t)m->space->nodes;
    double *y = n->work, kinetic = 0, elastic = 0, potential = 0;
    const bool rebuilt = kinematics_rebuilds(m->kinematics);
    const double *v = rebuilt ? n->d : n->v; /* there d is the last step's increment */

    blocks_multiply_mass(graph, m->assembly.M, v, y);
    for (size_t t = 0; t < count; t++)
        kinetic += v[t] * y[t] / 2;
    blocks_multiply(graph, stiffness(m), n->d, y);
    for (size_t t = 0; t < count; t++) {
        double weight =
            m->scene->density * m->scene->gravity[t % 3] * m->assembly.volume[t / 3] +
            (m->dead ? m->dead[t] : 0);
        elastic += n->d[t] * y[t] / 2;
        potential -= weight * (m->x[t] - m->space->rest[t]);
    }
    energy->kinetic = rebuilt ? kinetic / (n->dt * n->dt) : kinetic;
    energy->elastic = m->kinematics == KINEMATICS_LINEAR ? elastic : NAN;
    if (m->kinematics == KINEMATICS_NONLINEAR &&
        solid_green_energy(&m->green, m->x, &elastic) == STATUS_OK)
        energy->elastic = elastic;
    energy->potential = potential;
}

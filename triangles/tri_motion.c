#include "triangles/tri_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/mechanics/contact_push.h"
#include "models/mechanics/frequency.h"
#include "models/damping.h"
#include "models/linalg/order.h"
#include "models/mechanics/large_rest.h"
#include "models/mechanics/pencil.h"
#include "models/room.h"

static const struct large_path statics = {.s1 = 1, .g1 = 1};

/* As of a shell's membrane: against its ringing in energy-momentum steps, which nothing
 * else damps, mean stress is taken from (1/2 + lag) of the step. */
static const double MEMBRANE_LAG = 0.1;

/* Rows that a form or hinge reaches. */
enum { REACH = 2 };

static size_t count_of(const struct tri_motion *m)
{
    return 3 * (size_t)m->net.points.nodes;
}

static enum status make_arrays(struct tri_motion *m)
{
    bool explicit = m->integrator == INTEGRATOR_LEAPFROG;
    size_t pairs = (size_t)m->net.graph.start[m->net.points.nodes];
    enum status st = room_cut(&m->room, ROOM(m->x, count_of(m)), ROOM(m->M, pairs),
                              ROOM(m->held, 4 * (size_t)m->supports.held_count),
                              ROOM(m->K, pairs), ROOM(m->v, explicit ? count_of(m) : 0));

    if (st != STATUS_OK)
        return st;
    memcpy(m->x, m->net.points.rest, count_of(m) * sizeof *m->x);
    m->rest_energy = tri_body_energy(&m->body, m->x);
    for (int a = 0; a < m->net.points.nodes; a++)
        m->M[m->net.graph.start[a]] = m->load.mass[a];
    return STATUS_OK;
}

/* What implicit steps, equilibrium and modes need; once. */
static enum status make_large(struct tri_motion *m, struct message *why)
{
    enum status st = STATUS_OK;
    const struct scene *scene = m->scene;
    const int *points = m->net.points.points;
    bool euler = m->integrator == INTEGRATOR_IMPLICIT;
    int *order = NULL;

    if (m->large.x)
        return STATUS_OK;
    TRY(newmark_init(&m->newmark, m->net.points.nodes,
                     scene->step / (m->substeps ? m->substeps : 1),
                     damping_mass(scene) + damping_drag(scene), m->load.beta));
    order = malloc((size_t)m->net.points.nodes * sizeof *order);
    if (!order)
        TRY(STATUS_MEMORY);
    order_nested(points[0], points[1], 1, REACH, order);
    TRY(system_init(&m->system, &m->net.graph, &m->supports, NULL, order, &m->linear));
    TRY(contact_step_init(&m->contact, scene, &m->net.graph, &m->supports,
                          m->net.points.rest, scene->thickness / 2, order, &m->linear,
                          why));
    m->large = (struct large_motion){
        .body = m->body.body,
        .scene = scene,
        .graph = &m->net.graph,
        .M = m->M,
        .rest = m->net.points.rest,
        .load = m->load.load,
        .supports = &m->supports,
        .system = &m->system,
        .newmark = &m->newmark,
        .K = m->K,
        .x = m->x,
        .held = m->held,
        .lag = euler ? 0 : MEMBRANE_LAG,
        .euler = euler,
        .enough = m->iterations,
        .contact = scene->obstacle_count ? &m->contact : NULL,
    };
    TRY(large_motion_init(&m->large));
out:
    free(order);
    return st;
}

static enum status rest_stiffness(const struct tri_motion *m)
{
    return large_body_tangent(&m->body.body, &statics, m->net.points.rest,
                              (struct large_foresight){0}, m->K);
}

static enum status make_leapfrog(struct tri_motion *m, const struct discretization *d,
                                 struct message *why)
{
    enum status st;
    const struct spring_net *points = &m->net.points;
    struct spring_body body = {.scene = m->scene,
                               .net = points,
                               .supports = &m->supports,
                               .mass = m->load.mass,
                               .drag = m->load.drag,
                               .load = m->load.load,
                               .beta = m->load.beta,
                               .cells = &m->cells,
                               .form_count = m->net.form_count,
                               .forms = m->net.forms};
    struct contact_set outside = {0};

    m->cells.membrane = d->membrane;
    memcpy(m->cells.D, m->body.D, sizeof m->cells.D);
    memcpy(m->cells.cell, points->cell, sizeof m->cells.cell);
    TRY(rest_stiffness(m));
    TRY(frequency_largest(&m->net.graph, &m->supports, m->load.mass,
                          (const double(*)[9])m->K, &body.omega));
    supports_initial_velocity(&m->supports, m->scene, points->rest, NULL, m->v);
    TRY(contact_set_init(&outside, m->scene, &m->supports, m->x, m->scene->thickness / 2,
                         why));
    TRY(spring_leapfrog_make(&body, d->precision, d->substeps, m->x, m->v, NULL,
                             &m->leapfrog, why));
out:
    contact_set_clear(&outside);
    return st;
}

static enum status build(struct tri_motion *m, const struct discretization *d,
                         struct message *why)
{
    enum status st;
    const struct scene *scene = m->scene;
    struct spring_net *points = &m->net.points;

    TRY(tri_net_init(&m->net, scene, d->points, d->bending));
    TRY(tri_body_init(&m->body, scene, &m->net, d->membrane));
    TRY(spring_load_init(&m->load, scene, points, PARAMETERS_MATCHED));
    TRY(supports_init(&m->supports, scene, points->nodes, points->uvw, why));
    TRY(make_arrays(m));
    if (d->integrator == INTEGRATOR_LEAPFROG) {
        TRY(make_leapfrog(m, d, why));
    } else {
        TRY(make_large(m, why));
        supports_initial_velocity(&m->supports, scene, points->rest, NULL, m->newmark.v);
    }
out:
    return st;
}

void tri_motion_clear(struct tri_motion *m)
{
    spring_leapfrog_free(m->leapfrog);
    large_motion_clear(&m->large);
    contact_step_clear(&m->contact);
    system_clear(&m->system);
    newmark_clear(&m->newmark);
    supports_clear(&m->supports);
    spring_load_clear(&m->load);
    tri_body_clear(&m->body);
    tri_net_clear(&m->net);
    free(m->room);
    memset(m, 0, sizeof *m);
}

enum status tri_motion_init(struct tri_motion *m, const struct scene *scene,
                            const struct discretization *d, struct message *why)
{
    *m = (struct tri_motion){
        .scene = scene,
        .integrator = d->integrator,
        .linear = {.solver = d->solver, .preconditioner = d->preconditioner},
        .iterations = d->iterations,
        .substeps = d->substeps};
    enum status st = build(m, d, why);

    if (st != STATUS_OK)
        tri_motion_clear(m);
    return st;
}

static enum status step_implicit(struct tri_motion *m, struct counters *counters)
{
    enum status st = STATUS_OK;
    int substeps = m->substeps ? m->substeps : 1;
    double push[3] = {0, 0, 0}, start = (double)m->frame * m->scene->step;

    for (int n = 0; n < substeps; n++) {
        TRY(large_motion_step(&m->large, start + n * m->newmark.dt, counters));
        for (int i = 0; i < 3; i++)
            push[i] += m->large.push[i] / substeps;
    }
    memcpy(m->large.push, push, sizeof push);
    for (size_t t = 0; m->load.keep != 1 && t < count_of(m); t++)
        m->newmark.v[t] *= m->load.keep;
out:
    return st;
}

enum status tri_motion_step(struct tri_motion *m, struct counters *counters)
{
    enum status st;

    if (m->leapfrog) {
        memset(m->push, 0, sizeof m->push);
        m->large.rested = false;
        TRY(spring_leapfrog_frame(m->leapfrog, m->load.keep, m->x, m->push, &m->pushed,
                                  counters));
    } else {
        TRY(step_implicit(m, counters));
    }
    m->frame++;
    counters->steps++;
out:
    return st;
}

enum status tri_motion_rest(struct tri_motion *m, struct counters *counters,
                            struct message *why)
{
    enum status st;
    double end = supports_rest_time(&m->supports, m->scene);

    TRY(supports_allow_rest(&m->supports, m->scene, why));
    TRY(make_large(m, why));
    TRY(large_rest_equilibrium(&m->large, counters, why));
    m->frame = lround(end / m->scene->step);
    if (m->leapfrog)
        spring_leapfrog_place(m->leapfrog, end, m->x);
out:
    return st;
}

enum status tri_motion_modes(struct tri_motion *m, int count, double *omega,
                             struct message *why)
{
    enum status st;
    const struct pencil p = {&m->net.graph, (const double(*)[9])m->K, m->M, false};

    if (m->large.rested)
        return large_rest_modes(&m->large, count, omega, why);
    m->large.factored = -1;
    TRY(rest_stiffness(m));
    TRY(pencil_modes(&p, &m->supports, NULL, count, omega, why));
out:
    return st;
}

/* Of the sheet itself: clamps belong to what holds it. */
enum status tri_motion_matrices(const struct tri_motion *m, struct matrix *K,
                                struct matrix *M)
{
    enum status st;
    struct scene bare = *m->scene;
    struct tri_net net = {0};
    struct tri_body body = {0};
    double(*tangent)[9] = NULL, *mass = NULL;

    bare.support_count = 0;
    TRY(tri_net_init(&net, &bare, m->net.points.points,
                     m->net.hinge_count ? BENDING_HINGE : BENDING_QUADRATIC));
    TRY(tri_body_init(&body, &bare, &net, m->body.membrane));
    tangent = calloc((size_t)body.body.pairs, sizeof *tangent);
    mass = calloc((size_t)body.body.pairs, sizeof *mass);
    if (!tangent || !mass)
        TRY(STATUS_MEMORY);
    for (int a = 0; a < net.points.nodes; a++)
        mass[net.graph.start[a]] = m->load.mass[a];
    TRY(large_body_tangent(&body.body, &statics, net.points.rest,
                           (struct large_foresight){0}, tangent));
    TRY(pencil_matrices(
        &(struct pencil){&net.graph, (const double(*)[9])tangent, mass, false}, K, M));
out:
    free(tangent);
    free(mass);
    tri_body_clear(&body);
    tri_net_clear(&net);
    return st;
}

void tri_motion_contact(const struct tri_motion *m, struct model_contact *contact)
{
    if (!m->leapfrog) {
        large_motion_contact(&m->large, contact);
        return;
    }
    *contact = (struct model_contact){
        .nodes = m->pushed,
        .least_gap = contact_push_gap(m->scene, m->net.points.nodes, m->x)};
    memcpy(contact->force, m->push, sizeof contact->force);
}

void tri_motion_energy(const struct tri_motion *m, struct energy *energy)
{
    if (m->leapfrog)
        spring_leapfrog_velocity(m->leapfrog, m->v);
    spring_load_energy(&m->load, m->x, m->leapfrog ? m->v : m->newmark.v, energy);
    energy->elastic = tri_body_energy(&m->body, m->x) - m->rest_energy;
}

#include "triangles/tri_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
    size_t pairs = (size_t)m->net.graph.start[m->net.points.nodes];
    enum status st =
        room_cut(&m->room, ROOM(m->x, count_of(m)), ROOM(m->M, pairs),
                 ROOM(m->held, 4 * (size_t)m->supports.held_count), ROOM(m->K, pairs));

    if (st != STATUS_OK)
        return st;
    memcpy(m->x, m->net.points.rest, count_of(m) * sizeof *m->x);
    for (int a = 0; a < m->net.points.nodes; a++)
        m->M[m->net.graph.start[a]] = m->load.mass[a];
    return STATUS_OK;
}

static enum status make_large(struct tri_motion *m, const struct discretization *d)
{
    bool euler = d->integrator == INTEGRATOR_IMPLICIT;

    m->large = (struct large_motion){
        .body = m->body.body,
        .scene = m->scene,
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
        .enough = d->iterations,
        .contact = m->scene->obstacle_count ? &m->contact : NULL,
    };
    return large_motion_init(&m->large);
}

static enum status build(struct tri_motion *m, const struct discretization *d,
                         struct message *why)
{
    enum status st;
    const struct scene *scene = m->scene;
    struct spring_net *points = &m->net.points;
    int *order = NULL;

    TRY(tri_net_init(&m->net, scene, d->points, d->bending));
    TRY(tri_body_init(&m->body, scene, &m->net, d->membrane));
    TRY(spring_load_init(&m->load, scene, points, PARAMETERS_MATCHED));
    TRY(supports_init(&m->supports, scene, points->nodes, points->uvw, why));
    TRY(make_arrays(m));
    TRY(newmark_init(&m->newmark, points->nodes, scene->step / m->substeps,
                     damping_mass(scene) + damping_drag(scene), m->load.beta));
    supports_initial_velocity(&m->supports, scene, points->rest, NULL, m->newmark.v);
    order = malloc((size_t)points->nodes * sizeof *order);
    if (!order)
        TRY(STATUS_MEMORY);
    order_nested(d->points[0], d->points[1], 1, REACH, order);
    TRY(system_init(&m->system, &m->net.graph, &m->supports, NULL, order, d->solver));
    TRY(contact_step_init(&m->contact, scene, &m->net.graph, &m->supports, m->x,
                          scene->thickness / 2, order, d->solver, why));
    TRY(make_large(m, d));
out:
    free(order);
    return st;
}

void tri_motion_clear(struct tri_motion *m)
{
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
    *m = (struct tri_motion){.scene = scene,
                             .integrator = d->integrator,
                             .substeps = d->substeps > 0 ? d->substeps : 1};
    enum status st = build(m, d, why);

    if (st != STATUS_OK)
        tri_motion_clear(m);
    return st;
}

enum status tri_motion_step(struct tri_motion *m, struct counters *counters)
{
    enum status st = STATUS_OK;
    double push[3] = {0, 0, 0}, start = (double)m->frame * m->scene->step;

    for (int n = 0; n < m->substeps; n++) {
        TRY(large_motion_step(&m->large, start + n * m->newmark.dt, counters));
        for (int i = 0; i < 3; i++)
            push[i] += m->large.push[i] / m->substeps;
    }
    memcpy(m->large.push, push, sizeof push);
    for (size_t t = 0; m->load.keep != 1 && t < count_of(m); t++)
        m->newmark.v[t] *= m->load.keep;
    m->frame++;
    counters->steps++;
out:
    return st;
}

enum status tri_motion_rest(struct tri_motion *m, struct counters *counters,
                            struct message *why)
{
    enum status st;

    TRY(supports_allow_rest(&m->supports, m->scene, why));
    TRY(large_rest_equilibrium(&m->large, counters, why));
    m->frame = lround(supports_rest_time(&m->supports, m->scene) / m->scene->step);
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
    TRY(large_body_tangent(&m->body.body, &statics, m->net.points.rest,
                           (struct large_foresight){0}, m->K));
    TRY(pencil_modes(&p, &m->supports, NULL, count, omega, why));
out:
    return st;
}

enum status tri_motion_matrices(const struct tri_motion *m, struct matrix *K,
                                struct matrix *M)
{
    enum status st;
    const struct pencil p = {&m->net.graph, (const double(*)[9])m->K, m->M, false};

    TRY(large_body_tangent(&m->body.body, &statics, m->net.points.rest,
                           (struct large_foresight){0}, m->K));
    TRY(pencil_matrices(&p, K, M));
out:
    return st;
}

void tri_motion_contact(const struct tri_motion *m, struct model_contact *contact)
{
    large_motion_contact(&m->large, contact);
}

void tri_motion_energy(const struct tri_motion *m, struct energy *energy)
{
    spring_load_energy(&m->load, m->x, m->newmark.v, energy);
    energy->elastic = tri_body_energy(&m->body, m->x);
}

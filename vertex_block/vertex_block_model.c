#include "vertex_block/vertex_block_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/damping.h"
#include "models/room.h"
#include "models/vector.h"

/* The sweeps of a step at most, unless their number is given; then the frames from one
 * measurement of the forces that they leave to the next. */
enum { MOST_SWEEPS = 100, MEASURED = 10 };

/* Cells along the sheet at which VB_EDGE_LENGTH has the scene's bending. */
enum { CELLS = 10 };

static size_t count(const struct vb_motion *m)
{
    return 3 * (size_t)m->net.mesh.nodes;
}

/* --- what is built -----------------------------------------------------------------------
 */

static double springs_energy(const struct vb_motion *m)
{
    const bool grid = m->net.mesh.rows;

    return spring_forms_energy(grid ? &m->triangles.forms : &m->shell.forms, m->net.x,
                               spring_net_energy(&m->springs, m->net.x));
}

static double elastic(const struct vb_motion *m)
{
    return m->own.elements == VB_SPRINGS ? springs_energy(m)
           : m->net.mesh.rows            ? tri_body_energy(&m->law, m->net.x)
                                         : tri_shell_energy(&m->shell, m->net.x);
}

static enum status allocate(struct vb_motion *m)
{
    const size_t nodes = (size_t)m->net.mesh.nodes,
                 more = m->own.chebyshev > 0 ? 3 * nodes : 0;

    return room_cut(&m->room, ROOM(m->inertia, nodes), ROOM(m->gain, 3 * nodes),
                    ROOM(m->start, 3 * nodes), ROOM(m->target, 3 * nodes),
                    ROOM(m->force, 3 * nodes), ROOM(m->before[0], more),
                    ROOM(m->before[1], more));
}

static void scale_hinges(struct vb_motion *m)
{
    const double width = m->net.scene->length / CELLS;

    for (int k = 0; m->own.hinge_scale == VB_EDGE_LENGTH && k < m->triangles.hinge_count;
         k++)
        m->triangles.hinges[k].stiffness *= m->net.mesh.cell[0] / width;
}

static enum status make_contact(struct vb_motion *m)
{
    const enum status st = net_meet(&m->net);

    for (int a = 0; a < m->net.mesh.nodes; a++) {
        m->inertia[a] = (m->net.mass[a] / m->dt + m->net.drag[a]) / m->dt;
        if (m->net.contact && m->inertia[a] > 0)
            m->net.contact->compliance[a] = 1 / m->inertia[a];
    }
    if (m->net.contact)
        m->net.contact->steps = m->substeps, m->net.contact->dt = m->dt;
    return st;
}

static void vb_motion_clear(void *motion)
{
    struct vb_motion *m = motion;

    vb_body_clear(&m->body);
    spring_net_clear(&m->springs);
    tri_shell_clear(&m->shell);
    tri_body_clear(&m->law);
    tri_net_clear(&m->triangles);
    net_clear(&m->net);
    free(m->room);
    memset(m, 0, sizeof *m);
}

/* Makes the body, and what it is made of. */
static enum status make_body(struct vb_motion *m, enum bending bending)
{
    const struct scene *scene = m->net.scene;
    const struct mesh *mesh = &m->net.mesh;
    const bool springs = m->own.elements == VB_SPRINGS;
    const struct law law = scene_law(scene);
    struct vb_parts parts = {mesh,
                             mesh->rows ? m->law.D[0] : law.matrix[LAW_MEMBRANE],
                             mesh->rows ? &m->triangles.forms : &m->shell.forms,
                             mesh->rows ? &m->triangles.graph : &m->shell.graph,
                             NULL,
                             mesh->rows ? &m->triangles : NULL,
                             springs ? &m->springs : NULL};
    enum status st;

    if (springs)
        TRY(spring_net_init(&m->springs, scene, mesh, PARAMETERS_MATCHED, false));
    if (mesh->rows) {
        TRY(tri_net_init(&m->triangles, scene, mesh, bending));
        scale_hinges(m);
        TRY(tri_body_init(&m->law, scene, &m->triangles, MEMBRANE_GREEN));
    } else {
        TRY(tri_shell_init(&m->shell, scene, mesh, MEMBRANE_GREEN, BENDING_QUADRATIC,
                           false));
    }
    parts.plate = mesh->rows ? m->triangles.plate : m->shell.plate;
    TRY(vb_body_init(&m->body, &parts));
out:
    return st;
}

/* --- steps -------------------------------------------------------------------------------
 */

/* Computes where inertia, drag and loads lead to, and where the sweeps start. */
static void predict(struct vb_motion *m)
{
    for (int a = 0; a < m->net.mesh.nodes; a++) {
        const double mass = m->net.mass[a], *load = m->net.load + 3 * a;
        const double square = vector_dot(load, load);
        const bool weighs = mass > 0; /* a slope does not */
        double share = m->substep == 0 ? 1 : 0;

        if (m->substep > 0 && square > 0)
            share = mass / m->dt * vector_dot(m->gain + 3 * a, load) / square;
        share = fmin(fmax(share, 0), 1);
        for (int c = 3 * a, i = 0; i < 3; c++, i++) {
            m->start[c] = m->net.x[c];
            m->target[c] = m->net.x[c];
            if (weighs)
                m->target[c] += (mass / m->dt * m->net.v[c] + load[i]) / m->inertia[a];
            const double gain = weighs ? share * m->dt * load[i] / mass : 0;
            m->net.x[c] += m->dt * (m->net.v[c] + gain);
        }
    }
}

/* Goes beyond the last of `done` sweeps; *w is Chebyshev's factor. */
static void accelerate(struct vb_motion *m, int done, double *w)
{
    const double square = m->own.chebyshev * m->own.chebyshev;
    double *oldest = m->before[done % 2];

    *w = done == 1 ? 1 : done == 2 ? 2 / (2 - square) : 4 / (4 - square * *w);
    for (size_t n = 0; n < count(m); n++) {
        if (done > 1)
            m->net.x[n] = *w * (m->net.x[n] - oldest[n]) + oldest[n];
        oldest[n] = m->net.x[n];
    }
}

/* Computes the sweeps' change of velocity. */
static void find_gain(struct vb_motion *m)
{
    for (size_t n = 0; n < count(m); n++)
        m->gain[n] = (m->net.x[n] - m->start[n]) / m->dt - m->net.v[n];
}

/* Returns whether the step ends after `done` sweeps, by the force that they left. */
static bool ends(struct vb_motion *m, const struct vb_step *s, int done, double t)
{
    const int nodes = m->net.mesh.nodes;
    struct arrival_forces f;

    find_gain(m);
    vb_body_force(&m->body, s, m->net.x, m->force);
    f.left = arrival_sum(nodes, s->place, true, NULL, m->force);
    f.held = arrival_sum(nodes, s->place, false, NULL, m->force);
    f.momentum = arrival_sum(nodes, s->place, true, m->net.mass, m->gain) / m->dt;
    return arrival_ends(&m->arrival, done, &f, t);
}

/* Sweeps until the step that ends at t has arrived, or as often as was chosen, and then
 * measures what is left if that is asked for. Returns how often. */
static int sweep(struct vb_motion *m, bool asked, double t)
{
    const struct vb_step s = {m->inertia, m->target, m->net.supports.free_index};
    double w = 1;
    int done = 0;

    if (m->own.chebyshev > 0)
        memcpy(m->before[0], m->net.x, count(m) * sizeof *m->net.x);
    do {
        for (int until = arrival_next(&m->arrival, done); done < until;) {
            vb_body_sweep(&m->body, &s, m->net.x);
            done++;
            if (m->own.chebyshev > 0)
                accelerate(m, done, &w);
        }
    } while ((asked || !m->arrival.fixed) && !ends(m, &s, done, t));
    return done;
}

static enum status substep(struct vb_motion *m, bool asked, struct counters *counters)
{
    enum status st = STATUS_OK;
    double t = (double)(m->substep + 1) / m->substeps * m->net.scene->step;

    supports_change(&m->net.supports, m->net.scene, t - m->dt, m->net.x);
    net_blow(&m->net, t - m->dt, m->dt, m->net.x, m->net.v);
    predict(m);
    net_hold(&m->net, t);
    counters->iterations += sweep(m, asked, t);
    find_gain(m);
    TRY(net_contact_project(m->net.contact, t, m->start, m->net.x));
    for (size_t n = 0; n < count(m); n++) {
        m->net.v[n] = (m->net.x[n] - m->start[n]) / m->dt;
        if (!isfinite(m->net.v[n]))
            return STATUS_NAN;
    }
    m->substep++;
out:
    return st;
}

/* Implement model.h's entries for a struct vb_motion: frame that of advance. STATUS_NAN. */
static enum status vb_motion_frame(void *motion, struct counters *counters)
{
    struct vb_motion *m = motion;
    enum status st = STATUS_OK;

    net_contact_frame(m->net.contact);
    for (int n = 1; n <= m->substeps; n++)
        TRY(substep(m, n == m->substeps && m->frame % MEASURED == 0, counters));
    m->frame++;
    counters->steps++;
    counters->substeps += m->substeps;
    arrival_count(&m->arrival, counters);
    supports_damp(&m->net.supports, m->net.keep, m->net.v);
out:
    return st;
}

/* --- what came of it ---------------------------------------------------------------------
 */

void vb_motion_energy(const void *motion, struct energy *energy)
{
    const struct vb_motion *m = motion;

    net_energy(&m->net, m->net.v, energy);
    energy->elastic = fmax(elastic(m) - m->rest_energy, 0);
}

static enum status vb_motion_forces(void *motion, double (*support)[6], double (*body)[6])
{
    struct vb_motion *m = motion;
    const double t = (double)m->substep / m->substeps * m->net.scene->step;
    double *weightless = calloc((size_t)m->net.mesh.nodes, sizeof *weightless);

    if (!weightless)
        return STATUS_MEMORY;
    if (support && body) {
        vb_body_force(&m->body,
                      &(struct vb_step){weightless, m->target, m->net.supports.free_index},
                      m->net.x, m->force);
        net_forces(&m->net, t, m->dt, m->force, support, body);
    }
    free(weightless);
    return STATUS_OK;
}

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_NET, {"iterations"}, {"mesh"}, {"seed"}, {"refine"},
    {"bending", .only = OPTION(BENDING_QUADRATIC) | OPTION(BENDING_HINGE)},
    {"elements", "elements of the membrane",
     OPTION_WORDS([VB_TRIANGLES] = "triangles", [VB_SPRINGS] = "springs"),
     OPTION_OWN(vb_own, elements), .with = "bending", .of = OPTION(BENDING_QUADRATIC)},
    {"hinge_scale", "stiffness of hinges: the scene's, or proportional to the cells' width",
     OPTION_WORDS([VB_MATCHED] = "matched", [VB_EDGE_LENGTH] = "edge_length"),
     OPTION_OWN(vb_own, hinge_scale), .with = "bending", .of = OPTION(BENDING_HINGE)},
    {"chebyshev", "spectral radius of a sweep, to accelerate by; 0: no acceleration",
     SCHEMA_NUMBER, .low = 0, .high = 0.9999, OPTION_OWN(vb_own, chebyshev)},
    {NULL}};
/* clang-format on */

static enum status refuse(const struct scene *scene, const struct discretization *d,
                          struct message *why)
{
    enum status st;
    const char *lacks = net_mesh_lacks(scene, d, OWN(vb_own, d)->elements == VB_SPRINGS);
    const struct net_refusal rows[] = {
        {*lacks, lacks},
        {d->bending == BENDING_HINGE && !mesh_is_grid(scene, d),
         "bending=hinge: of a grid only; a clamp's hinge on a mesh has a point that is "
         "none "
         "of the net, which a sweep over points does not move"},
        {damping_stiffness(scene) != 0,
         "unsupported: no damping by stiffness (rayleigh beta): that of Chen et al. would "
         "resist rigid turns, too"},
        {d->bending == BENDING_HINGE && scene->is_fabric,
         "bending=hinge bends alike about every axis; for a fabric use bending=quadratic"},
        {OWN(vb_own, d)->elements == VB_SPRINGS && scene_needs(scene) & SCENE_NEED_BIAS,
         "elements=springs: springs along the edges can't couple stretch to shear, as a "
         "fabric does whose warp runs along neither"},
        {0}};

    TRY(net_refuse(scene, d, rows, why));
    if (d->substeps < 1)
        return status_fail(why, STATUS_INPUT,
                           "substeps: vbd takes a fixed number, 1 or more");
out:
    return st;
}

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    struct vb_motion *m = state;

    TRY(refuse(scene, d, why));
    m->own = *OWN(vb_own, d), m->substeps = d->substeps;
    m->dt = scene->step / m->substeps;
    TRY(net_init(&m->net, scene, d, why));
    TRY(make_body(m, d->bending));
    TRY(allocate(m));
    m->rest_energy = m->net.mesh.flat.start ? 0 : elastic(m);
    TRY(make_contact(m));
    TRY(net_make_air(&m->net));
    net_arrive(&m->net, d->iterations, MOST_SWEEPS, m->dt, &m->arrival);
    m->arrival.descends = !(m->own.chebyshev > 0);
out:
    return st;
}

/* Describes the steps, and hinges that do not bend by the scene's law. */
static void describe(const void *state, struct message *line)
{
    const struct vb_motion *m = state;

    status_fail(line, STATUS_OK, "steps of %.3g s, points of %d colours, ", m->dt,
                m->body.colours);
    arrival_describe(&m->arrival, "sweeps", line);
    if (m->own.hinge_scale == VB_EDGE_LENGTH)
        message_add(line, "; the bending stiffness is proportional to the width of the "
                          "net's cells: another net is another cloth");
}

static void doubt(const void *state, struct message *line)
{
    const struct vb_motion *m = state;

    arrival_doubt(&m->arrival, line);
}

const struct model vertex_block_model = {
    .name = "vbd",
    .title = "vertex block descent",
    .source = "Chen, Liu, Yang, Yuksel 2024; membrane: St. Venant and Kirchhoff; bending: "
              "Bergou et al. 2006, or Grinspun et al. 2003",
    .serves = NET_SERVES | SCENE_NEED_BIAS,
    .options = options,
    .defaults = {.points = {16, 16, 1},
                 .degree = {1, 1, 1},
                 .kinematics = KINEMATICS_NONLINEAR,
                 .substeps = 10},
    .bytes = sizeof(struct vb_motion),
    .init = init,
    .advance = vb_motion_frame,
    .probe = net_probe,
    .size = net_size,
    .describe = describe,
    .doubt = doubt,
    .energy = vb_motion_energy,
    .contact = net_touches,
    .forces = vb_motion_forces,
    .clear = vb_motion_clear,
};

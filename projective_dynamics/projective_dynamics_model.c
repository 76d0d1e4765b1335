#include "projective_dynamics/projective_dynamics_model.h"

#include "models/damping.h"
#include "models/net/net.h"
#include "models/net/spring_net.h"
#include "projective_dynamics/pd_motion.h"

enum { TOLERANCE_ITERATIONS = 1000000 }; /* at most, where a tolerance ends them */

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_NET, {"iterations"}, {"parameters"}, {"tolerance"},
    {"mesh"}, {"seed"}, {"refine"},
    {"solver", .only = OPTION(SOLVER_AUTO) | OPTION(SOLVER_BANDED) | OPTION(SOLVER_CHOLMOD)},
    {"integrator", .only = OPTION(INTEGRATOR_IMPLICIT) | OPTION(INTEGRATOR_BDF2)},
    {"constraint", "constraints that resist stretching", SCHEMA_WORD,
     .words = pd_energy_constraints,
     OPTION_OWN(pd_own, constraint)},
    {"acceleration", "acceleration of the iterations",
     OPTION_WORDS([ACCELERATION_AUTO] = "auto", [ACCELERATION_NONE] = "none",
                  [ACCELERATION_CHEBYSHEV] = "chebyshev", [ACCELERATION_ADMM] = "admm"),
     OPTION_OWN(pd_own, acceleration)},
    {NULL}};
/* clang-format on */

static enum constraint constraint_of(const struct scene *scene,
                                     const struct discretization *d)
{
    const enum constraint asked = OWN(pd_own, d)->constraint;

    return asked != CONSTRAINT_AUTO ? asked
           : scene->is_fabric       ? CONSTRAINT_EDGES
                                    : CONSTRAINT_TRIANGLES;
}

/* Iterations that go on until they arrive are accelerated, or they would take a thousand.
 */
static enum acceleration acceleration_of(const struct scene *scene,
                                         const struct discretization *d)
{
    const enum acceleration asked = OWN(pd_own, d)->acceleration;

    return asked != ACCELERATION_AUTO                        ? asked
           : d->iterations > 0 || d->tolerance > 0           ? ACCELERATION_NONE
           : constraint_of(scene, d) == CONSTRAINT_TRIANGLES ? ACCELERATION_ADMM
                                                             : ACCELERATION_CHEBYSHEV;
}

static void adapt(const struct scene *scene, struct discretization *d,
                  struct message *reason)
{
    (void)reason;
    OWN(pd_own, d)->constraint = constraint_of(scene, d);
    OWN(pd_own, d)->acceleration = acceleration_of(scene, d);
}

static struct pd_options options_of(const struct scene *scene,
                                    const struct discretization *d)
{
    const enum acceleration acceleration = acceleration_of(scene, d);
    const struct pd_options o = {
        .points = {d->points[0], d->points[1]},
        .mesh = d->mesh,
        .seed = d->seed,
        .refine = d->refine,
        .constraint = constraint_of(scene, d),
        .parameters = d->parameters,
        .substeps = d->substeps > 0 ? d->substeps : 1,
        .iterations =
            d->iterations <= 0 && d->tolerance > 0 ? TOLERANCE_ITERATIONS : d->iterations,
        .tolerance = d->tolerance,
        .chebyshev = acceleration == ACCELERATION_CHEBYSHEV,
        .split = acceleration == ACCELERATION_ADMM,
        .second = d->integrator == INTEGRATOR_BDF2,
        .solver = d->solver,
    };

    return o;
}

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    const struct pd_options chosen = options_of(scene, d);
    const bool matched = d->parameters == PARAMETERS_MATCHED,
               triangles = chosen.constraint == CONSTRAINT_TRIANGLES;
    const char *lacks = net_mesh_lacks(scene, d, !triangles);
    const struct net_refusal rows[] = {
        {*lacks, lacks},
        {matched && damping_stiffness(scene) != 0,
         "unsupported: no damping by stiffness (rayleigh beta); the constant matrix has no "
         "stiffness that turns with the sheet"},
        {chosen.split && !triangles, "acceleration=admm: with constraint=triangles only"},
        {scene->is_fabric && triangles && matched,
         "a fabric: with constraint=edges only, the projection of triangles is isotropic"},
        {0}};

    TRY(net_refuse(scene, d, rows, why));
    TRY(pd_motion_init(state, scene, &chosen, why));
out:
    return st;
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct pd_motion *m = state;
    const struct pd_net *net = &m->energy.net;
    const struct mesh_field field = {m->x, 1, pd_net_stride(net), 0};

    mesh_sample(&m->mesh, m->scene, &field, n, uvw, xyz);
}

static void doubt(const void *state, struct message *line)
{
    const struct pd_motion *m = state;

    arrival_doubt(&m->arrival, line);
}

/* Describes the iterations, and the membrane of edges of a fabric or a mesh. */
static void describe(const void *state, struct message *line)
{
    const struct pd_motion *m = state;
    const double *cell = m->mesh.cell;
    struct spring_law law;

    *line->text = '\0';
    if (m->scene->is_fabric) {
        spring_law_make(m->scene, m->options.parameters, cell, &law);
        spring_law_tell(&law, cell, m->scene, line);
        message_add(line, "; ");
    }
    arrival_describe(&m->arrival, "iterations", line);
    if (!m->mesh.rows && m->options.constraint == CONSTRAINT_EDGES)
        spring_net_tell_mesh(&m->mesh, m->scene, line);
}

const struct model projective_dynamics_model = {
    .name = "projective_dynamics",
    .title = "projective dynamics",
    .source = "Bouaziz, Martin, Liu, Kavan, Pauly 2014; on springs Liu et al. 2013; "
              "acceleration: Wang 2015",
    .serves = NET_SERVES,
    .options = options,
    .defaults = {.points = {10, 10, 1},
                 .degree = {1, 1, 1},
                 .kinematics = KINEMATICS_NONLINEAR},
    .adapt = adapt,
    .bytes = sizeof(struct pd_motion),
    .init = init,
    .advance = pd_motion_frame,
    .probe = probe,
    .size = pd_motion_size,
    .describe = describe,
    .doubt = doubt,
    .energy = pd_motion_energy,
    .contact = pd_motion_contact,
    .forces = pd_motion_forces,
    .clear = pd_motion_clear,
};

#include "mass_spring/spring_model.h"

#include "mass_spring/spring_motion.h"

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_NET, {"solver"}, {"preconditioner"}, {"mesh"}, {"seed"}, {"refine"},
    {"iterations", .with = "integrator", .of = OPTION(INTEGRATOR_IMPLICIT)},
    {"tolerance", .with = "integrator", .of = OPTION(INTEGRATOR_IMPLICIT)},
    {"precision", .with = "integrator", .of = OPTION(INTEGRATOR_LEAPFROG)},
    {"parameters", .with = "integrator", /* the paper's have a drag of points */
     .of = OPTION(INTEGRATOR_IMPLICIT) | OPTION(INTEGRATOR_LEAPFROG)},
    {"integrator", .only = OPTION(INTEGRATOR_IMPLICIT) | OPTION(INTEGRATOR_EXPLICIT) |
                           OPTION(INTEGRATOR_LEAPFROG) | OPTION(INTEGRATOR_MOMENTUM)},
    {"strain_limit", "largest strain of a spring; 0: none", SCHEMA_NUMBER, .low = 0, .high = 10,
     OPTION_OWN(spring_own, strain_limit),
     .with = "integrator", .of = OPTION(INTEGRATOR_IMPLICIT)},
    {"surface", "surface of the sheet: the net, or a B-spline of which it is the control net",
     OPTION_WORDS([SURFACE_NET] = "net", [SURFACE_QUADRATIC] = "quadratic",
                  [SURFACE_CUBIC] = "cubic"),
     OPTION_OWN(spring_own, surface)},
    {NULL}};
/* clang-format on */

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    const char *lacks = net_mesh_lacks(scene, d, true);
    const struct net_refusal rows[] = {
        {scene_needs(scene) & SCENE_NEED_SOFTENING && d->integrator != INTEGRATOR_MOMENTUM,
         "softening: with integrator=momentum only, the others have struts of constant "
         "force or a constant bending"},
        {*lacks, lacks},
        {OWN(spring_own, d)->surface != SURFACE_NET && !mesh_is_grid(scene, d),
         "surface: of a grid only, whose points can be a spline's"},
        {d->precision == PRECISION_SINGLE && !mesh_is_grid(scene, d),
         "precision=single: of a grid only, whose sweeps go along rows"},
        {d->integrator == INTEGRATOR_LEAPFROG && spring_leapfrog_lacks(scene) &&
             (d->precision == PRECISION_SINGLE || d->parameters == PARAMETERS_PAPER),
         "air and grippers: with precision=double and parameters=matched only where steps "
         "are explicit"},
        {OWN(spring_own, d)->strain_limit > 0 && contact_wanted(scene),
         "strain_limit: without contact only"},
        {0}};

    TRY(net_refuse(scene, d, rows, why));
    TRY(spring_motion_init(state, scene, d, why));
out:
    return st;
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct spring_motion *m = state;
    const struct mesh_field field = {m->net.x, 3, 1, m->degree};

    mesh_sample(&m->net.mesh, m->net.scene, &field, n, uvw, xyz);
}

/* Describes the misfit of springs to plane stress, and explicit steps. The sheet's tension
 * at a strain e is E h (1 + e) (e + e^2 / 2), which is 1.5 e more than that of springs
 * whose force is proportional to their length. */
static void describe(const void *state, struct message *line)
{
    const struct spring_motion *m = state;
    struct message steps = {{0}};

    spring_net_tell(&m->springs, m->net.scene, line);
    if (m->integrator == INTEGRATOR_IMPLICIT || m->integrator == INTEGRATOR_EXPLICIT)
        message_add(line, "; at a strain e it pulls 1.5 e less than the sheet "
                          "(integrator=momentum as the sheet)");
    march_describe(state, &steps);
    if (*steps.text)
        message_add(line, "; %s", steps.text);
}

const struct model spring_model = {
    .name = "mass_spring",
    .title = "mass-spring net",
    .source = "Provot 1995; implicit steps: Baraff and Witkin 1998; bending: Choi and Ko "
              "2002; springs "
              "between control points: Li et al. 2019",
    .serves = NET_SERVES | SCENE_NEED_SOFTENING,
    .options = options,
    .defaults = {.points = {10, 10, 1},
                 .degree = {1, 1, 1},
                 .kinematics = KINEMATICS_NONLINEAR},
    .bytes = sizeof(struct spring_motion),
    .init = init,
    .advance = spring_motion_step,
    .probe = probe,
    .size = march_size,
    .describe = describe,
    .energy = spring_motion_energy,
    .contact = march_contact,
    .forces = march_forces,
    .equilibrium = march_equilibrium,
    .clear = spring_motion_clear,
};

#include "projective_dynamics/projective_dynamics_model.h"

#include <stdlib.h>

#include "models/grid.h"
#include "projective_dynamics/pd_motion.h"
#include "projective_dynamics/pd_surface.h"

enum { DEFAULT_ITERATIONS = 10, MOST_ITERATIONS = 1000000 };
static const double DEFAULT_TOLERANCE = 1e-6; /* of the length; if iterations = 0        */

/* A support on part of the thickness is served if the mid-surface is in that part. */
static const unsigned SERVES = SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_PATCH_SUPPORTS |
                               SCENE_NEED_COMPONENT_SUPPORTS | SCENE_NEED_DRAG;

static void defaults(struct discretization *d)
{
    *d = (struct discretization){.points = {10, 10, 1},
                                 .degree = {1, 1, 1},
                                 .kinematics = KINEMATICS_NONLINEAR,
                                 .iterations = DEFAULT_ITERATIONS};
}

static enum status refuse_scene(const struct scene *scene, enum parameters parameters,
                                struct message *why)
{
    unsigned missing =
        scene_needs(scene) & ~SERVES & ~(unsigned)SCENE_NEED_THICKNESS_SUPPORTS;
    char text[256];

    for (int n = 0; n < scene->support_count; n++)
        if (scene->supports[n].lo[2] > 0.5 || scene->supports[n].hi[2] < 0.5)
            missing |= SCENE_NEED_THICKNESS_SUPPORTS;
    if (missing) {
        scene_needs_text(missing, text, sizeof text);
        return status_fail(why, STATUS_UNSUPPORTED, "unsupported: no %s%s", text,
                           missing & SCENE_NEED_THICKNESS_SUPPORTS
                               ? " that leave out the mid-surface"
                               : "");
    }
    if (parameters == PARAMETERS_MATCHED && scene->damping.kind == DAMPING_RAYLEIGH &&
        scene->damping.beta != 0)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "unsupported: no damping by stiffness (rayleigh beta); the "
                           "constant matrix has no stiffness that turns with the sheet");
    return STATUS_OK;
}

static enum status refuse_numbers(const struct discretization *d, struct message *why)
{
    for (int i = 0; i < 2; i++)
        if (d->points[i] < 2)
            return status_fail(why, STATUS_INPUT, "points: at least 2 along %c, not %d",
                               "uv"[i], d -> points[i]);
    if (d->points[2] != 1)
        return status_fail(why, STATUS_INPUT,
                           "points: the net has 1 point through the thickness, "
                           "points=[n,m,1], not %d",
                           d->points[2]);
    for (int i = 0; i < 3; i++) {
        if (d->degree[i] != 1)
            return status_fail(why, STATUS_INPUT, "degree: a net of points has none");
        if (d->gauss[i])
            return status_fail(why, STATUS_INPUT, "gauss: constraints need no quadrature");
        if (d->knot_count[i])
            return status_fail(why, STATUS_INPUT, "knots_%c: a net of points has no knots",
                               "uvw"[i]);
    }
    if (d->weight_count)
        return status_fail(why, STATUS_INPUT, "weights: a net of points has none");
    return STATUS_OK;
}

static enum status refuse(const struct discretization *d, struct message *why)
{
    enum status st = refuse_numbers(d, why);

    if (st != STATUS_OK)
        return st;
    if (d->unknowns == UNKNOWNS_THICKNESS)
        return status_fail(why, STATUS_INPUT,
                           "unknowns: a net has none through the thickness");
    if (d->kinematics != KINEMATICS_NONLINEAR)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "projective dynamics moves with kinematics=nonlinear only, "
                           "not %s",
                           kinematics_name(d->kinematics));
    if (d->remedy != REMEDY_NONE)
        return status_fail(why, STATUS_UNSUPPORTED, "projective_dynamics has no remedy=%s",
                           remedy_name(d->remedy));
    return discretization_refuse(d,
                                 DISCRETIZATION_PARAMETERS | DISCRETIZATION_SUBSTEPS |
                                     DISCRETIZATION_ITERATIONS | DISCRETIZATION_TOLERANCE |
                                     DISCRETIZATION_CONSTRAINT |
                                     DISCRETIZATION_ACCELERATION,
                                 why);
}

static struct pd_options options_of(const struct discretization *d)
{
    struct pd_options o = {
        .points = {d->points[0], d->points[1]},
        .constraint = d->constraint,
        .parameters = d->parameters,
        .substeps = d->substeps > 0 ? d->substeps : 1,
        .iterations = d->iterations > 0 ? d->iterations : MOST_ITERATIONS,
        .tolerance = d->tolerance,
        .chebyshev = d->acceleration == ACCELERATION_CHEBYSHEV,
        .solver = d->solver,
    };

    if (d->iterations <= 0 && d->tolerance <= 0)
        o.tolerance = DEFAULT_TOLERANCE;
    return o;
}

static void destroy(void *state)
{
    pd_motion_clear(state);
    free(state);
}

static enum status create(const struct scene *scene, const struct discretization *d,
                          void **state, struct message *why)
{
    enum status st;
    struct pd_motion *m = NULL;
    struct pd_options options;

    TRY(refuse_scene(scene, d->parameters, why));
    TRY(refuse(d, why));
    m = calloc(1, sizeof *m);
    if (!m)
        TRY(STATUS_MEMORY);
    options = options_of(d);
    TRY(pd_motion_init(m, scene, &options, why));
    *state = m, m = NULL;
out:
    destroy(m);
    return st;
}

static enum status advance(void *state, struct counters *counters)
{
    return pd_motion_frame(state, counters);
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct pd_motion *m = state;

    pd_surface_points(&m->energy.net, m->x, m->scene->thickness, n, uvw, xyz);
}

static void sample(const void *state, double *xyz)
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        probe(state, 1, uvw, xyz + 3 * (size_t)n);
    }
}

static void size(const void *state, struct model_size *size)
{
    pd_motion_size(state, size);
}

static void energy(const void *state, struct energy *energy)
{
    pd_motion_energy(state, energy);
}

const struct model projective_dynamics_model = {
    .name = "projective_dynamics",
    .title = "projective dynamics",
    .source = "Bouaziz, Martin, Liu, Kavan, Pauly 2014; on springs Liu et al. 2013; "
              "acceleration: Wang 2015",
    .serves = SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_PATCH_SUPPORTS |
              SCENE_NEED_COMPONENT_SUPPORTS | SCENE_NEED_DRAG,
    .defaults = defaults,
    .create = create,
    .advance = advance,
    .sample = sample,
    .probe = probe,
    .size = size,
    .energy = energy,
    .destroy = destroy,
};

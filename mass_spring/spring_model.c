#include "mass_spring/spring_model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mass_spring/spring_rest.h"
#include "models/grid.h"
#include "models/net.h"

#define SERVES                                                                             \
    (SCENE_NEED_CONTACT | SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS |                  \
     SCENE_NEED_PATCH_SUPPORTS | SCENE_NEED_COMPONENT_SUPPORTS | SCENE_NEED_DRAG |         \
     SCENE_NEED_INITIAL_MOTION)

static void defaults(struct discretization *d)
{
    *d = (struct discretization){
        .points = {10, 10, 1}, .degree = {1, 1, 1}, .kinematics = KINEMATICS_NONLINEAR};
}

/* Keys it has a use for. */
enum {
    USED = DISCRETIZATION_PARAMETERS | DISCRETIZATION_INTEGRATOR | DISCRETIZATION_SUBSTEPS |
           DISCRETIZATION_ITERATIONS | DISCRETIZATION_TOLERANCE |
           DISCRETIZATION_STRAIN_LIMIT | DISCRETIZATION_PRECISION
};

static void destroy(void *state)
{
    spring_motion_clear(state);
    free(state);
}

static enum status create(const struct scene *scene, const struct discretization *d,
                          void **state, struct message *why)
{
    enum status st;
    struct spring_motion *m = NULL;

    TRY(model_refuse_net(scene, SERVES, why));
    TRY(discretization_refuse_net(d, USED, "mass_spring", why));
    if (d->precision == PRECISION_SINGLE && d->integrator != INTEGRATOR_LEAPFROG)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "precision=single: with integrator=leapfrog only");
    if (solver_iterates(d->solver) && d->integrator != INTEGRATOR_IMPLICIT)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "solver=%s: with integrator=implicit only",
                           solver_name(d->solver));
    m = calloc(1, sizeof *m);
    if (!m)
        TRY(STATUS_MEMORY);
    TRY(spring_motion_init(m, scene, d, why));
    *state = m, m = NULL;
out:
    destroy(m);
    return st;
}

static enum status advance(void *state, struct counters *counters)
{
    return spring_motion_step(state, counters);
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct spring_motion *m = state;
    const struct net net = {m->net.points[0], m->net.points[1], m->x, 3, 1};

    for (int t = 0; t < n; t++, uvw += 3, xyz += 3) {
        double middle[3], off[3];
        net_surface(&net, uvw[0], uvw[1], middle, off);
        double length = off[0] * off[0] + off[1] * off[1] + off[2] * off[2];
        double height = (uvw[2] - 0.5) * m->scene->thickness;
        for (int c = 0; c < 3; c++)
            xyz[c] = middle[c] + (length > 0 ? height / sqrt(length) * off[c] : 0);
    }
}

static void sample(const void *state, double *xyz)
{
    grid_sample(probe, state, xyz);
}

static void size(const void *state, struct model_size *size)
{
    const struct spring_motion *m = state;
    const struct system none = {.held = &m->newton.supports};
    bool implicit = m->integrator == INTEGRATOR_IMPLICIT && m->newton.system.graph;

    *size = system_size(implicit ? &m->newton.system : &none, "mid-surface points");
}

/* The misfit of springs to plane stress, and the explicit method's limit. */
static void describe(const void *state, struct message *line)
{
    const struct spring_motion *m = state;
    struct spring_law_stiffness net = spring_law_effective(&m->net.law, m->net.cell);
    struct spring_law_stiffness sheet = spring_law_plane_stress(m->scene);
    char limit[128] = "";

    if (m->integrator != INTEGRATOR_IMPLICIT)
        snprintf(limit, sizeof limit,
                 "; explicit steps of %.3g s, stable below %.3g s about rest",
                 m->leapfrog ? spring_leapfrog_step(m->leapfrog) : m->dt,
                 spring_motion_limit(m));
    snprintf(
        line->text, sizeof line->text,
        "the net has C11 %.4g, C22 %.4g, C33 %.4g of plane stress's, and C12 = %.4g C11 "
        "for "
        "%.4g C11 (springs have C12 = C33, plane stress only at nu = 1/3)%s%s",
        net.c11 / sheet.c11, net.c22 / sheet.c22, net.c33 / sheet.c33, net.c12 / net.c11,
        sheet.c12 / sheet.c11,
        m->parameters == PARAMETERS_PAPER
            ? "; the paper's springs: no bending, own mass and damping, not the scene's"
            : "",
        limit);
}

static void energy(const void *state, struct energy *energy)
{
    spring_motion_energy(state, energy);
}

static void contact(const void *state, struct model_contact *contact)
{
    spring_motion_contact(state, contact);
}

static enum status equilibrium(void *state, struct counters *counters, struct message *why)
{
    const struct spring_motion *m = state;

    if (m->leapfrog)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "static equilibrium: with integrator=implicit or explicit");
    return spring_rest_equilibrium(state, counters, why);
}

const struct model spring_model = {
    .name = "mass_spring",
    .title = "mass-spring net",
    .source =
        "Provot 1995; implicit steps: Baraff and Witkin 1998; bending: Choi and Ko 2002",
    .serves = SERVES,
    .defaults = defaults,
    .create = create,
    .advance = advance,
    .sample = sample,
    .probe = probe,
    .size = size,
    .describe = describe,
    .energy = energy,
    .contact = contact,
    .equilibrium = equilibrium,
    .destroy = destroy,
};

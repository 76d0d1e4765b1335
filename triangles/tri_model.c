#include "triangles/tri_model.h"

#include <stdio.h>
#include <stdlib.h>

#include "models/contact/contact_rest.h"
#include "models/mechanics/large_leapfrog.h"
#include "models/net/net_surface.h"
#include "triangles/tri_motion.h"

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_NET, {"solver"}, {"preconditioner"}, {"precision"},
    {"integrator", .only = OPTION(INTEGRATOR_MOMENTUM) | OPTION(INTEGRATOR_IMPLICIT) |
                           OPTION(INTEGRATOR_LEAPFROG)},
    {"bending", .only = OPTION(BENDING_QUADRATIC) | OPTION(BENDING_HINGE)},
    {"membrane", "membrane strain of triangles",
     OPTION_WORDS([MEMBRANE_GREEN] = "green", [MEMBRANE_COROTATIONAL] = "corotational",
                  [MEMBRANE_BARAFF_WITKIN] = "baraff_witkin"),
     OPTION_OWN(tri_own, membrane)},
    {NULL}};
/* clang-format on */

static enum status refuse(const struct scene *scene, const struct discretization *d,
                          struct message *why)
{
    enum status st;

    TRY(model_refuse_net(scene, d, why));
    TRY(contact_rest_refuse(scene, why));
    if (d->precision == PRECISION_SINGLE && d->integrator != INTEGRATOR_LEAPFROG)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "precision=single: with integrator=leapfrog only");
    if (d->precision == PRECISION_SINGLE && d->bending == BENDING_HINGE)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "precision=single: with bending=quadratic only");
    if (scene_needs(scene) & SCENE_NEED_OWN_MATERIALS &&
        (d->integrator == INTEGRATOR_LEAPFROG || d->bending == BENDING_HINGE))
        return status_fail(why, STATUS_UNSUPPORTED,
                           "sheets with materials of their own: integrator=momentum or "
                           "implicit with bending=quadratic only");
    if (scene->is_fabric && d->bending == BENDING_HINGE)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "a fabric: with bending=quadratic only, hinges are isotropic");
    if (scene->is_fabric && d->integrator == INTEGRATOR_LEAPFROG &&
        OWN(tri_own, d)->membrane == MEMBRANE_COROTATIONAL)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "a fabric: corotational triangles with implicit steps only");
    if (scene_needs(scene) & SCENE_NEED_SOFTENING && d->integrator == INTEGRATOR_LEAPFROG)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "softening: integrator=momentum or implicit only");
    if (scene_needs(scene) & SCENE_NEED_BIAS &&
        (d->integrator == INTEGRATOR_LEAPFROG ||
         OWN(tri_own, d)->membrane == MEMBRANE_BARAFF_WITKIN))
        return status_fail(why, STATUS_UNSUPPORTED,
                           "a fabric whose warp runs along neither edge couples stretch to "
                           "shear: integrator=momentum or implicit only, and "
                           "membrane=green or corotational");
    if (d->iterations && d->integrator != INTEGRATOR_IMPLICIT)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "iterations: with integrator=implicit only");
out:
    return st;
}

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    const enum status st = refuse(scene, d, why);

    return st == STATUS_OK ? tri_motion_init(state, scene, d, why) : st;
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct tri_motion *m = state;
    const struct net_surface net = {m->net.points.rows, m->net.points.points[1], m->x, 3,
                                    1};

    net_surface_points(&net, m->scene, n, uvw, xyz);
}

static void size(const void *state, struct model_size *size)
{
    const struct tri_motion *m = state;
    const struct system none = {.held = &m->supports};

    *size = system_size(m->large.system.factor ? &m->large.system : &none,
                        "mid-surface points");
}

/* Describes deviations from the scene's law, and the explicit steps' limit. */
static void describe(const void *state, struct message *line)
{
    const struct tri_motion *m = state;
    const struct spring_leapfrog *l = m->leapfrog;
    const bool conditions = m->body.membrane == MEMBRANE_BARAFF_WITKIN;
    struct message limit;

    large_leapfrog_describe(&m->large.motion, &limit);
    if (l)
        snprintf(limit.text, sizeof limit.text,
                 "explicit steps of %.3g s, stable below %.3g s about rest",
                 spring_leapfrog_step(l), spring_leapfrog_limit(l));
    snprintf(line->text, sizeof line->text, "%s%s%s%s%.160s",
             conditions
                 ? "membrane by the conditions of Baraff and Witkin: the C11, C22 and C33 "
                   "of the sheet, and no C12"
                 : "",
             conditions && (l || m->net.hinge_count) ? "; " : "",
             m->net.hinge_count
                 ? "hinges bend with the scene's D about any axis, but with the Gaussian "
                   "curvature of a plate of nu = 0: a narrow strip is 1 / (1 - nu^2) times "
                   "too stiff"
                 : "",
             m->large.motion.leapfrog ? "; " : "", limit.text);
}

const struct model tri_model = {
    .name = "triangles",
    .title = "constant-strain triangles",
    .source =
        "membrane: St. Venant and Kirchhoff, or Baraff and Witkin 1998; bending: Bergou "
        "et al. 2006, or Grinspun et al. 2003; steps: Simo and Tarnow 1992, Baraff and "
        "Witkin 1998, leapfrog",
    .serves = SCENE_NEED_CONTACT | SCENE_NEED_SELF_CONTACT | SCENE_NEED_MOVING_OBSTACLES |
              SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_PATCH_SUPPORTS |
              SCENE_NEED_COMPONENT_SUPPORTS | SCENE_NEED_DRAG | SCENE_NEED_INITIAL_MOTION |
              SCENE_NEED_SHEETS | SCENE_NEED_FABRIC | SCENE_NEED_BIAS |
              SCENE_NEED_SOFTENING | SCENE_NEED_OWN_MATERIALS,
    .options = options,
    .defaults = {.points = {16, 16, 1},
                 .degree = {1, 1, 1},
                 .kinematics = KINEMATICS_NONLINEAR,
                 .integrator = INTEGRATOR_MOMENTUM},
    .bytes = sizeof(struct tri_motion),
    .init = init,
    .advance = tri_motion_step,
    .probe = probe,
    .size = size,
    .describe = describe,
    .energy = tri_motion_energy,
    .contact = tri_motion_contact,
    .equilibrium = tri_motion_rest,
    .modes = tri_motion_modes,
    .matrices = tri_motion_matrices,
    .clear = tri_motion_clear,
};

#include "position_based/position_based_model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/contact/contact_rest.h"
#include "models/net/net_surface.h"
#include "position_based/pb_motion.h"

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_NET, {"solver"}, {"preconditioner"}, {"parameters"}, {"precision"},

    {"projection", "projection of constraints on positions",
     OPTION_WORDS([PROJECTION_XPBD] = "xpbd", [PROJECTION_PBD] = "pbd"),
     OPTION_OWN(pb_own, projection)},
    {NULL}};
/* clang-format on */

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;

    TRY(model_refuse_net(scene, d, why));
    TRY(contact_rest_refuse(scene, why));
    if (d->iterations < 1)
        return status_fail(why, STATUS_INPUT,
                           "iterations: position_based takes a fixed number, 1 or more");
    if (OWN(pb_own, d)->projection == PROJECTION_PBD &&
        scene->damping.kind == DAMPING_RAYLEIGH && scene->damping.beta > 0 &&
        d->parameters == PARAMETERS_MATCHED)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "unsupported: no damping by stiffness (rayleigh beta) with "
                           "projection=pbd, which knows no stiffness");
    TRY(pb_motion_init(state, scene, d, why));
out:
    return st;
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct pb_motion *m = state;
    const struct net_surface net = {m->net.rows, m->net.points[1], m->x, 3, 1};

    net_surface_points(&net, m->scene, n, uvw, xyz);
}

static void size(const void *state, struct model_size *size)
{
    const struct pb_motion *m = state;

    *size = (struct model_size){.nodes = m->net.nodes,
                                .unknowns = m->supports.free_count,
                                .solver = "none",
                                .unknown_basis = "mid-surface points"};
}

/* Describes the misfit of springs to plane stress, and what one iteration leaves. */
static void describe(const void *state, struct message *line)
{
    const struct pb_motion *m = state;

    spring_law_tell(&m->net.law, m->net.cell, m->scene, line);
    size_t end = strlen(line->text);
    snprintf(line->text + end, sizeof line->text - end,
             "; steps of %.3g s, one iteration adds up to %.3g of their compliance to "
             "springs%s",
             m->dt, m->softening,
             m->projection == PROJECTION_PBD ? "; PBD's stiffness depends on both" : "");
}

static void doubt(const void *state, struct message *line)
{
    static const double LEFT_TOLD = 1e-3; /* a thousandth of the length                 */
    const struct pb_motion *m = state;

    if (m->left > LEFT_TOLD)
        status_fail(line, STATUS_OK,
                    "iterations end far from their fixed point: at t = %.4g s springs were "
                    "longer by %.2g %% than their forces ask for; take smaller steps or "
                    "more iterations",
                    m->left_time, 100 * m->left);
}

const struct model position_based_model = {
    .name = "position_based",
    .title = "position-based constraints",
    .source = "Macklin, Mueller, Chentanez 2016 (XPBD), small steps: Macklin et al. 2019; "
              "Mueller et al. 2007 (PBD)",
    .serves = SCENE_NEED_CONTACT | SCENE_NEED_SELF_CONTACT | SCENE_NEED_MOVING_OBSTACLES |
              SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_PATCH_SUPPORTS |
              SCENE_NEED_COMPONENT_SUPPORTS | SCENE_NEED_DRAG | SCENE_NEED_INITIAL_MOTION |
              SCENE_NEED_SHEETS | SCENE_NEED_FABRIC,
    .options = options,
    .defaults = {.points = {10, 10, 1},
                 .degree = {1, 1, 1},
                 .kinematics = KINEMATICS_NONLINEAR,
                 .iterations = 1},
    .bytes = sizeof(struct pb_motion),
    .init = init,
    .advance = pb_motion_frame,
    .probe = probe,
    .size = size,
    .describe = describe,
    .doubt = doubt,
    .energy = pb_motion_energy,
    .contact = pb_motion_contact,
    .clear = pb_motion_clear,
};

#include "vertex_block/vertex_block_model.h"

#include <stdio.h>
#include <stdlib.h>

#include "models/contact/contact_rest.h"
#include "models/net/net_surface.h"
#include "vertex_block/vb_motion.h"

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_NET, {"solver"}, {"preconditioner"},
    {"bending", .only = OPTION(BENDING_QUADRATIC) | OPTION(BENDING_HINGE)},
    {"elements", "elements of the membrane",
     OPTION_WORDS([VB_TRIANGLES] = "triangles", [VB_SPRINGS] = "springs"),
     OPTION_OWN(vb_own, elements)},
    {"hinge_scale", "stiffness of hinges: the scene's, or proportional to the cells' width",
     OPTION_WORDS([VB_MATCHED] = "matched", [VB_EDGE_LENGTH] = "edge_length"),
     OPTION_OWN(vb_own, hinge_scale)},
    {"chebyshev", "spectral radius of a sweep, to accelerate by; 0: no acceleration",
     SCHEMA_NUMBER, .low = 0, .high = 0.9999, OPTION_OWN(vb_own, chebyshev)},
    {NULL}};
/* clang-format on */

static enum status refuse(const struct scene *scene, const struct discretization *d,
                          struct message *why)
{
    enum status st;
    const struct vb_own *own = OWN(vb_own, d);

    TRY(model_refuse_net(scene, d, why));
    TRY(contact_rest_refuse(scene, why));
    if (d->iterations < 1 || d->substeps < 1)
        return status_fail(why, STATUS_INPUT,
                           "iterations, substeps: vbd takes fixed numbers, 1 or "
                           "more");
    if (scene->damping.kind == DAMPING_RAYLEIGH && scene->damping.beta != 0)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "unsupported: no damping by stiffness (rayleigh beta): that of "
                           "Chen et al. would resist rigid turns, too");
    if (own->hinge_scale == VB_EDGE_LENGTH && d->bending != BENDING_HINGE)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "hinge_scale=edge_length: with bending=hinge only");
    if (d->bending == BENDING_HINGE && scene->is_fabric)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "bending=hinge bends alike about every axis; for a fabric use "
                           "bending=quadratic");
    if (own->elements == VB_SPRINGS && scene_needs(scene) & SCENE_NEED_BIAS)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "elements=springs: springs along the edges can't couple stretch "
                           "to shear, as a fabric does whose warp runs along neither");
    if (own->elements == VB_SPRINGS && d->bending == BENDING_HINGE)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "elements=springs: with bending=quadratic only");
out:
    return st;
}

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    const enum status st = refuse(scene, d, why);

    return st == STATUS_OK ? vb_motion_init(state, scene, d, why) : st;
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct vb_motion *m = state;
    const struct net_surface net = {m->net.points.rows, m->net.points.points[1], m->x, 3,
                                    1};

    net_surface_points(&net, m->scene, n, uvw, xyz);
}

static void size(const void *state, struct model_size *size)
{
    const struct vb_motion *m = state;

    *size = (struct model_size){.nodes = m->net.points.nodes,
                                .unknowns = m->supports.free_count,
                                .solver = "none",
                                .unknown_basis = "mid-surface points"};
}

/* Describes the steps, and hinges that do not bend by the scene's law. */
static void describe(const void *state, struct message *line)
{
    const struct vb_motion *m = state;

    status_fail(line, STATUS_OK, "steps of %.3g s, %d sweeps over points of %d colours%s",
                m->dt, m->iterations, m->body.colours,
                m->own.hinge_scale == VB_EDGE_LENGTH
                    ? "; the bending stiffness is proportional to the width of the net's "
                      "cells: another net is another cloth"
                    : "");
}

static void doubt(const void *state, struct message *line)
{
    static const double LEFT_TOLD = 0.1; /* a tenth of the loads                        */
    const struct vb_motion *m = state;

    if (m->left > LEFT_TOLD)
        status_fail(line, STATUS_OK,
                    "iterations end far from their fixed point: at t = %.4g s a force was "
                    "left of %.2g times the loads (root mean square); take smaller steps "
                    "or more iterations",
                    m->left_time, m->left);
}

const struct model vertex_block_model = {
    .name = "vbd",
    .title = "vertex block descent",
    .source = "Chen, Liu, Yang, Yuksel 2024; membrane: St. Venant and Kirchhoff; bending: "
              "Bergou et al. 2006, or Grinspun et al. 2003",
    .serves = SCENE_NEED_CONTACT | SCENE_NEED_SELF_CONTACT | SCENE_NEED_MOVING_OBSTACLES |
              SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_PATCH_SUPPORTS |
              SCENE_NEED_COMPONENT_SUPPORTS | SCENE_NEED_DRAG | SCENE_NEED_INITIAL_MOTION |
              SCENE_NEED_SHEETS | SCENE_NEED_FABRIC | SCENE_NEED_BIAS,
    .options = options,
    .defaults = {.points = {16, 16, 1},
                 .degree = {1, 1, 1},
                 .kinematics = KINEMATICS_NONLINEAR,
                 .substeps = 10,
                 .iterations = 5},
    .bytes = sizeof(struct vb_motion),
    .init = init,
    .advance = vb_motion_frame,
    .probe = probe,
    .size = size,
    .describe = describe,
    .doubt = doubt,
    .energy = vb_motion_energy,
    .contact = vb_motion_contact,
    .clear = vb_motion_clear,
};

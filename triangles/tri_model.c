#include "triangles/tri_model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/contact/contact_rest.h"
#include "models/mechanics/pencil.h"
#include "models/net/net_surface.h"
#include "models/room.h"

static size_t count_of(const struct tri_motion *m)
{
    return 3 * (size_t)m->net.points.nodes;
}

static enum status make_arrays(struct tri_motion *m)
{
    enum status st =
        room_cut(&m->room, ROOM(m->x, count_of(m)), ROOM(m->v, m->swept ? count_of(m) : 0));

    if (st != STATUS_OK)
        return st;
    memcpy(m->x, m->net.points.rest, count_of(m) * sizeof *m->x);
    m->rest_energy = tri_body_energy(&m->body, m->x);
    return STATUS_OK;
}

/* Makes, once, what steps but swept ones, equilibrium and modes need. */
static enum status make_march(struct tri_motion *m, struct message *why)
{
    const struct spring_net *points = &m->net.points;
    struct discretization d = m->asked;

    if (m->march.graph)
        return STATUS_OK;
    if (m->swept)
        d.integrator = INTEGRATOR_MOMENTUM;
    m->march = (struct march){
        .body = m->body.body,
        .scene = m->scene,
        .graph = &m->net.graph,
        .mass = m->load.mass,
        .rest = points->rest,
        .x = m->x,
        .load = m->load.load,
        .net = {points->points[0], points->points[1], 1},
        .supports = &m->supports,
        .unknowns = "mid-surface points",
    };
    return march_init_net(&m->march, &d, why);
}

static enum status make_leapfrog(struct tri_motion *m, const struct discretization *d,
                                 struct message *why)
{
    enum status st;
    const struct spring_net *points = &m->net.points;
    struct spring_body body = {.load = &m->load,
                               .supports = &m->supports,
                               .stencil = &m->stencil,
                               .cells = &m->cells};

    m->cells.membrane = OWN(tri_own, d)->membrane;
    m->cells.D[0] = m->body.D[0][LAW_11];
    m->cells.D[1] = m->body.D[0][LAW_12];
    m->cells.D[2] = m->body.D[0][LAW_22];
    m->cells.D[3] = m->body.D[0][LAW_33];
    memcpy(m->cells.cell, points->cell, sizeof m->cells.cell);
    TRY(spring_stencil_init(&m->stencil, m->scene, points));
    spring_stencil_replace(&m->stencil, &m->net.forms);
    supports_initial_velocity(&m->supports, m->scene, points->rest, NULL, m->v);
    TRY(spring_leapfrog_make(&body, d->precision, d->substeps, m->x, m->v, &m->leapfrog,
                             why));
out:
    return st;
}

static enum status build(struct tri_motion *m, const struct discretization *d,
                         struct message *why)
{
    enum status st;
    const struct scene *scene = m->scene;
    struct spring_net *points = &m->net.points;

    TRY(tri_net_init(&m->net, scene, d->points, d->bending));
    TRY(tri_body_init(&m->body, scene, &m->net, OWN(tri_own, d)->membrane));
    TRY(spring_load_init(&m->load, scene, points, PARAMETERS_MATCHED));
    TRY(supports_init(&m->supports, scene, points->nodes, points->uvw, points->rest, why));
    TRY(make_arrays(m));
    if (m->swept) {
        TRY(make_leapfrog(m, d, why));
    } else {
        TRY(make_march(m, why));
    }
out:
    return st;
}

static void tri_motion_clear(void *motion)
{
    struct tri_motion *m = motion;

    spring_leapfrog_free(m->leapfrog);
    spring_stencil_clear(&m->stencil);
    march_clear(&m->march);
    supports_clear(&m->supports);
    spring_load_clear(&m->load);
    tri_body_clear(&m->body);
    tri_net_clear(&m->net);
    free(m->room);
    memset(m, 0, sizeof *m);
}

/* Initialises; *m must stay where it is: it holds pointers into itself. */
static enum status tri_motion_init(struct tri_motion *m, const struct scene *scene,
                                   const struct discretization *d, struct message *why)
{
    *m = (struct tri_motion){.scene = scene,
                             .swept = d->integrator == INTEGRATOR_LEAPFROG &&
                                      d->bending == BENDING_QUADRATIC,
                             .asked = *d};
    enum status st = build(m, d, why);

    if (st != STATUS_OK)
        tri_motion_clear(m);
    return st;
}

/* Implement model.h's entries advance, equilibrium, modes, matrices, contact and energy;
 * the state is a struct tri_motion. */
static enum status tri_motion_step(void *state, struct counters *counters)
{
    struct tri_motion *m = state;
    enum status st;

    if (!m->leapfrog)
        return march_step(state, counters);
    m->march.rested = false;
    TRY(spring_leapfrog_frame(m->leapfrog, m->x, counters));
    counters->steps++;
out:
    return st;
}

static enum status tri_motion_rest(void *state, struct counters *counters,
                                   struct message *why)
{
    struct tri_motion *m = state;
    enum status st;

    TRY(make_march(m, why));
    TRY(march_equilibrium(state, counters, why));
    if (m->leapfrog)
        spring_leapfrog_place(m->leapfrog, m->march.time, m->x);
out:
    return st;
}

static enum status tri_motion_modes(void *state, int count, double *omega,
                                    struct message *why)
{
    enum status st = make_march(state, why);

    return st == STATUS_OK ? march_modes(state, count, omega, why) : st;
}

/* Makes the matrices of the sheet itself: clamps belong to the supports. */
static enum status tri_motion_matrices(const void *state, struct matrix *K,
                                       struct matrix *M)
{
    const struct tri_motion *m = state;
    enum status st;
    struct scene bare = *m->scene;
    struct tri_net net = {0};
    struct tri_body body = {0};
    double(*tangent)[9] = NULL, *mass = NULL;

    bare.support_count = 0;
    TRY(tri_net_init(&net, &bare, m->asked.points,
                     m->net.hinge_count ? BENDING_HINGE : BENDING_QUADRATIC));
    TRY(tri_body_init(&body, &bare, &net, m->body.membrane));
    tangent = calloc((size_t)body.body.pairs, sizeof *tangent);
    mass = calloc((size_t)body.body.pairs, sizeof *mass);
    if (!tangent || !mass)
        TRY(STATUS_MEMORY);
    for (int a = 0; a < net.points.nodes; a++)
        mass[net.graph.start[a]] = m->load.mass[a];
    TRY(large_body_tangent(&body.body, &large_path_statics, net.points.rest,
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

static void tri_motion_contact(const void *state, struct model_contact *contact)
{
    const struct tri_motion *m = state;

    if (!m->leapfrog || m->march.rested)
        march_contact(state, contact);
    else
        *contact = spring_leapfrog_contact(m->leapfrog);
}

static void tri_motion_energy(const void *state, struct energy *energy)
{
    const struct tri_motion *m = state;

    if (m->leapfrog)
        spring_leapfrog_velocity(m->leapfrog, m->v);
    spring_load_energy(&m->load, m->x, m->leapfrog ? m->v : m->march.v, energy);
    energy->elastic = tri_body_energy(&m->body, m->x) - m->rest_energy;
}

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

    *size = system_size(m->march.system.factor ? &m->march.system : &none,
                        "mid-surface points");
}

/* Describes deviations from the scene's law, and the explicit steps' limit. */
static void describe(const void *state, struct message *line)
{
    const struct tri_motion *m = state;
    const struct spring_leapfrog *l = m->leapfrog;
    const bool conditions = m->body.membrane == MEMBRANE_BARAFF_WITKIN;
    struct message limit;

    march_describe(state, &limit);
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
             m->march.own ? "; " : "", limit.text);
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

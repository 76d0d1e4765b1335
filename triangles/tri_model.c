#include "triangles/tri_model.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/mechanics/pencil.h"
#include "models/net/spring_net.h"

static enum status make_march(struct tri_motion *m, const struct discretization *d,
                              struct message *why)
{
    m->march = (struct march){
        .integrator = m->swept.net ? &spring_leapfrog_integrator : NULL,
        .moved = &m->swept,
        .body = m->meshed ? m->shell.body : m->body.body,
        .graph = m->meshed ? &m->shell.graph : &m->triangles.graph,
    };
    return net_march(&m->net, &m->march, d, why);
}

/* Makes what a sweep moves: the bending's stencil, and cells. */
static enum status make_swept(struct tri_motion *m, const struct discretization *d)
{
    const struct mesh *mesh = &m->net.mesh;
    const double *D = m->body.D[0];

    m->cells = (struct spring_cells){.membrane = OWN(tri_own, d)->membrane,
                                     .D = {D[LAW_11], D[LAW_12], D[LAW_22], D[LAW_33]},
                                     .cell = {mesh->cell[0], mesh->cell[1]}};
    m->swept =
        (struct spring_body){.net = &m->net, .stencil = &m->stencil, .cells = &m->cells};
    return spring_stencil_init(&m->stencil, m->net.scene, mesh, NULL, &m->triangles.forms);
}

static void tri_motion_clear(void *motion)
{
    struct tri_motion *m = motion;

    spring_stencil_clear(&m->stencil);
    march_clear(&m->march);
    tri_shell_clear(&m->shell);
    tri_body_clear(&m->body);
    tri_net_clear(&m->triangles);
    net_clear(&m->net);
    memset(m, 0, sizeof *m);
}

/* Gives turns, which have no mass in implicit steps, that of explicit ones, or takes it:
 * eigenvalues need one, and it changes them with the square of the cells. */
static enum status weigh_turns(struct tri_motion *m, bool on)
{
    const struct mesh *mesh = &m->net.mesh;
    const struct scene *scene = m->net.scene;
    double *mass = NULL, *M = (double *)m->march.M; /* made by march_init */

    if (!m->meshed || march_explicit(&m->asked))
        return STATUS_OK;
    if (!(mass = calloc((size_t)mesh->nodes, sizeof *mass)))
        return STATUS_MEMORY;
    if (on)
        mesh_weigh_edges(mesh, scene->density * scene->thickness, mass);
    for (int a = mesh->vertices; a < mesh->nodes; a++)
        M[m->shell.graph.start[a]] = mass[a];
    free(mass);
    return STATUS_OK;
}

static enum status tri_motion_modes(void *state, int count, double *omega,
                                    struct message *why)
{
    struct tri_motion *m = state;
    enum status st;

    TRY(weigh_turns(m, true));
    TRY(march_modes(state, count, omega, why));
    TRY(weigh_turns(m, false));
out:
    return st;
}

/* Makes the matrices of the sheet itself: clamps belong to the supports. */
static enum status tri_motion_matrices(const void *state, struct matrix *K,
                                       struct matrix *M)
{
    const struct tri_motion *m = state;
    enum status st;
    struct scene bare = *m->net.scene;
    struct mesh mesh = {0};
    struct tri_net net = {0};
    struct tri_body body = {0};
    double(*tangent)[9] = NULL, *mass = NULL;

    if (m->meshed)
        return STATUS_UNSUPPORTED;
    bare.support_count = 0;
    TRY(mesh_init(&mesh, &bare, m->asked.points));
    TRY(tri_net_init(&net, &bare, &mesh,
                     m->triangles.hinge_count ? BENDING_HINGE : BENDING_QUADRATIC));
    TRY(tri_body_init(&body, &bare, &net, m->body.membrane));
    tangent = calloc((size_t)body.body.pairs, sizeof *tangent);
    mass = calloc((size_t)body.body.pairs, sizeof *mass);
    if (!tangent || !mass)
        TRY(STATUS_MEMORY);
    for (int a = 0; a < mesh.nodes; a++)
        mass[net.graph.start[a]] = m->net.mass[a];
    TRY(large_body_tangent(&body.body, &large_path_statics, mesh.rest,
                           (struct large_foresight){0}, tangent));
    TRY(pencil_matrices(
        &(struct pencil){&net.graph, (const double(*)[9])tangent, mass, false}, K, M));
out:
    free(tangent);
    free(mass);
    tri_body_clear(&body);
    tri_net_clear(&net);
    mesh_clear(&mesh);
    return st;
}

static void tri_motion_energy(const void *state, struct energy *energy)
{
    const struct tri_motion *m = state;

    net_march_energy(&m->net, &m->march, energy);
}

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_NET, {"solver"}, {"preconditioner"},
    {"iterations", .with = "integrator", .of = OPTION(INTEGRATOR_IMPLICIT)},
    {"precision", .with = "integrator", .of = OPTION(INTEGRATOR_LEAPFROG)},
    {"integrator", .only = OPTION(INTEGRATOR_MOMENTUM) | OPTION(INTEGRATOR_IMPLICIT) |
                           OPTION(INTEGRATOR_LEAPFROG)},
    {"bending", .only = OPTION(BENDING_QUADRATIC) | OPTION(BENDING_HINGE) |
                        OPTION(BENDING_MIDEDGE),
     .with = "precision", .of = OPTION(PRECISION_DOUBLE)},
    {"mesh"}, {"seed"}, {"refine"},
    {"membrane", "membrane strain of triangles",
     OPTION_WORDS([MEMBRANE_GREEN] = "green", [MEMBRANE_COROTATIONAL] = "corotational",
                  [MEMBRANE_BARAFF_WITKIN] = "baraff_witkin",
                  [MEMBRANE_SPRINGS] = "springs"),
     OPTION_OWN(tri_own, membrane)},
    {"arc", "edges longer than their chords by the curvature along them",
     OPTION_WORDS([TRI_ARC_OFF] = "off", [TRI_ARC_ON] = "on"), OPTION_OWN(tri_own, arc),
     .with = "bending", .of = OPTION(BENDING_MIDEDGE)},
    {NULL}};
/* clang-format on */

/* Refuses what a sheet on a mesh, and one on a grid, cannot do. */
static enum status refuse(const struct scene *scene, const struct discretization *d,
                          struct message *why)
{
    const unsigned needs = scene_needs(scene);
    const enum membrane membrane = OWN(tri_own, d)->membrane;
    const bool grid = mesh_is_grid(scene, d),
               meshed = !grid || d->bending == BENDING_MIDEDGE,
               springs = membrane == MEMBRANE_SPRINGS,
               leaps = d->integrator == INTEGRATOR_LEAPFROG,
               hinges = d->bending == BENDING_HINGE;
    const char *lacks = scene->pattern ? net_mesh_lacks(scene, d, springs) : "";
    const struct net_refusal rows[] = {
        {*lacks, lacks},
        {springs && !meshed,
         "membrane=springs: of a mesh, or with bending=midedge; springs of a grid are the "
         "model mass_spring"},
        {springs && scene->is_fabric, "membrane=springs: of an isotropic sheet only"},
        {springs && OWN(tri_own, d)->arc == TRI_ARC_ON,
         "membrane=springs: with arc=off only"},
        {meshed && (scene_sheets(scene) > 1 || scene->shape != SCENE_FLAT),
         "a mesh, or bending=midedge: of one flat sheet only"},
        {meshed && !springs && membrane != MEMBRANE_GREEN,
         "a mesh, or bending=midedge: with membrane=green or springs only"},
        {meshed && needs & SCENE_NEED_SOFTENING,
         "softening: of a grid with bending=quadratic only"},
        {leaps && d->precision == PRECISION_SINGLE && spring_leapfrog_lacks(scene),
         "air and grippers: with precision=double only where steps are explicit"},
        {needs & SCENE_NEED_OWN_MATERIALS && (leaps || hinges),
         "sheets with materials of their own: integrator=momentum or implicit with "
         "bending=quadratic only"},
        {scene->is_fabric && hinges,
         "a fabric: with bending=quadratic only, hinges are isotropic"},
        {scene->is_fabric && leaps && membrane == MEMBRANE_COROTATIONAL,
         "a fabric: corotational triangles with implicit steps only"},
        {needs & SCENE_NEED_SOFTENING && leaps,
         "softening: integrator=momentum or implicit only"},
        {needs & SCENE_NEED_BIAS && (leaps || membrane == MEMBRANE_BARAFF_WITKIN),
         "a fabric whose warp runs along neither edge couples stretch to shear: "
         "integrator=momentum or implicit only, and membrane=green or corotational"},
        {0}};

    return net_refuse(scene, d, rows, why);
}

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    struct tri_motion *m = state;

    TRY(refuse(scene, d, why));
    m->meshed = !mesh_is_grid(scene, d) || d->bending == BENDING_MIDEDGE, m->asked = *d;
    TRY(net_init(&m->net, scene, d, why));
    if (m->meshed) {
        TRY(tri_shell_init(&m->shell, scene, &m->net.mesh, OWN(tri_own, d)->membrane,
                           d->bending, OWN(tri_own, d)->arc == TRI_ARC_ON));
        if (march_explicit(d))
            mesh_weigh_edges(&m->net.mesh, scene->density * scene->thickness, m->net.mass);
    } else {
        TRY(tri_net_init(&m->triangles, scene, &m->net.mesh, d->bending));
        TRY(tri_body_init(&m->body, scene, &m->triangles, OWN(tri_own, d)->membrane));
    }
    if (!m->meshed && d->integrator == INTEGRATOR_LEAPFROG &&
        d->bending == BENDING_QUADRATIC && !spring_leapfrog_lacks(scene))
        TRY(make_swept(m, d));
    TRY(make_march(m, d, why));
out:
    return st;
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct tri_motion *m = state;

    net_probe(&m->net, n, uvw, xyz);
}

/* Describes a mesh, and what its hinges and springs do not have of the scene's law. */
static void describe_mesh(const struct tri_motion *m, struct message *line)
{
    const struct mesh *mesh = &m->net.mesh;

    message_add(line, "%d points, %d triangles, %d edges", mesh->vertices,
                mesh->flat.triangles, mesh->edges);
    if (m->shell.bending == BENDING_HINGE)
        message_add(line,
                    "; hinges bend as the mesh is drawn: cut one way, too soft on any net");
    if (OWN(tri_own, &m->asked)->membrane == MEMBRANE_SPRINGS)
        spring_net_tell_mesh(mesh, m->net.scene, line);
}

/* Describes deviations from the scene's law, and the explicit steps' limit. */
static void describe(const void *state, struct message *line)
{
    const struct tri_motion *m = state;
    const bool conditions = m->body.membrane == MEMBRANE_BARAFF_WITKIN;
    struct message limit;

    march_describe(state, &limit);
    if (m->meshed) {
        describe_mesh(m, line);
        if (*limit.text)
            message_add(line, "; %s", limit.text);
        return;
    }
    snprintf(line->text, sizeof line->text, "%s%s%s%s%.160s",
             conditions
                 ? "membrane by the conditions of Baraff and Witkin: the C11, C22 and C33 "
                   "of the sheet, and no C12"
                 : "",
             conditions && (m->march.own || m->triangles.hinge_count) ? "; " : "",
             m->triangles.hinge_count
                 ? "hinges bend with the scene's D about any axis, but with the Gaussian "
                   "curvature of a plate of nu = 0: a narrow strip is 1 / (1 - nu^2) times "
                   "too stiff"
                 : "",
             m->triangles.hinge_count && m->march.own ? "; " : "", limit.text);
}

const struct model tri_model = {
    .name = "triangles",
    .title = "constant-strain triangles",
    .source =
        "membrane: St. Venant and Kirchhoff, or Baraff and Witkin 1998; bending: Bergou "
        "et al. 2006, or Grinspun et al. 2003; steps: Simo and Tarnow 1992, Baraff and "
        "Witkin 1998, leapfrog",
    .serves =
        NET_SERVES | SCENE_NEED_BIAS | SCENE_NEED_SOFTENING | SCENE_NEED_OWN_MATERIALS,
    .options = options,
    .defaults = {.points = {16, 16, 1},
                 .degree = {1, 1, 1},
                 .kinematics = KINEMATICS_NONLINEAR,
                 .integrator = INTEGRATOR_MOMENTUM},
    .bytes = sizeof(struct tri_motion),
    .init = init,
    .advance = march_step,
    .probe = probe,
    .size = march_size,
    .describe = describe,
    .energy = tri_motion_energy,
    .contact = march_contact,
    .forces = march_forces,
    .equilibrium = march_equilibrium,
    .modes = tri_motion_modes,
    .matrices = tri_motion_matrices,
    .clear = tri_motion_clear,
};

#include "mass_spring/spring_model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "mass_spring/spring_rest.h"
#include "models/grid.h"

/* A support that takes part of the thickness is served if it takes the mid-surface: it
 * holds the points, and the sheet may turn about them. */
#define SERVES                                                                             \
    (SCENE_NEED_CONTACT | SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS |                  \
     SCENE_NEED_PATCH_SUPPORTS | SCENE_NEED_COMPONENT_SUPPORTS | SCENE_NEED_DRAG |         \
     SCENE_NEED_INITIAL_MOTION)

static void defaults(struct discretization *d)
{
    *d = (struct discretization){
        .points = {10, 10, 1}, .degree = {1, 1, 1}, .kinematics = KINEMATICS_NONLINEAR};
}

static enum status refuse_scene(const struct scene *scene, struct message *why)
{
    unsigned missing =
        scene_needs(scene) & ~SERVES & ~(unsigned)SCENE_NEED_THICKNESS_SUPPORTS;
    char text[256];

    for (int n = 0; n < scene->support_count; n++)
        if (scene->supports[n].lo[2] > 0.5 || scene->supports[n].hi[2] < 0.5)
            missing |= SCENE_NEED_THICKNESS_SUPPORTS;
    if (!missing)
        return STATUS_OK;
    scene_needs_text(missing, text, sizeof text);
    return status_fail(
        why, STATUS_UNSUPPORTED, "unsupported: no %s%s", text,
        missing & SCENE_NEED_THICKNESS_SUPPORTS ? " that leave out the mid-surface" : "");
}

/* Keys it has a use for. */
enum {
    USED = DISCRETIZATION_PARAMETERS | DISCRETIZATION_INTEGRATOR | DISCRETIZATION_SUBSTEPS |
           DISCRETIZATION_ITERATIONS | DISCRETIZATION_TOLERANCE |
           DISCRETIZATION_STRAIN_LIMIT
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

    TRY(refuse_scene(scene, why));
    TRY(discretization_refuse_net(d, USED, "mass_spring", why));
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

/* Unit normal at a node: of the tangents by central differences, one-sided on the rim; zero
 * where they are parallel. */
static void node_normal(const struct spring_motion *m, int i, int j, double normal[3])
{
    const int *points = m->net.points;
    int i0 = i ? i - 1 : 0, i1 = i < points[0] - 1 ? i + 1 : i;
    int j0 = j ? j - 1 : 0, j1 = j < points[1] - 1 ? j + 1 : j;
    const double *x = m->x;
    double u[3], v[3], length = 0;

    for (int t = 0; t < 3; t++) {
        u[t] = x[3 * (i1 * points[1] + j) + t] - x[3 * (i0 * points[1] + j) + t];
        v[t] = x[3 * (i * points[1] + j1) + t] - x[3 * (i * points[1] + j0) + t];
    }
    for (int t = 0; t < 3; t++) {
        normal[t] = u[(t + 1) % 3] * v[(t + 2) % 3] - u[(t + 2) % 3] * v[(t + 1) % 3];
        length += normal[t] * normal[t];
    }
    length = sqrt(length);
    for (int t = 0; t < 3; t++)
        normal[t] = length > 0 ? normal[t] / length : 0;
}

/* Cell of x among `points` nodes on [0,1], and the two weights there. */
static int cell(int points, double x, double weight[2])
{
    double s = x * (points - 1);
    int i = s < 0 ? 0 : (int)s;

    if (i > points - 2)
        i = points - 2;
    weight[1] = s - i;
    weight[0] = 1 - weight[1];
    return i;
}

/* The mid-surface is bilinear in each cell; the normal off it is that of the four nodes,
 * bilinear and made a unit again, so that the thick sheet has no gaps between cells. */
static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct spring_motion *m = state;

    for (int t = 0; t < n; t++, uvw += 3, xyz += 3) {
        double weight[2][2], middle[3] = {0}, off[3] = {0}, length = 0;
        int i = cell(m->net.points[0], uvw[0], weight[0]);
        int j = cell(m->net.points[1], uvw[1], weight[1]);
        for (int s = 0; s < 4; s++) {
            int a = i + s / 2, b = j + s % 2, node = a * m->net.points[1] + b;
            double normal[3], share = weight[0][s / 2] * weight[1][s % 2];
            node_normal(m, a, b, normal);
            for (int c = 0; c < 3; c++) {
                middle[c] += share * m->x[3 * (size_t)node + c];
                off[c] += share * normal[c];
            }
        }
        for (int c = 0; c < 3; c++)
            length += off[c] * off[c];
        double height = (uvw[2] - 0.5) * m->scene->thickness;
        for (int c = 0; c < 3; c++)
            xyz[c] = middle[c] + (length > 0 ? height / sqrt(length) * off[c] : 0);
    }
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
    const struct spring_motion *m = state;
    struct factor_info info = {.method = "none"};
    bool implicit = m->integrator == INTEGRATOR_IMPLICIT;

    if (implicit && m->newton.system.factor)
        factor_describe(m->newton.system.factor, &info);
    *size = (struct model_size){
        .nodes = m->net.nodes,
        .unknowns = m->newton.supports.free_count,
        .factor_entries = info.entries,
        .solver = info.method,
        .unknown_basis = "mid-surface points",
    };
}

/* The misfit of springs to plane stress, and the explicit method's limit. */
static void describe(const void *state, struct message *line)
{
    const struct spring_motion *m = state;
    struct spring_law_stiffness net = spring_law_effective(&m->net.law, m->net.cell);
    struct spring_law_stiffness sheet = spring_law_plane_stress(m->scene);
    char limit[128] = "";

    if (m->integrator == INTEGRATOR_EXPLICIT)
        snprintf(limit, sizeof limit,
                 "; explicit steps of %.3g s, stable below %.3g s about rest", m->dt,
                 m->limit);
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

#include "models/solid/solid_model.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/grid.h"
#include "models/linalg/gauss.h"
#include "models/mechanics/frames.h"
#include "models/mechanics/lumped_mass.h"
#include "models/room.h"
#include "models/solid/solid_hinge.h"

enum status solid_model_refuse_fabric(const struct scene *scene, struct message *why)
{
    const double *Y = scene->fabric.membrane, *B = scene->fabric.bending;
    const double h = scene->thickness, bend = h * h / 12;

    if (!scene->is_fabric)
        return STATUS_OK;
    return status_fail(
        why, STATUS_UNSUPPORTED,
        "unsupported: no fabrics. This solid's law is isotropic, and an orthotropic one, "
        "%.3g m thick, would bend with %.3g of B1, %.3g of B2 and %.3g of B66; iga with "
        "remedy=selective holds bending and membrane apart",
        h, bend * Y[LAW_WARP] / B[LAW_WARP], bend * Y[LAW_WEFT] / B[LAW_WEFT],
        bend * Y[LAW_SHEAR] / B[LAW_SHEAR]);
}

void solid_model_net(const void *state, double *xyz)
{
    const struct solid_sheet *s = state;

    for (int t = 0; t < 3 * s->space.nodes; t++)
        xyz[t] = solid_hinge_point(&s->space, s->march.x, t / 3, t % 3);
}

enum status solid_model_matrices(const void *state, struct matrix *K, struct matrix *M)
{
    const struct solid_sheet *s = state;

    if (s->space.thickness_basis || s->space.hinge.column)
        return STATUS_UNSUPPORTED;
    assert(!s->march.time);
    return march_matrices(state, K, M);
}

enum status solid_model_basis(const struct scene *scene, const struct discretization *d,
                              bool possible, bool *thickness, struct message *why)
{
    const enum supports_columns columns = supports_columns(scene);
    const bool served =
        columns == SUPPORTS_WHOLE || (columns == SUPPORTS_HINGED && d->points[2] == 2);
    const bool lumped = march_explicit(d);
    const bool can = possible && served && !lumped;

    if (d->unknowns == UNKNOWNS_THICKNESS && lumped)
        return status_fail(why, STATUS_INPUT,
                           "unknowns=thickness has no row sums, its functions don't sum to "
                           "1; use points");
    if (d->unknowns == UNKNOWNS_THICKNESS && !can)
        return status_fail(why, STATUS_INPUT,
                           "unknowns=thickness needs one element through the thickness, no "
                           "weights, and supports that take the whole thickness or, of two "
                           "layers, its middle");
    *thickness = can && d->unknowns != UNKNOWNS_POINTS;
    return STATUS_OK;
}

void solid_model_clear(struct solid_sheet *s)
{
    march_clear(&s->march);
    solid_green_clear(&s->green);
    solid_assembly_clear(&s->assembly);
    supports_clear(&s->supports);
}

static void frames(const void *sheet, double (*Q)[9])
{
    const struct solid_sheet *s = sheet;
    const int part = s->points[0] * s->points[1] * s->points[2];

    for (int a = 0; a < s->space.nodes; a += part)
        frames_of_net(s->points, s->space.thickness_basis, s->march.x + 3 * (size_t)a,
                      Q + a);
}

/* Sets up an iterated system; its solutions are increments of d, or steps of Newton. */
static enum status follow(struct march *m)
{
    struct solid_sheet *s = (struct solid_sheet *)m;
    const struct discretization *d = &m->asked;
    /* Conjugate gradients measure energy; in the norm of GMRES stiff motion hides the soft
     * one. */
    static const double CG_TOLERANCE = 1e-6, GMRES_TOLERANCE = 1e-8, STEP_TOLERANCE = 1e-3;
    const bool rebuilt = kinematics_rebuilds(d->kinematics);
    struct system *system = &s->march.system;
    enum status st;

    if (d->solver == SOLVER_AUTO && rebuilt)
        TRY(system_iterate(system));
    struct iterative *it = system->iterative;
    if (d->kinematics == KINEMATICS_LINEAR || !it)
        return STATUS_OK;
    iterative_tolerate(it,
                       !rebuilt                            ? STEP_TOLERANCE
                       : iterative_method(it) == SOLVER_CG ? CG_TOLERANCE
                                                           : GMRES_TOLERANCE,
                       0);
    TRY(iterative_follow(it, frames, s, rebuilt));
out:
    return st;
}

static enum status rebuild(struct march *m)
{
    struct solid_sheet *s = (struct solid_sheet *)m;

    return solid_assembly_compute(&s->assembly, m->x);
}

/* Assembles about the rest shape, and finds what is held. */
static enum status assemble(struct solid_sheet *s, const struct scene *scene,
                            const struct discretization *d, struct message *why)
{
    enum status st;
    const struct law law = scene_law(scene);
    const struct solid_material material = solid_element_material(&law, scene->density);
    struct solid_space *space = &s->space;

    TRY(solid_assembly_init(&s->assembly, space, &material));
    TRY(supports_init(&s->supports, scene, space->nodes, space->uvw, space->rest, why));
    st = solid_assembly_compute(&s->assembly, space->rest);
    if (st != STATUS_OK)
        TRY(status_fail(why, st, "the rest shape is folded: %s", status_text(st)));
    TRY(lumped_mass_make(d, &s->assembly.graph, s->assembly.M, why));
    if (d->kinematics == KINEMATICS_NONLINEAR)
        TRY(solid_green_init(&s->green, &s->assembly));
out:
    return st;
}

enum status solid_model_init(struct solid_sheet *s, const struct scene *scene,
                             const struct discretization *d, const int points[3],
                             const double *middle, struct message *why)
{
    enum status st;
    struct solid_space *space = &s->space;

    if (middle && !space->thickness_basis)
        TRY(solid_hinge_init(space, scene, points[2], middle, why));
    if (space->thickness_basis)
        TRY(system_parity(scene, space->nodes, points[2], &space->parity));
    memcpy(s->points, d->points, sizeof s->points);
    TRY(assemble(s, scene, d, why));
    s->march = (struct march){
        .body = s->green.body,
        .scene = scene,
        .graph = &s->assembly.graph,
        .M = s->assembly.M,
        .stiffness = (const double(*)[9])s->assembly.K,
        .rest = space->rest,
        .uvw = (const double(*)[3])space->uvw,
        .measure = s->assembly.volume,
        .depth = 1,
        .net = {points[0], points[1], points[2]},
        .supports = &s->supports,
        .parity = space->parity,
        .unknowns = space->thickness_basis ? "thickness" : "control points",
        .singular = ", or it is too thin for control points as unknowns "
                    "(discretization.unknowns=thickness is made for that)",
        .follow = follow,
        .rebuild = rebuild,
        .relief = d->viscosity == VISCOSITY_MEMBRANE,
    };
    TRY(march_init(&s->march, d, why));
    TRY(follow(&s->march));
out:
    return st;
}

enum status solid_model_load(struct solid_sheet *s, const struct dead_load_line line[3])
{
    enum status st = march_load(&s->march, line);

    if (s->march.dead && s->space.hinge.column) {
        solid_hinge_forces(&s->space, s->march.dead);
        march_weigh(&s->march);
    }
    return st;
}

const struct solid_face *solid_model_face(struct solid_sheet *s, const void *body, int face)
{
    const bool both = kinematics_rebuilds(s->march.kinematics);

    if (!contact_wanted(s->march.scene) || face > both)
        return NULL;
    s->face[face] = (struct solid_face){body, both ? face : 0.5};
    return &s->face[face];
}

enum status solid_model_meet(struct solid_sheet *s, const struct solid_face *face,
                             struct contact_surface *surface)
{
    struct contact_outside *outside = &s->march.outside;

    if (s->march.contact)
        return contact_init(s->march.contact, s->march.scene, surface);
    outside->face[face - s->face] = *surface;
    outside->layers = s->points[2];
    outside->first_only = s->space.thickness_basis;
    return STATUS_OK;
}

/* The rows of a mid-surface about an element. */
struct air_rows {
    contact_row *row;
    const struct solid_face *face;
    int width, used;
    int *node;     /* [width] of the element, found so far                              */
    int *found;    /* [width] of a row                                                  */
    double *value; /* [width] of it                                                     */
};

/* Adds `factor` times the functions at u, v to N[width] of the element. */
static void add_row(struct air_rows *r, double u, double v, double factor, double *N)
{
    const int count = r->row(r->face, u, v, r->found, r->value);

    for (int k = 0; k < count; k++) {
        int a = 0;
        while (a < r->used && r->node[a] != r->found[k])
            a++;
        if (a == r->used)
            r->node[r->used++] = r->found[k];
        N[a] += factor * r->value[k];
    }
}

/* Fills in the functions N[3][width] at a place between from and to. */
static void fill_place(struct air_rows *r, const double at[2], const double size[2],
                       double weight, double *N)
{
    static const double step[4] = {-2, -1, 1, 2}, part[4] = {1, -8, 8, -1};
    const double HUNDREDTH = 0.01; /* two of it lead from no Gauss point to the rim */

    add_row(r, at[0], at[1], weight * size[0] * size[1], N);
    for (int d = 0; d < 2; d++)
        for (int k = 0; k < 4; k++) {
            const double h = HUNDREDTH * size[d];
            add_row(r, at[0] + (d ? 0 : step[k] * h), at[1] + (d ? step[k] * h : 0),
                    part[k] / (12 * h), N + (1 + d) * r->width);
        }
}

enum status solid_model_air(struct solid_sheet *s, const void *body, contact_row *row,
                            int width, const int breaks[2], const double *const lines[2],
                            const int degree[2])
{
    enum status st = STATUS_OK;
    const struct scene *scene = s->march.scene;
    const struct solid_face face = {body, 0.5};
    struct air *air = &s->march.air;
    struct air_rows r = {row, &face, width, 0, NULL, NULL, NULL};
    const int n[2] = {degree[0] + 1, degree[1] + 1}, cells = breaks[1] - 1,
              count = scene_sheets(scene) * (breaks[0] - 1) * cells;
    double x[2][GAUSS_MAX], w[2][GAUSS_MAX];
    void *room = NULL;

    if (scene->air.density == 0)
        return st;
    TRY(air_init(air, scene, count, n[0] * n[1], width));
    TRY(room_cut(&room, ROOM(r.found, width), ROOM(r.value, width)));
    gauss_rule(n[0], x[0], w[0]);
    gauss_rule(n[1], x[1], w[1]);
    for (int e = 0; e < count; e++) {
        const int sheet = e / ((breaks[0] - 1) * cells), i = e / cells % (breaks[0] - 1);
        const double *v = lines[1] + e % cells,
                     from = scene_sheet_u(scene, sheet, lines[0][i]),
                     size[2] = {scene_sheet_u(scene, sheet, lines[0][i + 1]) - from,
                                v[1] - v[0]};
        r.node = air->node + e * width, r.used = 0;
        for (int q = 0; q < n[0] * n[1]; q++)
            fill_place(&r,
                       (double[]){from + x[0][q / n[1]] * size[0],
                                  v[0] + x[1][q % n[1]] * size[1]},
                       size, w[0][q / n[1]] * w[1][q % n[1]],
                       air->shape + 3 * (size_t)width * (size_t)(e * n[0] * n[1] + q));
        while (r.used < width) /* functions that are nowhere */
            r.node[r.used] = r.node[0], r.used++;
    }
out:
    free(room);
    return st;
}

enum status solid_model_misfit(struct solid_sheet *s,
                               void (*probe)(const void *state, int n, const double *uvw,
                                             double *xyz))
{
    const struct scene *scene = s->march.scene;
    double *xyz = NULL;

    if (scene->shape == SCENE_FLAT)
        return STATUS_OK;
    xyz = malloc(3 * GRID_POINTS * sizeof *xyz);
    if (!xyz)
        return STATUS_MEMORY;
    grid_sample(probe, s, xyz);
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3], rest[3], *x = xyz + 3 * (size_t)n;

        grid_point(n, uvw);
        scene_rest_point(scene, uvw, rest);
        s->misfit =
            fmax(s->misfit, hypot(hypot(x[0] - rest[0], x[1] - rest[1]), x[2] - rest[2]));
    }
    free(xyz);
    return STATUS_OK;
}

void solid_model_describe(const void *state, struct message *line)
{
    const struct solid_sheet *s = state;
    const double misfit = s->misfit, round_off = 1e-12; /* [m] */

    march_describe(state, line);
    if (misfit > round_off)
        snprintf(line->text, sizeof line->text,
                 "the curved rest shape is met to %.2g m: straight pieces stand for arcs",
                 misfit);
}

#include "models/solid/solid_model.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/grid.h"
#include "models/linalg/order.h"
#include "models/mechanics/large_leapfrog.h"
#include "models/mechanics/large_rest.h"
#include "models/mechanics/lumped_mass.h"
#include "models/mechanics/pencil.h"
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

void solid_model_size(const void *state, struct model_size *size)
{
    const struct solid_motion *m = state;

    *size =
        system_size(&m->system, m->space->thickness_basis ? "thickness" : "control points");
}

void solid_model_contact(const void *state, struct model_contact *contact)
{
    const struct solid_motion *m = state;

    if (m->large.contact)
        large_motion_contact(&m->large, contact);
    else
        contact_outside_report(&m->outside, contact);
}

void solid_model_net(const void *state, double *xyz)
{
    const struct solid_motion *m = state;

    for (int t = 0; t < 3 * m->space->nodes; t++)
        xyz[t] = solid_hinge_point(m->space, m->x, t / 3, t % 3);
}

/* Computes r = load - K d, zero at held unknowns. */
static void residual(const struct solid_motion *m, const double *d, double *r)
{
    size_t count = 3 * (size_t)m->space->nodes;

    blocks_multiply(&m->assembly.graph, (const double(*)[9])m->assembly.K, d, r);
    for (size_t t = 0; t < count; t++)
        r[t] = m->supports.free_index[t] < 0 ? 0 : m->load[t] - r[t];
}

static double largest(size_t count, const double *x)
{
    double most = 0;

    for (size_t t = 0; t < count; t++)
        if (!(fabs(x[t]) <= most))
            most = fabs(x[t]);
    return most;
}

/* A correction above this part of the solution means a numerically singular system. */
static const double LARGEST_CORRECTION = 1e-2;

enum status solid_model_equilibrium(void *state, struct counters *counters,
                                    struct message *why)
{
    enum status st;
    struct solid_motion *m = state;
    struct newmark *n = &m->newmark;
    size_t count = 3 * (size_t)m->space->nodes;
    double *r = n->work, change = 0;
    const bool nonlinear = m->kinematics == KINEMATICS_NONLINEAR;

    TRY(supports_allow_rest(&m->supports, m->scene, nonlinear, why));
    m->time = supports_rest_time(&m->supports, m->scene);
    if (nonlinear)
        return large_rest_equilibrium(&m->large, counters, why);
    memset(n->d, 0, 3 * count * sizeof *n->d); /* d, v and a */
    supports_shift(&m->supports, m->scene, m->time, m->held);
    for (int h = 0; h < m->supports.held_count; h++)
        n->d[m->supports.held[h]] = m->held[h];
    m->started = false;
    st = system_factor(&m->system, 1, (const double(*)[9])m->assembly.K, 0, NULL);
    counters->factorisations++;
    for (int pass = 0; st == STATUS_OK && pass < 2; pass++) {
        residual(m, n->d, r);
        TRY(system_solve(&m->system, r));
        counters->solves++;
        for (size_t t = 0; t < count; t++)
            n->d[t] += r[t];
        change = largest(count, r) / largest(count, n->d);
    }
    if (st == STATUS_OK && change > LARGEST_CORRECTION)
        st = STATUS_INDEFINITE;
    if (st == STATUS_INDEFINITE)
        status_fail(why, st,
                    "the stiffness is singular to working accuracy: the supports leave the "
                    "sheet free to move, or it is too thin for control points as unknowns "
                    "(discretization.unknowns=thickness is made for that)");
    for (size_t t = 0; t < count; t++)
        m->x[t] = m->space->rest[t] + n->d[t];
    if (m->kinematics != KINEMATICS_LINEAR) /* there d is the last step's increment */
        memset(n->d, 0, count * sizeof *n->d);
out:
    return st;
}

static struct pencil pencil_of(const struct solid_motion *m)
{
    return (struct pencil){&m->assembly.graph, (const double(*)[9])m->assembly.K,
                           m->assembly.M};
}

enum status solid_model_modes(void *state, int count, double *omega, struct message *why)
{
    struct solid_motion *m = state;
    const struct pencil p = pencil_of(m);

    if (m->large.rested)
        return large_rest_modes(&m->large, count, omega, why);
    return pencil_modes(&p, &m->supports, m->system.parity, count, omega, why);
}

enum status solid_model_matrices(const void *state, struct matrix *K, struct matrix *M)
{
    const struct solid_motion *m = state;
    const struct pencil p = pencil_of(m);

    if (m->space->thickness_basis || m->space->hinge.column)
        return STATUS_UNSUPPORTED;
    assert(!m->time);
    return pencil_matrices(&p, K, M);
}

enum status solid_model_basis(const struct scene *scene, const struct discretization *d,
                              bool possible, bool *thickness, struct message *why)
{
    const enum supports_columns columns = supports_columns(scene);
    const bool served =
        columns == SUPPORTS_WHOLE || (columns == SUPPORTS_HINGED && d->points[2] == 2);
    const bool lumped = lumped_mass_wanted(d);
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

/* Finds the parity of one flat sheet in Legendre functions through the thickness
 * (solid_space.h), 0/1 per component; NULL unless the normal is a coordinate axis.
 * STATUS_MEMORY. */
static enum status find_parity(const struct scene *scene, int nodes, int layers,
                               unsigned char **found)
{
    const double *u = scene->axis_u, *v = scene->axis_v;
    double w[3];
    int normal = -1;

    scene_normal(scene, w);
    for (int i = 0; i < 3 && scene->shape == SCENE_FLAT && scene->sheets < 2; i++)
        if (fabs(w[i]) == 1 && u[i] == 0 && v[i] == 0)
            normal = i;
    if (normal < 0)
        return STATUS_OK;
    unsigned char *parity = *found = malloc(3 * (size_t)nodes);
    if (!parity)
        return STATUS_MEMORY;
    for (int a = 0; a < nodes; a++)
        for (int i = 0; i < 3; i++)
            parity[3 * a + i] = (unsigned char)((a % layers + (i == normal)) % 2);
    return STATUS_OK;
}

enum status solid_model_init(struct solid_sheet *s, const struct scene *scene,
                             const struct discretization *d, const int points[3],
                             const double *middle, struct message *why)
{
    int *order = NULL;
    enum status st;

    if (middle && !s->space.thickness_basis)
        TRY(solid_hinge_init(&s->space, scene, points[2], middle, why));
    TRY(order_wide(points[0], points[1], points[2], &order));
    if (s->space.thickness_basis)
        TRY(find_parity(scene, s->space.nodes, points[2], &s->space.parity));
    TRY(solid_motion_init(&s->motion, scene, &s->space, d, order, why));
out:
    free(order);
    return st;
}

enum status solid_model_misfit(struct solid_sheet *s,
                               void (*probe)(const void *state, int n, const double *uvw,
                                             double *xyz))
{
    const struct scene *scene = s->motion.scene;
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

    large_leapfrog_describe(&s->motion.large, line);
    if (misfit > round_off)
        snprintf(line->text, sizeof line->text,
                 "the curved rest shape is met to %.2g m: straight pieces stand for arcs",
                 misfit);
}

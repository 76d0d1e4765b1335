#include "shell_ref/shell_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "iga/bspline_contact.h"
#include "iga/support_knots.h"
#include "models/damping.h"
#include "models/linalg/order.h"
#include "models/mechanics/dead_load.h"
#include "models/mechanics/large_leapfrog.h"
#include "models/mechanics/large_rest.h"
#include "models/mechanics/lumped_mass.h"
#include "models/mechanics/pencil.h"
#include "models/room.h"
#include "shell_ref/shell_mass.h"

/* Returns the density at a node [kg/m^3]. */
static double density_at(const struct shell_motion *m, int node)
{
    return m->assembly.material[scene_sheet_of(m->scene, node, m->space->nodes)].density;
}

static void compute_load(struct shell_motion *m)
{
    const struct scene *s = m->scene;

    for (int a = 0; a < m->space->nodes; a++)
        for (int i = 0; i < 3; i++) {
            double force =
                (density_at(m, a) * s->gravity[i] + s->drag * s->wind[i]) * s->thickness;
            m->load[3 * a + i] = force * m->assembly.area[a];
        }
}

static enum status add_loads(struct shell_motion *m)
{
    const struct bspline *b = m->space->basis;
    struct dead_load_line line[3] = {{0}, {0}, {.n = 1}};
    struct bspline part[2];

    for (int i = 0; i < 2; i++) {
        part[i] = bspline_part(&b[i], 0);
        line[i] =
            (struct dead_load_line){part[i].n,       b[i].p,         part[i].n - b[i].p + 1,
                                    b[i].U + b[i].p, bspline_values, &part[i]};
    }
    return dead_load_make(m->scene, line, &m->dead, m->load);
}

/* Fills in the functions at the points of the mass, which lie in each element alike. */
static enum status press(struct shell_motion *m)
{
    const struct shell_space *s = m->space;
    struct shell_element *e = &m->assembly.work[0];
    struct shell_place place[SHELL_MAX_POINTS];
    const int points = shell_space_places(s, SHELL_MASS, 0, place), local = s->local;
    enum status st =
        pressure_init(&m->pressure, m->scene, s->elements, points, local, s->ien);
    double *shape = m->pressure.shape;

    if (!shape)
        return st;
    for (int n = 0; n < s->elements; n++) {
        const double *T;
        shell_space_places(s, SHELL_MASS, n, place);
        shell_space_functions(s, SHELL_MASS, n, e->at[SHELL_MASS].room, &T);
        for (int q = 0; q < points; q++)
            for (int a = 0; a < SHELL_SLOPES * local; a++)
                *shape++ = T[a * s->rule[SHELL_MASS].padded + q] *
                           (a < local ? place[q].weight : 1);
    }
    return st;
}

/* Widens an edge of a sheet in direction d to the second row of control points, at either
 * end. */
static void clamp_edge(const struct scene *scene, struct scene_support *s, int d,
                       const struct bspline *b)
{
    const int n = bspline_part(b, 0).n;
    double at = s->lo[1];
    const int first = d ? 0 : n * scene_sheet_at(scene, s->lo[0], &at);

    if (at == 0)
        s->hi[d] = support_knots_at(scene, b, d, first + 1);
    else if (at == 1)
        s->lo[d] = support_knots_at(scene, b, d, first + n - 2);
}

/* Makes the scene's supports, borrowed paths and all, with clamped edges two rows wide. */
static enum status clamp_edges(struct shell_motion *m, struct message *why)
{
    const struct scene *scene = m->scene;
    enum status st;

    m->held_scene = *scene;
    TRY(support_knots_hold(scene, m->space->basis, &m->held_scene.supports));
    for (int n = 0; n < scene->support_count; n++) {
        struct scene_support *s = &m->held_scene.supports[n];
        if (s->lo[2] > 0.5 || s->hi[2] < 0.5)
            TRY(status_fail(why, STATUS_UNSUPPORTED,
                            "support %d misses the mid-surface w = 1/2, and a shell has "
                            "nothing else to hold",
                            n));
        if (s->fix != FIX_XYZ || s->lo[2] == s->hi[2])
            continue;
        for (int d = 0; d < 2; d++)
            if (s->lo[d] == s->hi[d] && s->lo[1 - d] < s->hi[1 - d])
                clamp_edge(scene, s, d, &m->space->basis[d]);
    }
out:
    return st;
}

static enum status hold(struct shell_motion *m, struct message *why)
{
    int nodes = m->space->nodes, rows = bspline_points(&m->space->basis[1]);
    double(*uvw)[3] = malloc((size_t)nodes * sizeof *uvw);
    enum status st = STATUS_MEMORY;

    if (!uvw)
        goto out;
    for (int a = 0; a < nodes; a++) {
        uvw[a][0] = support_knots_at(m->scene, &m->space->basis[0], 0, a / rows);
        uvw[a][1] = support_knots_at(m->scene, &m->space->basis[1], 1, a % rows);
        uvw[a][2] = 0.5;
    }
    TRY(clamp_edges(m, why));
    st = supports_init(&m->supports, &m->held_scene, nodes, uvw, m->space->rest, why);
out:
    free(uvw);
    return st;
}

/* Finds the parity under linear kinematics of a flat sheet whose normal is a coordinate
 * axis: bending and stretching do not couple; m->parity is 1 for components along the
 * normal, NULL elsewhere. */
static enum status find_parity(struct shell_motion *m)
{
    const struct scene *s = m->scene;
    const int count = 3 * m->space->nodes;
    int normal = -1;

    for (int i = 0; i < 3 && s->shape == SCENE_FLAT && s->sheets < 2; i++)
        if (s->axis_u[i] == 0 && s->axis_v[i] == 0)
            normal = i;
    if (normal < 0)
        return STATUS_OK;
    m->parity = malloc((size_t)count);
    for (int t = 0; m->parity && t < count; t++)
        m->parity[t] = t % 3 == normal;
    return m->parity ? STATUS_OK : STATUS_MEMORY;
}

static enum status make_room(struct shell_motion *m, bool lumped)
{
    size_t nodes = (size_t)m->space->nodes;
    const size_t pairs = (size_t)m->assembly.graph.start[nodes];
    const bool linear = m->kinematics == KINEMATICS_LINEAR && contact_wanted(m->scene);
    enum status st =
        room_cut(&m->room, ROOM(m->x, 3 * nodes), ROOM(m->load, 3 * nodes),
                 ROOM(m->held, 4 * (size_t)m->supports.held_count),
                 ROOM(m->beyond, lumped ? pairs : 0), ROOM(m->lumped, lumped ? pairs : 0),
                 ROOM(m->K, pairs), ROOM(m->meets.tangent, linear ? pairs : 0),
                 ROOM(m->meets.room, linear ? 18 * nodes : 0));

    if (st == STATUS_OK)
        memcpy(m->x, m->space->rest, 3 * nodes * sizeof *m->x);
    return st;
}

static enum status make_large(struct shell_motion *m, const struct discretization *d)
{
    const bool rings = d->viscosity == VISCOSITY_NONE;

    m->large = (struct large_motion){
        .body = m->assembly.body,
        .scene = m->scene,
        .graph = &m->assembly.graph,
        .M = m->lumped ? m->lumped : m->assembly.M,
        .beyond = m->beyond,
        .rest = m->space->rest,
        .load = m->load,
        .supports = &m->supports,
        .system = &m->system,
        .newmark = &m->newmark,
        .K = m->K,
        .x = m->x,
        .held = m->held,
        .lag = rings ? 0 : large_motion_lag,
        .rings = rings,
        .full = d->newton == NEWTON_FULL,
        .pressure = m->pressure.value != 0 ? &m->pressure : NULL,
        .contact = contact_wanted(m->scene) ? &m->contact : NULL,
    };
    return large_motion_init(&m->large);
}

/* Finds the surface's point in the control points: contact_row. */
static int row(const void *motion, double u, double v, int *node, double *shape)
{
    const struct shell_motion *m = motion;
    double T[SHELL_DERIVATIVES * SHELL_MAX_LOCAL], s;
    const int sheet = scene_sheet_at(m->scene, u, &s);

    shell_space_at(m->space, sheet, s, v, node, T);
    memcpy(shape, T, (size_t)m->space->local * sizeof *shape);
    return m->space->local;
}

/* Does so for the control net. */
static int row_of_net(const void *motion, double u, double v, int *node, double *shape)
{
    const struct shell_space *s = ((const struct shell_motion *)motion)->space;
    const struct bspline *b = s->basis;
    double N[2][BSPLINE_MAX_ORDER], sum = 0;
    const int first[2] = {bspline_contact_hats(&b[0], u, N[0]),
                          bspline_contact_hats(&b[1], v, N[1])};
    int used = 0;

    for (int a = 0; a < s->local; a++) {
        const int i = a / (b[1].p + 1), j = a % (b[1].p + 1);
        node[used] = (first[0] + i) * b[1].n + first[1] + j;
        shape[used] = N[0][i] * N[1][j] * (s->weight ? s->weight[node[used]] : 1);
        sum += shape[used];
        used += shape[used] != 0;
    }
    for (int n = 0; n < used; n++)
        shape[n] /= sum;
    return used;
}

/* Makes the surface that meets bodies and itself. */
static enum status meet(struct shell_motion *m, const struct discretization *d)
{
    static contact_row *const rows[CONTACT_SAMPLES] = {row, row_of_net};
    const struct shell_space *space = m->space;
    struct contact_surface surface;
    enum status st = bspline_contact_surface(m->scene, space->basis, d, m, rows,
                                             space->local, space->nodes, &surface);

    m->meets = (struct contact_linear){.contact = &m->contact,
                                       .newmark = &m->newmark,
                                       .system = &m->system,
                                       .K = (const double(*)[9])m->K,
                                       .M = m->assembly.M,
                                       .load = m->load,
                                       .tangent = m->meets.tangent,
                                       .room = m->meets.room};
    return st == STATUS_OK ? contact_init(&m->contact, m->scene, &surface) : st;
}

static struct shell_material material_of(const struct scene *sheet)
{
    struct shell_material material = {scene_law(sheet), sheet->density, {{0}}};

    for (int i = 0; i < 2; i++) {
        const double *along = material.law.along[i], l = sheet->length, w = sheet->width;
        material.along[i][0] = along[0] / (l * l);
        material.along[i][1] = along[1] / (w * w);
        material.along[i][2] = along[2] / (l * w);
    }
    return material;
}

static enum status build(struct shell_motion *m, const struct discretization *d,
                         struct message *why)
{
    const struct scene *scene = m->scene;
    struct shell_material material[SCENE_MAX_SHEETS];
    int *order = NULL;
    enum status st;

    for (int k = 0; k < scene_sheets(scene); k++) {
        const struct scene sheet = scene_sheet(scene, k);
        material[k] = material_of(&sheet);
    }
    TRY(shell_assembly_init(&m->assembly, m->space, scene_sheets(scene), material, why));
    TRY(hold(m, why));
    TRY(newmark_init(&m->newmark, m->space->nodes, scene->step,
                     damping_mass(scene) + damping_drag(scene), damping_stiffness(scene)));
    TRY(make_room(m,
                  lumped_mass_wanted(d) && !m->supports.moving && !contact_wanted(scene)));
    if (m->beyond)
        TRY(shell_mass_beyond(m->space, &m->assembly.graph, &m->supports, m->assembly.M,
                              m->lumped, m->beyond));
    else
        TRY(lumped_mass_make(d, &m->assembly.graph, m->assembly.M, why));
    compute_load(m);
    TRY(add_loads(m));
    TRY(press(m));
    supports_initial_velocity(&m->supports, scene, m->space->rest, NULL, m->newmark.v);
    TRY(large_body_tangent(&m->assembly.body, &large_path_statics, m->x,
                           (struct large_foresight){0}, m->K));
    if (m->kinematics == KINEMATICS_NONLINEAR)
        TRY(make_large(m, d));
    else if (!contact_wanted(scene))
        TRY(find_parity(m));
    TRY(order_wide(m->space->basis[0].n, bspline_points(&m->space->basis[1]), 1, &order));
    TRY(system_init(&m->system, &m->assembly.graph, &m->supports, m->parity, order, d));
    if (contact_wanted(scene))
        TRY(meet(m, d));
    if (m->kinematics == KINEMATICS_NONLINEAR)
        TRY(large_leapfrog_make(&m->large, d, why));
out:
    free(order);
    return st;
}

void shell_motion_clear(struct shell_motion *m)
{
    system_clear(&m->system);
    newmark_clear(&m->newmark);
    supports_clear(&m->supports);
    shell_assembly_clear(&m->assembly);
    free(m->held_scene.supports);
    free(m->parity);
    free(m->room);
    free(m->dead);
    pressure_clear(&m->pressure);
    large_motion_clear(&m->large);
    contact_linear_clear(&m->meets);
    contact_clear(&m->contact);
    memset(m, 0, sizeof *m);
}

enum status shell_motion_init(struct shell_motion *m, const struct scene *scene,
                              const struct shell_space *space,
                              const struct discretization *d, struct message *why)
{
    enum status st;

    *m = (struct shell_motion){.scene = scene, .space = space, .kinematics = d->kinematics};
    st = build(m, d, why);
    if (st != STATUS_OK)
        shell_motion_clear(m);
    return st;
}

static const double (*stiffness(const struct shell_motion *m))[9]
{
    return (const double(*)[9])m->K;
}

/* Finds where held unknowns are on their paths at time t; NULL if nothing moves. */
static const struct newmark_held *follow(struct shell_motion *m, double t,
                                         struct newmark_held *held)
{
    if (!m->supports.moving)
        return NULL;
    *held = newmark_follow(&m->supports, m->scene, t, m->newmark.dt, m->held);
    return held;
}

static enum status step_linear(struct shell_motion *m, struct counters *counters)
{
    enum status st;
    struct newmark *n = &m->newmark;
    struct newmark_held held;
    size_t count = 3 * (size_t)m->space->nodes;

    if (!m->started) {
        TRY(newmark_begin(n, &m->system, stiffness(m), m->assembly.M, m->load,
                          follow(m, m->time, &held), counters));
        m->started = m->meets.plain = true;
    }
    const struct newmark_held *at = follow(m, m->time + n->dt, &held);
    if (m->meets.contact) {
        TRY(contact_linear_step(&m->meets, m->time, at, m->x, counters));
    } else {
        TRY(newmark_step(n, &m->system, stiffness(m), m->assembly.M, m->load, at));
        counters->solves++;
    }
    for (size_t t = 0; t < count; t++)
        m->x[t] = m->space->rest[t] + m->newmark.d[t];
out:
    return st;
}

enum status shell_motion_step(void *state, struct counters *counters)
{
    struct shell_motion *m = state;
    enum status st = m->kinematics == KINEMATICS_LINEAR
                         ? step_linear(m, counters)
                         : large_motion_step(&m->large, m->time, counters);
    double factor = damping_velocity(m->scene);
    size_t count = 3 * (size_t)m->space->nodes;

    if (st != STATUS_OK)
        return st;
    for (size_t t = 0; factor != 1 && t < count; t++)
        m->newmark.v[t] *= factor;
    m->time += m->newmark.dt;
    counters->steps++;
    return STATUS_OK;
}

void shell_motion_energy(const void *state, struct energy *energy)
{
    const struct shell_motion *m = state;
    const struct newmark *n = &m->newmark;
    const struct blocks *graph = &m->assembly.graph;
    const struct scene *s = m->scene;
    size_t count = 3 * (size_t)m->space->nodes;
    double *y = n->work;

    *energy = (struct energy){0};
    blocks_multiply_mass(graph, m->assembly.M, n->v, y);
    for (size_t t = 0; t < count; t++) {
        energy->kinetic += n->v[t] * y[t] / 2;
        double sheet = density_at(m, (int)(t / 3)) * s->thickness;
        double weight = sheet * s->gravity[t % 3] * m->assembly.area[t / 3] +
                        (m->dead ? m->dead[t] : 0);
        energy->potential -= weight * (m->x[t] - m->space->rest[t]);
    }
    if (m->beyond)
        energy->kinetic = large_leapfrog_kinetic(&m->large);
    if (m->pressure.value != 0)
        energy->potential += pressure_energy(&m->pressure, m->space->rest, m->x);
    if (m->kinematics == KINEMATICS_NONLINEAR) {
        if (shell_assembly_energy(&m->assembly, m->x, &energy->elastic) != STATUS_OK)
            energy->elastic = NAN;
        return;
    }
    blocks_multiply(graph, stiffness(m), n->d, y);
    for (size_t t = 0; t < count; t++)
        energy->elastic += n->d[t] * y[t] / 2;
}

void shell_motion_contact(const void *state, struct model_contact *contact)
{
    const struct shell_motion *m = state;

    if (m->kinematics == KINEMATICS_NONLINEAR)
        large_motion_contact(&m->large, contact);
    else
        contact_report(&m->contact, contact);
}

void shell_motion_size(const void *state, struct model_size *size)
{
    const struct shell_motion *m = state;

    *size = system_size(&m->system, "control points");
}

/* --- Results without time stepping. */

static enum status rest_linear(struct shell_motion *m, struct counters *counters)
{
    enum status st;
    struct newmark *n = &m->newmark;
    size_t count = 3 * (size_t)m->space->nodes;
    const double(*K)[9] = (const double(*)[9])m->K;
    double *r = n->work;

    memset(n->d, 0, 3 * count * sizeof *n->d); /* d, v and a */
    supports_shift(&m->supports, m->scene, m->time, m->held);
    for (int h = 0; h < m->supports.held_count; h++)
        n->d[m->supports.held[h]] = m->held[h];
    TRY(system_factor(&m->system, 1, K, 0, NULL));
    counters->factorisations++;
    for (int pass = 0; pass < 2; pass++) {
        blocks_multiply(&m->assembly.graph, K, n->d, r);
        for (size_t t = 0; t < count; t++)
            r[t] = m->load[t] - r[t];
        TRY(system_solve(&m->system, r));
        counters->solves++;
        for (size_t t = 0; t < count; t++)
            n->d[t] += r[t];
    }
    for (size_t t = 0; t < count; t++)
        m->x[t] = m->space->rest[t] + n->d[t];
out:
    return st;
}

enum status shell_motion_equilibrium(void *state, struct counters *counters,
                                     struct message *why)
{
    struct shell_motion *m = state;
    enum status st;

    TRY(supports_allow_rest(&m->supports, m->scene, m->kinematics == KINEMATICS_NONLINEAR,
                            why));
    m->time = supports_rest_time(&m->supports, m->scene);
    m->started = false;
    if (m->kinematics == KINEMATICS_NONLINEAR)
        return large_rest_equilibrium(&m->large, counters, why);
    st = rest_linear(m, counters);
    if (st == STATUS_INDEFINITE)
        status_fail(why, st,
                    "the stiffness is singular to working accuracy: the supports "
                    "leave the sheet free to move");
out:
    return st;
}

/* Makes the tangent of the rest shape, wherever x is: *K, owned by the caller. */
static enum status make_stiffness(const struct shell_motion *m, double (**K)[9])
{
    const struct blocks *graph = &m->assembly.graph;

    *K = malloc((size_t)graph->start[graph->nodes] * sizeof **K);
    return *K ? large_body_tangent(&m->assembly.body, &large_path_statics, m->space->rest,
                                   (struct large_foresight){0}, *K)
              : STATUS_MEMORY;
}

enum status shell_motion_modes(void *state, int count, double *omega, struct message *why)
{
    struct shell_motion *m = state;
    double(*K)[9];

    if (m->large.rested)
        return large_rest_modes(&m->large, count, omega, why);
    enum status st = make_stiffness(m, &K);
    if (st == STATUS_OK)
        st = pencil_modes(
            &(struct pencil){&m->assembly.graph, (const double(*)[9])K, m->assembly.M},
            &m->supports, m->parity, count, omega, why);
    free(K);
    return st;
}

enum status shell_motion_matrices(const void *state, struct matrix *K, struct matrix *M)
{
    const struct shell_motion *m = state;
    double(*block)[9];
    enum status st = make_stiffness(m, &block);

    if (st == STATUS_OK)
        st = pencil_matrices(
            &(struct pencil){&m->assembly.graph, (const double(*)[9])block, m->assembly.M},
            K, M);
    free(block);
    return st;
}

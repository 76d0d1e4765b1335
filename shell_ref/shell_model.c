#include "shell_ref/shell_model.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "iga/bspline_contact.h"
#include "iga/cloak_net.h"
#include "iga/support_knots.h"
#include "models/contact/contact_rest.h"
#include "models/grid.h"
#include "models/linalg/blocks.h"
#include "models/mechanics/lumped_mass.h"
#include "models/room.h"
#include "models/vector.h"

/* The mass of the shell's explicit steps.
 *
 * Row sums D of the mass M are too heavy for whatever turns: by (p + 1) / 12 of a span's
 * square times the rate of the slope, squared. Explicit steps therefore use them twice,
 * M^-1 ~ D^-1 + D^-1 (D - M) D^-1, which is positive, as D^-1 M is in 0 .. 1, and off by
 * the square of 1 - D^-1 M: of fourth order (two terms of Neumann's series).
 *
 * Open ends have the highest frequencies of a basis, where its functions are short: a free
 * edge costs a net more than half of its steps. The second derivative across the edge, zero
 * where nobody bends or stretches it there, has a mass P of its own besides (as Deng, Calo,
 * CMAME 383, 2021, penalise it in K and M). The largest frequency of a line cured of
 * locking, over the speed of sound by the span: by D 3.1, 2.8, 3.9, 4.6 for degrees 2 to 5;
 * by M as above 4.1, 3.5, 5.1, 6.0; by M + P 2.7, 2.1, 2.5, 3.1.
 */

/* P in units of D. D^-1 (M + P) must stay below 2: it is 1.86 at most. */
static const double EDGE = 1.6;

enum { STENCIL = 3 }; /* control points that a second derivative at an end depends on */

/* One end of a direction: the derivative there, from the end inward. */
struct end {
    int last, way; /* of the node at the end, and to the next one                       */
    double q[STENCIL];
};

/* Fills both ends of a direction of a part; false where it has none, or they meet. */
static bool find_ends(const struct bspline *basis, int part, int count, int way,
                      struct end end[2])
{
    const struct bspline own = bspline_part(basis, part), *b = &own;
    double N[3 * BSPLINE_MAX_ORDER];

    if (basis->wrap || count < 2 * (b->p + 1))
        return false;
    for (int n = 0; n < 2; n++) {
        end[n] = (struct end){n ? (count - 1) * way : 0, n ? -way : way, {0}};
        bspline_eval(b, bspline_span(b, part + n), part + n, 2, N);
        for (int a = 0; a < STENCIL; a++)
            end[n].q[a] = N[2 * (b->p + 1) + (n ? b->p - a : a)];
    }
    return true;
}

/* A derivative: its control points and their factors. */
struct stencil {
    int count, node[STENCIL * STENCIL];
    double q[STENCIL * STENCIL];
};

/* Makes that across an end at the node `origin` along it; or across two. */
static struct stencil across(const struct end *end, const struct end *other, int origin)
{
    struct stencil s = {.count = other ? STENCIL * STENCIL : STENCIL};

    for (int n = 0; n < s.count; n++) {
        const int a = n % STENCIL, b = n / STENCIL;
        s.node[n] = origin + end->last + a * end->way;
        s.q[n] = end->q[a];
        if (other)
            s.node[n] += other->last + b * other->way, s.q[n] *= other->q[b];
    }
    return s;
}

struct masses {
    const struct blocks *graph;
    const struct supports *supports;
    double *D, *beyond;
};

static bool is_free(const struct masses *m, const struct stencil *s)
{
    for (int n = 0; n < 3 * s->count; n++)
        if (m->supports->free_index[3 * s->node[n / 3] + n % 3] < 0)
            return false;
    return true;
}

/* Adds so much mass of a derivative to P, in units of D. */
static void add(const struct masses *m, const struct stencil *s, double mass)
{
    double compliance = 0;

    for (int n = 0; n < s->count; n++)
        compliance += s->q[n] * s->q[n] / m->D[s->node[n]];
    for (int a = 0; a < s->count; a++)
        for (int b = 0; b < s->count; b++)
            if (s->node[a] <= s->node[b])
                m->beyond[blocks_find(m->graph, s->node[a], s->node[b])] -=
                    mass / compliance * s->q[a] * s->q[b];
}

/* Tells whether the other direction's end has masses where this end's stencil is. */
static bool meets(const struct masses *m, const struct end *end, const struct end *other,
                  int origin)
{
    for (int a = 0; a < STENCIL; a++) {
        const struct stencil s = across(other, NULL, origin + end->last + a * end->way);
        if (is_free(m, &s))
            return true;
    }
    return false;
}

/* Adds the ends of one direction, of nodes `origin` + i `way`, i < count. What an end of
 * the other direction has, too, is counted once, and rows beside a corner that is not free
 * are left out where it has masses: their sum would pass 2. */
static void add_ends(const struct masses *m, const struct end end[2],
                     const struct end *other, int origin, int way, int count)
{
    for (int n = 0; n < 2 * count; n++) {
        const int i = n / 2;
        const struct end *e = &end[n % 2], *o = other + (i >= STENCIL);
        const struct stencil s = across(e, NULL, origin + i * way);
        if (!is_free(m, &s))
            continue;
        if (other && (i < STENCIL || i >= count - STENCIL) && meets(m, e, o, origin)) {
            const struct stencil corner = across(e, o, origin);
            if (!is_free(m, &corner))
                continue;
            if (i == 0 || i == count - 1)
                add(m, &corner, -EDGE);
        }
        add(m, &s, EDGE);
    }
}

/* Computes lumped[pairs], D on the diagonal and zero elsewhere, and beyond[pairs] = D - M -
 * P from M[pairs], consistent. Where one of the three
 * control points behind an edge is held, P is zero, and along sides of fewer than 2 (p + 1)
 * points. STATUS_MEMORY. */
static enum status shell_mass_beyond(const struct shell_space *space,
                                     const struct blocks *graph,
                                     const struct supports *supports, const double *M,
                                     double *lumped, double *beyond)
{
    const int parts = space->basis[0].parts > 1 ? space->basis[0].parts : 1;
    const int rows = bspline_points(&space->basis[1]),
              columns = graph->nodes / rows / parts;
    struct masses m = {graph, supports, calloc((size_t)graph->nodes, sizeof(double)),
                       beyond};
    struct end u[2], v[2];

    if (!m.D)
        return STATUS_MEMORY;
    for (int a = 0; a < graph->nodes; a++)
        for (long n = graph->start[a]; n < graph->start[a + 1]; n++) {
            lumped[n] = 0;
            beyond[n] = -M[n];
            m.D[a] += M[n];
            if (n > graph->start[a])
                m.D[graph->node[n]] += M[n];
        }
    for (int a = 0; a < graph->nodes; a++) {
        lumped[graph->start[a]] = m.D[a];
        beyond[graph->start[a]] += m.D[a];
    }
    for (int part = 0; part < parts; part++) {
        const int origin = part * columns * rows;
        const bool across_u = find_ends(&space->basis[0], part, columns, rows, u),
                   across_v = find_ends(&space->basis[1], 0, rows, 1, v);
        if (across_u)
            add_ends(&m, u, NULL, origin, 1, rows);
        if (across_v)
            add_ends(&m, v, across_u ? u : NULL, origin, rows, columns);
    }
    free(m.D);
    return STATUS_OK;
}

static enum status add_loads(struct shell *m)
{
    const struct bspline *b = m->space.basis;
    struct dead_load_line line[3] = {{0}, {0}, {.n = 1}};
    struct bspline part[2];

    for (int i = 0; i < 2; i++) {
        part[i] = bspline_part(&b[i], 0);
        line[i] =
            (struct dead_load_line){part[i].n,       b[i].p,         part[i].n - b[i].p + 1,
                                    b[i].U + b[i].p, bspline_values, &part[i]};
    }
    return march_load(&m->march, line);
}

/* Fills in the functions at the points of the mass, which lie in each element alike. */
static void fill_functions(struct shell *m, double *shape)
{
    const struct shell_space *s = &m->space;
    struct shell_element *e = &m->assembly.work[0];
    struct shell_place place[SHELL_MAX_POINTS];
    const int local = s->local;

    for (int n = 0; shape && n < s->elements; n++) {
        const double *T;
        const int points = shell_space_places(s, SHELL_MASS, n, place);
        shell_space_functions(s, SHELL_MASS, n, e->at[SHELL_MASS].room, &T);
        for (int q = 0; q < points; q++)
            for (int a = 0; a < SHELL_SLOPES * local; a++)
                *shape++ = T[a * s->rule[SHELL_MASS].padded + q] *
                           (a < local ? place[q].weight : 1);
    }
}

/* Makes pressure and air. */
static enum status press(struct shell *m)
{
    enum status st;
    const struct shell_space *s = &m->space;
    struct shell_place place[SHELL_MAX_POINTS];
    const int points = shell_space_places(s, SHELL_MASS, 0, place);

    TRY(pressure_init(&m->march.pressure, m->scene, s->elements, points, s->local, s->ien));
    TRY(air_init(&m->march.air, m->scene, s->elements, points, s->local));
    fill_functions(m, m->march.pressure.shape);
    fill_functions(m, m->march.air.shape);
    if (m->march.air.node)
        memcpy(m->march.air.node, s->ien,
               (size_t)s->elements * (size_t)s->local * sizeof *s->ien);
out:
    return st;
}

/* Returns the components that a clamp holds of the row beside an edge, whose nodes begin at
 * `first` and come every `way`, `step` from those of the edge: all but the one along the
 * sheet across the edge, in which the sheet may stretch. All where that is no coordinate
 * axis, or where the clamp turns it: these get frames (release). */
static int held_beside(const struct shell *m, const struct scene_support *s, int first,
                       int way, int count, int step)
{
    const double ALONG = 1e-12; /* round-off of a direction */
    double side[3] = {0}, size = 0;

    for (int k = 0; k < count; k++)
        for (int i = 0; i < 3; i++) {
            const double *x = m->space.rest + 3 * (first + k * way) + i;
            const double apart = fabs(x[0] - x[3 * step]);
            side[i] = fmax(side[i], apart), size = fmax(size, apart);
        }
    for (int i = 0; i < 3 && !s->motion.turn_count; i++)
        if (fmax(side[(i + 1) % 3], side[(i + 2) % 3]) <= ALONG * size)
            return FIX_XYZ & ~(1 << i);
    return FIX_XYZ;
}

/* Makes the clamp of the row of control points beside an edge across direction d: the
 * direction of the sheet there. *step is from the edge to the row. Returns whether the
 * support is such an edge. */
static bool clamp_slope(const struct shell *m, const struct scene_support *s, int d,
                        struct scene_support *slope)
{
    const struct bspline *b = m->space.basis;
    const int n = bspline_part(&b[d], 0).n, rows = bspline_points(&b[1]);
    double at = s->lo[1];
    const int part = d ? 0 : n * scene_sheet_at(m->scene, s->lo[0], &at),
              beside = part + (at == 0 ? 1 : n - 2), step = d ? 1 : rows;

    if (s->lo[d] != s->hi[d] || s->lo[1 - d] >= s->hi[1 - d] || (at != 0 && at != 1))
        return false;
    *slope = *s;
    slope->lo[d] = slope->hi[d] = support_knots_at(m->scene, &b[d], d, beside);
    slope->fix = held_beside(m, s, beside * step, d ? rows : 1, d ? b[0].n : rows,
                             at == 0 ? -step : step);
    return true;
}

/* Makes the scene's supports, borrowed paths and all, and after them those that hold the
 * direction of the sheet at clamped edges. */
static enum status clamp_edges(struct shell *m, struct message *why)
{
    const struct scene *scene = m->scene;
    struct scene *held = &m->held_scene;
    const size_t count = (size_t)scene->support_count;
    struct scene_support *supports;
    enum status st;

    *held = *scene;
    TRY(support_knots_hold(scene, m->space.basis, &held->supports));
    supports = realloc(held->supports, (2 * count + 1) * sizeof *supports);
    if (!supports)
        return STATUS_MEMORY;
    held->supports = supports;
    m->clamp = calloc(2 * count + 1, sizeof *m->clamp);
    if (!m->clamp)
        return STATUS_MEMORY;
    m->slopes = scene->support_count;
    for (int n = 0; n < scene->support_count; n++) {
        const struct scene_support *s = &held->supports[n];
        if (s->lo[2] > 0.5 || s->hi[2] < 0.5)
            TRY(status_fail(why, STATUS_UNSUPPORTED,
                            "support %d misses the mid-surface w = 1/2, and a shell has "
                            "nothing else to hold",
                            n));
        if (s->fix != FIX_XYZ || s->lo[2] == s->hi[2] || scene_grips(s))
            continue;
        for (int d = 0; d < 2; d++) {
            m->clamp[held->support_count] = n;
            held->support_count += clamp_slope(m, s, d, &supports[held->support_count]);
        }
    }
    m->scene = held;
out:
    return st;
}

/* Has what is free beside clamped edges begin its steps where the edge takes it: left
 * behind by an edge that moves on, a sheet would turn inside out. */
static void carry(struct shell *m)
{
    const struct bspline *b = m->space.basis;
    const int rows = bspline_points(&b[1]);
    struct supports *s = &m->supports;

    for (int n = 0; n < 4 * m->space.nodes; n++) {
        const int a = n / 4, d = n % 2, end = n / 2 % 2, count = bspline_part(&b[d], 0).n;
        const int row = d ? a % rows : a / rows % count, step = d ? 1 : rows,
                  *beside = s->free_index + 3 * a,
                  held = (beside[0] < 0) + (beside[1] < 0) + (beside[2] < 0);
        if (b[d].wrap || row != (end ? count - 2 : 1) || held != 2)
            continue;
        for (int i = 0; i < 3; i++) {
            const int u = 3 * a + i, edge = u + 3 * (end ? step : -step);
            if (s->free_index[u] >= 0 && s->free_index[edge] < 0)
                s->carrier[u] = edge;
        }
    }
}

/* Returns whether nodes a, b and c lie on a straight line at rest. */
static bool in_line(const struct shell *m, int a, int b, int c)
{
    const double ALONG = 1e-9; /* round-off of a direction */
    const double *x = m->space.rest;
    double to_b[3], to_c[3], across[3];

    vector_between(x + 3 * a, x + 3 * b, to_b);
    vector_between(x + 3 * a, x + 3 * c, to_c);
    vector_cross(to_b, to_c, across);
    return vector_length(across) <= ALONG * vector_length(to_b) * vector_length(to_c);
}

/* Finds, for each node beside a clamped edge, the edge's node next to it: beside[nodes];
 * negative: none, or two, where edges meet that leave different ways free. */
static void find_ways(const struct shell *m, const double (*uvw)[3], int *beside)
{
    enum { NONE = -1, TWO = -2 };
    const int rows = bspline_points(&m->space.basis[1]), nodes = m->space.nodes;

    for (int a = 0; a < nodes; a++)
        beside[a] = NONE;
    for (int n = m->slopes; n < m->held_scene.support_count; n++) {
        const struct scene_support *s = &m->held_scene.supports[n];
        const int d = s->lo[0] < s->hi[0], step = d ? 1 : rows,
                  count = bspline_part(&m->space.basis[d], 0).n;
        for (int a = 0; a < nodes; a++) {
            const int edge = (d ? a % rows : a / rows % count) == 1 ? a - step : a + step;
            if (beside[a] != TWO && supports_covers(s, uvw[a]))
                beside[a] =
                    beside[a] == NONE || in_line(m, a, beside[a], edge) ? edge : TWO;
        }
    }
}

/* Lets the sheet stretch across clamped edges whose row beside them is held in all. */
static enum status release(struct shell *m, const double (*uvw)[3])
{
    int *beside = malloc((size_t)m->space.nodes * sizeof *beside);
    enum status st = STATUS_MEMORY;

    if (beside) {
        find_ways(m, uvw, beside);
        st = supports_release(&m->supports, m->slopes, beside, m->space.rest);
    }
    free(beside);
    return st;
}

/* Has clamped directions follow their edges' supports, as the scene counts them. */
static void join(struct shell *m)
{
    struct supports *s = &m->supports;

    for (int h = 0; h < s->held_count; h++)
        s->owner[h] = s->owner[h] < m->slopes ? s->owner[h] : m->clamp[s->owner[h]];
    for (int n = 0; n < s->frame_count; n++)
        s->frame[n].owner = m->clamp[s->frame[n].owner];
    m->held_scene.support_count = m->slopes;
}

static enum status hold(struct shell *m, struct message *why)
{
    int nodes = m->space.nodes, rows = bspline_points(&m->space.basis[1]);
    double(*uvw)[3] = malloc((size_t)nodes * sizeof *uvw);
    enum status st = STATUS_MEMORY;

    if (!uvw)
        goto out;
    for (int a = 0; a < nodes; a++) {
        uvw[a][0] = support_knots_at(m->scene, &m->space.basis[0], 0, a / rows);
        uvw[a][1] = support_knots_at(m->scene, &m->space.basis[1], 1, a % rows);
        uvw[a][2] = 0.5;
    }
    TRY(clamp_edges(m, why));
    TRY(supports_init(&m->supports, m->scene, nodes, uvw, m->space.rest, why));
    carry(m);
    TRY(release(m, (const double(*)[3])uvw));
    join(m);
out:
    free(uvw);
    return st;
}

/* Finds the surface's point in the control points: contact_row. */
static int row(const void *motion, double u, double v, int *node, double *shape)
{
    const struct shell *m = motion;
    double T[SHELL_DERIVATIVES * SHELL_MAX_LOCAL], s;
    const int sheet = scene_sheet_at(m->scene, u, &s);

    shell_space_at(&m->space, sheet, s, v, node, T);
    memcpy(shape, T, (size_t)m->space.local * sizeof *shape);
    return m->space.local;
}

/* Does so for the control net. */
static int row_of_net(const void *motion, double u, double v, int *node, double *shape)
{
    const struct shell_space *s = &((const struct shell *)motion)->space;
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
static enum status meet(struct shell *m, const struct discretization *d)
{
    static contact_row *const rows[CONTACT_SAMPLES] = {row, row_of_net};
    const struct shell_space *space = &m->space;
    struct contact_surface surface;
    enum status st = bspline_contact_surface(m->scene, space->basis, d, m, rows,
                                             space->local, space->nodes, &surface);

    return st == STATUS_OK ? contact_init(m->march.contact, m->scene, &surface) : st;
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

static enum status make_masses(struct shell *m, const struct discretization *d,
                               struct message *why)
{
    const struct blocks *graph = &m->assembly.graph;
    const size_t pairs = (size_t)graph->start[graph->nodes];
    enum status st;

    if (!march_explicit(d) || m->supports.moving || contact_wanted(m->scene))
        return lumped_mass_make(d, graph, m->assembly.M, why);
    TRY(room_cut(&m->room, ROOM(m->beyond, pairs), ROOM(m->lumped, pairs)));
    TRY(shell_mass_beyond(&m->space, graph, &m->supports, m->assembly.M, m->lumped,
                          m->beyond));
out:
    return st;
}

static enum status build(struct shell *m, const struct discretization *d,
                         struct message *why)
{
    const struct scene *scene = m->scene;
    struct shell_material material[SCENE_MAX_SHEETS];
    enum status st;

    for (int k = 0; k < scene_sheets(scene); k++) {
        const struct scene sheet = scene_sheet(scene, k);
        material[k] = material_of(&sheet);
    }
    TRY(shell_assembly_init(&m->assembly, &m->space, scene_sheets(scene), material, why));
    TRY(hold(m, why));
    TRY(make_masses(m, d, why));
    if (!m->supports.frame_count)
        TRY(system_parity(scene, m->space.nodes, 1, &m->parity));
    m->march = (struct march){
        .body = m->assembly.body,
        .scene = m->scene,
        .graph = &m->assembly.graph,
        .M = m->lumped ? m->lumped : m->assembly.M,
        .beyond = m->beyond,
        .rest = m->space.rest,
        .measure = m->assembly.area,
        .depth = scene->thickness,
        .net = {m->space.basis[0].n, bspline_points(&m->space.basis[1]), 1},
        .supports = &m->supports,
        .parity = m->parity,
        .unknowns = "control points",
        .lag = d->viscosity == VISCOSITY_NONE ? 0 : march_lag,
    };
    TRY(march_init(&m->march, d, why));
    TRY(add_loads(m));
    TRY(press(m));
    if (m->march.contact)
        TRY(meet(m, d));
out:
    return st;
}

/* clang-format off */
static const struct schema_key options[] = {
    OPTIONS_CONTINUUM, {"knots_u"}, {"knots_v"}, {"contact"},
    {"kinematics", .only = OPTION(KINEMATICS_LINEAR) | OPTION(KINEMATICS_NONLINEAR)},
    {"remedy", .only = OPTION(REMEDY_NONE) | OPTION(REMEDY_SELECTIVE)},
    {"unknowns", .only = OPTION(UNKNOWNS_AUTO) | OPTION(UNKNOWNS_POINTS)},
    {NULL}};
/* clang-format on */

static enum status check_remedy(const struct discretization *d, struct message *why)
{
    if (d->remedy != REMEDY_NONE && (d->gauss[0] || d->gauss[1]))
        return status_fail(why, STATUS_INPUT,
                           "remedy=selective has its own rule; leave gauss out");
    return STATUS_OK;
}

/* Returns the length of the waves in which a sheet wrinkles whose gravity pushes it along
 * an edge that is clamped, or towards it [m]; INFINITY where none does. Of a plate that
 * carries the pressure p = rho h g L (g, L: of gravity, of the sheet, in its plane) the
 * fastest growing wave is 2 pi sqrt(2 D / p) long. */
static double wrinkle(const struct scene *scene, int sheet)
{
    const struct scene one = scene_sheet(scene, sheet);
    const double *axis[2] = {one.axis_u, one.axis_v};
    const double side[2] = {scene->length, scene->width};
    double g[2] = {0}, push = 0;
    bool pushed = false;

    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            g[i] += scene->gravity[k] * axis[i][k];
    for (int i = 0; i < 2; i++) {
        push += fabs(g[i]) * side[i];
        for (int end = 0; end < 2; end++)
            pushed |= scene_edge_clamped(scene, sheet, i, end) &&
                      (end ? -g[i] : g[i]) < fabs(g[1 - i]);
    }
    if (!pushed || push == 0)
        return INFINITY;
    return 2 * acos(-1) *
           sqrt(2 * scene_bending_stiffness(&one) / (one.density * one.thickness * push));
}

/* Returns whether that is shorter than SPANS of the longest spans, with a sentence. A
 * selective shell of degree 3 sees slopes once a span, where those of a wave of two spans
 * are steepest: a pressure P along the sheet bends it with twice its force, and it grows
 * with the rate^2 (2 P k^2 - D k^4) / (rho h), k = pi / span, though P k^2 < D k^4. (flag
 * about its flat equilibrium, P = 2.1 p: 176/s of 22x22 points, no such wave of 30x30;
 * found are 175 and 113, 108 in the limit. At the points of degree 2 the squares of slopes
 * have their mean.) It folds too early; one without remedy stays flat, as it locks, and is
 * off by what the sheet moves: .9 % of the length at 0.3 s. (With remedy 10x10, 16x16,
 * 22x22, 28x28, 31x31, 40x40 points are 2.0, 1.8, 1.3, 1.7, .2, .2 % off, without .7, .6,
 * .4, .5, .3, .1. Points inside the spans at the ends, or two a span, see that wave better
 * and lock: corners_patch on 10x10 is 7.7 and 8.7 % off for 1.8, edge_drop 1.7 and 2.8 for
 * .8.) A net of fewer spans a side has no room to fold. Where gravity bends the sheet a net
 * with remedy is nearer, however heavy it is: edge_drop of nu = 0 and 1, 10, 100 times its
 * Gamma on 10x10 points at 0.4 s, .5, 1.1, 1.6 and without 10, 6.4, 5.5.
 */
static bool wrinkles(const struct scene *scene, const struct discretization *d,
                     struct message *reason)
{
    enum { SPANS = 10, FEW = 4 };
    const double side[2] = {scene->length, scene->width};
    double longest = 0, length = wrinkle(scene, 0);
    int enough[2];

    for (int k = 1; k < scene->sheets; k++)
        length = fmin(length, wrinkle(scene, k));

    for (int i = 0; i < 2; i++) {
        const int spans = d->points[i] - d->degree[i];
        if (spans < FEW)
            return false;
        longest = fmax(longest, side[i] / spans);
        enough[i] = (int)fmin(ceil(SPANS * side[i] / length), 1e6) + d->degree[i];
    }
    if (!(SPANS * longest > length))
        return false;
    status_fail(reason, STATUS_OK,
                "gravity pushes the sheet along its clamped edge and wrinkles it in waves "
                "of %.2g spans of this net, where a cured shell folds too far; one of "
                "[%d,%d] points or more is cured",
                length / longest, enough[0], enough[1]);
    return true;
}

static void adapt(const struct scene *scene, struct discretization *d,
                  struct message *reason)
{
    for (int i = 0; i < 2; i++)
        if (!d->degree[i])
            d->degree[i] = bspline_open_degree(d, i, 3);
    if (d->remedy != REMEDY_AUTO)
        return;
    d->remedy = REMEDY_SELECTIVE;
    if (check_remedy(d, reason) != STATUS_OK || wrinkles(scene, d, reason))
        d->remedy = REMEDY_NONE;
}

/* Adds points for knots that repeat at supports, which make no spans. */
static int extra_points(const struct scene *scene, const struct discretization *d, int i)
{
    return i > 1 ? 0 : support_knots_repeats(scene, i, d->degree[i], SUPPORT_KNOTS_SHELL);
}

static enum status refuse(const struct scene *scene, const struct discretization *d,
                          struct message *why)
{
    enum status st = model_refuse(scene, shell_model.serves, why);

    if (st == STATUS_OK)
        st = contact_rest_refuse(scene, d, why);
    if (st != STATUS_OK)
        return st;
    if (d->points[2] > 1 || d->gauss[2])
        return status_fail(why, STATUS_INPUT,
                           "a shell has one point through the thickness: use "
                           "discretization.points=[%d,%d]",
                           d->points[0], d->points[1]);
    if (scene_needs(scene) & SCENE_NEED_SOFTENING &&
        (scene->shape != SCENE_FLAT || d->weight_count ||
         d->kinematics != KINEMATICS_NONLINEAR))
        return status_fail(why, STATUS_UNSUPPORTED,
                           "softening: with kinematics=nonlinear, on flat sheets without "
                           "weights only");
    if (scene->pressure != 0 && d->kinematics != KINEMATICS_NONLINEAR)
        return status_fail(why, STATUS_UNSUPPORTED,
                           "pressure that follows the normal: with kinematics=nonlinear "
                           "only");
    st = check_remedy(d, why);
    return st == STATUS_OK ? model_refuse_options(d, why) : st;
}

/* Makes the flat sheet: control points at Greville abscissae, parameter = coordinate. */
static void make_flat(const struct scene *scene, const struct bspline basis[2],
                      double *point)
{
    int m = basis[1].n;

    for (int a = 0; a < basis[0].n * m; a++) {
        const double uvw[3] = {support_knots_at(scene, &basis[0], 0, a / m),
                               support_knots_at(scene, &basis[1], 1, a % m), 0.5};
        scene_rest_point(scene, uvw, point + 3 * (size_t)a);
    }
}

static enum status make_space(const struct scene *scene, const struct discretization *d,
                              struct shell_space *space, struct message *why)
{
    enum status st;
    const bool curved = scene->shape != SCENE_FLAT;
    const double middle = 0.5;
    struct bspline basis[2] = {{0}};
    double *point = NULL, *weight = NULL;

    for (int i = 0; i < 2; i++)
        TRY(support_knots_basis(&basis[i], scene, d, i, SUPPORT_KNOTS_SHELL, why));
    size_t nodes = (size_t)(basis[0].n * bspline_points(&basis[1]));
    point = malloc(3 * nodes * sizeof *point);
    weight = malloc(nodes * sizeof *weight);
    if (!point || !weight)
        TRY(STATUS_MEMORY);
    if (curved)
        TRY(cloak_net(scene, &basis[0], &basis[1], 1, &middle, point, weight, why));
    else
        make_flat(scene, basis, point);
    const bool rational = curved && cloak_net_exact(&basis[1]);
    TRY(shell_space_init(space, basis, point, rational ? weight : NULL, d->gauss,
                         d->remedy == REMEDY_SELECTIVE, why));
out:
    bspline_clear(&basis[0]);
    bspline_clear(&basis[1]);
    free(point);
    free(weight);
    return st;
}

/* Evaluates the functions alive at u (i = 0) or v; returns the first. */
static int alive(const struct shell *s, int i, double at, double *value)
{
    const int sheet = i ? 0 : scene_sheet_at(s->scene, at, &at);

    return bspline_alive(&s->space.basis[i], sheet, at, 1, value);
}

static void clear(void *state)
{
    struct shell *s = state;

    march_clear(&s->march);
    supports_clear(&s->supports);
    shell_assembly_clear(&s->assembly);
    free(s->held_scene.supports);
    free(s->clamp);
    free(s->parity);
    free(s->room);
    shell_space_clear(&s->space);
}

static enum status init(void *state, const struct scene *scene,
                        const struct discretization *d, struct message *why)
{
    enum status st;
    struct shell *s = state;

    TRY(refuse(scene, d, why));
    TRY(make_space(scene, d, &s->space, why));
    s->scene = scene;
    TRY(build(s, d, why));
out:
    return st;
}

/* Computes half a thickness along the normal of two tangents. */
static void make_offset(const struct shell *s, double along[2][3], double offset[3])
{
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        offset[i] = along[0][j] * along[1][k] - along[0][k] * along[1][j];
    }
    double length =
        sqrt(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]);
    for (int i = 0; i < 3; i++)
        offset[i] *= s->scene->thickness / 2 / length;
}

/* Computes mid-surface and offset of the faces at one point; N: values and slopes. */
static void evaluate(const struct shell *s, const int first[2], const double *const N[2],
                     double middle[3], double offset[3])
{
    const struct bspline *v = &s->space.basis[1];
    int m = bspline_points(v), p = s->space.basis[0].p + 1, q = v->p + 1;
    double along[2][3] = {{0}};

    memset(middle, 0, 3 * sizeof *middle);
    for (int a = 0; a < p; a++) {
        const double *row = s->march.x + 3 * (size_t)(first[0] + a) * (size_t)m;
        double line[2][3] = {{0}}; /* value and slope along v */
        for (int b = 0; b < q; b++)
            for (int i = 0; i < 3; i++) {
                const double x = row[3 * bspline_point(v, first[1] + b) + i];
                line[0][i] += N[1][b] * x;
                line[1][i] += N[1][q + b] * x;
            }
        for (int i = 0; i < 3; i++) {
            middle[i] += N[0][a] * line[0][i];
            along[0][i] += N[0][p + a] * line[0][i];
            along[1][i] += N[0][a] * line[1][i];
        }
    }
    make_offset(s, along, offset);
}

/* Does so at parameters of a rational surface. */
static void evaluate_rational(const struct shell *s, double u, double v, double middle[3],
                              double offset[3])
{
    double T[SHELL_DERIVATIVES * SHELL_MAX_LOCAL], along[2][3] = {{0}};
    int node[SHELL_MAX_LOCAL], local = s->space.local;

    memset(middle, 0, 3 * sizeof *middle);
    shell_space_at(&s->space, 0, u, v, node, T);
    for (int a = 0; a < local; a++)
        for (int i = 0; i < 3; i++) {
            double x = s->march.x[3 * (size_t)node[a] + (size_t)i];
            middle[i] += T[a] * x;
            along[0][i] += T[local + a] * x;
            along[1][i] += T[2 * local + a] * x;
        }
    make_offset(s, along, offset);
}

/* Places a point: w = 0 and 1 lie at minus and plus half a thickness. */
static void place(const double middle[3], const double offset[3], double w, double *xyz)
{
    for (int i = 0; i < 3; i++)
        xyz[i] = middle[i] + (2 * w - 1) * offset[i];
}

static void probe(const void *state, int n, const double *uvw, double *xyz)
{
    const struct shell *s = state;

    for (int t = 0; t < n; t++, uvw += 3, xyz += 3) {
        double N[2][2 * BSPLINE_MAX_ORDER], middle[3], offset[3];
        int first[2];
        for (int i = 0; i < 2 && !s->space.weight; i++)
            first[i] = alive(s, i, uvw[i], N[i]);
        if (s->space.weight)
            evaluate_rational(s, uvw[0], uvw[1], middle, offset);
        else
            evaluate(s, first, (const double *const[2]){N[0], N[1]}, middle, offset);
        place(middle, offset, uvw[2], xyz);
    }
}

static void sample(const void *state, double *xyz)
{
    const struct shell *s = state;
    double value[2][GRID_U][2 * BSPLINE_MAX_ORDER]; /* of the lines along u and v */
    int alive_at[2][GRID_U];

    _Static_assert(GRID_U == GRID_V, "both lines have as many points");
    for (int n = 0; n < 2 * GRID_U; n++)
        alive_at[n % 2][n / 2] =
            alive(s, n % 2, n / 2 / (GRID_U - 1.0), value[n % 2][n / 2]);
    for (int n = 0; n < GRID_U * GRID_V; n++) {
        const int i = n % GRID_U, j = n / GRID_U;
        double middle[3], offset[3];
        if (s->space.weight)
            evaluate_rational(s, i / (GRID_U - 1.0), j / (GRID_V - 1.0), middle, offset);
        else
            evaluate(s, (const int[]){alive_at[0][i], alive_at[1][j]},
                     (const double *const[]){value[0][i], value[1][j]}, middle, offset);
        for (int k = 0; k < GRID_W; k++)
            place(middle, offset, k / (GRID_W - 1.0),
                  xyz + 3 * (size_t)(k * GRID_U * GRID_V + n));
    }
}

const struct model shell_model = {
    .name = "shell",
    .title = "isogeometric Kirchhoff-Love shell",
    .source =
        "Kiendl, Bletzinger, Linhard, Wuechner, Comput. Methods Appl. Mech. Engrg. 198 "
        "(2009) 3902-3914; Simo, Tarnow, ZAMP 43 (1992) 757-792",
    .serves = SCENE_NEED_CONTACT | SCENE_NEED_SELF_CONTACT | SCENE_NEED_MOVING_OBSTACLES |
              SCENE_NEED_LOADS | SCENE_NEED_MOVING_SUPPORTS | SCENE_NEED_TURNING_CLAMPS |
              SCENE_NEED_PATCH_SUPPORTS | SCENE_NEED_COMPONENT_SUPPORTS |
              SCENE_NEED_THICKNESS_SUPPORTS | SCENE_NEED_DRAG | SCENE_NEED_CURVED_REST |
              SCENE_NEED_CLOSED_REST | SCENE_NEED_INITIAL_MOTION | SCENE_NEED_SHEETS |
              SCENE_NEED_FABRIC | SCENE_NEED_BIAS | SCENE_NEED_SOFTENING |
              SCENE_NEED_PRESSURE | SCENE_NEED_AIR | SCENE_NEED_GRIPPERS |
              SCENE_NEED_OWN_MATERIALS,
    .options = options,
    /* Degree 3: seven times nearer to edge_drop's truth than degree 2 on the same net, in
     * about the same time: Newton's method takes fewer tangents. */
    .defaults = {.points = {10, 10, 1},
                 .degree = {3, 3, 1},
                 .kinematics = KINEMATICS_NONLINEAR,
                 .remedy = REMEDY_SELECTIVE},
    .adapt = adapt,
    .extra_points = extra_points,
    .bytes = sizeof(struct shell),
    .init = init,
    .advance = march_step,
    .sample = sample,
    .probe = probe,
    .size = march_size,
    .describe = march_describe,
    .energy = march_energy,
    .contact = march_contact,
    .forces = march_forces,
    .equilibrium = march_equilibrium,
    .modes = march_modes,
    .matrices = march_matrices,
    .clear = clear,
};

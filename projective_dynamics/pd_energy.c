#include "projective_dynamics/pd_energy.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/net/spring_form.h"
#include "models/net/spring_law.h"
#include "models/net/spring_net.h"
#include "models/net/spring_plate.h"
#include "models/room.h"
#include "models/vector.h"

const char *const pd_energy_constraints[] = {[CONSTRAINT_AUTO] = "auto",
                                             [CONSTRAINT_TRIANGLES] = "triangles",
                                             [CONSTRAINT_EDGES] = "edges",
                                             NULL};

static const double PAPER_STRETCH = 10, PAPER_BEND = 10, PAPER_MASS = 1;

/* --- bending and clamps as quadratic rows of second differences ----------------------
 */

/* The list to which rows are added. */
struct row_list {
    const struct mesh *mesh;  /*                                             borrowed */
    const struct pd_net *net; /*                                             borrowed */
    struct pd_row *rows;      /* room for ROWS a node                        borrowed */
    int count;
};

/* The most rows of a node: a twist, and two curvatures or four clamps. */
enum { ROWS = 5 };

static struct pd_row *add_row(struct row_list *b, double weight)
{
    struct pd_row *row = &b->rows[b->count++];

    *row = (struct pd_row){.weight = weight};
    return row;
}

static void add_term(struct pd_row *row, int node, double coefficient)
{
    row->coefficient[spring_form_slot(&row->count, row->node, node)] += coefficient;
}

/* Adds the second difference along the line through k, whose nodes are `by` apart. */
static void add_second(struct pd_row *row, int k, int by, double factor)
{
    add_term(row, k - by, factor);
    add_term(row, k, -2 * factor);
    add_term(row, k + by, factor);
}

static void add_twist(struct row_list *b, int k, double weight)
{
    const struct pd_net *net = b->net;
    double c = 1 / (net->du * net->dv);
    struct pd_row *row = add_row(b, weight);

    add_term(row, k, c);
    add_term(row, k + 1, -c);
    add_term(row, k + net->m, -c);
    add_term(row, k + net->m + 1, c);
}

/* The lines of a node, along u and v, on which it has neighbours before and behind. */
struct lines {
    bool u, v;
};

static struct lines inside(const struct pd_net *net, int k)
{
    int i = k / net->m % net->rows, j = k % net->m;

    return (struct lines){i > 0 && i<net->rows - 1, j> 0 && j < net->m - 1};
}

/* Returns whether a clamped node k is on a clamped line along u, along v (area: both). */
static struct lines on_line(const struct row_list *b, int k)
{
    const struct pd_net *net = b->net;
    const bool *clamped = b->mesh->clamped;
    int i = k / net->m % net->rows, j = k % net->m, m = net->m;

    if (!clamped[k])
        return (struct lines){false, false};
    return (struct lines){(i > 0 && clamped[k - m]) ||
                              (i < net->rows - 1 && clamped[k + m]),
                          (j > 0 && clamped[k - 1]) || (j < net->m - 1 && clamped[k + 1])};
}

/* Bending stiffness along u and v, their geometric mean D, nu = B12 / D and the fourth
 * root of their ratio. */
struct plate {
    double along[2], D, nu, r;
};

static struct plate plate_of(const struct law *law)
{
    const double *B = law->matrix[LAW_BENDING];

    return (struct plate){{B[LAW_11], B[LAW_22]},
                          sqrt(B[LAW_11] * B[LAW_22]),
                          law_cross(law),
                          sqrt(sqrt(B[LAW_11] / B[LAW_22]))};
}

/* Curvatures at one node: with a = r k_uu, b = k_vv / r the energy is D times
 *   a^2 + b^2 + 2 nu a b = (1+nu)/2 (a + b)^2 + (1-nu)/2 (a - b)^2.
 * On a free edge b = -nu a, which leaves (1 - nu^2) a^2. */
static void add_curvatures(struct row_list *b, int k, const struct plate *p)
{
    const struct pd_net *net = b->net;
    struct lines has = inside(net, k);
    double cu = 1 / (net->du * net->du), cv = 1 / (net->dv * net->dv), nu = p->nu;

    if (has.u && has.v) {
        for (int sign = -1; sign <= 1; sign += 2) {
            struct pd_row *row = add_row(b, b->mesh->area[k] * p->D * (1 + sign * nu) / 2);
            add_second(row, k, net->m, p->r * cu);
            add_second(row, k, 1, sign * cv / p->r);
        }
    } else if (has.u) {
        add_second(add_row(b, b->mesh->area[k] * p->along[0] * (1 - nu * nu)), k, net->m,
                   cu);
    } else if (has.v) {
        add_second(add_row(b, b->mesh->area[k] * p->along[1] * (1 - nu * nu)), k, 1, cv);
    }
}

/* Adds the slope from k to k + by, `length` apart, towards `direction`. */
static void add_clamp(struct row_list *b, int k, int by, double length,
                      const double direction[3], double sign, double weight)
{
    double c = 2 / (length * length);
    struct pd_row *row = add_row(b, weight);

    add_term(row, k + by, c);
    add_term(row, k, -c);
    for (int i = 0; i < 3; i++)
        row->target[i] = c * length * sign * direction[i];
}

/* Adds half a cell of curvature between the clamped node k and its free neighbours across
 * the clamped lines that it is on: two in an area. */
static void add_clamps(struct row_list *b, const struct scene *scene, int k,
                       const double D[2])
{
    const struct pd_net *net = b->net;
    const struct lines has = inside(net, k), line = on_line(b, k);
    const struct scene_pose *pose = &scene->pose[k / net->m / net->rows];
    const int place[2] = {k / net->m % net->rows, k % net->m},
              points[2] = {net->rows, net->m}, by[2] = {net->m, 1};
    const bool across[2] = {line.v, line.u}, inner[2] = {has.u, has.v};
    const double length[2] = {net->du, net->dv};

    for (int along = 0; along < 2; along++)
        for (int s = -1; across[along] && s <= 1; s += 2) {
            const int to = place[along] + s, step = s * by[along];
            if (to >= 0 && to < points[along] && !b->mesh->clamped[k + step])
                add_clamp(b, k, step, length[along], along ? pose->axis_v : pose->axis_u, s,
                          D[along] * b->mesh->area[k] / (1 + inner[along]));
        }
}

/* Adds the plate's energy with the scene's D and nu, and clamps. */
static void add_plate(struct row_list *b, const struct scene *scene)
{
    const struct pd_net *net = b->net;
    const struct law law = scene_law(scene);
    const struct plate p = plate_of(&law);
    const double *B = law.matrix[LAW_BENDING];
    const double twist = law.isotropic ? 1 - p.nu : 2 * B[LAW_33] / p.D;

    for (int k = 0; k < net->nodes; k++) {
        struct lines line = on_line(b, k);
        if (line.u || line.v)
            add_clamps(b, scene, k, p.along);
        else
            add_curvatures(b, k, &p);
        if (pd_net_has(net, PD_EDGE_FALLING, k))
            add_twist(b, k, net->du * net->dv * 2 * twist * p.D);
    }
}

/* Adds weight/2 area |x_uu + x_vv|^2 at every node; along the rim the term that exists. */
static void add_mean_curvature(struct row_list *b, double weight)
{
    const struct pd_net *net = b->net;

    for (int k = 0; k < net->nodes; k++) {
        struct lines has = inside(net, k);
        if (!has.u && !has.v)
            continue;
        struct pd_row *row = add_row(b, b->mesh->area[k] * weight);
        if (has.u)
            add_second(row, k, net->m, 1 / (net->du * net->du));
        if (has.v)
            add_second(row, k, 1, 1 / (net->dv * net->dv));
    }
}

/* Adds the forms of a mesh that is no grid. */
static enum status add_forms(struct pd_energy *e, const struct scene *scene)
{
    struct spring_forms forms;
    enum status st = spring_plate_make(scene, e->mesh, PARAMETERS_MATCHED, &forms);

    for (int n = 0; st == STATUS_OK && n < forms.count; n++) {
        const struct spring_form *form = spring_form_of(&forms, n);
        struct pd_row *row = &e->rows[e->row_count++];
        *row = (struct pd_row){.weight = form->stiffness};
        for (int k = 0; k < form->count; k++)
            add_term(row, forms.place[n].at + form->step[k], form->weight[k]);
    }
    spring_forms_clear(&forms);
    return st;
}

/* --- stretch -------------------------------------------------------------------------
 */

static void add_link(struct pd_energy *e, enum pd_edge kind, int k, double weight)
{
    int to[2];

    pd_net_ends(&e->net, kind, to);
    e->links[e->link_count++] =
        (struct pd_link){k + to[0], k + to[1], kind * pd_net_stride(&e->net) + k, weight,
                         pd_net_length(&e->net, kind)};
}

/* Adds a mesh's triangles; an edge's weight is what both beside it couple its ends by. */
static void add_triangles(struct pd_energy *e, double larger)
{
    const struct mesh *mesh = e->mesh;

    for (; e->link_count < mesh->edges; e->link_count++)
        e->links[e->link_count] = (struct pd_link){mesh->edge[e->link_count].node[0],
                                                   mesh->edge[e->link_count].node[1]};
    for (int n = 0; n < mesh->flat.triangles; n++) {
        const struct mesh_plane p = mesh_plane_of(mesh, n);
        struct pd_triangle *t = &e->triangles[e->triangle_count++];
        memcpy(t->node, mesh->flat.triangle[n], sizeof t->node);
        t->size = 2 * p.area / (e->net.du * e->net.dv);
        for (int j = 0; j < 3; j++)
            for (int d = 0; d < 2; d++)
                t->rise[j][d] = -p.out[j][d] * p.length[j] / (2 * p.area);
        for (int j = 0; j < 3; j++) {
            const double *g = t->rise[(j + 1) % 3], *h = t->rise[(j + 2) % 3];
            e->links[mesh->side[n][j]].weight -=
                t->size * larger * (g[0] * h[0] + g[1] * h[1]);
        }
    }
}

/* Sets the energy of plane stress per area, E h / 2(1-nu^2) [(1-nu) |e|^2 + nu tr(e)^2], e
 * the strain. With |e|^2 = (s1-s2)^2/2 + (s1+s2-2)^2/2 for small strains that is
 *   E h/(1+nu) (s1-s2)^2/4 + E h/(1-nu) (s1+s2-2)^2/4.
 * The matrix needs no more than the larger weight: to second order the two distances lie in
 * orthogonal parts of F. */
static void set_triangles(struct pd_energy *e, const struct scene *scene,
                          enum parameters parameters)
{
    const struct pd_net *net = &e->net;
    const struct law law = scene_law(scene);
    double stiffness = law.young * law.thickness, area = net->du * net->dv / 2;

    e->deviator = area * stiffness / (1 + law.poisson);
    e->trace = area * stiffness / (1 - law.poisson);
    if (parameters == PARAMETERS_PAPER)
        e->deviator = e->trace = area * PAPER_STRETCH * PAPER_STRETCH;
    double larger = fmax(e->deviator, e->trace);
    if (!net->rows)
        add_triangles(e, larger);
    for (int c = PD_EDGE_U; net->rows && c <= PD_EDGE_V; c++)
        for (int k = 0; k < net->nodes; k++) {
            const int i = k / net->m % net->rows, j = k % net->m;
            const int beside =
                c == PD_EDGE_U ? (j > 0) + (j < net->m - 1) : (i > 0) + (i < net->rows - 1);
            const double length = c == PD_EDGE_U ? net->du : net->dv;
            if (pd_net_has(net, (enum pd_edge)c, k))
                add_link(e, (enum pd_edge)c, k, larger * beside / (length * length));
        }
}

/* Adds the springs of a mesh that is no grid. */
static enum status add_springs(struct pd_energy *e, const struct scene *scene)
{
    struct spring_net springs;
    enum status st;

    TRY(spring_net_init(&springs, scene, e->mesh, PARAMETERS_MATCHED, false));
    for (; e->link_count < springs.spring_count; e->link_count++) {
        const struct spring *s = &springs.springs[e->link_count];
        e->links[e->link_count] = (struct pd_link){s->a, s->b, 0, s->stiffness, s->length};
    }
    spring_net_clear(&springs);
out:
    return st;
}

static void set_edges(struct pd_energy *e, const struct scene *scene,
                      enum parameters parameters)
{
    static const enum spring_direction direction[PD_EDGES] = {
        SPRING_U, SPRING_V, SPRING_DIAGONAL, SPRING_DIAGONAL};
    const struct pd_net *net = &e->net;
    const bool paper = parameters == PARAMETERS_PAPER;
    struct spring_law law;

    spring_law_make(scene, parameters, (double[]){net->du, net->dv}, &law);
    for (int c = 0; c < PD_EDGES; c++)
        for (int k = 0; k < net->nodes; k++) {
            int i = k / net->m % net->rows, j = k % net->m;
            bool rim = (c == PD_EDGE_U && (j == 0 || j == net->m - 1)) ||
                       (c == PD_EDGE_V && (i == 0 || i == net->rows - 1));
            if (!pd_net_has(net, (enum pd_edge)c, k))
                continue;
            add_link(
                e, (enum pd_edge)c, k,
                (paper ? PAPER_STRETCH * PAPER_STRETCH / pd_net_length(net, (enum pd_edge)c)
                       : law.stiffness[direction[c]]) *
                    (rim ? law.rim : 1));
        }
}

static void set_mass(struct pd_energy *e, const struct scene *scene,
                     enum parameters parameters)
{
    e->areal = parameters == PARAMETERS_PAPER ? PAPER_MASS / (scene->length * scene->width)
                                              : scene->density * scene->thickness;
    for (int k = 0; k < e->net.nodes; k++)
        e->mass[k] = e->areal * e->mesh->area[k];
}

static void set_rest(struct pd_energy *e)
{
    for (int n = 0; n < 3 * e->net.nodes; n++)
        e->rest[n % 3 * pd_net_stride(&e->net) + n / 3] = e->mesh->rest[n];
}

static enum status allocate(struct pd_energy *e)
{
    const bool grid = e->net.rows;

    e->fields = e->mass = pd_net_fields(&e->net, 4);
    e->rows = malloc((size_t)ROWS * (size_t)e->net.nodes * sizeof *e->rows);
    if (!e->fields || !e->rows)
        return STATUS_MEMORY;
    e->rest = e->fields + pd_net_stride(&e->net);
    return room_cut(&e->room,
                    ROOM(e->links, grid ? PD_EDGES * e->net.nodes : e->mesh->edges),
                    ROOM(e->triangles, e->mesh->flat.triangles));
}

void pd_energy_clear(struct pd_energy *e)
{
    pd_net_free_fields(&e->net, e->fields);
    free(e->rows);
    free(e->room);
    memset(e, 0, sizeof *e);
}

enum status pd_energy_init(struct pd_energy *e, const struct scene *scene,
                           const struct mesh *mesh, enum constraint constraint,
                           enum parameters parameters)
{
    enum status st;
    struct pd_energy new = {.mesh = mesh, .constraint = constraint};

    pd_net_init(&new.net, mesh);
    TRY(allocate(&new));
    set_mass(&new, scene, parameters);
    set_rest(&new);
    if (constraint == CONSTRAINT_TRIANGLES)
        set_triangles(&new, scene, parameters);
    else if (mesh->rows)
        set_edges(&new, scene, parameters);
    else
        TRY(add_springs(&new, scene));
    struct row_list bending = {mesh, &new.net, new.rows, 0};
    if (!mesh->rows)
        TRY(add_forms(&new, scene));
    else if (parameters == PARAMETERS_PAPER)
        add_mean_curvature(&bending, PAPER_BEND);
    else
        add_plate(&bending, scene);
    new.row_count += bending.count;
    new.rest_value = mesh->flat.start ? 0 : pd_energy_value(&new, new.rest);
    HAND_OVER(e, new);
out:
    pd_energy_clear(&new);
    return st;
}

/* --- value ------------------------------------------------------------------------------
 */

static void difference(const struct pd_energy *e, const double *x, int from, int to,
                       double scale, double d[3])
{
    for (int c = 0; c < 3; c++, x += pd_net_stride(&e->net))
        d[c] = (x[to] - x[from]) * scale;
}

static double edge_energy(const struct pd_energy *e, const double *x)
{
    double sum = 0;

    for (const struct pd_link *l = e->links; l < e->links + e->link_count; l++) {
        double d[3];
        difference(e, x, l->a, l->b, 1, d);
        const double off = sqrt(vector_dot(d, d)) - l->length;
        sum += l->weight * off * off / 2;
    }
    return sum;
}

void pd_energy_strain(const struct pd_energy *e, const struct pd_triangle *t,
                      const double *x, double F[2][3])
{
    for (int c = 0; c < 3; c++, x += pd_net_stride(&e->net))
        for (int d = 0; d < 2; d++)
            F[d][c] = t->rise[0][d] * x[t->node[0]] + t->rise[1][d] * x[t->node[1]] +
                      t->rise[2][d] * x[t->node[2]];
}

/* Returns the energy of a triangle of half a cell with tangents u and v. */
static double strain_energy(const struct pd_energy *e, const double u[3], const double v[3])
{
    const double a = vector_dot(u, u), b = vector_dot(v, v), c = vector_dot(u, v);
    const double area = sqrt(fmax(a * b - c * c, 0));
    const double trace = sqrt(a + b + 2 * area) - 2, deviator2 = fmax(a + b - 2 * area, 0);

    return (e->deviator * deviator2 + e->trace * trace * trace) / 4;
}

static double triangle_energy(const struct pd_energy *e, const double *x)
{
    const struct pd_net *net = &e->net;
    double sum = 0;

    for (const struct pd_triangle *t = e->triangles; t < e->triangles + e->triangle_count;
         t++) {
        double F[2][3];
        pd_energy_strain(e, t, x, F);
        sum += t->size * strain_energy(e, F[0], F[1]);
    }
    for (int t = 0; net->rows && t < 2 * net->nodes; t++) {
        int k = t / 2, second = t % 2;
        double u[3], v[3];
        if (!pd_net_has(net, PD_EDGE_FALLING, k))
            continue;
        difference(e, x, k + second, k + net->m + second, 1 / net->du, u);
        difference(e, x, k + second * net->m, k + 1 + second * net->m, 1 / net->dv, v);
        sum += strain_energy(e, u, v);
    }
    return sum;
}

static double row_energy(const struct pd_energy *e, const double *x)
{
    double sum = 0;

    for (int r = 0; r < e->row_count; r++) {
        const struct pd_row *row = &e->rows[r];
        for (int c = 0; c < 3; c++) {
            double off = -row->target[c];
            for (int s = 0; s < row->count; s++)
                off += row->coefficient[s] * x[c * pd_net_stride(&e->net) + row->node[s]];
            sum += row->weight * off * off / 2;
        }
    }
    return sum;
}

double pd_energy_value(const struct pd_energy *e, const double *x)
{
    double stretch =
        e->constraint == CONSTRAINT_EDGES ? edge_energy(e, x) : triangle_energy(e, x);

    return fmax(stretch + row_energy(e, x) - e->rest_value, 0);
}

#include "vertex_block/vb_body.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/clones.h"
#include "models/room.h"
#include "models/vector.h"
#include "triangles/tri_hinge.h"

/* Fewer points of a colour than these are not worth a second thread. */
enum { ALONE = 400 };

/* --- what is built -----------------------------------------------------------------------
 */

/* Turns counts at [a + 1] into starts at [a]. */
static void start_lists(int nodes, int *from)
{
    for (int a = 0; a < nodes; a++)
        from[a + 1] += from[a];
}

static void count_elements(struct vb_body *b, const struct vb_parts *parts)
{
    const struct tri_net *net = parts->net;
    const struct spring_net *springs = parts->springs;
    const struct mesh_flat *flat = &parts->mesh->flat;

    for (int k = 0; !springs && net && k < net->triangle_count; k++)
        for (int c = 0; c < 3; c++)
            b->corners_from[net->triangles[k].node[c] + 1]++;
    for (int t = 0; !springs && !net && t < flat->triangles; t++)
        for (int c = 0; c < 3; c++)
            b->corners_from[flat->triangle[t][c] + 1]++;
    for (int k = 0; springs && k < springs->spring_count; k++) {
        b->springs_from[springs->springs[k].a + 1]++;
        b->springs_from[springs->springs[k].b + 1]++;
    }
    for (int a = 0; a < b->nodes; a++)
        for (long n = parts->graph->start[a]; n < parts->graph->start[a + 1]; n++) {
            if (parts->plate[n] == 0)
                continue;
            b->plates_from[a + 1]++;
            b->plates_from[parts->graph->node[n] + 1] += parts->graph->node[n] != a;
        }
    for (int k = 0; net && k < net->hinge_count; k++)
        for (int c = 0; c < 4; c++)
            b->hinges_from[net->hinges[k].node[c] + 1]++;
    start_lists(b->nodes, b->corners_from);
    start_lists(b->nodes, b->springs_from);
    start_lists(b->nodes, b->plates_from);
    start_lists(b->nodes, b->hinges_from);
}

/* Lists a triangle at its corners. */
static void list_corner(struct vb_body *b, struct vb_corner *corner, int *next)
{
    for (int c = 0; c < 3; c++) {
        for (int d = 0; d < 2; d++) /* of the ends of e_d and of e_(1-d) */
            corner->share[d] = c == 0       ? -corner->side[d] - corner->skew[d]
                               : c == 1 + d ? corner->side[d]
                                            : corner->skew[d];
        b->corner[next[corner->node[c]]++] = *corner;
    }
}

static void list_corners(struct vb_body *b, const struct vb_parts *parts, int *next)
{
    const struct mesh *mesh = parts->mesh;
    const double *cell = mesh->cell;

    for (int k = 0; parts->net && k < parts->net->triangle_count; k++) {
        const struct tri_triangle *t = &parts->net->triangles[k];
        struct vb_corner corner = {.area = cell[0] * cell[1] / 2,
                                   .side = {t->side[0] / cell[0], t->side[1] / cell[1]}};
        memcpy(corner.node, t->node, sizeof corner.node);
        list_corner(b, &corner, next);
    }
    for (int t = 0; !parts->net && t < mesh->flat.triangles; t++) {
        const int *v = mesh->flat.triangle[t];
        const double *x = mesh_flat_place(&mesh->flat, t, 0),
                     *y = mesh_flat_place(&mesh->flat, t, 1),
                     *z = mesh_flat_place(&mesh->flat, t, 2);
        const double e[2] = {y[0] - x[0], y[1] - x[1]}, f[2] = {z[0] - x[0], z[1] - x[1]};
        const double twice = e[0] * f[1] - e[1] * f[0];
        struct vb_corner corner = {.area = twice / 2,
                                   .side = {f[1] / twice, e[0] / twice},
                                   .skew = {-e[1] / twice, -f[0] / twice}};
        memcpy(corner.node, v, sizeof corner.node);
        list_corner(b, &corner, next);
    }
}

static void list_springs(struct vb_body *b, const struct spring_net *net, int *next)
{
    for (const struct spring *s = net->springs; s < net->springs + net->spring_count; s++) {
        b->spring[next[s->a]++] = (struct vb_spring){s->b, s->stiffness, s->length};
        b->spring[next[s->b]++] = (struct vb_spring){s->a, s->stiffness, s->length};
    }
}

/* Lists the plate's matrix by rows, and what its clamps pull at rest. */
static void list_plate(struct vb_body *b, const struct vb_parts *parts, int *next)
{
    const struct blocks *g = parts->graph;

    for (int a = 0; a < b->nodes; a++)
        for (long n = g->start[a]; n < g->start[a + 1]; n++) {
            const int other = g->node[n];
            if (parts->plate[n] == 0)
                continue;
            b->plate[next[a]++] = (struct vb_plate){other, parts->plate[n]};
            if (other != a)
                b->plate[next[other]++] = (struct vb_plate){a, parts->plate[n]};
        }
    for (int k = 0; k < parts->forms->count; k++) {
        const struct spring_form *f = spring_form_of(parts->forms, k);
        spring_form_pull(parts->forms, k, f->stiffness, f->shift, b->pull);
    }
}

static void list_hinges(struct vb_body *b, const struct tri_net *net, int *next)
{
    for (const struct tri_hinge *h = net->hinges; h < net->hinges + net->hinge_count; h++)
        for (int c = 0; c < 4; c++)
            b->hinge[next[h->node[c]]++] = (struct vb_hinge){h, c};
}

/* Marks, in used[colour] = a, the colours of what shares an element with node a. */
static void mark_colours(const struct vb_body *b, int a, const int *colour, int *used)
{
    for (int k = b->corners_from[a]; k < b->corners_from[a + 1]; k++)
        for (int c = 0; c < 3; c++)
            used[colour[b->corner[k].node[c]]] = a;
    for (int k = b->springs_from[a]; k < b->springs_from[a + 1]; k++)
        used[colour[b->spring[k].other]] = a;
    for (int k = b->plates_from[a]; k < b->plates_from[a + 1]; k++)
        used[colour[b->plate[k].other]] = a;
    for (int k = b->hinges_from[a]; k < b->hinges_from[a + 1]; k++)
        for (int c = 0; c < 4; c++)
            used[colour[b->hinge[k].hinge->node[c]]] = a;
}

/* Gives each node the first colour that no neighbour has; sorts the nodes by colour. */
static enum status colour_nodes(struct vb_body *b)
{
    int *colour = malloc((size_t)b->nodes * sizeof *colour);
    int *used = malloc(((size_t)b->nodes + 1) * sizeof *used);

    if (colour && used) {
        for (int a = 0; a < b->nodes; a++)
            colour[a] = b->nodes, used[a] = -1; /* none yet */
        for (int a = 0; a < b->nodes; a++) {
            int c = 0;
            mark_colours(b, a, colour, used);
            while (used[c] == a)
                c++;
            colour[a] = c;
            b->colours_from[c + 1]++;
            b->colours = c + 1 > b->colours ? c + 1 : b->colours;
        }
        start_lists(b->colours, b->colours_from);
        memcpy(used, b->colours_from, (size_t)b->colours * sizeof *used);
        for (int a = 0; a < b->nodes; a++)
            b->order[used[colour[a]]++] = a;
    }
    const bool good = colour && used;
    free(colour);
    free(used);
    return good ? STATUS_OK : STATUS_MEMORY;
}

static enum status list_elements(struct vb_body *b, const struct vb_parts *parts)
{
    const size_t bytes = (size_t)b->nodes * sizeof(int);
    int *next = malloc(bytes + 1);

    if (!next)
        return STATUS_MEMORY;
    memcpy(next, b->corners_from, bytes);
    if (b->corners_from[b->nodes])
        list_corners(b, parts, next);
    memcpy(next, b->springs_from, bytes);
    if (b->springs_from[b->nodes])
        list_springs(b, parts->springs, next);
    memcpy(next, b->plates_from, bytes);
    list_plate(b, parts, next);
    memcpy(next, b->hinges_from, bytes);
    if (parts->net)
        list_hinges(b, parts->net, next);
    free(next);
    return STATUS_OK;
}

void vb_body_clear(struct vb_body *b)
{
    free(b->room);
    memset(b, 0, sizeof *b);
}

enum status vb_body_init(struct vb_body *b, const struct vb_parts *parts)
{
    enum status st;
    const struct tri_net *net = parts->net;
    const struct spring_net *springs = parts->springs;
    const size_t nodes = (size_t)parts->mesh->nodes;
    const int triangles = net ? net->triangle_count : parts->mesh->flat.triangles;

    *b = (struct vb_body){.nodes = parts->mesh->nodes};
    for (int j = 0; j < 3; j++) {
        double e[3] = {0}, stress[3];
        e[j] = 1;
        law_stress(parts->D, e, stress);
        for (int i = 0; i < 3; i++)
            b->D[i][j] = stress[i];
    }
    TRY(room_cut(&b->room, ROOM(b->corners_from, nodes + 1),
                 ROOM(b->springs_from, nodes + 1), ROOM(b->plates_from, nodes + 1),
                 ROOM(b->hinges_from, nodes + 1),
                 ROOM(b->corner, springs ? 0 : 3 * triangles),
                 ROOM(b->spring, springs ? 2 * springs->spring_count : 0),
                 ROOM(b->plate, 2 * parts->graph->start[nodes]),
                 ROOM(b->hinge, net ? 4 * net->hinge_count : 0), ROOM(b->pull, 3 * nodes),
                 ROOM(b->order, nodes), ROOM(b->colours_from, nodes + 1)));
    count_elements(b, parts);
    TRY(list_elements(b, parts));
    TRY(colour_nodes(b));
out:
    return st;
}

/* --- force and block of a point ----------------------------------------------------------
 */

/* The force against a point's motion, and its block's entries xx, xy, xz, yy, yz, zz. */
struct vb_local {
    double g[3], H[6];
};

static inline void add_square(double k, const double a[3], double H[6])
{
    H[0] += k * a[0] * a[0], H[1] += k * a[0] * a[1], H[2] += k * a[0] * a[2];
    H[3] += k * a[1] * a[1], H[4] += k * a[1] * a[2], H[5] += k * a[2] * a[2];
}

static inline void add_identity(double k, double H[6])
{
    H[0] += k, H[3] += k, H[5] += k;
}

static inline void add_corner(const struct vb_body *b, const struct vb_corner *c,
                              const double *x, struct vb_local *l)
{
    const double *x0 = x + 3 * c->node[0], *x1 = x + 3 * c->node[1],
                 *x2 = x + 3 * c->node[2], wu = c->share[0], wv = c->share[1];
    double U[3], V[3], G[3][3], S[3], DG[3][3];

    for (int i = 0; i < 3; i++) {
        const double e = x1[i] - x0[i], f = x2[i] - x0[i];
        U[i] = c->side[0] * e + c->skew[0] * f, V[i] = c->side[1] * f + c->skew[1] * e;
        G[0][i] = wu * U[i], G[1][i] = wv * V[i], G[2][i] = wu * V[i] + wv * U[i];
    }
    const double e[3] = {(vector_dot(U, U) - 1) / 2, (vector_dot(V, V) - 1) / 2,
                         vector_dot(U, V)};
    for (int k = 0; k < 3; k++) {
        S[k] = c->area * (b->D[k][0] * e[0] + b->D[k][1] * e[1] + b->D[k][2] * e[2]);
        for (int i = 0; i < 3; i++)
            DG[k][i] = c->area *
                       (b->D[k][0] * G[0][i] + b->D[k][1] * G[1][i] + b->D[k][2] * G[2][i]);
    }
    for (int i = 0, n = 0; i < 3; i++) {
        l->g[i] += S[0] * G[0][i] + S[1] * G[1][i] + S[2] * G[2][i];
        for (int j = i; j < 3; j++, n++)
            l->H[n] += G[0][i] * DG[0][j] + G[1][i] * DG[1][j] + G[2][i] * DG[2][j];
    }
    const double tension = S[0] * wu * wu + S[1] * wv * wv + 2 * S[2] * wu * wv;
    add_identity(fmax(tension, 0), l->H);
}

static inline void add_spring(const struct vb_spring *s, const double *x, int a,
                              struct vb_local *l)
{
    double way[3];

    vector_between(x + 3 * s->other, x + 3 * a, way);
    const double length = vector_length(way),
                 pull = s->stiffness * (1 - s->length / length);
    if (!(length > 0))
        return;
    for (int i = 0; i < 3; i++)
        l->g[i] += pull * way[i];
    add_identity(fmax(pull, 0), l->H);
    add_square((s->stiffness - fmax(pull, 0)) / (length * length), way, l->H);
}

static inline void add_hinge(const struct vb_hinge *h, const double *x, struct vb_local *l)
{
    double at[4][3], gradient[12];
    const double *g = gradient + 3 * h->corner, k = h->hinge->stiffness;

    for (int c = 0; c < 4; c++)
        memcpy(at[c], x + 3 * h->hinge->node[c], sizeof at[c]);
    tri_hinge_gradient(at, gradient);
    const double angle = tri_hinge_angle(at);
    for (int i = 0; i < 3; i++)
        l->g[i] += k * angle * g[i];
    add_square(k, g, l->H);
}

static inline struct vb_local local_at(const struct vb_body *b, const struct vb_step *s,
                                       const double *x, int a)
{
    const double mass = s->inertia[a];
    struct vb_local l = {.H = {mass, 0, 0, mass, 0, mass}};

    for (int i = 0; i < 3; i++)
        l.g[i] = mass * (x[3 * a + i] - s->target[3 * a + i]) + b->pull[3 * a + i];
    for (int k = b->plates_from[a]; k < b->plates_from[a + 1]; k++) {
        const struct vb_plate *p = &b->plate[k];
        for (int i = 0; i < 3; i++)
            l.g[i] += p->stiffness * x[3 * p->other + i];
        if (p->other == a)
            add_identity(p->stiffness, l.H);
    }
    for (int k = b->corners_from[a]; k < b->corners_from[a + 1]; k++)
        add_corner(b, &b->corner[k], x, &l);
    for (int k = b->springs_from[a]; k < b->springs_from[a + 1]; k++)
        add_spring(&b->spring[k], x, a, &l);
    for (int k = b->hinges_from[a]; k < b->hinges_from[a + 1]; k++)
        add_hinge(&b->hinge[k], x, &l);
    return l;
}

/* Holds components: their equations become 1 d = 0. */
static void hold(const int place[3], struct vb_local *l)
{
    static const int entry[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

    for (int i = 0; i < 3; i++) {
        if (place[i] >= 0)
            continue;
        for (int j = 0; j < 3; j++)
            l->H[entry[i][j]] = 0;
        l->H[entry[i][i]] = 1;
        l->g[i] = 0;
    }
}

/* Solves H d = g by elimination, d in g; H is positive definite. */
static inline void solve(const double H[6], double g[3])
{
    const double a = 1 / H[0], l1 = H[1] * a, l2 = H[2] * a;
    const double b = 1 / (H[3] - l1 * H[1]), m = H[4] - l1 * H[2], l3 = m * b;
    const double c = 1 / (H[5] - l2 * H[2] - l3 * m);

    g[1] -= l1 * g[0];
    g[2] = (g[2] - l2 * g[0] - l3 * g[1]) * c;
    g[1] = g[1] * b - l3 * g[2];
    g[0] = g[0] * a - l1 * g[1] - l2 * g[2];
}

CLONES
static void sweep_nodes(const struct vb_body *b, const struct vb_step *s, double *x,
                        int from, int end)
{
    for (int n = from; n < end; n++) {
        const int a = b->order[n], *place = s->place + 3 * a;
        if (place[0] < 0 && place[1] < 0 && place[2] < 0)
            continue;
        struct vb_local l = local_at(b, s, x, a);
        if (place[0] < 0 || place[1] < 0 || place[2] < 0)
            hold(place, &l);
        solve(l.H, l.g);
        for (int i = 0; i < 3; i++)
            x[3 * a + i] -= l.g[i];
    }
}

void vb_body_sweep(const struct vb_body *b, const struct vb_step *s, double *x)
{
    enum { PARTS = 8 };

    for (int c = 0; c < b->colours; c++) {
        const int from = b->colours_from[c], count = b->colours_from[c + 1] - from;
        if (count <= ALONE) {
            sweep_nodes(b, s, x, from, from + count);
            continue;
        }
#pragma omp parallel for schedule(static)
        for (int k = 0; k < PARTS; k++)
            sweep_nodes(b, s, x, from + (int)((long)count * k / PARTS),
                        from + (int)((long)count * (k + 1) / PARTS));
    }
}

void vb_body_force(const struct vb_body *b, const struct vb_step *s, const double *x,
                   double *force)
{
    for (int a = 0; a < b->nodes; a++) {
        const struct vb_local l = local_at(b, s, x, a);
        memcpy(force + 3 * a, l.g, sizeof l.g);
    }
}

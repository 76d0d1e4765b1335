#include "models/net/spring_net.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/vector.h"

/* The lines of a net, with the step (in i, in j) to the next node. */
static const struct line {
    enum spring_direction direction;
    int di, dj;
} LINES[] = {
    {SPRING_U, 1, 0}, {SPRING_V, 0, 1}, {SPRING_DIAGONAL, 1, 1}, {SPRING_DIAGONAL, 1, -1}};

enum { LINE_COUNT = sizeof LINES / sizeof *LINES };

/* Returns the node `count` steps along the line from (i, j), -1 beyond the rim. */
static int along(const struct spring_net *net, int i, int j, const struct line *line,
                 int count)
{
    return mesh_beside(net->mesh, i, j, count * line->di, count * line->dj);
}

/* Tells whether the line is on the rim, where it belongs to one row of cells only. */
static bool on_rim(const struct spring_net *net, int i, int j, const struct line *line)
{
    return (line->direction == SPRING_U && mesh_on_rim(net->mesh, i, j, 0)) ||
           (line->direction == SPRING_V && mesh_on_rim(net->mesh, i, j, 1));
}

static void add_springs(struct spring_net *net, int i, int j)
{
    int a = i * net->mesh->points[1] + j;
    double e[3];

    for (int n = 0; n < LINE_COUNT; n++) {
        const struct line *line = &LINES[n];
        int b = along(net, i, j, line, 1);
        double k = net->law.stiffness[line->direction] *
                   (on_rim(net, i, j, line) ? net->law.rim : 1);
        if (b < 0 || k == 0)
            continue;
        vector_between(net->mesh->rest + 3 * (size_t)a, net->mesh->rest + 3 * (size_t)b, e);
        net->springs[net->spring_count++] =
            (struct spring){.a = a, .b = b, .stiffness = k, .length = vector_length(e)};
    }
}

static void add_clamp(struct spring_net *net, int a, int b, double strut)
{
    struct clamp clamp = {.a = a, .b = b, .strut = 2 * strut};

    if (b < 0 || net->mesh->clamped[b] || strut == 0)
        return;
    vector_between(net->mesh->rest + 3 * a, net->mesh->rest + 3 * b, clamp.edge);
    net->clamps[net->clamp_count++] = clamp;
}

static void add_hinges(struct spring_net *net, int i, int j)
{
    int b = i * net->mesh->points[1] + j;

    for (int n = 0; n < LINE_COUNT; n++) {
        const struct line *line = &LINES[n];
        int a = along(net, i, j, line, -1), c = along(net, i, j, line, 1);
        bool rim = on_rim(net, i, j, line);
        double whole = net->law.strut[line->direction];
        double strut = rim ? net->law.rim_strut[line->direction] : whole;
        if (net->mesh->clamped[b]) {
            add_clamp(net, b, a, rim ? net->law.rim * whole : whole);
            add_clamp(net, b, c, rim ? net->law.rim * whole : whole);
        } else if (a >= 0 && c >= 0 && strut > 0) {
            net->hinges[net->hinge_count++] =
                (struct hinge){.a = a, .b = b, .c = c, .strut = strut};
        }
    }
}

/* Adds the graph's elements at a node: every two and every three in line. */
static int *add_lines(const struct spring_net *net, int i, int j, int *next)
{
    int b = i * net->mesh->points[1] + j;

    for (int n = 0; n < LINE_COUNT; n++) {
        int a = along(net, i, j, &LINES[n], -1), c = along(net, i, j, &LINES[n], 1);
        if (c < 0)
            continue;
        next[0] = a < 0 ? b : a, next[1] = b, next[2] = c;
        next += 3;
    }
    return next;
}

/* Makes the graph of springs and hinges; `whole`: of all lines, also those without any. */
static enum status make_graph(struct spring_net *net, bool whole)
{
    size_t elements = (size_t)net->spring_count + (size_t)net->hinge_count +
                      (whole ? LINE_COUNT * (size_t)net->mesh->nodes : 0);
    int *ien = malloc((3 * elements + 1) * sizeof *ien), *next = ien;
    enum status st = STATUS_MEMORY;

    if (!ien)
        goto out;
    for (int n = 0; n < net->spring_count; n++, next += 3) {
        const struct spring *s = &net->springs[n];
        next[0] = s->a, next[1] = next[2] = s->b;
    }
    for (int n = 0; n < net->hinge_count; n++, next += 3) {
        const struct hinge *h = &net->hinges[n];
        next[0] = h->a, next[1] = h->b, next[2] = h->c;
    }
    for (int a = 0; whole && a < net->mesh->nodes; a++)
        next = add_lines(net, a / net->mesh->points[1], a % net->mesh->points[1], next);
    TRY(blocks_init(&net->graph, net->mesh->nodes, (int)((next - ien) / 3), 3, ien));
out:
    free(ien);
    return st;
}

/* --- on a mesh --------------------------------------------------------------------------
 */

static double beside_triangle(const struct scene *scene)
{
    return sqrt(3) / 4 * scene->young * scene->thickness;
}

static void add_edges(struct spring_net *net, const struct scene *scene)
{
    const struct mesh *mesh = net->mesh;
    double e[3];

    for (const struct mesh_edge *at = mesh->edge; at < mesh->edge + mesh->edges; at++) {
        const int p = at->node[0], q = at->node[1];
        vector_between(mesh->rest + 3 * (size_t)p, mesh->rest + 3 * (size_t)q, e);
        const double length = mesh->flat.start
                                  ? mesh_edge_length(mesh, (int)(at - mesh->edge))
                                  : vector_length(e);
        net->springs[net->spring_count++] =
            (struct spring){.a = p < q ? p : q,
                            .b = p < q ? q : p,
                            .stiffness = beside_triangle(scene) * (at->node[3] < 0 ? 1 : 2),
                            .length = length};
    }
}

/* Makes the graph of triangles, and of the slopes at their sides. */
static enum status make_graph_of_mesh(struct spring_net *net)
{
    const struct mesh *mesh = net->mesh;
    const int most = mesh->nodes > mesh->vertices ? 6 : 3, count = mesh->flat.triangles;
    int *ien = malloc((size_t)(count * most) * sizeof *ien);
    enum status st = STATUS_MEMORY;

    for (int n = 0; ien && n < count * most; n++)
        ien[n] = n % most < 3 ? mesh->flat.triangle[n / most][n % most]
                              : mesh->vertices + mesh->side[n / most][n % most - 3];
    if (ien)
        st = blocks_init(&net->graph, mesh->nodes, count, most, ien);
    free(ien);
    return st;
}

void spring_net_even(const struct mesh *mesh, const struct scene *scene,
                     double even[LAW_ENTRIES])
{
    const double each = beside_triangle(scene) / (mesh->size[0] * mesh->size[1]);

    memset(even, 0, LAW_ENTRIES * sizeof *even);
    for (int t = 0; t < mesh->flat.triangles; t++) {
        const struct mesh_plane p = mesh_plane_of(mesh, t);
        for (int i = 0; i < 3; i++) {
            const double *d = p.along[i], l = p.length[i];
            const double row[3] = {d[0] * d[0], d[1] * d[1], d[0] * d[1]};
            for (int j = 0, entry = 0; j < 3; j++)
                for (int k = j; k < 3; k++)
                    even[entry++] += each * l * l * row[j] * row[k];
        }
    }
}

void spring_net_tell_mesh(const struct mesh *mesh, const struct scene *scene,
                          struct message *line)
{
    const struct law law = scene_law(scene);
    const double *sheet = law.matrix[LAW_MEMBRANE];
    double even[LAW_ENTRIES];

    spring_net_even(mesh, scene, even);
    message_add(
        line,
        "; springs that stretch evenly have %.2g of the sheet's stiffness against "
        "tension along u with free sides, %.2g against shear, and %.2g where u and v "
        "are stretched alike",
        law_narrow(even) / law_narrow(sheet), even[LAW_33] / sheet[LAW_33],
        (even[LAW_11] + 2 * even[LAW_12] + even[LAW_22]) /
            (sheet[LAW_11] + 2 * sheet[LAW_12] + sheet[LAW_22]));
}

void spring_net_tell(const struct spring_net *net, const struct scene *scene,
                     struct message *line)
{
    const struct mesh *mesh = net->mesh;

    if (mesh->rows) {
        spring_law_tell(&net->law, mesh->cell, scene, line);
        return;
    }
    status_fail(line, STATUS_OK, "%d points, %d edges", mesh->vertices, mesh->edges);
    spring_net_tell_mesh(mesh, scene, line);
}

static void find_pairs(struct spring_net *net)
{
    const struct blocks *g = &net->graph;

    for (int n = 0; n < net->spring_count; n++) {
        struct spring *s = &net->springs[n];
        s->aa = g->start[s->a], s->bb = g->start[s->b];
        s->ab = blocks_find(g, s->a, s->b);
    }
    for (int n = 0; n < net->hinge_count; n++) {
        struct hinge *h = &net->hinges[n];
        h->aa = g->start[h->a], h->bb = g->start[h->b], h->cc = g->start[h->c];
        h->ab = blocks_find(g, h->a, h->b);
        h->bc = blocks_find(g, h->b, h->c);
        h->ac = blocks_find(g, h->a, h->c);
    }
    for (int n = 0; n < net->clamp_count; n++)
        net->clamps[n].bb = g->start[net->clamps[n].b];
}

/* Allocates the clamps, of which most nets have few. */
static enum status allocate_clamps(struct spring_net *net)
{
    size_t count = 1;

    for (int a = 0; a < net->mesh->nodes; a++)
        count += 2 * LINE_COUNT * net->mesh->clamped[a];
    net->clamps = malloc(count * sizeof *net->clamps);
    return net->clamps ? STATUS_OK : STATUS_MEMORY;
}

void spring_net_clear(struct spring_net *net)
{
    blocks_clear(&net->graph);
    free(net->room);
    free(net->clamps);
    memset(net, 0, sizeof *net);
}

enum status spring_net_init(struct spring_net *net, const struct scene *scene,
                            const struct mesh *mesh, enum parameters parameters, bool whole)
{
    enum status st;
    const int m = mesh->points[1];
    struct spring_net new = {.mesh = mesh};

    TRY(room_cut(&new.room, ROOM(new.springs, LINE_COUNT * mesh->nodes),
                 ROOM(new.hinges, LINE_COUNT * mesh->nodes)));
    spring_law_make(scene, parameters, mesh->cell, &new.law);
    if (!mesh->rows)
        add_edges(&new, scene);
    TRY(allocate_clamps(&new));
    for (int a = 0; mesh->rows && a < mesh->nodes; a++) {
        add_springs(&new, a / m, a % m);
        add_hinges(&new, a / m, a % m);
    }
    TRY(mesh->rows ? make_graph(&new, whole) : make_graph_of_mesh(&new));
    find_pairs(&new);
    HAND_OVER(net, new);
out:
    spring_net_clear(&new);
    return st;
}

double spring_net_energy(const struct spring_net *net, const double *x)
{
    double sum = 0, e[3];

    for (const struct spring *s = net->springs; s < net->springs + net->spring_count; s++) {
        vector_between(x + 3 * (size_t)s->a, x + 3 * (size_t)s->b, e);
        const double more = vector_length(e) - s->length;
        sum += s->stiffness * more * more / 2;
    }
    return sum;
}

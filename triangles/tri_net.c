#include "triangles/tri_net.h"

#include <stdlib.h>
#include <string.h>

#include "models/room.h"

static int node_of(const struct tri_net *net, int i, int j)
{
    return i * net->points.points[1] + j;
}

/* Returns whether four diagonals meet at the node: even i + j in its sheet. */
static bool is_hub(const struct tri_net *net, int node)
{
    int m = net->points.points[1];

    return (node / m % net->points.rows + node % m) % 2 == 0;
}

/* Adds the two triangles of a cell: right angles at its points that are no hubs. */
static void add_triangles(struct tri_net *net, int i, int j)
{
    for (int k = 0; k < 4; k++) {
        int di = k / 2, dj = k % 2, root = node_of(net, i + di, j + dj);
        if (is_hub(net, root))
            continue;
        net->triangles[net->triangle_count++] = (struct tri_triangle){
            .node = {root, node_of(net, i + !di, j + dj), node_of(net, i + di, j + !dj)},
            .side = {di ? -1 : 1, dj ? -1 : 1}};
    }
}

static void add_hinge(struct tri_net *net, int a, int b, int c, int d, double stiffness)
{
    net->hinges[net->hinge_count++] =
        (struct tri_hinge){.node = {a, b, c, d}, .stiffness = stiffness};
}

/* Adds the edge from (i, j) along u or v, if it lies between two cells, as seen with right
 * angles at either end. Where those are clamped, the clamp bends instead. */
static void add_edge(struct tri_net *net, double D, int i, int j, int along)
{
    const struct spring_net *p = &net->points;
    int across = 1 - along;
    int end[2] = {node_of(net, i, j), node_of(net, i + !along, j + along)};
    int step = along ? p->points[1] : 1;

    if (spring_net_on_rim(p, i, j, along))
        return;
    for (int k = 0; k < 2; k++) {
        int before = end[k] - step, behind = end[k] + step;
        double weight = spring_form_beside(p, before, behind);
        if (!p->clamped[end[k]])
            add_hinge(net, end[k], end[!k], before, behind,
                      weight * D / 2 * p->cell[along] / p->cell[across]);
    }
}

static void add_diagonals(struct tri_net *net, double D, int i, int j)
{
    const double *a = net->points.cell;
    double k = D * a[0] * a[1] / (a[0] * a[0] + a[1] * a[1]);
    const int p = node_of(net, i, j), q = node_of(net, i + 1, j + 1);
    const int r = node_of(net, i + 1, j), s = node_of(net, i, j + 1);

    add_hinge(net, p, q, r, s, k);
    add_hinge(net, r, s, p, q, k);
}

/* Fills triangles and hinges, strip by strip. */
static void fill(struct tri_net *net, double D)
{
    int n = net->points.points[0], m = net->points.points[1];

    for (int i = 0; i < n; i++) {
        net->triangle_at[i] = net->triangle_count;
        net->hinge_at[i] = net->hinge_count;
        const bool last = i % net->points.rows == net->points.rows - 1; /* of its sheet */
        for (int j = 0; !last && j < m; j++) {
            if (j + 1 < m)
                add_triangles(net, i, j);
            if (D > 0 && j + 1 < m)
                add_diagonals(net, D, i, j);
            if (D > 0)
                add_edge(net, D, i, j, 0);
            if (D > 0 && j + 1 < m)
                add_edge(net, D, i + 1, j, 1);
        }
    }
    net->triangle_at[n] = net->triangle_count;
    net->hinge_at[n] = net->hinge_count;
}

/* Lists `most` nodes of an element, the last one repeated; steps are from `at`. */
static void list(int **next, int most, int count, int at, const int *step)
{
    for (int k = 0; k < most; k++)
        *(*next)++ = at + step[k < count ? k : count - 1];
}

static void list_forms(int **next, int most, const struct spring_forms *forms)
{
    for (int k = 0; k < forms->count; k++)
        list(next, most, spring_form_of(forms, k)->count, forms->place[k].at,
             spring_form_of(forms, k)->step);
}

/* Returns the most points of a form, or `most`. */
static int largest(const struct spring_forms *forms, int most)
{
    for (int k = 0; k < forms->forms; k++)
        most = forms->form[k].count > most ? forms->form[k].count : most;
    return most;
}

static enum status make_graph(struct tri_net *net)
{
    enum status st = STATUS_MEMORY;
    const int elements =
        net->triangle_count + net->hinge_count + net->forms.count + net->soft.forms.count;
    const int most = largest(&net->soft.forms, largest(&net->forms, 4));
    int *ien, *next;

    ien = next = malloc(((size_t)elements * (size_t)most + 1) * sizeof *ien);
    if (!ien)
        goto out;
    for (int k = 0; k < net->triangle_count; k++)
        list(&next, most, 3, 0, net->triangles[k].node);
    for (int k = 0; k < net->hinge_count; k++)
        list(&next, most, 4, 0, net->hinges[k].node);
    list_forms(&next, most, &net->forms);
    list_forms(&next, most, &net->soft.forms);
    TRY(blocks_init(&net->graph, net->points.nodes, elements, most, ien));
out:
    free(ien);
    return st;
}

static long pair_of(const struct blocks *g, int a, int b)
{
    return a < b ? blocks_find(g, a, b) : blocks_find(g, b, a);
}

/* Finds the pairs (p, q >= p) of node[count]. */
static void find_pairs(const struct blocks *g, int count, const int *node, long *pair)
{
    for (int p = 0; p < count; p++)
        for (int q = p; q < count; q++)
            *pair++ = pair_of(g, node[p], node[q]);
}

static void set_plate(struct tri_net *net)
{
    for (int k = 0; k < net->forms.count; k++) {
        const struct spring_form *f = spring_form_of(&net->forms, k);
        const int at = net->forms.place[k].at;
        for (int p = 0; p < f->count; p++)
            for (int q = 0; q < f->count; q++)
                if (f->step[p] <= f->step[q])
                    net->plate[pair_of(&net->graph, at + f->step[p], at + f->step[q])] +=
                        f->stiffness * f->weight[p] * f->weight[q];
    }
}

void tri_net_clear(struct tri_net *net)
{
    blocks_clear(&net->graph);
    spring_net_clear(&net->points);
    spring_forms_clear(&net->forms);
    spring_soft_clear(&net->soft);
    free(net->plate);
    free(net->room);
    memset(net, 0, sizeof *net);
}

enum status tri_net_init(struct tri_net *net, const struct scene *scene,
                         const int points[2], enum bending bending)
{
    enum status st;
    struct tri_net new = {0};
    size_t n, m = (size_t)points[1];
    bool hinges = bending == BENDING_HINGE;

    TRY(spring_net_init(&new.points, scene, points, PARAMETERS_MATCHED, false));
    n = (size_t) new.points.points[0];
    TRY(room_cut(&new.room, ROOM(new.triangles, 2 * n * m),
                 ROOM(new.hinges, hinges ? 6 * n * m : 0), ROOM(new.triangle_at, n + 1),
                 ROOM(new.hinge_at, n + 1)));
    fill(&new, hinges ? scene_bending_stiffness(scene) : 0);
    TRY(spring_plate_make(scene, &new.points, &new.forms));
    TRY(spring_forms_sort(&new.forms, &new.points,
                          hinges ? 1u << SPRING_PLATE_CLAMP : ~0u));
    TRY(spring_soft_init(&new.soft, scene, &new.points));
    TRY(make_graph(&new));
    for (int k = 0; k < new.triangle_count; k++)
        find_pairs(&new.graph, 3, new.triangles[k].node, new.triangles[k].pair);
    for (int k = 0; k < new.hinge_count; k++)
        find_pairs(&new.graph, 4, new.hinges[k].node, new.hinges[k].pair);
    new.plate = calloc((size_t) new.graph.start[new.points.nodes], sizeof *new.plate);
    if (!new.plate)
        TRY(STATUS_MEMORY);
    set_plate(&new);
    HAND_OVER(net, new);
out:
    tri_net_clear(&new);
    return st;
}

void tri_net_add(int count, const int *node, const long *pair, const double *B,
                 double (*K)[9])
{
    for (int p = 0; p < count; p++)
        for (int q = p; q < count; q++, pair++)
            for (int t = 0; t < 9; t++) {
                int i = t / 3, j = t % 3;
                int at = node[p] <= node[q] ? (3 * p + i) * 3 * count + 3 * q + j
                                            : (3 * p + j) * 3 * count + 3 * q + i;
                K[*pair][t] += B[at];
            }
}

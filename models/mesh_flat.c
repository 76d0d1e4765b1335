#include "models/mesh_flat.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void mesh_flat_clear(struct mesh_flat *flat)
{
    free(flat->at);
    free(flat->triangle);
    free(flat->corner);
    free(flat->start);
    memset(flat, 0, sizeof *flat);
}

enum status mesh_flat_make(struct mesh_flat *flat, int nodes, int triangles)
{
    *flat =
        (struct mesh_flat){.at = calloc((size_t)nodes, sizeof *flat->at),
                           .triangle = calloc((size_t)triangles, sizeof *flat->triangle)};
    if (flat->at && flat->triangle)
        return STATUS_OK;
    mesh_flat_clear(flat);
    return STATUS_MEMORY;
}

enum status mesh_flat_raise(struct mesh_flat *flat)
{
    flat->corner = calloc((size_t)flat->triangles, sizeof *flat->corner);
    flat->start = calloc((size_t)flat->nodes, sizeof *flat->start);
    return flat->corner && flat->start ? STATUS_OK : STATUS_MEMORY;
}

/* --- edges ------------------------------------------------------------------------------
 */

/* A triangle's side, by its lower end. */
struct half {
    int low, high, triangle, corner;
};

static int compare(const void *a, const void *b)
{
    const struct half *p = a, *q = b;

    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    if (p->high != q->high)
        return p->high < q->high ? -1 : 1;
    return p->triangle < q->triangle ? -1 : p->triangle > q->triangle;
}

static void list_halves(const struct mesh_flat *flat, struct half *half)
{
    for (int t = 0; t < flat->triangles; t++)
        for (int c = 0; c < 3; c++) {
            const int a = flat->triangle[t][(c + 1) % 3],
                      b = flat->triangle[t][(c + 2) % 3];
            half[3 * t + c] = (struct half){a < b ? a : b, a < b ? b : a, t, c};
        }
    qsort(half, 3 * (size_t)flat->triangles, sizeof *half, compare);
}

enum status mesh_flat_edges(const struct mesh_flat *flat, struct mesh_edge **edge,
                            int *count, int (**side)[3])
{
    const size_t halves = 3 * (size_t)flat->triangles;
    struct half *half = malloc((halves + 1) * sizeof *half);
    enum status st = STATUS_OK;

    *count = 0;
    *edge = malloc((halves + 1) * sizeof **edge);
    if (side)
        *side = malloc(((size_t)flat->triangles + 1) * sizeof **side);
    if (!half || !*edge || (side && !*side))
        TRY(STATUS_MEMORY);
    list_halves(flat, half);
    for (size_t n = 0, meet = 0; n < halves; n++) {
        const struct half *h = &half[n];
        const int *node = flat->triangle[h->triangle];
        meet = n && h->low == h[-1].low && h->high == h[-1].high ? meet + 1 : 0;
        if (meet > 1) {
            *count = h->triangle;
            TRY(STATUS_INPUT);
        }
        struct mesh_edge *e = meet ? &(*edge)[*count - 1] : &(*edge)[(*count)++];
        if (meet == 0)
            *e = (struct mesh_edge){
                {node[(h->corner + 1) % 3], node[(h->corner + 2) % 3], node[h->corner], -1},
                {h->triangle, -1}};
        else
            e->node[3] = node[h->corner], e->triangle[1] = h->triangle;
        if (side)
            (*side)[h->triangle][h->corner] = *count - 1;
    }
out:
    free(half);
    if (st != STATUS_OK) {
        free(*edge);
        *edge = NULL;
        if (side)
            free(*side), *side = NULL;
    }
    return st;
}

int mesh_flat_rim(const struct mesh_flat *flat, const struct mesh_edge *edge, int edges,
                  int *next)
{
    memset(next, -1, (size_t)flat->nodes * sizeof *next);
    for (const struct mesh_edge *e = edge; e < edge + edges; e++) {
        if (e->node[3] >= 0)
            continue;
        if (next[e->node[0]] >= 0)
            return e->triangle[0];
        next[e->node[0]] = e->node[1];
    }
    return -1;
}

void mesh_flat_pieces(const struct mesh_flat *flat, int *piece)
{
    bool changed = true;

    for (int a = 0; a < flat->nodes; a++)
        piece[a] = a;
    while (changed) {
        changed = false;
        for (int n = 0; n < 3 * flat->triangles; n++) {
            const int *v = flat->triangle[n / 3];
            int *own = &piece[v[n % 3]], other = piece[v[(n + 1) % 3]];
            changed |= *own != other;
            *own = other < *own ? other : *own;
            piece[v[(n + 1) % 3]] = *own;
        }
    }
}

/* --- grids ------------------------------------------------------------------------------
 */

enum status mesh_flat_grid(struct mesh_flat *flat, const double size[2],
                           const int points[2], bool alternate)
{
    const int n = points[0], m = points[1];
    enum status st = mesh_flat_make(flat, n * m, 2 * (n - 1) * (m - 1));

    if (st != STATUS_OK)
        return st;
    flat->nodes = n * m;
    for (int a = 0; a < n * m; a++) {
        flat->at[a][0] = (double)(a / m) / (n - 1) * size[0];
        flat->at[a][1] = (double)(a % m) / (m - 1) * size[1];
    }
    for (int a = 0; a < (n - 1) * m; a++) {
        const int p = a, q = a + m, r = a + m + 1, s = a + 1;
        const bool falls = alternate && (a / m + a % m) % 2;
        const int cut[2][3] = {{p, q, falls ? s : r}, {falls ? q : p, r, s}};
        if (a % m == m - 1)
            continue;
        memcpy(flat->triangle[flat->triangles], cut, sizeof cut);
        flat->triangles += 2;
    }
    return STATUS_OK;
}

/* --- turned edges -----------------------------------------------------------------------
 */

enum { SWEEPS = 64 };

/* Shares of the squared lengths below which four points lie on a circle. */
static const double ROUND = 1e-10;

double mesh_flat_random(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;

    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) / (double)(1ull << 52) - 1;
}

double mesh_flat_area2(const struct mesh_flat *flat, int a, int b, int c)
{
    return mesh_flat_left(flat->at[a], flat->at[b], flat->at[c]);
}

double mesh_flat_weigh(const struct mesh_flat *flat, int triangle, const double p[2],
                       double weight[3])
{
    const double *a = mesh_flat_place(flat, triangle, 0),
                 *b = mesh_flat_place(flat, triangle, 1),
                 *c = mesh_flat_place(flat, triangle, 2);
    const double whole = mesh_flat_left(a, b, c);

    weight[0] = mesh_flat_left(p, b, c) / whole;
    weight[1] = mesh_flat_left(a, p, c) / whole;
    weight[2] = 1 - weight[0] - weight[1];
    return fmin(weight[0], fmin(weight[1], weight[2]));
}

/* Returns minus the cosine-like measure that is positive where the angles across from an
 * edge a b, at c and d, are more than 180 degrees together: d lies in c's circle. */
static double excess(const struct mesh_flat *flat, const int node[4])
{
    const double *a = flat->at[node[0]], *b = flat->at[node[1]];
    double dot[2], cross[2];

    for (int k = 0; k < 2; k++) {
        const double *c = flat->at[node[2 + k]];
        const double p[2] = {a[0] - c[0], a[1] - c[1]}, q[2] = {b[0] - c[0], b[1] - c[1]};
        dot[k] = p[0] * q[0] + p[1] * q[1];
        cross[k] = fabs(p[0] * q[1] - p[1] * q[0]);
    }
    return -(dot[0] * cross[1] + dot[1] * cross[0]);
}

/* Replaces one of an edge's triangles and the point across in it. */
static void replace(struct mesh_edge *e, int triangle, int with, int across)
{
    const int k = e->triangle[0] == triangle ? 0 : 1;

    e->triangle[k] = with, e->node[2 + k] = across;
}

void mesh_flat_turn(struct mesh_flat *flat, struct mesh_edge *edge, int (*side)[3], int k)
{
    struct mesh_edge *e = &edge[k];
    const int a = e->node[0], b = e->node[1], c = e->node[2], d = e->node[3];
    const int s = e->triangle[0], t = e->triangle[1];
    const int bc = side[s][mesh_flat_corner(flat->triangle[s], a)];
    const int ca = side[s][mesh_flat_corner(flat->triangle[s], b)];
    const int db = side[t][mesh_flat_corner(flat->triangle[t], a)];
    const int ad = side[t][mesh_flat_corner(flat->triangle[t], b)];

    replace(&edge[ca], s, s, d);
    replace(&edge[ad], t, s, c);
    replace(&edge[bc], s, t, d);
    replace(&edge[db], t, t, c);
    memcpy(flat->triangle[s], (int[3]){d, c, a}, sizeof *flat->triangle);
    memcpy(side[s], (int[3]){ca, ad, k}, sizeof *side);
    memcpy(flat->triangle[t], (int[3]){c, d, b}, sizeof *flat->triangle);
    memcpy(side[t], (int[3]){db, bc, k}, sizeof *side);
    *e = (struct mesh_edge){{d, c, a, b}, {s, t}};
}

bool mesh_flat_turns(const struct mesh_flat *flat, const struct mesh_edge *edge,
                     double scale)
{
    const int *node = edge->node;

    return node[3] >= 0 && excess(flat, node) > ROUND * scale &&
           mesh_flat_area2(flat, node[3], node[2], node[0]) > 0 &&
           mesh_flat_area2(flat, node[2], node[3], node[1]) > 0;
}

void mesh_flat_improve(struct mesh_flat *flat, struct mesh_edge *edge, int edges,
                       int (*side)[3], double scale)
{
    bool turned = true;

    for (int sweep = 0; turned && sweep < SWEEPS; sweep++) {
        turned = false;
        for (int k = 0; k < edges; k++) {
            if (!mesh_flat_turns(flat, &edge[k], scale))
                continue;
            mesh_flat_turn(flat, edge, side, k);
            turned = true;
        }
    }
}

bool mesh_flat_good(const struct mesh_flat *flat, double least)
{
    for (int t = 0; t < flat->triangles; t++) {
        const int *node = flat->triangle[t];
        if (!(mesh_flat_area2(flat, node[0], node[1], node[2]) > least))
            return false;
    }
    return true;
}

/* --- refinement -------------------------------------------------------------------------
 */

static void halve(const double *a, const double *b, int count, double *middle)
{
    for (int i = 0; i < count; i++)
        middle[i] = (a[i] + b[i]) / 2;
}

/* Places the corners of a triangle's four parts, in the order of mesh_flat_refine, and the
 * new nodes where they begin. */
static void raise_fine(const struct mesh_flat *flat, const int (*side)[3], int t,
                       struct mesh_flat *fine)
{
    /* A part's corners: the triangle's own, or 3 and the number of a side's middle. */
    static const int part[4][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}, {3, 4, 5}};
    double place[6][2];

    memcpy(place, flat->corner[t], sizeof flat->corner[t]);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3, *v = flat->triangle[t];
        halve(place[j], place[k], 2, place[3 + i]);
        halve(flat->start[v[j]], flat->start[v[k]], 3,
              fine->start[flat->nodes + side[t][i]]);
    }
    for (int n = 0; n < 12; n++)
        memcpy(fine->corner[4 * t + n / 3][n % 3], place[part[n / 3][n % 3]],
               sizeof *place);
}

enum status mesh_flat_refine(struct mesh_flat *flat)
{
    struct mesh_flat fine = {0};
    struct mesh_edge *edge = NULL;
    int edges, (*side)[3] = NULL;
    enum status st;

    TRY(mesh_flat_edges(flat, &edge, &edges, &side));
    TRY(mesh_flat_make(&fine, flat->nodes + edges, 4 * flat->triangles));
    fine.nodes = flat->nodes + edges, fine.triangles = 4 * flat->triangles;
    memcpy(fine.at, flat->at, (size_t)flat->nodes * sizeof *fine.at);
    if (flat->start) {
        TRY(mesh_flat_raise(&fine));
        memcpy(fine.start, flat->start, (size_t)flat->nodes * sizeof *fine.start);
    }
    for (int t = 0; t < flat->triangles; t++) {
        const int *v = flat->triangle[t], n = flat->nodes;
        const int p = n + side[t][0], q = n + side[t][1], r = n + side[t][2];
        const int four[4][3] = {{v[0], r, q}, {r, v[1], p}, {q, p, v[2]}, {p, q, r}};
        memcpy(fine.triangle[4 * t], four, sizeof four);
        for (int i = 0; i < 3; i++) /* of a seam its first triangle's */
            if (edge[side[t][i]].triangle[0] == t)
                halve(mesh_flat_place(flat, t, (i + 1) % 3),
                      mesh_flat_place(flat, t, (i + 2) % 3), 2, fine.at[n + side[t][i]]);
        if (flat->start)
            raise_fine(flat, (const int(*)[3])side, t, &fine);
    }
    mesh_flat_clear(flat);
    HAND_OVER(flat, fine);
out:
    free(edge);
    free(side);
    mesh_flat_clear(&fine);
    return st;
}

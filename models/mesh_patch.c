#include "models/mesh_patch.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"

/* A border that turns to the other side by an angle of this sine is still straight. */
static const double STRAIGHT = 1e-9;

void mesh_patches_clear(struct mesh_patches *p)
{
    free(p->room);
    free(p->near);
    memset(p, 0, sizeof *p);
}

/* --- order ------------------------------------------------------------------------------
 */

/* A spot is the middle of a triangle, which is sorted by one of its coordinates, `key`. */
struct spot {
    double at[3], key;
    int triangle;
};

static int compare(const void *a, const void *b)
{
    const struct spot *p = a, *q = b;

    return p->key != q->key ? (p->key < q->key ? -1 : 1)
                            : (p->triangle > q->triangle) - (p->triangle < q->triangle);
}

/* Sorts triangles so that each box holds a part that is cut off straight across its longer
 * side. */
static void bisect(struct spot *spot, int count)
{
    double low[3] = {INFINITY, INFINITY, INFINITY};
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    int half = 1, longest = 0;

    if (count < 2)
        return;
    for (int n = 0; n < count; n++)
        for (int d = 0; d < 3; d++) {
            low[d] = fmin(low[d], spot[n].at[d]);
            high[d] = fmax(high[d], spot[n].at[d]);
        }
    for (int d = 1; d < 3; d++)
        longest = high[d] - low[d] > high[longest] - low[longest] ? d : longest;
    for (int n = 0; n < count; n++)
        spot[n].key = spot[n].at[longest];
    qsort(spot, (size_t)count, sizeof *spot, compare);
    while (2 * half < count)
        half *= 2;
    bisect(spot, half);
    bisect(spot + half, count - half);
}

static enum status find_order(const struct mesh_cells *mesh, int *order)
{
    struct spot *spot = calloc((size_t)mesh->count, sizeof *spot);

    if (!spot)
        return STATUS_MEMORY;
    for (int n = 0; n < mesh->count; n++) {
        spot[n].triangle = n;
        for (int k = 0; k < 9; k++) {
            const int corner = mesh->corner[n][k / 3];
            spot[n].at[k % 3] += mesh->start ? mesh->start[corner][k % 3]
                                 : k % 3 < 2 ? mesh->at[corner][k % 3]
                                             : 0;
        }
    }
    bisect(spot, mesh->count);
    for (int n = 0; n < mesh->count; n++)
        order[n] = spot[n].triangle;
    free(spot);
    return STATUS_OK;
}

/* --- patches ----------------------------------------------------------------------------
 */

/* Patches are made from these, with room for borders in them. */
struct work {
    struct mesh_patches *p;
    const struct mesh_cells *mesh;
    int levels, boxes[32]; /* of levels                                                 */
    int *border;           /* [edges] those of the border that meet a patch             */
    int *before;           /* [points] 1 + that which ends there; 0: none              */
};

/* Returns a rectangle with its longer side added all around. */
static void widen(const double part[4], double wide[4])
{
    const double side = fmax(part[2] - part[0], part[3] - part[1]);

    for (int k = 0; k < 4; k++)
        wide[k] = part[k] + (k < 2 ? -side : side);
}

static void include(double part[4], const double low[2], const double high[2])
{
    for (int d = 0; d < 2; d++) {
        part[d] = fmin(part[d], low[d]);
        part[2 + d] = fmax(part[2 + d], high[d]);
    }
}

static void fit_parts(const struct work *w)
{
    struct mesh_patches *p = w->p;

    for (int l = 1; l < w->levels; l++)
        for (int n = 0; n < w->boxes[l]; n++) {
            double *part = p->part[p->start[l] + n];
            part[0] = part[1] = INFINITY, part[2] = part[3] = -INFINITY;
            for (int k = 2 * n; k < 2 * n + 2 && k < w->boxes[l - 1]; k++)
                for (int c = 0; c < (l == 1 ? 3 : 1); c++) {
                    const double *own = l == 1
                                            ? w->mesh->at[w->mesh->corner[p->order[k]][c]]
                                            : p->part[p->start[l - 1] + k];
                    include(part, own, l == 1 ? own : own + 2);
                }
        }
}

static enum status keep(struct mesh_patches *p, int box)
{
    if (p->count == p->most) {
        const int most = 2 * p->most + 1024;
        int *near = realloc(p->near, (size_t)most * sizeof *near);
        if (!near)
            return STATUS_MEMORY;
        p->near = near, p->most = most;
    }
    p->near[p->count++] = box;
    return STATUS_OK;
}

/* Lists the boxes that meet a box's patch: of those in the patch of the box around it. */
static enum status list_near(const struct work *w, int l, int n)
{
    struct mesh_patches *p = w->p;
    const int self = p->start[l] + n,
              above = l + 1 < w->levels ? p->start[l + 1] + n / 2 : -1;
    enum status st = STATUS_OK;
    double wide[4];

    widen(p->part[self], wide);
    p->first[self] = p->count;
    if (above < 0)
        TRY(keep(p, n));
    for (int k = above < 0 ? 0 : p->first[above]; above >= 0 && k < p->end[above]; k++)
        for (int c = 2 * p->near[k]; c < 2 * p->near[k] + 2 && c < w->boxes[l]; c++)
            if (mesh_patches_meets(p, l, c, wide))
                TRY(keep(p, c));
    p->end[self] = p->count;
out:
    return st;
}

/* Lists the edges of the border that meet a patch, if any part of their rectangles does;
 * returns how many. */
static int list_border(const struct work *w, int l, int n)
{
    const struct mesh_patches *p = w->p;
    const struct mesh_cells *mesh = w->mesh;
    const int self = p->start[l] + n;
    double wide[4];
    int count = 0;

    widen(p->part[self], wide);
    for (int k = p->first[self]; k < p->end[self]; k++)
        for (int c = p->near[k] << l; c < (p->near[k] + 1) << l && c < mesh->count; c++)
            for (int s = 0; s < 3; s++) {
                const int edge = mesh->side[p->order[c]][s], *end = mesh->edge[edge].node;
                double part[4] = {INFINITY, INFINITY, -INFINITY, -INFINITY};
                include(part, mesh->at[end[0]], mesh->at[end[0]]);
                include(part, mesh->at[end[1]], mesh->at[end[1]]);
                if (mesh->edge[edge].triangle[1] < 0 && mesh_patches_overlap(part, wide))
                    w->border[count++] = edge;
            }
    return count;
}

/* Tells whether the border turns to the right from an edge to the next. */
static bool turns_in(const struct mesh_cells *mesh, int edge, int next)
{
    const int *a = mesh->edge[edge].node, *b = mesh->edge[next].node;
    const double p[2] = {mesh->at[a[1]][0] - mesh->at[a[0]][0],
                         mesh->at[a[1]][1] - mesh->at[a[0]][1]};
    const double q[2] = {mesh->at[b[1]][0] - mesh->at[b[0]][0],
                         mesh->at[b[1]][1] - mesh->at[b[0]][1]};

    return p[0] * q[1] - p[1] * q[0] < -STRAIGHT * hypot(p[0], p[1]) * hypot(q[0], q[1]);
}

/* Tells whether what a patch has of the pattern is convex: one piece of border passes
 * through it, or none, and turns to the left, where the sheet is, or not at all. */
static bool is_convex(const struct work *w, int l, int n)
{
    const struct mesh_edge *edge = w->mesh->edge;
    const int count = list_border(w, l, n);
    bool convex = true;
    int pieces = 0;

    for (int k = 0; k < count; k++) {
        int *before = &w->before[edge[w->border[k]].node[1]];
        convex &= !*before;
        *before = 1 + w->border[k];
    }
    for (int k = 0; k < count; k++) {
        const int before = w->before[edge[w->border[k]].node[0]];
        pieces += !before;
        convex &= !before || !turns_in(w->mesh, before - 1, w->border[k]);
    }
    for (int k = 0; k < count; k++)
        w->before[edge[w->border[k]].node[1]] = 0;
    return convex && pieces < 2;
}

/* Counts the boxes of levels, as contact_tree.h has them. */
static int count_boxes(struct work *w)
{
    int count = 0;

    w->boxes[0] = w->mesh->count;
    for (w->levels = 1; w->boxes[w->levels - 1] > 1; w->levels++) {
        w->boxes[w->levels] = (w->boxes[w->levels - 1] + 1) / 2;
        w->p->start[w->levels] = count;
        count += w->boxes[w->levels];
    }
    return count;
}

enum status mesh_patches_init(struct mesh_patches *p, const struct mesh_cells *mesh,
                              int points)
{
    struct work w = {.p = p, .mesh = mesh};
    void *room = NULL;
    enum status st;

    *p = (struct mesh_patches){0};
    const int boxes = count_boxes(&w);
    TRY(room_cut(&p->room, ROOM(p->part, boxes), ROOM(p->first, boxes), ROOM(p->end, boxes),
                 ROOM(p->convex, boxes), ROOM(p->order, mesh->count)));
    TRY(room_cut(&room, ROOM(w.border, 3 * mesh->count), ROOM(w.before, points)));
    TRY(find_order(mesh, p->order));
    if (mesh->start)
        goto out;
    fit_parts(&w);
    for (int l = w.levels - 1; l > 0; l--)
        for (int n = 0; n < w.boxes[l]; n++) {
            const bool above = l + 1 < w.levels && p->convex[p->start[l + 1] + n / 2];
            TRY(list_near(&w, l, n));
            p->convex[p->start[l] + n] = above || is_convex(&w, l, n);
        }
out:
    free(room);
    if (st)
        mesh_patches_clear(p);
    return st;
}

/* Tells whether the patch of a box is known to be convex and holds another box. */
static bool holds(const struct mesh_patches *p, int self, int other)
{
    double wide[4];

    widen(p->part[self], wide);
    const double *in = p->part[other];
    return p->convex[self] && in[0] >= wide[0] && in[1] >= wide[1] && in[2] <= wide[2] &&
           in[3] <= wide[3];
}

bool mesh_patches_between(const struct mesh_patches *p, int level, int a, int b,
                          double part[4], const int **near, const int **end)
{
    const int first = p->start[level] + a, second = p->start[level] + b;
    const int self = holds(p, first, second) ? first : second;

    if (self == second && !holds(p, second, first))
        return false;
    memcpy(part, p->part[first], sizeof p->part[first]);
    include(part, p->part[second], p->part[second] + 2);
    *near = p->near + p->first[self], *end = p->near + p->end[self];
    return true;
}

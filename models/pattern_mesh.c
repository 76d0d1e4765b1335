#include "models/pattern_mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* So far from the border, in widths, points of the lattice are left out, and so often
 * points are moved to the mean of their neighbours. */
static const double MARGIN = 0.6;
enum { MOVES = 6 };

struct work {
    const struct scene *scene;
    const struct pattern *p;
    struct mesh_flat *flat; /* its first nodes are those of the border               */
    double width;
    int *next, *line; /* [border] the node after it on its line, and its line  */
    int border, lines;
    struct mesh_edge *edge;
    int edges, (*side)[3];
    int last;              /* triangle of the last point put in                     */
    int *stack, top, room; /* edges to look at                                      */
};

/* --- the border -------------------------------------------------------------------------
 */

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Lists where along a side from a to b, in shares of it, supports end; returns how many. */
static int breaks_of(const struct scene *scene, const double a[2], const double b[2],
                     double *share)
{
    const double size[2] = {scene->length, scene->width}, least = 1e-6;
    int count = 0;

    for (int n = 0; n < 4 * scene->support_count; n++) {
        const struct scene_support *s = &scene->supports[n / 4];
        const int i = n % 2;
        const double line = (n % 4 < 2 ? s->lo : s->hi)[i] * size[i];
        const double at = (line - a[i]) / (b[i] - a[i]);
        if (at > least && at < 1 - least)
            share[count++] = at;
    }
    qsort(share, (size_t)count, sizeof *share, compare);
    share[count++] = 1;
    return count;
}

/* Divides a side, and fills at[] with its points, but for its end; NULL: counts them only.
 */
static int divide(const struct work *w, const double a[2], const double b[2], double *share,
                  double (*at)[2])
{
    const double length = hypot(b[0] - a[0], b[1] - a[1]);
    const int breaks = breaks_of(w->scene, a, b, share);
    double from = 0;
    int count = 0;

    for (int n = 0; n < breaks; n++) {
        const double part = share[n] - from;
        const int pieces = (int)fmax(1, round(part * length / w->width));
        for (int k = 0; k < pieces && part > 0; k++, count++)
            for (int i = 0; at && i < 2; i++)
                at[count][i] = a[i] + (from + part * k / pieces) * (b[i] - a[i]);
        from = share[n];
    }
    return count;
}

static void add_border(struct work *w, double *share)
{
    struct mesh_flat *flat = w->flat;

    for (int k = 0; k < w->p->lines; k++) {
        const int first = flat->nodes;
        for (int n = w->p->line[k]; n < w->p->line[k + 1]; n++)
            flat->nodes += divide(w, w->p->at[n], w->p->at[w->p->next[n]], share,
                                  flat->at + flat->nodes);
        for (int a = first; a < flat->nodes; a++)
            w->next[a] = a + 1 < flat->nodes ? a + 1 : first, w->line[a] = k;
    }
}

static int count_border(const struct work *w, double *share)
{
    int count = 0;

    for (int n = 0; n < w->p->points; n++)
        count += divide(w, w->p->at[n], w->p->at[w->p->next[n]], share, NULL);
    return count;
}

/* --- ears -------------------------------------------------------------------------------
 */

/* A closed walk along the border, which goes to holes and back. */
struct walk {
    int count, *node;
};

/* Tells whether the way between two nodes crosses or touches a side that neither ends. */
static bool is_blocked(const struct work *w, int a, int b)
{
    for (int c = 0; c < w->border; c++) {
        const int d = w->next[c];
        if (c == a || c == b || d == a || d == b)
            continue;
        const double abc = mesh_flat_area2(w->flat, a, b, c),
                     abd = mesh_flat_area2(w->flat, a, b, d);
        const double cda = mesh_flat_area2(w->flat, c, d, a),
                     cdb = mesh_flat_area2(w->flat, c, d, b);
        if (((abc >= 0 && abd <= 0) || (abc <= 0 && abd >= 0)) &&
            ((cda >= 0 && cdb <= 0) || (cda <= 0 && cdb >= 0)))
            return true;
    }
    return false;
}

/* Tells whether the way from the n-th node of the walk to a node begins inside. */
static bool looks_in(const struct work *w, const struct walk *walk, int n, int to)
{
    const int at = walk->node[n], before = walk->node[(n + walk->count - 1) % walk->count],
              after = walk->node[(n + 1) % walk->count];
    const bool convex = mesh_flat_area2(w->flat, before, at, after) > 0;
    const bool a = mesh_flat_area2(w->flat, before, at, to) > 0,
               b = mesh_flat_area2(w->flat, at, after, to) > 0;

    return convex ? a && b : a || b;
}

/* Returns the line's node that is farthest along u. */
static int farthest(const struct work *w, int line)
{
    int best = -1;

    for (int a = 0; a < w->border; a++)
        if (w->line[a] == line && (best < 0 || w->flat->at[a][0] > w->flat->at[best][0]))
            best = a;
    return best;
}

/* Joins a hole to the walk, by the shortest way from its farthest node that nothing blocks.
 */
static void join(const struct work *w, struct walk *walk, int from)
{
    const double(*at)[2] = (const double(*)[2])w->flat->at;
    double least = INFINITY;
    int best = 0, size = 1;

    for (int n = 0; n < walk->count; n++) {
        const int a = walk->node[n];
        const double way = hypot(at[a][0] - at[from][0], at[a][1] - at[from][1]);
        if (way < least && looks_in(w, walk, n, from) && !is_blocked(w, a, from))
            least = way, best = n;
    }
    for (int a = w->next[from]; a != from; a = w->next[a])
        size++;
    int *behind = walk->node + best + 1;
    memmove(behind + size + 2, behind, (size_t)(walk->count - best - 1) * sizeof *behind);
    for (int n = 0, a = from; n < size; n++, a = w->next[a])
        behind[n] = a;
    behind[size] = from, behind[size + 1] = walk->node[best];
    walk->count += size + 2;
}

/* Starts with the outline, and joins holes to it, those first that reach farthest: nothing
 * but the walk so far is then between them and it. */
static void make_walk(const struct work *w, struct walk *walk, bool *joined)
{
    for (int a = 0; a < w->border; a++)
        if (w->line[a] == 0)
            walk->node[walk->count++] = a;
    for (int n = 1; n < w->lines; n++) {
        int best = -1;
        for (int k = 1; k < w->lines; k++) {
            const int a = joined[k] ? -1 : farthest(w, k);
            if (a >= 0 && (best < 0 || w->flat->at[a][0] > w->flat->at[best][0]))
                best = a;
        }
        joined[w->line[best]] = true;
        join(w, walk, best);
    }
}

/* Tells whether the corner at the n-th node can be cut off: no other node is in it. */
static bool is_ear(const struct work *w, const struct walk *walk, int n)
{
    const int a = walk->node[(n + walk->count - 1) % walk->count], b = walk->node[n],
              c = walk->node[(n + 1) % walk->count];

    if (!(mesh_flat_area2(w->flat, a, b, c) > 0))
        return false;
    for (int k = 0; k < walk->count; k++) {
        const int d = walk->node[k];
        if (d != a && d != b && d != c && mesh_flat_area2(w->flat, a, b, d) >= 0 &&
            mesh_flat_area2(w->flat, b, c, d) >= 0 &&
            mesh_flat_area2(w->flat, c, a, d) >= 0)
            return false;
    }
    return true;
}

/* Cuts the walk into triangles, round and round; what round-off leaves without an ear is
 * cut anywhere it turns left. */
static void clip(struct work *w, struct walk *walk)
{
    int since = 0;

    for (int n = 0; walk->count > 2;) {
        n %= walk->count;
        const int a = walk->node[(n + walk->count - 1) % walk->count], b = walk->node[n],
                  c = walk->node[(n + 1) % walk->count];
        if (!(since < walk->count
                  ? is_ear(w, walk, n)
                  : mesh_flat_area2(w->flat, a, b, c) > 0 || since > 2 * walk->count)) {
            n++, since++;
            continue;
        }
        memcpy(w->flat->triangle[w->flat->triangles++], (int[3]){a, b, c},
               sizeof *w->flat->triangle);
        memmove(walk->node + n, walk->node + n + 1,
                (size_t)(walk->count - n - 1) * sizeof *walk->node);
        walk->count--, n++, since = 0;
    }
}

static enum status cut_border(struct work *w)
{
    struct walk walk = {0};
    bool *joined = calloc((size_t)w->lines, sizeof *joined);
    enum status st = STATUS_MEMORY;

    walk.node = malloc(((size_t)w->border + 2 * (size_t)w->lines) * sizeof *walk.node);
    if (walk.node && joined) {
        make_walk(w, &walk, joined);
        clip(w, &walk);
        st = STATUS_OK;
    }
    free(walk.node);
    free(joined);
    return st;
}

/* --- points inside ----------------------------------------------------------------------
 */

static double area_of(const struct work *w, int t, int corner, int node)
{
    const int *v = w->flat->triangle[t];

    return mesh_flat_area2(w->flat, node, v[(corner + 1) % 3], v[(corner + 2) % 3]);
}

/* Returns the triangle that a node lies in, on a way from the last one found; if that leads
 * out of the sheet, by looking at all. */
static int find(const struct work *w, int node)
{
    int t = w->last;

    for (int steps = 0; steps < w->flat->triangles; steps++) {
        int worst = 0;
        for (int c = 1; c < 3; c++)
            if (area_of(w, t, c, node) < area_of(w, t, worst, node))
                worst = c;
        if (area_of(w, t, worst, node) >= 0)
            return t;
        const struct mesh_edge *e = &w->edge[w->side[t][worst]];
        const int beyond = e->triangle[e->triangle[0] == t];
        if (beyond < 0)
            break;
        t = beyond;
    }
    for (t = 0; t < w->flat->triangles; t++)
        if (area_of(w, t, 0, node) >= 0 && area_of(w, t, 1, node) >= 0 &&
            area_of(w, t, 2, node) >= 0)
            return t;
    return -1;
}

/* Gives an edge another triangle in place of one, and the node across in it. */
static void hand(struct mesh_edge *e, int from, int to, int across)
{
    const int k = e->triangle[0] == from ? 0 : 1;

    e->triangle[k] = to, e->node[2 + k] = across;
}

/* Notes an edge; one that there is no room for is turned at the end. */
static void push(struct work *w, int edge)
{
    if (w->top < w->room)
        w->stack[w->top++] = edge;
}

/* Cuts a triangle into three at a node, and turns edges around it. */
static void put_in(struct work *w, int t, int node)
{
    struct mesh_flat *flat = w->flat;
    const double scale = pow(w->width, 4);
    int v[3], out[3], spoke[3], of[3] = {t, flat->triangles, flat->triangles + 1};

    memcpy(v, flat->triangle[t], sizeof v);
    memcpy(out, w->side[t], sizeof out);
    flat->triangles += 2;
    for (int c = 0; c < 3; c++) { /* of[c] has the side across from v[c] */
        const int a = v[(c + 1) % 3], b = v[(c + 2) % 3];
        spoke[c] = w->edges++;
        memcpy(flat->triangle[of[c]], (int[3]){node, a, b}, sizeof *flat->triangle);
        hand(&w->edge[out[c]], t, of[c], node);
    }
    for (int c = 0; c < 3; c++) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        /* the spoke to v[c] lies between of[a] and of[b]: its ends in of[b] are v[c], node
         */
        w->edge[spoke[c]] = (struct mesh_edge){{node, v[c], v[a], v[b]}, {of[b], of[a]}};
        memcpy(w->side[of[c]], (int[3]){out[c], spoke[b], spoke[a]}, sizeof *w->side);
    }
    for (int c = 0; c < 3; c++)
        push(w, out[c]);
    while (w->top) {
        const int k = w->stack[--w->top];
        if (!mesh_flat_turns(flat, &w->edge[k], scale))
            continue;
        mesh_flat_turn(flat, w->edge, w->side, k);
        for (int s = 0; s < 2; s++)
            for (int c = 0; c < 3; c++)
                if (w->side[w->edge[k].triangle[s]][c] != k)
                    push(w, w->side[w->edge[k].triangle[s]][c]);
    }
    w->last = t;
}

/* Tells whether a place is on the sheet and far enough from its border. */
static bool has_room(const struct work *w, const double at[2])
{
    const double least = MARGIN * w->width;

    for (int a = 0; a < w->border; a++) {
        const double *from = w->flat->at[a], *to = w->flat->at[w->next[a]];
        const double d[2] = {to[0] - from[0], to[1] - from[1]};
        const double e[2] = {at[0] - from[0], at[1] - from[1]};
        const double along = (e[0] * d[0] + e[1] * d[1]) / (d[0] * d[0] + d[1] * d[1]);
        const double s = fmin(fmax(along, 0), 1);
        const double off[2] = {e[0] - s * d[0], e[1] - s * d[1]};
        if (off[0] * off[0] + off[1] * off[1] < least * least)
            return false;
    }
    return pattern_has(w->p, at[0], at[1]);
}

/* A lattice of equilateral triangles, turned and shifted by a seed. */
struct lattice {
    double corner[2], turn, width;
    int rows;
};

static struct lattice lattice_of(const struct work *w, int seed)
{
    const double reach = hypot(w->scene->length, w->scene->width);
    uint64_t state = (uint64_t)seed;
    struct lattice l = {.width = w->width, .rows = (int)ceil(reach / w->width) + 1};

    if (seed) {
        l.turn = mesh_flat_random(&state);
        l.corner[0] = w->width * mesh_flat_random(&state);
        l.corner[1] = w->width * mesh_flat_random(&state);
    }
    return l;
}

/* Computes the place (i, j) of the lattice, which lies around the middle of the box. */
static void lattice_at(const struct lattice *l, const double middle[2], int i, int j,
                       double at[2])
{
    const double x = l->corner[0] + (i + (j & 1) / 2.) * l->width,
                 y = l->corner[1] + j * sqrt(0.75) * l->width;

    at[0] = middle[0] + cos(l->turn) * x - sin(l->turn) * y;
    at[1] = middle[1] + sin(l->turn) * x + cos(l->turn) * y;
}

/* Puts in the places of the lattice that have room. */
static void fill_in(struct work *w, int seed)
{
    const struct lattice l = lattice_of(w, seed);
    const double middle[2] = {w->scene->length / 2, w->scene->width / 2};

    for (int j = -l.rows; j <= l.rows; j++)
        for (int i = -l.rows; i <= l.rows; i++) {
            double at[2];
            lattice_at(&l, middle, i, j, at);
            if (at[0] < 0 || at[1] < 0 || at[0] > w->scene->length ||
                at[1] > w->scene->width || !has_room(w, at))
                continue;
            memcpy(w->flat->at[w->flat->nodes], at, sizeof at);
            const int t = find(w, w->flat->nodes);
            if (t >= 0)
                put_in(w, t, w->flat->nodes++);
        }
}

/* Moves points inside to the mean of their neighbours, by less where triangles would turn
 * over. */
static enum status relax(struct work *w)
{
    struct mesh_flat *flat = w->flat;
    const size_t count = (size_t)flat->nodes;
    double(*sum)[3] = calloc(count, sizeof *sum), (*old)[2] = malloc(count * sizeof *old);

    for (int n = 0; sum && old && n < MOVES; n++) {
        double part = 1;
        memset(sum, 0, count * sizeof *sum);
        memcpy(old, flat->at, count * sizeof *old);
        for (int e = 0; e < w->edges; e++)
            for (int k = 0; k < 2; k++) {
                const int a = w->edge[e].node[k], b = w->edge[e].node[1 - k];
                sum[a][0] += old[b][0], sum[a][1] += old[b][1], sum[a][2] += 1;
            }
        do {
            for (int a = w->border; a < flat->nodes; a++)
                for (int i = 0; i < 2; i++)
                    flat->at[a][i] = old[a][i] + part * (sum[a][i] / sum[a][2] - old[a][i]);
            part /= 2;
        } while (part > 1. / 32 && !mesh_flat_good(flat, 0));
        if (!mesh_flat_good(flat, 0))
            memcpy(flat->at, old, count * sizeof *old);
        mesh_flat_improve(flat, w->edge, w->edges, w->side, pow(w->width, 4));
    }
    const enum status st = sum && old ? STATUS_OK : STATUS_MEMORY;
    free(old);
    free(sum);
    return st;
}

/* --- the whole --------------------------------------------------------------------------
 */

/* Makes room for the nodes, triangles and edges that the lattice may add to the border's: a
 * place has its part of the area, but for those along the border. */
static enum status make_room(struct work *w)
{
    struct mesh_flat *flat = w->flat;
    const double places = w->p->area / (sqrt(0.75) * w->width * w->width);
    const size_t nodes = (size_t)places + 3 * (size_t)w->border + 16;
    const size_t triangles = 2 * nodes + 2 * (size_t)w->lines;
    double(*at)[2] = realloc(flat->at, nodes * sizeof *at);
    if (at)
        flat->at = at;
    int(*triangle)[3] = realloc(flat->triangle, triangles * sizeof *triangle);
    if (triangle)
        flat->triangle = triangle;
    struct mesh_edge *edge = realloc(w->edge, 2 * triangles * sizeof *edge);
    if (edge)
        w->edge = edge;
    int(*side)[3] = realloc(w->side, triangles * sizeof *side);
    if (side)
        w->side = side;
    w->room = 1024;
    w->stack = malloc((size_t)w->room * sizeof *w->stack);
    return at && triangle && edge && side && w->stack ? STATUS_OK : STATUS_MEMORY;
}

enum status pattern_mesh(const struct scene *scene, double width, int seed,
                         struct mesh_flat *flat)
{
    struct mesh_flat new = {0};
    struct work w = {.scene = scene, .p = scene->pattern, .flat = &new, .width = width};
    double *share = malloc((4 * (size_t)scene->support_count + 2) * sizeof *share);
    enum status st = share ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    w.lines = w.p->lines, w.border = count_border(&w, share);
    w.next = malloc((size_t)w.border * sizeof *w.next);
    w.line = malloc((size_t)w.border * sizeof *w.line);
    TRY(w.next && w.line ? STATUS_OK : STATUS_MEMORY);
    TRY(mesh_flat_make(&new, w.border, w.border + 2 * w.lines));
    add_border(&w, share);
    TRY(cut_border(&w));
    TRY(mesh_flat_edges(&new, &w.edge, &w.edges, &w.side));
    TRY(make_room(&w));
    mesh_flat_improve(&new, w.edge, w.edges, w.side, pow(width, 4));
    fill_in(&w, seed);
    TRY(relax(&w));
    mesh_flat_clear(flat);
    HAND_OVER(flat, new);
out:
    free(share);
    free(w.next);
    free(w.line);
    free(w.edge);
    free(w.side);
    free(w.stack);
    mesh_flat_clear(&new);
    return st;
}

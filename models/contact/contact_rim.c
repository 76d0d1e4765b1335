#include "models/contact/contact_rim.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/vector.h"

/* The most of `start` between two points of a rim. */
static const double SPACING = 0.25;

/* More chords than these an edge of a sheet that holds together does not have. */
static const double MOST_POINTS = 1e6;
/* How much farther than `start` the chords of curved rims are looked at, over start. */
static const double SLACK = 0.5;
/* The step of differences along an edge; the change at which a foot is found. */
static const double SPREAD = 1. / 64, SETTLED = 1e-9;
/* A share of a squared cosine that rounding can't reach; the least distance along the sheet
 * at which places count, over start, rounded down. */
static const double ROUNDED = 1 - 1e-9, LEAST_APART = 1.5;

void contact_rim_clear(struct contact_rim *r)
{
    free(r->room);
    free(r->pair);
    free(r->near);
    memset(r, 0, sizeof *r);
}

enum status contact_rim_init(struct contact_rim *r, struct contact_search *search)
{
    const size_t width = 2 * (size_t)contact_foot_width(search->sheet.surface);

    *r = (struct contact_rim){.search = search, .sought = -1};
    return room_cut(&r->room, ROOM(r->node, width), ROOM(r->weight, width));
}

/* --- edges: those of each sheet of n x m samples go round it, the sheet at their left, so
 * that the normal times their direction leads into it; those of a mesh are its own ------
 */

/* Computes the samples at the ends of an edge. */
static void ends_of(const struct contact_surface *s, int edge, int end[2])
{
    if (s->mesh.count) {
        memcpy(end, s->mesh.edge[edge].node, 2 * sizeof *end);
        return;
    }
    const int n = s->rows, m = s->points[1], on[4] = {n - 1, m - 1, n - 1, m - 1};
    const int round = 2 * (n - 1 + m - 1), first = edge / round * n * m;
    int side = 0;

    for (edge %= round; edge >= on[side]; side++)
        edge -= on[side];
    for (int k = 0; k < 2; k++) {
        const int at = side < 2 ? edge + k : on[side] - edge - k;
        end[k] = first + (side % 2 ? (side == 1 ? (n - 1) * m : 0) + at
                                   : at * m + (side == 0 ? 0 : m - 1));
    }
}

/* Lists the edges of a cell that are rims; returns how many. */
static int edges_of(const struct contact_tree *tree, int cell, int edge[4])
{
    const struct contact_surface *s = tree->surface;
    if (s->mesh.count)
        return mesh_cells_rims(&s->mesh, contact_tree_triangle(tree, cell), edge);
    const int n = s->rows, m = s->points[1], row = cell / (m - 1), j = cell % (m - 1);
    const int i = row % n, first = row / n * 2 * (n - 1 + m - 1);
    const bool seam = s->around > 0;
    int count = 0;

    if (j == 0 && !seam)
        edge[count++] = first + i;
    if (i == n - 2)
        edge[count++] = first + n - 1 + j;
    if (j == m - 2 && !seam)
        edge[count++] = first + n - 1 + m - 1 + n - 2 - i;
    if (i == 0)
        edge[count++] = first + 2 * (n - 1) + m - 1 + m - 2 - j;
    return count;
}

/* An edge near another, as a chord. */
struct contact_rim_chord {
    int end[2];
    const double *y;   /* [m], its first end                                             */
    double e[3], size; /* [m], [m^2], to its second end, and the square of that          */
};

static int by_edges(const void *a, const void *b)
{
    const int *p = a, *q = b;

    return p[0] != q[0] ? (p[0] > q[0]) - (p[0] < q[0]) : (p[1] > q[1]) - (p[1] < q[1]);
}

static enum status keep(struct contact_rim *r, int edge, int other)
{
    if (r->count == r->most) {
        const int most = 2 * r->most + 64;
        int(*pair)[2] = realloc(r->pair, (size_t)most * sizeof *pair);
        if (!pair)
            return STATUS_MEMORY;
        r->pair = pair;
        struct contact_rim_chord *near = realloc(r->near, (size_t)most * sizeof *near);
        if (!near)
            return STATUS_MEMORY;
        r->near = near, r->most = most;
    }
    r->pair[r->count][0] = edge, r->pair[r->count++][1] = other;
    return STATUS_OK;
}

/* Lists the pairs of edges in near cells, each both ways. */
static enum status list_pairs(struct contact_rim *r)
{
    const struct contact_tree *tree = &r->search->tree;
    enum status st = STATUS_OK;
    int cell[2], edge[2][4];

    r->count = 0;
    for (long n = 0; contact_search_cells(r->search, n, cell); n++) {
        const int count = edges_of(tree, cell[0], edge[0]);
        const int others = count ? edges_of(tree, cell[1], edge[1]) : 0;
        for (int k = 0; k < count; k++)
            for (int l = 0; l < others; l++)
                if (edge[0][k] != edge[1][l]) {
                    TRY(keep(r, edge[0][k], edge[1][l]));
                    if (cell[0] != cell[1])
                        TRY(keep(r, edge[1][l], edge[0][k]));
                }
    }
    if (r->count)
        qsort(r->pair, (size_t)r->count, sizeof *r->pair, by_edges);
    r->sought = r->search->sought;
out:
    return st;
}

/* --- points of an edge ------------------------------------------------------------------
 */

/* A place on a rim: the ends of an edge, and how far along it, 0 to 1. */
struct place {
    int end[2];
    double at;
    double uv[3], y[3]; /* uv: of a mesh the place in the tree's flat                */
};

/* Computes the parameters of a place, those of the sheet's ends beyond them. */
static void find_uv(const struct contact_sheet *sheet, struct place *p)
{
    const struct contact_surface *s = sheet->surface;
    const double(*flat)[3] = (const double(*)[3])sheet->tree->flat;

    if (s->mesh.count) {
        for (int d = 0; d < 3; d++)
            p->uv[d] = (1 - p->at) * flat[p->end[0]][d] + p->at * flat[p->end[1]][d];
        return;
    }
    const double *end = s->line[0] + p->end[0] / s->points[1] / s->rows * s->rows;
    const double low[2] = {*end, 0}, high[2] = {end[s->rows - 1], 1};

    for (int d = 0; d < 2; d++) {
        const int from = d ? p->end[0] % s->points[1] : p->end[0] / s->points[1];
        const int to = d ? p->end[1] % s->points[1] : p->end[1] / s->points[1];
        p->uv[d] = (1 - p->at) * s->line[d][from] + p->at * s->line[d][to];
        p->uv[d] = fmin(fmax(p->uv[d], low[d]), high[d]);
    }
}

/* Computes a place's parameters and point; lists its nodes and returns how many. */
static int locate(const struct contact_sheet *sheet, struct place *p, int *node,
                  double *weight)
{
    const struct contact_surface *s = sheet->surface;
    const double share[] = {1 - p->at, p->at};

    find_uv(sheet, p);
    const int count = s->smooth ? s->row(s->self, p->uv[0], p->uv[1], node, weight)
                                : contact_surface_mix(s, 2, p->end, share, node, weight);
    memset(p->y, 0, sizeof p->y);
    for (int k = 0; k < count; k++)
        for (int i = 0; i < 3; i++)
            p->y[i] += weight[k] * sheet->x[3 * (long)node[k] + i];
    return count;
}

/* Returns the length at rest of an edge. */
static double length_of(const struct contact_tree *tree, const int end[2])
{
    const double *a = tree->flat[end[0]], *b = tree->flat[end[1]];

    return hypot(hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]);
}

/* Moves a foot on a curved rim to the point that is closest to y; it may leave its edge for
 * the next. */
static void refine(const struct contact_sheet *sheet, const double y[3], struct place *foot,
                   int *node, double *weight)
{
    for (int turn = 0; turn < 6; turn++) {
        double p[3][3], gain = 0, size = 0, bend = 0;
        const double at = foot->at;
        for (int k = 0; k < 3; k++) {
            foot->at = at + (k - 1) * SPREAD;
            locate(sheet, foot, node, weight);
            memcpy(p[k], foot->y, sizeof p[k]);
        }
        for (int i = 0; i < 3; i++) {
            const double d = (p[2][i] - p[0][i]) / (2 * SPREAD), way = y[i] - p[1][i];
            gain += way * d, size += d * d;
            bend += way * (p[2][i] - 2 * p[1][i] + p[0][i]) / (SPREAD * SPREAD);
        }
        const double step = gain / fmax(size - bend, size / 4);
        foot->at = fmin(fmax(at + step, -1), 2);
        if (!(fabs(foot->at - at) > SETTLED))
            break;
    }
}

/* --- feet -------------------------------------------------------------------------------
 */

/* Finds the closest place on chords, nearer than `most`; false: none. */
static bool closest(const struct contact_rim *r, const struct place *point, int count,
                    double most, struct place *foot)
{
    double least = most * most;
    bool any = false;

    for (const struct contact_rim_chord *c = r->near; c < r->near + count; c++) {
        double way[3];
        vector_between(c->y, point->y, way);
        const double on = vector_dot(way, c->e);
        const double at = on <= 0 ? 0 : on >= c->size ? 1 : on / c->size;
        for (int i = 0; i < 3; i++)
            way[i] -= at * c->e[i];
        const double square = vector_dot(way, way);
        if (!(square < least))
            continue;
        struct place here = {.end = {c->end[0], c->end[1]}, .at = at};
        find_uv(&r->search->sheet, &here);
        if (contact_foot_far(&r->search->sheet, point->uv, here.uv) > 0) {
            least = square, *foot = here;
            any = true;
        }
    }
    return any;
}

/* Returns the rim's share in the law of a foot that is seen along a way: what the face does
 * not have, and nothing over the face. */
static double share_of(const struct contact_sheet *sheet, const struct place *foot,
                       const double way[3])
{
    const double at = fmin(fmax(foot->at, 0), 1);
    double n[2][3], normal[3], e[3], out[3];

    for (int k = 0; k < 2; k++)
        contact_foot_normal(sheet, foot->end[k], n[k]);
    for (int i = 0; i < 3; i++)
        normal[i] = (1 - at) * n[0][i] + at * n[1][i];
    vector_between(sheet->y + 3 * (long)foot->end[0], sheet->y + 3 * (long)foot->end[1], e);
    vector_cross(e, normal, out);
    if (vector_dot(way, out) < 0 && at > 0 && at < 1)
        return 0;
    const double along = vector_dot(way, normal);
    const double sizes = vector_dot(normal, normal) * vector_dot(way, way);
    return sizes > 0 ? 1 - contact_foot_seen(along * along / sizes) : 1;
}

/* Visits the foot of a point, if it has one. */
static enum status meet(struct contact_rim *r, struct place *point, double length,
                        int count, contact_rim_visit *visit, void *context)
{
    const struct contact_sheet *sheet = &r->search->sheet;
    const bool curved = sheet->surface->smooth;
    const double start = r->search->start;
    struct contact_rim_foot f = {.node = r->node, .weight = r->weight};
    struct place foot;
    double way[3];

    f.of_point = locate(sheet, point, r->node, r->weight);
    if (!closest(r, point, count, (curved ? 1 + SLACK : 1) * start, &foot))
        return STATUS_OK;
    int *node = r->node + f.of_point;
    double *weight = r->weight + f.of_point;
    if (curved)
        refine(sheet, point->y, &foot, node, weight);
    f.of_foot = locate(sheet, &foot, node, weight);
    for (int k = 0; k < f.of_foot; k++)
        weight[k] = -weight[k];
    vector_between(foot.y, point->y, way);
    f.distance = vector_length(way);
    if (!(f.distance < start) || f.distance == 0)
        return STATUS_OK;
    for (int i = 0; i < 3; i++)
        f.normal[i] = way[i] / f.distance;
    f.area = length * start * contact_foot_far(&r->search->sheet, point->uv, foot.uv) *
             share_of(sheet, &foot, way);
    return f.area > 0 ? visit(context, &f) : STATUS_OK;
}

/* Returns the way from the closest place of a chord to the point at t of an edge from y. */
static void way_at(const struct contact_rim_chord *c, const double y[3], const double e[3],
                   double t, double way[3])
{
    for (int i = 0; i < 3; i++)
        way[i] = y[i] + t * e[i] - c->y[i];
    const double on = fmin(fmax(vector_dot(way, c->e) / c->size, 0), 1);
    for (int i = 0; i < 3; i++)
        way[i] -= on * c->e[i];
}

/* Cuts a straight line of ways to where they are shorter than `most`; false: nowhere. */
static bool shorten(double from[3], double to[3], double most)
{
    double by[3], t[2] = {0, 1};

    vector_between(from, to, by);
    const double a = vector_dot(by, by), b = vector_dot(from, by);
    const double c = vector_dot(from, from) - most * most, d = b * b - a * c;
    if (!(a > 0))
        return c < 0;
    if (!(d > 0))
        return false;
    t[0] = fmax((-b - sqrt(d)) / a, 0), t[1] = fmin((-b + sqrt(d)) / a, 1);
    for (int i = 0; i < 3; i++)
        to[i] = from[i] + t[1] * by[i], from[i] += t[0] * by[i];
    return t[0] < t[1];
}

/* Tells whether two ways are seen within the angle at which the face counts wholly, from
 * normals at both ends of a chord, and from the same side. So are then all between them,
 * since ways within an angle of a normal make up a convex cone, and normals within an angle
 * of a way, too. */
static bool is_over(const double n[2][3], const double *const way[2])
{
    int above = 0;

    for (int k = 0; k < 4; k++) {
        const double *m = n[k / 2], *w = way[k % 2], along = vector_dot(m, w);
        const double sizes = vector_dot(m, m) * vector_dot(w, w);
        if (contact_foot_seen(ROUNDED * along * along / sizes) < 1)
            return false;
        above += along > 0;
    }
    return above % 4 == 0;
}

/* Tells whether no point of an edge can have a foot with a share on a chord: those near it
 * are over the face. The way from the chord is straight between the points that are beside
 * its ends. A chord that goes on from the edge, at no sharp angle, is nearest at their
 * common end, and is too near along the sheet unless the edge is a third shorter than at
 * rest. */
static bool faces(const struct contact_rim *r, const int own[2],
                  const struct contact_rim_chord *c)
{
    const struct contact_sheet *sheet = &r->search->sheet;
    const double *y = sheet->y + 3 * (long)own[0], most = (1 + SPREAD) * r->search->start;
    double e[3], n[2][3], on[4] = {0, 0, 1, 1};

    vector_between(y, sheet->y + 3 * (long)own[1], e);
    const double along = vector_dot(e, c->e);
    if (own[1] == c->end[0] || own[0] == c->end[1])
        return along >= -SPREAD * vector_length(e) * sqrt(c->size) &&
               vector_length(e) > length_of(&r->search->tree, own) / LEAST_APART;
    for (int k = 0; k < 2; k++) {
        contact_foot_normal(sheet, c->end[k], n[k]);
        const double to = vector_dot(c->y, c->e) + k * c->size - vector_dot(y, c->e);
        on[along < 0 ? 2 - k : 1 + k] = along == 0 ? 0 : fmin(fmax(to / along, 0), 1);
    }
    for (int k = 0; k < 3; k++) {
        double from[3], to[3];
        way_at(c, y, e, on[k], from);
        way_at(c, y, e, on[k + 1], to);
        if (on[k] < on[k + 1] && shorten(from, to, most) &&
            !is_over((const double(*)[3])n, (const double *const[]){from, to}))
            return false;
    }
    return true;
}

/* Tells whether an edge of a net only faces the chords near it, as those of cards do that
 * lie on each other: it has points enough to take longer than all else in a step. */
static bool only_faces(const struct contact_rim *r, int edge, int count)
{
    int own[2];

    ends_of(r->search->sheet.surface, edge, own);
    for (int n = 0; n < count; n++)
        if (!faces(r, own, &r->near[n]))
            return false;
    return true;
}

/* Visits the feet of an edge, with the chords that are near it. */
static enum status meet_edge(struct contact_rim *r, int edge, int count,
                             contact_rim_visit *visit, void *context)
{
    enum status st = STATUS_OK;
    struct place point = {0};

    ends_of(r->search->sheet.surface, edge, point.end);
    const double length = length_of(&r->search->tree, point.end);
    const double wanted = ceil(length / (SPACING * r->search->start));
    if (!(wanted < MOST_POINTS)) /* an edge that long has burst */
        return STATUS_ESCAPED;
    const int points = (int)wanted;
    r->points += points;
    for (int n = 0; n < points; n++) {
        point.at = (n + 0.5) / points;
        TRY(meet(r, &point, length / points, count, visit, context));
    }
out:
    return st;
}

/* Tells whether two edges of a net share a corner, about which they are as near as it is
 * sharp: they would press open whatever is folded flat. A curved rim has an arc there. */
static bool joined(const struct contact_surface *s, const int own[2], const int end[2])
{
    return !s->smooth && (own[0] == end[1] || own[1] == end[0]);
}

/* Lists the chords that pairs of an edge have near it indeed; returns how many. */
static int sift(const struct contact_rim *r, int first, int end)
{
    const struct contact_surface *s = r->search->sheet.surface;
    const double *y = r->search->sheet.y, most = (1 + SLACK) * r->search->start;
    int count = 0, own[2];

    ends_of(s, r->pair[first][0], own);
    for (int n = first; n < end; n++) {
        struct contact_rim_chord *c = r->near + count;
        double at[2];
        ends_of(s, r->pair[n][1], c->end);
        c->y = y + 3 * (long)c->end[0];
        const double *const p[4] = {y + 3 * (long)own[0], y + 3 * (long)own[1], c->y,
                                    y + 3 * (long)c->end[1]};
        vector_between(p[2], p[3], c->e);
        c->size = vector_dot(c->e, c->e);
        if (!joined(s, own, c->end) && contact_foot_between(p, at) < most)
            count++;
    }
    return count;
}

enum status contact_rim_find(struct contact_rim *r, contact_rim_visit *visit, void *context)
{
    enum status st = STATUS_OK;

    if (r->sought != r->search->sought)
        TRY(list_pairs(r));
    for (int first = 0, end; first < r->count; first = end) {
        for (end = first; end < r->count && r->pair[end][0] == r->pair[first][0];)
            end++;
        const int count = sift(r, first, end);
        if (count &&
            (r->search->sheet.surface->smooth || !only_faces(r, r->pair[first][0], count)))
            TRY(meet_edge(r, r->pair[first][0], count, visit, context));
    }
out:
    return st;
}

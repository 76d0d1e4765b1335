#include "models/bodies/body_mesh.h"

#include <assert.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/vector.h"

enum { LEAF = 4, STACK = 64 };

/* Corners are on a line if twice the triangle's area is less than this share of its longest
 * edge's square; a point is on the surface if it is closer than this share of the mesh. */
static const double FLAT = 1e-14, TOUCHING = 1e-12;

struct box {
    double lo[3], hi[3];
};

/* Box 0 is the root, boxes 2 n + 1 and 2 n + 2 halve the triangles of box n. The arrays
 * follow in the same piece of memory. */
struct obstacle_mesh {
    int vertices, triangles, leaves; /* leaves is a power of two                   */
    double (*vertex)[3];
    int (*corner)[3];  /* [triangles]                                                  */
    int (*beside)[3];  /* [triangles] the one over the edge from corner k on; -1: none */
    double (*face)[3]; /* [triangles] unit normals                                     */
    double (*bend)[3]; /* [vertices] sums of normals times angles; 0 on a rim          */
    struct box *box;   /* [2 leaves - 1]                                               */
    bool outward;      /* closed, and all beyond the root's box is outside             */
};

/* --- making ----------------------------------------------------------------------------
 */

struct place {
    double x[3];
    int vertex;
};

static int compare_places(const void *a, const void *b)
{
    const struct place *p = a, *q = b;

    for (int i = 0; i < 3; i++)
        if (p->x[i] != q->x[i])
            return p->x[i] < q->x[i] ? -1 : 1;
    return (p->vertex > q->vertex) - (p->vertex < q->vertex);
}

/* Copies what is given; equal places get the number of the first, and triangles with equal
 * corners go. */
static enum status weld(struct obstacle_mesh *m, const double (*vertex)[3], int triangles,
                        const int (*triangle)[3])
{
    struct place *sorted;
    int *same;
    void *room;
    enum status st;

    TRY(room_cut(&room, ROOM(sorted, m->vertices), ROOM(same, m->vertices)));
    for (int n = 0; n < m->vertices; n++) {
        sorted[n].vertex = n;
        for (int i = 0; i < 3; i++) /* no -0 */
            sorted[n].x[i] = m->vertex[n][i] = vertex[n][i] + 0.0;
    }
    qsort(sorted, (size_t)m->vertices, sizeof *sorted, compare_places);
    for (int n = 0; n < m->vertices; n++) {
        const bool again =
            n > 0 && !memcmp(sorted[n].x, sorted[n - 1].x, sizeof sorted[n].x);
        same[sorted[n].vertex] = again ? same[sorted[n - 1].vertex] : sorted[n].vertex;
    }
    for (int t = 0; t < triangles; t++) {
        int *c = m->corner[m->triangles];
        for (int k = 0; k < 3; k++)
            c[k] = same[triangle[t][k]];
        m->triangles += c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
    }
out:
    free(room);
    return st;
}

static struct box box_of(const struct obstacle_mesh *m, int first, int end)
{
    struct box b = {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

    for (int t = first; t < end; t++)
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++) {
                b.lo[i] = fmin(b.lo[i], m->vertex[m->corner[t][k]][i]);
                b.hi[i] = fmax(b.hi[i], m->vertex[m->corner[t][k]][i]);
            }
    return b;
}

struct keyed {
    uint64_t key;
    int corner[3], order;
};

static int compare_keys(const void *a, const void *b)
{
    const struct keyed *p = a, *q = b;

    if (p->key != q->key)
        return p->key < q->key ? -1 : 1;
    return p->order - q->order;
}

/* Returns the place of a triangle's middle on a curve that keeps neighbours together
 * (Morton 1966). */
static uint64_t curve_place(const struct obstacle_mesh *m, const int corner[3],
                            const struct box *all)
{
    enum { BITS = 21 };
    uint64_t key = 0;
    unsigned cell[3];

    for (int i = 0; i < 3; i++) {
        const double width = all->hi[i] - all->lo[i], *x = &m->vertex[0][i];
        const double middle = (x[3 * (size_t)corner[0]] + x[3 * (size_t)corner[1]] +
                               x[3 * (size_t)corner[2]]) /
                              3;
        const double part = width > 0 ? (middle - all->lo[i]) / width : 0;
        cell[i] = (unsigned)(fmin(fmax(part, 0), 1) * ((1 << BITS) - 1));
    }
    for (int bit = BITS - 1; bit >= 0; bit--)
        for (int i = 0; i < 3; i++)
            key = key << 1 | (cell[i] >> bit & 1);
    return key;
}

/* Sorts the triangles along the curve, so that each range of them is a part of the mesh. */
static enum status sort_triangles(struct obstacle_mesh *m)
{
    struct keyed *sorted = malloc((size_t)m->triangles * sizeof *sorted);
    const struct box all = box_of(m, 0, m->triangles);

    if (!sorted)
        return STATUS_MEMORY;
    for (int t = 0; t < m->triangles; t++) {
        sorted[t].key = curve_place(m, m->corner[t], &all);
        sorted[t].order = t;
        memcpy(sorted[t].corner, m->corner[t], sizeof m->corner[t]);
    }
    qsort(sorted, (size_t)m->triangles, sizeof *sorted, compare_keys);
    for (int t = 0; t < m->triangles; t++)
        memcpy(m->corner[t], sorted[t].corner, sizeof m->corner[t]);
    free(sorted);
    return STATUS_OK;
}

/* Returns the first triangle of a leaf; of the one after the last their number. */
static int first_of(const struct obstacle_mesh *m, int leaf)
{
    return (int)((int64_t)m->triangles * leaf / m->leaves);
}

static void make_tree(struct obstacle_mesh *m)
{
    for (int n = 0; n < m->leaves; n++)
        m->box[m->leaves - 1 + n] = box_of(m, first_of(m, n), first_of(m, n + 1));
    for (int n = m->leaves - 2; n >= 0; n--)
        for (int i = 0; i < 3; i++) {
            const struct box *a = &m->box[2 * n + 1], *b = a + 1;
            m->box[n].lo[i] = fmin(a->lo[i], b->lo[i]);
            m->box[n].hi[i] = fmax(a->hi[i], b->hi[i]);
        }
}

static const double *corner_of(const struct obstacle_mesh *m, int t, int k)
{
    return m->vertex[m->corner[t][k % 3]];
}

/* Refuses the mesh for what is at the places a and b. */
static enum status refuse(const char *before, const double a[3], const char *between,
                          const double b[3], const char *after, struct message *why)
{
    return status_fail(why, STATUS_INPUT,
                       "%s (%.6g, %.6g, %.6g) m %s (%.6g, %.6g, %.6g) m %s", before, a[0],
                       a[1], a[2], between, b[0], b[1], b[2], after);
}

/* Computes faces' normals, and their sums at vertices. */
static enum status make_normals(struct obstacle_mesh *m, struct message *why)
{
    for (int t = 0; t < m->triangles; t++) {
        double e[3][3], longest = 0, *n = m->face[t];
        for (int k = 0; k < 3; k++) {
            vector_between(corner_of(m, t, k), corner_of(m, t, k + 1), e[k]);
            longest = fmax(longest, vector_dot(e[k], e[k]));
        }
        vector_cross(e[0], e[1], n);
        const double area = vector_length(n);
        if (!(area > FLAT * longest))
            return refuse("a triangle at", corner_of(m, t, 0), "and", corner_of(m, t, 1),
                          "has its three corners on a line; leave it out and let its "
                          "neighbours share their corners",
                          why);
        for (int i = 0; i < 3; i++)
            n[i] /= area;
        for (int k = 0; k < 3; k++) {
            const double angle = atan2(area, -vector_dot(e[k], e[(k + 2) % 3]));
            for (int i = 0; i < 3; i++)
                m->bend[m->corner[t][k]][i] += angle * n[i];
        }
    }
    return STATUS_OK;
}

struct edge {
    int low, high; /* vertices */
    int side;      /* 3 triangle + corner where it begins */
};

static int compare_edges(const void *a, const void *b)
{
    const struct edge *p = a, *q = b;

    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    if (p->high != q->high)
        return p->high < q->high ? -1 : 1;
    return p->side - q->side;
}

/* Tells triangles their neighbours; vertices of a rim get no normal. */
static enum status join(const struct obstacle_mesh *m, struct message *why)
{
    const int count = 3 * m->triangles;
    struct edge *edge = malloc((size_t)count * sizeof *edge);
    enum status st = STATUS_OK;

    if (!edge)
        return STATUS_MEMORY;
    for (int n = 0; n < count; n++) {
        const int a = m->corner[n / 3][n % 3], b = m->corner[n / 3][(n + 1) % 3];
        edge[n] = (struct edge){a < b ? a : b, a < b ? b : a, n};
    }
    qsort(edge, (size_t)count, sizeof *edge, compare_edges);
    for (int n = 0, more; n < count; n += more) {
        const struct edge *e = edge + n;
        const int s = e->side;
        for (more = 1;
             n + more < count && e[more].low == e->low && e[more].high == e->high;)
            more++;
        const int other = more == 2 ? e[1].side : -1;
        m->beside[s / 3][s % 3] = other < 0 ? -1 : other / 3;
        if (other >= 0)
            m->beside[other / 3][other % 3] = s / 3;
        if (more > 2 ||
            (other >= 0 && m->corner[other / 3][other % 3] == m->corner[s / 3][s % 3]))
            TRY(refuse("the triangles at the edge from", m->vertex[e->low], "to",
                       m->vertex[e->high],
                       "are more than two or face opposite ways; one or two that are "
                       "counter-clockwise seen from outside would be right",
                       why));
        for (int i = 0; other < 0 && i < 3; i++)
            m->bend[e->low][i] = m->bend[e->high][i] = 0;
    }
out:
    free(edge);
    return st;
}

/* Tells whether the mesh is closed and faces away from what it encloses. */
static bool is_outward(const struct obstacle_mesh *m)
{
    double volume = 0;

    for (int t = 0; t < m->triangles; t++) {
        double a[3], e[3], f[3], n[3];
        for (int k = 0; k < 3; k++)
            if (m->beside[t][k] < 0)
                return false;
        vector_between(m->box[0].lo, corner_of(m, t, 0), a);
        vector_between(corner_of(m, t, 0), corner_of(m, t, 1), e);
        vector_between(corner_of(m, t, 0), corner_of(m, t, 2), f);
        vector_cross(e, f, n);
        volume += vector_dot(a, n);
    }
    return volume > 0;
}

enum status body_mesh_make(int vertices, const double (*vertex)[3], int triangles,
                           const int (*triangle)[3], struct obstacle_mesh **mesh,
                           struct message *why)
{
    enum status st = STATUS_OK;
    struct obstacle_mesh new = {.vertices = vertices, .leaves = 1}, *m;
    void *room;

    *mesh = NULL;
    while (new.leaves * LEAF < triangles)
        new.leaves *= 2;
    TRY(room_cut(&room, ROOM(m, 1), ROOM(new.vertex, vertices), ROOM(new.corner, triangles),
                 ROOM(new.beside, triangles), ROOM(new.face, triangles),
                 ROOM(new.bend, vertices), ROOM(new.box, 2 * new.leaves - 1)));
    assert(room == m);
    *m = new;
    if (vertices && triangles)
        TRY(weld(m, vertex, triangles, triangle));
    if (!m->triangles)
        TRY(status_fail(why, STATUS_INPUT,
                        "it has no triangle with three different corners; lines `v x y z` "
                        "and `f a b c` would be right"));
    TRY(sort_triangles(m));
    make_tree(m);
    TRY(make_normals(m, why));
    TRY(join(m, why));
    m->outward = is_outward(m);
    *mesh = m, room = NULL;
out:
    free(room);
    return st;
}

struct body_mesh_view body_mesh_view(const struct obstacle_mesh *mesh)
{
    struct body_mesh_view view = {.vertices = mesh->vertices,
                                  .triangles = mesh->triangles,
                                  .vertex = (const double(*)[3])mesh->vertex,
                                  .triangle = (const int(*)[3])mesh->corner,
                                  .bend = (const double(*)[3])mesh->bend,
                                  .mark = 14695981039346656037u}; /* FNV-1a, 64 bits */
    const struct {
        const void *bytes;
        size_t count;
    } part[] = {{mesh->vertex, (size_t)mesh->vertices * sizeof *mesh->vertex},
                {mesh->corner, (size_t)mesh->triangles * sizeof *mesh->corner}};

    for (int p = 0; p < 2; p++)
        for (size_t n = 0; n < part[p].count; n++)
            view.mark =
                (view.mark ^ ((const unsigned char *)part[p].bytes)[n]) * 1099511628211u;
    return view;
}

bool body_mesh_edge(const struct obstacle_mesh *mesh, int side, double normal[3])
{
    const int t = side / 3, beside = mesh->beside[t][side % 3];

    for (int i = 0; i < 3; i++)
        normal[i] = beside < 0 ? 0 : mesh->face[t][i] + mesh->face[beside][i];
    return beside < t;
}

/* --- the distance ----------------------------------------------------------------------
 */

/* A foot is the nearest point so far: in a triangle's face, on its edge, or at its corner.
 */
struct foot {
    double square; /* of its distance; or the most that is wanted                       */
    double place[3];
    int triangle; /* -1: none yet                                                       */
    enum { FOOT_FACE, FOOT_EDGE, FOOT_CORNER } on;
    int k; /* of the edge or corner                                                    */
};

/* Tries the edge from corner k of triangle t, e[3] long, for x = corner + r. */
static void try_edge(const struct obstacle_mesh *m, const double x[3], int t, int k,
                     const double e[3], const double r[3], struct foot *f)
{
    const double s = fmin(fmax(vector_dot(r, e) / vector_dot(e, e), 0), 1);
    struct foot at = {.triangle = t,
                      .on = s > 0 && s < 1 ? FOOT_EDGE : FOOT_CORNER,
                      .k = s < 1 ? k : (k + 1) % 3};
    double way[3];

    for (int i = 0; i < 3; i++)
        at.place[i] = s < 1 ? corner_of(m, t, k)[i] + s * e[i] : corner_of(m, t, k + 1)[i];
    vector_between(at.place, x, way);
    at.square = vector_dot(way, way);
    if (at.square < f->square)
        *f = at;
}

/* The nearest point of a triangle to one that is not over it lies on an edge over which
 * that one is. */
static void try_triangle(const struct obstacle_mesh *m, const double x[3], int t,
                         struct foot *f)
{
    const double *n = m->face[t];
    double e[3], r[3], out[3], height = 0;
    bool inside = true;

    for (int k = 0; k < 3; k++) {
        vector_between(corner_of(m, t, k), x, r);
        if (k == 0)
            height = vector_dot(r, n);
        if (height * height >= f->square)
            return;
        vector_between(corner_of(m, t, k), corner_of(m, t, k + 1), e);
        vector_cross(e, n, out);
        if (vector_dot(r, out) <= 0)
            continue;
        inside = false;
        try_edge(m, x, t, k, e, r, f);
    }
    if (!inside)
        return;
    *f = (struct foot){.square = height * height, .triangle = t, .on = FOOT_FACE};
    for (int i = 0; i < 3; i++)
        f->place[i] = x[i] - height * n[i];
}

static double square_to_box(const struct box *b, const double x[3])
{
    double sum = 0;

    for (int i = 0; i < 3; i++) {
        const double under = b->lo[i] - x[i], over = x[i] - b->hi[i];
        const double off = under > over ? under : over;
        sum += off > 0 ? off * off : 0;
    }
    return sum;
}

/* Finds the nearest point that is nearer than sqrt(f->square): nearer halves first. */
static void search(const struct obstacle_mesh *m, const double x[3], struct foot *f)
{
    struct {
        int box;
        double square;
    } stack[STACK] = {{0, square_to_box(&m->box[0], x)}};
    int depth = 1;

    while (depth > 0) {
        const int n = stack[--depth].box, leaf = n - (m->leaves - 1);
        if (stack[depth].square >= f->square)
            continue;
        if (leaf >= 0) {
            for (int t = first_of(m, leaf); t < first_of(m, leaf + 1); t++)
                try_triangle(m, x, t, f);
            continue;
        }
        for (int k = 1; k <= 2; k++) {
            stack[depth + k - 1].box = 2 * n + k;
            stack[depth + k - 1].square = square_to_box(&m->box[2 * n + k], x);
        }
        if (stack[depth].square < stack[depth + 1].square) {
            const __typeof__(stack[0]) nearer = stack[depth];
            stack[depth] = stack[depth + 1], stack[depth + 1] = nearer;
        }
        depth += 2;
    }
}

/* Computes the sum of normals at a foot, 0 on a rim. */
static void pseudonormal(const struct obstacle_mesh *m, const struct foot *f, double n[3])
{
    const int t = f->triangle;

    if (f->on == FOOT_EDGE)
        body_mesh_edge(m, 3 * t + f->k, n);
    else
        memcpy(n, f->on == FOOT_FACE ? m->face[t] : m->bend[m->corner[t][f->k]],
               sizeof *m->face);
}

double body_mesh_distance(const struct obstacle_mesh *mesh, const double x[3], double most,
                          double normal[3])
{
    struct foot f = {.square = INFINITY, .triangle = -1};
    const double off = sqrt(square_to_box(&mesh->box[0], x));
    double n[3], way[3];

    if (!isfinite(vector_dot(x, x)))
        return vector_dot(x, x);
    if (mesh->outward && off > 0 && off >= most)
        return off;
    search(mesh, x, &f);
    pseudonormal(mesh, &f, n);
    vector_between(f.place, x, way);
    const double distance = sqrt(f.square), sign = vector_dot(way, n) < 0 ? -1 : 1;
    const double size = vector_distance(mesh->box[0].lo, mesh->box[0].hi);
    const double *along = mesh->face[f.triangle];
    double scale = 1;
    if (f.on != FOOT_FACE && distance > TOUCHING * size)
        along = way, scale = sign / distance;
    else if (f.on != FOOT_FACE && vector_dot(n, n) > 0)
        along = n, scale = 1 / vector_length(n);
    for (int i = 0; normal && i < 3; i++)
        normal[i] = scale * along[i];
    return sign * distance;
}

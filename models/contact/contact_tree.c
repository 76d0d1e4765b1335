#include "models/contact/contact_tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/each.h"
#include "models/room.h"
#include "models/vector.h"

/* The components of a box. */
enum { PLACE = 0, ALONG_U = 3, ALONG_V = 6, MOTION = 9, COMPONENTS = 12 };
struct contact_box {
    double low[COMPONENTS], high[COMPONENTS];
};

enum { PARALLEL = 1000 }; /* boxes from which threads are worth their start             */

void contact_tree_clear(struct contact_tree *t)
{
    mesh_patches_clear(&t->patches);
    free(t->room);
    memset(t, 0, sizeof *t);
}

static bool meshed(const struct contact_tree *t)
{
    return t->patches.order;
}

enum status contact_tree_init(struct contact_tree *t, const struct contact_surface *s,
                              double apart)
{
    int n[2] = {s->points[0] - 1, s->points[1] - 1};
    size_t count = 0, start[32] = {0};
    enum status st;

    *t = (struct contact_tree){.surface = s, .apart = apart};
    if (s->mesh.count)
        n[0] = s->mesh.count, n[1] = 1;
    for (;;) {
        t->level[t->levels] = (struct contact_tree_level){{n[0], n[1]}, NULL};
        start[t->levels] = count;
        count += t->levels++ ? (size_t)n[0] * n[1] : 0;
        if (n[0] == 1 && n[1] == 1)
            break;
        n[0] = (n[0] + 1) / 2, n[1] = (n[1] + 1) / 2;
    }
    TRY(room_cut(&t->room, ROOM(t->boxes, count), ROOM(t->per_length[0], s->points[0]),
                 ROOM(t->per_length[1], s->points[1]), ROOM(t->flat, s->count)));
    for (int l = 1; l < t->levels; l++)
        t->level[l].box = t->boxes + start[l];
    for (int d = 0; d < 2; d++)
        for (int k = 0; !s->mesh.count && k + 1 < s->points[d]; k++)
            t->per_length[d][k] = 1 / (s->flat[d][k + 1] - s->flat[d][k]);
    for (int k = 0; k < s->count; k++)
        if (s->mesh.start)
            memcpy(t->flat[k], s->mesh.start[k], sizeof t->flat[k]);
        else if (s->mesh.count)
            memcpy(t->flat[k], s->mesh.at[k], sizeof s->mesh.at[k]);
        else
            for (int d = 0; d < 2; d++)
                t->flat[k][d] = s->flat[d][d ? k % s->points[1] : k / s->points[1]];
    if (s->mesh.count)
        TRY(mesh_patches_init(&t->patches, &s->mesh, s->count));
out:
    return st;
}

int contact_tree_triangle(const struct contact_tree *t, int cell)
{
    return meshed(t) ? t->patches.order[cell]
                     : 2 * (cell + cell / (t->surface->points[1] - 1));
}

int contact_tree_samples(const struct contact_tree *t, int cell, int sample[4])
{
    if (meshed(t))
        return mesh_cells_points(&t->surface->mesh, t->patches.order[cell], sample);
    const int m = t->surface->points[1], i = cell / (m - 1), j = cell % (m - 1);
    const bool last_u = (i + 2) % t->surface->rows == 0, last_v = j + 2 == m;
    int count = 0;

    sample[count++] = i * m + j;
    if (last_u)
        sample[count++] = (i + 1) * m + j;
    if (last_v)
        sample[count++] = i * m + j + 1;
    if (last_u && last_v)
        sample[count++] = (i + 1) * m + j + 1;
    return count;
}

int contact_tree_edges(const struct contact_tree *t, int cell, int edge[5][2])
{
    if (meshed(t))
        return mesh_cells_edges(&t->surface->mesh, t->patches.order[cell], edge);
    const int m = t->surface->points[1], i = cell / (m - 1), j = cell % (m - 1);
    const int c = i * m + j;
    const int all[5][2] = {
        {c, c + m}, {c, c + 1}, {c, c + m + 1}, {c + m, c + m + 1}, {c + 1, c + m + 1}};
    int count = 0;

    for (int k = 0; k < 5; k++)
        if (k < 3 || (k == 3 ? (i + 2) % t->surface->rows == 0 : j + 2 == m)) {
            edge[count][0] = all[k][0];
            edge[count++][1] = all[k][1];
        }
    return count;
}

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

static void take(struct contact_box *box, int first, const double a[3])
{
    for (int i = first; i < first + 3; i++) {
        const double x = a[i - first];
        box->low[i] = x < box->low[i] ? x : box->low[i];
        box->high[i] = x > box->high[i] ? x : box->high[i];
    }
}

static void join(struct contact_box *box, const struct contact_box *other, int first,
                 int end)
{
    for (int i = first; i < end; i++) {
        box->low[i] = other->low[i] < box->low[i] ? other->low[i] : box->low[i];
        box->high[i] = other->high[i] > box->high[i] ? other->high[i] : box->high[i];
    }
}

/* Sets a part of a box to the hull of the differences of two pairs of samples. */
static void set_slopes(struct contact_box *box, int first, const double *y, long step,
                       long other, double per_length)
{
    for (int i = 0; i < 3; i++) {
        const double a = (y[3 * step + i] - y[i]) * per_length;
        const double b = (y[3 * (other + step) + i] - y[3 * other + i]) * per_length;
        box->low[first + i] = a < b ? a : b;
        box->high[first + i] = a < b ? b : a;
    }
}

/* Sets a part of a box to the hull of a vector at the corners of a cell. */
static void set_corners(struct contact_box *box, int first, const double *a,
                        const int corner[4])
{
    memcpy(box->low + first, a + 3 * (long)corner[0], 3 * sizeof *a);
    memcpy(box->high + first, a + 3 * (long)corner[0], 3 * sizeof *a);
    for (int k = 1; k < 4; k++)
        take(box, first, a + 3 * (long)corner[k]);
}

static void fit_places(const struct contact_tree *t, int cell, struct contact_box *box)
{
    int corner[4];

    contact_tree_corners(t, cell, corner);
    set_corners(box, PLACE, t->y, corner);
    if (t->d)
        set_corners(box, MOTION, t->d, corner);
}

static void fit_slopes(const struct contact_tree *t, int cell, struct contact_box *box)
{
    if (t->surface->mesh.start) { /* no part counts as flat */
        memset(box->low + ALONG_U, 0, (MOTION - ALONG_U) * sizeof *box->low);
        memset(box->high + ALONG_U, 0, (MOTION - ALONG_U) * sizeof *box->high);
        return;
    }
    if (meshed(t)) {
        mesh_cells_slopes(&t->surface->mesh, t->y, t->patches.order[cell],
                          box->low + ALONG_U, box->low + ALONG_V);
        memcpy(box->high + ALONG_U, box->low + ALONG_U, 6 * sizeof *box->low);
        return;
    }
    const int m = t->surface->points[1], i = cell / (m - 1), j = cell % (m - 1);
    const double *y = t->y + 3 * ((long)i * m + j);

    set_slopes(box, ALONG_U, y, m, 1, t->per_length[0][i]);
    set_slopes(box, ALONG_V, y, 1, m, t->per_length[1][j]);
}

/* Returns a box for its slopes, in `own` if it is that of a cell. */
static const struct contact_box *slopes_at(const struct contact_tree *t, int l, int n,
                                           struct contact_box *own)
{
    if (l > 0)
        return &t->level[l].box[n];
    fit_slopes(t, n, own);
    return own;
}

/* Finds the children of box n of level l in the level below; returns how many. Of the cells
 * those between two sheets are none. */
static int children(const struct contact_tree *t, int l, int n, int child[4])
{
    const struct contact_tree_level *below = &t->level[l - 1];
    const int i = n / t->level[l].n[1], j = n % t->level[l].n[1];
    int count = 0;

    for (int k = 0; k < 4; k++) {
        const int p = 2 * i + k / 2, q = 2 * j + k % 2;
        if (p < below->n[0] && q < below->n[1] &&
            !(l == 1 && contact_surface_cut(t->surface, p)))
            child[count++] = p * below->n[1] + q;
    }
    return count;
}

/* The boxes of a level of a tree that are fitted. */
struct level {
    const struct contact_tree *tree;
    int number, components;
};

/* Fits a box around its children. */
static void fit_box(void *self, long n)
{
    const struct level *level = self;
    const struct contact_tree *t = level->tree;
    const int l = level->number;
    struct contact_box *box = &t->level[l].box[n];
    int child[4];
    const int parts = children(t, l, (int)n, child);

    for (int k = 0; k < parts; k++) {
        struct contact_box own, *part = l > 1 ? &t->level[l - 1].box[child[k]] : &own;
        if (l == 1) {
            fit_places(t, child[k], part);
            fit_slopes(t, child[k], part);
        }
        if (k == 0)
            *box = *part;
        else
            join(box, part, 0, level->components);
    }
}

void contact_tree_fit(struct contact_tree *t, const double *y, const double *d)
{
    t->y = y, t->d = d;
    for (int l = 1; l < t->levels; l++) {
        const int count = t->level[l].n[0] * t->level[l].n[1];
        struct level level = {t, l, d ? COMPONENTS : MOTION};
        each_turn(count, count >= PARALLEL, fit_box, &level);
    }
}

/* Returns a bound on the part along the plane across n of a vector in a box around 0. */
static double radius(const double half[3], const double n[3])
{
    const double square = vector_dot(n, n);
    double along = 0;

    for (int i = 0; i < 3; i++)
        along += half[i] * sqrt(square > 0 ? 1 - n[i] * n[i] / square : 1);
    return smaller(along, vector_length(half));
}

/* Returns the share of a distance along the sheet that two points of a part are at least
 * apart; may be negative. */
static double flatness(const struct contact_box *box)
{
    double a[3], b[3], half[2][3], n[3];

    for (int i = 0; i < 3; i++) {
        const int u = ALONG_U + i, v = ALONG_V + i;
        a[i] = (box->low[u] + box->high[u]) / 2;
        b[i] = (box->low[v] + box->high[v]) / 2;
        half[0][i] = box->high[u] - a[i];
        half[1][i] = box->high[v] - b[i];
    }
    vector_cross(a, b, n);
    const double aa = vector_dot(a, a), ab = vector_dot(a, b), bb = vector_dot(b, b);
    const double least = (aa + bb) / 2 - sqrt((aa - bb) * (aa - bb) / 4 + ab * ab);
    const double of_a = radius(half[0], n), of_b = radius(half[1], n);
    return (least > 0 ? sqrt(least) : 0) - sqrt(of_a * of_a + of_b * of_b);
}

/* A box of a level by its number. */
struct part {
    int n;
    const struct contact_box *box;
};

/* Returns gap_of_neighbours on a mesh, where lines between both stay on the sheet. */
static double gap_in_patch(const struct contact_tree *t, int l, int p, int q)
{
    const struct contact_box *box = t->level[l].box;
    const int *near, *end;
    struct contact_box hull;
    double part[4];

    if (l == 0 || !mesh_patches_between(&t->patches, l, p, q, part, &near, &end))
        return 0;
    hull = box[p];
    for (; near < end; near++)
        if (mesh_patches_meets(&t->patches, l, *near, part))
            join(&hull, &box[*near], ALONG_U, MOTION);
    return t->apart * flatness(&hull);
}

/* Tells whether boxes of a level from row p to q reach over several sheets. */
static bool of_sheets(const struct contact_tree *t, int l, int p, int q)
{
    const int rows = t->surface->rows, end = t->surface->points[0] - 1;
    const int last = (q + 1) << l < end ? (q + 1) << l : end;

    return rows <= end && (p << l) / rows != last / rows;
}

/* Returns how far points of two boxes of a level, neighbours or the same, that lie at least
 * t->apart along the sheet from each other are apart in space. */
static double gap_of_neighbours(const struct contact_tree *t, int l, const struct part *p,
                                const struct part *q)
{
    const int wide = t->level[l].n[1];
    const int di = q->n / wide - p->n / wide, dj = q->n % wide - p->n % wide;
    const int first = di < 0 ? q->n / wide : p->n / wide;
    struct contact_box hull, own;

    if (meshed(t))
        return gap_in_patch(t, l, p->n, q->n);
    if (abs(di) > 1 || abs(dj) > 1 || of_sheets(t, l, first, first + abs(di)))
        return 0;
    hull = *slopes_at(t, l, p->n, &own);
    join(&hull, slopes_at(t, l, q->n, &own), ALONG_U, MOTION);
    if (di && dj) {
        join(&hull, slopes_at(t, l, p->n + dj, &own), ALONG_U, MOTION);
        join(&hull, slopes_at(t, l, q->n - dj, &own), ALONG_U, MOTION);
    }
    return t->apart * flatness(&hull);
}

/* Tells whether two boxes are at least `reach` apart. */
static bool boxes_apart(const struct contact_box *p, const struct contact_box *q,
                        double reach)
{
    double square = 0;

    for (int i = 0; i < 3; i++) {
        const double gap = larger(p->low[i] - q->high[i], q->low[i] - p->high[i]);
        if (gap >= reach)
            return true;
        square += gap > 0 ? gap * gap : 0;
    }
    return square >= reach * reach;
}

/* Returns how far points of two boxes move relative to each other, at most. */
static double motion(const struct contact_box *p, const struct contact_box *q)
{
    double way[3];

    for (int i = 0; i < 3; i++)
        way[i] = larger(p->high[MOTION + i] - q->low[MOTION + i],
                        q->high[MOTION + i] - p->low[MOTION + i]);
    return vector_length(way);
}

static bool left_out(const struct contact_tree *t, const struct contact_tree_search *search,
                     int l, const struct part *p, const struct part *q)
{
    const double reach =
        search->reach + (t->d ? search->share * motion(p->box, q->box) : 0);

    return boxes_apart(p->box, q->box, reach) || gap_of_neighbours(t, l, p, q) >= reach;
}

/* Finds the parts of a box of level l, in `own` if they are cells; returns how many. */
static int open_box(const struct contact_tree *t, int l, int n, struct part part[4],
                    struct contact_box own[4])
{
    int child[4];
    const int count = children(t, l, n, child);

    for (int k = 0; k < count; k++) {
        if (l == 1)
            fit_places(t, child[k], &own[k]);
        part[k] =
            (struct part){child[k], l == 1 ? &own[k] : &t->level[l - 1].box[child[k]]};
    }
    return count;
}

/* Visits pairs of cells, one below the box p, one below the box q of level l. */
static enum status across(const struct contact_tree *t, struct contact_tree_search *search,
                          int l, const struct part *p, const struct part *q)
{
    enum status st = STATUS_OK;
    struct part of_p[4], of_q[4];
    struct contact_box own[2][4];

    if (left_out(t, search, l, p, q))
        return STATUS_OK;
    if (l == 0)
        return search->visit(search, p->n, q->n);
    const int p_count = open_box(t, l, p->n, of_p, own[0]);
    const int q_count = open_box(t, l, q->n, of_q, own[1]);
    for (int i = 0; i < p_count; i++)
        for (int j = 0; j < q_count; j++)
            TRY(across(t, search, l - 1, &of_p[i], &of_q[j]));
out:
    return st;
}

/* Visits pairs of cells both below a box of level l. */
static enum status inside(const struct contact_tree *t, struct contact_tree_search *search,
                          int l, const struct part *p)
{
    enum status st = STATUS_OK;
    struct part part[4];
    struct contact_box own[4];

    if (left_out(t, search, l, p, p))
        return STATUS_OK;
    if (l == 0)
        return search->visit(search, p->n, p->n);
    const int count = open_box(t, l, p->n, part, own);
    for (int i = 0; i < count; i++) {
        TRY(inside(t, search, l - 1, &part[i]));
        for (int j = i + 1; j < count; j++)
            TRY(across(t, search, l - 1, &part[i], &part[j]));
    }
out:
    return st;
}

enum status contact_tree_visit(const struct contact_tree *t,
                               struct contact_tree_search *search)
{
    struct contact_box own;
    const int top = t->levels - 1;
    const struct part all = {0, top ? t->level[top].box : &own};

    if (!top)
        fit_places(t, 0, &own);
    return inside(t, search, top, &all);
}

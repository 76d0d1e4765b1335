#include "models/contact/contact_tree.h"

#include <stdlib.h>

#include "models/vector.h"

/* The components of a box. */
enum { PLACE = 0, ALONG_U = 3, ALONG_V = 6, MOTION = 9, COMPONENTS = 12 };
struct contact_box {
    double low[COMPONENTS], high[COMPONENTS];
};

enum { PARALLEL = 2000 }; /* cells from which threads are worth their start             */

void contact_tree_clear(struct contact_tree *t)
{
    free(t->boxes);
    memset(t, 0, sizeof *t);
}

enum status contact_tree_init(struct contact_tree *t, const struct contact_surface *s,
                              double apart)
{
    int n[2] = {s->points[0] - 1, s->points[1] - 1};
    size_t count = 0, start[32];

    *t = (struct contact_tree){.surface = s, .apart = apart};
    for (;;) {
        t->level[t->levels] = (struct contact_tree_level){{n[0], n[1]}, NULL};
        start[t->levels++] = count;
        count += (size_t)n[0] * n[1];
        if (n[0] == 1 && n[1] == 1)
            break;
        n[0] = (n[0] + 1) / 2, n[1] = (n[1] + 1) / 2;
    }
    t->boxes = malloc(count * sizeof *t->boxes);
    if (!t->boxes)
        return STATUS_MEMORY;
    for (int l = 0; l < t->levels; l++)
        t->level[l].box = t->boxes + start[l];
    return STATUS_OK;
}

static void take(struct contact_box *box, int first, const double a[3])
{
    for (int i = first; i < first + 3; i++) {
        const double x = a[i - first];
        box->low[i] = x < box->low[i] ? x : box->low[i];
        box->high[i] = x > box->high[i] ? x : box->high[i];
    }
}

static void join(struct contact_box *box, const struct contact_box *other, int count)
{
    for (int i = 0; i < count; i++) {
        box->low[i] = other->low[i] < box->low[i] ? other->low[i] : box->low[i];
        box->high[i] = other->high[i] > box->high[i] ? other->high[i] : box->high[i];
    }
}

static void slope(const double *y, long from, long to, double length, double d[3])
{
    for (int i = 0; i < 3; i++)
        d[i] = (y[3 * to + i] - y[3 * from + i]) / length;
}

/* Takes a vector at the four corners of a cell. */
static void take_corners(struct contact_box *box, int first, const double *a, long corner,
                         long m)
{
    memcpy(box->low + first, a + 3 * corner, 3 * sizeof *a);
    memcpy(box->high + first, a + 3 * corner, 3 * sizeof *a);
    take(box, first, a + 3 * (corner + 1));
    take(box, first, a + 3 * (corner + m));
    take(box, first, a + 3 * (corner + m + 1));
}

static void fit_cells(struct contact_tree *t, int i, const double *y, const double *d)
{
    const struct contact_surface *s = t->surface;
    const long m = s->points[1];
    const double du = s->flat[0][i + 1] - s->flat[0][i];

    for (int j = 0; j + 1 < m; j++) {
        const long corner = i * m + j;
        const double dv = s->flat[1][j + 1] - s->flat[1][j];
        struct contact_box *box = &t->level[0].box[i * (m - 1) + j];
        double along[3];
        take_corners(box, PLACE, y, corner, m);
        slope(y, corner, corner + m, du, along);
        memcpy(box->low + ALONG_U, along, sizeof along);
        memcpy(box->high + ALONG_U, along, sizeof along);
        slope(y, corner + 1, corner + m + 1, du, along);
        take(box, ALONG_U, along);
        slope(y, corner, corner + 1, dv, along);
        memcpy(box->low + ALONG_V, along, sizeof along);
        memcpy(box->high + ALONG_V, along, sizeof along);
        slope(y, corner + m, corner + m + 1, dv, along);
        take(box, ALONG_V, along);
        if (d)
            take_corners(box, MOTION, d, corner, m);
    }
}

/* Finds the children of box n of level l in the level below; returns how many. */
static int children(const struct contact_tree *t, int l, int n, int child[4])
{
    const struct contact_tree_level *below = &t->level[l - 1];
    const int i = n / t->level[l].n[1], j = n % t->level[l].n[1];
    int count = 0;

    for (int k = 0; k < 4; k++) {
        const int p = 2 * i + k / 2, q = 2 * j + k % 2;
        if (p < below->n[0] && q < below->n[1])
            child[count++] = p * below->n[1] + q;
    }
    return count;
}

void contact_tree_fit(struct contact_tree *t, const double *y, const double *d)
{
    const int cells = t->level[0].n[0] * t->level[0].n[1];
    const int components = d ? COMPONENTS : MOTION;

    t->moves = d;
#pragma omp parallel for if (cells >= PARALLEL)
    for (int i = 0; i < t->level[0].n[0]; i++)
        fit_cells(t, i, y, d);
    for (int l = 1; l < t->levels; l++) {
        const struct contact_tree_level *level = &t->level[l];
        const int count = level->n[0] * level->n[1];
#pragma omp parallel for if (count >= PARALLEL)
        for (int n = 0; n < count; n++) {
            int child[4];
            const int parts = children(t, l, n, child);
            level->box[n] = t->level[l - 1].box[child[0]];
            for (int k = 1; k < parts; k++)
                join(&level->box[n], &t->level[l - 1].box[child[k]], components);
        }
    }
}

/* Returns the share of a distance along the sheet that two points of a part are at least
 * apart; may be negative. */
static double flatness(const struct contact_box *box)
{
    double a[3], b[3], radius = 0;

    for (int i = 0; i < 3; i++) {
        const int u = ALONG_U + i, v = ALONG_V + i;
        a[i] = (box->low[u] + box->high[u]) / 2;
        b[i] = (box->low[v] + box->high[v]) / 2;
        radius += (box->high[u] - a[i]) * (box->high[u] - a[i]) +
                  (box->high[v] - b[i]) * (box->high[v] - b[i]);
    }
    const double aa = vector_dot(a, a), ab = vector_dot(a, b), bb = vector_dot(b, b);
    const double least = (aa + bb) / 2 - sqrt((aa - bb) * (aa - bb) / 4 + ab * ab);
    return (least > 0 ? sqrt(least) : 0) - sqrt(radius);
}

/* Returns how far points of two boxes of a level, neighbours or the same, that lie at least
 * t->apart along the sheet from each other are apart in space. */
static double gap_of_neighbours(const struct contact_tree *t, int l, int m, int n)
{
    const struct contact_tree_level *level = &t->level[l];
    const int wide = level->n[1], di = n / wide - m / wide, dj = n % wide - m % wide;
    struct contact_box hull = level->box[m];

    if (abs(di) > 1 || abs(dj) > 1)
        return 0;
    if (m != n)
        join(&hull, &level->box[n], MOTION);
    if (di && dj) {
        join(&hull, &level->box[m + dj], MOTION);
        join(&hull, &level->box[n - dj], MOTION);
    }
    return t->apart * flatness(&hull);
}

/* Returns the distance of two boxes. */
static double gap_of_boxes(const struct contact_box *p, const struct contact_box *q)
{
    double square = 0;

    for (int i = 0; i < 3; i++) {
        const double above = p->low[i] - q->high[i], below = q->low[i] - p->high[i];
        const double gap = above > below ? above : below;
        square += gap > 0 ? gap * gap : 0;
    }
    return sqrt(square);
}

/* Returns how far points of two boxes move relative to each other, at most. */
static double motion(const struct contact_box *p, const struct contact_box *q)
{
    double way[3];

    for (int i = 0; i < 3; i++)
        way[i] = fmax(p->high[MOTION + i] - q->low[MOTION + i],
                      q->high[MOTION + i] - p->low[MOTION + i]);
    return vector_length(way);
}

static bool left_out(const struct contact_tree *t, const struct contact_tree_search *search,
                     int l, int m, int n)
{
    const struct contact_box *p = &t->level[l].box[m], *q = &t->level[l].box[n];
    const double reach = search->reach + (t->moves ? search->share * motion(p, q) : 0);

    return gap_of_boxes(p, q) >= reach || gap_of_neighbours(t, l, m, n) >= reach;
}

/* Visits pairs of cells, one below box m, one below box n of level l. */
static enum status across(const struct contact_tree *t, struct contact_tree_search *search,
                          int l, int m, int n)
{
    enum status st = STATUS_OK;
    int of_m[4], of_n[4];

    if (left_out(t, search, l, m, n))
        return STATUS_OK;
    if (l == 0)
        return search->visit(search, m, n);
    const int m_count = children(t, l, m, of_m), n_count = children(t, l, n, of_n);
    for (int i = 0; i < m_count; i++)
        for (int j = 0; j < n_count; j++)
            TRY(across(t, search, l - 1, of_m[i], of_n[j]));
out:
    return st;
}

/* Visits pairs of cells both below box n of level l. */
static enum status inside(const struct contact_tree *t, struct contact_tree_search *search,
                          int l, int n)
{
    enum status st = STATUS_OK;
    int child[4];

    if (left_out(t, search, l, n, n))
        return STATUS_OK;
    if (l == 0)
        return search->visit(search, n, n);
    const int count = children(t, l, n, child);
    for (int i = 0; i < count; i++) {
        TRY(inside(t, search, l - 1, child[i]));
        for (int j = i + 1; j < count; j++)
            TRY(across(t, search, l - 1, child[i], child[j]));
    }
out:
    return st;
}

enum status contact_tree_visit(const struct contact_tree *t,
                               struct contact_tree_search *search)
{
    return inside(t, search, t->levels - 1, 0);
}

#include "models/contact/contact_tree.h"

#include <stdlib.h>

#include "models/vector.h"

/* The components of a box. */
enum { PLACE = 0, ALONG_U = 3, ALONG_V = 6, MOTION = 9, COMPONENTS = 12 };
struct contact_box {
    double low[COMPONENTS], high[COMPONENTS];
};

enum { PARALLEL = 1000 }; /* boxes from which threads are worth their start             */

void contact_tree_clear(struct contact_tree *t)
{
    free(t->boxes);
    free(t->per_length[0]);
    memset(t, 0, sizeof *t);
}

enum status contact_tree_init(struct contact_tree *t, const struct contact_surface *s,
                              double apart)
{
    int n[2] = {s->points[0] - 1, s->points[1] - 1};
    size_t count = 0, start[32] = {0};

    *t = (struct contact_tree){.surface = s, .apart = apart};
    for (;;) {
        t->level[t->levels] = (struct contact_tree_level){{n[0], n[1]}, NULL};
        start[t->levels] = count;
        count += t->levels++ ? (size_t)n[0] * n[1] : 0;
        if (n[0] == 1 && n[1] == 1)
            break;
        n[0] = (n[0] + 1) / 2, n[1] = (n[1] + 1) / 2;
    }
    t->boxes = malloc((count + 1) * sizeof *t->boxes);
    t->per_length[0] = malloc((s->points[0] + s->points[1]) * sizeof(double));
    if (!t->boxes || !t->per_length[0]) {
        contact_tree_clear(t);
        return STATUS_MEMORY;
    }
    t->per_length[1] = t->per_length[0] + s->points[0];
    for (int d = 0; d < 2; d++)
        for (int k = 0; k + 1 < s->points[d]; k++)
            t->per_length[d][k] = 1 / (s->flat[d][k + 1] - s->flat[d][k]);
    for (int l = 1; l < t->levels; l++)
        t->level[l].box = t->boxes + start[l];
    return STATUS_OK;
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

static void join(struct contact_box *box, const struct contact_box *other, int count)
{
    for (int i = 0; i < count; i++) {
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

/* Sets a part of a box to the hull of a vector at the four corners of a cell. */
static void set_corners(struct contact_box *box, int first, const double *a, long m)
{
    memcpy(box->low + first, a, 3 * sizeof *a);
    memcpy(box->high + first, a, 3 * sizeof *a);
    take(box, first, a + 3);
    take(box, first, a + 3 * m);
    take(box, first, a + 3 * (m + 1));
}

static void fit_cell(const struct contact_tree *t, int cell, struct contact_box *box)
{
    const int m = t->surface->points[1], i = cell / (m - 1), j = cell % (m - 1);
    const double *y = t->y + 3 * ((long)i * m + j);

    set_corners(box, PLACE, y, m);
    set_slopes(box, ALONG_U, y, m, 1, t->per_length[0][i]);
    set_slopes(box, ALONG_V, y, 1, m, t->per_length[1][j]);
    if (t->d)
        set_corners(box, MOTION, t->d + 3 * ((long)i * m + j), m);
}

/* Returns a box, in `own` if it is that of a cell. */
static const struct contact_box *box_at(const struct contact_tree *t, int l, int n,
                                        struct contact_box *own)
{
    if (l > 0)
        return &t->level[l].box[n];
    fit_cell(t, n, own);
    return own;
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
    const int components = d ? COMPONENTS : MOTION;

    t->y = y, t->d = d;
    for (int l = 1; l < t->levels; l++) {
        const struct contact_tree_level *level = &t->level[l];
        const int count = level->n[0] * level->n[1];
#pragma omp parallel for if (count >= PARALLEL)
        for (int n = 0; n < count; n++) {
            struct contact_box own, *box = &level->box[n];
            int child[4];
            const int parts = children(t, l, n, child);
            *box = *box_at(t, l - 1, child[0], &own);
            for (int k = 1; k < parts; k++)
                join(box, box_at(t, l - 1, child[k], &own), components);
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
static double gap_of_neighbours(const struct contact_tree *t, int l, int m, int n,
                                const struct contact_box *p, const struct contact_box *q)
{
    const int wide = t->level[l].n[1], di = n / wide - m / wide, dj = n % wide - m % wide;
    struct contact_box hull = *p, own;

    if (abs(di) > 1 || abs(dj) > 1)
        return 0;
    join(&hull, q, MOTION);
    if (di && dj) {
        join(&hull, box_at(t, l, m + dj, &own), MOTION);
        join(&hull, box_at(t, l, n - dj, &own), MOTION);
    }
    return t->apart * flatness(&hull);
}

/* Returns the distance of two boxes. */
static double gap_of_boxes(const struct contact_box *p, const struct contact_box *q)
{
    double square = 0;

    for (int i = 0; i < 3; i++) {
        const double gap = larger(p->low[i] - q->high[i], q->low[i] - p->high[i]);
        square += gap > 0 ? gap * gap : 0;
    }
    return sqrt(square);
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
                     int l, int m, int n)
{
    struct contact_box of_m, of_n;
    const struct contact_box *p = box_at(t, l, m, &of_m), *q = box_at(t, l, n, &of_n);
    const double reach = search->reach + (t->d ? search->share * motion(p, q) : 0);

    return gap_of_boxes(p, q) >= reach || gap_of_neighbours(t, l, m, n, p, q) >= reach;
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

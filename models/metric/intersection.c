#include "models/metric/intersection.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/grid.h"
#include "models/metric/triangle.h"
#include "models/vector.h"

/* Pairs of cells tested at a time, so that memory does not grow with overlaps. */
enum { CANDIDATES = 1 << 15, FIRST_PAIRS = 1024 };

/* Coordinates below this share of the largest become 0; the others suit predicate.h. */
static const double negligible = 0x1p-247;

/* The largest distance of the first and the last row of a closed grid, of coordinates of
 * about 1: the round-off of a few sums. */
static const double same = 1e-13;

void intersection_clear(struct intersection *s)
{
    free(s->pairs);
    free(s->point);
    free(s->boxes);
    free(s->candidate);
    free(s->hit);
    memset(s, 0, sizeof *s);
}

void intersection_corners(int n_u, int triangle, int corner[3])
{
    int cell = triangle / 2, first = cell / (n_u - 1) * n_u + cell % (n_u - 1);

    corner[0] = first;
    corner[1] = triangle % 2 ? first + n_u + 1 : first + 1;
    corner[2] = triangle % 2 ? first + n_u : first + n_u + 1;
}

/* Tells whether a cell of the grid lies between two sheets, or has a corner that is beside
 * one. */
static bool is_void(const struct intersection *s, int cell)
{
    const int column = cell % (s->n_u - 1), i = s->step * column;
    const double *p = s->point + 3L * (cell / (s->n_u - 1) * s->n_u + column);

    if (s->sparse && isnan(p[0] + p[3] + p[3L * s->n_u] + p[3L * s->n_u + 3]))
        return true;
    return s->sheets > 1 && grid_sheet(s->sheets, i) != grid_sheet(s->sheets, i + s->step);
}

bool intersection_triangle(const struct intersection *s, int triangle, int corner[3])
{
    if (s->corner)
        memcpy(corner, s->corner[triangle], 3 * sizeof *corner);
    else
        intersection_corners(s->n_u, triangle, corner);
    for (int k = 0; k < 3 && s->closed; k++)
        corner[k] %= s->n_u * (s->n_v - 1);
    return s->corner || !is_void(s, triangle / 2);
}

/* Counts the boxes of all levels over so many cells. */
static long box_count(int n_u, int n_v)
{
    long count = 0;

    for (; n_u > 1 || n_v > 1; n_u = (n_u + 1) / 2, n_v = (n_v + 1) / 2)
        count += (long)n_u * n_v;
    return count + 1;
}

static enum status make_room(struct intersection *s, long boxes)
{
    const long points = s->points, room = points > boxes ? points : boxes;

    if (!s->candidate)
        s->candidate = malloc(CANDIDATES * sizeof *s->candidate);
    if (!s->hit)
        s->hit = malloc(CANDIDATES);
    if (room > s->room) {
        free(s->point);
        free(s->boxes);
        s->point = malloc(room * 3 * sizeof *s->point);
        s->boxes = malloc(room * sizeof *s->boxes);
        s->room = s->point && s->boxes ? room : 0;
    }
    return s->candidate && s->hit && s->room ? STATUS_OK : STATUS_MEMORY;
}

/* Copies the points, scaled by a power of two so that the largest coordinate is near 1, and
 * shaken: along a direction without meaning (the plastic number's powers), in proportion to
 * a point's number, so that parts of a sheet that lie on each other move apart as wholes.
 */
static enum status scale_points(struct intersection *s, const double *xyz)
{
    static const double direction[3] = {1, .7548776662466927, .5698402909980532};
    const long n = 3 * s->points;
    double size = 0;
    int exponent;

    for (long i = 0; i < n; i++) {
        if (!isfinite(xyz[i]) && !(s->sparse && isnan(xyz[i])))
            return STATUS_NAN;
        size = fmax(size, fabs(xyz[i]));
    }
    frexp(size, &exponent);
    s->scale = ldexp(1, exponent);
    for (long i = 0; i < n; i++) {
        const double along = s->shake * (double)(i / 3) / (double)s->points;
        const double x = ldexp(xyz[i] + along * direction[i % 3], -exponent);
        s->point[i] = fabs(x) < negligible ? 0 : x;
    }
    return STATUS_OK;
}

static void join(double box[6], const double low[3], const double high[3])
{
    for (int c = 0; c < 3; c++) {
        box[c] = low[c] < box[c] ? low[c] : box[c];
        box[3 + c] = high[c] > box[3 + c] ? high[c] : box[3 + c];
    }
}

/* Fits boxes around cells; those between two sheets are empty and meet none. */
static void fit_cells(const struct intersection *s, const struct intersection_level *cells)
{
    static const double empty[6] = {INFINITY,  INFINITY,  INFINITY,
                                    -INFINITY, -INFINITY, -INFINITY};

    for (int j = 0; j < cells->n_v; j++)
        for (int i = 0; i < cells->n_u; i++) {
            const double *p = s->point + 3 * ((long)j * s->n_u + i), *q = p + 3 * s->n_u;
            double *box = cells->box[(long)j * cells->n_u + i];
            memcpy(box, empty, sizeof empty);
            if (is_void(s, j * cells->n_u + i))
                continue;
            join(box, p, p);
            join(box, p + 3, p + 3);
            join(box, q, q);
            join(box, q + 3, q + 3);
        }
}

static void fit_triangles(const struct intersection *s,
                          const struct intersection_level *triangles)
{
    for (int n = 0; n < triangles->n_u; n++) {
        double *box = triangles->box[n];
        for (int i = 0; i < 3; i++) {
            const double *x = s->point + 3L * s->corner[n][i];
            if (i == 0)
                memcpy(box, x, 3 * sizeof *box), memcpy(box + 3, x, 3 * sizeof *box);
            join(box, x, x);
        }
    }
}

static void fit_parents(const struct intersection_level *below,
                        const struct intersection_level *above)
{
    for (int j = 0; j < above->n_v; j++)
        for (int i = 0; i < above->n_u; i++) {
            double *box = above->box[(long)j * above->n_u + i];
            memcpy(box, below->box[2L * j * below->n_u + 2 * i], 6 * sizeof *box);
            for (int k = 1; k < 4; k++) {
                int p = 2 * i + k % 2, q = 2 * j + k / 2;
                if (p < below->n_u && q < below->n_v) {
                    const double *child = below->box[(long)q * below->n_u + p];
                    join(box, child, child + 3);
                }
            }
        }
}

/* Fits boxes around the n_u x n_v cells, around 2 x 2 of those, and so on to a single one;
 * the cells of a mesh are its triangles, in one row. */
static void fit_boxes(struct intersection *s, int n_u, int n_v)
{
    double(*box)[6] = s->boxes;

    for (s->levels = 0;; s->levels++) {
        struct intersection_level *level = &s->level[s->levels];
        *level = (struct intersection_level){n_u, n_v, box};
        if (s->levels == 0 && s->corner)
            fit_triangles(s, level);
        else if (s->levels == 0)
            fit_cells(s, level);
        else
            fit_parents(level - 1, level);
        if (n_u == 1 && n_v == 1)
            break;
        box += (long)n_u * n_v;
        n_u = (n_u + 1) / 2, n_v = (n_v + 1) / 2;
    }
    s->levels++;
}

/* Moves the corners that both triangles share to the front, in the same order; returns
 * their number. No two triangles of a grid share all three. */
static int match(int p[3], int q[3])
{
    int shared = 0;

    for (int i = 0; i < 3; i++)
        for (int j = shared; j < 3; j++)
            if (p[i] == q[j]) {
                int of_p = p[i], of_q = q[j];
                p[i] = p[shared], q[j] = q[shared];
                p[shared] = of_p, q[shared] = of_q;
                shared++;
                break;
            }
    return shared;
}

static bool triangles_intersect(const struct intersection *s, int first, int second)
{
    int p[3], q[3];
    const double *a[3], *b[3];

    if (!intersection_triangle(s, first, p) || !intersection_triangle(s, second, q))
        return false;
    int shared = match(p, q);
    for (int i = 0; i < 3; i++) {
        a[i] = s->point + 3L * p[i];
        b[i] = s->point + 3L * q[i];
    }
    if (shared == 3) /* listed twice */
        return false;
    if (shared == 2)
        return triangle_meets_beyond_edge(a, b);
    return shared ? triangle_meets_beyond_vertex(a, b) : triangle_meets(a, b);
}

/* Returns bits 2a + b for triangles a, b of two cells; a cell with itself: bit 1 only. */
static unsigned char test_cells(const struct intersection *s, struct intersection_pair cell)
{
    unsigned char hit = 0;

    if (s->corner)
        return triangles_intersect(s, cell.first, cell.second);
    for (int bit = 0; bit < 4; bit++)
        if (cell.first != cell.second || bit == 1)
            if (triangles_intersect(s, 2 * cell.first + bit / 2, 2 * cell.second + bit % 2))
                hit |= 1u << bit;
    return hit;
}

static enum status keep_pair(struct intersection *s, int p, int q)
{
    if (s->pair_count == s->pair_room) {
        long room = s->pair_room ? 2 * s->pair_room : FIRST_PAIRS;
        struct intersection_pair *more = realloc(s->pairs, room * sizeof *more);
        if (!more)
            return STATUS_MEMORY;
        s->pairs = more;
        s->pair_room = room;
    }
    s->pairs[s->pair_count++] = (struct intersection_pair){p < q ? p : q, p < q ? q : p};
    return STATUS_OK;
}

/* Tests the candidates in parallel, then counts them in order. */
static enum status flush(struct intersection *s, long *count)
{
    enum status st = STATUS_OK;

#pragma omp parallel for schedule(dynamic, 256) if (s->candidate_count > 1024)
    for (int n = 0; n < s->candidate_count; n++)
        s->hit[n] = test_cells(s, s->candidate[n]);
    for (int n = 0; n < s->candidate_count; n++) {
        struct intersection_pair cell = s->candidate[n];
        s->tests += s->corner || cell.first == cell.second ? 1 : 4;
        for (int bit = 0; s->hit[n] >> bit; bit++)
            if (s->hit[n] >> bit & 1) {
                ++*count;
                if (s->keep_pairs && s->corner)
                    TRY(keep_pair(s, cell.first, cell.second));
                else if (s->keep_pairs)
                    TRY(keep_pair(s, 2 * cell.first + bit / 2, 2 * cell.second + bit % 2));
            }
    }
out:
    s->candidate_count = 0;
    return st;
}

/* Tells whether enough pairs were found. */
static bool is_enough(const struct intersection *s, long count)
{
    return s->most > 0 && count >= s->most;
}

static enum status add_candidate(struct intersection *s, int first, int second, long *count)
{
    enum status st = STATUS_OK;

    if (s->candidate_count == CANDIDATES)
        TRY(flush(s, count));
    s->candidate[s->candidate_count++] = (struct intersection_pair){first, second};
out:
    return st;
}

/* Finds the children of box n of level l + 1 in level l; returns how many. */
static int children(const struct intersection *s, int l, int n, int child[4])
{
    const struct intersection_level *above = &s->level[l + 1], *level = &s->level[l];
    int i = n % above->n_u, j = n / above->n_u, count = 0;

    for (int k = 0; k < 4; k++) {
        int p = 2 * i + k % 2, q = 2 * j + k / 2;
        if (p < level->n_u && q < level->n_v)
            child[count++] = q * level->n_u + p;
    }
    return count;
}

/* Tells whether boxes meet; touching counts. */
static bool boxes_meet(const double p[6], const double q[6])
{
    for (int c = 0; c < 3; c++)
        if (p[c] > q[3 + c] || q[c] > p[3 + c])
            return false;
    return true;
}

/* Tests pairs of cells, one below box m, one below box n of level l. */
static enum status across(struct intersection *s, int l, int m, int n, long *count)
{
    enum status st = STATUS_OK;
    int of_m[4], of_n[4];

    if (is_enough(s, *count) || !boxes_meet(s->level[l].box[m], s->level[l].box[n]))
        return STATUS_OK;
    if (l == 0)
        return add_candidate(s, m, n, count);
    int m_count = children(s, l - 1, m, of_m), n_count = children(s, l - 1, n, of_n);
    for (int i = 0; i < m_count; i++)
        for (int j = 0; j < n_count; j++)
            TRY(across(s, l - 1, of_m[i], of_n[j], count));
out:
    return st;
}

/* Tells whether the gradient with the columns u, v of a triangle, seen along the axes a, b,
 * certainly has a positive definite symmetric part: entries are about 1 or less, and off by
 * some 1e-15. */
static bool is_definite(const double a[3], const double b[3], const double u[3],
                        const double v[3])
{
    const double au = vector_dot(a, u), bv = vector_dot(b, v),
                 skew = vector_dot(a, v) + vector_dot(b, u),
                 size = fmax(vector_dot(a, a), vector_dot(b, b)) *
                        fmax(vector_dot(u, u), vector_dot(v, v));

    return size < 1e6 && au > 1e-3 && 4 * au * bv - skew * skew > 1e-3;
}

/* Tells whether the cells of box n of level l certainly do not meet each other: a piecewise
 * linear map of a rectangle to the plane whose gradients have positive definite symmetric
 * parts is one to one, as (f(p) - f(q)) . (p - q) > 0. The axes are the box's first row and
 * column, over the squares of their mean steps. */
static bool is_monotone(const struct intersection *s, int l, int n)
{
    const struct intersection_level *level = &s->level[l];
    const int i0 = n % level->n_u << l, j0 = n / level->n_u << l,
              i1 = i0 + (1 << l) < s->n_u ? i0 + (1 << l) : s->n_u - 1,
              j1 = j0 + (1 << l) < s->n_v ? j0 + (1 << l) : s->n_v - 1;
    const double *first = s->point + 3L * (j0 * s->n_u + i0);
    double axis[2][3], step[2][3];

    vector_between(first, first + 3L * (i1 - i0), axis[0]);
    vector_between(first, first + 3L * (j1 - j0) * s->n_u, axis[1]);
    for (int d = 0; d < 2; d++) {
        const double scale = (d ? j1 - j0 : i1 - i0) / vector_dot(axis[d], axis[d]);
        for (int c = 0; c < 3; c++)
            axis[d][c] *= scale;
    }
    for (int k = 0; k < 2 * (i1 - i0) * (j1 - j0); k++) {
        const int i = i0 + k / 2 % (i1 - i0), j = j0 + k / 2 / (i1 - i0);
        const double *p = s->point + 3L * (j * s->n_u + i), *q = p + 3L * s->n_u;
        vector_between(k % 2 ? q : p, (k % 2 ? q : p) + 3, step[0]);
        vector_between(k % 2 ? p : p + 3, k % 2 ? q : q + 3, step[1]);
        if (!is_definite(axis[0], axis[1], step[0], step[1]))
            return false;
    }
    return true;
}

/* Tests pairs of cells both below box n of level l. */
static enum status within(struct intersection *s, int l, int n, long *count)
{
    enum status st = STATUS_OK;
    int child[4];

    if (s->corner ? l == 0 : is_monotone(s, l, n))
        return STATUS_OK;
    if (l == 0)
        return add_candidate(s, n, n, count);
    int children_count = children(s, l - 1, n, child);
    for (int i = 0; i < children_count; i++) {
        TRY(within(s, l - 1, child[i], count));
        for (int j = i + 1; j < children_count; j++)
            TRY(across(s, l - 1, child[i], child[j], count));
    }
out:
    return st;
}

static int compare_pairs(const void *a, const void *b)
{
    const struct intersection_pair *p = a, *q = b;
    if (p->first != q->first)
        return p->first < q->first ? -1 : 1;
    return (p->second > q->second) - (p->second < q->second);
}

/* Begins with n_u x n_v cells on so many points. */
static enum status begin(struct intersection *s, long points, int n_u, int n_v,
                         const double *xyz, long *count)
{
    enum status st = STATUS_OK;

    *count = -1;
    s->points = points;
    s->pair_count = s->tests = s->candidate_count = 0;
    TRY(make_room(s, box_count(n_u, n_v)));
    TRY(scale_points(s, xyz));
    fit_boxes(s, n_u, n_v);
    *count = 0;
out:
    return st;
}

/* Tells whether the last row of the grid lies on the first one. */
static bool is_closed(const struct intersection *s)
{
    const double *last = s->point + 3L * s->n_u * (s->n_v - 1);
    const double shaken = s->shake / s->scale;

    for (int n = 0; n < 3 * s->n_u; n++)
        if (fabs(last[n] - s->point[n]) > same + shaken)
            return false;
    return s->n_v > 3;
}

/* Tests all pairs by the tree. */
static enum status count_by_tree(struct intersection *s, long *count)
{
    enum status st;

    TRY(within(s, s->levels - 1, 0, count));
    TRY(flush(s, count));
    if (s->pair_count)
        qsort(s->pairs, s->pair_count, sizeof *s->pairs, compare_pairs);
out:
    return st;
}

/* Counts those of a grid. */
static enum status count_grid(struct intersection *s, int n_u, int n_v, const double *xyz,
                              long *count)
{
    enum status st;

    assert(n_u >= 2 && n_v >= 2 && 2L * (n_u - 1) * (n_v - 1) <= 1L << 30);
    s->corner = NULL;
    s->closed = false;
    s->n_u = n_u, s->n_v = n_v;
    s->triangles = 2 * (n_u - 1) * (n_v - 1);
    TRY(begin(s, (long)n_u * n_v, n_u - 1, n_v - 1, xyz, count));
    s->closed = is_closed(s);
    TRY(count_by_tree(s, count));
out:
    if (st)
        *count = -1;
    return st;
}

enum status intersection_count(struct intersection *s, int n_u, int n_v, const double *xyz,
                               long *count)
{
    s->sheets = 1;
    return count_grid(s, n_u, n_v, xyz, count);
}

enum status intersection_count_field(struct intersection *s, int sheets, int step,
                                     const double *xyz, long *count)
{
    const int n_u = (GRID_U - 1) / step + 1, n_v = (GRID_V - 1) / step + 1;
    double *middle = malloc((size_t)(n_u * n_v) * 3 * sizeof *middle);
    enum status st = STATUS_MEMORY;

    assert((GRID_U - 1) % step == 0 && (GRID_V - 1) % step == 0);
    *count = -1;
    s->sheets = sheets, s->step = step;
    if (middle) {
        grid_middle(xyz, step, middle);
        st = count_grid(s, n_u, n_v, middle, count);
    }
    free(middle);
    return st;
}

enum status intersection_count_mesh(struct intersection *s, int vertices, const double *xyz,
                                    int triangles, int (*corner)[3], long *count)
{
    enum status st;

    assert(triangles >= 1);
    s->corner = corner;
    s->closed = false;
    s->triangles = triangles;
    TRY(begin(s, vertices, triangles, 1, xyz, count));
    TRY(count_by_tree(s, count));
out:
    if (st)
        *count = -1;
    return st;
}

/* Returns the distance of x from a box. */
static double box_distance(const double box[6], const double x[3])
{
    double d[3];

    for (int c = 0; c < 3; c++)
        d[c] = fmax(fmax(box[c] - x[c], x[c] - box[3 + c]), 0);
    return vector_length(d);
}

static void approach_cell(const struct intersection *s, int cell,
                          struct intersection_search *search)
{
    const int each = s->corner ? 1 : 2;

    for (int n = each * cell; n < each * (cell + 1); n++) {
        int corner[3];
        double foot[3];
        intersection_triangle(s, n, corner);
        const double *const p[3] = {s->point + 3L * corner[0], s->point + 3L * corner[1],
                                    s->point + 3L * corner[2]},
                            far = triangle_distance(p, search->x, foot);
        if (!(far < search->least) ||
            (search->counts && !search->counts(s, search, corner, foot)))
            continue;
        search->least = far;
        memcpy(search->corner, corner, sizeof corner);
        memcpy(search->foot, foot, sizeof foot);
    }
}

/* Searches below box n of level l, in the nearest boxes first. */
static void approach(const struct intersection *s, int l, int n,
                     struct intersection_search *search)
{
    int child[4];
    double far[4];

    if (l == 0) {
        approach_cell(s, n, search);
        return;
    }
    const int count = children(s, l - 1, n, child);
    for (int k = 0; k < count; k++)
        far[k] = box_distance(s->level[l - 1].box[child[k]], search->x);
    for (int k = 0; k < count; k++) {
        int next = 0;
        for (int i = 1; i < count; i++)
            next = far[i] < far[next] ? i : next;
        if (far[next] >= search->least)
            return;
        approach(s, l - 1, child[next], search);
        far[next] = INFINITY;
    }
}

bool intersection_nearest(const struct intersection *s, struct intersection_search *search)
{
    const double most = search->least;

    approach(s, s->levels - 1, 0, search);
    return search->least < most;
}

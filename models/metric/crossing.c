#include "models/metric/crossing.h"

#include <math.h>
#include <stdlib.h>

#include "models/grid.h"
#include "models/metric/predicate.h"
#include "models/metric/triangle.h"
#include "models/vector.h"

/* The largest depth that is looked for, in diagonals of the box around the sheet. */
static const double REACH = 0.1;

/* The cosines of the largest angles from a triangle's normal at which it faces a vertex,
 * and at which it is straight ahead. */
static const double FACING = 0.95, STRAIGHT = 0.99999;

/* The distance from the rim up to which a point is on it, of points of about 1. */
static const double ROUNDING = 1e-12;

/* The work space of a measurement, all arrays in one block. */
struct work {
    const struct intersection *s;
    double *far;  /* [points] distance from the facing triangle; 0: there is none        */
    double *deep; /* [points] largest distance in a part                                 */
    int *side;    /* [points] of the facing triangle; 0: there is none                   */
    int *part;    /* [points] of the sheet that is on one side, by union and find        */
    int *rim;     /* [points] 0: triangles close around it, else it is on the rim        */
};

static int root_of(int *parent, int n)
{
    while (parent[n] != n)
        n = parent[n] = parent[parent[n]];
    return n;
}

static void join(int *parent, int a, int b)
{
    a = root_of(parent, a);
    b = root_of(parent, b);
    parent[a > b ? a : b] = a > b ? b : a;
}

static enum status make_room(const struct intersection *s, struct work *w)
{
    const size_t points = (size_t)s->points;

    *w = (struct work){.s = s};
    w->far = calloc(points, 2 * sizeof *w->far + 3 * sizeof *w->side);
    if (!w->far)
        return STATUS_MEMORY;
    w->deep = w->far + points;
    w->side = (int *)(w->deep + points);
    w->part = w->side + points;
    w->rim = w->part + points;
    return STATUS_OK;
}

/* Finds the rim: around a vertex inside, each neighbour is a corner of two triangles. */
static void find_rim(struct work *w)
{
    int c[3];

    for (int n = 0; n < 3 * w->s->triangles; n++)
        if (intersection_triangle(w->s, n / 3, c))
            w->rim[c[n % 3]] ^= c[(n + 1) % 3] ^ c[(n + 2) % 3];
}

/* Returns the cosine of the angle between the way from x to a triangle's nearest point and
 * the triangle's normal; 0: it has none. */
static double cosine(const struct intersection *s, const double x[3], const int corner[3],
                     const double foot[3])
{
    const double *p = s->point + 3L * corner[0];
    double way[3], a[3], b[3], normal[3];

    vector_between(x, foot, way);
    vector_between(p, s->point + 3L * corner[1], a);
    vector_between(p, s->point + 3L * corner[2], b);
    vector_cross(a, b, normal);
    const double size = vector_length(normal) * vector_length(way);
    return size > 0 ? fabs(vector_dot(way, normal)) / size : 0;
}

bool crossing_faces(const struct intersection *s, const struct intersection_search *search,
                    const int corner[3], const double foot[3])
{
    for (int k = 0; k < 3; k++)
        if (search->x == s->point + 3L * corner[k])
            return false;
    return cosine(s, search->x, corner, foot) >= FACING;
}

/* Tells whether a vertex is beyond the rim: what it sees of the facing triangle is on the
 * rim, and not straight ahead. */
static bool is_beyond_rim(const struct work *w, const struct intersection_search *search)
{
    double foot[3];

    if (cosine(w->s, search->x, search->corner, search->foot) > STRAIGHT)
        return false;
    for (int k = 0; k < 3; k++) {
        const int from = search->corner[k], to = search->corner[(k + 1) % 3];
        const double *const a = w->s->point + 3L * from, *const b = w->s->point + 3L * to;
        if (w->rim[from] && w->rim[to] &&
            triangle_distance((const double *const[3]){a, b, a}, search->foot, foot) <=
                ROUNDING)
            return true;
    }
    return false;
}

/* Finds the facing triangle of each vertex, and its side. */
static void find_sides(struct work *w)
{
    const struct intersection *s = w->s;
    const double *box = s->level[s->levels - 1].box[0];
    double diagonal[3];

    vector_between(box, box + 3, diagonal);
    for (int n = 0; n < s->points; n++) {
        struct intersection_search search = {.x = s->point + 3L * n,
                                             .counts = crossing_faces,
                                             .least = REACH * vector_length(diagonal)};
        if (!intersection_nearest(s, &search) || is_beyond_rim(w, &search))
            continue;
        w->far[n] = search.least;
        w->side[n] = predicate_side(s->point + 3L * search.corner[0],
                                    s->point + 3L * search.corner[1],
                                    s->point + 3L * search.corner[2], search.x);
    }
}

/* Finds the parts: vertices that are joined by edges and lie on the same side. */
static void find_parts(struct work *w)
{
    const struct intersection *s = w->s;
    int c[3];

    for (int n = 0; n < s->points; n++)
        w->part[n] = n;
    for (int n = 0; n < 3 * s->triangles; n++)
        if (intersection_triangle(s, n / 3, c) &&
            w->side[c[n % 3]] == w->side[c[(n + 1) % 3]])
            join(w->part, c[n % 3], c[(n + 1) % 3]);
    for (int n = 0; n < s->points; n++) {
        w->part[n] = root_of(w->part, n);
        w->deep[w->part[n]] = fmax(w->deep[w->part[n]], w->far[n]);
    }
}

/* Computes how far triangle p lies beyond the plane of another one, with the smaller of
 * both sides' largest distances of its corners; and takes the depths of the parts that its
 * edges join across that plane into *depth. */
static double beyond(const struct work *w, int triangle, int other, double *depth)
{
    int p[3], q[3], side[3];
    double e[2][3], d[3], normal[3], most[2] = {0, 0};

    intersection_triangle(w->s, triangle, p);
    intersection_triangle(w->s, other, q);
    const double *const y[3] = {w->s->point + 3L * q[0], w->s->point + 3L * q[1],
                                w->s->point + 3L * q[2]};
    vector_between(y[0], y[1], e[0]);
    vector_between(y[0], y[2], e[1]);
    vector_cross(e[0], e[1], normal);
    for (int k = 0; k < 3; k++) {
        const double *x = w->s->point + 3L * p[k];
        vector_between(y[0], x, d);
        side[k] = predicate_side(y[0], y[1], y[2], x);
        most[side[k] > 0] = fmax(most[side[k] > 0], fabs(vector_dot(normal, d)));
    }
    for (int k = 0; k < 3; k++) {
        const int a = p[k], b = p[(k + 1) % 3];
        if (side[k] * side[(k + 1) % 3] < 0 && w->side[a] * w->side[b] < 0)
            *depth = fmax(*depth, fmin(w->deep[w->part[a]], w->deep[w->part[b]]));
    }
    const double size = vector_length(normal);
    return size > 0 ? fmin(most[0], most[1]) / size : 0;
}

static int compare_numbers(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* Counts the triangles that are in pairs. */
static enum status count_triangles(const struct intersection *s, int *count)
{
    const long room = 2 * s->pair_count;
    int *all = malloc((size_t)room * sizeof *all);

    if (!all)
        return STATUS_MEMORY;
    for (long n = 0; n < room; n++)
        all[n] = n % 2 ? s->pairs[n / 2].second : s->pairs[n / 2].first;
    qsort(all, (size_t)room, sizeof *all, compare_numbers);
    for (long n = 0; n < room; n++)
        *count += !n || all[n] != all[n - 1];
    free(all);
    return STATUS_OK;
}

enum status crossing_measure(const struct intersection *s, double tolerance,
                             struct crossing *crossing)
{
    struct work w = {NULL};
    double depth = 0;
    enum status st;

    *crossing = (struct crossing){0};
    if (!s->pair_count)
        return STATUS_OK;
    TRY(make_room(s, &w));
    find_rim(&w);
    find_sides(&w);
    find_parts(&w);
    for (long n = 0; n < s->pair_count; n++) {
        const int first = s->pairs[n].first, second = s->pairs[n].second;
        const double there = beyond(&w, first, second, &depth),
                     back = beyond(&w, second, first, &depth);
        depth = fmax(depth, fmin(there, back));
    }
    if (depth * s->scale > tolerance) {
        crossing->pairs = s->pair_count;
        crossing->depth = depth * s->scale;
        TRY(count_triangles(s, &crossing->triangles));
    }
out:
    free(w.far);
    return st;
}

enum status crossing_of_field(struct intersection *work, int sheets, int step,
                              const double *xyz, double tolerance,
                              struct crossing *crossing)
{
    const int n_u = (GRID_U - 1) / step + 1, n_v = (GRID_V - 1) / step + 1;
    long pairs;
    enum status st;

    *crossing = (struct crossing){0};
    work->keep_pairs = true, work->shake = CROSSING_SHAKE;
    work->most = (long)CROSSING_PAIRS_MOST * 2 * n_u * n_v;
    TRY(intersection_count_field(work, sheets, step, xyz, &pairs));
    st = crossing_measure(work, tolerance, crossing);
out:
    return st;
}

#include "models/metric/crossing.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "models/metric/predicate.h"
#include "models/vector.h"

/* The work space of a measurement, all arrays in one block. */
struct work {
    const struct intersection *s;
    double tolerance;   /* in the units of the points                                    */
    double *point;      /* [points][3] moved a little: no corner lies on a plane         */
    int *site;          /* [triangles] of the crossing, by union and find                */
    int *part;          /* [points] of the sheet, likewise                               */
    int *size;          /* [points] vertices of a part                                   */
    int largest;        /* part                                                          */
    double *far;        /* [points] depth of a part; negative: bounds no crossing        */
    double *depth;      /* [triangles] of a crossing; INFINITY: it cuts nothing off      */
    double *bound;      /* [triangles] lower bound of it                                 */
    unsigned char *cut; /* [triangles] a bit for each edge that is cut                   */
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

/* Moves a coordinate by less than a thousandth of the tolerance, by a hash of its number
 * (Steele, Lea, Flood 2014, SplitMix64). */
static double moved(const struct work *w, long n)
{
    uint64_t bits = (uint64_t)(n + 1) * 0x9e3779b97f4a7c15u;

    bits = (bits ^ bits >> 30) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ bits >> 27) * 0x94d049bb133111ebu;
    return w->s->point[n] +
           1e-3 * w->tolerance * ((double)((bits ^ bits >> 31) >> 11) * 0x1p-52 - 1);
}

static enum status make_room(const struct intersection *s, double tolerance, struct work *w)
{
    const size_t points = (size_t)s->points, triangles = (size_t)s->triangles;

    *w = (struct work){.s = s, .tolerance = tolerance / s->scale};
    w->point = malloc((4 * points + 2 * triangles) * sizeof *w->point +
                      (2 * points + triangles) * sizeof *w->site + triangles);
    if (!w->point)
        return STATUS_MEMORY;
    w->far = w->point + 3 * points;
    w->depth = w->far + points;
    w->bound = w->depth + triangles;
    w->part = (int *)(w->bound + triangles);
    w->size = w->part + points;
    w->site = w->size + points;
    w->cut = (unsigned char *)(w->site + triangles);
    for (long n = 0; n < 3 * s->points; n++)
        w->point[n] = moved(w, n);
    for (int n = 0; n < s->points; n++)
        w->part[n] = n, w->size[n] = 0, w->far[n] = -1;
    for (int n = 0; n < s->triangles; n++)
        w->site[n] = n, w->depth[n] = INFINITY, w->bound[n] = 0, w->cut[n] = 0;
    return STATUS_OK;
}

/* Returns the distance of x from the plane of q. */
static double off_plane(const double *const q[3], const double x[3])
{
    double a[3], b[3], d[3], normal[3];

    vector_between(q[0], q[1], a);
    vector_between(q[0], q[2], b);
    vector_between(q[0], x, d);
    vector_cross(a, b, normal);
    const double size = vector_length(normal);
    return size > 0 ? fabs(vector_dot(normal, d)) / size : 0;
}

/* Tells whether the segment a b passes through q, on whose sides its ends lie. */
static bool passes(const double a[3], const double b[3], int side_a, int side_b,
                   const double *const q[3])
{
    if (side_a * side_b >= 0)
        return false;
    const int side = predicate_side(a, b, q[0], q[1]);
    return side && predicate_side(a, b, q[1], q[2]) == side &&
           predicate_side(a, b, q[2], q[0]) == side;
}

/* Marks the edges of a triangle that pass through another one. */
static void mark_edges(struct work *w, int triangle, int other)
{
    int p[3], q[3], side[3];
    const double *x[3], *y[3];
    double *bound = &w->bound[root_of(w->site, triangle)];

    intersection_triangle(w->s, triangle, p);
    intersection_triangle(w->s, other, q);
    for (int k = 0; k < 3; k++)
        x[k] = w->point + 3L * p[k], y[k] = w->point + 3L * q[k];
    for (int k = 0; k < 3; k++)
        side[k] = predicate_side(y[0], y[1], y[2], x[k]);
    for (int k = 0; k < 3; k++) {
        const int next = (k + 1) % 3;
        if (!passes(x[k], x[next], side[k], side[next], y))
            continue;
        w->cut[triangle] |= 1u << k;
        *bound = fmax(*bound, fmin(off_plane(y, x[k]), off_plane(y, x[next])));
    }
}

/* Finds the crossings, and the parts into which they cut the sheet. */
static void find_parts(struct work *w)
{
    const struct intersection *s = w->s;

    for (long n = 0; n < s->pair_count; n++)
        join(w->site, s->pairs[n].first, s->pairs[n].second);
    for (long n = 0; n < s->pair_count; n++) {
        mark_edges(w, s->pairs[n].first, s->pairs[n].second);
        mark_edges(w, s->pairs[n].second, s->pairs[n].first);
    }
    for (int n = 0; n < s->triangles; n++) {
        int corner[3];
        intersection_triangle(s, n, corner);
        for (int k = 0; k < 3; k++)
            if (!(w->cut[n] >> k & 1))
                join(w->part, corner[k], corner[(k + 1) % 3]);
    }
    for (int n = 0; n < s->points; n++) {
        w->part[n] = root_of(w->part, n);
        if (++w->size[w->part[n]] > w->size[w->largest])
            w->largest = w->part[n];
    }
}

/* Tells whether a triangle has no vertex in the part that is the search's context. */
static bool is_rest(const struct intersection *s, const struct intersection_search *search,
                    const int corner[3], const double foot[3])
{
    const struct work *w = search->context;
    const int part = w->part[(search->x - s->point) / 3];

    (void)foot;
    return w->part[corner[0]] != part && w->part[corner[1]] != part &&
           w->part[corner[2]] != part;
}

/* Computes the depths of the parts that bound a crossing. */
static void measure_parts(struct work *w)
{
    const struct intersection *s = w->s;
    int corner[3];

    for (long n = 0; n < 2 * s->pair_count; n++) {
        intersection_triangle(s, n % 2 ? s->pairs[n / 2].second : s->pairs[n / 2].first,
                              corner);
        for (int k = 0; k < 3; k++)
            w->far[w->part[corner[k]]] = 0;
    }
    w->far[w->largest] = -1;
    for (int n = 0; n < s->points; n++) {
        double *far = &w->far[w->part[n]];
        struct intersection_search search = {s->point + 3L * n, w, is_rest, *far, INFINITY};
        if (*far < 0)
            continue;
        intersection_nearest(s, &search);
        if (isfinite(search.least))
            *far = fmax(*far, search.least);
    }
}

/* Takes the smallest depth among the parts that a crossing bounds, but those that are
 * rounding. */
static void measure_crossings(struct work *w)
{
    const struct intersection *s = w->s;

    for (long n = 0; n < 2 * s->pair_count; n++) {
        const int triangle = n % 2 ? s->pairs[n / 2].second : s->pairs[n / 2].first;
        double *depth = &w->depth[root_of(w->site, triangle)];
        int corner[3];
        intersection_triangle(s, triangle, corner);
        for (int k = 0; k < 3; k++) {
            const double far = w->far[w->part[corner[k]]];
            *depth = far > w->tolerance ? fmin(*depth, far) : *depth;
        }
    }
}

enum status crossing_measure(const struct intersection *s, double tolerance,
                             struct crossing *crossing)
{
    struct work w;
    enum status st;

    *crossing = (struct crossing){0};
    TRY(make_room(s, tolerance, &w));
    find_parts(&w);
    measure_parts(&w);
    measure_crossings(&w);
    for (long n = 0; n < s->pair_count; n++) {
        const int pair[2] = {s->pairs[n].first, s->pairs[n].second},
                  site = root_of(w.site, pair[0]);
        if (!(w.bound[site] > w.tolerance))
            continue;
        const double depth = isinf(w.depth[site]) ? w.bound[site] : w.depth[site];
        crossing->pairs++;
        crossing->depth = fmax(crossing->depth, s->scale * depth);
        for (int k = 0; k < 2; k++) { /* counted once */
            crossing->triangles += !(w.cut[pair[k]] & 8);
            w.cut[pair[k]] |= 8;
        }
    }
out:
    free(w.point);
    return st;
}

#include "models/metric/triangle.h"

#include <float.h>
#include <math.h>

#include "models/metric/predicate.h"
#include "models/vector.h"

/* The error bound of a projection m . (x - o): a difference, a product, two sums, each
 * with a relative error of DBL_EPSILON / 2, of terms whose sizes add up to `size`; twice
 * that. */
static const double projection_bound = 4 * DBL_EPSILON;

static bool same(const double a[3], const double b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

static double smallest(const double *const p[3], int c)
{
    double x = p[0][c] < p[1][c] ? p[0][c] : p[1][c];
    return x < p[2][c] ? x : p[2][c];
}

static double largest(const double *const p[3], int c)
{
    double x = p[0][c] > p[1][c] ? p[0][c] : p[1][c];
    return x > p[2][c] ? x : p[2][c];
}

static bool boxes_apart(const double *const p[3], const double *const q[3])
{
    for (int c = 0; c < 3; c++)
        if (smallest(p, c) > largest(q, c) || smallest(q, c) > largest(p, c))
            return true;
    return false;
}

/* Computes bounds [low, high] of m . (x - o). */
static void project(const double m[3], const double o[3], const double x[3], double *low,
                    double *high)
{
    double a = m[0] * (x[0] - o[0]), b = m[1] * (x[1] - o[1]), c = m[2] * (x[2] - o[2]);
    double error = projection_bound * (fabs(a) + fabs(b) + fabs(c));

    *low = (a + b + c) - error;
    *high = (a + b + c) + error;
}

/* Tells whether a plane across the line of centroids certainly separates the two. */
static bool centroids_part(const double *const p[3], const double *const q[3])
{
    double m[3], p_high = -INFINITY, q_low = INFINITY;

    for (int c = 0; c < 3; c++)
        m[c] = (q[0][c] + q[1][c] + q[2][c]) - (p[0][c] + p[1][c] + p[2][c]);
    for (int i = 0; i < 3; i++) {
        double low, high;
        project(m, p[0], p[i], &low, &high);
        p_high = fmax(p_high, high);
        project(m, p[0], q[i], &low, &high);
        q_low = fmin(q_low, low);
    }
    return p_high < q_low;
}

/* Adds factor times the unit vector along (x - o) + (y - o) to m. */
static void add_bisector(double factor, const double o[3], const double x[3],
                         const double y[3], double m[3])
{
    double d[3], size = 0;

    for (int c = 0; c < 3; c++) {
        d[c] = (x[c] - o[c]) + (y[c] - o[c]);
        size += d[c] * d[c];
    }
    size = size > 0 ? factor / sqrt(size) : 0;
    for (int c = 0; c < 3; c++)
        m[c] += size * d[c];
}

/* Tells whether a plane through the shared vertex, which alone lies on it, separates the
 * two. */
static bool bisectors_part(const double *const p[3], const double *const q[3])
{
    double m[3] = {0, 0, 0}, low, high;

    add_bisector(1, p[0], q[1], q[2], m);
    add_bisector(-1, p[0], p[1], p[2], m);
    for (int i = 1; i < 3; i++) {
        project(m, p[0], p[i], &low, &high);
        if (!(high < 0))
            return false;
        project(m, p[0], q[i], &low, &high);
        if (!(low > 0))
            return false;
    }
    return true;
}

static bool segment_boxes_meet(const double a[3], const double b[3], const double c[3],
                               const double d[3])
{
    for (int k = 0; k < 3; k++)
        if (fmin(a[k], b[k]) > fmax(c[k], d[k]) || fmin(c[k], d[k]) > fmax(a[k], b[k]))
            return false;
    return true;
}

/* Tells whether segments a b, c d of one plane meet, seen along `axis`; -1 if all
 * collinear. */
static int projected_segments_meet(int axis, const double a[3], const double b[3],
                                   const double c[3], const double d[3])
{
    int abc = predicate_turn(axis, a, b, c), abd = predicate_turn(axis, a, b, d);
    if (abc * abd > 0)
        return 0;
    int cda = predicate_turn(axis, c, d, a), cdb = predicate_turn(axis, c, d, b);
    if (cda * cdb > 0)
        return 0;
    return abc || abd || cda || cdb ? 1 : -1;
}

static bool segments_meet(const double a[3], const double b[3], const double c[3],
                          const double d[3])
{
    if (!segment_boxes_meet(a, b, c, d) || predicate_side(a, b, c, d))
        return false;
    for (int axis = 0; axis < 3; axis++) {
        int meet = projected_segments_meet(axis, a, b, c, d);
        if (meet >= 0)
            return meet;
    }
    return true; /* all on one line, along which the boxes meet */
}

static bool all_of_one_sign(int a, int b, int c)
{
    return !((a > 0 || b > 0 || c > 0) && (a < 0 || b < 0 || c < 0));
}

/* Tells whether segment s t meets p in its plane; p is no segment seen along `axis`. */
static bool flat_segment_meets(int axis, const double s[3], const double t[3],
                               const double *const p[3])
{
    if (all_of_one_sign(predicate_turn(axis, p[0], p[1], s),
                        predicate_turn(axis, p[1], p[2], s),
                        predicate_turn(axis, p[2], p[0], s)))
        return true;
    for (int i = 0; i < 3; i++) {
        const double *a = p[i], *b = p[(i + 1) % 3];
        int meet = projected_segments_meet(axis, a, b, s, t);
        if (meet > 0 || (meet < 0 && segment_boxes_meet(a, b, s, t)))
            return true;
    }
    return false;
}

/* Tells whether segment s t meets p; side_s, side_t: the sides of p on which they lie. */
static bool segment_meets(const double s[3], const double t[3], const double *const p[3],
                          int side_s, int side_t)
{
    if (side_s * side_t > 0)
        return false;
    if (side_s || side_t)
        return all_of_one_sign(predicate_side(s, t, p[0], p[1]),
                               predicate_side(s, t, p[1], p[2]),
                               predicate_side(s, t, p[2], p[0]));
    for (int axis = 0; axis < 3; axis++)
        if (predicate_turn(axis, p[0], p[1], p[2]))
            return flat_segment_meets(axis, s, t, p);
    return segments_meet(s, t, p[0], p[1]) || segments_meet(s, t, p[1], p[2]) ||
           segments_meet(s, t, p[2], p[0]);
}

static bool contains(const double *const p[3], const double x[3])
{
    int side = predicate_side(p[0], p[1], p[2], x);
    return segment_meets(x, x, p, side, side);
}

bool triangle_meets(const double *const p[3], const double *const q[3])
{
    int p_side[3], q_side[3];

    if (boxes_apart(p, q) || centroids_part(p, q))
        return false;
    for (int i = 0; i < 3; i++)
        q_side[i] = predicate_side(p[0], p[1], p[2], q[i]);
    if (q_side[0] && q_side[0] == q_side[1] && q_side[0] == q_side[2])
        return false;
    for (int i = 0; i < 3; i++)
        p_side[i] = predicate_side(q[0], q[1], q[2], p[i]);
    if (p_side[0] && p_side[0] == p_side[1] && p_side[0] == p_side[2])
        return false;
    /* where two triangles meet, an edge of one meets the other */
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        if (segment_meets(q[i], q[j], p, q_side[i], q_side[j]) ||
            segment_meets(p[i], p[j], q, p_side[i], p_side[j]))
            return true;
    }
    return false;
}

/* Tells whether segments a c and a d run along each other. */
static bool same_direction(const double a[3], const double c[3], const double d[3])
{
    if (same(a, c) || same(a, d) || !predicate_collinear(a, c, d))
        return false;
    for (int k = 0; k < 3; k++)
        if ((c[k] > a[k]) != (d[k] > a[k]) || (c[k] < a[k]) != (d[k] < a[k]))
            return false;
    return true;
}

/* Tells whether they meet off the shared corner; `flat` is a segment through it, p is none.
 */
static bool flat_meets_beyond_vertex(const double *const flat[3], const double *const p[3])
{
    /* p[1] p[2] does not pass through p[0], so any point counts */
    if (segment_meets(p[1], p[2], flat, 0, 0))
        return true;
    for (int i = 1; i < 3; i++)
        if (!same(flat[i], flat[0]) && contains(p, flat[i]))
            return true;
    return false;
}

bool triangle_meets_beyond_vertex(const double *const p[3], const double *const q[3])
{
    if (bisectors_part(p, q))
        return false;
    int q1 = predicate_side(p[0], p[1], p[2], q[1]);
    int q2 = predicate_side(p[0], p[1], p[2], q[2]);
    if (q1 * q2 > 0)
        return false;
    int p1 = predicate_side(q[0], q[1], q[2], p[1]);
    int p2 = predicate_side(q[0], q[1], q[2], p[2]);
    if (p1 * p2 > 0)
        return false;
    bool p_flat = predicate_collinear(p[0], p[1], p[2]);
    bool q_flat = predicate_collinear(q[0], q[1], q[2]);
    if (p_flat && q_flat)
        return same_direction(p[0], p[1], q[1]) || same_direction(p[0], p[1], q[2]) ||
               same_direction(p[0], p[2], q[1]) || same_direction(p[0], p[2], q[2]);
    if (p_flat)
        return flat_meets_beyond_vertex(p, q);
    if (q_flat)
        return flat_meets_beyond_vertex(q, p);
    /* the ray from the corner through a common point leaves one of the two first */
    return segment_meets(q[1], q[2], p, q1, q2) || segment_meets(p[1], p[2], q, p1, p2);
}

/* Tells whether a b c and a b d meet off a b, where all lie on a line, or a = b. */
static bool flat_meet_beyond_edge(const double a[3], const double b[3], const double c[3],
                                  const double d[3])
{
    if (same(a, b))
        return same_direction(a, c, d);
    int k = a[0] != b[0] ? 0 : a[1] != b[1] ? 1 : 2;
    double low = fmin(a[k], b[k]), high = fmax(a[k], b[k]);
    return (c[k] < low && d[k] < low) || (c[k] > high && d[k] > high);
}

bool triangle_meets_beyond_edge(const double *const p[3], const double *const q[3])
{
    const double *a = p[0], *b = p[1], *c = p[2], *d = q[2];

    for (int axis = 0; axis < 3; axis++) {
        int sides = predicate_turn(axis, a, b, c);
        if (sides)
            sides *= predicate_turn(axis, a, b, d);
        if (sides) /* either side of the edge; or folded over, at an angle or flat */
            return sides > 0 && !predicate_side(a, b, c, d);
    }
    if (!predicate_collinear(a, b, c) || !predicate_collinear(a, b, d))
        return false; /* at right angles, or one of them lies on the line of the edge */
    return flat_meet_beyond_edge(a, b, c, d);
}

/* Returns the distance of x from the nearest point of the segment a b. */
static double segment_distance(const double a[3], const double b[3], const double x[3],
                               double foot[3])
{
    double ab[3], ax[3], d[3];

    vector_between(a, b, ab);
    vector_between(a, x, ax);
    const double length = vector_dot(ab, ab),
                 s = length > 0 ? fmin(fmax(vector_dot(ab, ax) / length, 0), 1) : 0;
    for (int c = 0; c < 3; c++)
        foot[c] = a[c] + s * ab[c];
    vector_between(foot, x, d);
    return vector_length(d);
}

double triangle_distance(const double *const p[3], const double x[3], double foot[3])
{
    double e[2][3], d[3], normal[3], inward[3], other[3], least = INFINITY;
    bool inside = true;

    vector_between(p[0], p[1], e[0]);
    vector_between(p[0], p[2], e[1]);
    vector_cross(e[0], e[1], normal);
    const double size = vector_dot(normal, normal);
    for (int i = 0; i < 3; i++) {
        vector_between(p[i], p[(i + 1) % 3], e[0]);
        vector_between(p[i], x, d);
        vector_cross(normal, e[0], inward);
        inside = inside && size > 0 && vector_dot(inward, d) >= 0;
    }
    const double height = size > 0 ? vector_dot(normal, d) / size : 0;
    for (int c = 0; c < 3; c++)
        foot[c] = x[c] - height * normal[c];
    if (inside)
        return fabs(height) * sqrt(size);
    for (int i = 0; i < 3; i++) {
        const double far = segment_distance(p[i], p[(i + 1) % 3], x, other);
        for (int c = 0; far < least && c < 3; c++)
            foot[c] = other[c];
        least = fmin(least, far);
    }
    return least;
}

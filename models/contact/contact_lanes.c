#include "models/contact/contact_lanes.h"

#include <math.h>

#include "models/clones.h"

enum { LANES = CONTACT_LANES };

/* The squared sine of the angle at corner 0 up to which triangles are segments. */
static const double needle = 1e-16;

#define INLINE static inline __attribute__((always_inline))

struct three {
    double x, y, z;
};

INLINE struct three at(const double v[3][LANES], int l)
{
    return (struct three){v[0][l], v[1][l], v[2][l]};
}

/* Takes the vectors of all lanes' points from the k-th on. */
INLINE void gather(const double *v, const struct contact_lanes *lanes, int k,
                   double to[4][3][LANES])
{
    for (; k < 4; k++)
        for (int l = 0; l < LANES; l++) {
            const double *from = v + 3 * (long)lanes->point[k][l];
            to[k][0][l] = from[0], to[k][1][l] = from[1], to[k][2][l] = from[2];
        }
}

INLINE struct three less(struct three a, struct three b)
{
    return (struct three){a.x - b.x, a.y - b.y, a.z - b.z};
}

/* Returns a + t b. */
INLINE struct three plus(struct three a, double t, struct three b)
{
    return (struct three){a.x + t * b.x, a.y + t * b.y, a.z + t * b.z};
}

INLINE double dot(struct three a, struct three b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

INLINE struct three cross(struct three a, struct three b)
{
    return (struct three){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                          a.x * b.y - a.y * b.x};
}

INLINE double smaller(double a, double b)
{
    return a < b ? a : b;
}

/* Returns t within 0 and 1, 0 for NaN. */
INLINE double clamp(double t)
{
    t = t > 0 ? t : 0;
    return t < 1 ? t : 1;
}

/* Sets a lane's way and its square. */
INLINE void reach(struct contact_lanes *lanes, int l, struct three way)
{
    lanes->way[0][l] = way.x, lanes->way[1][l] = way.y, lanes->way[2][l] = way.z;
    lanes->square[l] = dot(way, way);
}

/* Sets a lane to the point of its triangle with the shares s, t of corners 2 and 3, which
 * is at p + s a + t b. */
INLINE void take(struct contact_lanes *lanes, int l, double p, double s, double t,
                 struct three a, struct three b, struct three way)
{
    lanes->share[1][l] = p, lanes->share[2][l] = s, lanes->share[3][l] = t;
    reach(lanes, l, plus(plus(way, -s, a), -t, b));
}

/* Finds the closest points where these are inside of triangles; returns whether all are. */
INLINE bool find_inside(struct contact_lanes *lanes, const double p[4][3][LANES],
                        double inside[LANES])
{
    double least = 1;

#pragma omp simd reduction(min : least)
    for (int l = 0; l < LANES; l++) {
        const struct three a = less(at(p[2], l), at(p[1], l));
        const struct three b = less(at(p[3], l), at(p[1], l));
        const struct three way = less(at(p[0], l), at(p[1], l)), n = cross(a, b);
        const double aa = dot(a, a), bb = dot(b, b), nn = dot(n, n);
        const double s = dot(cross(way, b), n), t = dot(cross(a, way), n);
        const double rest = (nn < needle * aa * bb ? 0 : nn) - s - t;
        const double per_nn = 1 / nn, share_s = s * per_nn, share_t = t * per_nn;
        inside[l] = smaller(smaller(s, t), rest) > 0 ? 1 : 0;
        least = smaller(least, inside[l]);
        take(lanes, l, 1 - share_s - share_t, share_s, share_t, a, b, way);
    }
    return least > 0;
}

/* Finds them on the sides where they are not inside. */
INLINE void find_on_sides(struct contact_lanes *lanes, const double p[4][3][LANES],
                          const double inside[LANES])
{
#pragma omp simd
    for (int l = 0; l < LANES; l++) {
        const struct three a = less(at(p[2], l), at(p[1], l));
        const struct three b = less(at(p[3], l), at(p[1], l)), c = less(b, a);
        const struct three way = less(at(p[0], l), at(p[1], l)), from_q = less(way, a);
        const double on_a = clamp(dot(a, way) / dot(a, a));
        const double on_b = clamp(dot(b, way) / dot(b, b));
        const double on_c = clamp(dot(c, from_q) / dot(c, c));
        const struct three of_a = plus(way, -on_a, a), of_b = plus(way, -on_b, b);
        const struct three of_c = plus(from_q, -on_c, c);
        const double to_a = dot(of_a, of_a), to_b = dot(of_b, of_b), to_c = dot(of_c, of_c);
        const bool by_b = to_b < to_a, by_c = to_c < (by_b ? to_b : to_a);
        const double s = by_c ? 1 - on_c : by_b ? 0 : on_a;
        const double t = by_c ? on_c : by_b ? on_b : 0, rest = by_c ? 0 : 1 - s - t;
        const bool in = inside[l] > 0;
        take(lanes, l, in ? lanes->share[1][l] : rest, in ? lanes->share[2][l] : s,
             in ? lanes->share[3][l] : t, a, b, way);
    }
}

CLONES void contact_lanes_nearest(struct contact_lanes *lanes)
{
    double p[4][3][LANES], inside[LANES];
    const double(*places)[3][LANES] = (const double(*)[3][LANES])p;

    gather(lanes->y, lanes, 0, p);
    if (!find_inside(lanes, places, inside))
        find_on_sides(lanes, places, inside);
}

/* Measures the lanes, whose points' places are p. */
INLINE void measure(struct contact_lanes *lanes, const double p[4][3][LANES])
{
#pragma omp simd
    for (int l = 0; l < LANES; l++) {
        struct three way = at(p[0], l);
        for (int k = 1; k < 4; k++)
            way = plus(way, -lanes->share[k][l], at(p[k], l));
        reach(lanes, l, way);
        const double distance = sqrt(lanes->square[l]), per_distance = 1 / distance;
        lanes->distance[l] = distance;
        for (int i = 0; i < 3; i++)
            lanes->way[i][l] *= per_distance;
    }
}

CLONES void contact_lanes_measure(struct contact_lanes *lanes)
{
    double p[4][3][LANES];

    gather(lanes->y, lanes, 0, p);
    measure(lanes, (const double(*)[3][LANES])p);
}

/* Newton's method for the shares s, t of corners 2 and 3 and the height h of a lane. */
struct height {
    double p[4][3][LANES], n[4][3][LANES];
    double s[LANES], t[LANES], h[LANES], change[LANES];
};

/* Takes a step of it where the last one was not small; returns the largest change. */
INLINE double rise(struct height *now, bool first)
{
    double most = 0;

#pragma omp simd reduction(max : most)
    for (int l = 0; l < LANES; l++) {
        const struct three p = at(now->p[1], l), m = at(now->n[1], l);
        const struct three a = less(at(now->p[2], l), p), b = less(at(now->p[3], l), p);
        const struct three u = less(at(now->n[2], l), m), v = less(at(now->n[3], l), m);
        const double s = now->s[l], t = now->t[l];
        const struct three n = plus(plus(m, s, u), t, v);
        struct three rest = plus(plus(less(at(now->p[0], l), p), -s, a), -t, b);
        const double h = first ? dot(rest, n) / dot(n, n) : now->h[l];
        rest = plus(rest, -h, n);
        const struct three by_s = plus(a, h, u), by_t = plus(b, h, v);
        const struct three across = cross(by_s, by_t);
        const double per_det = 1 / dot(across, n);
        const double ds = dot(cross(by_t, n), rest) * per_det;
        const double dt = dot(cross(n, by_s), rest) * per_det;
        const double old = now->change[l], change = fabs(ds) + fabs(dt);
        const bool moves =
            old >= 1e-6 && old < 4; /* the next is its square; far off, NaN */
        now->s[l] = moves ? s + ds : s, now->t[l] = moves ? t + dt : t;
        now->h[l] = moves ? h + dot(across, rest) * per_det : h;
        now->change[l] = moves ? change : old;
        const double left = moves && change < 4 ? change : 0;
        most = left > most ? left : most;
    }
    return most;
}

CLONES void contact_lanes_meet(struct contact_lanes *lanes)
{
    struct height now;

    gather(lanes->y, lanes, 0, now.p);
    gather(lanes->normal, lanes, 1, now.n);
    for (int l = 0; l < LANES; l++) {
        now.s[l] = lanes->share[2][l], now.t[l] = lanes->share[3][l];
        now.h[l] = 0, now.change[l] = 1;
    }
    double most = rise(&now, true);
    for (int round = 1; round < 8 && most >= 1e-6; round++)
        most = rise(&now, false);
    for (int l = 0; l < LANES; l++) {
        lanes->share[1][l] = 1 - now.s[l] - now.t[l];
        lanes->share[2][l] = now.s[l], lanes->share[3][l] = now.t[l];
        lanes->met[l] = now.change[l] < 4;
    }
    measure(lanes, (const double(*)[3][LANES])now.p);
}

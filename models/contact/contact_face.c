#include "models/contact/contact_face.h"

#include <math.h>

/* The squared sine of the angle at corner 0 up to which triangles are segments. */
static const double needle = 1e-16;

struct three {
    double x, y, z;
};

static struct three of(const double v[3])
{
    return (struct three){v[0], v[1], v[2]};
}

static struct three less(struct three a, struct three b)
{
    return (struct three){a.x - b.x, a.y - b.y, a.z - b.z};
}

/* Returns a + t b. */
static struct three plus(struct three a, double t, struct three b)
{
    return (struct three){a.x + t * b.x, a.y + t * b.y, a.z + t * b.z};
}

static double dot(struct three a, struct three b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static struct three cross(struct three a, struct three b)
{
    return (struct three){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z,
                          a.x * b.y - a.y * b.x};
}

/* Returns t within 0 and 1, 0 for NaN. */
static double clamp(double t)
{
    t = t > 0 ? t : 0;
    return t < 1 ? t : 1;
}

static void set_shares(struct contact_face *f, double p, double s, double t)
{
    f->share[0] = p, f->share[1] = s, f->share[2] = t;
}

/* Sets the way and its square. */
static void reach(struct contact_face *f, struct three way)
{
    f->way[0] = way.x, f->way[1] = way.y, f->way[2] = way.z;
    f->square = dot(way, way);
}

/* Sets the shares to those of the closest point on the sides a, b from corner 0, and the
 * third one; way: from corner 0 to the point. */
static void find_on_sides(struct contact_face *f, struct three a, struct three b,
                          struct three way)
{
    const struct three c = less(b, a), from_q = less(way, a);
    const double on_a = clamp(dot(a, way) / dot(a, a));
    const double on_b = clamp(dot(b, way) / dot(b, b));
    const double on_c = clamp(dot(c, from_q) / dot(c, c));
    const struct three of_a = plus(way, -on_a, a), of_b = plus(way, -on_b, b);
    const struct three of_c = plus(from_q, -on_c, c);
    const double to_a = dot(of_a, of_a), to_b = dot(of_b, of_b), to_c = dot(of_c, of_c);
    const bool by_b = to_b < to_a;

    if (to_c < (by_b ? to_b : to_a))
        set_shares(f, 0, 1 - on_c, on_c);
    else if (by_b)
        set_shares(f, 1 - on_b, 0, on_b);
    else
        set_shares(f, 1 - on_a, on_a, 0);
}

void contact_face_nearest(struct contact_face *f)
{
    const struct three p = of(f->p[1]), way = less(of(f->p[0]), p);
    const struct three a = less(of(f->p[2]), p), b = less(of(f->p[3]), p), n = cross(a, b);
    const double nn = dot(n, n), s = dot(cross(way, b), n), t = dot(cross(a, way), n);
    const double all = nn < needle * dot(a, a) * dot(b, b) ? 0 : nn;

    if (s > 0 && t > 0 && all - s - t > 0) {
        const double per_nn = 1 / nn, share_s = s * per_nn, share_t = t * per_nn;
        set_shares(f, 1 - share_s - share_t, share_s, share_t);
    } else {
        find_on_sides(f, a, b, way);
    }
    reach(f, plus(plus(way, -f->share[1], a), -f->share[2], b));
}

double contact_face_measure(struct contact_face *f)
{
    struct three way = of(f->p[0]);

    for (int k = 0; k < 3; k++)
        way = plus(way, -f->share[k], of(f->p[k + 1]));
    reach(f, way);
    const double distance = sqrt(f->square), per_distance = 1 / distance;
    for (int i = 0; i < 3; i++)
        f->way[i] *= per_distance;
    return distance;
}

bool contact_face_meet(struct contact_face *f, const double *const normal[3])
{
    const struct three p = of(f->p[1]), y = less(of(f->p[0]), p), m = of(normal[0]);
    const struct three a = less(of(f->p[2]), p), b = less(of(f->p[3]), p);
    const struct three u = less(of(normal[1]), m), v = less(of(normal[2]), m);
    double s = f->share[1], t = f->share[2], h = 0, change = 1;

    /* Newton's method: the next change is the square of one; far off, NaN. */
    for (int round = 0; round < 8 && change >= 1e-6 && change < 4; round++) {
        const struct three n = plus(plus(m, s, u), t, v);
        struct three rest = plus(plus(y, -s, a), -t, b);
        if (round == 0)
            h = dot(rest, n) / dot(n, n);
        rest = plus(rest, -h, n);
        const struct three by_s = plus(a, h, u), by_t = plus(b, h, v);
        const struct three across = cross(by_s, by_t);
        const double per_det = 1 / dot(across, n);
        const double ds = dot(cross(by_t, n), rest) * per_det;
        const double dt = dot(cross(n, by_s), rest) * per_det;
        s += ds, t += dt, h += dot(across, rest) * per_det;
        change = fabs(ds) + fabs(dt);
    }
    set_shares(f, 1 - s - t, s, t);
    return change < 4;
}

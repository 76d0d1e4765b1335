#include <math.h>

#include "models/contact/contact_parts.h"
#include "models/vector.h"

/* The x of the law that one change leaves to what comes from farther off, and the share of
 * their x that it leaves to others: the pressure grows little more than fourfold in a
 * change, and Newton's method, which knows its slope only, is not thrown back far. */
static const double LEFT = 0.5;

/* The calls of contact_find in a step after which no change turns a slip round: it ends
 * where there is none. What slips has no stiffness along its way, so that Newton's steps
 * may go from one way of slipping to the other for ever. */
enum { CAREFUL = 9 };

/* Returns a bound of the least distance on a way whose ends have these distances and
 * slopes: distances to convex bodies lie over their tangents. */
static double lowest(const double distance[2], const double slope[2])
{
    if (slope[0] >= 0 || slope[1] <= 0)
        return fmin(distance[0], distance[1]);
    const double at = (distance[0] - distance[1] + slope[1]) / (slope[1] - slope[0]);
    return distance[0] + slope[0] * at;
}

/* Returns the share of the change d of a sample at y that leaves enough before a body. The
 * distance is no more than the way shorter, so that the first share is safe; steps towards
 * the end of a longer one are tried while they are. */
static double limit_sample(const struct contact *c, int sample, int obstacle,
                           const double y[3], const double d[3], double share)
{
    enum { TRIES = 60 };
    static const double SHORTER = 0.95;
    const struct scene_obstacle *o = &c->scene->obstacles[obstacle];
    const double wall = c->body.start - c->body.range, way = vector_length(d);
    const double far = wall + way * share + LEFT * c->body.range;
    double normal[3];
    double room = contact_shape_near(o, &c->pose[obstacle], y, far, normal);

    if (!contact_touch_still(o)) /* what is behind a body that came over it may come back */
        room = contact_touch_met(c, sample, obstacle, y, room, normal);
    room -= wall;
    if (!(room > 0) || room - way * share >= LEFT * c->body.range)
        return share;
    const double least = LEFT * fmin(room, c->body.range);
    if (room - way * share >= least)
        return share;
    const double slope = vector_dot(normal, d);
    for (int n = 0; n < TRIES; n++) {
        double end[3];
        for (int i = 0; i < 3; i++)
            end[i] = y[i] + share * d[i];
        double left = contact_shape_distance(o, &c->pose[obstacle], end, normal) - wall;
        left = lowest((double[2]){room, left},
                      (double[2]){share * slope, share * vector_dot(normal, d)});
        if (left >= least)
            break;
        share *= fmin((room - least) / (room - left), SHORTER);
    }
    return share;
}

/* Returns the share of a change d that ends the slip of a touch instead of turning it
 * round. */
static double limit_slip(const struct contact *c, const struct contact_touch *t,
                         const double *d)
{
    double way[3] = {0}, change[3];

    if (!(t->drag > 0) || t->grip > 0)
        return 1;
    for (int k = t->first; k < t->first + t->count; k++)
        for (int i = 0; i < 3; i++)
            way[i] += c->weight[k] * d[3 * (size_t)c->node[k] + i];
    contact_touch_split(way, t->normal, change);
    const double size = vector_length(t->rub) / t->drag;
    const double back = vector_dot(t->rub, change) / t->drag; /* rub is against the slip */
    return back > size * size ? size * size / back : 1;
}

/* Returns the share of a change that keeps the sheet from coming through itself; 0 with
 * c->failed. */
static double limit_own(struct contact *c, const double *x, const double *d)
{
    double share = 1;

    if (c->scene->contact.self)
        c->failed = contact_search_limit(&c->search, x, d, c->self.start - c->self.range,
                                         c->self.range, &share);
    return c->failed == STATUS_OK ? share : 0;
}

double contact_limit(struct contact *c, const double *x, const double *d)
{
    double share = 1;

    for (int n = 0; n < c->surface.count; n++) {
        double y[3], way[3];
        contact_surface_at(&c->surface, n, x, y);
        contact_surface_at(&c->surface, n, d, way);
        for (int o = 0; o < c->scene->obstacle_count; o++)
            share = limit_sample(c, n, o, y, way, share);
    }
    for (int n = 0; c->finds > CAREFUL && n < c->count; n++)
        share = fmin(share, limit_slip(c, &c->touch[n], d));
    return fmin(share, limit_own(c, x, d));
}

void contact_lead(struct contact *c, double *x)
{
    const size_t count = 3 * (size_t)c->surface.nodes;

    for (size_t k = 0; k < count; k++)
        x[k] -= c->x_old[k];
    const double share = contact_limit(c, c->x_old, x);
    for (size_t k = 0; k < count; k++)
        x[k] = c->x_old[k] + share * x[k];
}

bool contact_shorten(struct contact *c, const double *x, double *d)
{
    const struct contact_surface *s = &c->surface;
    bool any = false;

    for (int n = 0; n < s->count; n++) {
        double y[3], way[3], share = 1;
        contact_surface_at(s, n, x, y);
        contact_surface_at(s, n, d, way);
        for (int o = 0; o < c->scene->obstacle_count; o++)
            share = limit_sample(c, n, o, y, way, share);
        any |= share < 1;
        for (int k = 0; share < 1 && k < s->used[n]; k++)
            for (int i = 0; i < 3; i++)
                d[3 * (size_t)s->node[(size_t)n * s->width + k] + i] *= share;
    }
    const double own = limit_own(c, x, d);
    for (int k = 0; own < 1 && k < 3 * s->nodes; k++)
        d[k] *= own;
    return any || own < 1;
}

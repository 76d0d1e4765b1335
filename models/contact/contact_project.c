#include <math.h>
#include <string.h>

#include "models/contact/contact_parts.h"
#include "models/vector.h"

/* Returns how far the touch opens along n by a unit of force along n [m/N], by itself or if
 * those around it have the same pressure. */
static double opening(const struct contact *c, const struct contact_touch *t,
                      const double n[3], const double *compliance, const int *held,
                      bool together)
{
    double sum = 0;

    for (int k = t->first; k < t->first + t->count; k++) {
        const int a = c->node[k];
        const double share = together ? c->pressed[a] / t->area : c->weight[k];
        for (int i = 0; i < 3; i++)
            if (held[3 * (size_t)a + i] >= 0)
                sum += n[i] * n[i] * c->weight[k] * share * compliance[a];
    }
    return sum;
}

/* Finds a touch's force by the law, from its way up to x: normal force first, then
 * friction. */
static void press_by(const struct contact *c, struct contact_touch *t,
                     const double *compliance, const int *held, bool together,
                     const double *x)
{
    const struct contact_law *law = contact_touch_law(c, t);
    const double mu = contact_touch_friction(c, t);
    const double open = opening(c, t, t->normal, compliance, held, together);
    double way[3], slip[3], across[3];

    contact_touch_way(c, t, x, way);
    const double along = contact_touch_split(way, t->normal, slip),
                 size = vector_length(slip);
    t->push = contact_law_solve(law, t->D_flat + along, t->D_old, c->dt, t->area, open);
    memset(t->rub, 0, sizeof t->rub);
    if (mu == 0 || size == 0)
        return;
    for (int i = 0; i < 3; i++)
        across[i] = slip[i] / size;
    const double most = mu * t->push * opening(c, t, across, compliance, held, together);
    const double share = contact_law_hold(law, size, c->dt, most);
    for (int i = 0; i < 3; i++)
        t->rub[i] = -mu * t->push * share * across[i];
}

/* Moves the nodes of a touch by `times` its force, in so far as they are free. */
static void yield_to(const struct contact *c, const struct contact_touch *t, double times,
                     const double *compliance, const int *held, double *x)
{
    for (int k = t->first; k < t->first + t->count; k++)
        for (int i = 0; i < 3; i++) {
            size_t u = 3 * (size_t)c->node[k] + i;
            if (held[u] >= 0)
                x[u] += times * c->weight[k] * compliance[c->node[k]] *
                        (t->push * t->normal[i] + t->rub[i]);
        }
}

/* Returns a touch's distance at x, along the normal that it had where it was found. */
static double distance_now(const struct contact *c, const struct contact_touch *t,
                           const double *x)
{
    double way[3];

    contact_touch_way(c, t, x, way);
    return t->D_flat + vector_dot(way, t->normal);
}

/* Tells whether a touch's push is less than the law has at x, by more than round-off. */
static bool lacks(const struct contact *c, const struct contact_touch *t, const double *x)
{
    const double D = distance_now(c, t, x), round_off = 1e-9;
    const double p = contact_law_push(contact_touch_law(c, t), D, t->D_old, c->dt, NULL);

    return t->area * p > (1 + round_off) * t->push;
}

/* Gives each touch from `first` on that lacks force what it lacks, one after the other as
 * the others now press; returns whether any did. */
static bool relieve(const struct contact *c, int first, const double *compliance,
                    const int *held, double *x)
{
    bool any = false;

    for (struct contact_touch *t = c->touch + first; t < c->touch + c->count; t++) {
        const struct contact_touch before = *t;
        if (!lacks(c, t, x))
            continue;
        any = true;
        yield_to(c, t, -1, compliance, held, x);
        press_by(c, t, compliance, held, false, x);
        if (t->push < before.push) /* others that rely on it would sink */
            *t = before;
        yield_to(c, t, 1, compliance, held, x);
    }
    return any;
}

/* Takes the touches from `first` on as they are at x. */
static void take(struct contact *c, int first, const double *x)
{
    for (struct contact_touch *t = c->touch + first; t < c->touch + c->count; t++) {
        t->D = distance_now(c, t, x);
        contact_touch_total(c, t);
    }
}

/* Ends the step of touches with a body, or of the sheet's own: with a body of all as if
 * they had the same pressure, which leaves flat what lands flat; then of one after the
 * other as the others now press. */
static void settle(struct contact *c, int first, const double *compliance, const int *held,
                   double *x)
{
    struct contact_touch *from = c->touch + first, *end = c->touch + c->count;

    memset(c->pressed, 0, (size_t)c->surface.nodes * sizeof *c->pressed);
    for (const struct contact_touch *t = from; t < end; t++)
        for (int k = t->first; k < t->first + t->count; k++)
            c->pressed[c->node[k]] += fabs(c->weight[k]) * t->area;
    for (struct contact_touch *t = from; t < end && t->obstacle >= 0; t++)
        press_by(c, t, compliance, held, true, x);
    for (struct contact_touch *t = from; t < end; t++)
        yield_to(c, t, 1, compliance, held, x);
    relieve(c, first, compliance, held, x);
}

/* Notes where a touch that was found at x was when the step began. */
static void look_back(const struct contact *c, struct contact_touch *t, const double *x)
{
    double way[3];

    contact_touch_way(c, t, x, way);
    const double along = vector_dot(way, t->normal);
    t->D_old = contact_touch_before(c, t, along);
    t->D_flat = t->D - along;
}

/* Tells whether a sample at y has come less far from where it was looked at than the bodies
 * were from it: most of a sheet need not be looked at in each of an explicit method's
 * steps.
 */
static bool keeps_off(struct contact *c, const double *spare, const double y[3])
{
    double way[3];

    vector_between(spare, y, way);
    const double square = vector_dot(way, way);
    if (!(square < spare[3] * spare[3]))
        return false;
    if (spare[3] < c->least)
        c->least = fmin(c->least, spare[3] - sqrt(square));
    return true;
}

/* Lists the samples that must be looked at, with their places. */
static int list_near(struct contact *c, const double *x)
{
    int count = 0;

    for (int n = 0; n < c->surface.count; n++) {
        double *spare = c->spare + 4 * (size_t)n, y[3];
        contact_surface_at(&c->surface, n, x, y);
        if (keeps_off(c, spare, y))
            continue;
        memcpy(spare, y, sizeof y);
        spare[3] = INFINITY;
        c->near[count++] = n;
    }
    return count;
}

/* Ends the step of samples by the law of a body, together: a sheet that lands flat stays
 * flat. Their spare is how far they are from it, 0 if it may come nearer by itself. */
static enum status meet_body(struct contact *c, int obstacle, int count,
                             const double *compliance, const int *held, double *x)
{
    enum status st = STATUS_OK;
    const struct scene_obstacle *body = &c->scene->obstacles[obstacle];
    const bool still = contact_touch_still(body);
    const int first = c->count;

    for (int n = 0; n < count; n++) {
        double y[3], normal[3], *spare = &c->spare[4 * (size_t)c->near[n] + 3];
        contact_surface_at(&c->surface, c->near[n], x, y);
        double D = contact_shape_distance(body, &c->pose[obstacle], y, normal);
        if (isnan(D))
            return STATUS_NAN;
        D = contact_touch_met(c, c->near[n], obstacle, y, D, normal);
        const double off = D - c->body.start;
        *spare = fmin(*spare, still ? fmax(off, 0) : 0);
        if (off >= 0) {
            c->least = fmin(c->least, off);
            continue;
        }
        TRY(contact_touch_body(c, c->near[n], obstacle, D, normal));
        look_back(c, &c->touch[c->count - 1], x);
    }
    settle(c, first, compliance, held, x);
out:
    return st;
}

/* The rounds in which bodies that close from two sides find how each presses against the
 * other, and layers on a body how it bears them; their forces rise to those of the law,
 * from below. */
enum { ROUNDS = 32 };

/* Adds the touches with bodies, and ends all. */
static enum status project_bodies(struct contact *c, const double *compliance,
                                  const int *held, double *x)
{
    enum status st = STATUS_OK;
    const int near = list_near(c, x), own = c->count;

    for (int o = 0; o < c->scene->obstacle_count; o++)
        TRY(meet_body(c, o, near, compliance, held, x));
    int rounds = c->scene->obstacle_count > 1 || (own && c->count > own) ? ROUNDS : 0;
    while (rounds-- > 0 && relieve(c, 0, compliance, held, x))
        ;
    take(c, 0, x);
out:
    return st;
}

enum status contact_project_bodies(struct contact *c, const double *compliance,
                                   const int *held, double *x)
{
    contact_touch_none(c);
    return project_bodies(c, compliance, held, x);
}

enum status contact_project(struct contact *c, const double *compliance, const int *held,
                            double *x)
{
    enum status st = STATUS_OK;

    contact_touch_none(c);
    TRY(contact_touch_own(c, x));
    for (int n = 0; n < c->count; n++)
        look_back(c, &c->touch[n], x);
    settle(c, 0, compliance, held, x);
    TRY(project_bodies(c, compliance, held, x));
out:
    return st;
}

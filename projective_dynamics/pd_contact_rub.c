#include "projective_dynamics/pd_contact.h"

#include <math.h>

#include "models/contact/contact_shape.h"

/* A slipping force has settled when it turns by less than this share of it. */
static const double SETTLED = 1e-9;

static double norm(const double a[3])
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Computes two unit vectors across `normal`. */
static void across(const double normal[3], double tangent[2][3])
{
    int least = 0;

    for (int i = 1; i < 3; i++)
        if (fabs(normal[i]) < fabs(normal[least]))
            least = i;
    for (int i = 0; i < 3; i++)
        tangent[0][i] = (i == least) - normal[least] * normal[i];
    double size = norm(tangent[0]);
    for (int i = 0; i < 3; i++)
        tangent[0][i] /= size;
    for (int i = 0; i < 3; i++)
        tangent[1][i] = normal[(i + 1) % 3] * tangent[0][(i + 2) % 3] -
                        normal[(i + 2) % 3] * tangent[0][(i + 1) % 3];
}

/* Computes the part of x - start across the normal at `from`. */
static void way_across(const struct pd_contact *c, int t, const double *from,
                       const double *start, const double *x, double normal[3],
                       double way[3])
{
    double along;

    pd_contact_normal(c, t, from, normal);
    for (int i = 0; i < 3; i++) {
        ptrdiff_t at = i * pd_net_stride(c->system->net) + t % c->nodes;
        way[i] = x[at] - start[at];
    }
    along = dot(way, normal);
    for (int i = 0; i < 3; i++)
        way[i] -= along * normal[i];
}

/* Moves the force a step down, then into the disc; returns whether it changed. The step is
 * safe: S is nowhere larger than 1 / mass. */
static bool relax(struct pd_touch *touch, double bound, double mass, const double way[3])
{
    double next[3], change[3];

    for (int i = 0; i < 3; i++)
        next[i] = touch->tangent[i] - mass * way[i];
    double size = norm(next);
    for (int i = 0; i < 3; i++) {
        next[i] *= size > bound ? bound / size : 1;
        change[i] = next[i] - touch->tangent[i];
        touch->tangent[i] = next[i];
    }
    return norm(change) > SETTLED * bound;
}

static bool rub_one(struct pd_contact *c, int t, const double *from, const double *start,
                    const double *x)
{
    struct pd_touch *touch = &c->touch[t];
    double bound = pd_contact_obstacle(c, t)->friction * touch->press;
    double normal[3], way[3];

    way_across(c, t, from, start, x, normal, way);
    double along = dot(touch->tangent, normal);
    for (int i = 0; i < 3; i++)
        touch->tangent[i] -= along * normal[i]; /* planes of spheres turn */
    double size = norm(touch->tangent);
    if (touch->rub == PD_RUB_STICK) {
        if (size <= bound)
            return false;
        touch->rub = PD_RUB_SLIP;
        for (int i = 0; i < 3; i++)
            touch->tangent[i] *= bound / size;
        return true;
    }
    if (dot(way, touch->tangent) <= 0 || touch->changes >= PD_CONTACT_CHANGES)
        return relax(touch, bound, c->mass[t % c->nodes], way);
    touch->rub = PD_RUB_STICK;
    touch->changes++;
    return true;
}

/* Finds forces on the nodes that stick, which keep them where they were. */
static enum status stick(struct pd_contact *c, const double *from, const double *start,
                         const double *x, int *changed)
{
    enum status st;
    double near = PD_CONTACT_CLOSED * c->scene->length, most = 0;
    int count = 0;

    for (int t = 0; t < c->count; t++)
        count += c->touch[t].closed && c->touch[t].rub == PD_RUB_STICK;
    TRY(pd_contact_room(c, 2 * count));
    c->row_count = 0;
    for (int t = 0; t < c->count; t++) {
        double normal[3], way[3], tangent[2][3];
        if (!c->touch[t].closed || c->touch[t].rub != PD_RUB_STICK)
            continue;
        way_across(c, t, from, start, x, normal, way);
        across(normal, tangent);
        for (int k = 0; k < 2; k++)
            pd_contact_row(c, t, tangent[k], -dot(tangent[k], way));
        most = fmax(most, norm(way));
    }
    if (!(most > near))
        return STATUS_OK;
    *changed = true;
    TRY(pd_dual_solve(&c->dual, PD_DUAL_TANGENTS, c->row, c->row_count, near / 4,
                      c->row_error));
    for (int n = 0; n < c->row_count; n++)
        for (int i = 0; i < 3; i++)
            c->touch[c->row_touch[n]].tangent[i] +=
                c->row_error[n] / c->scale * c->row[n].direction[i];
out:
    return st;
}

enum status pd_contact_rub(struct pd_contact *c, const double *from, const double *start,
                           const double *x, int *changed)
{
    enum status st;

    *changed = false;
    TRY(stick(c, from, start, x, changed));
    for (int t = 0; t < c->count; t++)
        if (c->touch[t].closed && c->touch[t].rub != PD_RUB_NONE)
            *changed |= rub_one(c, t, from, start, x);
out:
    return st;
}

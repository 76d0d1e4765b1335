#include "projective_dynamics/pd_contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/contact/contact_shape.h"
#include "models/room.h"

/* BLOCKS: swaps of all at once without progress before single ones; PASSES: of friction in
 * an iteration; REFINEMENTS: of a solution. */
enum { BLOCKS = 4, PASSES = 2, REFINEMENTS = 2 };

void pd_contact_clear(struct pd_contact *c)
{
    if (!c || !c->system)
        return;
    pd_dual_clear(&c->dual);
    pd_net_free_fields(c->system->net, c->alone);
    pd_net_free_fields(c->system->net, c->free);
    pd_net_free_fields(c->system->net, c->way);
    free(c->touch);
    free(c->row_memory);
    memset(c, 0, sizeof *c);
}

enum status pd_contact_init(struct pd_contact *c, const struct scene *scene,
                            struct pd_system *system, const double *mass,
                            const double *rest, struct message *why)
{
    enum status st = STATUS_MEMORY;
    const struct pd_net *net = system->net;

    *c = (struct pd_contact){.scene = scene,
                             .system = system,
                             .mass = mass,
                             .scale = 1,
                             .nodes = net->nodes,
                             .count = net->nodes * scene->obstacle_count};
    for (int o = 0; o < scene->obstacle_count; o++)
        c->friction |= scene->obstacles[o].friction > 0;
    c->touch = calloc((size_t)c->count, sizeof *c->touch);
    c->alone = pd_net_fields(net, 3);
    c->free = pd_net_fields(net, 3);
    c->way = pd_net_fields(net, 3);
    if (!c->touch || !c->alone || !c->free || !c->way)
        goto out;
    TRY(pd_dual_init(&c->dual, system));
    double gap = pd_contact_gap(c, rest);
    if (gap < -PD_CONTACT_CLOSED * scene->length)
        st = status_fail(why, STATUS_INPUT,
                         "the sheet at rest reaches %.3g m into an obstacle", -gap);
out:
    if (st != STATUS_OK)
        pd_contact_clear(c);
    return st;
}

/* --- geometry ----------------------------------------------------------------------------
 */

static void node_at(const struct pd_contact *c, const double *x, int node, double p[3])
{
    for (int i = 0; i < 3; i++)
        p[i] = x[i * pd_net_stride(c->system->net) + node];
}

const struct scene_obstacle *pd_contact_obstacle(const struct pd_contact *c, int t)
{
    return &c->scene->obstacles[t / c->nodes];
}

double pd_contact_normal(const struct pd_contact *c, int t, const double *x,
                         double normal[3])
{
    double p[3];

    node_at(c, x, t % c->nodes, p);
    return contact_shape_distance(pd_contact_obstacle(c, t), NULL, p, normal) -
           c->scene->thickness / 2;
}

/* Returns the height of x over the plane that the touch has at `from`. */
static double height(const struct pd_contact *c, int t, const double *from, const double *x,
                     double normal[3])
{
    double gap = pd_contact_normal(c, t, from, normal), p[3], q[3];

    node_at(c, from, t % c->nodes, p);
    node_at(c, x, t % c->nodes, q);
    for (int i = 0; i < 3; i++)
        gap += normal[i] * (q[i] - p[i]);
    return gap;
}

double pd_contact_gap(const struct pd_contact *c, const double *x)
{
    double least = INFINITY;

    for (int t = 0; t < c->count; t++) {
        double gap = pd_contact_normal(c, t, x, NULL);
        if (!(gap >= least))
            least = gap;
    }
    return least;
}

/* --- rows --------------------------------------------------------------------------------
 */

enum status pd_contact_room(struct pd_contact *c, int rows)
{
    if (rows <= c->row_room)
        return STATUS_OK;
    size_t n = 2 * (size_t)rows;
    free(c->row_memory);
    enum status st = room_cut(&c->row_memory, ROOM(c->row, n), ROOM(c->row_touch, n),
                              ROOM(c->row_value, n), ROOM(c->row_error, n));
    c->row_room = st == STATUS_OK ? (int)n : 0;
    return st;
}

void pd_contact_row(struct pd_contact *c, int t, const double direction[3], double error)
{
    struct pd_push *row = &c->row[c->row_count];

    row->node = t % c->nodes;
    memcpy(row->direction, direction, sizeof row->direction);
    c->row_touch[c->row_count] = t;
    c->row_error[c->row_count++] = error;
}

/* Collects normals of the active set and the gaps left at x; returns the largest. */
static double find_rows(struct pd_contact *c, const double *from, const double *x)
{
    double most = 0;

    c->row_count = 0;
    for (int t = 0; t < c->count; t++) {
        double normal[3];
        if (!c->touch[t].closed)
            continue;
        double low = height(c, t, from, x, normal);
        pd_contact_row(c, t, normal, -low);
        most = fmax(most, fabs(low));
    }
    return most;
}

/* Computes to = from + factor more, three fields. */
static void add_field(const struct pd_contact *c, const double *from, double factor,
                      const double *more, double *to)
{
    ptrdiff_t stride = pd_net_stride(c->system->net);

    for (int i = 0; i < 3; i++)
        for (int k = 0; k < c->nodes; k++)
            to[i * stride + k] = from[i * stride + k] + factor * more[i * stride + k];
}

/* Finds the forces that close the active set's rows, x = free + A^-1 C^T p. */
static enum status solve_rows(struct pd_contact *c, const double *from, double *x)
{
    enum status st = STATUS_OK;
    int closed = 0;
    double near = PD_CONTACT_CLOSED * c->scene->length;

    for (int t = 0; t < c->count; t++)
        closed += c->touch[t].closed;
    TRY(pd_contact_room(c, closed));
    double left = find_rows(c, from, c->free);
    for (int r = 0; r < c->row_count; r++)
        c->row_value[r] = 0;
    add_field(c, c->free, 0, c->free, x);
    for (int n = 0; n <= REFINEMENTS && c->row_count; n++) {
        if (n && !(left > near))
            break;
        TRY(pd_dual_solve(&c->dual, PD_DUAL_NORMALS, c->row, c->row_count, near / 4,
                          c->row_error));
        for (int r = 0; r < c->row_count; r++)
            c->row_value[r] += c->row_error[r];
        TRY(pd_dual_push(&c->dual, c->row, c->row_count, c->row_value, c->way));
        add_field(c, c->free, 1, c->way, x);
        left = find_rows(c, from, x);
    }
    for (int r = 0; r < c->row_count; r++)
        c->touch[c->row_touch[r]].press = c->row_value[r] / c->scale;
out:
    return st;
}

/* --- the active set ----------------------------------------------------------------------
 */

static bool held_whole(const struct pd_contact *c, int node)
{
    const bool *held = c->system->held;

    return held[node] && held[c->nodes + node] && held[2 * c->nodes + node];
}

/* Returns whether touch t pulls, or is open and below its plane. */
static bool is_wrong(const struct pd_contact *c, int t, const double *from, const double *x)
{
    const struct pd_touch *touch = &c->touch[t];
    double normal[3];

    if (touch->closed)
        return touch->press < 0;
    return height(c, t, from, x, normal) < -PD_CONTACT_CLOSED * c->scene->length &&
           !held_whole(c, t % c->nodes);
}

static void swap(struct pd_contact *c, int t)
{
    bool closed = !c->touch[t].closed;

    for (int i = 0; i < 3; i++)
        c->stale |= c->touch[t].tangent[i] != 0;
    struct pd_touch next = {.closed = closed, .changes = c->touch[t].changes + closed};
    if (closed && pd_contact_obstacle(c, t)->friction > 0)
        next.rub = next.changes < PD_CONTACT_CHANGES ? PD_RUB_STICK : PD_RUB_SLIP;
    c->touch[t] = next;
}

/* Swaps all wrong touches, or the last of them alone; returns how many were wrong. */
static int pivot(struct pd_contact *c, const double *from, const double *x, bool single)
{
    int count = 0, last = -1;

    for (int t = 0; t < c->count; t++)
        if (is_wrong(c, t, from, x)) {
            count++, last = t;
            if (!single)
                swap(c, t);
        }
    if (single && last >= 0)
        swap(c, last);
    return count;
}

/* Computes x = free + the pushes of the active set, with the right set. */
static enum status press(struct pd_contact *c, const double *from, double *x)
{
    enum status st;
    int best = c->count + 1, patience = BLOCKS;

    for (long n = 0; n < 20 + 4L * c->count; n++) {
        bool single = patience == 0;
        TRY(solve_rows(c, from, x));
        int wrong = pivot(c, from, x, single);
        if (wrong == 0)
            return STATUS_OK;
        if (wrong < best)
            best = wrong, patience = BLOCKS;
        else if (patience > 0)
            patience--;
    }
    st = STATUS_DIVERGED;
out:
    return st;
}

/* Computes free = alone + the nodes' friction forces. */
static enum status set_free(struct pd_contact *c)
{
    enum status st = STATUS_OK;
    int count = 0;

    c->stale = false;
    add_field(c, c->alone, 0, c->alone, c->free);
    for (int t = 0; t < c->count; t++)
        count += c->touch[t].closed && c->touch[t].rub != PD_RUB_NONE;
    if (!count)
        return STATUS_OK;
    TRY(pd_contact_room(c, count));
    c->row_count = 0;
    for (int t = 0; t < c->count; t++)
        if (c->touch[t].closed && c->touch[t].rub != PD_RUB_NONE) {
            c->row_value[c->row_count] = c->scale;
            pd_contact_row(c, t, c->touch[t].tangent, 0);
        }
    TRY(pd_dual_push(&c->dual, c->row, count, c->row_value, c->way));
    add_field(c, c->alone, 1, c->way, c->free);
out:
    return st;
}

/* --- the whole ---------------------------------------------------------------------------
 */

static void add_up(struct pd_contact *c, const double *from)
{
    memset(c->force, 0, sizeof c->force);
    c->pressed = 0;
    for (int t = 0; t < c->count; t++) {
        const struct pd_touch *touch = &c->touch[t];
        double normal[3];
        if (!touch->closed || !(touch->press > 0))
            continue;
        pd_contact_normal(c, t, from, normal);
        for (int i = 0; i < 3; i++)
            c->force[i] += touch->press * normal[i] + touch->tangent[i];
        c->pressed++;
    }
}

enum status pd_contact_apply(struct pd_contact *c, const double *from, const double *start,
                             double *x)
{
    enum status st = STATUS_OK;

    for (int t = 0; from == start && t < c->count; t++)
        c->touch[t].changes = 0;
    add_field(c, x, 0, x, c->alone);
    for (int pass = 1, changed = 1; changed; pass++) {
        TRY(set_free(c));
        TRY(press(c, from, x));
        add_up(c, from);
        if (!c->friction || pass == PASSES)
            break;
        TRY(pd_contact_rub(c, from, start, x, &changed));
        changed |= c->stale;
    }
out:
    return st;
}

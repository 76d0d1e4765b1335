#include "models/mechanics/contact_solve.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_PASSES = 2000,
    PATIENCE = 5, /* passes without progress before pairs change one at a time */
    FRICTION_PASSES = 50,
    MOST_DOUBLINGS = 5 /* see hurry                                                     */
};

/* Friction has settled when its forces change by less than this share of the largest. */
static const double FRICTION_SETTLED = 1e-7;

/* A sticking node may creep by this share of what gravity moves from rest in a step. */
static const double CREEP = 1e-7;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static struct contact_pair *pairs_of(const struct contact_set *c, int a)
{
    return c->pair + (size_t)a * (size_t)c->obstacles;
}

/* Returns the least value of n . x that the pair allows. */
static double target(const struct contact_problem *p, const struct contact_pair *pair,
                     int a)
{
    double from = p->still ? dot(pair->normal, p->still + 3 * (size_t)a) : 0;

    return from - p->scale * pair->gap;
}

/* Fills y[nodes][3] with the active pairs' part of x; zero at held unknowns. */
static void given_part(const struct contact_set *c, const struct contact_problem *p,
                       const double *x, double *y)
{
    memset(y, 0, 3 * (size_t)c->nodes * sizeof *y);
    for (int a = 0; a < c->nodes; a++) {
        const struct contact_node *node = &c->node[a];
        double *ya = y + 3 * (size_t)a;
        for (int t = 0; t < node->touches; t++) {
            const struct contact_pair *pair = &pairs_of(c, a)[node->obstacle[t]];
            double size = target(p, pair, a);
            for (int i = 0; i < 3; i++)
                if (c->held->free_index[3 * a + i] < 0)
                    size -= pair->normal[i] * x[3 * (size_t)a + i];
            for (int i = 0; i < 3; i++)
                ya[i] += size * node->dual[t][i];
        }
    }
}

/* Adds drag still to r: friction is zero where nothing moves. */
static void add_friction(const struct contact_set *c, const struct contact_problem *p,
                         double *r)
{
    for (int a = 0; p->still && a < c->nodes; a++)
        for (int i = 0; c->node[a].drag > 0 && i < 3; i++)
            r[3 * (size_t)a + i] += dot(c->drag[a] + 3 * i, p->still + 3 * (size_t)a);
}

/* Solves for x with the present set, and computes the forces that it requires. */
static enum status solve_once(struct contact_set *c, struct system *s,
                              const struct contact_problem *p, double *x)
{
    const int *place = c->held->free_index;
    size_t count = 3 * (size_t)c->nodes;
    double *given = c->work, *r = c->work + count, *product = c->work + 2 * count,
           *work = c->work + 3 * count;
    bool any = contact_set_any(c);
    const double(*P)[9] = (const double(*)[9])c->projector;
    enum status st;

    memcpy(r, p->b, count * sizeof *r);
    add_friction(c, p, r);
    if (any) {
        given_part(c, p, x, given);
        system_multiply(s, p->k, p->K, p->m, p->M, given, product, work);
        for (size_t t = 0; t < count; t++)
            r[t] -= product[t];
        contact_set_apply(c, P, r);
    }
    TRY(system_solve(s, r));
    if (any) {
        contact_set_apply(c, P, r);
        for (size_t t = 0; t < count; t++)
            r[t] += given[t];
        system_multiply(s, p->k, p->K, p->m, p->M, r, product, work);
    }
    for (size_t t = 0; t < count; t++) {
        c->node[t / 3].force[t % 3] =
            c->touched[t / 3] && place[t] >= 0 ? product[t] - p->b[t] : 0;
        if (place[t] >= 0)
            x[t] = r[t];
    }
out:
    return st;
}

/* Splits the forces into multipliers and, from x, friction. */
static void split_forces(struct contact_set *c, const struct contact_problem *p,
                         const double *x)
{
    for (int a = 0; a < c->nodes; a++) {
        struct contact_node *node = &c->node[a];
        double moved[3];
        for (int i = 0; i < 3; i++)
            moved[i] = x[3 * (size_t)a + i] - (p->still ? p->still[3 * (size_t)a + i] : 0);
        for (int i = 0; i < 3; i++)
            node->friction[i] = node->drag > 0 ? -dot(c->drag[a] + 3 * i, moved) : 0;
        for (int o = 0; o < c->obstacles; o++)
            pairs_of(c, a)[o].lambda = 0;
        for (int t = 0; t < node->touches; t++)
            pairs_of(c, a)[node->obstacle[t]].lambda = dot(node->dual[t], node->force);
    }
}

/* Returns the mean diagonal of A at node a. */
static double stiffness(const struct system *s, const struct contact_problem *p, int a)
{
    long n = s->graph->start[a];
    const double *K = p->K[n];

    return p->k * (K[0] + K[4] + K[8]) / 3 + (p->M ? p->m * p->M[n] : 0);
}

/* Returns the length of the pair's normal in directions left free by supports and, in
 * *beside, also by the node's other contacts. */
static double free_normal(const struct contact_set *c, int a, int o, double *beside)
{
    double v[3], free[3];

    memcpy(v, pairs_of(c, a)[o].normal, sizeof v);
    for (int i = 0; i < 3; i++)
        free[i] = c->held->free_index[3 * a + i] < 0 ? 0 : v[i];
    contact_set_along(c, a, v);
    *beside = sqrt(dot(v, v));
    return sqrt(dot(free, free));
}

/* Returns whether the pair should change: an active one if it pulls or adds no direction,
 * another if its node is too far; by more than `slack`, as a value of x. */
static bool violated(const struct contact_set *c, const struct system *s,
                     const struct contact_problem *p, const double *x, int a, int o,
                     double slack)
{
    const struct contact_pair *pair = &pairs_of(c, a)[o];
    const struct contact_node *node = &c->node[a];
    bool counts = false;
    double beside;

    if (!pair->active)
        return dot(pair->normal, x + 3 * (size_t)a) < target(p, pair, a) - slack &&
               free_normal(c, a, o, &beside) > CONTACT_SET_INDEPENDENT;
    for (int t = 0; t < node->touches; t++)
        counts |= node->obstacle[t] == o;
    return !counts || pair->lambda < -slack * stiffness(s, p, a);
}

/* Changes a pair. A new one that adds no direction to the node's others replaces the one
 * whose normal is nearest to its own. */
static void change(struct contact_set *c, int a, int o)
{
    struct contact_pair *pair = pairs_of(c, a);
    double beside, nearest = -INFINITY;
    int other = o;

    pair[o].active = !pair[o].active;
    free_normal(c, a, o, &beside);
    if (!pair[o].active || beside > CONTACT_SET_INDEPENDENT)
        return;
    for (int t = 0; t < c->obstacles; t++)
        if (t != o && pair[t].active && dot(pair[t].normal, pair[o].normal) > nearest) {
            nearest = dot(pair[t].normal, pair[o].normal);
            other = t;
        }
    if (other != o)
        pair[other].active = false;
}

/* Changes all violated pairs. Returns how many they were. */
static long exchange(struct contact_set *c, const struct system *s,
                     const struct contact_problem *p, const double *x, double slack)
{
    long count = 0;

    for (int a = 0; a < c->nodes; a++)
        for (int o = 0; o < c->obstacles; o++)
            if (violated(c, s, p, x, a, o, slack)) {
                change(c, a, o);
                count++;
            }
    return count;
}

/* Starts the primal method where nothing has moved, y[nodes][3], with the pairs that are
 * closed there. */
static void start_primal(struct contact_set *c, const struct contact_problem *p,
                         const double *x, double slack, double *y)
{
    for (int a = 0; a < c->nodes; a++) {
        for (int i = 3 * a; i < 3 * a + 3; i++)
            y[i] = c->held->free_index[i] < 0 ? x[i] : p->still ? p->still[i] : 0;
        for (int o = 0; o < c->obstacles; o++) {
            struct contact_pair *pair = &pairs_of(c, a)[o];
            pair->active &= dot(pair->normal, y + 3 * a) <= target(p, pair, a) + slack;
        }
    }
}

/* Drops the active pair that pulls most, as a motion; false if none does. */
static bool let_go(struct contact_set *c, const struct system *s,
                   const struct contact_problem *p, double slack)
{
    struct contact_pair *worst = NULL;
    double most = slack;

    for (int a = 0; a < c->nodes; a++)
        for (int o = 0; o < c->obstacles; o++) {
            struct contact_pair *pair = &pairs_of(c, a)[o];
            double pull = -pair->lambda / stiffness(s, p, a);
            if (pair->active && pull > most)
                most = pull, worst = pair;
        }
    if (worst)
        worst->active = false;
    return worst;
}

/* Does one pass of the primal method from x, the solution for the present set: y goes
 * towards it until the first pair closes, which joins; where none does, one that pulls is
 * dropped. Returns whether the set changed. */
static bool primal_pass(struct contact_set *c, const struct system *s,
                        const struct contact_problem *p, const double *x, double slack,
                        double *y)
{
    double part = 1;
    int node = -1, obstacle = 0;

    for (int a = 0; a < c->nodes; a++)
        for (int o = 0; o < c->obstacles; o++) {
            const struct contact_pair *pair = &pairs_of(c, a)[o];
            if (pair->active || !violated(c, s, p, x, a, o, slack))
                continue;
            double from = dot(pair->normal, y + 3 * a);
            double room = fmax(0, from - target(p, pair, a));
            double way = from - dot(pair->normal, x + 3 * a);
            if (room < part * way || node < 0)
                part = fmin(part, room / way), node = a, obstacle = o;
        }
    for (int t = 0; t < 3 * c->nodes; t++)
        y[t] += part * (x[t] - y[t]);
    if (node < 0)
        return let_go(c, s, p, slack);
    change(c, node, obstacle);
    return true;
}

/* Returns the greatest friction that node a can have. */
static double friction_limit(const struct contact_set *c, int a)
{
    const struct contact_node *node = &c->node[a];
    double limit = 0;

    for (int t = 0; t < node->touches; t++)
        limit += c->scene->obstacles[node->obstacle[t]].friction *
                 fmax(0, pairs_of(c, a)[node->obstacle[t]].lambda);
    return limit;
}

static void set_drag(struct contact_set *c, int a, double drag)
{
    const int *place = c->held->free_index + 3 * (size_t)a;

    c->node[a].drag = drag;
    for (int t = 0; t < 9; t++)
        c->drag[a][t] =
            place[t / 3] >= 0 && place[t % 3] >= 0 ? drag * c->projector[a][t] : 0;
}

/* Extrapolates from the drag `old` to the wanted one, farther the longer it has changed the
 * same way: the drag of a sticking node grows without end, that of one that breaks loose
 * falls, by the same small factor in each pass. */
static double hurry(struct contact_node *node, double old, double want)
{
    if (!(old > 0 && want > 0))
        return want;
    int way = want > old ? 1 : -1;
    node->trend = node->trend * way > 0 ? node->trend + way : way;
    int doublings = abs(node->trend) - 2;
    if (doublings <= 0)
        return want;
    return want *
           pow(want / old,
               ldexp(1, doublings < MOST_DOUBLINGS ? doublings : MOST_DOUBLINGS) - 1);
}

/* Sets the drag that gives node a its greatest friction at the speed of x. Returns the
 * change of its friction. */
static double update_drag(struct contact_set *c, const struct contact_problem *p,
                          const double *x, int a, double creep)
{
    struct contact_node *node = &c->node[a];
    double limit = friction_limit(c, a), old = node->drag, v[3], length;

    memcpy(v, x + 3 * (size_t)a, sizeof v);
    for (int i = 0; p->still && i < 3; i++)
        v[i] -= p->still[3 * (size_t)a + i];
    contact_set_along(c, a, v);
    length = sqrt(dot(v, v));
    node->sticks = limit > 0 && length < creep;
    double want = limit / fmax(length, creep);
    set_drag(c, a, fmin(hurry(node, old, want), limit / creep));
    return fabs(want - old) * length;
}

/* Updates the drags; returns whether friction already agreed with the solution. */
static bool settle_friction(struct contact_set *c, const struct contact_problem *p,
                            const double *x)
{
    const double *g = c->scene->gravity;
    double most = 0, largest = 0, step = c->scene->step;
    double creep = fmax(CREEP * sqrt(dot(g, g)) * step * step, c->rounding) * p->scale;

    for (int a = 0; a < c->nodes; a++) {
        double limit = friction_limit(c, a);
        if (limit == 0 && c->node[a].drag == 0)
            continue;
        most = fmax(most, update_drag(c, p, x, a, creep));
        largest = fmax(largest, limit);
    }
    return most <= FRICTION_SETTLED * largest;
}

static enum status factor_wanted(struct contact_set *c, struct system *s,
                                 const struct contact_problem *p, struct counters *counters)
{
    enum status st;

    if (!contact_set_project(c))
        return STATUS_OK;
    c->is_factored = false;
    TRY(system_factor_projected(s, p->k, p->K, p->m, p->M, (const double(*)[9])c->drag,
                                (const double(*)[9])c->projector, c->touched));
    counters->factorisations++;
    contact_set_remember(c);
out:
    return st;
}

enum status contact_solve(struct contact_set *c, struct system *s,
                          const struct contact_problem *p, double *x,
                          struct counters *counters)
{
    enum status st = STATUS_DIVERGED;
    double slack = c->rounding * p->scale, *y = c->work + 12 * (size_t)c->nodes;
    long fewest = LONG_MAX;
    int patience = PATIENCE, friction_passes = 0;

    for (int pass = 0; pass < MOST_PASSES; pass++) {
        TRY(factor_wanted(c, s, p, counters));
        TRY(solve_once(c, s, p, x));
        counters->solves++;
        split_forces(c, p, x);
        st = STATUS_DIVERGED;
        if (patience == 0) {
            if (primal_pass(c, s, p, x, slack, y))
                continue;
        } else {
            long count = exchange(c, s, p, x, slack);
            patience = count < fewest ? PATIENCE : patience - 1;
            fewest = count < fewest ? count : fewest;
            if (count && patience == 0)
                start_primal(c, p, x, slack, y);
            if (count)
                continue;
        }
        c->settled = p->friction == CONTACT_FRICTION_KEPT || settle_friction(c, p, x);
        if (c->settled || p->friction == CONTACT_FRICTION_ONCE)
            return STATUS_OK;
        if (++friction_passes == FRICTION_PASSES) {
            c->unsettled++;
            return STATUS_OK;
        }
        fewest = LONG_MAX;
        patience = PATIENCE;
    }
out:
    return st;
}

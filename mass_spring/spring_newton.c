#include "mass_spring/spring_newton.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/order.h"
#include "models/mechanics/frames.h"
#include "models/room.h"

/* The most iterations: a net under pressure may have to buckle within the step, away from a
 * saddle that attracts at first. */
enum { MOST_ITERATIONS = 2000, MOST_CUTS = 30 };

/* Friction that has not settled after so many iterations stays as it is for the step. */
enum { FRICTION_ITERATIONS = 50 };

/* Tolerances of conjugate gradients: for a step that others follow, and for one alone. */
static const double LINEAR_TOLERANCE = 1e-2, LAST_TOLERANCE = 1e-4;

/* The error that they may leave at each point after the first step, as a share of
 * Newton's tolerance: the very last step only shows that none is needed. The first has
 * no such allowance: it follows movements below the tolerance, too, which short steps
 * would lose. */
static const double NEAR = 0.1;

/* K is kept while no point has moved farther since it was made, in lengths of a cell: a
 * quarter fewer are made, and no more systems solved (three times as far: a third more). */
static const double STILL = 1e-4;

/* A step is accepted if the slope at its end is above minus this part of the one at its
 * start. */
static const double LARGEST_RISE = 0.5;

static void frames(const void *body, double (*Q)[9])
{
    const struct spring_newton *s = body;
    const int points[3] = {s->net->points[0], s->net->points[1], 1};

    frames_of_net(points, false, s->at, Q);
}

static enum status make_hinges(struct spring_newton *s)
{
    if (s->hinges)
        return STATUS_OK;
    s->hinges = malloc((size_t)s->net->graph.start[s->net->nodes] * sizeof *s->hinges);
    if (!s->hinges)
        return STATUS_MEMORY;
    spring_force_hinges(s->net, s->hinges);
    return STATUS_OK;
}

enum status spring_newton_system(struct spring_newton *s)
{
    enum status st = make_hinges(s);
    const int *points = s->net->points;

    if (st != STATUS_OK || s->system.factor || s->system.iterative ||
        !s->supports.free_count)
        return st;
    int *order = malloc((size_t)s->net->nodes * sizeof *order);
    if (!order)
        return STATUS_MEMORY;
    order_nested(points[0], points[1], 1, spring_net_reach(s->net), order);
    TRY(system_init(&s->system, &s->net->graph, &s->supports, NULL, order, &s->linear));
    if (!contact_set_used(&s->contact)) /* contact needs exact solutions */
        system_single(&s->system);
    st = iterative_follow(s->system.iterative, frames, s, false);
out:
    free(order);
    return st;
}

void spring_newton_clear(struct spring_newton *s)
{
    system_clear(&s->system);
    contact_set_clear(&s->contact);
    supports_clear(&s->supports);
    free(s->hinges);
    free(s->room);
    memset(s, 0, sizeof *s);
}

enum status spring_newton_init(struct spring_newton *s, const struct scene *scene,
                               const struct spring_net *net, const struct discretization *d,
                               struct message *why)
{
    enum status st;
    size_t pairs = (size_t)net->graph.start[net->nodes];

    *s = (struct spring_newton){
        .net = net, .linear = {.solver = d->solver, .preconditioner = d->preconditioner}};
    if (d->solver == SOLVER_AUTO)
        s->linear.solver = SOLVER_CG; /* on an earlier factor */
    TRY(supports_init(&s->supports, scene, net->nodes, net->uvw, why));
    TRY(room_cut(&s->room, ROOM(s->K, pairs), ROOM(s->work, 18 * (size_t)net->nodes)));
    TRY(contact_set_init(&s->contact, scene, &s->supports, scene->thickness / 2));
out:
    if (st != STATUS_OK)
        spring_newton_clear(s);
    return st;
}

/* Computes minus the gradient at x, zero at held unknowns; `work`: for the viscous part. */
static void residual(const struct spring_newton *s, const struct spring_problem *p,
                     const double *x, double *work, double *r)
{
    size_t count = 3 * (size_t)s->net->nodes;
    const int *place = s->supports.free_index;

    if (p->viscosity) {
        for (size_t t = 0; t < count; t++)
            work[t] = p->viscosity * (x[t] - p->start[t]);
        blocks_multiply(&s->net->graph, p->V, work, r);
        for (size_t t = 0; t < count; t++)
            r[t] = p->load[t] - r[t];
    } else {
        memcpy(r, p->load, count * sizeof *r);
    }
    for (size_t t = 0; t < count; t++)
        r[t] -= p->weight[t / 3] * (x[t] - p->target[t]);
    spring_force_add(s->net, x, r);
    for (size_t t = 0; t < count; t++)
        if (place[t] < 0)
            r[t] = 0;
}

static void assemble(struct spring_newton *s, const struct spring_problem *p,
                     const double *x)
{
    const struct blocks *g = &s->net->graph;
    long pairs = g->start[g->nodes];

    spring_force_clamped(s->net, x, s->hinges, s->K);
    for (int a = 0; a < g->nodes; a++)
        for (int i = 0; i < 3; i++)
            s->K[g->start[a]][4 * i] += p->weight[a];
    for (long n = 0; p->viscosity && n < pairs; n++)
        for (int t = 0; t < 9; t++)
            s->K[n][t] += p->viscosity * p->V[n][t];
}

static double product(size_t count, const double *a, const double *b)
{
    double sum = 0;

    for (size_t t = 0; t < count; t++)
        sum += a[t] * b[t];
    return sum;
}

/* Solves d = K^-1 r; near: see iterative_tolerate. made: K is new. */
static enum status solve(struct spring_newton *s, double tolerance, double near, bool made,
                         const double *x, const double *r, double *d,
                         struct counters *counters)
{
    enum status st;
    size_t count = 3 * (size_t)s->net->nodes;

    s->at = x;
    iterative_tolerate(s->system.iterative, tolerance, near);
    if (made)
        TRY(system_update(&s->system, 1, (const double(*)[9])s->K, 0, NULL));
    memcpy(d, r, count * sizeof *d);
    TRY(system_solve(&s->system, d));
    counters->solves++;
out:
    system_work(&s->system, counters);
    return st;
}

/* Tells whether d from x would take a point beyond an obstacle's plane. */
static bool meets(const struct spring_newton *s, const double *start, const double *x,
                  const double *d)
{
    const struct contact_set *c = &s->contact;

    for (int a = 0; a < c->nodes; a++)
        for (int o = 0; o < c->obstacles; o++) {
            const struct contact_pair *pair = &c->pair[a * c->obstacles + o];
            double gap = pair->gap;
            for (int i = 3 * a; i < 3 * a + 3; i++)
                gap += pair->normal[i % 3] * (x[i] + d[i] - start[i]);
            if (gap < -c->rounding)
                return true;
        }
    return false;
}

/* Finds d that minimises the model of the function at x within the obstacles' planes. */
static enum status solve_contact(struct spring_newton *s, const struct spring_problem *p,
                                 const double *x, enum contact_friction friction,
                                 const double *r, double *d, struct counters *counters)
{
    size_t count = 3 * (size_t)s->net->nodes;
    double *still = s->work + 2 * count;
    const struct contact_problem problem = {.k = 1,
                                            .K = (const double(*)[9])s->K,
                                            .b = r,
                                            .scale = 1,
                                            .still = still,
                                            .friction = friction};

    for (size_t t = 0; t < count; t++)
        still[t] = p->start[t] - x[t];
    memset(d, 0, count * sizeof *d);
    s->at = x;
    contact_set_forget(&s->contact);
    enum status st = contact_solve(&s->contact, &s->system, &problem, d, counters);
    iterative_forget(s->system.iterative);
    return st;
}

/* Returns the work along d of friction at sliding points, which is not in the gradient. */
static double friction_work(const struct spring_newton *s, const double *d)
{
    double sum = 0;

    for (int a = 0; contact_set_used(&s->contact) && a < s->contact.nodes; a++)
        for (int i = 0; i < 3; i++)
            sum += s->contact.node[a].friction[i] * d[3 * a + i];
    return sum;
}

/* Moves x along d as far as is good, with the residual there in r; returns the share. */
static double search(const struct spring_newton *s, const struct spring_problem *p,
                     const double *d, double *x, double *r)
{
    size_t count = 3 * (size_t)s->net->nodes;
    double *from = s->work + 2 * count, *work = s->work + 3 * count;
    double rub = friction_work(s, d), fall = product(count, r, d) + rub, part = 1;

    memcpy(from, x, count * sizeof *x);
    for (int cut = 0; cut <= MOST_CUTS; cut++) {
        for (size_t t = 0; t < count; t++)
            x[t] = from[t] + part * d[t];
        residual(s, p, x, work, r);
        double rise = -product(count, r, d) - rub;
        if (rise <= LARGEST_RISE * fall || fall < 0) /* the point began to stick */
            break;
        part *= isfinite(rise) ? fall / (fall + rise) : 0.5;
    }
    return part;
}

/* Estimates an upper bound of the next step over this one: steps shrink evenly, as the
 * Jacobian is not exact; 1 while they do not shrink fast. */
static double left(double size, double before)
{
    const double caution = 10;

    return fmin(1, caution * size / before);
}

enum status spring_newton_solve(struct spring_newton *s, const struct spring_problem *p,
                                const struct spring_limits *limits, double *x,
                                struct counters *counters)
{
    enum status st = STATUS_OK;
    size_t count = 3 * (size_t)s->net->nodes;
    double *r = s->work, *d = s->work + count;
    bool obstacles = contact_set_used(&s->contact);
    int most = limits->iterations ? limits->iterations : MOST_ITERATIONS;
    int calm = 0;
    double before = 0, moved = INFINITY; /* since K was made */
    const double still = STILL * fmin(s->net->cell[0], s->net->cell[1]);

    if (!s->supports.free_count)
        return STATUS_OK;
    if (obstacles)
        contact_set_detect(&s->contact, p->start);
    residual(s, p, x, d, r);
    for (int n = 0; n < most; n++) {
        bool bears = obstacles && contact_set_any(&s->contact);
        bool make = bears || !(moved <= still);
        if (make) {
            assemble(s, p, x);
            counters->assemblies++;
            moved = 0;
        }
        if (!bears)
            TRY(solve(s, most == 1 ? LAST_TOLERANCE : LINEAR_TOLERANCE,
                      n ? NEAR * limits->tolerance : 0, make, x, r, d, counters));
        if (bears || (obstacles && meets(s, p->start, x, d))) {
            TRY(solve_contact(s, p, x,
                              n < FRICTION_ITERATIONS ? CONTACT_FRICTION_ONCE
                                                      : CONTACT_FRICTION_KEPT,
                              r, d, counters));
            moved = INFINITY; /* the system is another */
        }
        counters->iterations++;
        double size = blocks_longest(s->net->nodes, d);
        if (!isfinite(size))
            TRY(STATUS_NAN);
        if (most == 1) {
            for (size_t t = 0; t < count; t++)
                x[t] += d[t];
            goto out;
        }
        double part = search(s, p, d, x, r);
        moved += part * size;
        calm = part * size * (part == 1 ? left(size, before) : 1) <= limits->tolerance
                   ? calm + 1
                   : 0;
        before = size;
        if (calm > bears) /* friction of a step shows in the next */
            goto out;
    }
    st = limits->iterations ? STATUS_OK : STATUS_DIVERGED;
out:
    return st;
}

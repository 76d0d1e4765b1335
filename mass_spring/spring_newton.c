#include "mass_spring/spring_newton.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/mechanics/contact_share.h"
#include "models/mechanics/frames.h"
#include "models/room.h"

/* The most iterations: a net under pressure may have to buckle within the step, away from a
 * saddle that attracts at first. */
enum { MOST_ITERATIONS = 2000, MOST_CUTS = 30 };

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

static void frames(const void *body, double (*Q)[9])
{
    const struct spring_newton *s = body;
    const int points[3] = {s->net->mesh->rows, s->net->mesh->points[1], 1};
    const int nodes = points[0] * points[1];

    for (int first = 0; first < s->net->mesh->nodes; first += nodes)
        frames_of_net(points, false, s->at + 3 * first, Q + first);
}

static enum status make_hinges(struct spring_newton *s)
{
    if (s->hinges)
        return STATUS_OK;
    s->hinges =
        malloc((size_t)s->net->graph.start[s->net->mesh->nodes] * sizeof *s->hinges);
    if (!s->hinges)
        return STATUS_MEMORY;
    spring_force_hinges(s->net, s->hinges);
    return STATUS_OK;
}

enum status spring_newton_system(struct spring_newton *s)
{
    enum status st = make_hinges(s);

    if (st != STATUS_OK || s->system.factor || s->system.iterative ||
        !s->supports->free_count)
        return st;
    int *order = NULL;
    TRY(mesh_order(s->net->mesh, &order));
    TRY(system_init(&s->system, &s->net->graph, s->supports, NULL, order, &s->linear));
    system_single(&s->system);
    st = iterative_follow(s->system.iterative, frames, s, false);
out:
    free(order);
    return st;
}

void spring_newton_clear(struct spring_newton *s)
{
    system_clear(&s->system);
    contact_coupled_clear(&s->coupled);
    free(s->hinges);
    free(s->room);
    memset(s, 0, sizeof *s);
}

enum status spring_newton_init(struct spring_newton *s, const struct spring_net *net,
                               const struct supports *supports,
                               const struct discretization *d)
{
    size_t pairs = (size_t)net->graph.start[net->graph.nodes];

    *s = (struct spring_newton){
        .net = net,
        .supports = supports,
        .linear = {.solver = d->solver, .preconditioner = d->preconditioner}};
    if (d->solver == SOLVER_AUTO)
        s->linear.solver = SOLVER_CG; /* on an earlier factor */
    return room_cut(&s->room, ROOM(s->K, pairs),
                    ROOM(s->work, 9 * (size_t)net->graph.nodes));
}

/* Computes minus the gradient at x, zero at held unknowns; `work`: for the viscous part. */
static enum status residual(const struct spring_newton *s, const struct spring_problem *p,
                            const double *x, double *work, double *r)
{
    enum status st = STATUS_OK;
    size_t count = 3 * (size_t)s->net->mesh->nodes;
    const int *place = s->supports->free_index;

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
    if (p->contact) {
        TRY(contact_find(p->contact, x));
        contact_force(p->contact, r);
    }
    for (size_t t = 0; t < count; t++)
        if (place[t] < 0)
            r[t] = 0;
out:
    return st;
}

static enum status assemble(struct spring_newton *s, const struct spring_problem *p,
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
    return p->contact ? contact_coupled_add(&s->coupled, p->contact, &s->system, s->K)
                      : STATUS_OK;
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
    size_t count = 3 * (size_t)s->net->mesh->nodes;

    s->at = x;
    iterative_tolerate(s->system.iterative, tolerance, near);
    if (made)
        TRY(contact_coupled_update(&s->coupled, &s->system, 1, (const double(*)[9])s->K, 0,
                                   NULL));
    memcpy(d, r, count * sizeof *d);
    TRY(contact_coupled_solve(&s->coupled, &s->system, d));
    counters->solves++;
out:
    system_work(&s->system, counters);
    return st;
}

/* A step of the iteration: the residual at its start, then where it leads. */
struct stride {
    const struct spring_newton *s;
    const struct spring_problem *p;
    double *r, *work;
};

static enum status look(void *self, const struct contact_change *c, double *rise)
{
    struct stride *t = self;
    const enum status st = residual(t->s, t->p, c->x, t->work, t->r);

    *rise = -product(c->count, t->r, c->d);
    return st;
}

/* Moves x along d as far as is good, with the residual there in r; *part: of d. */
static enum status search(struct spring_newton *s, const struct spring_problem *p,
                          const double *d, double *x, double *r, double *part)
{
    const size_t count = 3 * (size_t)s->net->mesh->nodes;
    struct stride stride = {s, p, r, s->work + 2 * count};

    return contact_change_take(&(struct contact_change){.count = count,
                                                        .x = x,
                                                        .d = d,
                                                        .fall = product(count, r, d),
                                                        .lower = !p->contact,
                                                        .self = &stride,
                                                        .look = look},
                               part);
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
    size_t count = 3 * (size_t)s->net->mesh->nodes;
    double *r = s->work, *d = s->work + count;
    const bool once = limits->iterations == 1;
    const int most = once || !limits->iterations ? MOST_ITERATIONS : limits->iterations;
    double before = 0, moved = INFINITY; /* since K was made */
    const double still = STILL * fmin(s->net->mesh->cell[0], s->net->mesh->cell[1]);

    if (!s->supports->free_count)
        return STATUS_OK;
    TRY(residual(s, p, x, d, r));
    for (int n = 0; n < most; n++) {
        const bool touches = p->contact && p->contact->count;
        const bool make = touches || !(moved <= still);
        if (make) {
            TRY(assemble(s, p, x));
            counters->assemblies++;
            moved = 0;
        }
        TRY(solve(s, once ? LAST_TOLERANCE : LINEAR_TOLERANCE,
                  n ? NEAR * limits->tolerance : 0, make, x, r, d, counters));
        counters->iterations++;
        double size = blocks_longest(s->net->mesh->nodes, d), part;
        if (!isfinite(size))
            TRY(STATUS_NAN);
        if (p->contact)
            contact_hold(p->contact, x, size);
        const bool cut = p->contact && contact_limit(p->contact, x, d) < 1;
        if (cut)
            size = blocks_longest(s->net->mesh->nodes, d);
        if (once ? !(p->contact && (touches || cut))
                 : !p->contact && size <= limits->tolerance) { /* whole, unsearched */
            for (size_t t = 0; t < count; t++)
                x[t] += d[t];
            goto out;
        }
        TRY(search(s, p, d, x, r, &part));
        moved = touches ? INFINITY : moved + part * size; /* contact's K changes fast */
        if (!(cut && part == 1) &&
            part * size * (part == 1 ? left(size, before) : 1) <= limits->tolerance) {
            if (!p->contact || !contact_release(p->contact))
                goto out;
            TRY(residual(s, p, x, d, r));
        }
        before = size;
    }
    st = most == MOST_ITERATIONS ? STATUS_DIVERGED : STATUS_OK;
out:
    return st;
}

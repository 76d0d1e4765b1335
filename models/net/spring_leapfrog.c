#include "models/net/spring_leapfrog.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/mechanics/frequency.h"
#include "models/mechanics/march_rest.h"
#include "models/room.h"

/* The largest tolerated fraction of the greatest stable step. */
static const double BORNE = 0.98;

/* The steps of a frame become fewer only by more than a tenth. */
static const double FEWER = 0.9;

static void discard(struct spring_leapfrog *l)
{
    if (l)
        spring_sweep_free(l->sweep), free(l->room);
    free(l);
}

static void clear(struct march *m)
{
    discard(m->own);
}

static size_t count(const struct spring_leapfrog *l)
{
    return 3 * (size_t)l->net->mesh.nodes;
}

/* Returns the factor on a velocity in a step without forces. */
static double kept(const struct spring_leapfrog *l, int node)
{
    double half = l->net->drag[node] / l->net->mass[node] * l->dt / 2;

    return (1 - half) / (1 + half);
}

static void set_neighbour(const struct spring_stencil *s, int a, int n, double push,
                          double *c)
{
    if (n >= SPRING_STENCIL_NEAR) {
        c[SWEEP_FAR + n - SPRING_STENCIL_NEAR] = push * s->bend[a][n];
    } else {
        c[SWEEP_A + n] = push * (s->bend[a][n] - s->spring[a][n] * s->square[n]);
        c[SWEEP_B + n] = push * s->spring[a][n];
    }
}

static void set_point(struct spring_leapfrog *l, int a)
{
    const struct net *load = l->net;
    const struct spring_stencil *s = l->body.stencil;
    double push = l->dt / (load->mass[a] + load->drag[a] * l->dt / 2), *c = l->c[a];

    for (int n = 0; n < SPRING_STENCIL_ALL; n++)
        set_neighbour(s, a, n, push, c);
    c[SWEEP_KEEP] = kept(l, a);
    c[SWEEP_PUSH] = push;
    for (int i = 0; i < 3; i++) {
        bool free = l->net->supports.free_index[3 * a + i] >= 0;
        c[SWEEP_FREE + i] = free;
        c[SWEEP_KICK + i] = free ? push * (load->load[3 * a + i] + s->clamp[a][i]) : 0;
    }
    if (l->net->contact)
        l->net->contact->compliance[a] = push * l->dt;
}

static void set_step(struct spring_leapfrog *l, int substeps)
{
    l->substeps = substeps;
    l->dt = l->scene->step / substeps;
    if (l->net->contact)
        l->net->contact->steps = substeps, l->net->contact->dt = l->dt;
    for (int a = 0; a < l->net->mesh.nodes; a++)
        set_point(l, a);
    spring_sweep_set(l->sweep, (const double(*)[SWEEP_COUNT])l->c);
}

/* Puts x and v; the sweep keeps x + beta v in place of x. */
static void put(struct spring_leapfrog *l, const double *x, const double *moves,
                const double *v)
{
    for (size_t n = 0; n < count(l); n++)
        l->ahead[n] = x[n] + l->net->beta * moves[n];
    spring_sweep_put(l->sweep, l->ahead, v);
}

/* Gets x; v only with stiffness damping. */
static void get(const struct spring_leapfrog *l, double *x, double *v)
{
    spring_sweep_get(l->sweep, x, l->net->beta > 0 ? v : NULL);
    for (size_t n = 0; l->net->beta > 0 && n < count(l); n++)
        x[n] -= l->net->beta * v[n];
}

/* Starts from the present x and v: v becomes that of half a step ago. The kick is found
 * from the origin's velocity, beside which it would be rounded away. */
static void start(struct spring_leapfrog *l, const double *x, const double *now)
{
    const double *base = spring_sweep_origin(l->sweep)->velocity;

    for (size_t n = 0; n < count(l); n++)
        l->kicked[n] = base[n % 3];
    put(l, x, now, l->kicked);
    spring_sweep_run(l->sweep, 0, 1);
    spring_sweep_get(l->sweep, NULL, l->kicked);
    for (size_t n = 0; n < count(l); n++) {
        bool held = l->net->supports.free_index[n] < 0;
        const double keep = l->c[n / 3][SWEEP_KEEP];
        l->v[n] =
            held ? now[n] : (2 * now[n] - (l->kicked[n] - keep * base[n % 3])) / (1 + keep);
    }
    if (l->net->beta > 0) /* the kick has moved x + beta v */
        put(l, x, l->v, l->v);
    else
        spring_sweep_put(l->sweep, NULL, l->v);
}

/* Computes the present v: the mean of half a step ago and half a step on; of held points,
 * that of the step. Leaves the sweep as it is. */
static void velocity(const struct spring_leapfrog *l, double *v)
{
    double *x = l->net->beta > 0 ? l->x : NULL, *old = l->v; /* before the kick */

    spring_sweep_get(l->sweep, x, old);
    spring_sweep_run(l->sweep, 0, 1);
    spring_sweep_get(l->sweep, NULL, v);
    spring_sweep_put(l->sweep, x, old);
    for (size_t n = 0; n < count(l); n++)
        v[n] = l->net->supports.free_index[n] < 0 ? old[n] : (old[n] + v[n]) / 2;
}

static void look(const struct march *m)
{
    velocity(m->own, m->v);
}

/* Returns how much stiffer a net is at most with its springs as long as at x: a spring is,
 * along itself. */
static double stiffer(const struct spring_leapfrog *l, const double *x)
{
    return (3 * spring_stencil_stretch2(l->body.stencil, x) - 1) / 2;
}

/* Returns the substeps that keep a share of the limit where springs are so long. */
static double needed(const struct spring_leapfrog *l, double share, double more)
{
    return fmax(1, ceil(l->scene->step * sqrt(more) / (share * l->limit)));
}

static enum status make_sweep(const struct spring_leapfrog *l, enum precision precision,
                              struct spring_sweep **sweep)
{
    const struct mesh *net = &l->net->mesh;
    const struct spring_sweep_plan plan = {
        .n = net->points[0],
        .m = net->points[1],
        .sheet = net->rows,
        .precision = precision,
        .lag = l->net->beta,
        .cells = l->body.cells,
        .origin.length = precision == PRECISION_SINGLE ? l->scene->length : 0,
        .origin.carried = l->net->supports.held_count == 0};

    return spring_sweep_make(&plan, sweep);
}

/* The ways from rest by whose forces a stiffness is found, in cells, root mean square: far
 * above round-off, far below what turns a line. */
static const double SMALL = 1e-7;

/* Computes K x from the kick at small displacements; implements frequency_body. */
static void multiply(const void *self, const double *x, double *y)
{
    const struct spring_leapfrog *l = self;
    const double shorter = fmin(l->net->mesh.cell[0], l->net->mesh.cell[1]);
    const double scale = SMALL * shorter * sqrt((double)count(l) * l->net->mass[0]);

    for (size_t n = 0; n < count(l); n++)
        l->ahead[n] = l->net->mesh.rest[n] + scale * x[n];
    spring_sweep_put(l->sweep, l->ahead, l->before);
    spring_sweep_run(l->sweep, 0, 1);
    spring_sweep_get(l->sweep, NULL, l->v);
    for (int a = 0; a < l->net->mesh.nodes; a++) {
        const double over = 1 / (scale * l->c[a][SWEEP_PUSH]);
        for (int i = 3 * a; i < 3 * a + 3; i++)
            y[i] = (l->now[i] - l->v[i]) * over;
    }
}

/* Finds the largest frequency about rest by a sweep in double precision. */
static enum status find_frequency(struct spring_leapfrog *l, double *omega)
{
    enum status st;
    const struct frequency_body body = {.supports = &l->net->supports,
                                        .mass = l->net->mass,
                                        .multiply = multiply,
                                        .self = l};

    TRY(make_sweep(l, PRECISION_DOUBLE, &l->sweep));
    set_step(l, 1);
    spring_sweep_put(l->sweep, l->net->mesh.rest, l->now);
    spring_sweep_run(l->sweep, 0, 1);
    spring_sweep_get(l->sweep, NULL, l->now);
    TRY(frequency_of_body(&body, omega));
out:
    memset(l->now, 0, count(l) * sizeof *l->now);
    spring_sweep_free(l->sweep);
    l->sweep = NULL;
    return st;
}

static enum status make(struct march *m, const struct discretization *d,
                        struct message *why)
{
    enum status st;
    const struct spring_body *body = m->moved;
    size_t nodes = (size_t)body->net->mesh.nodes;
    int substeps;
    double omega;
    struct spring_leapfrog *l = calloc(1, sizeof *l);

    if (!l)
        return STATUS_MEMORY;
    l->body = *body, l->scene = body->net->scene, l->net = body->net;
    l->asked = d->substeps;
    TRY(room_cut(&l->room, ROOM(l->c, nodes), ROOM(l->x, 3 * nodes), ROOM(l->v, 3 * nodes),
                 ROOM(l->before, 3 * nodes), ROOM(l->now, 3 * nodes),
                 ROOM(l->kicked, 3 * nodes), ROOM(l->ahead, 3 * nodes),
                 ROOM(l->shift, body->net->supports.held_count),
                 ROOM(l->next, body->net->supports.held_count)));
    supports_shift(&body->net->supports, l->scene, 0, l->shift);
    TRY(find_frequency(l, &omega));
    TRY(make_sweep(l, d->precision, &l->sweep));
    TRY(net_meet(l->net));
    l->limit = frequency_limit(omega, l->net->beta);
    TRY(frequency_steps(l->scene->step, l->limit, d->substeps, &substeps, why));
    spring_sweep_follow(l->sweep, l->net->x, l->net->v);
    set_step(l, substeps);
    start(l, l->net->x, l->net->v);
    m->own = l, l = NULL;
out:
    discard(l);
    return st;
}

/* Moves held points to time t, with the velocity of their way. */
static void hold(struct spring_leapfrog *l, double t)
{
    const struct supports *s = &l->net->supports;
    double *was = l->shift;

    supports_shift(s, l->scene, t, l->next);
    for (int h = 0; h < s->held_count; h++) {
        double v = (l->next[h] - was[h]) / l->dt;
        double x = l->net->mesh.rest[s->held[h]] + l->next[h];
        spring_sweep_hold(l->sweep, s->held[h] / 3, s->held[h] % 3, x + l->net->beta * v,
                          v);
    }
    l->shift = l->next, l->next = was;
}

bool spring_leapfrog_lacks(const struct scene *scene)
{
    return scene_needs(scene) & (SCENE_NEED_AIR | SCENE_NEED_GRIPPERS);
}

void spring_leapfrog_place(struct spring_leapfrog *l, double t)
{
    l->frame = lround(t / l->scene->step);
    supports_shift(&l->net->supports, l->scene, t, l->shift);
    memset(l->now, 0, count(l) * sizeof *l->now);
    start(l, l->net->x, l->now);
}

static enum status rest(struct march *m, struct counters *counters, struct message *why)
{
    struct spring_leapfrog *l = m->own;
    const enum status st = march_rest_equilibrium(m, counters, why);

    if (st == STATUS_OK)
        spring_leapfrog_place(l, m->time);
    return st;
}

static void tell_contact(const struct march *m, struct model_contact *contact)
{
    const struct spring_leapfrog *l = m->own;

    *contact = net_contact_report(l->net->contact);
}

static void describe(const struct march *m, struct message *line)
{
    const struct spring_leapfrog *l = m->own;

    snprintf(line->text, sizeof line->text,
             "explicit steps of %.3g s, stable below %.3g s about rest", l->dt, l->limit);
}

/* Gives a point's free components their place x and the velocity of their real way. */
static void move(struct spring_leapfrog *l, int node)
{
    for (int i = 0; i < 3; i++) {
        const int n = 3 * node + i;
        const double v = (l->x[n] - l->before[n]) / l->dt;
        if (l->net->supports.free_index[n] >= 0)
            spring_sweep_hold(l->sweep, node, i, l->x[n] + l->net->beta * v, v);
    }
}

/* Ends a step by the law of contact. In single precision the way is that of the velocity:
 * differences of places would drown the creep of friction. */
static enum status meet_bodies(struct spring_leapfrog *l, double t)
{
    enum status st;
    const struct contact *c = &l->net->contact->law;

    spring_sweep_get(l->sweep, NULL, l->v);
    for (size_t n = 0; n < count(l); n++)
        l->x[n] = l->before[n] + l->dt * l->v[n];
    TRY(net_contact_project(l->net->contact, t, l->before, l->x));
    for (int k = 0; k < c->weights; k++)
        move(l, c->node[k]);
out:
    return st;
}

/* Takes steps that need work after each. */
static enum status careful(struct spring_leapfrog *l)
{
    enum status st = STATUS_OK;

    for (int n = 1; n <= l->substeps; n++) {
        double t = ((double)l->frame + (double)n / l->substeps) * l->scene->step;
        if (l->net->contact)
            get(l, l->before, l->v);
        spring_sweep_run(l->sweep, l->dt, 1);
        if (l->net->supports.moving)
            hold(l, t);
        if (l->net->contact)
            TRY(meet_bodies(l, t));
    }
out:
    return st;
}

/* Chooses more steps for the next frame where the net has become stiffer, fewer where it no
 * longer is. */
static void watch(struct spring_leapfrog *l, const double *x)
{
    double more = stiffer(l, x);
    double borne = needed(l, BORNE, more), chosen = needed(l, frequency_chosen, more);

    if (l->asked || !isfinite(more) || chosen > FREQUENCY_MOST_STEPS)
        return;
    if (borne <= l->substeps && chosen >= FEWER * l->substeps)
        return;
    velocity(l, l->now);
    set_step(l, (int)chosen);
    start(l, x, l->now);
}

static void scale(struct spring_leapfrog *l, double factor, const double *x)
{
    velocity(l, l->now);
    supports_damp(&l->net->supports, factor, l->now);
    start(l, x, l->now);
}

/* Lets the sweep's origin follow the net at x. */
static void follow(struct spring_leapfrog *l, const double *x)
{
    if (net_origin_stays(spring_sweep_origin(l->sweep), l->net->mesh.nodes, x))
        return;
    spring_sweep_get(l->sweep, l->ahead, l->v);
    if (spring_sweep_follow(l->sweep, l->ahead, l->v))
        spring_sweep_set(l->sweep, (const double(*)[SWEEP_COUNT])l->c);
}

static bool all_finite(const double *x, size_t n)
{
    double none = 0; /* a sum of what is 0 for numbers, NaN else */

#pragma omp simd reduction(+ : none)
    for (size_t k = 0; k < n; k++)
        none += x[k] - x[k];
    return none == 0;
}

/* Weighs the end of a frame: what the sweep does not tell of held points. */
static enum status weigh(struct march *m)
{
    enum status st;
    const struct spring_leapfrog *l = m->own;
    const double beta = l->net->beta, t = (double)l->frame * l->scene->step;

    for (size_t n = 0; n < count(l); n++)
        l->ahead[n] = l->net->x[n] + (beta > 0 ? beta * l->v[n] : 0);
    TRY(large_body_force(&m->body, &large_path_statics, l->ahead, m->work));
    net_weigh(l->net, t, l->dt, m->work, l->next, m->reaction);
    if (l->net->contact)
        memcpy(m->push, l->net->contact->push,
               (size_t)l->scene->obstacle_count * sizeof *m->push);
out:
    return st;
}

static enum status step(struct march *m, double t, struct counters *counters)
{
    enum status st = STATUS_OK;
    struct spring_leapfrog *l = m->own;
    double *x = l->net->x;

    (void)t; /* l->frame has it without the rounding of a sum */
    m->rested = false;

    net_contact_frame(l->net->contact);
    if (l->net->contact || l->net->supports.moving)
        TRY(careful(l));
    else
        spring_sweep_run(l->sweep, l->dt, l->substeps);
    l->frame++;
    counters->substeps += l->substeps;
    counters->assemblies += l->substeps;
    get(l, x, l->v);
    if (!all_finite(x, count(l)))
        return STATUS_NAN;
    if (m->weighed)
        TRY(weigh(m));
    if (l->net->keep != 1)
        scale(l, l->net->keep, x);
    follow(l, x);
    watch(l, x);
out:
    return st;
}

const struct march_integrator spring_leapfrog_integrator = {
    .explicit = true,
    .make = make,
    .step = step,
    .rest = rest,
    .modes = march_rest_modes,
    .describe = describe,
    .contact = tell_contact,
    .look = look,
    .clear = clear,
};

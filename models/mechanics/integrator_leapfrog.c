/* integrator_leapfrog.c - a body at large displacements in time by explicit leapfrog steps
 * (central differences; Hughes 2000, The Finite Element Method, 9.1), second order:
 *     v(n+1/2) = ((1 - alpha dt/2) v(n-1/2) + dt a(n)) / (1 + alpha dt/2),
 *     x(n+1) = x(n) + dt v(n+1/2),   M a(n) = load - f(x(n)),
 * whose first and last kicks in a frame are half ones, v(n) the mean of v(n-1/2) and
 * v(n+1/2): v belongs to x at its ends.
 * Stiffness damping takes the rate of strain of half a step ago: first order in beta. Air
 * takes the velocity of half a step ago and the acceleration then, for the present one. No
 * tangent is made in a step.
 *
 * Mass. Row sums (lumped_mass.h): M is diagonal, and a step costs its forces. Of a body
 * that says what is beyond them (march.h) M^-1 is D^-1 + D^-1 beyond D^-1, D the row
 * sums: symmetric, and positive where the mass D - beyond is below 2 D.
 *
 * Steps. A frame has as many as keep 0.95 of the greatest stable step about rest,
 * sqrt(beta^2 + 4 / omega^2) - beta, omega the largest frequency by Lanczos' method. A
 * sheet that is stretched is stiffer: after every frame its energy is compared with the
 * least it has had since, the work of supports and pressure apart. A frame that has
 * gained is done again in twice as many steps, which then stay; one that gains in 256 times
 * as many, or in the number that was asked for, is a death.
 *
 * Contact moves the nodes at the end of each step (contact_project).
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/krylov.h"
#include "models/mechanics/frequency.h"
#include "models/mechanics/march_rest.h"
#include "models/mechanics/reaction.h"
#include "models/room.h"
#include "models/vector.h"

/* The steps of a frame are doubled so many times at most. */
enum { DOUBLINGS = 8 };

/* The energy that a frame may gain, as a share of the most that moved or was stored so far.
 * Stable steps exchange the energy of what they hardly resolve; unstable ones gain this
 * much in a few frames from nothing. */
static const double GAIN = 0.05;

/* A momentum has this relative error where frames are watched, and in what is told; the
 * kinetic energy has its square. */
static const double WATCHED = 1e-2, TOLD = 1e-7;

/* Strains below this are round-off. */
static const double ROUND_OFF = 1e-10;

struct leapfrog {
    struct march *m; /* borrowed                                              */
    void *room;      /* memory of the arrays                          owned   */
    int asked, substeps, doublings;
    double limit;       /* greatest stable step about rest                   [s]   */
    double least, most; /* energy so far, see judge                          [J]   */
    double work;        /* of what moves: supports and bodies; and of pressure, which has no
                           potential where an edge is free                          [J]   */
    double stored;      /* elastic energy, and the loads' potential, at x    [J]   */
    double *inverse;    /* [nodes][3] row sums: 1/mass, 0 of held unknowns         */
    int *fixed; /* [nodes][3] with contact: negative where it moves nothing: held unknowns,
                   and all of nodes with frames                                       */
    double *a;  /* [nodes][3] acceleration at x, 0 of held unknowns        */
    double *x_start, *v_start; /* [nodes][3] where the frame began                      */
    double *before;            /* [nodes][3] with contact                                 */
    double *compliance;        /* [nodes] with contact: dt^2 / mass               [m/N]   */
    double *blow;              /* [nodes][3] force of pressure and air at x         [N]   */
    double *pull;  /* [held_count] force less load                                       */
    double *reach; /* [held_count] with m->beyond: beyond a of the last add_beyond       */
    double *along; /* [frames] as pull, along the ways that are free                     */
    double *shift; /* [held_count] with supports that move: the step's way    */
    double *momentum, *image; /* [nodes][3] with m->beyond: of the free unknowns at the
                                 last frame's end [kg m/s]; work                         */
    double *krylov;           /* with m->beyond: work                                    */
};

static double step_of(const struct leapfrog *l)
{
    return l->m->dt / l->substeps;
}

static void discard(struct leapfrog *l)
{
    if (l)
        free(l->room);
    free(l);
}

static void clear(struct march *m)
{
    discard(m->own);
}

static void make_mass(struct leapfrog *l)
{
    const struct march *m = l->m;

    for (size_t t = 0; t < march_count(l->m); t++) {
        double mass = m->M[m->graph->start[t / 3]];
        l->inverse[t] = m->supports->free_index[t] < 0 ? 0 : 1 / mass;
        if (l->fixed)
            l->fixed[t] = m->supports->frame_count && m->supports->framed[t / 3] >= 0
                              ? -1
                              : m->supports->free_index[t];
    }
}

/* Chooses the step with the tangent about rest, m->K; l->a is work. */
static enum status choose_step(struct leapfrog *l, struct message *why)
{
    enum status st;
    struct march *m = l->m;
    double omega;

    m->factored = -1;
    TRY(large_body_tangent(&m->body, &large_path_statics, m->rest,
                           (struct large_foresight){0}, m->K));
    for (int a = 0; a < m->graph->nodes; a++)
        l->a[a] = m->M[m->graph->start[a]];
    TRY(frequency_largest(m->graph, m->supports, l->a, m->beyond, (const double(*)[9])m->K,
                          &omega));
    l->limit = frequency_limit(omega, m->beta);
    TRY(frequency_steps(m->dt, l->limit, l->asked, &l->substeps, why));
out:
    return st;
}

static enum status make(struct march *m, const struct discretization *d,
                        struct message *why)
{
    enum status st;
    struct leapfrog *l = NULL;
    size_t count = march_count(m);
    bool meets = m->contact != NULL, moving = m->supports->moving;
    size_t held = moving ? (size_t)supports_most(m->supports) : 0;

    l = calloc(1, sizeof *l);
    if (!l)
        return STATUS_MEMORY;
    l->m = m, l->asked = d->substeps;
    TRY(room_cut(
        &l->room, ROOM(l->a, count), ROOM(l->x_start, count), ROOM(l->v_start, count),
        ROOM(l->inverse, count), ROOM(l->momentum, m->beyond ? count : 0),
        ROOM(l->image, m->beyond ? count : 0),
        ROOM(l->krylov, m->beyond ? krylov_cg_work((int)count) : 0),
        ROOM(l->before, meets ? count : 0), ROOM(l->compliance, meets ? count / 3 : 0),
        ROOM(l->fixed, meets ? count : 0),
        ROOM(l->blow, m->scene->pressure != 0 || m->scene->air.density > 0 ? count : 0),
        ROOM(l->pull, supports_most(m->supports)), ROOM(l->along, m->supports->frame_count),
        ROOM(l->reach, m->beyond ? supports_most(m->supports) : 0), ROOM(l->shift, held)));
    TRY(choose_step(l, why));
    make_mass(l);
    m->own = l, l = NULL;
out:
    discard(l);
    return st;
}

/* Looks at what is held now. */
static enum status hold(struct march *m)
{
    struct leapfrog *l = m->own;
    struct message why;
    enum status st = STATUS_OK;

    if (!l->asked)
        TRY(choose_step(l, &why));
    l->substeps <<= l->doublings;
    make_mass(l);
out:
    return st;
}

/* Computes D^-1 F of the free unknowns in place of F, D the row sums. */
static void divide(const struct leapfrog *l, double *F)
{
    supports_to_frames(l->m->supports, F);
    for (size_t t = 0; t < march_count(l->m); t++)
        F[t] *= l->inverse[t];
    supports_from_frames(l->m->supports, F);
}

/* Adds to a = D^-1 F what the mass lacks of D: D^-1 beyond a. What is held has to be pulled
 * against inertia by -beyond a, so that sums of D and velocities are the momentum. */
static void add_beyond(const struct leapfrog *l, double *a)
{
    blocks_multiply_mass(l->m->graph, l->m->beyond, a, l->image);
    for (int h = 0; h < l->m->supports->held_count; h++)
        l->reach[h] = supports_get(l->m->supports, h, l->image);
    divide(l, l->image);
    for (size_t t = 0; t < march_count(l->m); t++)
        a[t] += l->image[t];
}

/* Computes the velocity v of a momentum. */
static void velocity_of(void *self, const double *momentum, double *v)
{
    const struct leapfrog *l = self;

    memcpy(v, momentum, march_count(l->m) * sizeof *v);
    divide(l, v);
    add_beyond(l, v);
}

/* Computes the momentum of a velocity by row sums. */
static enum status heavy(void *self, const double *v, double *momentum)
{
    const struct leapfrog *l = self;

    memcpy(momentum, v, march_count(l->m) * sizeof *v);
    supports_to_frames(l->m->supports, momentum);
    for (size_t t = 0; t < march_count(l->m); t++)
        momentum[t] = l->inverse[t] > 0 ? momentum[t] / l->inverse[t] : 0;
    supports_from_frames(l->m->supports, momentum);
    return STATUS_OK;
}

/* Returns the free unknowns' kinetic energy; NaN: it cannot be had. */
static double kinetic(const struct leapfrog *l, double tolerance)
{
    const struct march *m = l->m;
    double *y = m->work, *v = m->v, sum = 0;
    bool done = true;

    if (m->beyond) {
        struct krylov k = {.n = (int)march_count(l->m),
                           .self = (void *)l,
                           .multiply = velocity_of,
                           .precondition = heavy,
                           .tolerance = tolerance,
                           .most = (int)march_count(l->m),
                           .work = l->krylov};
        if (krylov_cg(&k, v, l->momentum, &done) != STATUS_OK)
            return NAN;
        y = l->momentum;
    } else {
        blocks_multiply_mass(m->graph, m->M, v, y);
    }
    supports_zero(m->supports, y);
    for (size_t t = 0; t < march_count(l->m); t++)
        sum += v[t] * y[t] / 2;
    return sum;
}

/* Returns how much the stress takes of the strains' rate, in steps; a plain body's damping
 * is by its tangent. */
static double rate_of(const struct leapfrog *l)
{
    return l->m->V ? 0 : l->m->beta / step_of(l);
}

/* Adds a plain body's damping, of v half a step ago, to the forces in l->a. */
static enum status damp_plain(struct leapfrog *l)
{
    enum status st;
    struct march *m = l->m;
    const struct large_path path = {.s1 = 1, .g1 = 1, .x_old = m->x};

    TRY(large_body_tangent(&m->body, &path, m->x, (struct large_foresight){0}, m->V));
    blocks_multiply(m->graph, (const double(*)[9])m->V, m->v, m->work);
    for (size_t t = 0; t < march_count(l->m); t++)
        l->a[t] += m->beta * m->work[t];
out:
    return st;
}

/* Computes what blows at time t; `since` the time for which v is known. */
static void blow(struct leapfrog *l, double t, double since)
{
    struct march *m = l->m;
    double *v = m->work;

    memset(l->blow, 0, march_count(m) * sizeof *l->blow);
    if (m->pressure.value != 0)
        pressure_force(&m->pressure, 1, NULL, 1, m->x, l->blow);
    if (m->air.density == 0)
        return;
    air_blow(&m->air, m->scene, t);
    for (size_t k = 0; k < march_count(m); k++)
        v[k] = m->v[k] + (since > 0 ? since * (l->a[k] - m->alpha * m->v[k]) : 0);
    air_force(&m->air, 1, &(struct air_motion){.x = m->x, .v = v, .share = 1}, l->blow);
}

/* Computes a at x and time t; features that the scene lacks cost nothing. */
static enum status accelerate(struct leapfrog *l, double t, double since,
                              struct counters *counters)
{
    enum status st;
    struct march *m = l->m;
    double *a = l->a, rate = rate_of(l);
    const struct large_path path = {
        .s0 = -rate, .s1 = 1 + rate, .g1 = 1, .strain_old = m->strain_old};

    if (l->blow)
        blow(l, t, since);
    TRY(large_body_force(&m->body, &path, m->x, a));
    if (m->V)
        TRY(damp_plain(l));
    for (size_t k = 0; l->blow && k < march_count(l->m); k++)
        a[k] -= l->blow[k];
    if (rate > 0)
        TRY(large_body_strain(&m->body, m->x, m->strain_old));
    for (int h = 0; h < m->supports->held_count; h++)
        l->pull[h] =
            supports_get(m->supports, h, a) - supports_get(m->supports, h, m->load);
    counters->assemblies++;
    for (size_t k = 0; k < march_count(l->m); k++)
        a[k] = m->load[k] - a[k];
    for (int n = 0; n < m->supports->frame_count; n++)
        l->along[n] = -vector_dot(m->supports->frame[n].axes,
                                  a + 3 * (size_t)m->supports->frame[n].node);
    divide(l, a);
    if (m->beyond)
        add_beyond(l, a);
    for (int h = 0; m->beyond && h < m->supports->held_count; h++)
        l->pull[h] -= l->reach[h];
out:
    return st;
}

/* Returns the free unknowns' kinetic and all stored energy, less the work put in. */
static double energy_now(const struct leapfrog *l)
{
    return l->stored - l->work + kinetic(l, WATCHED);
}

static enum status store(struct leapfrog *l, double *elastic)
{
    const struct march *m = l->m;
    enum status st = m->body.energy(m->body.self, m->x, elastic);

    if (m->contact)
        *elastic += m->contact->energy;
    l->stored = *elastic;
    for (size_t t = 0; t < march_count(l->m); t++)
        l->stored -= m->load[t] * (m->x[t] - m->rest[t]);
    return st;
}

/* Starts from any x and v at time t. */
static enum status begin(struct leapfrog *l, double t, struct counters *counters)
{
    enum status st;
    struct march *m = l->m;
    double elastic, *x_before = m->newton;

    march_follow(m, t);
    for (size_t k = 0; rate_of(l) > 0 && k < march_count(l->m); k++)
        x_before[k] = m->x[k] - step_of(l) * m->v[k];
    if (rate_of(l) > 0)
        TRY(large_body_strain(&m->body, x_before, m->strain_old));
    TRY(accelerate(l, t, 0, counters));
    TRY(store(l, &elastic));
    m->started = true;
out:
    return st;
}

/* Returns the kinetic energy of what is free of nodes with frames. */
static double kinetic_along(const struct leapfrog *l)
{
    const struct march *m = l->m;
    const struct supports_frame *f = m->supports->frame;
    double sum = 0;

    for (int n = 0; n < m->supports->frame_count; n++) {
        const double v = vector_dot(f[n].axes, m->v + 3 * (size_t)f[n].node);
        sum += m->M[m->graph->start[f[n].node]] * v * v / 2;
    }
    return sum;
}

/* Moves held unknowns to time t. What frames gain as they turn is the supports' work. */
static void move_supports(struct leapfrog *l, double t, double dt)
{
    struct march *m = l->m;
    struct supports *s = m->supports;
    double *v = m->v;

    l->work -= kinetic_along(l);
    supports_turn(s, m->scene, t, t, m->x);
    l->work += kinetic_along(l);
    struct march_held held = march_path(m, t, dt);
    for (int h = 0; h < s->held_count; h++) {
        const double x = supports_get(s, h, m->rest) + held.d[h];
        const double from =
            supports_get(s, h, m->x) - dt * supports_get(s, h, v); /* before the drift */
        supports_set(s, h, m->x, x);
        supports_set(s, h, v, held.v[h]);
        l->shift[h] = x - from;
    }
}

/* Adds half of a step's work by the forces at x. */
static void add_work(struct leapfrog *l)
{
    const struct supports *s = l->m->supports;
    const double half = step_of(l) / 2;

    for (int h = 0; s->moving && h < s->held_count; h++)
        l->work += l->pull[h] * l->shift[h] / 2;
    for (size_t t = 0; l->blow && t < march_count(l->m); t++)
        l->work += l->blow[t] * half * l->m->v[t];
}

/* Ends a step that began at time t by contact; v is then that of the real way. */
static enum status meet(struct leapfrog *l, double t, double dt)
{
    struct march *m = l->m;
    const double share = 1 + m->alpha * dt / 2;

    for (int a = 0; a < m->graph->nodes; a++)
        l->compliance[a] = dt * dt / share / m->M[m->graph->start[a]];
    contact_begin(m->contact, t, dt, l->before);
    enum status st = contact_project(m->contact, l->compliance, l->fixed, m->x);
    for (size_t k = 0; m->contact->count && k < march_count(l->m); k++)
        if (l->fixed[k] >= 0)
            m->v[k] = (m->x[k] - l->before[k]) / dt;
    l->work += contact_body_work(m->contact, m->x);
    contact_force_bodies(m->contact, m->x, 1.0 / l->substeps, m->push);
    if (m->weighed && m->contact->count) {
        memset(m->work, 0, march_count(m) * sizeof *m->work);
        contact_force(m->contact, m->work);
        reaction_add(m->supports, m->work, m->x, 1.0 / l->substeps, m->reaction);
    }
    return st;
}

/* Adds `share` of what supports have to do against the forces at x. */
static enum status weigh(struct leapfrog *l, double share)
{
    enum status st = STATUS_OK;
    struct march *m = l->m;
    double *left = m->work;

    if (!m->weighed)
        return st;
    if (m->clamps) {
        TRY(large_body_force(&m->body, &large_path_statics, m->x, left));
        reaction_clamps(m->scene, m->graph->nodes, left, m->x, share, m->reaction);
    }
    memset(left, 0, march_count(m) * sizeof *left);
    for (int h = 0; h < m->supports->held_count; h++)
        supports_set(m->supports, h, left, -l->pull[h]);
    for (int n = 0; !m->beyond && n < m->supports->frame_count; n++)
        for (int i = 0; i < 3; i++)
            left[3 * (size_t)m->supports->frame[n].node + i] -=
                l->along[n] * m->supports->frame[n].axes[i];
    reaction_add(m->supports, left, m->x, share, m->reaction);
out:
    return st;
}

/* Adds what they do against inertia and damping in a frame. */
static void weigh_inertia(struct leapfrog *l)
{
    struct march *m = l->m;
    const size_t count = march_count(m);
    const double frame = m->dt;
    double *gain = m->work, *left = gain + count, *held = left + count;

    if (!m->weighed)
        return;
    for (size_t t = 0; t < count; t++)
        gain[t] = -(m->v[t] - l->v_start[t] + m->alpha * (m->x[t] - l->x_start[t])) / frame;
    memset(held, 0, count * sizeof *held);
    for (int h = 0; h < m->supports->held_count; h++)
        supports_set(m->supports, h, held, supports_get(m->supports, h, gain));
    blocks_multiply_mass(m->graph, m->M, m->beyond ? held : gain, left);
    reaction_add(m->supports, left, m->x, 1, m->reaction);
}

/* Computes v <- keep v + push a where nothing is held. */
static void kick(struct leapfrog *l, double keep, double push)
{
    const struct supports *s = l->m->supports;
    double *v = l->m->v;

    supports_to_frames(s, v);
    supports_to_frames(s, l->a);
    for (size_t t = 0; t < march_count(l->m); t++)
        v[t] = l->inverse[t] > 0 ? keep * v[t] + push * l->a[t] : v[t];
    supports_from_frames(s, v);
    supports_from_frames(s, l->a);
}

/* Runs a frame from time t. */
static enum status run(struct leapfrog *l, double t, struct counters *counters)
{
    enum status st = STATUS_OK;
    struct march *m = l->m;
    double dt = step_of(l), half = m->alpha * dt / 2;
    bool moving = m->supports->moving;

    march_forget(m);
    TRY(weigh(l, 0.5 / l->substeps));
    for (int n = 0; n < l->substeps; n++) {
        if (n)
            kick(l, (1 - half) / (1 + half), dt / (1 + half));
        else
            kick(l, 1 - half, dt / 2);
        if (l->before)
            memcpy(l->before, m->x, march_count(l->m) * sizeof *m->x);
        for (size_t k = 0; k < march_count(l->m); k++)
            m->x[k] += dt * m->v[k];
        if (moving)
            move_supports(l, t + (n + 1) * dt, dt);
        if (l->before)
            TRY(meet(l, t + n * dt, dt));
        add_work(l);
        TRY(accelerate(l, t + (n + 1) * dt, dt / 2, counters));
        add_work(l);
        TRY(weigh(l, (n < l->substeps - 1 ? 1 : 0.5) / l->substeps));
        counters->substeps++;
    }
    kick(l, 1 / (1 + half), dt / 2 / (1 + half));
    weigh_inertia(l);
out:
    return st;
}

/* Rejects a state that has gained energy: STATUS_GAINED. */
static enum status judge(struct leapfrog *l)
{
    const struct scene *s = l->m->scene;
    const struct law law = scene_law(s);
    double elastic, round_off = law.young * s->length * s->width * law.thickness;
    enum status st = store(l, &elastic);

    if (st != STATUS_OK)
        return st;
    double now = energy_now(l), moved = now - (l->stored - l->work) + elastic;
    l->most = fmax(l->most, moved);
    if (!(now - l->least <= GAIN * l->most + ROUND_OFF * ROUND_OFF * round_off))
        return STATUS_GAINED;
    l->least = fmin(l->least, now);
    return STATUS_OK;
}

/* Restores the state where the frame began. */
static void restore(struct leapfrog *l, double work)
{
    size_t bytes = march_count(l->m) * sizeof *l->a;

    memcpy(l->m->x, l->x_start, bytes);
    memcpy(l->m->v, l->v_start, bytes);
    l->work = work;
    l->m->started = false;
}

static double told_kinetic(const struct march *m)
{
    return kinetic(m->own, TOLD);
}

static void describe(const struct march *m, struct message *line)
{
    const struct leapfrog *l = m->own;

    snprintf(line->text, sizeof line->text,
             "explicit steps of %.3g s, %d a frame; about rest %.3g s are stable; row sums "
             "of the mass%s",
             step_of(l), l->substeps, l->limit,
             m->beyond ? ", and once more of what they leave out" : "");
}

static enum status step(struct march *m, double t, struct counters *counters)
{
    enum status st = STATUS_OK;
    struct leapfrog *l = m->own;
    size_t bytes = march_count(l->m) * sizeof *m->x;
    bool first = !m->started;
    double work = l->work;

    m->rested = false;
    memcpy(l->x_start, m->x, bytes);
    for (;;) {
        if (!m->started)
            TRY(begin(l, t, counters));
        memcpy(l->v_start, m->v, bytes);
        l->least = first ? energy_now(l) : fmin(l->least, energy_now(l));
        l->most = first ? 0 : l->most;
        first = false;
        st = run(l, t, counters);
        if (st == STATUS_OK)
            st = judge(l);
        if (st == STATUS_OK)
            return STATUS_OK;
        restore(l, work);
        if (!status_is_death(st) || l->asked || l->doublings == DOUBLINGS)
            return st;
        l->substeps *= 2;
        l->doublings++;
    }
out:
    return st;
}

const struct march_integrator integrator_leapfrog = {
    .explicit = true,
    .make = make,
    .step = step,
    .hold = hold,
    .rest = march_rest_equilibrium,
    .modes = march_rest_modes,
    .kinetic = told_kinetic,
    .describe = describe,
    .clear = clear,
};

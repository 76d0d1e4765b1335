#include "models/mechanics/march_rest.h"

#include <math.h>
#include <string.h>

#include "models/mechanics/contact_system.h"
#include "models/mechanics/march.h"
#include "models/mechanics/large_newton.h"
#include "models/mechanics/pencil.h"
#include "models/mechanics/reaction.h"
#include "models/vector.h"

/* Rest: the unbalanced share of the loads and the supports' reactions is below this. */
static const double RESIDUAL = 1e-6;

/* The error of a step, in the slip from which friction is whole: friction is off by the
 * square of it. */
static const double SLIP = 1e-3;

/* The mass is multiplied by FAILED after a step that failed, by SHORTER where the step
 * needed a tangent without stress - a shape with an unstable way out is to be left - or
 * moved too far, and by GOOD where it went well. (tools/constants, a sheet that comes to
 * lie on a sphere: 1119 tangents; with half and twice FAILED 1645 and 1186, SHORTER 1919
 * and 1753, GOOD 1574 and no rest, FARTHEST 1052 and 2249.) */
static const double FAILED = 8, SHORTER = 2, GOOD = 0.5;

/* The share of the length beyond which a node's move in a step makes the next one shorter;
 * less than half of it makes the next longer: the way down is followed, not leapt. */
static const double FARTHEST = 0.02;

/* The mass of the longest step, relative to that of the scene's step. */
static const double LONGEST = 1e-8;

enum { MOST_STEPS = 600 };

/* Begins a step at `last` as one of the scene's: friction is that of the way in its time.
 */
static void begin_contact(struct march *m, const double *last)
{
    contact_begin_rest(m->contact, supports_rest_time(m->supports, m->scene),
                       m->scene->step, last);
}

/* Returns the slip of a step from which friction is whole, INFINITY without friction. */
static double whole_slip(const struct march *m)
{
    return m->contact && contact_rubs(m->contact) ? m->contact->body.creep * m->scene->step
                                                  : INFINITY;
}

/* Returns the friction of what slips faster than friction lets creep what it holds. */
static double sliding(const struct contact *c)
{
    double sum = 0;

    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++)
        sum += t->grip > 0 ? 0 : vector_length(t->rub);
    return sum;
}

/* Computes the unbalanced share of the loads and the supports' reactions at m->x. */
static enum status unbalanced(struct march *m, double *share)
{
    enum status st;
    const size_t count = march_count(m);
    double *f = m->newton + 2 * count, *load = f + count, left = 0, borne = 0;

    memcpy(load, m->load, count * sizeof *load);
    if (m->pressure.value != 0)
        pressure_force(&m->pressure, 1, NULL, 1, m->x, load);
    if (m->air.density > 0)
        air_force(&m->air, 1, &(struct air_motion){.x = m->x, .share = 1}, load);
    TRY(large_body_force(&m->body, &large_path_statics, m->x, f));
    for (size_t t = 0; t < count; t++)
        f[t] = load[t] - f[t];
    if (m->contact) {
        TRY(contact_find(m->contact, m->x));
        contact_force(m->contact, f);
        left = sliding(m->contact);
    }
    for (int h = 0; h < m->supports->held_count; h++)
        borne += fabs(supports_get(m->supports, h, f));
    supports_zero(m->supports, f);
    for (int a = 0; a < m->graph->nodes; a++) {
        left += vector_length(f + 3 * (size_t)a);
        borne += vector_length(load + 3 * (size_t)a);
    }
    *share = left > 0 ? left / borne : 0;
out:
    return st;
}

/* Steps from m->x, which stays there on failure; *moved: the farthest that a node moved. */
static enum status step_down(struct march *m, double mass, double *moved,
                             struct counters *counters)
{
    enum status st;
    size_t count = march_count(m);
    double *last = m->newton, *way = m->newton + 2 * count;
    const struct large_equation q = {
        .path = {.s1 = 1, .g1 = 1, .x_old = last, .strain_old = m->strain_old},
        .mass = mass,
        .hat = last,
        .load = 1,
        .tolerance = fmin(SLIP * whole_slip(m), 1e-7 * m->scene->length),
        .limit = 30};

    memcpy(last, m->x, count * sizeof *last);
    if (m->contact)
        begin_contact(m, last);
    TRY(large_body_strain(&m->body, last, m->strain_old));
    m->factored = -1;
    st = large_newton_solve(m, &q, m->x, counters);
    for (size_t t = 0; t < count; t++)
        way[t] = m->x[t] - last[t];
    *moved = blocks_longest(m->graph->nodes, way);
    if (st != STATUS_OK)
        memcpy(m->x, last, count * sizeof *last);
out:
    return st;
}

/* Returns the factor from this step's mass to the next one's. */
static double growth(const struct march *m, enum status st, double moved)
{
    double farthest = FARTHEST * m->scene->length;

    if (st != STATUS_OK)
        return FAILED;
    if (m->stressless || moved > farthest)
        return SHORTER;
    return moved < GOOD * farthest ? GOOD : 1;
}

/* Moves m->x, any shape with held unknowns where they shall be, to equilibrium by steps
 * downhill (march_rest.h). */
static enum status settle(struct march *m, struct counters *counters, struct message *why)
{
    enum status st = STATUS_OK;
    double first = 1 / (m->scene->step * m->scene->step), mass = first;
    double left = INFINITY, moved = 0;
    int n = 0;

    for (; n < MOST_STEPS && left > RESIDUAL; n++) {
        st = step_down(m, mass, &moved, counters);
        if (st != STATUS_OK && !status_is_death(st))
            goto out;
        mass = fmax(mass * growth(m, st, moved), LONGEST * first);
        if (st == STATUS_OK)
            TRY(unbalanced(m, &left));
    }
    if (left > RESIDUAL)
        TRY(status_fail(why, STATUS_DIVERGED,
                        "no equilibrium in %d steps: forces of %.3g of the loads are left",
                        n, left));
    status_fail(why, STATUS_OK,
                "Relaxed in %d steps: forces of %.2g of the loads are left unbalanced.", n,
                left);
out:
    m->factored = -1;
    return st;
}

/* The load or the paths' time grows by increments: the first; the smallest before giving
 * up, also along a path; the largest along a path. */
static const double FIRST_INCREMENT = 1.0 / 8, SMALLEST_INCREMENT = 1e-7,
                    SMALLEST_MOVE = 1e-6, LARGEST_MOVE = 1.0 / 16;
enum { MOST_INCREMENTS = 2000 };

/* This grows from 0 to 1: the load, then the time of the supports' paths. */
enum stage { LOADING, MOVING };

static void begin(struct march *m)
{
    size_t count = march_count(m);

    march_still(m, m->time);
    memcpy(m->x, m->rest, count * sizeof *m->x);
    memcpy(m->newton, m->rest, count * sizeof *m->x);
    supports_turn_back(m->supports);
    m->rested = false;
    m->halvings = 0;
}

/* Places held unknowns for this part of the stage; m->newton has the last shape. */
static void place(struct march *m, enum stage stage, double part)
{
    double t = stage == MOVING ? part * m->scene->end : 0;
    double scale = stage == LOADING ? part : 1;
    struct supports *s = m->supports;

    supports_turn(s, m->scene, t, t, m->newton);
    supports_shift(s, m->scene, t, m->held);
    for (int h = 0; h < s->held_count; h++)
        supports_set(s, h, m->x, supports_get(s, h, m->rest) + scale * m->held[h]);
    if (s->moving)
        supports_carry(s, m->newton, m->x);
}

/* Finds the shape at `part`, guessed `ahead` times as far beyond the last two shapes as
 * they are apart. */
static enum status increment_to(struct march *m, enum stage stage, double part,
                                double ahead, struct counters *counters)
{
    enum status st;
    size_t count = march_count(m);
    const double *last = m->newton, *before = m->newton + count;
    const struct large_equation q = {
        .path = large_path_statics, .load = stage == LOADING ? part : 1, .limit = 30};

    TRY(large_body_strain(&m->body, last, m->strain_old));
    for (size_t t = 0; t < count; t++)
        m->x[t] = last[t] + ahead * (last[t] - before[t]);
    place(m, stage, part);
    m->factored = -1;
    TRY(large_newton_solve(m, &q, m->x, counters));
out:
    return st;
}

/* Goes downhill to a shape at `part` that is far off, as a snapping sheet does, and solves
 * from there: where moving supports leave none near the last one, and where growing loads
 * fail, since a sheet that hangs from a hinge or from corners has no stiffness at first. */
static enum status snap(struct march *m, enum stage stage, double part,
                        struct counters *counters)
{
    enum status st;
    const size_t bytes = march_count(m) * sizeof(double);

    memcpy(m->x, m->newton, bytes);
    place(m, stage, part);
    TRY(settle(m, counters, NULL));
    memcpy(m->newton, m->x, bytes);
    TRY(increment_to(m, stage, part, 0, counters));
out:
    return st;
}

/* This is the state of a stage. */
struct progress {
    double part, increment, last_increment;
    bool stable; /* MOVING: the last shape is */
};

/* Accepts m->x, the shape at `part`. */
static void accept(struct march *m, struct progress *p, enum stage stage, double part)
{
    size_t count = march_count(m);
    double *last = m->newton, *before = m->newton + count;

    memcpy(before, part > 0 ? last : m->x, count * sizeof *last);
    memcpy(last, m->x, count * sizeof *last);
    p->last_increment = part - p->part;
    p->part = part;
    p->stable = stage == MOVING && m->added == 0;
}

/* Does all of a stage from the present shape. */
static enum status follow(struct march *m, enum stage stage, struct counters *counters)
{
    enum status st = STATUS_DIVERGED;
    struct progress p = {.increment = FIRST_INCREMENT};
    double smallest = stage == MOVING ? SMALLEST_MOVE : SMALLEST_INCREMENT;

    accept(m, &p, stage, 0);
    for (int n = 0; p.part < 1 && n < MOST_INCREMENTS; n++) {
        long iterations = counters->iterations;
        double next = fmin(1, p.part + p.increment);
        double ahead = p.last_increment > 0 ? (next - p.part) / p.last_increment : 0;
        st = increment_to(m, stage, next, ahead, counters);
        bool unstable = st == STATUS_OK && p.stable && m->added > 0;
        double shorter = (next - p.part) / 4;
        if (st == STATUS_OK && (!unstable || shorter < smallest)) {
            accept(m, &p, stage, next);
            if (counters->iterations - iterations < 10)
                p.increment *= 2;
            if (stage == MOVING)
                p.increment = fmin(p.increment, LARGEST_MOVE);
            continue;
        }
        p.increment = shorter;
        if (stage == MOVING && status_is_death(st) && shorter < smallest &&
            snap(m, stage, next, counters) == STATUS_OK) {
            accept(m, &p, stage, next);
            p.last_increment = 0;
            p.increment = FIRST_INCREMENT;
            st = STATUS_OK;
            continue;
        }
        if ((st != STATUS_OK && !status_is_death(st)) || shorter < smallest)
            break;
    }
    if (st == STATUS_OK && p.part < 1)
        st = STATUS_DIVERGED;
    memcpy(m->x, m->newton, march_count(m) * sizeof *m->x);
    m->factored = -1;
    return st;
}

enum status march_rest_equilibrium(struct march *m, struct counters *counters,
                                   struct message *why)
{
    enum status st;
    const struct large_equation whole = {.path = large_path_statics, .load = 1};

    begin(m);
    if (m->contact) {
        place(m, LOADING, 1);
        TRY(settle(m, counters, why));
        m->rested = true;
        contact_force_bodies(m->contact, m->x, 1, m->push);
        return large_newton_weigh(m, &whole, 1);
    }
    st = follow(m, LOADING, counters);
    if (status_is_death(st)) {
        begin(m);
        st = snap(m, LOADING, 1, counters);
    }
    if (st == STATUS_OK && m->supports->moving)
        st = follow(m, MOVING, counters);
    if (st == STATUS_INDEFINITE)
        status_fail(why, st,
                    "the stiffness is singular to working accuracy: the supports "
                    "leave the sheet free to move");
    else if (status_is_death(st))
        status_fail(why, st, "static equilibrium not found: %s", status_text(st));
    m->rested = st == STATUS_OK;
    if (m->rested)
        TRY(large_newton_weigh(m, &whole, 1));
out:
    return st;
}

enum status march_rest_modes(struct march *m, int count, double *omega, struct message *why)
{
    enum status st;
    struct pencil p = {m->graph, (const double(*)[9])m->K, m->M, .stressed = true};

    m->factored = -1;
    TRY(large_body_tangent(&m->body, &large_path_statics, m->x, (struct large_foresight){0},
                           m->K));
    if (m->pressure.value != 0)
        pressure_tangent(&m->pressure, 1, NULL, 1, m->x, m->graph, m->K);
    if (m->air.density > 0)
        air_tangent(&m->air, 1, &(struct air_motion){.x = m->x, .share = 1}, false,
                    m->graph, m->K);
    if (m->contact) {
        contact_begin_rest(m->contact, supports_rest_time(m->supports, m->scene),
                           m->scene->step, m->x);
        TRY(contact_find(m->contact, m->x));
        TRY(contact_coupled_pencil(&m->coupled, m->contact, &m->system, m->x, m->K, m->M,
                                   &p));
    }
    TRY(pencil_modes(&p, m->supports, NULL, count, omega, why));
out:
    return st;
}

/* --- linear bodies ----------------------------------------------------------------------
 */

static double largest(size_t count, const double *x)
{
    double most = 0;

    for (size_t t = 0; t < count; t++)
        if (!(fabs(x[t]) <= most))
            most = fabs(x[t]);
    return most;
}

/* A correction above this part of the solution means a numerically singular system. */
static const double LARGEST_CORRECTION = 1e-2;

enum status march_rest_linear(struct march *m, struct counters *counters,
                              struct message *why)
{
    enum status st;
    const size_t count = march_count(m);
    double *r = m->work, change = 0;

    memset(m->d, 0, 3 * count * sizeof *m->d); /* d, v and a */
    supports_shift(m->supports, m->scene, m->time, m->held);
    for (int h = 0; h < m->supports->held_count; h++)
        supports_set(m->supports, h, m->d, m->held[h]);
    st = system_factor(&m->system, 1, m->stiffness, 0, NULL);
    counters->factorisations++;
    for (int pass = 0; st == STATUS_OK && pass < 2; pass++) {
        blocks_multiply(m->graph, m->stiffness, m->d, r);
        for (size_t t = 0; t < count; t++)
            r[t] = m->load[t] - r[t];
        TRY(system_solve(&m->system, r));
        counters->solves++;
        for (size_t t = 0; t < count; t++)
            m->d[t] += r[t];
        change = largest(count, r) / largest(count, m->d);
    }
    blocks_multiply(m->graph, m->stiffness, m->d, r);
    for (size_t t = 0; t < count; t++)
        r[t] = m->load[t] - r[t];
    reaction_add(m->supports, r, m->rest, 1, m->reaction);
    if (st == STATUS_OK && change > LARGEST_CORRECTION)
        st = STATUS_INDEFINITE;
    if (st == STATUS_INDEFINITE)
        status_fail(why, st,
                    "the stiffness is singular to working accuracy: the supports leave the "
                    "sheet free to move%s",
                    m->singular ? m->singular : "");
    for (size_t t = 0; t < count; t++)
        m->x[t] = m->rest[t] + m->d[t];
    if (m->kinematics != KINEMATICS_LINEAR) /* there d is the last step's increment */
        memset(m->d, 0, count * sizeof *m->d);
out:
    return st;
}

#include "models/mechanics/large_newton.h"

#include <math.h>
#include <string.h>

#include "models/contact/contact_hold.h"
#include "models/mechanics/contact_share.h"
#include "models/mechanics/newton.h"
#include "models/mechanics/reaction.h"

/* Steps below this part of the length end the iteration. Sixty of them leave 1e-8 to 2e-7
 * of it (newton.h), a fiftieth of what the best truths are known to. */
static const double STEP_TOLERANCE = 1e-7;
/* The change under contact, in ranges of the law, that ends the iteration once the touches
 * are held: they are no better known. */
static const double LEEWAY = 1e-3;
/* The error that conjugate gradients may leave at each point after the first change, as a
 * share of the tolerance: the very last change only shows that none is needed. The first
 * has no such allowance: it follows movements below the tolerance, too, which short steps
 * would lose. */
static const double NEAR = 0.1;
/* Under contact a change of an old tangent ends the iteration only if so much of the
 * tolerance is left after it: forces are far less known than places there, and else the
 * last change leaves 5e-4 of an impulse unbalanced. */
static const double OLD = 0.01;
/* Steps in time that do not halve in so many iterations creep about a tangent without
 * stress, and most never converge: two halves of the time step are cheaper than going on.
 * (edge_drop, undamped, no lag, to 0.9 s, shell 16x16, p = 3: .60 of the assemblies.) */
enum { PATIENCE = 5 };
/* A tangent learns from changes that are so many lengths long: in the fall of forces over
 * shorter ones round-off of the membrane's has a part. */
static const double FAR = 3e-6;

/* Half or twice LEEWAY, NEAR, OLD or FAR changes the tangents and solutions of no run of
 * tools/constants by more than 7 %. */

/* An equation is what newton.h's loop solves here. */
struct equation {
    struct march *m;
    const struct large_equation *q;
    double *work;  /* [nodes][3]                                                       */
    double before; /* the work of the contact's forces on a change where it begins [J] */
};

/* --- forces --------------------------------------------------------------------------- */

/* Returns how the sheet moves against the air at x. */
static struct air_motion against_air(const struct large_equation *q, const double *x)
{
    return (struct air_motion){
        .x_old = q->path.x_old, .x = x, .share = q->path.g1, .rate = q->drag};
}

/* Computes what the equation leaves at x, also at held unknowns; found: contact_find was
 * called at x. */
static enum status find_left(struct march *m, const struct large_equation *q, bool found,
                             const double *x, double *r)
{
    const size_t count = march_count(m);
    double *inertia = m->work, *work = m->newton + 2 * count;
    const double *x_old = q->path.x_old;
    enum status st = large_body_force(&m->body, &q->path, x, r);

    if (st != STATUS_OK)
        return st;
    for (size_t t = 0; t < count; t++)
        r[t] = q->load * m->load[t] - r[t];
    if (m->pressure.value != 0)
        pressure_force(&m->pressure, q->load, x_old, q->path.g1, x, r);
    if (m->air.density > 0)
        air_force(&m->air, q->load, (struct air_motion[]){against_air(q, x)}, r);
    if (m->contact) {
        st = found ? STATUS_OK : contact_find(m->contact, x);
        if (st != STATUS_OK)
            return st;
        contact_force(m->contact, r);
    }
    if (q->mass == 0)
        return STATUS_OK;
    for (size_t t = 0; t < count; t++)
        work[t] = q->mass * (x[t] - q->hat[t]);
    blocks_multiply_mass(m->graph, m->M, work, inertia);
    for (size_t t = 0; t < count; t++)
        r[t] -= inertia[t];
    for (size_t t = 0; m->drag && t < count; t++)
        r[t] -= q->drag * m->drag[t / 3] * (x[t] - x_old[t]);
    if (q->viscosity > 0) {
        for (size_t t = 0; t < count; t++)
            work[t] = q->viscosity * (x[t] - x_old[t]);
        blocks_multiply(m->graph, (const double(*)[9])m->V, work, inertia);
        for (size_t t = 0; t < count; t++)
            r[t] -= inertia[t];
    }
    return STATUS_OK;
}

enum status large_newton_weigh(struct march *m, const struct large_equation *q,
                               double share)
{
    enum status st;
    const size_t count = march_count(m);
    const double g = q->path.g1;
    double *left = m->work + count, *at = left + count;

    for (size_t t = 0; t < count; t++)
        at[t] = g == 1 ? m->x[t] : (1 - g) * q->path.x_old[t] + g * m->x[t];
    if (m->clamps) {
        TRY(large_body_force(&m->body, &q->path, m->x, left));
        reaction_clamps(m->scene, m->graph->nodes, left, at, share, m->reaction);
    }
    TRY(find_left(m, q, true, m->x, left));
    reaction_add(m->supports, left, at, share, m->reaction);
out:
    return st;
}

/* Computes n->r. */
static enum status find_residual(struct newton *n, bool found)
{
    const struct equation *e = n->self;
    const enum status st = find_left(e->m, e->q, found, n->x, n->r);

    if (st == STATUS_OK && e->q->mass > 0)
        supports_lean(e->m->supports, n->r);
    return st;
}

static enum status residual(struct newton *n)
{
    return find_residual(n, false);
}

/* Tells whether the sheet touched anything where the residual was last computed. */
static bool touches(const struct newton *n)
{
    const struct equation *e = n->self;

    return e->m->contact && e->m->contact->count > 0;
}

/* --- tangents ------------------------------------------------------------------------- */

/* Factors the tangent. In statics mass is added to one that is not positive definite until
 * it is: a shorter step towards less energy. No more than it takes: bending is softer than
 * stretching by (h/L)^2, and what stops one hardly moves the other. */
static enum status factor(struct march *m, double mass, struct counters *counters)
{
    enum { TRIES = 16 };
    const double(*K)[9] = (const double(*)[9])m->K;
    const struct scene *s = m->scene;
    double more = scene_bending_stiffness(s) /
                  (s->density * s->thickness * pow(s->length, 4)); /* some omega^2 */
    enum status st = STATUS_OK;

    m->added = 0;
    if (mass > 0 || m->coupled.used)
        return contact_coupled_update(&m->coupled, &m->system, 1, K, mass, m->M);
    st = system_factor(&m->system, 1, K, mass, m->M);
    counters->factorisations++;
    for (int n = 0; n < TRIES && st == STATUS_INDEFINITE; n++) {
        m->added = more *= 10;
        st = system_factor(&m->system, 1, K, more, m->M);
        counters->factorisations++;
    }
    return st;
}

/* Makes the tangent at x. */
static enum status assemble(struct march *m, const struct large_equation *q,
                            const double *x, struct large_foresight foresight)
{
    enum status st;

    TRY(large_body_tangent(&m->body, &q->path, x, foresight, m->K));
    if (m->pressure.value != 0)
        pressure_tangent(&m->pressure, q->load, q->path.x_old, q->path.g1, x, m->graph,
                         m->K);
    if (m->air.density > 0)
        air_tangent(&m->air, q->load, (struct air_motion[]){against_air(q, x)},
                    foresight.none, m->graph, m->K);
    for (long k = 0; q->viscosity > 0 && k < 9 * m->body.pairs; k++)
        m->K[k / 9][k % 9] += q->viscosity * m->V[k / 9][k % 9];
    for (int t = 0; m->drag && t < 3 * m->graph->nodes; t++)
        m->K[m->graph->start[t / 3]][4 * (t % 3)] += q->drag * m->drag[t / 3];
    if (m->contact)
        TRY(contact_coupled_add(&m->coupled, m->contact, &m->system, m->K));
out:
    return st;
}

/* Fills work with what large_foresight needs beside d, which led to x. With B of the
 * geometry that the tangent had, (1 - g) x_old + g (x - d), it foresaw e(x - d) + B d: of
 * e(x), (d + 2 (1 - g) (x - d - x_old)) d / 2 less. A stress without the second part is
 * wrong by the turn of the step, not only by that of d. */
static void fill_beside(const struct newton *n, const struct large_path *path, double *work)
{
    const double back = 2 * (1 - path->g1);

    for (size_t t = 0; t < n->count; t++)
        work[t] = n->d[t] + (back > 0 ? back * (n->x[t] - n->d[t] - path->x_old[t]) : 0);
}

/* A tangent that is not positive definite, in time, is made anew without stress. */
static enum status setup(struct newton *n, enum newton_setup which,
                         struct counters *counters)
{
    const struct equation *e = n->self;
    struct march *m = e->m;
    const bool moves = e->q->mass > 0;
    struct large_foresight foresight = {.none = which == NEWTON_SAFER};
    enum status st = STATUS_INDEFINITE;

    m->factored = -1;
    if (which == NEWTON_FIRST)
        foresight.strain = m->strain_old;
    if (which == NEWTON_NEXT) {
        fill_beside(n, &e->q->path, e->work);
        foresight.change = n->d, foresight.beside = e->work;
    }
    for (int attempt = 0; attempt < 2 && st == STATUS_INDEFINITE; attempt++) {
        m->stressless =
            foresight.none; /* one that was indefinite says little of the next */
        TRY(assemble(m, e->q, n->x, foresight));
        counters->assemblies++;
        st = factor(m, e->q->mass, counters);
        if (!moves)
            break;
        foresight.none = true;
    }
    n->safer = moves && !m->stressless;
    if (st == STATUS_OK)
        m->factored = e->q->mass;
out:
    return st;
}

static enum status solve(struct newton *n, double *b)
{
    const struct equation *e = n->self;
    struct march *m = e->m;

    if (m->loose > 0)
        iterative_tolerate(m->system.iterative, m->loose,
                           isfinite(n->size) ? NEAR * m->tolerance : 0);
    return system_solve(m->coupled.used ? &m->coupled.system : &m->system, b);
}

/* --- changes -------------------------------------------------------------------------- */

/* Returns the work of r on d, which is zero at the held unknowns. */
static double work_of(const struct newton *n, const double *r)
{
    double sum = 0;

    for (size_t t = 0; t < n->count; t++)
        sum += r[t] * n->d[t];
    return sum;
}

/* Returns the work of the contact's forces on d. */
static double contact_work(const struct newton *n)
{
    const struct equation *e = n->self;

    memset(e->work, 0, n->count * sizeof *e->work);
    contact_force(e->m->contact, e->work);
    return work_of(n, e->work);
}

/* Computes r at x, and the rise that contact makes: all other forces count as unchanged.
 * The spurious stress that a whole step leaves in a thin sheet would shorten each, while
 * what contact throws back it does alone. */
static enum status look(void *self, const struct contact_change *c, double *rise)
{
    struct newton *n = self;
    const struct equation *e = n->self;
    enum status st = STATUS_OK;

    *rise = -c->fall;
    if (e->m->contact) {
        TRY(contact_find(e->m->contact, c->x));
        *rise += e->before - contact_work(n);
    }
    st = find_residual(n, e->m->contact);
out:
    return st;
}

static enum status take(struct newton *n)
{
    struct equation *e = n->self;
    const struct contact_change change = {.count = n->count,
                                          .x = n->x,
                                          .d = n->d,
                                          .fall = work_of(n, n->r),
                                          .lower = !e->m->contact,
                                          .self = n,
                                          .look = look};
    double share;

    e->before = e->m->contact ? contact_work(n) : 0;
    const enum status st = contact_change_take(&change, &share);
    for (size_t t = 0; share < 1 && t < n->count; t++)
        n->d[t] *= share;
    n->whole &= share == 1;
    return st;
}

static bool limit(struct newton *n)
{
    const struct equation *e = n->self;

    return !e->m->contact || contact_limit(e->m->contact, n->x, n->d) == 1;
}

/* --- the end -------------------------------------------------------------------------- */

/* Returns the change that ends the iteration. */
static double tolerance(const struct march *m, const struct large_equation *q)
{
    const double most = STEP_TOLERANCE * m->scene->length;
    const bool held = m->contact && m->contact->held;

    if (q->tolerance > 0)
        return q->tolerance;
    return held ? fmax(most, LEEWAY * m->contact->body.range) : most;
}

/* Returns an upper bound of what is left after a change, if changes shrink evenly by s <
 * .9, as they do where the tangent is not exact: s / (1 - s) < 10 s of it; the change
 * itself while they do not shrink fast, and where the owner states no tolerance: then so
 * much less is left. Under contact an old tangent has to leave OLD of it. */
static double left(const struct newton *n)
{
    const struct equation *e = n->self;
    const double caution = 10, shrunk = n->before > 0 ? n->size / n->before : 1;

    if (n->kept && touches(n))
        return n->size * fmax(1, shrunk / OLD);
    return e->m->tolerance > 0 ? n->size * fmin(1, caution * shrunk) : n->size;
}

/* Tells whether a step below the tolerance means convergence. */
static bool settled(const struct march *m, double size, double before)
{
    const double shrink = 0.1, round_off = 1e-14;

    return m->added == 0 || size <= shrink * before || size <= round_off * m->scene->length;
}

/* A wrung strip spent two thirds of its work on steps that were halved since they had found
 * touches anew up to the limit. */
static enum newton_verdict judge(struct newton *n)
{
    const struct equation *e = n->self;
    struct march *m = e->m;

    if (m->contact && (!n->kept || m->contact->released))
        contact_hold(m->contact, n->size);
    const bool calm =
        left(n) <= tolerance(m, e->q) && n->whole && settled(m, n->size, n->before);
    const bool anew =
        calm && m->contact && contact_hold_release(m->contact, n->changes < n->limit / 2);
    if ((calm && !anew) || n->changes + 1 == e->q->enough)
        return NEWTON_DONE;
    return anew ? NEWTON_ANEW : NEWTON_ON;
}

enum status large_newton_solve(struct march *m, const struct large_equation *q, double *x,
                               struct counters *counters)
{
    static const struct newton_owner owner = {residual, setup,   solve, limit,
                                              take,     touches, judge};
    const size_t count = march_count(m);
    struct equation e = {.m = m, .q = q, .work = m->newton + 2 * count};
    struct newton n = {.owner = &owner,
                       .self = &e,
                       .count = count,
                       .x = x,
                       .room = m->newton + 3 * count,
                       .chord = q->chord,
                       .still = m->still,
                       .least = FAR * m->scene->length,
                       .limit = q->limit,
                       .patience = q->mass > 0 ? PATIENCE : 0,
                       .kept = q->chord > 0 && m->factored == q->mass && !m->worn,
                       .safer = q->mass > 0};

    m->stressless = false;
    const enum status st = newton_solve(&n, counters);
    m->worn = n.worn;
    if (m->contact)
        m->contact->held = false;
    return st;
}

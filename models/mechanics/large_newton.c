#include "models/mechanics/large_newton.h"

#include <math.h>
#include <string.h>

#include "models/mechanics/contact_share.h"

/* Steps below this part of the length end the iteration. */
static const double STEP_TOLERANCE = 1e-7;
/* The tangent at the predictor is kept after the first step, the longest by far, only if
 * the second is this much shorter: it looks shorter than it is to a tangent whose membrane
 * has not turned with the sheet, and goes astray. (edge_drop, undamped, to 0.4 s, with no
 * more tangents: shell 10x10 selective p = 2, .81 of the iterations; p = 3, .87; IGA
 * selective p = 3, .86.) */
static const double FIRST_CHORD = 0.03;
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
/* The least curvature of the MARCH_LEARNT steps that a kept tangent learns from, over what
 * they were driven by. */
static const double LEAST_CURVE = 1e-2;
/* It learns from changes that are so many lengths long: in the fall of forces over
 * shorter ones round-off of the membrane's has a part. */
static const double FAR = 3e-6;
/* A tangent that learns, as it does under contact, is kept while its changes shrink as
 * fast, for its work, as those of a new one did last, which with a solve costs COST as
 * much; by no less and no more than this. */
static const double COST = 4.5, LEAST_CHORD = 0.5, MOST_CHORD = 0.8;

static size_t count_of(const struct march *m)
{
    return 3 * (size_t)m->graph->nodes;
}

/* Computes the right-hand side at x, r; work[nodes][3]. found: by contact_find. */
static enum status residual(struct march *m, const struct large_equation *q,
                            const double *x, double *r, double *work, bool found)
{
    size_t count = count_of(m);
    enum status st = large_body_force(&m->body, &q->path, x, r);

    if (st != STATUS_OK)
        return st;
    for (size_t t = 0; t < count; t++)
        r[t] = q->load * m->load[t] - r[t];
    if (m->pressure.value != 0)
        pressure_force(&m->pressure, q->load, q->path.x_old, q->path.g1, x, r);
    if (m->contact) {
        st = found ? STATUS_OK : contact_find(m->contact, x);
        if (st != STATUS_OK)
            return st;
        contact_force(m->contact, r);
    }
    if (q->mass == 0)
        return STATUS_OK;
    double *inertia = m->work;
    for (size_t t = 0; t < count; t++)
        work[t] = q->mass * (x[t] - q->hat[t]);
    blocks_multiply_mass(m->graph, m->M, work, inertia);
    for (size_t t = 0; t < count; t++)
        r[t] -= inertia[t];
    for (size_t t = 0; m->drag && t < count; t++)
        r[t] -= q->drag * m->drag[t / 3] * (x[t] - q->path.x_old[t]);
    if (q->viscosity > 0) {
        for (size_t t = 0; t < count; t++)
            work[t] = q->viscosity * (x[t] - q->path.x_old[t]);
        blocks_multiply(m->graph, (const double(*)[9])m->V, work, inertia);
        for (size_t t = 0; t < count; t++)
            r[t] -= inertia[t];
    }
    supports_lean(m->supports, r);
    return STATUS_OK;
}

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

/* Tells whether the sheet touched anything where the residual was last computed. */
static bool touches(const struct march *m)
{
    return m->contact && m->contact->count > 0;
}

/* Makes and factors the tangent at x. */
static enum status refresh(struct march *m, const struct large_equation *q, const double *x,
                           struct large_foresight foresight, struct counters *counters)
{
    enum status st = STATUS_OK;

    m->factored = -1;
    m->stressless = foresight.none; /* one that was indefinite says little of the next */
    for (int attempt = 0; attempt < 2; attempt++) {
        foresight.none = m->stressless;
        TRY(large_body_tangent(&m->body, &q->path, x, foresight, m->K));
        counters->assemblies++;
        if (m->pressure.value != 0)
            pressure_tangent(&m->pressure, q->load, q->path.x_old, q->path.g1, x, m->graph,
                             m->K);
        for (long n = 0; q->viscosity > 0 && n < 9 * m->body.pairs; n++)
            m->K[n / 9][n % 9] += q->viscosity * m->V[n / 9][n % 9];
        for (int t = 0; m->drag && t < 3 * m->graph->nodes; t++)
            m->K[m->graph->start[t / 3]][4 * (t % 3)] += q->drag * m->drag[t / 3];
        if (m->contact)
            TRY(contact_coupled_add(&m->coupled, m->contact, &m->system, m->K));
        st = factor(m, q->mass, counters);
        if (st != STATUS_INDEFINITE || q->mass == 0)
            break;
        m->stressless = true;
    }
    if (st == STATUS_OK)
        m->factored = q->mass;
out:
    return st;
}

/* The state of an iteration; vectors [nodes][3]. */
struct iteration {
    double *x;        /* present points                                                */
    double *d, size;  /* the last step, its largest move [m]                           */
    double *r, *next; /* right-hand side at x; the step from there                     */
    double *work;
    double *
        learnt; /* [MARCH_LEARNT][2] steps since the tangent was made, and the falls of r */
    double
        curve[MARCH_LEARNT]; /* the products of the two                               [J] */
    int learns;              /* how many of them there are                               */
    double chord;  /* the tangent is kept if the next step is so much shorter           */
    bool whole;    /* contact did not cut d short                                       */
    bool balanced; /* a step was taken whole: r has no resultant any more               */
    int renewed;   /* tangents made since the first change                             */
    double pays;   /* the least shrinkage of changes that keeps a tangent that learns   */
    bool kept;     /* d is of a tangent that was made at an earlier x                   */
    double before; /* the work of the contact's forces on d where it begins        [J] */
    struct march *m;
    const struct large_equation *q;
};

/* Notes the step i->d, and the fall of the right-hand side in it from `before`, where both
 * are those of a tangent that is positive definite. */
static void learn(struct iteration *i, const double *before)
{
    const size_t count = count_of(i->m);
    double *step = i->learnt + 2 * i->learns * count, *fall = step + count, curve = 0;
    double driven = 0;

    if (i->learns == MARCH_LEARNT)
        return;
    for (size_t t = 0; t < count; t++) {
        step[t] = i->d[t], fall[t] = before[t] - i->r[t];
        curve += step[t] * fall[t], driven += step[t] * before[t];
    }
    i->curve[i->learns] = curve;
    i->learns += curve > LEAST_CURVE * driven && driven > 0;
}

/* Corrects the right-hand side next before the solution, and the solution after it, by what
 * was learnt of the tangent since it was made (Matthies and Strang 1979, Int. J. Numer.
 * Meth. Engng 14, 1613, in Nocedal's form). */
static void correct(const struct iteration *i, double *next, double *share, bool solved)
{
    const size_t count = count_of(i->m);

    for (int n = 0; n < i->learns; n++) {
        const int k = solved ? n : i->learns - 1 - n;
        const double *step = i->learnt + 2 * k * count, *fall = step + count;
        double sum = 0;
        for (size_t t = 0; t < count; t++)
            sum += next[t] * (solved ? fall[t] : step[t]);
        sum /= i->curve[k];
        share[k] = solved ? share[k] - sum : sum;
        for (size_t t = 0; t < count; t++)
            next[t] += solved ? share[k] * step[t] : -share[k] * fall[t];
    }
}

/* Solves for i->next from i->r with the factored tangent. A tangent found not to be
 * positive definite, by conjugate gradients, is replaced by one without stress;
 * so is one for which GMRES finds no solution, since it cannot tell why. */
static enum status solve(struct march *m, const struct large_equation *q,
                         struct iteration *i, double *size, struct counters *counters)
{
    enum status st;
    double share[MARCH_LEARNT];

    for (int attempt = 0; attempt < 2; attempt++) {
        memcpy(i->next, i->r, count_of(m) * sizeof *i->next);
        correct(i, i->next, share, false);
        if (m->loose > 0)
            iterative_tolerate(m->system.iterative, m->loose,
                               isfinite(i->size) ? NEAR * m->tolerance : 0);
        st = contact_coupled_solve(&m->coupled, &m->system, i->next);
        correct(i, i->next, share, true);
        counters->solves++;
        const bool indefinite = st == STATUS_INDEFINITE || st == STATUS_UNSOLVED;
        if (!indefinite || m->stressless || q->mass == 0)
            break;
        m->stressless = true, i->learns = 0;
        TRY(refresh(m, q, i->x, (struct large_foresight){.none = true}, counters));
    }
    TRY(st);
    *size = blocks_longest(m->graph->nodes, i->next);
    st = isfinite(*size) ? STATUS_OK : STATUS_NAN;
out:
    return st;
}

/* Returns the work of r on d, both [nodes][3]; d is zero at the held unknowns. */
static double work_of(const struct march *m, const double *r, const double *d)
{
    double sum = 0;

    for (size_t t = 0; t < count_of(m); t++)
        sum += r[t] * d[t];
    return sum;
}

/* Returns the work of the contact's forces on d. */
static double contact_work(const struct march *m, const struct iteration *i)
{
    memset(i->work, 0, count_of(m) * sizeof *i->work);
    contact_force(m->contact, i->work);
    return work_of(m, i->work, i->d);
}

/* Computes the right-hand side at x, and the rise that contact makes: all other forces
 * count as unchanged. The spurious stress that a whole step leaves in a thin sheet would
 * shorten each, while what contact throws back it does alone. */
static enum status look(void *self, const struct contact_change *c, double *rise)
{
    struct iteration *i = self;
    struct march *m = i->m;
    enum status st = STATUS_OK;

    *rise = -c->fall;
    if (m->contact) {
        TRY(contact_find(m->contact, c->x));
        *rise += i->before - contact_work(m, i);
    }
    st = residual(m, i->q, c->x, i->r, i->work, m->contact);
out:
    return st;
}

/* Takes as much of the step d as there is a right-hand side for, and contact does not throw
 * back. */
static enum status take_step(struct iteration *i)
{
    const struct contact_change change = {.count = count_of(i->m),
                                          .x = i->x,
                                          .d = i->d,
                                          .fall = work_of(i->m, i->r, i->d),
                                          .lower = !i->m->contact,
                                          .self = i,
                                          .look = look};
    double share;

    i->before = i->m->contact ? contact_work(i->m, i) : 0;
    const enum status st = contact_change_take(&change, &share);
    for (size_t t = 0; share < 1 && t < change.count; t++)
        i->d[t] *= share;
    i->whole &= share == 1;
    return st;
}

/* Fills i->work with what large_foresight needs beside d, which led to x. With B of the
 * geometry that the tangent had, (1 - g) x_old + g (x - d), it foresaw e(x - d) + B d: of
 * e(x), (d + 2 (1 - g) (x - d - x_old)) d / 2 less. A stress without the second part is
 * wrong by the turn of the step, not only by that of d. */
static void fill_beside(const struct march *m, const struct large_equation *q,
                        const struct iteration *i)
{
    const double back = 2 * (1 - q->path.g1), *old = q->path.x_old;

    for (size_t t = 0; t < count_of(m); t++)
        i->work[t] = i->d[t] + (back > 0 ? back * (i->x[t] - i->d[t] - old[t]) : 0);
}

/* Returns the change that ends the iteration. */
static double tolerance(const struct march *m, const struct large_equation *q)
{
    const double most = STEP_TOLERANCE * m->scene->length;
    const bool held = m->contact && m->contact->held;

    if (q->tolerance > 0)
        return q->tolerance;
    return held ? fmax(most, LEEWAY * m->contact->body.range) : most;
}

/* Finds the next step, with the old tangent if that still works well. */
static enum status next_step(struct march *m, const struct large_equation *q,
                             struct iteration *i, struct counters *counters)
{
    enum status st;
    double size = INFINITY, *swap;

    if (q->chord > 0)
        TRY(solve(m, q, i, &size, counters));
    i->kept = size <= (touches(m) ? fmax(LEAST_CHORD, i->pays) : i->chord) * i->size;
    if (!i->kept) {
        i->learns = 0;
        fill_beside(m, q, i);
        TRY(refresh(m, q, i->x, (struct large_foresight){.change = i->d, .beside = i->work},
                    counters));
        m->worn = !touches(m) || i->renewed++ > 0;
        TRY(solve(m, q, i, &size, counters));
        i->pays = fmin(MOST_CHORD, pow(size / i->size, 1 / COST));
    }
    swap = i->d;
    i->d = i->next, i->next = swap, i->size = size;
    i->chord = q->chord;
out:
    return st;
}

/* Returns an upper bound of what is left after a change, if changes shrink evenly, as they
 * do where the tangent is not exact; the change itself while they do not shrink fast, and
 * where the owner states no tolerance: then so much less is left. Under contact an old
 * tangent has to leave OLD of it. */
static double left(const struct iteration *i, double before)
{
    const double caution = 10, shrunk = before > 0 ? i->size / before : 1;

    if (i->kept && touches(i->m))
        return i->size * fmax(1, shrunk / OLD);
    return i->m->tolerance > 0 ? i->size * fmin(1, caution * shrunk) : i->size;
}

/* Tells whether a step below the tolerance means convergence. */
static bool settled(const struct march *m, double size, double before)
{
    const double shrink = 0.1, round_off = 1e-14;

    return m->added == 0 || size <= shrink * before || size <= round_off * m->scene->length;
}

/* Takes the step i->d, *anew: to touches that are found anew there, and finds the next. */
static enum status go_on(struct iteration *i, bool anew, struct counters *counters)
{
    enum status st;
    struct march *m = i->m;

    memcpy(i->next, i->r, count_of(m) * sizeof *i->next);
    TRY(take_step(i));
    if (i->balanced && !anew && touches(m) && i->size > FAR * m->scene->length)
        learn(i, i->next);
    i->balanced |= i->whole;
    TRY(next_step(m, i->q, i, counters));
    i->whole = !m->contact || contact_limit(m->contact, i->x, i->d) == 1;
out:
    return st;
}

enum status large_newton_solve(struct march *m, const struct large_equation *q, double *x,
                               struct counters *counters)
{
    enum status st = STATUS_OK;
    int since = 0; /* the best of sizes, halved, is of that iteration */
    double before = 0, best = INFINITY; /* the size of the step before; of the best */
    size_t count = count_of(m);
    double *room = m->newton + 2 * count, *swap;
    struct iteration i = {.x = x,
                          .d = room,
                          .r = room + count,
                          .next = room + 2 * count,
                          .work = room + 3 * count,
                          .learnt = m->newton + 6 * count,
                          .size = INFINITY,
                          .chord = q->chord,
                          .m = m,
                          .q = q};

    m->stressless = false;
    TRY(residual(m, q, x, i.r, i.work, false));
    i.kept = true;
    if (q->chord == 0 || m->factored != q->mass || m->worn) {
        i.kept = false;
        TRY(refresh(m, q, x, (struct large_foresight){.strain = m->strain_old}, counters));
        i.chord = fmin(q->chord, FIRST_CHORD);
    }
    TRY(solve(m, q, &i, &i.size, counters));
    swap = i.d, i.d = i.next, i.next = swap;
    m->worn = false;
    memset(i.next, 0, count * sizeof *i.next);
    i.whole = !m->contact || contact_limit(m->contact, x, i.d) == 1;
    for (int n = 0; n < q->limit; n += !(i.kept && touches(m))) {
        counters->iterations++;
        if (m->contact && (!i.kept || m->contact->released))
            contact_hold(m->contact, x, i.size);
        if (i.size < best / 2)
            best = i.size, since = n;
        if (q->mass > 0 && !touches(m) && n - since > PATIENCE) {
            st = STATUS_DIVERGED;
            goto out;
        }
        const bool calm =
            left(&i, before) <= tolerance(m, q) && i.whole && settled(m, i.size, before);
        /* A wrung strip spent two thirds of its work on steps that were halved since they
         * had found touches anew up to the limit. */
        const bool anew =
            calm && m->contact && contact_release(m->contact, n < q->limit / 2);
        before = i.size;
        if ((calm && !anew) || n + 1 == q->enough) {
            for (size_t t = 0; t < count; t++)
                x[t] += i.d[t];
            goto out;
        }
        TRY(go_on(&i, anew, counters));
    }
    st = STATUS_DIVERGED;
out:
    if (m->contact)
        m->contact->held = false;
    return st;
}

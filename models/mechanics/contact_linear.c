#include "models/mechanics/contact_linear.h"

#include <math.h>
#include <string.h>

#include "models/mechanics/contact_share.h"
#include "models/mechanics/contact_system.h"

/* The most iterations of a step; the change that ends them, in lengths of the sheet. */
enum { MOST = 60 };
static const double TOLERANCE = 1e-9;

/* The equation (k K + m M) w = b + force f(x), x = start + way (w - still). */
struct equation {
    double force, way;
    const double *b;     /* [nodes][3] without the part of held unknowns               */
    const double *still; /* [nodes][3]; NULL: zeros                                    */
    const double *start; /* [nodes][3]                                                 */
};

static size_t count_of(const struct contact_linear *l)
{
    return 3 * (size_t)l->system->graph->nodes;
}

static void place(const struct contact_linear *l, const struct equation *q, const double *w,
                  double *x)
{
    for (size_t t = 0; t < count_of(l); t++)
        x[t] = q->start[t] + q->way * (w[t] - (q->still ? q->still[t] : 0));
}

/* Computes r = b + force f - (k K + m M) w for the free unknowns. */
static void residual(const struct contact_linear *l, const struct equation *q,
                     const double *w, double *r, double *work)
{
    const int *place_of = l->system->held->free_index;
    const size_t count = count_of(l);
    double *free = work, *y = work + count;

    memset(r, 0, count * sizeof *r);
    contact_force(l->contact, r);
    for (size_t t = 0; t < count; t++) {
        free[t] = place_of[t] < 0 ? 0 : w[t];
        r[t] = q->b[t] + q->force * r[t];
    }
    blocks_multiply(l->system->graph, l->K, free, y);
    for (size_t t = 0; t < count; t++)
        r[t] -= newmark_k(l->newmark) * y[t];
    blocks_multiply_mass(l->system->graph, l->M, free, y);
    for (size_t t = 0; t < count; t++)
        r[t] -= newmark_m(l->newmark) * y[t];
}

/* Factorises the equation's matrix with the stiffness of the present touches. */
static enum status factor(struct contact_linear *l, const struct equation *q)
{
    enum status st = STATUS_OK;
    const struct blocks *g = l->system->graph;
    const double k = newmark_k(l->newmark) / (q->force * q->way);

    if (!l->contact->count && l->plain)
        return STATUS_OK;
    l->plain = !l->contact->count;
    l->coupled.used = false;
    if (l->plain)
        return system_update(l->system, newmark_k(l->newmark), l->K, newmark_m(l->newmark),
                             l->M);
    for (long n = 0; n < g->start[g->nodes]; n++)
        for (int i = 0; i < 9; i++)
            l->tangent[n][i] = k * l->K[n][i];
    TRY(contact_coupled_add(&l->coupled, l->contact, l->system, l->tangent));
    st =
        contact_coupled_update(&l->coupled, l->system, q->force * q->way,
                               (const double(*)[9])l->tangent, newmark_m(l->newmark), l->M);
out:
    return st;
}

static double product(size_t count, const double *a, const double *b)
{
    double sum = 0;

    for (size_t t = 0; t < count; t++)
        sum += a[t] * b[t];
    return sum;
}

/* Moves w and x along d as far as contact allows and is good, with the residual there in r.
 * *whole: all of it. */
static enum status search(struct contact_linear *l, const struct equation *q, double *w,
                          double *r, bool *whole)
{
    enum status st = STATUS_OK;
    const size_t count = count_of(l);
    double *x = l->room, *d = l->room + 4 * count, *work = l->newmark->work + count;
    const double fall = product(count, r, d), most = contact_limit(l->contact, x, d);
    struct contact_share part = {.share = most, .most = most, .high = most};
    double moved = 0;

    for (int n = 0; n < CONTACT_SHARE_PLACES; n++) {
        for (size_t t = 0; t < count; t++)
            w[t] += (part.share - moved) * d[t] / q->way;
        moved = part.share, *whole = moved == 1;
        place(l, q, w, x);
        TRY(contact_find(l->contact, x));
        residual(l, q, w, r, work);
        if (contact_share_good(&part, fall, -product(count, r, d)))
            break;
    }
out:
    return st;
}

/* Solves the equation for w, on entry the held unknowns. */
static enum status solve(struct contact_linear *l, const struct equation *q, double *w,
                         struct counters *counters)
{
    enum status st;
    const size_t count = count_of(l);
    const int *place_of = l->system->held->free_index;
    double size = INFINITY; /* of the last change [m] */
    const double close = TOLERANCE * l->contact->scene->length;
    double *x = l->room, *d = l->room + 4 * count, *r = l->room + 5 * count;

    for (size_t t = 0; t < count; t++)
        if (place_of[t] >= 0)
            w[t] = q->still ? q->still[t] : 0;
    place(l, q, w, x);
    TRY(contact_find(l->contact, x));
    residual(l, q, w, r, l->newmark->work + count);
    for (int n = 0; n < MOST; n++) {
        const bool touched = l->contact->count > 0;
        bool whole;
        memcpy(d, r, count * sizeof *d);
        l->contact->error = size;
        TRY(factor(l, q));
        TRY(contact_coupled_solve(&l->coupled, l->system, d));
        counters->solves++, counters->iterations++;
        for (size_t t = 0; t < count; t++)
            d[t] *= q->way;
        size = blocks_longest(l->system->graph->nodes, d);
        if (!isfinite(size))
            TRY(STATUS_NAN);
        TRY(search(l, q, w, r, &whole));
        if (size <= close || (whole && !touched && !l->contact->count))
            return STATUS_OK;
    }
    st = STATUS_DIVERGED;
out:
    l->plain &= st == STATUS_OK;
    return st;
}

/* Subtracts from b what held unknowns contribute, and sets their w. */
static void subtract_held(const struct contact_linear *l, const struct newmark_held *held,
                          double *b, double *w)
{
    const struct newmark *n = l->newmark;
    const struct supports *s = l->system->held;
    const size_t count = count_of(l);
    double *x = n->work + 2 * count, dt = n->dt;

    memset(x, 0, count * sizeof *x);
    for (int h = 0; h < s->held_count; h++) {
        int t = s->held[h];
        x[t] = (1 + n->alpha * dt / 2) * (n->v[t] + held->v[h]);
    }
    blocks_multiply_mass(l->system->graph, l->M, x, w);
    for (size_t t = 0; t < count; t++)
        b[t] -= w[t];
    for (int h = 0; h < s->held_count; h++) {
        int t = s->held[h];
        x[t] = dt / 2 * (held->d[h] - n->d[t]) + n->beta * dt / 2 * (n->v[t] + held->v[h]);
    }
    blocks_multiply(l->system->graph, l->K, x, w);
    for (size_t t = 0; t < count; t++)
        b[t] -= w[t];
    memset(w, 0, count * sizeof *w);
    for (int h = 0; h < s->held_count; h++)
        w[s->held[h]] = 2 * (held->d[h] - n->d[s->held[h]]) / dt;
}

void contact_linear_clear(struct contact_linear *l)
{
    contact_coupled_clear(&l->coupled);
}

enum status contact_linear_step(struct contact_linear *l, double t,
                                const struct newmark_held *held, const double *x,
                                struct counters *counters)
{
    enum status st;
    struct newmark *n = l->newmark;
    const struct supports *s = l->system->held;
    const size_t count = count_of(l);
    double *b = n->work, *w = l->room + 2 * count, *y = n->work + count, dt = n->dt;

    /* w = v0 + v1: (k K + m M) w = 2 M v0 + dt (f - K d0 + r) */
    blocks_multiply_mass(l->system->graph, l->M, n->v, b);
    blocks_multiply(l->system->graph, l->K, n->d, y);
    for (size_t k = 0; k < count; k++) {
        b[k] = 2 * b[k] + dt * (l->load[k] - y[k]);
        w[k] = 0;
    }
    if (held)
        subtract_held(l, held, b, w);
    contact_begin(l->contact, t, dt, x);
    const struct equation q = {.force = dt, .way = dt / 2, .b = b, .start = x};
    TRY(solve(l, &q, w, counters));
    for (size_t k = 0; k < count; k++) {
        if (s->free_index[k] < 0)
            continue;
        n->d[k] += dt / 2 * w[k];
        n->v[k] = w[k] - n->v[k];
    }
    for (int h = 0; held && h < s->held_count; h++)
        n->d[s->held[h]] = held->d[h], n->v[s->held[h]] = held->v[h];
    contact_system_land(l->contact, l->system->graph, l->M, s->free_index, l->room, n->v,
                        y);
out:
    return st;
}

/* Takes the acceleration by contact out of a, which the next step would go on with: its
 * force is that of one step. */
static enum status forget(struct contact_linear *l, double force, double *by)
{
    enum status st = STATUS_OK;
    const struct newmark *n = l->newmark;

    if (!l->contact->count)
        return st;
    memset(by, 0, count_of(l) * sizeof *by);
    contact_force(l->contact, by);
    TRY(system_factor(l->system, 0, l->K, 1, l->M));
    TRY(system_solve(l->system, by));
    for (size_t t = 0; t < count_of(l); t++)
        n->a[t] -= force * by[t];
out:
    return st;
}

enum status contact_linear_rebuilt(struct contact_linear *l, double t,
                                   const struct newmark_held *held, const double *x,
                                   struct counters *counters)
{
    enum status st;
    struct newmark *n = l->newmark;
    const struct supports *s = l->system->held;
    const size_t count = count_of(l);
    const double k = newmark_k(n);
    double *still = l->room + count, *w = l->room + 2 * count, *b = l->room + 3 * count;

    newmark_predict(n, l->system, l->K, l->M, l->load, held);
    memcpy(b, n->work, count * sizeof *b);
    for (size_t u = 0; u < count; u++) { /* w without motion: d1 = 0, v1 = -2 d0/dt - v0 */
        still[u] = -n->beta * (2 * n->d[u] / n->dt + n->v[u]) / k;
        w[u] = 0;
    }
    for (int h = 0; held && h < s->held_count; h++)
        w[s->held[h]] = (held->d[h] + n->beta * held->v[h]) / k;
    contact_begin(l->contact, t, n->dt, x);
    l->plain = false;
    const struct equation q = {.force = 2,
                               .way = k / (1 + 2 * n->beta / n->dt),
                               .b = b,
                               .still = still,
                               .start = x};
    TRY(solve(l, &q, w, counters));
    newmark_correct(n, l->system, w, held);
    TRY(forget(l, q.force, b));
    contact_system_land(l->contact, l->system->graph, l->M, s->free_index, l->room, n->v,
                        n->work);
out:
    return st;
}

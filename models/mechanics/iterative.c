#include "models/mechanics/iterative.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/ichol.h"
#include "models/linalg/krylov.h"
#include "models/room.h"

/* The relative tolerance of a solution, unless the owner sets one. */
static const double TOLERANCE = 1e-10;

/* The most iterations with a factor of this very A, which only round-off requires; and with
 * other preconditioners, per unknown and in addition. */
enum { MOST_FRESH = 30, MOST_AN_UNKNOWN = 10, MOST_ANYWAY = 100 };

/* The most iterations with a factor in single precision: more cost more than it saves; and
 * the tolerance it must reach on its own A, as one in double does in one product: 1e-2 of a
 * large movement leads Newton astray (a strip 1000 : 1 took 135 steps for 88, now 93). */
enum { MOST_SINGLE = 8 };
static const double SINGLE_TOLERANCE = 1e-4;

/* The solutions that are extrapolated. */
enum { PAST = 5 };

struct iterative {
    struct iterative_owner owner;
    enum solver solver;
    enum preconditioner preconditioner;
    struct krylov krylov;
    void *room;         /* memory of the arrays, krylov's too                  owned   */
    double (*A)[9];     /* [pairs]                                                     */
    double *b;          /* [nodes][3] right-hand side                                  */
    double (*block)[9]; /* [nodes] inverses of A's diagonal; of jacobi                 */
    double *packed;     /* [free] of ichol                                             */
    struct ichol *ichol;
    long *entry; /* [pairs][9] of ichol's values, -1: none                             */
    bool factored, fresh, single; /* single: factors are made in single precision      */
    double tolerance, near; /* tolerances of systems of a sequence                     */

    void (*frames)(const void *body, double (*Q)[9]);
    const void *body;
    void *follow; /* memory of the next arrays                           owned   */
    double (*now)[9], (*then)[9]; /* [nodes] frames of A and of the factor             */
    double *turned;               /* [nodes][3]                                        */
    double *past[PAST];           /* [nodes][3] solutions, the last first, to extrapolate */
    int known;                    /* number of those                                   */
    long age, spent; /* the factor's: systems solved, iterations' work on them         */
    bool spent_more; /* the last took more than they did on average                    */
    long solves, factorisations;
};

static size_t count_of(const struct iterative *it)
{
    return 3 * (size_t)it->owner.graph->nodes;
}

static bool coupled(const struct iterative_owner *o, int a, int b)
{
    return o->held->free_index[a] >= 0 && o->held->free_index[b] >= 0 &&
           (!o->parity || o->parity[a] == o->parity[b]);
}

/* --- the preconditioners -----------------------------------------------------------------
 */

/* Computes y = R x or R^T x node by node; nodes of which a part is held do not turn. */
static void turn(const struct iterative *it, bool back, const double *x, double *y)
{
    const int *place = it->owner.held->free_index;
    const double(*from)[9] = (const double(*)[9])(back ? it->now : it->then);
    const double(*to)[9] = (const double(*)[9])(back ? it->then : it->now);

    for (int a = 0; a < it->owner.graph->nodes; a++, x += 3, y += 3, place += 3) {
        double own[3] = {0};
        if (place[0] < 0 || place[1] < 0 || place[2] < 0) {
            memmove(y, x, 3 * sizeof *y);
            continue;
        }
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                own[j] += from[a][3 * i + j] * x[i];
        for (int i = 0; i < 3; i++)
            y[i] = to[a][3 * i] * own[0] + to[a][3 * i + 1] * own[1] +
                   to[a][3 * i + 2] * own[2];
    }
}

static enum status by_factor(struct iterative *it, const double *x, double *y)
{
    enum status st;

    if (!it->frames || it->fresh) {
        memcpy(y, x, count_of(it) * sizeof *y);
        return it->owner.solve(it->owner.self, y);
    }
    turn(it, true, x, it->turned);
    TRY(it->owner.solve(it->owner.self, it->turned));
    turn(it, false, it->turned, y);
out:
    return st;
}

static void by_ichol(const struct iterative *it, const double *x, double *y)
{
    const int *place = it->owner.held->free_index;
    size_t count = count_of(it);

    for (size_t t = 0; t < count; t++)
        if (place[t] >= 0)
            it->packed[place[t]] = x[t];
    ichol_solve(it->ichol, it->packed);
    for (size_t t = 0; t < count; t++)
        y[t] = place[t] >= 0 ? it->packed[place[t]] : 0;
}

static void by_blocks(const struct iterative *it, const double *x, double *y)
{
    for (int a = 0; a < it->owner.graph->nodes; a++, x += 3, y += 3)
        for (int i = 0; i < 3; i++)
            y[i] = it->block[a][3 * i] * x[0] + it->block[a][3 * i + 1] * x[1] +
                   it->block[a][3 * i + 2] * x[2];
}

static enum status precondition(void *self, const double *x, double *y)
{
    struct iterative *it = self;

    it->solves++;
    if (it->preconditioner == PRECONDITIONER_ICHOL)
        by_ichol(it, x, y);
    else if (it->preconditioner == PRECONDITIONER_JACOBI)
        by_blocks(it, x, y);
    else
        return by_factor(it, x, y);
    return STATUS_OK;
}

static void multiply(void *self, const double *x, double *y)
{
    struct iterative *it = self;

    blocks_multiply(it->owner.graph, (const double(*)[9])it->A, x, y);
}

static enum status make_blocks(struct iterative *it)
{
    const struct blocks *g = it->owner.graph;

    for (int a = 0; a < g->nodes; a++)
        if (!blocks_invert(it->A[g->start[a]], it->owner.held->free_index + 3 * (size_t)a,
                           it->block[a]))
            return STATUS_INDEFINITE;
    return STATUS_OK;
}

static enum status make_ichol(struct iterative *it)
{
    double *value = ichol_values(it->ichol);

    for (long t = 0; t < 9 * it->owner.graph->start[it->owner.graph->nodes]; t++)
        if (it->entry[t] >= 0)
            value[it->entry[t]] = it->A[t / 9][t % 9];
    it->factorisations++;
    return ichol_refactor(it->ichol);
}

static void set_precision(struct iterative *it, bool single)
{
    it->single = single;
    it->factored = it->fresh = false;
    it->owner.precise(it->owner.self, single);
}

void iterative_single(struct iterative *it)
{
    set_precision(it, true);
}

static enum status make_factor(struct iterative *it)
{
    enum status st;

    it->factored = it->fresh = false;
    it->factorisations++;
    st = it->owner.factor(it->owner.self, (const double(*)[9])it->A);
    if (st == STATUS_INDEFINITE && it->single) {
        set_precision(it, false);
        return make_factor(it);
    }
    TRY(st);
    it->factored = it->fresh = true;
    it->age = 0, it->spent = it->owner.patience, it->spent_more = false;
    if (it->frames)
        memcpy(it->then, it->now, (size_t)it->owner.graph->nodes * sizeof *it->then);
out:
    return st;
}

/* --- life --------------------------------------------------------------------------------
 */

enum status iterative_create(const struct iterative_owner *owner,
                             const struct factor_pattern *pattern, const long *entry,
                             enum solver solver, enum preconditioner preconditioner,
                             struct iterative **out)
{
    enum status st = STATUS_MEMORY;
    size_t nodes = (size_t)owner->graph->nodes, pairs = (size_t)owner->graph->start[nodes];
    int n = 3 * owner->graph->nodes;
    bool cg = solver == SOLVER_CG, ichol = preconditioner == PRECONDITIONER_ICHOL;
    bool jacobi = preconditioner == PRECONDITIONER_JACOBI;
    struct iterative *it = calloc(1, sizeof *it);

    if (!it)
        return st;
    *it = (struct iterative){
        .owner = *owner, .solver = solver, .preconditioner = preconditioner};
    it->krylov = (struct krylov){
        .n = n, .self = it, .multiply = multiply, .precondition = precondition};
    it->tolerance = TOLERANCE;
    TRY(room_cut(&it->room, ROOM(it->A, pairs), ROOM(it->b, 3 * nodes),
                 ROOM(it->krylov.work, cg ? krylov_cg_work(n) : krylov_gmres_work(n)),
                 ROOM(it->block, jacobi ? nodes : 0), ROOM(it->packed, ichol ? n : 0),
                 ROOM(it->entry, ichol ? 9 * pairs : 0)));
    if (ichol) {
        TRY(ichol_create(pattern, &it->ichol));
        memcpy(it->entry, entry, 9 * pairs * sizeof *entry);
    }
    *out = it, it = NULL;
out:
    iterative_destroy(it);
    return st;
}

void iterative_destroy(struct iterative *it)
{
    if (!it)
        return;
    ichol_destroy(it->ichol);
    free(it->follow);
    free(it->room);
    free(it);
}

double (*iterative_matrix(struct iterative *it))[9]
{
    return it->A;
}

enum status iterative_follow(struct iterative *it,
                             void (*frames)(const void *body, double (*Q)[9]),
                             const void *body, bool guess)
{
    enum status st;

    if (!it)
        return STATUS_OK;
    size_t nodes = (size_t)it->owner.graph->nodes, count = guess ? 3 * nodes : 0;
    TRY(room_cut(&it->follow, ROOM(it->now, nodes), ROOM(it->then, nodes),
                 ROOM(it->turned, 3 * nodes), ROOM(it->past[0], count),
                 ROOM(it->past[1], count), ROOM(it->past[2], count),
                 ROOM(it->past[3], count), ROOM(it->past[4], count)));
    it->frames = frames;
    it->body = body;
out:
    return st;
}

void iterative_tolerate(struct iterative *it, double tolerance, double near)
{
    if (!it)
        return;
    it->tolerance = it->krylov.tolerance = tolerance;
    it->near = it->krylov.near = near;
}

enum solver iterative_method(const struct iterative *it)
{
    return it->solver;
}

void iterative_work(struct iterative *it, long *solves, long *factorisations)
{
    *solves = it->solves, *factorisations = it->factorisations;
    it->solves = it->factorisations = 0;
}

/* --- numbers -----------------------------------------------------------------------------
 */

static void clear_held(struct iterative *it)
{
    const struct blocks *g = it->owner.graph;
    const int *place = it->owner.held->free_index;

    for (int a = 0; a < g->nodes; a++)
        for (long n = g->start[a]; n < g->start[a + 1]; n++) {
            int b = g->node[n];
            bool free = true;
            for (int i = 0; i < 3; i++)
                free = free && place[3 * a + i] >= 0 && place[3 * b + i] >= 0;
            for (int t = 0; t < 9 && (!free || it->owner.parity); t++)
                if (!coupled(&it->owner, 3 * a + t / 3, 3 * b + t % 3))
                    it->A[n][t] = 0;
        }
}

enum status iterative_update(struct iterative *it, bool keep)
{
    clear_held(it);
    it->krylov.tolerance = keep ? it->tolerance : TOLERANCE;
    it->krylov.near = keep ? it->near : 0;
    if (it->frames)
        it->frames(it->body, it->now);
    it->fresh = false;
    if (it->preconditioner == PRECONDITIONER_JACOBI)
        return make_blocks(it);
    if (it->preconditioner == PRECONDITIONER_ICHOL)
        return make_ichol(it);
    return keep && it->factored && !it->spent_more ? STATUS_OK : make_factor(it);
}

/* Guesses x by extrapolating the last solutions, times the factor that is best in the norm
 * of A; zero without them. */
static void guess(struct iterative *it, double *x)
{
    static const double weight[PAST + 1][PAST] = {
        {0}, {1}, {2, -1}, {3, -3, 1}, {4, -6, 4, -1}, {5, -10, 10, -5, 1}};
    const double *w = weight[it->known];
    size_t count = count_of(it);
    double *Ax = it->krylov.work;

    memset(x, 0, count * sizeof *x);
    memset(Ax, 0, count * sizeof *Ax);
    it->krylov.multiplied = it->solver == SOLVER_CG;
    if (!it->known)
        return;
    for (size_t t = 0; t < count; t++)
        for (int n = 0; n < it->known; n++)
            x[t] += w[n] * it->past[n][t];
    multiply(it, x, Ax);
    const int n = it->krylov.n;
    double size = krylov_product(n, x, Ax), part = krylov_product(n, x, it->b) / size;
    if (!(size > 0 && isfinite(part)))
        part = 0;
    for (size_t t = 0; t < count; t++)
        x[t] = part ? part * x[t] : 0, Ax[t] = part ? part * Ax[t] : 0;
}

static void remember(struct iterative *it, const double *x)
{
    double *oldest = it->past[PAST - 1];

    if (!oldest)
        return;
    memmove(it->past + 1, it->past, (PAST - 1) * sizeof *it->past);
    it->past[0] = memcpy(oldest, x, count_of(it) * sizeof *x);
    it->known += it->known < PAST;
}

static enum status iterate(struct iterative *it, int most, double *x, bool *done)
{
    struct krylov *k = &it->krylov;

    k->most = most;
    return it->solver == SOLVER_CG ? krylov_cg(k, it->b, x, done)
                                   : krylov_gmres(k, it->b, x, done);
}

/* Iterates with a factor of this very A. */
static enum status iterate_fresh(struct iterative *it, double *x, bool *done)
{
    enum status st = STATUS_OK;

    if (it->single) {
        double tolerance = it->krylov.tolerance, near = it->krylov.near;
        it->krylov.tolerance = fmin(tolerance, SINGLE_TOLERANCE), it->krylov.near = 0;
        st = iterate(it, MOST_SINGLE, x, done);
        it->krylov.tolerance = tolerance, it->krylov.near = near;
        if (*done || (st != STATUS_OK && st != STATUS_INDEFINITE))
            return st;
        set_precision(it, false);
        TRY(make_factor(it));
        guess(it, x); /* anew: a factor that is too coarse may have led astray */
    }
    st = iterate(it, MOST_FRESH, x, done);
out:
    return st;
}

enum status iterative_solve(struct iterative *it, double *x)
{
    enum status st = STATUS_OK;
    bool done = false, by_factor = it->preconditioner == PRECONDITIONER_FACTOR;
    int most = MOST_AN_UNKNOWN * it->owner.held->free_count + MOST_ANYWAY;

    memcpy(it->b, x, count_of(it) * sizeof *x);
    guess(it, x);
    if (!by_factor) {
        TRY(iterate(it, most, x, &done));
    } else {
        if (!it->fresh) {
            st = iterate(it, it->owner.patience, x, &done);
            if (st != STATUS_OK && st != STATUS_INDEFINITE)
                goto out;
        }
        if (!done) {
            if (st == STATUS_INDEFINITE)
                memset(x, 0, count_of(it) * sizeof *x);
            if (!it->fresh)
                TRY(make_factor(it));
            TRY(iterate_fresh(it, x, &done));
        }
    }
    st = done ? STATUS_OK : STATUS_UNSOLVED;
    it->spent += it->krylov.iterations;
    it->age++;
    it->spent_more = it->krylov.iterations * it->age > it->spent;
    if (done)
        remember(it, x);
out:
    return st;
}

#include "models/mechanics/system.h"

#include <stdlib.h>
#include <string.h>

#include "models/room.h"

/* Tells whether component i of node a (column) and j of node b >= a (row) have an entry in
 * the lower triangle among free unknowns. */
static bool has_entry(const struct supports *held, const unsigned char *parity, int a,
                      int b, int i, int j)
{
    if (held->free_index[3 * a + i] < 0 || held->free_index[3 * b + j] < 0 ||
        (a == b && j < i))
        return false;
    return !parity || parity[3 * a + i] == parity[3 * b + j];
}

/* The lower triangle by columns of the free unknowns; arrays owned. */
struct pattern {
    long *start; /* [free_count + 1]                                                   */
    int *row;    /* [start[free_count]]                                                */
    long *entry; /* [pairs][9] where a block's entry lies in row; -1: nowhere          */
};

static void pattern_clear(struct pattern *p)
{
    free(p->start);
    free(p->row);
    free(p->entry);
}

/* Fills a pattern; clear it in any case. */
static enum status pattern_init(struct pattern *p, const struct blocks *graph,
                                const struct supports *held, const unsigned char *parity)
{
    const size_t entries = 9 * (size_t)graph->start[graph->nodes];
    long count = 0;

    p->start = malloc(((size_t)held->free_count + 1) * sizeof *p->start);
    p->row = malloc((entries + 1) * sizeof *p->row);
    p->entry = malloc((entries + 1) * sizeof *p->entry);
    if (!p->start || !p->row || !p->entry)
        return STATUS_MEMORY;
    for (int a = 0; a < graph->nodes; a++)
        for (int i = 0; i < 3; i++) {
            if (held->free_index[3 * a + i] >= 0)
                p->start[held->free_index[3 * a + i]] = count;
            for (long n = graph->start[a]; n < graph->start[a + 1]; n++)
                for (int j = 0, b = graph->node[n]; j < 3; j++) {
                    const bool has = has_entry(held, parity, a, b, i, j);
                    p->entry[9 * n + 3 * i + j] = has ? count : -1;
                    if (has)
                        p->row[count++] = held->free_index[3 * b + j];
                }
        }
    p->start[held->free_count] = count;
    return STATUS_OK;
}

/* Finds each block entry's slot; those above the diagonal, held or uncoupled get the
 * dump. */
static void find_slots(struct system *s, const struct pattern *p)
{
    const struct blocks *g = s->graph;
    const ptrdiff_t dump = factor_dump(s->factor);
    const int *place = s->held->free_index;

    for (int a = 0; a < g->nodes; a++)
        for (long t = 9 * g->start[a]; t < 9 * g->start[a + 1]; t++)
            s->slot[t] = p->entry[t] < 0 ? dump
                                         : factor_slot(s->factor, p->row[p->entry[t]],
                                                       place[3 * a + t % 9 / 3]);
}

/* Turns a node order into an order of free unknowns. */
static int *order_unknowns(const struct supports *held, const int *order)
{
    int *p = malloc(((size_t)held->free_count + 1) * sizeof *p), count = 0;

    for (int a = 0; p && a < held->nodes; a++)
        for (int i = 0; i < 3; i++)
            if (held->free_index[3 * order[a] + i] >= 0)
                p[count++] = held->free_index[3 * order[a] + i];
    return p;
}

enum status system_parity(const struct scene *scene, int nodes, int layers,
                          unsigned char **parity)
{
    int normal = -1;

    for (int i = 0; i < 3 && scene->shape == SCENE_FLAT && scene->sheets < 2; i++)
        if (scene->axis_u[i] == 0 && scene->axis_v[i] == 0)
            normal = i;
    if (normal < 0)
        return STATUS_OK;
    *parity = malloc(3 * (size_t)nodes);
    for (int t = 0; *parity && t < 3 * nodes; t++)
        (*parity)[t] = (unsigned char)((t / 3 % layers + (t % 3 == normal)) % 2);
    return *parity ? STATUS_OK : STATUS_MEMORY;
}

void system_clear(struct system *s)
{
    factor_destroy(s->factor);
    iterative_destroy(s->iterative);
    free(s->room);
    memset(s, 0, sizeof *s);
}

/* Copies A's numbers to the factor's slots and factors. */
static enum status factor_blocks(void *self, const double (*A)[9])
{
    struct system *s = self;
    long pairs = s->graph->start[s->graph->nodes];
    double *value = factor_values(s->factor);

    factor_clear_values(s->factor);
    for (long n = 0; n < pairs; n++)
        for (int t = 0; t < 9; t++)
            value[s->slot[9 * n + t]] = A[n][t];
    return factor_refactor(s->factor);
}

static enum status solve_factored(void *self, double *x)
{
    struct system *s = self;
    const int *place = s->held->free_index;
    int count = 3 * s->held->nodes;
    enum status st;

    for (int n = 0; n < count; n++)
        if (place[n] >= 0)
            s->packed[place[n]] = x[n];
    st = factor_solve(s->factor, s->packed);
    for (int n = 0; n < count; n++)
        x[n] = place[n] >= 0 ? s->packed[place[n]] : 0;
    return st;
}

static void set_precision(void *self, bool single)
{
    factor_single(((struct system *)self)->factor, single);
}

/* Returns the cost of a factorisation in iterations: its arithmetic is this much faster, as
 * an iteration waits for memory (factor.c's measurements, with a product with A). */
static int patience(const struct factor *f)
{
    const double advantage = 16;
    struct factor_info info;

    factor_describe(f, &info);
    return 2 + (int)(info.flops / (advantage * (double)(info.entries + 1)));
}

static enum status make_iterative(struct system *s, const struct factor_pattern *pattern,
                                  const long *entry, const struct discretization *d)
{
    const struct iterative_owner owner = {.self = s,
                                          .graph = s->graph,
                                          .held = s->held,
                                          .parity = s->parity,
                                          .factor = factor_blocks,
                                          .solve = solve_factored,
                                          .precise = set_precision,
                                          .patience = s->factor ? patience(s->factor) : 0};

    return iterative_create(&owner, pattern, entry, d->solver, d->preconditioner,
                            &s->iterative);
}

enum status system_init(struct system *s, const struct blocks *graph,
                        const struct supports *held, const unsigned char *parity,
                        const int *order, const struct discretization *d)
{
    enum status st = STATUS_MEMORY;
    const bool iterates = d && solver_iterates(d->solver);
    const bool repeats =
        d && d->solver == SOLVER_AUTO && kinematics_rebuilds(d->kinematics);
    const enum solver solver = iterates || repeats ? SOLVER_CG
                               : d                 ? d->solver
                                                   : SOLVER_AUTO;
    struct system new = {.graph = graph, .held = held, .parity = parity};
    struct pattern pattern = {NULL};
    int *unknowns = NULL;

    if (order && !(unknowns = order_unknowns(held, order)))
        goto out;
    TRY(pattern_init(&pattern, graph, held, parity));
    struct factor_pattern p = {held->free_count, pattern.start, pattern.row, unknowns};
    TRY(room_cut(&new.room, ROOM(new.slot, 9 * graph->start[graph->nodes]),
                 ROOM(new.packed, held->free_count)));
    if (!iterates || d->preconditioner == PRECONDITIONER_FACTOR) {
        TRY(factor_create(&p, solver, &new.factor));
        find_slots(&new, &pattern);
    }
    HAND_OVER(s, new);
    if (iterates && (st = make_iterative(s, &p, pattern.entry, d)) != STATUS_OK)
        system_clear(s);
out:
    system_clear(&new);
    pattern_clear(&pattern);
    free(unknowns);
    return st;
}

enum status system_iterate(struct system *s)
{
    const double enough = 2e7; /* flops, as of 12x12x2 control points of degree 2 */
    const struct discretization d = {.solver = SOLVER_CG};
    struct factor_info info;
    enum status st;

    factor_describe(s->factor, &info);
    if (info.flops < enough)
        return STATUS_OK;
    TRY(make_iterative(s, NULL, NULL, &d));
    system_single(s);
out:
    return st;
}

struct model_size system_size(const struct system *s, const char *unknown_basis)
{
    struct factor_info info = {.method = "none"};

    if (s->factor)
        factor_describe(s->factor, &info);
    if (s->iterative)
        info.method = option_solver[iterative_method(s->iterative)];
    return (struct model_size){.nodes = s->held->nodes,
                               .unknowns = s->held->free_count,
                               .factor_entries = info.entries,
                               .solver = info.method,
                               .unknown_basis = unknown_basis};
}

/* Sums a block of k K + m M, n of node a's, as the unknowns have it. */
static inline void sum_block(const struct supports *held, const struct blocks *g, int a,
                             long n, double k, const double (*K)[9], double m,
                             const double *M, double A[9])
{
    const double mass = M ? m * M[n] : 0;

    for (int t = 0; t < 9; t++)
        A[t] = k * K[n][t] + (t % 4 ? 0 : mass);
    if (held->frame_count)
        supports_turn_block(held, a, g->node[n], A);
}

/* Sums k K + m M into A, to iterate on. */
static enum status update(struct system *s, bool keep, double k, const double (*K)[9],
                          double m, const double *M)
{
    const struct blocks *g = s->graph;
    double(*A)[9] = iterative_matrix(s->iterative);

    for (int a = 0; a < g->nodes; a++)
        for (long n = g->start[a]; n < g->start[a + 1]; n++)
            sum_block(s->held, g, a, n, k, K, m, M, A[n]);
    return iterative_update(s->iterative, keep);
}

enum status system_update(struct system *s, double k, const double (*K)[9], double m,
                          const double *M)
{
    if (s->iterative)
        return update(s, true, k, K, m, M);
    s->factorisations++;
    return system_factor(s, k, K, m, M);
}

void system_single(struct system *s)
{
    const long small = 1L << 17; /* in L: 1 MB, which a second cache holds; nets of springs
                                    16 x 16 (72000) gain 2 %, 32 x 32 a third             */
    struct factor_info info;

    if (!s->iterative || !s->factor)
        return;
    factor_describe(s->factor, &info);
    if (info.entries > small)
        iterative_single(s->iterative);
}

void system_work(struct system *s, struct counters *counters)
{
    long solves = 0, factorisations = 0;

    if (s->iterative)
        iterative_work(s->iterative, &solves, &factorisations);
    counters->solves += solves;
    counters->factorisations += factorisations + s->factorisations;
    s->factorisations = 0;
}

enum status system_factor(struct system *s, double k, const double (*K)[9], double m,
                          const double *M)
{
    if (s->iterative)
        return update(s, false, k, K, m, M);
    const struct blocks *g = s->graph;
    double *value = factor_values(s->factor), A[9];
    const bool turns = s->held->frame_count > 0;

    factor_clear_values(s->factor);
    for (int a = 0; turns && a < g->nodes; a++)
        for (long n = g->start[a]; n < g->start[a + 1]; n++) {
            sum_block(s->held, g, a, n, k, K, m, M, A);
            for (int t = 0; t < 9; t++)
                value[s->slot[9 * n + t]] = A[t];
        }
    for (long n = 0; !turns && n < g->start[g->nodes]; n++) {
        const ptrdiff_t *slot = s->slot + 9 * n;
        const double mass = M ? m * M[n] : 0;
        for (int t = 0; t < 9; t++)
            value[slot[t]] = k * K[n][t] + (t % 4 ? 0 : mass);
    }
    return factor_refactor(s->factor);
}

enum status system_solve(struct system *s, double *x)
{
    supports_to_frames(s->held, x);
    const enum status st =
        s->iterative ? iterative_solve(s->iterative, x) : solve_factored(s, x);
    supports_from_frames(s->held, x);
    return st;
}

enum status system_columns(const struct blocks *graph, const struct supports *held,
                           const unsigned char *parity, double k, const double (*K)[9],
                           double m, const double *M, long **start, int **row,
                           double **value)
{
    enum status st;
    struct pattern p = {NULL};
    double *v = NULL, A[9];

    TRY(pattern_init(&p, graph, held, parity));
    v = malloc(((size_t)p.start[held->free_count] + 1) * sizeof *v);
    if (!v)
        TRY(STATUS_MEMORY);
    for (int a = 0; a < graph->nodes; a++)
        for (long n = graph->start[a]; n < graph->start[a + 1]; n++) {
            sum_block(held, graph, a, n, k, K, m, M, A);
            for (int t = 0; t < 9; t++)
                if (p.entry[9 * n + t] >= 0)
                    v[p.entry[9 * n + t]] = A[t];
        }
    *start = p.start, *row = p.row, *value = v;
    p.start = NULL, p.row = NULL;
out:
    pattern_clear(&p);
    return st;
}

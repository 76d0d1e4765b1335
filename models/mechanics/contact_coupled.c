#include "models/mechanics/contact_coupled.h"

#include <stdlib.h>
#include <string.h>

#include "models/mechanics/contact_system.h"
#include "models/room.h"

/* Tells whether the touches couple places of the sheet. */
static bool couples(const struct contact *c)
{
    for (int n = c->count - 1; n >= 0; n--)
        if (c->touch[n].obstacle < 0)
            return true;
    return false;
}

void contact_coupled_clear(struct contact_coupled *w)
{
    system_clear(&w->system);
    blocks_clear(&w->graph);
    free(w->room);
    memset(w, 0, sizeof *w);
}

/* The touches by node: those of node a are list[first[a]] .. list[first[a + 1] - 1]. */
struct touches_of {
    void *room; /*                                                             owned   */
    long *first;
    int *list;
};

static enum status sort_touches(const struct contact *c, int nodes, struct touches_of *of)
{
    enum status st;

    TRY(room_cut(&of->room, ROOM(of->first, nodes + 2), ROOM(of->list, c->weights)));
    for (int k = 0; k < c->weights; k++)
        of->first[c->node[k] + 2]++;
    for (int a = 0; a < nodes; a++)
        of->first[a + 2] += of->first[a + 1];
    for (int t = 0; t < c->count; t++)
        for (int k = 0; k < c->touch[t].count; k++)
            of->list[of->first[c->node[c->touch[t].first + k] + 1]++] = t;
out:
    return st;
}

static int ascending(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

/* Lists the nodes b >= a that the body or touches couple with a, in row[nodes]; mark[nodes]
 * holds no a yet. */
static int collect(const struct contact *c, const struct blocks *body,
                   const struct touches_of *of, int a, int *mark, int *row)
{
    int count = 0;

    for (long n = body->start[a]; n < body->start[a + 1]; n++)
        mark[row[count++] = body->node[n]] = a;
    const int inherent = count;
    for (long n = of->first[a]; n < of->first[a + 1]; n++) {
        const struct contact_touch *t = &c->touch[of->list[n]];
        for (int k = t->first; k < t->first + t->count; k++)
            if (c->node[k] >= a && mark[c->node[k]] != a)
                mark[row[count++] = c->node[k]] = a;
    }
    if (count > inherent)
        qsort(row, (size_t)count, sizeof *row, ascending);
    return count;
}

static enum status make_graph(const struct contact *c, const struct blocks *body,
                              struct blocks *graph)
{
    enum status st;
    const int nodes = body->nodes;
    struct touches_of of = {0};
    int *mark = NULL, *row;
    long room = 0;
    void *work = NULL;

    TRY(room_cut(&work, ROOM(mark, nodes), ROOM(row, nodes)));
    TRY(sort_touches(c, nodes, &of));
    memset(mark, -1, (size_t)nodes * sizeof *mark);
    graph->nodes = nodes;
    graph->start = calloc((size_t)nodes + 1, sizeof *graph->start);
    if (!graph->start)
        TRY(STATUS_MEMORY);
    for (int a = 0; a < nodes; a++) {
        const int count = collect(c, body, &of, a, mark, row);
        const long end = graph->start[a] + count;
        if (end > room) {
            room = 2 * end + body->start[nodes];
            int *more = realloc(graph->node, (size_t)room * sizeof *more);
            if (!more)
                TRY(STATUS_MEMORY);
            graph->node = more;
        }
        memcpy(graph->node + graph->start[a], row, (size_t)count * sizeof *row);
        graph->start[a + 1] = end;
    }
out:
    free(of.room);
    free(work);
    return st;
}

/* Makes the pattern for the present touches. */
static enum status make(struct contact_coupled *w, const struct contact *c,
                        const struct blocks *body, const struct supports *held)
{
    enum status st;

    contact_coupled_clear(w);
    w->used = true;
    TRY(make_graph(c, body, &w->graph));
    const long pairs = w->graph.start[body->nodes];
    TRY(room_cut(&w->room, ROOM(w->place, body->start[body->nodes]), ROOM(w->K, pairs),
                 ROOM(w->M, pairs)));
    for (int a = 0; a < body->nodes; a++)
        for (long n = body->start[a]; n < body->start[a + 1]; n++)
            w->place[n] = blocks_find(&w->graph, a, body->node[n]);
    TRY(system_init(&w->system, &w->graph, held, NULL, NULL, NULL));
out:
    if (st != STATUS_OK)
        contact_coupled_clear(w);
    return st;
}

/* Fills K, with the turning of normals unless x is NULL; false if the pattern lacks a
 * touch's places. */
static bool fill(struct contact_coupled *w, const struct contact *c,
                 const struct blocks *body, const double *x, const double (*K)[9])
{
    memset(w->K, 0, (size_t)w->graph.start[w->graph.nodes] * sizeof *w->K);
    for (long n = 0; n < body->start[body->nodes]; n++)
        memcpy(w->K[w->place[n]], K[n], sizeof K[n]);
    return contact_system_tangent(c, x, &w->graph, w->K);
}

/* Fills M with the body's, NULL: zeros. */
static void fill_mass(struct contact_coupled *w, const struct blocks *body, const double *M)
{
    memset(w->M, 0, (size_t)w->graph.start[w->graph.nodes] * sizeof *w->M);
    for (long n = 0; M && n < body->start[body->nodes]; n++)
        w->M[w->place[n]] = M[n];
}

static enum status add(struct contact_coupled *w, const struct contact *c,
                       const struct system *system, const double *x, double (*K)[9])
{
    enum status st = STATUS_OK;
    const struct blocks *graph = system->graph;

    w->used = couples(c);
    if (!w->used)
        contact_system_tangent(c, x, graph, K);
    else if (!w->room || !fill(w, c, graph, x, (const double(*)[9])K)) {
        TRY(make(w, c, graph, system->held));
        fill(w, c, graph, x, (const double(*)[9])K);
    }
out:
    return st;
}

enum status contact_coupled_add(struct contact_coupled *w, const struct contact *c,
                                const struct system *system, double (*K)[9])
{
    return add(w, c, system, NULL, K);
}

enum status contact_coupled_pencil(struct contact_coupled *w, const struct contact *c,
                                   const struct system *system, const double *x,
                                   double (*K)[9], const double *M, struct pencil *p)
{
    const enum status st = add(w, c, system, x, K);

    if (st == STATUS_OK && w->used) {
        fill_mass(w, system->graph, M);
        p->graph = &w->graph, p->K = (const double(*)[9])w->K, p->M = w->M;
    }
    return st;
}

enum status contact_coupled_update(struct contact_coupled *w, struct system *system,
                                   double k, const double (*K)[9], double m,
                                   const double *M)
{
    if (!w->used)
        return system_update(system, k, K, m, M);
    system->factorisations++;
    fill_mass(w, system->graph, M);
    return system_update(&w->system, k, (const double(*)[9])w->K, m, w->M);
}

enum status contact_coupled_solve(struct contact_coupled *w, struct system *system,
                                  double *x)
{
    return system_solve(w->used ? &w->system : system, x);
}

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

/* Makes the body's graph with what the touches couple: its pairs and they are elements. */
static enum status make_graph(const struct contact *c, const struct blocks *body,
                              struct blocks *graph)
{
    enum status st;
    const long pairs = body->start[body->nodes];
    long *start, next = 0;
    int *ien, count = 0;
    void *work = NULL;

    TRY(room_cut(&work, ROOM(start, pairs + c->count + 1),
                 ROOM(ien, 2 * pairs + c->weights)));
    for (int a = 0; a < body->nodes; a++)
        for (long n = body->start[a]; n < body->start[a + 1]; n++) {
            ien[next++] = a, ien[next++] = body->node[n];
            start[++count] = next;
        }
    for (const struct contact_touch *t = c->touch; t < c->touch + c->count; t++) {
        for (int k = t->first; k < t->first + t->count; k++)
            ien[next++] = c->node[k];
        start[++count] = next;
    }
    TRY(blocks_init_uneven(graph, body->nodes, count, start, ien));
out:
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

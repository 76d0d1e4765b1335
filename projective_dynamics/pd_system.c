#include "projective_dynamics/pd_system.h"

#include <stdlib.h>
#include <string.h>

#include "models/room.h"

/* --- the matrix --------------------------------------------------------------------------
 */

/* Makes the graph of links and rows. */
static enum status make_graph(struct pd_system *s, const struct pd_energy *e)
{
    const int elements = e->link_count + e->row_count;
    int *ien = malloc((size_t)(PD_ROW * elements + 1) * sizeof *ien), *next = ien;
    enum status st = STATUS_MEMORY;

    if (!ien)
        return st;
    for (const struct pd_link *l = e->links; l < e->links + e->link_count; l++)
        for (int k = 0; k < PD_ROW; k++)
            *next++ = k ? l->b : l->a;
    for (const struct pd_row *row = e->rows; row < e->rows + e->row_count; row++)
        for (int k = 0; k < PD_ROW; k++)
            *next++ = row->node[k < row->count ? k : 0];
    st = blocks_init(&s->graph, s->net->nodes, elements, PD_ROW, ien);
    free(ien);
    return st;
}

static void add(struct pd_system *s, int a, int b, double value)
{
    s->entry[blocks_find(&s->graph, a < b ? a : b, a < b ? b : a)] += value;
}

static void add_links(struct pd_system *s, const struct pd_energy *e, double factor)
{
    for (const struct pd_link *l = e->links; l < e->links + e->link_count; l++) {
        const double weight = factor * l->weight;
        add(s, l->a, l->a, weight);
        add(s, l->b, l->b, weight);
        add(s, l->a, l->b, -weight);
    }
}

static void add_rows(struct pd_system *s, const struct pd_energy *e, double factor)
{
    for (int r = 0; r < e->row_count; r++) {
        const struct pd_row *row = &e->rows[r];
        for (int p = 0; p < row->count; p++) {
            double weight = factor * row->weight * row->coefficient[p];
            for (int q = 0; q <= p; q++)
                add(s, row->node[p], row->node[q], weight * row->coefficient[q]);
            for (int c = 0; c < 3; c++)
                s->constant[c * pd_net_stride(s->net) + row->node[p]] +=
                    weight * row->target[c];
        }
    }
}

/* --- factors -----------------------------------------------------------------------------
 */

/* Makes the pattern of all couplings that are ever used: the same for every group. Arrays
 * owned by the caller. */
static enum status make_pattern(const struct pd_system *s, long **start, int **row)
{
    const struct blocks *g = &s->graph;
    long end = 0;

    *start = malloc(((size_t)g->nodes + 1) * sizeof **start);
    *row = malloc((size_t)g->start[g->nodes] * sizeof **row);
    if (!*start || !*row)
        return STATUS_MEMORY;
    for (int k = 0; k < g->nodes; k++) {
        (*start)[k] = end;
        for (long n = g->start[k]; n < g->start[k + 1]; n++)
            if (n == g->start[k] || s->entry[n] != 0)
                (*row)[end++] = g->node[n];
    }
    (*start)[g->nodes] = end;
    return STATUS_OK;
}

static void couple(struct pd_group *g, int node, int held, double value)
{
    g->coupling_free[g->coupling_count] = node;
    g->coupling_held[g->coupling_count] = held;
    g->coupling[g->coupling_count++] = value;
}

static void fill(const struct pd_system *s, struct pd_group *g, const bool *held)
{
    double *value = factor_values(g->factor);

    factor_clear_values(g->factor);
    for (int k = 0; k < s->net->nodes; k++)
        for (long n = s->graph.start[k]; n < s->graph.start[k + 1]; n++) {
            const int other = s->graph.node[n];
            const double a = s->entry[n];
            if (a == 0 && other != k)
                continue;
            if (!held[k] && !held[other])
                value[factor_slot(g->factor, other, k)] += a;
            else if (other == k)
                value[factor_slot(g->factor, k, k)] = 1;
            else if (held[k] != held[other])
                couple(g, held[k] ? other : k, held[k] ? k : other, a);
        }
}

static enum status make_group(struct pd_system *s, const struct factor_pattern *pattern,
                              enum solver solver, struct pd_group *g)
{
    enum status st;
    const bool *held = s->held + (size_t)g->first * s->net->nodes;
    size_t most = 0;

    for (int k = 0; k < s->net->nodes; k++)
        for (long n = s->graph.start[k]; n < s->graph.start[k + 1]; n++)
            most += held[k] != held[s->graph.node[n]];
    TRY(room_cut(&g->room, ROOM(g->coupling_free, most), ROOM(g->coupling_held, most),
                 ROOM(g->coupling, most)));
    /* A band solves three sides together: up to 80 x 80 points that is the faster on a
     * grid.
     */
    if (solver == SOLVER_AUTO && s->net->rows)
        solver = SOLVER_BANDED;
    TRY(factor_create(pattern, solver, &g->factor));
    fill(s, g, held);
    TRY(factor_refactor(g->factor));
out:
    return st;
}

static bool same_held(const struct pd_system *s, int a, int b)
{
    size_t nodes = (size_t)s->net->nodes;

    return !memcmp(s->held + a * nodes, s->held + b * nodes, nodes * sizeof *s->held);
}

/* Groups neighbouring components with the same held nodes. */
static enum status make_groups(struct pd_system *s, const struct mesh *mesh,
                               enum solver solver)
{
    enum status st;
    long *start = NULL;
    int *row = NULL, *order = NULL;

    TRY(mesh_order(mesh, &order));
    TRY(make_pattern(s, &start, &row));
    struct factor_pattern pattern = {s->net->nodes, start, row, order};
    for (int c = 0; c < 3; c += s->group[s->group_count++].count) {
        struct pd_group *g = &s->group[s->group_count];
        g->first = c;
        for (g->count = 1; c + g->count < 3 && same_held(s, c, c + g->count);)
            g->count++;
        st = make_group(s, &pattern, solver, g);
        if (st != STATUS_OK) {
            s->group_count++; /* to be cleared with the others */
            goto out;
        }
    }
out:
    free(start);
    free(row);
    free(order);
    return st;
}

void pd_system_clear(struct pd_system *s)
{
    for (int g = 0; g < s->group_count; g++) {
        factor_destroy(s->group[g].factor);
        free(s->group[g].room);
    }
    if (s->net)
        pd_net_free_fields(s->net, s->constant);
    blocks_clear(&s->graph);
    free(s->room);
    memset(s, 0, sizeof *s);
}

enum status pd_system_init(struct pd_system *s, const struct pd_energy *energy,
                           const struct supports *supports, double mass_factor,
                           double factor, double stretch, enum solver solver)
{
    enum status st;
    size_t nodes = (size_t)energy->net.nodes;
    struct pd_system new = {.net = &energy->net};

    TRY(make_graph(&new, energy));
    TRY(room_cut(&new.room, ROOM(new.entry, new.graph.start[nodes]),
                 ROOM(new.held, 3 * nodes)));
    if (!(new.constant = pd_net_fields(new.net, 3)))
        TRY(STATUS_MEMORY);
    for (int k = 0; k < new.net->nodes; k++)
        add(&new, k, k, mass_factor * energy->mass[k]);
    add_links(&new, energy, factor * stretch);
    add_rows(&new, energy, factor);
    for (int h = 0; h < supports->held_count; h++)
        new.held[supports->held[h] % 3 * nodes + (size_t)supports->held[h] / 3] = true;
    TRY(make_groups(&new, energy->mesh, solver));
    HAND_OVER(s, new);
out:
    pd_system_clear(&new);
    return st;
}

/* --- the step ----------------------------------------------------------------------------
 */

void pd_system_hold(const struct pd_system *s, double *base)
{
    ptrdiff_t stride = pd_net_stride(s->net);

    for (int n = 0; n < s->group_count; n++) {
        const struct pd_group *g = &s->group[n];
        for (int c = g->first; c < g->first + g->count; c++) {
            double *b = base + c * stride;
            for (int t = 0; t < g->coupling_count; t++)
                b[g->coupling_free[t]] -= g->coupling[t] * b[g->coupling_held[t]];
        }
    }
}

enum status pd_system_solve(struct pd_system *s, double *b)
{
    enum status st = STATUS_OK;
    ptrdiff_t stride = pd_net_stride(s->net);

    for (int n = 0; n < s->group_count; n++)
        TRY(factor_solve_many(s->group[n].factor, s->group[n].count,
                              b + s->group[n].first * stride, stride));
out:
    return st;
}

void pd_system_subtract(const struct pd_system *s, const double *x, double *b)
{
    const int nodes = s->net->nodes;

    for (int c = 0; c < 3; c++, x += pd_net_stride(s->net), b += pd_net_stride(s->net)) {
        const bool *held = s->held + (size_t)c * nodes;
        for (int k = 0; k < nodes; k++)
            for (long n = s->graph.start[k]; n < s->graph.start[k + 1]; n++) {
                const int other = s->graph.node[n];
                const double a = s->entry[n];
                b[k] -= held[other] && !held[k] ? 0 : a * x[other];
                if (other != k)
                    b[other] -= held[k] && !held[other] ? 0 : a * x[k];
            }
    }
}

double pd_system_diagonal(const struct pd_system *s, int node)
{
    return s->entry[s->graph.start[node]];
}

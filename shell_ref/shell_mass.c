#include "shell_ref/shell_mass.h"

#include <stdlib.h>

/* P in units of D. D^-1 (M + P) must stay below 2: it is 1.86 at most. */
static const double EDGE = 1.6;

enum { STENCIL = 3 }; /* control points that a second derivative at an end depends on */

/* One end of a direction: the derivative there, from the end inward. */
struct end {
    int last, way; /* of the node at the end, and to the next one                       */
    double q[STENCIL];
};

/* Fills both ends of a direction of a part; false where it has none, or they meet. */
static bool find_ends(const struct bspline *basis, int part, int count, int way,
                      struct end end[2])
{
    const struct bspline own = bspline_part(basis, part), *b = &own;
    double N[3 * BSPLINE_MAX_ORDER];

    if (basis->wrap || count < 2 * (b->p + 1))
        return false;
    for (int n = 0; n < 2; n++) {
        end[n] = (struct end){n ? (count - 1) * way : 0, n ? -way : way, {0}};
        bspline_eval(b, bspline_span(b, n), n, 2, N);
        for (int a = 0; a < STENCIL; a++)
            end[n].q[a] = N[2 * (b->p + 1) + (n ? b->p - a : a)];
    }
    return true;
}

/* A derivative: its control points and their factors. */
struct stencil {
    int count, node[STENCIL * STENCIL];
    double q[STENCIL * STENCIL];
};

/* Makes that across an end at the node `origin` along it; or across two. */
static struct stencil across(const struct end *end, const struct end *other, int origin)
{
    struct stencil s = {.count = other ? STENCIL * STENCIL : STENCIL};

    for (int n = 0; n < s.count; n++) {
        const int a = n % STENCIL, b = n / STENCIL;
        s.node[n] = origin + end->last + a * end->way;
        s.q[n] = end->q[a];
        if (other)
            s.node[n] += other->last + b * other->way, s.q[n] *= other->q[b];
    }
    return s;
}

struct masses {
    const struct blocks *graph;
    const struct supports *supports;
    double *D, *beyond;
};

static bool is_free(const struct masses *m, const struct stencil *s)
{
    for (int n = 0; n < 3 * s->count; n++)
        if (m->supports->free_index[3 * s->node[n / 3] + n % 3] < 0)
            return false;
    return true;
}

/* Adds so much mass of a derivative to P, in units of D. */
static void add(const struct masses *m, const struct stencil *s, double mass)
{
    double compliance = 0;

    for (int n = 0; n < s->count; n++)
        compliance += s->q[n] * s->q[n] / m->D[s->node[n]];
    for (int a = 0; a < s->count; a++)
        for (int b = 0; b < s->count; b++)
            if (s->node[a] <= s->node[b])
                m->beyond[blocks_find(m->graph, s->node[a], s->node[b])] -=
                    mass / compliance * s->q[a] * s->q[b];
}

/* Tells whether the other direction's end has masses where this end's stencil is. */
static bool meets(const struct masses *m, const struct end *end, const struct end *other,
                  int origin)
{
    for (int a = 0; a < STENCIL; a++) {
        const struct stencil s = across(other, NULL, origin + end->last + a * end->way);
        if (is_free(m, &s))
            return true;
    }
    return false;
}

/* Adds the ends of one direction, of nodes `origin` + i `way`, i < count. What an end of
 * the other direction has, too, is counted once, and rows beside a corner that is not free
 * are left out where it has masses: their sum would pass 2. */
static void add_ends(const struct masses *m, const struct end end[2],
                     const struct end *other, int origin, int way, int count)
{
    for (int n = 0; n < 2 * count; n++) {
        const int i = n / 2;
        const struct end *e = &end[n % 2], *o = other + (i >= STENCIL);
        const struct stencil s = across(e, NULL, origin + i * way);
        if (!is_free(m, &s))
            continue;
        if (other && (i < STENCIL || i >= count - STENCIL) && meets(m, e, o, origin)) {
            const struct stencil corner = across(e, o, origin);
            if (!is_free(m, &corner))
                continue;
            if (i == 0 || i == count - 1)
                add(m, &corner, -EDGE);
        }
        add(m, &s, EDGE);
    }
}

enum status shell_mass_beyond(const struct shell_space *space, const struct blocks *graph,
                              const struct supports *supports, const double *M,
                              double *lumped, double *beyond)
{
    const int parts = space->basis[0].parts > 1 ? space->basis[0].parts : 1;
    const int rows = bspline_points(&space->basis[1]),
              columns = graph->nodes / rows / parts;
    struct masses m = {graph, supports, calloc((size_t)graph->nodes, sizeof(double)),
                       beyond};
    struct end u[2], v[2];

    if (!m.D)
        return STATUS_MEMORY;
    for (int a = 0; a < graph->nodes; a++)
        for (long n = graph->start[a]; n < graph->start[a + 1]; n++) {
            lumped[n] = 0;
            beyond[n] = -M[n];
            m.D[a] += M[n];
            if (n > graph->start[a])
                m.D[graph->node[n]] += M[n];
        }
    for (int a = 0; a < graph->nodes; a++) {
        lumped[graph->start[a]] = m.D[a];
        beyond[graph->start[a]] += m.D[a];
    }
    for (int part = 0; part < parts; part++) {
        const int origin = part * columns * rows;
        const bool across_u = find_ends(&space->basis[0], part, columns, rows, u),
                   across_v = find_ends(&space->basis[1], 0, rows, 1, v);
        if (across_u)
            add_ends(&m, u, NULL, origin, 1, rows);
        if (across_v)
            add_ends(&m, v, across_u ? u : NULL, origin, rows, columns);
    }
    free(m.D);
    return STATUS_OK;
}

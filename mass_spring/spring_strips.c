#include "mass_spring/spring_strips.h"

#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "models/vector.h"

/* The springs ahead of a point; the rows that they reach, and that bending reaches. */
enum { SPRINGS = SPRING_STENCIL_NEAR / 2, ROWS = 2, REACH = 2 };

/* The neighbours ahead: first those with springs. */
static const int AHEAD[SPRING_STRIPS_AHEAD] = {4, 5, 6, 7, 10, 11};

static int row_length(const struct spring_strips *s)
{
    return s->stencil->mesh->points[1];
}

/* Returns a thread's room: [2 rows][3] of points, the same of the geometry, strains. */
static double *room_of(const struct spring_strips *s, int thread)
{
    return s->work + (size_t)thread * s->room;
}

static double *geometry_of(const struct spring_strips *s, int thread)
{
    return room_of(s, thread) + 3 * ROWS * row_length(s);
}

static double *strains_of(const struct spring_strips *s, int thread)
{
    return room_of(s, thread) + 2 * 3 * ROWS * row_length(s);
}

/* Returns the value of form n, of a row that softens. */
static double *soft_strain(const struct spring_strips *s, int thread, int row, int n)
{
    return strains_of(s, thread) + (SPRINGS + 3) * row_length(s) +
           3 * (n - s->stencil->soft.forms.row_at[row]);
}

/* Computes the edge of x, from `first` on, from a to b; returns its square. */
static double edge(const double *x, int first, int a, int b, double e[3])
{
    vector_between(x + 3 * (a - first), x + 3 * (b - first), e);
    return vector_dot(e, e);
}

/* Returns the other end of the k-th spring ahead of a, -1: there is none. */
static int spring_end(const struct spring_stencil *t, int a, int k)
{
    return t->spring[a][AHEAD[k]] > 0 ? spring_stencil_node(t->mesh, a, AHEAD[k]) : -1;
}

/* Returns k / r^2. */
static double strength(const struct spring_stencil *t, int a, int k)
{
    return 2 * t->spring[a][AHEAD[k]];
}

static void bending_at(const struct spring_stencil *t, int a, const double *x, double f[3])
{
    double now[3], rest[3];

    f[0] = f[1] = f[2] = 0;
    for (int n = 0; n < SPRING_STENCIL_ALL; n++) {
        int b = spring_stencil_node(t->mesh, a, n);
        if (b < 0)
            continue;
        edge(x, 0, a, b, now);
        edge(t->mesh->rest, 0, a, b, rest);
        for (int c = 0; c < 3; c++)
            f[c] -= t->bend[a][n] * (now[c] - rest[c]);
    }
}

static double *strain_of(const void *self, int thread, int row, const double *x,
                         const struct large_foresight *foresight)
{
    const double *change = foresight ? foresight->change : NULL;
    const struct spring_strips *s = self;
    const struct spring_stencil *t = s->stencil;
    int m = row_length(s), rows = t->mesh->points[0] - row, first = row * m;
    const struct spring_forms *soft = &t->soft.forms;
    double *strain = strains_of(s, thread), e[3];

    memcpy(room_of(s, thread), x + 3 * (size_t)first,
           3 * (size_t)m * (size_t)(rows < ROWS ? rows : ROWS) * sizeof *x);
    for (int j = 0; j < m; j++) {
        int a = first + j;
        for (int k = 0; k < SPRINGS; k++) {
            int b = spring_end(t, a, k);
            double l2 = b < 0 ? 0 : edge(x, 0, a, b, e) - t->square[AHEAD[k]];
            if (b >= 0 && change) /* |e - d|^2 + 2 (e - d) d: what was foreseen */
                l2 -= edge(change, 0, a, b, e);
            strain[SPRINGS * j + k] = l2 / 2;
        }
        bending_at(t, a, x, strain + SPRINGS * m + 3 * j);
    }
    for (int n = soft->row_at[row]; n < soft->row_at[row + 1]; n++)
        spring_form_value(soft, n, x, soft_strain(s, thread, row, n));
    return strain;
}

static void set_geometry(const void *self, int thread, int row, const double *x_old,
                         double share)
{
    const struct spring_strips *s = self;
    const double *now = room_of(s, thread);
    double *x = geometry_of(s, thread);
    int m = row_length(s), rows = s->stencil->mesh->points[0] - row;
    int count = 3 * m * (rows < ROWS ? rows : ROWS);

    for (int n = 0; n < count; n++)
        x[n] = share == 1 ? now[n] : (1 - share) * x_old[3 * row * m + n] + share * now[n];
}

static void add_force(const void *self, int thread, int row, double *force)
{
    const struct spring_strips *s = self;
    const struct spring_stencil *t = s->stencil;
    const struct spring_forms *soft = &t->soft.forms;
    const double *x = geometry_of(s, thread), *strain = strains_of(s, thread);
    int m = row_length(s), first = row * m;
    double e[3];

    for (int j = 0; j < m; j++) {
        int a = first + j;
        for (int k = 0; k < SPRINGS; k++) {
            int b = spring_end(t, a, k);
            double pull = strength(t, a, k) * strain[SPRINGS * j + k];
            if (b < 0)
                continue;
            edge(x, first, a, b, e);
            for (int c = 0; c < 3; c++) {
                force[3 * b + c] += pull * e[c];
                force[3 * a + c] -= pull * e[c];
            }
        }
        for (int c = 0; c < 3; c++)
            force[3 * a + c] += strain[SPRINGS * m + 3 * j + c];
    }
    for (int n = soft->row_at[row]; n < soft->row_at[row + 1]; n++)
        spring_soft_force(&t->soft, n, soft_strain(s, thread, row, n), force);
}

/* Adds all I + along e e' between a and the n-th ahead of it to K, in its four blocks. */
static void add_block(const struct spring_strips *s, int a, int n, double all, double along,
                      const double e[3], double (*K)[9])
{
    const struct blocks *graph = &s->stencil->springs->graph;
    int b = spring_stencil_node(s->stencil->mesh, a, AHEAD[n]);
    double *aa = K[graph->start[a]], *bb = K[graph->start[b]];
    double *ab = s->pair[a][n] < 0 ? NULL : K[s->pair[a][n]];

    for (int t = 0; t < 9; t++) {
        double k = along * e[t / 3] * e[t % 3] + (t % 4 == 0 ? all : 0);
        aa[t] += k, bb[t] += k;
        if (ab)
            ab[t] -= k;
    }
}

static void add_tangent(const void *self, int thread, int row,
                        const struct large_path *path, double (*K)[9])
{
    const struct spring_strips *s = self;
    const struct spring_stencil *t = s->stencil;
    const struct spring_forms *soft = &t->soft.forms;
    const double *x = geometry_of(s, thread), *strain = strains_of(s, thread);
    int m = row_length(s), first = row * m;

    for (int j = 0; j < m; j++)
        for (int n = 0; n < SPRING_STRIPS_AHEAD; n++) {
            int a = first + j, b = spring_stencil_node(t->mesh, a, AHEAD[n]);
            double all = path->s1 * t->bend[a][AHEAD[n]], along = 0, e[3] = {0, 0, 0};
            if (b < 0)
                continue;
            if (n < SPRINGS) {
                along = (path->s1 + path->lag) * strength(t, a, n);
                all += path->g1 * strength(t, a, n) * strain[SPRINGS * j + n];
                edge(x, first, a, b, e);
            }
            add_block(s, a, n, all, along, e, K);
        }
    for (int n = soft->row_at[row]; n < soft->row_at[row + 1]; n++)
        spring_soft_tangent(&t->soft, n, soft_strain(s, thread, row, n), path->s1,
                            &t->springs->graph, K);
}

static enum status energy_of(const void *self, const double *x, double *energy)
{
    const struct spring_strips *s = self;

    *energy = spring_stencil_energy(s->stencil, x);
    return STATUS_OK;
}

void spring_strips_clear(struct spring_strips *s)
{
    free(s->slab);
    free(s->pair);
    free(s->work);
    memset(s, 0, sizeof *s);
}

static void find_pairs(struct spring_strips *s)
{
    const struct mesh *net = s->stencil->mesh;

    for (int a = 0; a < net->nodes; a++)
        for (int n = 0; n < SPRING_STRIPS_AHEAD; n++) {
            int b = spring_stencil_node(net, a, AHEAD[n]);
            s->pair[a][n] = b < 0 ? -1 : blocks_find(&s->stencil->springs->graph, a, b);
        }
}

enum status spring_strips_init(struct spring_strips *s,
                               const struct spring_stencil *stencil)
{
    enum status st;
    const struct mesh *net = stencil->mesh;
    const size_t m = (size_t)net->points[1];
    const size_t soft = (size_t)spring_forms_most(&stencil->soft.forms, net);
    const size_t strains = (SPRINGS + 3) * m + 3 * soft;

    *s = (struct spring_strips){.stencil = stencil, .room = 2 * 3 * ROWS * m + strains};
    s->body = (struct large_body){.self = s,
                                  .nodes = net->nodes,
                                  .threads = omp_get_max_threads(),
                                  .pairs = stencil->springs->graph.start[net->nodes],
                                  .strains = strains,
                                  .lagged = SPRINGS * m,
                                  .strain = strain_of,
                                  .geometry = set_geometry,
                                  .force = add_force,
                                  .tangent = add_tangent,
                                  .energy = energy_of};
    TRY(blocks_slabs(net->points[0], 1, REACH, &s->body.slabs, &s->slab));
    s->body.slab = s->slab;
    s->pair = malloc((size_t)net->nodes * sizeof *s->pair);
    s->work = calloc((size_t)s->body.threads * s->room, sizeof *s->work);
    if (!s->pair || !s->work)
        TRY(STATUS_MEMORY);
    find_pairs(s);
out:
    return st;
}

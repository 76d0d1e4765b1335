#include "models/mechanics/air.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"
#include "models/vector.h"

enum status air_init(struct air *p, const struct scene *scene, int elements, int points,
                     int local)
{
    const size_t nodes = (size_t)elements * (size_t)local;

    *p = (struct air){.density = scene->air.density,
                      .elements = elements,
                      .points = points,
                      .local = local};
    memcpy(p->drag, scene->air.drag, sizeof p->drag);
    air_blow(p, scene, 0);
    if (p->density == 0)
        return STATUS_OK;
    return room_cut(&p->room, ROOM(p->node, nodes),
                    ROOM(p->shape, 3 * (size_t)points * nodes));
}

void air_clear(struct air *p)
{
    free(p->room);
    memset(p, 0, sizeof *p);
}

void air_blow(struct air *p, const struct scene *scene, double t)
{
    scene_motion_table(scene->air.wind_count, 4, (const double *)scene->air.wind, t,
                       p->wind);
}

/* This is known at a point. */
struct gust {
    double weight;      /* the sum of the functions times it                           */
    double slope[2][3]; /* x_u, x_v                                                     */
    double area[3], J;  /* x_u x x_v, its length                                        */
    double w[3];        /* wind less velocity                                     [m/s] */
    double n[3], w_n;   /* unit normal, w n                                             */
    double w_t[3], t;   /* the part along the sheet, its length                         */
};

static const int *nodes_of(const struct air *p, int element)
{
    return p->node + (size_t)element * (size_t)p->local;
}

static const double *shape_of(const struct air *p, int element, int point)
{
    return p->shape +
           3 * ((size_t)element * (size_t)p->points + (size_t)point) * (size_t)p->local;
}

static struct gust gust_at(const struct air *p, const int *node, const double *N,
                           const struct air_motion *m)
{
    struct gust g = {0};

    for (int a = 0; a < p->local; a++)
        for (int i = 0; i < 3; i++) {
            const size_t t = 3 * (size_t)node[a] + (size_t)i;
            const double x =
                m->share == 1 ? m->x[t] : (1 - m->share) * m->x_old[t] + m->share * m->x[t];
            const double v = m->v           ? m->v[t]
                             : m->rate != 0 ? m->rate * (m->x[t] - m->x_old[t])
                                            : 0;
            g.weight += i == 0 ? N[a] : 0;
            g.w[i] -= N[a] * v;
            g.slope[0][i] += N[p->local + a] * x;
            g.slope[1][i] += N[2 * p->local + a] * x;
        }
    vector_cross(g.slope[0], g.slope[1], g.area);
    g.J = vector_length(g.area);
    for (int i = 0; i < 3; i++) {
        g.w[i] = p->wind[i] + g.w[i] / g.weight;
        g.n[i] = g.J > 0 ? g.area[i] / g.J : 0;
    }
    g.w_n = vector_dot(g.w, g.n);
    for (int i = 0; i < 3; i++)
        g.w_t[i] = g.w[i] - g.w_n * g.n[i];
    g.t = vector_length(g.w_t);
    return g;
}

/* Computes the force at a point, but for the weight. */
static void push(const struct air *p, const struct gust *g, double f[3])
{
    const double along = p->density / 2 * p->drag[0] * fabs(g->w_n) * g->w_n,
                 beside = p->density / 2 * p->drag[1] * g->J * g->t;

    for (int i = 0; i < 3; i++)
        f[i] = along * g->area[i] + beside * g->w_t[i];
}

/* Computes the derivative of that force by w, D[3][3]. */
static void resist(const struct air *p, const struct gust *g, double D[9])
{
    const double half = p->density / 2 * g->J, n = 2 * half * p->drag[0] * fabs(g->w_n),
                 t = half * p->drag[1] * g->t,
                 more = g->t > 0 ? half * p->drag[1] / g->t : 0;

    for (int k = 0; k < 9; k++)
        D[k] = (n - t) * g->n[k / 3] * g->n[k % 3] + more * g->w_t[k / 3] * g->w_t[k % 3] +
               (k % 4 == 0) * t;
}

/* Computes the derivatives of the force by x_u and x_v, G[2][3][3], from that by their
 * product. */
static void lean(const struct air *p, const struct gust *g, double G[2][9])
{
    const double half = p->density / 2, n = half * p->drag[0] * fabs(g->w_n),
                 t = half * p->drag[1], more = g->t > 0 ? t * g->w_n / g->t : 0;
    double A[9];

    for (int k = 0; k < 9; k++) {
        const int i = k / 3, j = k % 3, same = i == j;
        A[k] = n * (same * g->w_n + 2 * g->n[i] * g->w_t[j]) +
               t * g->t *
                   (g->w_t[i] * g->n[j] - g->n[i] * g->w_t[j] -
                    g->w_n * (same - g->n[i] * g->n[j])) -
               more * g->w_t[i] * g->w_t[j];
    }
    for (int i = 0; i < 3; i++) { /* d area = d x_u x x_v + x_u x d x_v */
        vector_cross(g->slope[1], A + 3 * i, G[0] + 3 * i);
        vector_cross(A + 3 * i, g->slope[0], G[1] + 3 * i);
    }
}

void air_force(const struct air *p, double factor, const struct air_motion *at, double *f)
{
    for (int n = 0; n < p->elements * p->points; n++) {
        const int *node = nodes_of(p, n / p->points);
        const double *N = shape_of(p, 0, n);
        const struct gust g = gust_at(p, node, N, at);
        double force[3];
        push(p, &g, force);
        for (int a = 0; a < p->local; a++)
            for (int i = 0; i < 3; i++)
                f[3 * (size_t)node[a] + (size_t)i] += factor * N[a] * force[i];
    }
}

/* This is the part of a point in the tangent: by velocity over the weight, and by slopes.
 */
struct bend {
    double D[9], G[2][9];
};

/* Adds an element's part for a pair of its functions. */
static void add_pair(const struct air *p, const double *N, int a, int b,
                     const struct bend *bend, double K[9])
{
    for (int q = 0; q < p->points; q++, N += 3 * p->local, bend++) {
        const double *u = N + p->local, *v = u + p->local;
        for (int k = 0; k < 9; k++) {
            const int t = k % 3 * 3 + k / 3; /* the transposed place */
            K[k] += N[a] * N[b] * bend->D[k] -
                    N[a] * (u[b] * bend->G[0][k] + v[b] * bend->G[1][k]) -
                    N[b] * (u[a] * bend->G[0][t] + v[a] * bend->G[1][t]);
        }
    }
}

void air_tangent(const struct air *p, double factor, const struct air_motion *at, bool firm,
                 const struct blocks *graph, double (*K)[9])
{
    struct bend bend[AIR_MOST];

    for (int n = 0; n < p->elements; n++) {
        const int *node = nodes_of(p, n);
        memset(bend, 0, sizeof bend);
        for (int q = 0; q < p->points; q++) {
            const struct gust g = gust_at(p, node, shape_of(p, n, q), at);
            resist(p, &g, bend[q].D);
            if (!firm)
                lean(p, &g, bend[q].G);
            for (int k = 0; k < 9; k++) {
                bend[q].D[k] *= factor * at->rate / g.weight;
                bend[q].G[0][k] *= factor * at->share / 2;
                bend[q].G[1][k] *= factor * at->share / 2;
            }
        }
        for (int a = 0; a < p->local; a++)
            for (int b = 0; b < p->local; b++) {
                const long pair =
                    node[a] <= node[b] ? blocks_find(graph, node[a], node[b]) : -1;
                if (pair >= 0) /* pairs across a cell have no part */
                    add_pair(p, shape_of(p, n, 0), a, b, bend, K[pair]);
            }
    }
}

void air_ahead(const struct air *p, const struct air_step *s)
{
    const struct air_motion at = {.x = s->x, .v = s->v, .share = 1};
    static const int place[3] = {0, 1, 2};

    memset(s->force, 0, 3 * (size_t)s->nodes * sizeof *s->force);
    memset(s->hold, 0, (size_t)s->nodes * sizeof *s->hold);
    air_force(p, 1, &at, s->force);
    for (int n = 0; n < p->elements * p->points; n++) {
        const int *node = nodes_of(p, n / p->points);
        const double *N = shape_of(p, 0, n);
        const struct gust g = gust_at(p, node, N, &at);
        double D[9];
        resist(p, &g, D);
        for (int a = 0; a < p->local; a++)
            for (int k = 0; k < 9; k++)
                s->hold[node[a]][k] += N[a] * D[k];
    }
    for (int a = 0; a < s->nodes; a++) {
        const double *v = s->v + 3 * a, *from = s->from + 3 * a, *load = s->load + 3 * a,
                     *D = s->hold[a], m = s->mass[a],
                     c = m + (s->drag ? s->dt * s->drag[a] : 0);
        double *f = s->force + 3 * a, A[9], inverse[9], b[3], change[3];
        for (int k = 0; k < 9; k++)
            A[k] = s->dt * D[k] + (k % 4 == 0) * c;
        for (int i = 0; i < 3; i++) /* of the change from v */
            b[i] = m * from[i] - c * v[i] + s->dt * (load[i] + f[i]);
        if (!(m > 0) || !blocks_invert(A, place, inverse)) {
            memset(f, 0, 3 * sizeof *f);
            continue;
        }
        for (int i = 0; i < 3; i++)
            change[i] = vector_dot(inverse + 3 * i, b);
        for (int i = 0; i < 3; i++)
            f[i] -= vector_dot(D + 3 * i, change);
    }
}

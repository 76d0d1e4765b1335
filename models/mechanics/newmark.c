#include "models/mechanics/newmark.h"

#include <stdlib.h>
#include <string.h>

void newmark_clear(struct newmark *n)
{
    free(n->d);
    memset(n, 0, sizeof *n);
}

enum status newmark_init(struct newmark *n, int nodes, double dt, double alpha, double beta)
{
    size_t count = 3 * (size_t)nodes;
    double *room = calloc(6 * count + 1, sizeof *room);

    if (!room)
        return STATUS_MEMORY;
    *n = (struct newmark){.dt = dt,
                          .alpha = alpha,
                          .beta = beta,
                          .d = room,
                          .v = room + count,
                          .a = room + 2 * count,
                          .work = room + 3 * count};
    return STATUS_OK;
}

double newmark_k(const struct newmark *n)
{
    return n->dt * n->dt / 4 + n->beta * n->dt / 2;
}

double newmark_m(const struct newmark *n)
{
    return 1 + n->alpha * n->dt / 2 + n->gamma * n->dt * n->dt / 4;
}

struct newmark_held newmark_follow(const struct supports *s, const struct scene *scene,
                                   double t, double dt, double *room)
{
    int count = s->held_count;
    double *d = room, *v = d + count, *a = v + count, *work = a + count;

    supports_shift(s, scene, t, d);
    supports_shift(s, scene, t + dt, v);
    supports_shift(s, scene, t - dt, work);
    for (int h = 0; h < count; h++) {
        double ahead = v[h], behind = work[h];
        v[h] = (ahead - behind) / (2 * dt);
        a[h] = (ahead - 2 * d[h] + behind) / (dt * dt);
    }
    return (struct newmark_held){d, v, a};
}

/* Subtracts M (a + alpha v + gamma d) + K (d + beta v) of the held unknowns, whose motion
 * is given, from rhs. */
static void subtract_held(struct newmark *n, struct system *s, const double (*K)[9],
                          const double *M, const struct newmark_held *held, double *rhs)
{
    size_t count = 3 * (size_t)s->graph->nodes;
    double *x = n->work + count, *y = n->work + 2 * count;

    memset(x, 0, count * sizeof *x);
    for (int h = 0; h < s->held->held_count; h++)
        supports_set(s->held, h, x,
                     held->a[h] + n->alpha * held->v[h] + n->gamma * held->d[h]);
    blocks_multiply_mass(s->graph, M, x, y);
    for (size_t t = 0; t < count; t++)
        rhs[t] -= y[t];
    for (int h = 0; h < s->held->held_count; h++)
        supports_set(s->held, h, x, held->d[h] + n->beta * held->v[h]);
    blocks_multiply(s->graph, K, x, y);
    for (size_t t = 0; t < count; t++)
        rhs[t] -= y[t];
}

enum status newmark_begin(struct newmark *n, struct system *s, const double (*K)[9],
                          const double *M, const double *load,
                          const struct newmark_held *held, struct counters *counters)
{
    enum status st;
    int held_count = held ? s->held->held_count : 0;
    size_t count = 3 * (size_t)s->graph->nodes;
    double *x = n->work, *y = n->work + count;

    for (int h = 0; h < held_count; h++) {
        supports_set(s->held, h, n->d, held->d[h]);
        supports_set(s->held, h, n->v, held->v[h]);
    }
    for (size_t t = 0; t < count; t++)
        x[t] = n->alpha * n->v[t];
    for (int h = 0; h < held_count; h++)
        supports_set(s->held, h, x, supports_get(s->held, h, x) + held->a[h]);
    blocks_multiply_mass(s->graph, M, x, y);
    for (size_t t = 0; t < count; t++) {
        n->a[t] = load[t] - y[t];
        x[t] = n->d[t] + n->beta * n->v[t];
    }
    blocks_multiply(s->graph, K, x, y);
    for (size_t t = 0; t < count; t++)
        n->a[t] -= y[t];
    TRY(system_factor(s, 0, K, 1, M));
    TRY(system_solve(s, n->a));
    for (int h = 0; h < held_count; h++)
        supports_set(s->held, h, n->a, held->a[h]);
    TRY(system_factor(s, newmark_k(n), K, newmark_m(n), M));
    counters->factorisations += 2;
    counters->solves++;
out:
    return st;
}

void newmark_predict(struct newmark *n, struct system *s, const double (*K)[9],
                     const double *M, const double *load, const struct newmark_held *held)
{
    size_t count = 3 * (size_t)s->graph->nodes;
    double dt = n->dt, c = dt * dt / 4, k = newmark_k(n), m = newmark_m(n);
    double *w = n->work, *z = n->work + count;

    for (size_t t = 0; t < count; t++) {
        double p = n->d[t] + dt * n->v[t] + c * n->a[t];
        double q = n->v[t] + dt / 2 * n->a[t];
        w[t] = m * ((p + n->beta * q) / k) - n->alpha * q - n->gamma * p;
    }
    supports_zero(s->held, w);
    blocks_multiply_mass(s->graph, M, w, z);
    for (size_t t = 0; t < count; t++)
        w[t] = z[t] + load[t];
    if (held)
        subtract_held(n, s, K, M, held, w);
}

void newmark_correct(struct newmark *n, const struct system *s, const double *w,
                     const struct newmark_held *held)
{
    size_t count = 3 * (size_t)s->graph->nodes;
    double dt = n->dt, c = dt * dt / 4, k = newmark_k(n);

    for (size_t t = 0; t < count; t++) {
        double p = n->d[t] + dt * n->v[t] + c * n->a[t];
        double q = n->v[t] + dt / 2 * n->a[t];
        n->a[t] = w[t] - (p + n->beta * q) / k;
        n->d[t] = p + c * n->a[t];
        n->v[t] = q + dt / 2 * n->a[t];
    }
    for (int h = 0; h < s->held->held_count; h++) {
        supports_set(s->held, h, n->d, held ? held->d[h] : 0);
        supports_set(s->held, h, n->v, held ? held->v[h] : 0);
        supports_set(s->held, h, n->a, held ? held->a[h] : 0);
    }
}

enum status newmark_step(struct newmark *n, struct system *s, const double (*K)[9],
                         const double *M, const double *load,
                         const struct newmark_held *held)
{
    enum status st;

    newmark_predict(n, s, K, M, load, held);
    TRY(system_solve(s, n->work));
    newmark_correct(n, s, n->work, held);
out:
    return st;
}

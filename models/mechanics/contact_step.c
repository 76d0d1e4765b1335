#include "models/mechanics/contact_step.h"

#include <stdlib.h>
#include <string.h>

void contact_step_clear(struct contact_step *c)
{
    contact_set_clear(&c->set);
    system_clear(&c->mass);
    free(c->arrest);
    memset(c, 0, sizeof *c);
}

enum status contact_step_init(struct contact_step *c, const struct scene *scene,
                              const struct blocks *graph, const struct supports *supports,
                              double offset, const int *order,
                              const struct discretization *d)
{
    enum status st;

    memset(c, 0, sizeof *c);
    TRY(contact_set_init(&c->set, scene, supports, offset));
    if (!contact_set_used(&c->set))
        return STATUS_OK;
    TRY(system_init(&c->mass, graph, supports, NULL, order, d));
    c->arrest = malloc((size_t)supports->nodes * sizeof *c->arrest);
    st = c->arrest ? STATUS_OK : STATUS_MEMORY;
out:
    if (st != STATUS_OK)
        contact_step_clear(c);
    return st;
}

enum status contact_step_impact(struct contact_step *c, const double *M, double dt,
                                double unit, double *v, double *work,
                                struct counters *counters)
{
    enum status st = STATUS_OK;
    struct contact_set *set = &c->set;
    const struct blocks *graph = c->mass.graph;
    const double(*P)[9] = (const double(*)[9])c->arrest;
    size_t count = 3 * (size_t)set->nodes;
    double *change = work, *r = work + count;

    if (contact_set_arrest(set, v, change, c->arrest) <= 2 * set->rounding / dt)
        return STATUS_OK;
    TRY(system_factor_projected(&c->mass, 0, NULL, 1, M, NULL, P, set->touched));
    counters->factorisations++;
    blocks_multiply_mass(graph, M, change, r);
    for (size_t t = 0; t < count; t++)
        r[t] = -r[t];
    contact_set_apply(set, P, r);
    TRY(system_solve(&c->mass, r));
    counters->solves++;
    contact_set_apply(set, P, r);
    for (size_t t = 0; t < count; t++) {
        change[t] += r[t];
        v[t] += change[t];
    }
    blocks_multiply_mass(graph, M, change, r);
    for (size_t t = 0; t < count; t++)
        if (set->touched[t / 3] && set->held->free_index[t] >= 0)
            set->node[t / 3].force[t % 3] += unit * r[t];
out:
    return st;
}

/* Makes b = 2 M v + dt (f - K d), less held unknowns' part; w: their values, else 0. */
static void linear_side(struct newmark *n, const struct system *s, const double (*K)[9],
                        const double *M, const double *load,
                        const struct newmark_held *held, double *b, double *w)
{
    const struct blocks *graph = s->graph;
    size_t count = 3 * (size_t)graph->nodes;
    double *x = n->work + 2 * count, dt = n->dt;

    blocks_multiply_mass(graph, M, n->v, b);
    blocks_multiply(graph, K, n->d, x);
    for (size_t t = 0; t < count; t++) {
        b[t] = 2 * b[t] + dt * (load[t] - x[t]);
        w[t] = 0;
    }
    if (!held)
        return;
    memset(x, 0, count * sizeof *x);
    for (int h = 0; h < s->held->held_count; h++) {
        int t = s->held->held[h];
        x[t] = (1 + n->alpha * dt / 2) * (n->v[t] + held->v[h]);
    }
    blocks_multiply_mass(graph, M, x, w);
    for (size_t t = 0; t < count; t++)
        b[t] -= w[t];
    for (int h = 0; h < s->held->held_count; h++) {
        int t = s->held->held[h];
        x[t] = dt / 2 * (held->d[h] - n->d[t]) + n->beta * dt / 2 * (n->v[t] + held->v[h]);
    }
    blocks_multiply(graph, K, x, w);
    for (size_t t = 0; t < count; t++)
        b[t] -= w[t];
    for (int h = 0; h < s->held->held_count; h++) {
        int t = s->held->held[h];
        w[t] = 2 * (held->d[h] - n->d[t]) / dt;
    }
}

/* Updates d and v by the step's w = v0 + v1. */
static void linear_finish(struct newmark *n, const struct supports *s,
                          const struct newmark_held *held, const double *w)
{
    size_t count = 3 * (size_t)s->nodes;

    for (size_t t = 0; t < count; t++) {
        if (s->free_index[t] < 0)
            continue;
        n->d[t] += n->dt / 2 * w[t];
        n->v[t] = w[t] - n->v[t];
    }
    for (int h = 0; held && h < s->held_count; h++) {
        int t = s->held[h];
        n->d[t] = held->d[h], n->v[t] = held->v[h];
    }
}

enum status contact_step_linear(struct contact_step *c, struct newmark *n, struct system *s,
                                const double (*K)[9], const double *M, const double *load,
                                const struct newmark_held *held, const double *x,
                                struct counters *counters)
{
    enum status st;
    size_t count = 3 * (size_t)s->graph->nodes;
    double *b = n->work, *w = n->work + count;
    const struct contact_problem problem = {
        .k = newmark_k(n), .K = K, .m = newmark_m(n), .M = M, .b = b, .scale = 2 / n->dt};

    contact_set_detect(&c->set, x);
    linear_side(n, s, K, M, load, held, b, w);
    TRY(contact_solve(&c->set, s, &problem, w, counters));
    linear_finish(n, s->held, held, w);
    TRY(contact_step_impact(c, M, n->dt, 1, n->v, n->work, counters));
out:
    return st;
}

/* motion_fixture.h - solids in motion, for tests that concern time: the state within reach,
 * fields, and all natural modes of a small net. */
#ifndef MOTION_FIXTURE_H
#define MOTION_FIXTURE_H

#include <float.h>

#include "models/linalg/eigen.h"
#include "models/metric/metric.h"
#include "models/solid/solid_model.h"
#include "tests/opened_run.h"

static inline struct solid_sheet *run_solid(const struct run *run)
{
    return run->state; /* solid_model.h: a state begins with it */
}

typedef double run_field[GRID_POINTS][3];

static inline void run_sample(const struct run *run, run_field field)
{
    model_sample(run->model, run->state, field[0]);
}

static inline size_t run_unknowns(const struct run *run)
{
    return 3 * (size_t)run_solid(run)->space.nodes;
}

/* All natural modes of a run's rest shape about held supports: lambda = omega^2 ascending,
 * vector[i][unknowns] M-normalised, zero at held unknowns. */
struct modes {
    int count;
    size_t unknowns;
    double *lambda, *vector;
    double *work;
};

static inline void modes_init(struct modes *m, const struct run *run)
{
    const struct solid_sheet *s = run_solid(run);
    const double(*K)[9] = (const double(*)[9])s->assembly.K;
    long *start[2];
    int *row[2], n = s->supports.free_count;
    double *value[2], *packed = malloc((size_t)(n * n) * sizeof *packed);

    *m = (struct modes){.count = n, .unknowns = run_unknowns(run)};
    m->lambda = malloc((size_t)n * sizeof *m->lambda);
    m->vector = calloc((size_t)n * m->unknowns, sizeof *m->vector);
    m->work = malloc(m->unknowns * sizeof *m->work);
    REQUIRE(packed && m->lambda && m->vector && m->work && n <= EIGEN_DENSE_MAX);
    for (int t = 0; t < 2; t++)
        REQUIRE(system_columns(&s->assembly.graph, &s->supports, NULL, !t, K, t,
                               s->assembly.M, &start[t], &row[t], &value[t]) == STATUS_OK);
    const struct eigen_pair pair = {n, start[0], row[0], value[0], value[1]};
    REQUIRE(eigen_lowest(&pair, n, m->lambda, packed, NULL) == STATUS_OK);
    for (int i = 0; i < n; i++)
        for (size_t t = 0; t < m->unknowns; t++)
            if (s->supports.free_index[t] >= 0)
                m->vector[(size_t)i * m->unknowns + t] =
                    packed[i * n + s->supports.free_index[t]];
    for (int t = 0; t < 2; t++) {
        free(start[t]);
        free(row[t]);
        free(value[t]);
    }
    free(packed);
}

static inline void modes_clear(struct modes *m)
{
    free(m->lambda);
    free(m->vector);
    free(m->work);
    memset(m, 0, sizeof *m);
}

/* Modal amplitudes q[count] = vector' M x of x[unknowns]. */
static inline void modes_project(const struct modes *m, const struct run *run,
                                 const double *x, double *q)
{
    const struct solid_assembly *a = &run_solid(run)->assembly;

    blocks_multiply_mass(&a->graph, a->M, x, m->work);
    for (int i = 0; i < m->count; i++) {
        q[i] = 0;
        for (size_t t = 0; t < m->unknowns; t++)
            q[i] += m->vector[(size_t)i * m->unknowns + t] * m->work[t];
    }
}

/* x[unknowns] = sum q[i] vector[i]. */
static inline void modes_combine(const struct modes *m, const double *q, double *x)
{
    memset(x, 0, m->unknowns * sizeof *x);
    for (int i = 0; i < m->count; i++)
        for (size_t t = 0; t < m->unknowns; t++)
            x[t] += q[i] * m->vector[(size_t)i * m->unknowns + t];
}

/* Modal loads vector' f of the scene's constant load f. */
static inline void modes_load(const struct modes *m, const struct run *run, double *p)
{
    for (int i = 0; i < m->count; i++) {
        p[i] = 0;
        for (size_t t = 0; t < m->unknowns; t++)
            p[i] += m->vector[(size_t)i * m->unknowns + t] * run_solid(run)->march.load[t];
    }
}

#endif

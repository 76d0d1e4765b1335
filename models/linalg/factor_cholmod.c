/* CHOLMOD as it comes: it orders, and takes supernodes or single columns as it sees fit. We
 * change two things: L L^T also column by column, since L D L^T would factor what is not
 * positive definite, and one thread. */
#include <assert.h>
#include <cholmod.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/cholmod_status.h"
#include "models/linalg/factor.h"
#include "models/linalg/factor_part.h"

struct state {
    cholmod_common common;
    cholmod_sparse *matrix; /* the lower triangle; its numbers are copied from values     */
    cholmod_factor *factor;
    cholmod_dense *x, *y, *e; /* CHOLMOD's work of a solve, NULL until needed */
};

/* Limits CHOLMOD's loops, which ask for four threads whatever the machine has, to one: no
 * parallel region may open. Returns what threads_restore puts back. */
static int threads_one(void)
{
    int levels = omp_get_max_active_levels();
    if (!omp_in_parallel())
        omp_set_max_active_levels(0);
    return levels;
}

static void threads_restore(int levels)
{
    if (!omp_in_parallel())
        omp_set_max_active_levels(levels);
}

static cholmod_sparse *copy_pattern(const struct factor_pattern *a, cholmod_common *c)
{
    long entries = a->start[a->n];
    cholmod_sparse *m = cholmod_allocate_sparse((size_t)a->n, (size_t)a->n, (size_t)entries,
                                                true, true, -1, CHOLMOD_REAL, c);
    if (!m)
        return NULL;
    for (int j = 0; j <= a->n; j++)
        ((int *)m->p)[j] = (int)a->start[j];
    memcpy(m->i, a->row, (size_t)entries * sizeof *a->row);
    return m;
}

static enum status create(const struct factor_pattern *a, int *position,
                          struct factor_part *part)
{
    struct state *s = part->state = calloc(1, sizeof *s);
    if (!s)
        return STATUS_MEMORY;
    for (int k = 0; k < a->n; k++)
        position[k] = k;
    cholmod_start(&s->common);
    s->common.print = 0;
    s->common.final_ll = true;
    s->matrix = copy_pattern(a, &s->common);
    s->factor = s->matrix ? cholmod_analyze(s->matrix, &s->common) : NULL;
    part->rows = part->n;
    part->slots = a->start[a->n];
    return s->factor ? STATUS_OK : cholmod_status(&s->common);
}

static ptrdiff_t slot(const struct factor_part *part, int i, int j)
{
    const struct state *s = part->state;
    const int *start = s->matrix->p, *row = s->matrix->i;
    int low = start[j], high = start[j + 1];
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (row[middle] <= i)
            low = middle;
        else
            high = middle;
    }
    assert(row[low] == i);
    return low;
}

static enum status refactor(struct factor_part *part, double *value)
{
    struct state *s = part->state;
    memcpy(s->matrix->x, value, (size_t)part->slots * sizeof *value);
    int levels = threads_one();
    bool done = cholmod_factorize(s->matrix, s->factor, &s->common);
    threads_restore(levels);
    if (!done)
        return cholmod_status(&s->common);
    /* The estimate is zero if a pivot failed, or infinity or NaN got into the diagonal. */
    return cholmod_rcond(s->factor, &s->common) > 0.0 ? STATUS_OK : STATUS_INDEFINITE;
}

static enum status solve(struct factor_part *part, const double *value, double *b)
{
    struct state *s = part->state;
    const size_t n = (size_t)part->n;
    cholmod_dense side = {.nrow = n,
                          .ncol = 1,
                          .nzmax = n,
                          .d = n,
                          .x = b,
                          .xtype = CHOLMOD_REAL,
                          .dtype = CHOLMOD_DOUBLE};
    int levels = threads_one();
    bool done = cholmod_solve2(CHOLMOD_A, s->factor, &side, NULL, &s->x, NULL, &s->y, &s->e,
                               &s->common);
    threads_restore(levels);
    (void)value;
    if (!done)
        return cholmod_status(&s->common);
    memcpy(b, s->x->x, n * sizeof *b);
    return STATUS_OK;
}

static void describe(const struct factor_part *part, struct factor_info *info)
{
    const struct state *s = part->state;
    const cholmod_factor *l = s->factor;
    info->entries += (long)(l->is_super ? (double)l->xsize : s->common.lnz);
    info->flops += s->common.fl;
    info->bytes += (long)s->common.memory_inuse;
}

static void destroy(struct factor_part *part)
{
    struct state *s = part->state;
    if (!s)
        return;
    cholmod_free_factor(&s->factor, &s->common);
    cholmod_free_sparse(&s->matrix, &s->common);
    cholmod_free_dense(&s->x, &s->common);
    cholmod_free_dense(&s->y, &s->common);
    cholmod_free_dense(&s->e, &s->common);
    cholmod_finish(&s->common);
    free(s);
    part->state = NULL;
}

const struct factor_method factor_cholmod = {
    "cholmod", create, slot, refactor, solve, NULL, NULL, NULL, NULL, describe, destroy};

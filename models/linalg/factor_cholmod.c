/* Supernodal Cholesky. CHOLMOD orders, analyses and factors; the solve reads its L in
 * place. */
#include <assert.h>
#include <cblas.h>
#include <cholmod.h>
#include <math.h>
#include <omp.h>
#include <stdlib.h>

#include "models/linalg/factor_part.h"

struct sparse {
    cholmod_common common;
    cholmod_sparse *a; /* lower triangle by columns, in positions; its x is not used     */
    cholmod_factor *l; /* natural order: a is permuted already                           */
    double *gather;    /* [l->maxesize]                                                  */
};

static enum status error_of(const cholmod_common *c)
{
    switch (c->status) {
    case CHOLMOD_OK:
        return STATUS_OK;
    case CHOLMOD_NOT_POSDEF:
        return STATUS_INDEFINITE;
    case CHOLMOD_OUT_OF_MEMORY:
    case CHOLMOD_TOO_LARGE:
        return STATUS_MEMORY;
    default:
        return STATUS_LIBRARY;
    }
}

/* The pattern with unknown i moved to position[i], lower triangle, columns sorted; zeros
 * for values where CHOLMOD wants some. */
static cholmod_sparse *permuted_pattern(const struct factor_pattern *a, const int *position,
                                        cholmod_common *c)
{
    long entries = a->start[a->n];
    cholmod_triplet *t =
        cholmod_allocate_triplet(a->n, a->n, entries, -1, CHOLMOD_PATTERN, c);
    cholmod_sparse *lower = NULL;
    if (t) {
        int *i = t->i, *j = t->j;
        long end = 0;
        for (int col = 0; col < a->n; col++)
            for (long s = a->start[col]; s < a->start[col + 1]; s++, end++) {
                int p = position[a->row[s]], q = position[col];
                i[end] = p > q ? p : q;
                j[end] = p > q ? q : p;
            }
        t->nnz = entries;
        lower = cholmod_triplet_to_sparse(t, entries, c);
        if (lower)
            cholmod_sort(lower, c);
    }
    cholmod_free_triplet(&t, c);
    return lower;
}

/* position[n] from the given order, or the better of AMD and METIS; postordered. */
static enum status find_order(const struct factor_pattern *a, int *position,
                              cholmod_common *c)
{
    for (int k = 0; k < a->n; k++)
        position[k] = k;
    cholmod_sparse *lower = permuted_pattern(a, position, c);
    cholmod_factor *l = NULL;
    c->nmethods = a->order ? 1 : 2;
    c->method[0].ordering = a->order ? CHOLMOD_GIVEN : CHOLMOD_AMD;
    c->method[1].ordering = CHOLMOD_METIS;
    c->postorder = 1;
    c->supernodal = CHOLMOD_SUPERNODAL;
    if (lower)
        l = cholmod_analyze_p(lower, (int *)a->order, NULL, 0, c);
    for (int k = 0; l && k < a->n; k++)
        position[((int *)l->Perm)[k]] = k;
    cholmod_free_factor(&l, c);
    cholmod_free_sparse(&lower, c);
    return error_of(c);
}

static enum status create(const struct factor_pattern *a, int *position,
                          struct factor_part *part)
{
    enum status st;
    struct sparse *s = part->state = calloc(1, sizeof *s);
    if (!s)
        return STATUS_MEMORY;
    cholmod_common *c = &s->common;
    cholmod_start(c);
    c->print = 0;
    TRY(find_order(a, position, c));
    if (!(s->a = permuted_pattern(a, position, c))) {
        st = STATUS_MEMORY;
        goto out;
    }
    c->nmethods = 1;
    c->method[0].ordering = CHOLMOD_NATURAL;
    c->postorder = 0;
    s->l = cholmod_analyze(s->a, c);
    TRY(error_of(c));
    s->gather = malloc((s->l->maxesize + 1) * sizeof *s->gather);
    st = s->gather ? STATUS_OK : STATUS_MEMORY;
    part->rows = part->n;
    part->slots = ((int *)s->a->p)[part->n];
out:
    return st;
}

static ptrdiff_t slot(const struct factor_part *part, int i, int j)
{
    const struct sparse *s = part->state;
    const int *start = s->a->p, *row = s->a->i;
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
    struct sparse *s = part->state;
    double sum = 0.0;
    for (ptrdiff_t k = 0; k < part->slots; k++)
        sum += value[k] - value[k]; /* NaN if any is not finite: CHOLMOD would not say so */
    if (sum != 0.0)
        return STATUS_INDEFINITE;
    s->a->x = value; /* lent for the call */
    s->a->xtype = CHOLMOD_REAL;
    /* CHOLMOD 5's OpenMP loops ask for 4 threads whatever the caller set; level 0 refuses.
     */
    int levels = omp_get_max_active_levels();
    omp_set_max_active_levels(0);
    cholmod_factorize(s->a, s->l, &s->common);
    omp_set_max_active_levels(levels);
    s->a->x = NULL;
    s->a->xtype = CHOLMOD_PATTERN;
    if (s->common.status == CHOLMOD_OK && s->l->minor < s->l->n)
        return STATUS_INDEFINITE;
    return error_of(&s->common);
}

static void solve(struct factor_part *part, const double *value, double *b)
{
    struct sparse *s = part->state;
    const cholmod_factor *l = s->l;
    const int *super = l->super, *pi = l->pi, *px = l->px, *rows = l->s;
    double *gather = s->gather;
    (void)value;
    for (size_t k = 0; k < l->nsuper; k++) {
        int cols = super[k + 1] - super[k], lead = pi[k + 1] - pi[k], below = lead - cols;
        const double *block = (double *)l->x + px[k];
        const int *row = rows + pi[k] + cols;
        cblas_dtrsv(CblasColMajor, CblasLower, CblasNoTrans, CblasNonUnit, cols, block,
                    lead, b + super[k], 1);
        cblas_dgemv(CblasColMajor, CblasNoTrans, below, cols, 1.0, block + cols, lead,
                    b + super[k], 1, 0.0, gather, 1);
        for (int i = 0; i < below; i++)
            b[row[i]] -= gather[i];
    }
    for (size_t k = l->nsuper; k-- > 0;) {
        int cols = super[k + 1] - super[k], lead = pi[k + 1] - pi[k], below = lead - cols;
        const double *block = (double *)l->x + px[k];
        const int *row = rows + pi[k] + cols;
        for (int i = 0; i < below; i++)
            gather[i] = b[row[i]];
        cblas_dgemv(CblasColMajor, CblasTrans, below, cols, -1.0, block + cols, lead,
                    gather, 1, 1.0, b + super[k], 1);
        cblas_dtrsv(CblasColMajor, CblasLower, CblasTrans, CblasNonUnit, cols, block, lead,
                    b + super[k], 1);
    }
}

static void describe(const struct factor_part *part, struct factor_info *info)
{
    const struct sparse *s = part->state;
    info->entries += (long)s->l->xsize;
    info->flops += s->common.fl;
    info->bytes += (long)s->common.memory_inuse;
}

static void destroy(struct factor_part *part)
{
    struct sparse *s = part->state;
    if (!s)
        return;
    cholmod_free_factor(&s->l, &s->common);
    cholmod_free_sparse(&s->a, &s->common);
    cholmod_finish(&s->common);
    free(s->gather);
    free(s);
    part->state = NULL;
}

const struct factor_method factor_cholmod = {
    .name = "cholmod",
    .create = create,
    .slot = slot,
    .refactor = refactor,
    .solve = solve,
    .describe = describe,
    .destroy = destroy,
};

/* Cholesky on lower band storage: entry (i,j), i >= j, at value[i - j + j * lead]. */
#include <assert.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>

#include "models/linalg/factor_part.h"

struct banded {
    int half; /* half-bandwidth                                                        */
    int lead; /* numbers stored a column                                               */
};

static int half_bandwidth(const struct factor_pattern *a, const int *position)
{
    int half = 0;
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j]; s < a->start[j + 1]; s++) {
            int width = abs(position[a->row[s]] - position[j]);
            half = width > half ? width : half;
        }
    return half;
}

static enum status create(const struct factor_pattern *a, int *position,
                          struct factor_part *part)
{
    struct banded *band = part->state = malloc(sizeof *band);
    if (!band)
        return STATUS_MEMORY;
    /* The given order, unless it is wider than the natural one. */
    for (int k = 0; k < a->n; k++)
        position[k] = k;
    band->half = half_bandwidth(a, position);
    if (a->order) {
        for (int k = 0; k < a->n; k++)
            position[a->order[k]] = k;
        int given = half_bandwidth(a, position);
        if (given < band->half)
            band->half = given;
        else
            for (int k = 0; k < a->n; k++)
                position[k] = k;
    }
    band->lead = band->half + 1;
    part->slots = (ptrdiff_t)part->n * band->lead;
    return STATUS_OK;
}

static ptrdiff_t slot(const struct factor_part *part, int i, int j)
{
    const struct banded *band = part->state;
    assert(i - j <= band->half);
    return i - j + (ptrdiff_t)j * band->lead;
}

static enum status refactor(struct factor_part *part, double *value)
{
    const struct banded *band = part->state;
    lapack_int info =
        LAPACKE_dpbtrf_work(LAPACK_COL_MAJOR, 'L', part->n, band->half, value, band->lead);
    if (info != 0)
        return STATUS_INDEFINITE;
    for (int j = 0; j < part->n; j++)
        if (!isfinite(value[(ptrdiff_t)j * band->lead]))
            return STATUS_INDEFINITE;
    return STATUS_OK;
}

static void solve(struct factor_part *part, const double *value, double *b)
{
    const struct banded *band = part->state;
    LAPACKE_dpbtrs_work(LAPACK_COL_MAJOR, 'L', part->n, band->half, 1, value, band->lead, b,
                        part->n);
}

static void describe(const struct factor_part *part, struct factor_info *info)
{
    const struct banded *band = part->state;
    double n = part->n, k = band->half;
    info->entries += (long)((n - k) * (k + 1) + k * (k + 1) / 2);
    info->flops += n * (k + 1) * (k + 1);
    info->bytes += (long)sizeof *band;
    info->half_bandwidth =
        band->half > info->half_bandwidth ? band->half : info->half_bandwidth;
}

static void destroy(struct factor_part *part)
{
    free(part->state);
    part->state = NULL;
}

const struct factor_method factor_banded = {
    .name = "banded",
    .create = create,
    .slot = slot,
    .refactor = refactor,
    .solve = solve,
    .describe = describe,
    .destroy = destroy,
};

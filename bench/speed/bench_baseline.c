#include "bench/speed/bench_baseline.h"

#include <cholmod.h>
#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

static int half_bandwidth(const struct bench_matrix *A)
{
    int most = 0;

    for (int j = 0; j < A->n; j++)
        for (long t = A->start[j]; t < A->start[j + 1]; t++)
            if (A->row[t] - j > most)
                most = A->row[t] - j;
    return most;
}

enum status bench_baseline_lapack(const struct bench_matrix *A, int repeats,
                                  struct bench_baseline *b)
{
    int n = A->n, width = half_bandwidth(A), rows = width + 1;
    size_t size = (size_t)n * (size_t)rows;
    double *band = malloc(size * sizeof *band), *x = malloc((size_t)n * sizeof *x);
    double *factor = malloc((size_t)repeats * sizeof *factor);
    double *solve = malloc((size_t)repeats * sizeof *solve);
    enum status st = band && x && factor && solve ? STATUS_OK : STATUS_MEMORY;

    for (int r = -1; r < repeats && st == STATUS_OK; r++) { /* -1: warm-up */
        memset(band, 0, size * sizeof *band);
        for (int j = 0; j < n; j++)
            for (long t = A->start[j]; t < A->start[j + 1]; t++)
                band[(size_t)j * (size_t)rows + (size_t)(A->row[t] - j)] = A->value[t];
        for (int j = 0; j < n; j++)
            x[j] = 1;
        double start = clock_now();
        int info = LAPACKE_dpbtrf_work(LAPACK_COL_MAJOR, 'L', n, width, band, rows);
        double middle = clock_now();
        if (!info)
            info =
                LAPACKE_dpbtrs_work(LAPACK_COL_MAJOR, 'L', n, width, 1, band, rows, x, n);
        double end = clock_now();
        if (info)
            st = STATUS_INDEFINITE;
        if (r >= 0)
            factor[r] = middle - start, solve[r] = end - middle;
    }
    if (st == STATUS_OK)
        *b = (struct bench_baseline){clock_summarise(factor, repeats),
                                     clock_summarise(solve, repeats), (long)size};
    free(band);
    free(x);
    free(factor);
    free(solve);
    return st;
}

static cholmod_sparse *copy_matrix(const struct bench_matrix *A, cholmod_common *common)
{
    cholmod_sparse *copy =
        cholmod_allocate_sparse((size_t)A->n, (size_t)A->n, (size_t)A->start[A->n], true,
                                true, -1, CHOLMOD_REAL, common);

    if (!copy)
        return NULL;
    for (int j = 0; j <= A->n; j++)
        ((int *)copy->p)[j] = (int)A->start[j];
    memcpy(copy->i, A->row, (size_t)A->start[A->n] * sizeof *A->row);
    memcpy(copy->x, A->value, (size_t)A->start[A->n] * sizeof *A->value);
    return copy;
}

enum status bench_baseline_cholmod(const struct bench_matrix *A, int repeats,
                                   struct bench_baseline *b)
{
    cholmod_common common;
    double *factor = malloc((size_t)repeats * sizeof *factor);
    double *solve = malloc((size_t)repeats * sizeof *solve);
    enum status st = factor && solve ? STATUS_OK : STATUS_MEMORY;

    cholmod_start(&common);
    cholmod_sparse *copy = copy_matrix(A, &common);
    cholmod_dense *one = cholmod_ones((size_t)A->n, 1, CHOLMOD_REAL, &common);
    cholmod_factor *L = copy ? cholmod_analyze(copy, &common) : NULL;
    if (!copy || !one || !L)
        st = STATUS_MEMORY;
    for (int r = -1; r < repeats && st == STATUS_OK; r++) {
        double start = clock_now();
        if (!cholmod_factorize(copy, L, &common) || L->minor < L->n)
            st = STATUS_INDEFINITE;
        double middle = clock_now();
        cholmod_dense *x = cholmod_solve(CHOLMOD_A, L, one, &common);
        double end = clock_now();
        cholmod_free_dense(&x, &common);
        if (r >= 0)
            factor[r] = middle - start, solve[r] = end - middle;
    }
    if (st == STATUS_OK)
        *b = (struct bench_baseline){clock_summarise(factor, repeats),
                                     clock_summarise(solve, repeats),
                                     (long)(L->is_super ? L->xsize : L->nzmax)};
    cholmod_free_factor(&L, &common);
    cholmod_free_dense(&one, &common);
    cholmod_free_sparse(&copy, &common);
    cholmod_finish(&common);
    free(factor);
    free(solve);
    return st;
}

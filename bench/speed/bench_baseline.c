#include "bench/speed/bench_baseline.h"

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

enum status bench_baseline_cholmod(const struct bench_matrix *A, int repeats,
                                   struct bench_baseline *b)
{
    enum status st = STATUS_OK;
    struct bench_factor_row row;
    double *one = malloc((size_t)A->n * sizeof *one), *x = malloc((size_t)A->n * sizeof *x);

    if (!one || !x)
        TRY(STATUS_MEMORY);
    for (int i = 0; i < A->n; i++)
        one[i] = 1;
    TRY(bench_factor_matrix(A, SOLVER_CHOLMOD, NULL, repeats, one, x, &row));
    *b = (struct bench_baseline){row.refactor, row.solve, row.entries};
out:
    free(one);
    free(x);
    return st;
}

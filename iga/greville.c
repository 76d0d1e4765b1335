#include "iga/greville.h"

#include <stdlib.h>
#include <string.h>

static double integral(const struct bspline *b, int a)
{
    return (b->U[a + b->p + 1] - b->U[a]) / (b->p + 1);
}

/* Solves A w = w in place; A[n][n] with `band` entries either side of its diagonal, totally
 * positive, so that elimination needs no pivots (de Boor, Pinkus 1977). */
static void solve(int n, int band, double *A, double *w)
{
    for (int k = 0; k < n; k++)
        for (int i = k + 1; i < n && i <= k + band; i++) {
            double factor = A[i * n + k] / A[k * n + k];
            for (int j = k; j < n && j <= k + band; j++)
                A[i * n + j] -= factor * A[k * n + j];
            w[i] -= factor * w[k];
        }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n && j <= k + band; j++)
            w[k] -= A[k * n + j] * w[j];
        w[k] /= A[k * n + k];
    }
}

int greville_rule(const struct bspline *b, bool derivative, double *at, double *weight)
{
    const struct bspline s = {b->p - derivative, b->n - derivative, b->U + derivative};
    size_t n = (size_t)s.n;
    double *A = calloc(n * n, sizeof *A), *N = malloc(n * sizeof *N);
    bool positive = true;

    if (!A || !N) {
        free(A);
        free(N);
        return 0;
    }
    for (int q = 0; q < s.n; q++) {
        at[q] = bspline_greville(&s, q);
        weight[q] = integral(&s, q);
        bspline_values(&s, at[q], N);
        for (int a = 0; a < s.n; a++)
            A[a * s.n + q] = N[a];
    }
    solve(s.n, s.p, A, weight);
    for (int q = 0; q < s.n; q++)
        positive = positive && weight[q] > 0;
    for (int q = 0; q < s.n && !positive; q++)
        weight[q] = integral(&s, q);
    free(A);
    free(N);
    return s.n;
}

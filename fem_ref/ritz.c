#include "fem_ref/ritz.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>

/* Computes the Legendre series of the integral from 0 to x, x = (s + 1) / 2: int P_k ds =
 * (P_{k+1} - P_{k-1}) / (2k + 1), and dx = ds / 2. */
static void integrate(int terms, const double *from, double *to)
{
    for (int k = 0; k < terms; k++)
        to[k] = 0;
    for (int k = 0; k < terms; k++) {
        double c = from[k] / (2 * (2 * k + 1));
        if (c == 0)
            continue;
        assert(k + 1 < terms);
        to[k + 1] += c;
        to[k > 0 ? k - 1 : 0] += k > 0 ? -c : c;
    }
}

static void legendre(int count, double s, double *p)
{
    p[0] = 1;
    p[1] = s;
    for (int k = 1; k + 1 < count; k++)
        p[k + 1] = ((2 * k + 1) * s * p[k] - k * p[k - 1]) / (k + 1);
}

/* Sets phi'' = sqrt(2d + 1) P_d, integrated twice from x = 0. */
static void set_integrated(struct ritz *r, int i, int d)
{
    double *c[3];
    for (int a = 0; a < 3; a++)
        c[a] = r->coefficient[a] + i * r->terms;
    c[2][d] = sqrt(2 * d + 1);
    integrate(r->terms, c[2], c[1]);
    integrate(r->terms, c[1], c[0]);
}

/* Sets the first four free functions: rigid motions, then a quadratic and a cubic
 * orthogonal to them. P_2'' = 12 and P_3'' = 60 s in x; P_2' = 6 s, P_3' = 2 + 10 P_2. */
static void set_low_free(struct ritz *r)
{
    const int n = r->terms;
    double *value = r->coefficient[0], *slope = r->coefficient[1],
           *bend = r->coefficient[2];
    const double two = 12, three = 60 / sqrt(3); /* norms of P_2'' and P_3'' */

    value[0] = 1;
    value[n + 1] = 0.5; /* x - 1/2 */
    slope[n] = 1;
    value[2 * n + 2] = 1 / two;
    slope[2 * n + 1] = 6 / two;
    bend[2 * n] = 1;
    value[3 * n + 3] = 1 / three;
    slope[3 * n] = 2 / three;
    slope[3 * n + 2] = 10 / three;
    bend[3 * n + 1] = sqrt(3);
}

void ritz_clear(struct ritz *r)
{
    for (int a = 0; a < 3; a++)
        free(r->coefficient[a]);
    *r = (struct ritz){0};
}

enum status ritz_init(struct ritz *r, enum ritz_end end, int count)
{
    assert(count >= 4 && count <= RITZ_MAX);
    *r = (struct ritz){.count = count, .terms = count + 3};
    for (int a = 0; a < 3; a++) {
        r->coefficient[a] = calloc((size_t)count * r->terms, sizeof(double));
        if (!r->coefficient[a]) {
            ritz_clear(r);
            return STATUS_MEMORY;
        }
    }
    if (end == RITZ_CLAMPED_FREE) {
        for (int i = 0; i < count; i++)
            set_integrated(r, i, i);
    } else {
        set_low_free(r);
        for (int i = 4; i < count; i++) /* P_{i-2} is orthogonal to 1 and x: ends free */
            set_integrated(r, i, i - 2);
    }
    return STATUS_OK;
}

void ritz_eval(const struct ritz *r, int d, double x, double *out)
{
    double p[RITZ_MAX + 3];

    assert(d >= 0 && d <= 2 && x >= 0 && x <= 1);
    legendre(r->terms, 2 * x - 1, p);
    for (int i = 0; i < r->count; i++) {
        const double *c = r->coefficient[d] + i * r->terms;
        double sum = 0;
        for (int k = 0; k < r->terms; k++)
            sum += c[k] * p[k];
        out[i] = sum;
    }
}

double ritz_product(const struct ritz *r, int a, int i, int b, int j)
{
    const double *c = r->coefficient[a] + i * r->terms;
    const double *d = r->coefficient[b] + j * r->terms;
    double sum = 0;

    for (int k = 0; k < r->terms; k++)
        sum += c[k] * d[k] / (2 * k + 1);
    return sum;
}

double ritz_integral(const struct ritz *r, int i)
{
    return r->coefficient[0][i * r->terms];
}

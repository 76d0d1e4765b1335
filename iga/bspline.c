#include "iga/bspline.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static enum status check_degree(int p, struct message *why)
{
    if (p < 1 || p > BSPLINE_MAX_DEGREE)
        return status_fail(why, STATUS_INPUT, "degree %d is not between 1 and %d", p,
                           BSPLINE_MAX_DEGREE);
    return STATUS_OK;
}

/* Checks knots, rule by rule in the order in which a user would meet them. */
static enum status check_knots(int p, int count, const double *U, struct message *why)
{
    int last = count - 1, multiplicity = 1;

    if (count < 2 * p + 2)
        return status_fail(why, STATUS_INPUT, "degree %d needs at least %d knots, not %d",
                           p, 2 * p + 2, count);
    for (int i = 1; i < count; i++)
        if (!(U[i] >= U[i - 1])) /* so that NaN is caught too */
            return status_fail(why, STATUS_INPUT, "knots must not decrease: %g after %g",
                               U[i], U[i - 1]);
    if (U[0] != 0.0 || U[last] != 1.0)
        return status_fail(why, STATUS_INPUT,
                           "knots must go from 0 to 1, not from %g to %g", U[0], U[last]);
    if (U[p] != 0.0 || U[last - p] != 1.0)
        return status_fail(why, STATUS_INPUT,
                           "knots are not open: degree %d needs %d zeros and %d ones", p,
                           p + 1, p + 1);
    if (U[p + 1] == 0.0 || U[last - p - 1] == 1.0)
        return status_fail(why, STATUS_INPUT, "an end knot is repeated more than %d times",
                           p + 1);
    for (int i = p + 2; i < last - p; i++) {
        multiplicity = U[i] == U[i - 1] ? multiplicity + 1 : 1;
        if (multiplicity > p)
            return status_fail(why, STATUS_INPUT,
                               "inner knot %g is repeated more than %d times", U[i], p);
    }
    return STATUS_OK;
}

enum status bspline_init_uniform(struct bspline *b, int p, int n, struct message *why)
{
    enum status st = check_degree(p, why);
    double *U;

    if (st != STATUS_OK)
        return st;
    if (n <= p)
        return status_fail(why, STATUS_INPUT,
                           "degree %d needs at least %d functions, not %d", p, p + 1, n);
    U = malloc(((size_t)n + p + 1) * sizeof *U);
    if (!U)
        return status_fail(why, STATUS_MEMORY, "no memory for %d knots", n + p + 1);
    for (int i = 0; i <= p; i++)
        U[i] = 0.0, U[n + i] = 1.0;
    for (int i = p + 1; i < n; i++)
        U[i] = (double)(i - p) / (n - p);
    *b = (struct bspline){.p = p, .n = n, .U = U};
    return STATUS_OK;
}

enum status bspline_init_closed(struct bspline *b, int p, int points, struct message *why)
{
    enum status st = check_degree(p, why);
    const int n = points + p;
    double *U;

    if (st != STATUS_OK)
        return st;
    if (points <= p)
        return status_fail(why, STATUS_INPUT,
                           "degree %d around a closed sheet needs at least %d points, not "
                           "%d",
                           p, p + 1, points);
    U = malloc(((size_t)n + p + 1) * sizeof *U);
    if (!U)
        return status_fail(why, STATUS_MEMORY, "no memory for %d knots", n + p + 1);
    for (int i = 0; i <= n + p; i++)
        U[i] = (double)(i - p) / points;
    *b = (struct bspline){.p = p, .n = n, .U = U, .wrap = p};
    return STATUS_OK;
}

int bspline_points(const struct bspline *b)
{
    return b->n - b->wrap;
}

int bspline_point(const struct bspline *b, int i)
{
    return i < b->n - b->wrap ? i : i - (b->n - b->wrap);
}

enum status bspline_init(struct bspline *b, int p, int count, const double *U,
                         struct message *why)
{
    enum status st = check_degree(p, why);
    double *copy;

    if (st == STATUS_OK)
        st = check_knots(p, count, U, why);
    if (st != STATUS_OK)
        return st;
    copy = malloc((size_t)count * sizeof *copy);
    if (!copy)
        return status_fail(why, STATUS_MEMORY, "no memory for %d knots", count);
    memcpy(copy, U, (size_t)count * sizeof *copy);
    *b = (struct bspline){.p = p, .n = count - p - 1, .U = copy};
    return STATUS_OK;
}

enum status bspline_init_direction(struct bspline *b, const struct discretization *d, int i,
                                   struct message *why)
{
    if (!d->knot_count[i])
        return bspline_init_uniform(b, d->degree[i], d->points[i], why);
    if (d->knot_count[i] != d->points[i] + d->degree[i] + 1)
        return status_fail(why, STATUS_INPUT,
                           "knots_%c: %d knots given, but %d points of degree %d need %d",
                           'u' + i, d->knot_count[i], d->points[i], d->degree[i],
                           d->points[i] + d->degree[i] + 1);
    return bspline_init(b, d->degree[i], d->knot_count[i], d->knots[i], why);
}

int bspline_open_degree(const struct discretization *d, int i, int usual)
{
    const int most = d->points[i] - 1,
              told = d->knot_count[i] ? d->knot_count[i] - most - 2 : usual;

    return most < 1 || told < 1 ? 1 : told > most ? most : told;
}

enum status bspline_copy(const struct bspline *from, struct bspline *to)
{
    const size_t bytes = ((size_t)from->n + (size_t)from->p + 1) * sizeof *from->U;
    double *U = malloc(bytes);

    if (!U)
        return STATUS_MEMORY;
    memcpy(U, from->U, bytes);
    *to = *from;
    to->U = U;
    return STATUS_OK;
}

void bspline_clear(struct bspline *b)
{
    if (!b)
        return;
    free(b->U);
    *b = (struct bspline){0};
}

enum status bspline_repeat(struct bspline *b, int parts)
{
    const int knots = b->n + b->p + 1; /* the last p + 1 are the next part's first */
    double *U;

    if (parts < 2)
        return STATUS_OK;
    U = malloc(((size_t)parts * (size_t)b->n + (size_t)b->p + 1) * sizeof *U);
    if (!U)
        return STATUS_MEMORY;
    for (int k = 0; k < parts; k++)
        for (int i = 0; i < knots; i++)
            U[k * b->n + i] = k + b->U[i];
    free(b->U);
    b->U = U, b->n *= parts, b->parts = parts;
    return STATUS_OK;
}

struct bspline bspline_part(const struct bspline *b, int k)
{
    const int n = b->n / (b->parts > 1 ? b->parts : 1);

    return (struct bspline){.p = b->p, .n = n, .U = b->U + k * n};
}

int bspline_alive(const struct bspline *b, int part, double s, int order, double *out)
{
    const struct bspline one = bspline_part(b, part);
    const int span = bspline_span(&one, part + s);

    bspline_eval(&one, span, part + s, order, out);
    return part * one.n + span - one.p;
}

int bspline_span(const struct bspline *b, double u)
{
    int low = b->p, high = b->n;

    /* U[low] <= u < U[high] from here on, or u lies outside and an end span wins. */
    while (high - low > 1) {
        int middle = low + (high - low) / 2;
        if (u >= b->U[middle])
            low = middle;
        else
            high = middle;
    }
    return low;
}

/* Room for a degree more: a spline times a straight line (line_rule.c). */
enum { ROOM = BSPLINE_MAX_ORDER + 1 };

/* Computes row[q][a] = N_{span-q+a} of degree q, for all q <= p (the triangle of A2.2). */
static void triangle(const struct bspline *b, int span, double u, double row[ROOM][ROOM])
{
    row[0][0] = 1.0;
    for (int q = 1; q <= b->p; q++) {
        row[q][0] = 0.0;
        for (int a = 0; a < q; a++) {
            double left = b->U[span + 1 - q + a], right = b->U[span + 1 + a];
            double share = row[q - 1][a] / (right - left);
            row[q][a] += (right - u) * share;
            row[q][a + 1] = (u - left) * share;
        }
    }
}

/* Turns the coefficients c_a on the functions of degree q - 1 alive on `span` into those of
 * the derivative on degree q: N'_{i,q} = q (N_{i,q-1} / (U[i+q] - U[i]) - N_{i+1,q-1} /
 * (U[i+q+1] - U[i+1])). */
static void differentiate(const struct bspline *b, int span, int q, double *c)
{
    double carried = 0.0;

    for (int a = 0; a < q; a++) {
        double share = q * c[a] / (b->U[span + 1 + a] - b->U[span + 1 - q + a]);
        c[a] = carried - share;
        carried = share;
    }
    c[q] = carried;
}

void bspline_eval(const struct bspline *b, int span, double u, int order, double *out)
{
    double row[ROOM][ROOM];
    int p = b->p;

    assert(order >= 0 && order <= p);
    assert(span >= p && span < b->n && b->U[span] < b->U[span + 1]);
    triangle(b, span, u, row);
    for (int d = 0; d <= order; d++) {
        double *derivative = out + d * (p + 1);
        memcpy(derivative, row[p - d], (size_t)(p - d + 1) * sizeof *derivative);
        for (int q = p - d + 1; q <= p; q++)
            differentiate(b, span, q, derivative);
    }
}

void bspline_values(const void *b, double u, double *N)
{
    const struct bspline *s = b;
    int span = bspline_span(s, u);

    memset(N, 0, (size_t)s->n * sizeof *N);
    bspline_eval(s, span, u, 0, N + span - s->p);
}

int bspline_spans(const struct bspline *b, int *span)
{
    int count = 0;

    for (int k = b->p; k < b->n; k++)
        if (b->U[k] < b->U[k + 1])
            span[count++] = k;
    return count;
}

double bspline_greville(const struct bspline *b, int i)
{
    double sum = 0.0;

    assert(i >= 0 && i < b->n);
    for (int k = 1; k <= b->p; k++)
        sum += b->U[i + k];
    return b->wrap ? sum / b->p - floor(sum / b->p) : sum / b->p;
}

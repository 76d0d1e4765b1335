#include "bench/speed/bench_factor.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/order.h"

/* Enough turns for a clock of 30 ns and the noise of a shared machine. */
enum { REPEATS_MAX = 201 };
static const double enough = 0.1; /* [s] a repeated measurement goes on at least         */

static void fill(const struct bench_matrix *a, const ptrdiff_t *slot, struct factor *f)
{
    double *value = factor_values(f);
    factor_clear_values(f);
    for (long s = 0; s < a->start[a->n]; s++)
        value[slot[s]] += a->value[s];
}

static double residual(const struct net_matrix *a, const double *x, const double *b,
                       double *y)
{
    double size = 0.0, worst = 0.0;
    net_matrix_multiply(a, x, y);
    for (int i = 0; i < a->n; i++)
        size = fmax(size, fabs(x[i]));
    for (int i = 0; i < a->n; i++)
        worst = fmax(worst, fabs(b[i] - y[i]) / (a->value[a->start[i]] * size));
    return worst;
}

static enum status time_refactor(const struct bench_matrix *a, const ptrdiff_t *slot,
                                 struct factor *f, int repeats, struct clock_summary *out)
{
    enum status st = STATUS_OK;
    double seconds[REPEATS_MAX], total = 0.0;
    int count = -1; /* the first is a warm-up */
    while (count < repeats || (total < enough && count < REPEATS_MAX)) {
        fill(a, slot, f);
        double begin = clock_now();
        TRY(factor_refactor(f));
        double t = clock_now() - begin;
        if (count >= 0)
            seconds[count] = t, total += t;
        count++;
    }
    *out = clock_summarise(seconds, count);
out:
    return st;
}

static enum status time_solve(struct factor *f, int n, const double *b, double *x,
                              int repeats, struct clock_summary *out)
{
    enum status st = STATUS_OK;
    double seconds[REPEATS_MAX], total = 0.0;
    int count = -1;
    while (count < repeats || (total < enough && count < REPEATS_MAX)) {
        memcpy(x, b, n * sizeof *x);
        double begin = clock_now();
        TRY(factor_solve(f, x));
        double t = clock_now() - begin;
        if (count >= 0)
            seconds[count] = t, total += t;
        count++;
    }
    *out = clock_summarise(seconds, count);
out:
    return st;
}

static enum status make_slots(const struct bench_matrix *a, const struct factor *f,
                              ptrdiff_t **slot)
{
    if (!(*slot = malloc(a->start[a->n] * sizeof **slot)))
        return STATUS_MEMORY;
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j]; s < a->start[j + 1]; s++)
            (*slot)[s] = factor_slot(f, a->row[s], j);
    return STATUS_OK;
}

static void describe(const struct factor *f, struct bench_factor_row *row)
{
    struct factor_info info;
    factor_describe(f, &info);
    row->method = info.method;
    row->parts = info.parts;
    row->half_bandwidth = info.half_bandwidth;
    row->entries = info.entries;
    row->bytes = info.bytes;
    row->flops = info.flops;
}

enum status bench_factor_matrix(const struct bench_matrix *a, enum solver method,
                                const int *order, int repeats, const double *b, double *x,
                                struct bench_factor_row *row)
{
    enum status st = STATUS_OK;
    struct factor *f = NULL;
    ptrdiff_t *slot = NULL;
    struct factor_pattern pattern = {
        .n = a->n, .start = a->start, .row = a->row, .order = order};

    memset(row, 0, sizeof *row);
    row->asked = method;
    row->unknowns = a->n;
    repeats = repeats < REPEATS_MAX ? repeats : REPEATS_MAX;
    double begin = clock_now();
    TRY(factor_create(&pattern, method, &f));
    double seconds = clock_now() - begin;
    row->analyse = clock_summarise(&seconds, 1);
    TRY(make_slots(a, f, &slot));
    TRY(time_refactor(a, slot, f, repeats, &row->refactor));
    TRY(time_solve(f, a->n, b, x, repeats, &row->solve));
    describe(f, row);
out:
    free(slot);
    factor_destroy(f);
    return st;
}

enum status bench_factor_measure(const struct net_shape *shape, enum solver method,
                                 bool nested, int repeats, struct bench_factor_row *row)
{
    enum status st = STATUS_OK;
    struct net_matrix a = {0};
    double *b = NULL;
    int *order = NULL;

    TRY(net_matrix_create(shape, &a));
    b = malloc(3 * a.n * sizeof *b);
    order = malloc(a.n * sizeof *order);
    if (!b || !order)
        TRY(STATUS_MEMORY);
    int rows = shape->points_u - shape->held_edge;
    order_nested(rows, shape->points_v, 6, shape->reach, order);
    for (int i = 0; i < a.n; i++)
        b[i] = 1.0 + i % 7;
    TRY(bench_factor_matrix(&(struct bench_matrix){a.n, a.start, a.row, a.value}, method,
                            nested ? order : NULL, repeats, b, b + a.n, row));
    row->shape = *shape;
    row->residual = residual(&a, b + a.n, b, b + 2 * a.n);
out:
    free(b);
    free(order);
    net_matrix_clear(&a);
    return st;
}

const struct net_shape *bench_factor_shapes(int *count)
{
    /* clang-format off: points_u, points_v, reach, held edge, split */
    static const struct net_shape shapes[] = {
        {5, 5, 2, true, false},     {7, 7, 2, true, false},     {10, 10, 2, true, false},
        {10, 10, 2, true, true},    {14, 14, 2, true, false},   {17, 17, 2, true, false},
        {20, 20, 2, true, false},   {20, 20, 2, true, true},    {24, 24, 2, true, false},
        {32, 32, 2, true, false},   {32, 32, 2, true, true},    {50, 50, 2, true, false},
        {50, 50, 2, true, true},    {100, 100, 2, true, false}, {100, 100, 2, true, true},
        {10, 10, 1, true, false},   {12, 12, 1, true, false},   {16, 16, 1, true, false},
        {20, 20, 1, true, false},   {24, 24, 1, true, false},   {32, 32, 1, true, false},
        {32, 32, 1, true, true},    {40, 40, 1, true, false},   {64, 64, 1, true, false},
        {100, 100, 1, true, false}, {60, 6, 2, true, false},    {100, 10, 1, true, false},
        {14, 14, 4, true, false},   {20, 20, 3, true, false},
    };
    /* clang-format on */
    *count = sizeof shapes / sizeof *shapes;
    return shapes;
}

/* What a factor and a solve cost on matrices of a cloth solid's pattern, method by method:
 * the nets that the rule of SOLVER_AUTO was measured on. Passes whatever the figures.
 *   test_speed_factor [NET...]    a net: a line number of the list, all by default */
#include <math.h>

#include "models/clock.h"
#include "models/linalg/blas_kernel.h"
#include "models/linalg/factor.h"
#include "models/linalg/order.h"
#include "tests/check.h"
#include "tests/net_matrix.h"

/* Enough turns for a clock of 30 ns and the noise of a shared machine. */
enum { REPEATS = 9, REPEATS_MAX = 201 };
static const double enough = 0.1; /* [s] a repeated measurement goes on at least         */

static void fill(const struct net_matrix *a, const ptrdiff_t *slot, struct factor *f)
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

/* Of factorisations, filling the values not counted, or of solves: x = A^-1 b. */
static struct clock_summary repeat(const struct net_matrix *a, const ptrdiff_t *slot,
                                   struct factor *f, const double *b, double *x)
{
    double seconds[REPEATS_MAX], total = 0.0;
    int count = -1; /* the first is a warm-up */
    while (count < REPEATS || (total < enough && count < REPEATS_MAX)) {
        if (b)
            memcpy(x, b, a->n * sizeof *x);
        else
            fill(a, slot, f);
        double begin = clock_now();
        REQUIRE((b ? factor_solve(f, x) : factor_refactor(f)) == STATUS_OK);
        double t = clock_now() - begin;
        if (count >= 0)
            seconds[count] = t, total += t;
        count++;
    }
    return clock_summarise(seconds, count);
}

static void measure(const struct net_shape *shape, enum solver method, bool nested)
{
    struct net_matrix a;
    struct factor *f = NULL;
    struct factor_info info;
    char net[32];

    REQUIRE(net_matrix_create(shape, &a) == STATUS_OK);
    double *b = malloc(3 * a.n * sizeof *b), *x = b + a.n;
    int *order = malloc(a.n * sizeof *order);
    ptrdiff_t *slot = malloc(a.start[a.n] * sizeof *slot);
    REQUIRE(b && order && slot);
    order_nested(shape->points_u - shape->held_edge, shape->points_v, 6, shape->reach,
                 order);
    const struct factor_pattern pattern = {
        .n = a.n, .start = a.start, .row = a.row, .order = nested ? order : NULL};
    double begin = clock_now();
    REQUIRE(factor_create(&pattern, method, &f) == STATUS_OK);
    const double analyse = clock_now() - begin;
    for (int j = 0; j < a.n; j++) {
        b[j] = 1.0 + j % 7;
        for (long s = a.start[j]; s < a.start[j + 1]; s++)
            slot[s] = factor_slot(f, a.row[s], j);
    }
    const struct clock_summary refactor = repeat(&a, slot, f, NULL, NULL),
                               solve = repeat(&a, slot, f, b, x);
    factor_describe(f, &info);
    snprintf(net, sizeof net, "%dx%dx2 p=%d%s", shape->points_u, shape->points_v,
             shape->reach, shape->split ? " split" : "");
    printf("%-19s %6d %-10s %-6s %4d %9ld %8.1f %9.4f %9.4f %8.4f %8.4f %7.1f %.0e\n", net,
           a.n, info.method, nested ? "nested" : "", info.half_bandwidth, info.entries,
           info.flops * 1e-6, refactor.median * 1e3, refactor.min * 1e3, solve.median * 1e3,
           solve.min * 1e3, analyse * 1e3, residual(&a, x, b, x + a.n));
    fflush(stdout);
    free(b);
    free(slot);
    free(order);
    factor_destroy(f);
    net_matrix_clear(&a);
}

static const struct net_shape *list_shapes(int *count)
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

int main(int argc, char **argv)
{
    /* Above this the band is hopeless and takes gigabytes. */
    const int band_columns = 2500;
    int count;
    const struct net_shape *shapes = list_shapes(&count);
    printf("BLAS kernel %s; times in ms: median and least\n", blas_kernel_name());
    printf("net               unknowns method    order  half   entries    Mflop    factor "
           "    least    solve    least analyse residual\n");
    for (int k = 0; k < count; k++) {
        bool wanted = argc < 2;
        for (int a = 1; a < argc; a++)
            wanted = wanted || atoi(argv[a]) == k;
        if (!wanted)
            continue;
        if (shapes[k].points_u * shapes[k].points_v <= band_columns)
            measure(&shapes[k], SOLVER_BANDED, false);
        measure(&shapes[k], SOLVER_SUPERNODAL, false);
        measure(&shapes[k], SOLVER_SUPERNODAL, true);
        measure(&shapes[k], SOLVER_CHOLMOD, false);
    }
    return check_result();
}

/* Both factors on nets of every shape: residuals at round-off, parts found, bits
 * repeated, matrices that are not positive definite refused. */
#include <float.h>

#include "tests/net_matrix.h"
#include "models/linalg/factor.h"
#include "models/linalg/order.h"
#include "models/option.h"
#include "tests/check.h"

/* Cholesky is backward stable: |b - A x| <= c w eps |A| |x| for w numbers a row of L (at
 * most a few hundred here). A is diagonally dominant: |A| |x| <= 2 |a_ii| |x| row by row.
 */
#define TOL_RESIDUAL (512 * DBL_EPSILON)
#define TOL_SINGLE   (512 * FLT_EPSILON)

/* A matrix and its factor, as a test case works on them. */
struct factored {
    struct net_matrix a;
    struct factor *f;
    struct factor_info info;
};

static void open(struct factored *c, const struct net_shape *shape, enum solver method,
                 const int *order)
{
    REQUIRE(net_matrix_create(shape, &c->a) == STATUS_OK);
    const struct factor_pattern pattern = {
        .n = c->a.n, .start = c->a.start, .row = c->a.row, .order = order};
    REQUIRE(factor_create(&pattern, method, &c->f) == STATUS_OK);
    factor_describe(c->f, &c->info);
}

static void close(struct factored *c)
{
    factor_destroy(c->f);
    net_matrix_clear(&c->a);
}

static void fill(const struct factored *c)
{
    const struct net_matrix *a = &c->a;

    factor_clear_values(c->f);
    for (int j = 0; j < a->n; j++)
        for (long s = a->start[j]; s < a->start[j + 1]; s++)
            factor_values(c->f)[factor_slot(c->f, a->row[s], j)] += a->value[s];
}

/* b - A x over a_ii |x|, largest. */
static double residual(const struct net_matrix *a, const double *x, const double *b)
{
    double *y = malloc(a->n * sizeof *y), size = 0.0, worst = 0.0;
    net_matrix_multiply(a, x, y);
    for (int i = 0; i < a->n; i++)
        size = fmax(size, fabs(x[i]));
    for (int i = 0; i < a->n; i++)
        worst = fmax(worst, fabs(b[i] - y[i]) / (a->value[a->start[i]] * size));
    free(y);
    return size > 0.0 ? worst : NAN;
}

static void check_shape(const struct net_shape *shape, enum solver method, const int *order,
                        bool single)
{
    struct factored c;
    open(&c, shape, method, order);
    const int n = c.a.n;
    double *b = malloc(3 * n * sizeof *b), *x = b + n, *again = x + n;

    REQUIRE(b);
    for (int i = 0; i < n; i++)
        b[i] = 1.0 + sin(1.0 + i * i);
    factor_single(c.f, single);
    for (int turn = 0; turn < 2; turn++) { /* the second refactor must not see the first */
        fill(&c);
        factor_values(c.f)[factor_dump(c.f)] += NAN;
        REQUIRE(factor_refactor(c.f) == STATUS_OK);
        memcpy(x, b, n * sizeof *x);
        CHECK(factor_solve(c.f, x) == STATUS_OK);
        CHECK_NEAR(residual(&c.a, x, b), 0.0,
                   method != SOLVER_CHOLMOD && single ? TOL_SINGLE : TOL_RESIDUAL);
        CHECK(turn == 0 || !memcmp(x, again, n * sizeof *x));
        memcpy(again, x, n * sizeof *x);
    }
    factor_single(c.f, false); /* leaves nothing behind */
    fill(&c);
    memcpy(x, b, n * sizeof *x);
    CHECK(factor_refactor(c.f) == STATUS_OK && factor_solve(c.f, x) == STATUS_OK);
    CHECK_NEAR(residual(&c.a, x, b), 0.0, TOL_RESIDUAL);
    CHECK(n < 100 || method == SOLVER_CHOLMOD ||
          single == !!memcmp(x, again, n * sizeof *x));
    factor_describe(c.f, &c.info);
    CHECK(method <= SOLVER_DIRECT || !strcmp(c.info.method, option_solver[method]));
    CHECK(c.info.parts == (shape->split ? 2 : 1));
    CHECK(c.info.entries > n && c.info.flops > 0 && c.info.bytes >= 8 * c.info.entries);
    free(b);
    close(&c);
}

/* Three sides at once, one more by itself: each as good as alone, and none of the others'.
 */
static void check_many(const struct net_shape *shape, enum solver method)
{
    enum { COUNT = 4 };
    struct factored c;
    open(&c, shape, method, NULL);
    const int stride = c.a.n + 3;
    const size_t size = COUNT * stride * sizeof(double);
    double *b = malloc(3 * size), *x = b + COUNT * stride, *again = x + COUNT * stride;

    REQUIRE(b);
    for (int i = 0; i < COUNT * stride; i++)
        b[i] = cos(i + 0.1 * (i % 7));
    for (int turn = 0; turn < 2; turn++) { /* the second refactor must not see the first */
        for (long s = 0; s < c.a.start[c.a.n]; s++)
            c.a.value[s] *= 1 + turn;
        fill(&c);
        REQUIRE(factor_refactor(c.f) == STATUS_OK);
        memcpy(x, b, size);
        CHECK(factor_solve_many(c.f, COUNT, x, stride) == STATUS_OK);
        for (int k = 0; k < COUNT; k++)
            CHECK_NEAR(residual(&c.a, x + k * stride, b + k * stride), 0.0, TOL_RESIDUAL);
        for (int i = c.a.n; i < stride; i++)
            CHECK(x[i] == b[i]); /* nothing behind a side is touched */
        memcpy(again, b, size);
        CHECK(factor_solve_many(c.f, COUNT, again, stride) == STATUS_OK);
        CHECK(!memcmp(x, again, size));
    }
    free(b);
    close(&c);
}

static void check_shapes(void)
{
    static const struct net_shape shapes[] = {
        {.points_u = 2, .points_v = 2, .reach = 1},
        {.points_u = 5, .points_v = 5, .reach = 2, .held_edge = true},
        {.points_u = 5, .points_v = 3, .reach = 4, .split = true},
        {.points_u = 10, .points_v = 10, .reach = 2, .held_edge = true},
        {.points_u = 10, .points_v = 10, .reach = 2, .held_edge = true, .split = true},
        {.points_u = 12, .points_v = 7, .reach = 1},
        {.points_u = 16, .points_v = 16, .reach = 1, .held_edge = true, .split = true},
        {.points_u = 15, .points_v = 14, .reach = 3, .held_edge = true},
    };
    for (size_t k = 0; k < sizeof shapes / sizeof *shapes; k++)
        for (enum solver method = SOLVER_AUTO; method <= SOLVER_CHOLMOD; method++) {
            check_shape(&shapes[k], method, NULL, false);
            check_shape(&shapes[k], method, NULL, true);
            check_many(&shapes[k], method);
        }
}

/* Any permutation will do. */
static void check_order(void)
{
    const struct net_shape shape = {
        .points_u = 9, .points_v = 4, .reach = 2, .split = true};
    int n = 9 * 4 * 6, *order = malloc(n * sizeof *order);
    for (int k = 0; k < n; k++)
        order[k] = (k * 5 + 3) % n; /* 5 and 216 have no common factor */
    check_shape(&shape, SOLVER_BANDED, order, false);
    check_shape(&shape, SOLVER_CHOLMOD, order, false);
    free(order);
}

/* Supernodes hold less than a band of a large net, and SOLVER_AUTO sees that; SOLVER_CG
 * that the band solves faster. */
static void check_choice(const struct net_shape *shape)
{
    struct factored c[4];

    open(&c[0], shape, SOLVER_CHOLMOD, NULL);
    open(&c[1], shape, SOLVER_BANDED, NULL);
    open(&c[2], shape, SOLVER_AUTO, NULL);
    open(&c[3], shape, SOLVER_CG, NULL);
    CHECK(c[0].info.flops < 0.6 * c[1].info.flops && c[0].info.half_bandwidth == 0);
    CHECK(!strcmp(c[2].info.method, "cholmod"));
    CHECK(!strcmp(c[3].info.method, "banded"));
    for (int k = 0; k < 4; k++)
        close(&c[k]);
    check_shape(shape, SOLVER_AUTO, NULL, false);
}

/* The band takes the narrower of the given and the natural order. */
static void check_band_order(void)
{
    const struct net_shape wide = {.points_u = 3, .points_v = 20, .reach = 1};
    struct factored c;
    int *order;

    CHECK(order_wide(20, 3, 6, &order) == STATUS_OK && !order);
    REQUIRE(order_wide(3, 20, 6, &order) == STATUS_OK && order);
    open(&c, &wide, SOLVER_BANDED, order);
    CHECK(c.info.half_bandwidth == (3 + 1) * 6 + 5);
    close(&c);
    free(order);
}

/* CHOLMOD has no supernodes of a narrow net. */
static void check_refusals(enum solver method, bool narrow)
{
    const struct net_shape shape = {narrow ? 30 : 7, narrow ? 2 : 6, narrow ? 1 : 2};
    const double bad[] = {-1e3, 0.0, NAN, INFINITY, -INFINITY};
    struct factored c;

    open(&c, &shape, method, NULL);
    const int where[] = {0, 17, c.a.n - 1};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
        for (size_t w = 0; w < sizeof where / sizeof *where; w++) {
            fill(&c);
            factor_values(c.f)[factor_slot(c.f, where[w], where[w])] = bad[k];
            CHECK(factor_refactor(c.f) == STATUS_INDEFINITE);
        }
    fill(&c); /* off the diagonal */
    factor_values(c.f)[factor_slot(c.f, 15, 3)] = NAN;
    CHECK(factor_refactor(c.f) == STATUS_INDEFINITE);
    fill(&c); /* and sound again */
    CHECK(factor_refactor(c.f) == STATUS_OK);
    close(&c);
}

/* Unknowns that meet nobody are parts of their own. */
static void check_diagonal(enum solver method)
{
    const long start[] = {0, 1, 2, 3};
    const int row[] = {0, 1, 2};
    struct factor_pattern pattern = {.n = 3, .start = start, .row = row};
    struct factor *f = NULL;
    struct factor_info info;
    REQUIRE(factor_create(&pattern, method, &f) == STATUS_OK);
    for (int i = 0; i < 3; i++)
        factor_values(f)[factor_slot(f, i, i)] = 4.0 + i;
    double b[] = {8.0, 15.0, 24.0};
    REQUIRE(factor_refactor(f) == STATUS_OK);
    factor_solve(f, b);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(b[i], 2.0 + i, TOL_RESIDUAL);
    factor_describe(f, &info);
    CHECK(info.parts == 3 && info.entries >= 3);
    factor_destroy(f);
}

int main(void)
{
    check_shapes();
    check_order();
    check_band_order();
    check_choice(&(struct net_shape){.points_u = 32, .points_v = 31, .reach = 1});
    for (enum solver method = SOLVER_BANDED; method <= SOLVER_CHOLMOD; method++) {
        check_refusals(method, false);
        check_refusals(method, true);
        check_diagonal(method);
    }
    factor_destroy(NULL);
    return check_result();
}

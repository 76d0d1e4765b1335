/* Points of remedy=selective: how many, what they integrate, and which
 * motions along a line they do not see. (Plates: `clothbench verify frequencies`.) */
#include <float.h>
#include <lapacke.h>

#include "iga/reduced_rule.h"
#include "models/linalg/gauss.h"
#include "tests/solid_fixture.h"

enum { MOST = 48, EVEN = 1, GRADED, REPEATED };

/* Sums of some dozen products of numbers near 1. */
static const double EXACT = 100 * DBL_EPSILON;
/* A motion of whose square (values, or slopes) the rule sees less than this share goes
 * unseen. The rest see a tenth (of values, at a graded end) and more, but of slopes at
 * degree 4; what no point sees, and a net's borders alone, (pi / spans)^2 and less. */
static const double UNSEEN = 0.02;

struct line {
    int degree, points, knots;
    int values, slopes; /* unseen motions; the constant one, by its slopes, is one       */
};

static void make_basis(const struct line *l, struct bspline *b)
{
    const int p = l->degree, spans = l->points - p;
    double U[MOST + 2 * BSPLINE_MAX_ORDER];

    for (int k = 0; k <= l->points + p; k++) {
        int inner = k <= p ? 0 : k - p > spans ? spans : k - p;
        inner -= l->knots == REPEATED && inner == spans / 2 + 1; /* twice the middle one */
        U[k] = pow((double)inner / spans, l->knots == GRADED ? 2 : 1);
    }
    REQUIRE(bspline_init(b, p, l->points + p + 1, U, NULL) == STATUS_OK);
}

/* K[n][n] += part f f^T, f the values or slopes at x of a span. */
static void add_square(const struct bspline *b, int knot, double x, double part,
                       bool slopes, double *K)
{
    const double size = b->U[knot + 1] - b->U[knot];
    double T[2 * BSPLINE_MAX_ORDER], *f = T + slopes * (b->p + 1);

    bspline_eval(b, knot, b->U[knot] + size * x, 1, T);
    for (int i = 0; i <= b->p; i++)
        for (int j = 0; j <= b->p; j++)
            K[(knot - b->p + i) * b->n + knot - b->p + j] += part * size * f[i] * f[j];
}

/* Motions of which the rule sees less than UNSEEN of what there is. With slopes, a little
 * of the values makes the exact square definite; the constant then has no slope. */
static int unseen(const struct bspline *b, const struct line_rule *rule, bool slopes)
{
    const double little = 1e-9;
    int span[MOST], spans = bspline_spans(b, span), count = 0;
    double seen[MOST * MOST] = {0}, exact[MOST * MOST] = {0}, share[MOST];
    double x[GAUSS_MAX], w[GAUSS_MAX];

    gauss_rule(b->p + 1, x, w);
    for (int e = 0; e < spans; e++) {
        for (int q = 0; q < rule->count[e]; q++) {
            int at = e * LINE_RULE_MOST + q;
            add_square(b, span[e], rule->x[at], rule->part[at], slopes, seen);
        }
        for (int q = 0; q <= b->p; q++) {
            add_square(b, span[e], x[q], w[q], slopes, exact);
            add_square(b, span[e], x[q], slopes ? little * w[q] : 0, false, exact);
        }
    }
    REQUIRE(!LAPACKE_dsygvd(LAPACK_ROW_MAJOR, 1, 'N', 'U', b->n, seen, b->n, exact, b->n,
                            share));
    for (int k = 0; k < b->n; k++)
        count += share[k] < UNSEEN;
    return count;
}

/* The bubble of each span and the hat at each simple knot: all continuous quadratics. */
static void check_exact(const struct bspline *b, const struct line_rule *rule)
{
    int span[MOST], spans = bspline_spans(b, span);
    double left = 0, bubble = 0, hat = 0;

    for (int e = 0; e < spans; e++) {
        double size = b->U[span[e] + 1] - b->U[span[e]], sum[3] = {0};
        bool simple = e && span[e] == span[e - 1] + 1;
        for (int q = 0; q < rule->count[e]; q++) {
            double x = rule->x[e * LINE_RULE_MOST + q],
                   part = rule->part[e * LINE_RULE_MOST + q];
            sum[0] += part * (1 - x), sum[1] += part * x, sum[2] += part * x * (1 - x);
            CHECK(part > 0 && x > 0 && x < 1);
        }
        bubble = fmax(bubble, fabs(6 * sum[2] - 1));
        if (simple)
            hat = fmax(hat, fabs(left + size * (sum[0] - 0.5)) / size);
        else
            hat = fmax(hat, fabs(left) + fabs(sum[0] - 0.5));
        left = size * (sum[1] - 0.5);
    }
    CHECK_NEAR(bubble, 0, EXACT);
    CHECK_NEAR(fmax(hat, fabs(left)), 0, EXACT);
}

static void check_line(const struct line *l)
{
    struct bspline b;
    struct line_rule rule;
    int span[MOST], points = 0, pieces = l->knots == REPEATED ? 2 : 1;

    make_basis(l, &b);
    REQUIRE(reduced_rule_init(&rule, &b, true) == STATUS_OK);
    const int spans = bspline_spans(&b, span);
    const bool mirrored = l->knots == EVEN;
    for (int e = 0; e < spans; e++) {
        points += 2 * rule.count[e];
        CHECK(rule.count[e] <= rule.most);
        for (int q = 0; mirrored && q < rule.count[e]; q++) { /* as seen from u = 1 */
            double near = 1;
            for (int r = 0; r < spans * LINE_RULE_MOST; r++)
                if (r % LINE_RULE_MOST < rule.count[r / LINE_RULE_MOST])
                    near = fmin(near, fabs(r / LINE_RULE_MOST + rule.x[r] + e +
                                           rule.x[e * LINE_RULE_MOST + q] - spans));
            CHECK_NEAR(near, 0, EXACT);
        }
    }
    bool good = CHECK(points == 2 * (b.p % 2 ? b.n : spans + pieces * b.p));
    if (b.p % 2 == 0)
        check_exact(&b, &rule);
    good &= CHECK(unseen(&b, &rule, false) == l->values);
    good &= CHECK(unseen(&b, &rule, true) == l->slopes);
    SAY_UNLESS(good, "degree %d, %d functions, knots %d: %d points, unseen %d, %d", b.p,
               b.n, l->knots, points, unseen(&b, &rule, false), unseen(&b, &rule, true));
    line_rule_clear(&rule);
    bspline_clear(&b);
}

/* Nets with continuous slopes: no value of a function may go unseen across the line along
 * which a sheet bends, nor may a value or (but for the constant) a slope at the points that
 * are one a function. */
static void check_seen(int degree, int spans, int knots)
{
    const struct line l = {degree, degree + spans, knots, 0, 0};
    struct line_rule bending, values, slopes;
    struct bspline b;

    make_basis(&l, &b);
    REQUIRE(line_rule_bending(&bending, &b) == STATUS_OK);
    REQUIRE(line_rule_greville(&values, &b, false) == STATUS_OK);
    REQUIRE(line_rule_greville(&slopes, &b, true) == STATUS_OK);
    SAY_UNLESS(
        CHECK(unseen(&b, &bending, false) == 0) && CHECK(unseen(&b, &values, false) == 0) &&
            CHECK(unseen(&b, &slopes, true) == 1),
        "degree %d on %d spans, knots %d: unseen %d, %d, %d", degree, spans, knots,
        unseen(&b, &bending, false), unseen(&b, &values, false), unseen(&b, &slopes, true));
    line_rule_clear(&bending);
    line_rule_clear(&values);
    line_rule_clear(&slopes);
    bspline_clear(&b);
}

int main(void)
{
    static const struct line lines[] = {
        {2, 3, EVEN, 0, 1},    {2, 4, EVEN, 0, 1},      {2, 5, EVEN, 0, 1},
        {2, 10, EVEN, 0, 1},   {2, 41, EVEN, 0, 1},     {2, 42, EVEN, 0, 1},
        {2, 42, GRADED, 0, 1}, {2, 12, REPEATED, 0, 1}, {2, 41, REPEATED, 0, 1},
        {4, 5, EVEN, 0, 1},    {4, 6, EVEN, 0, 1},      {4, 9, EVEN, 0, 1},
        {4, 10, EVEN, 0, 1},   {4, 43, EVEN, 0, 1},     {4, 44, EVEN, 0, 1},
        {4, 44, GRADED, 0, 1}, {4, 44, REPEATED, 0, 1}, {3, 10, EVEN, 0, 1},
        {3, 43, EVEN, 2, 1},   {5, 44, EVEN, 2, 1},     {3, 9, EVEN, 0, 1},
        {3, 42, EVEN, 2, 1},   {5, 45, EVEN, 2, 1},     {3, 7, EVEN, 0, 1},
    };

    for (size_t k = 0; k < sizeof lines / sizeof *lines; k++)
        check_line(&lines[k]);
    for (int degree = 2; degree <= 5; degree++)
        for (int spans = 1; spans <= 8; spans++)
            check_seen(degree, spans,
                       degree > 2 && spans > 2 && spans % 2 ? REPEATED : EVEN);
    return check_result();
}

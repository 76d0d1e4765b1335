/* Points of line_rule_greville, one a function: what they integrate, on even, graded and
 * waved nets, with knots that repeat up to a break of the slope, at every degree; that
 * weights are positive; and that an even net is seen alike from either end. */
#include <float.h>

#include "iga/line_rule.h"
#include "models/linalg/gauss.h"
#include "tests/check.h"

enum { MOST = 64, EVEN = 0, SQUARE, CUBE, WAVED, REPEATED, BROKEN, NETS };
static const char *const net_name[NETS] = {"even",  "squares",  "cubes",
                                           "waved", "repeated", "broken"};

/* The rule's own bound on what integrals miss, beside round-off of this test's sums. */
static const double EXACT = 2e-13;

static double place(int net, double x)
{
    const double power = net == SQUARE ? 2 : net == CUBE ? 3 : 1;

    return net == WAVED ? x + 0.02 * sin(40 * x) * (1 - x) : pow(x, power);
}

static void make_basis(int p, int spans, int net, struct bspline *b)
{
    const int times = net == BROKEN ? p : net == REPEATED && p > 2 ? p - 1 : 1;
    double U[2 * MOST];
    int n = 0;

    for (int k = 0; k <= p; k++)
        U[n++] = 0;
    for (int k = 1; k < spans; k++)
        for (int t = 0; t < (k == spans / 2 ? times : 1); t++)
            U[n++] = place(net, (double)k / spans);
    for (int k = 0; k <= p; k++)
        U[n++] = 1;
    REQUIRE(bspline_init(b, p, n, U, NULL) == STATUS_OK);
}

/* Integrates (u - middle of the support) or 1 times function a of the space s by the rule
 * on the spans of b, whose functions begin `before` earlier, and by Gauss points. */
static void integrate(const struct bspline *b, const struct bspline *s, int before,
                      const struct line_rule *rule, int a, bool line, double sum[2])
{
    const double middle = (s->U[a] + s->U[a + s->p + 1]) / 2;
    double x[GAUSS_MAX], w[GAUSS_MAX], N[BSPLINE_MAX_ORDER];

    gauss_rule(s->p + 2, x, w);
    sum[0] = sum[1] = 0;
    for (int e = 0; e < rule->spans; e++) {
        const int knot = rule->span[e] - before, local = a - (knot - s->p);
        const double lo = b->U[rule->span[e]], size = line_rule_size(rule, b, e);
        for (int q = 0; q < rule->count[e] + s->p + 2; q++) {
            const int g = q - rule->count[e], at = e * LINE_RULE_MOST + q;
            const double u = lo + size * (g < 0 ? rule->x[at] : x[g]);
            if (local < 0 || local > s->p)
                continue;
            bspline_eval(s, knot, u, 0, N);
            sum[g >= 0] +=
                size * (g < 0 ? rule->part[at] : w[g]) * N[local] * (line ? u - middle : 1);
        }
    }
}

static void check_rule(int p, int spans, int net, bool derivative)
{
    struct line_rule rule;
    struct bspline b;
    double worst = 0, least = INFINITY, last = -1, apart = 0;
    int points = 0;

    make_basis(p, spans, net, &b);
    const struct bspline s = {p - derivative, b.n - derivative, b.U + derivative, 0, 0};
    REQUIRE(line_rule_greville(&rule, &b, derivative) == STATUS_OK);
    for (int a = 0; a < s.n; a++)
        for (int line = 0; line < (s.p > 1 ? 2 : 1); line++) {
            double sum[2];
            integrate(&b, &s, derivative, &rule, a, line, sum);
            worst = fmax(worst, fabs(sum[0] - sum[1]) / (s.U[a + s.p + 1] - s.U[a]));
        }
    for (int e = 0; e < rule.spans; e++)
        for (int q = 0; q < rule.count[e]; q++, points++) {
            const int at = e * LINE_RULE_MOST + q;
            double nearest = 1;
            least = fmin(least, rule.part[at]);
            CHECK(rule.x[at] >= 0 && rule.x[at] <= 1 && e + rule.x[at] >= last);
            last = e + rule.x[at];
            for (int r = 0; r < rule.spans * LINE_RULE_MOST; r++)
                if (r % LINE_RULE_MOST < rule.count[r / LINE_RULE_MOST])
                    nearest = fmin(
                        nearest, fabs(r / LINE_RULE_MOST + rule.x[r] + last - rule.spans));
            apart = fmax(apart, net == EVEN ? nearest : 0);
        }
    SAY_UNLESS(CHECK(points == s.n) && CHECK(least > 0) && CHECK_NEAR(worst, 0, EXACT) &&
                   CHECK_NEAR(apart, 0, 1e3 * DBL_EPSILON),
               "degree %d, %d spans, %s, %s: least weight %g, integrals off by %.1e", p,
               spans, net_name[net], derivative ? "derivatives" : "values", least, worst);
    line_rule_clear(&rule);
    bspline_clear(&b);
}

int main(void)
{
    for (int p = 2; p <= 5; p++)
        for (int net = EVEN; net < NETS; net++)
            for (int spans = net < REPEATED ? 1 : 2; spans <= 20; spans += 1 + spans / 6)
                for (int derivative = 0; derivative < 2; derivative++)
                    check_rule(p, spans, net, derivative);
    return check_result();
}

#include "iga/reduced_rule.h"

#include <math.h>

#include "models/linalg/gauss.h"

static void add(struct line_rule *rule, int span, double x, double part)
{
    int at = span * LINE_RULE_MOST + rule->count[span]++;

    rule->x[at] = x;
    rule->part[at] = part;
}

static void add_gauss(struct line_rule *rule, int span, int count)
{
    double x[GAUSS_MAX], w[GAUSS_MAX];

    gauss_rule(count, x, w);
    for (int q = 0; q < count; q++)
        add(rule, span, x[q], w[q]);
}

/* Adds Radau's two points of a span, one of them on its first knot or its last. */
static void add_radau(struct line_rule *rule, int span, bool first)
{
    add(rule, span, first ? 0 : 1. / 3, first ? 0.25 : 0.75);
    add(rule, span, first ? 2. / 3 : 1, first ? 0.75 : 0.25);
}

/* Puts points at spans' middles: one a span, and one more for every function that the spans
 * between two knots of full multiplicity have beyond their number, dealt out from both ends
 * inwards, so that a clamp at u = 0 and one at u = 1 are alike. An odd last one is in the
 * middle: of an even number of spans on the knot there, half of it in either span, or,
 * where these have more than one point or strains jump, one in each. */
static void middles(const struct bspline *b, struct line_rule *rule, int first, int spans)
{
    const int p = b->p, half = spans / 2, even = p % 2 && spans % 2 == 0;
    int *counts = rule->count + first; /* first how many, then the points themselves */

    for (int e = 0; e < spans; e++)
        counts[e] = 1;
    for (int e = 0; e + 1 < spans; e++) { /* a knot that repeats adds functions */
        const int more = (rule->span[first + e + 1] - rule->span[first + e]) / 2;
        counts[e] += more, counts[e + 1] += more;
    }
    for (int k = 0; k < p - even; k++) {
        int e = k % 2 ? spans - 1 - k / 2 : k == p - 1 ? half : k / 2;
        counts[e < 0 ? 0 : e >= spans ? spans - 1 : e]++;
    }
    const bool shared = even && p > 1 && counts[half - 1] * counts[half] == 1;
    for (int e = 0; e < spans; e++) {
        const bool middle = even && (e == half - 1 || e == half);
        const int count = counts[e] + middle;
        counts[e] = 0;
        if (shared && middle)
            add_radau(rule, first + e, e == half);
        else
            add_gauss(rule, first + e, count > p + 1 ? p + 1 : count);
    }
}

/* Adds two points to an outermost span that complete the integrals of the hats at its
 * knots, hat[] from inside out, and of its bubble; all in lengths of the span. */
static void add_pair(struct line_rule *rule, int span, const double hat[2], bool mirrored)
{
    const double both = hat[0] + hat[1];
    const double a = (1 - sqrt(1 - 2 / (3 * both))) / 2; /* a (1 - a) both = 1/6 */
    const double inner = (both * (1 - a) - hat[1]) / (1 - 2 * a);

    add(rule, span, mirrored ? 1 - a : a, inner);
    add(rule, span, mirrored ? a : 1 - a, both - inner);
}

/* Adds Gauss's rule of continuous piecewise quadratics from a span outwards to the last
 * one. Each point completes the integral, `hat`, of the hat at the inner knot of its span,
 * and that of the span's bubble. */
static void outwards(const struct bspline *b, struct line_rule *rule, int span, int last,
                     bool mirrored, double hat)
{
    const int step = mirrored ? -1 : 1;

    for (; span != last; span += step) {
        const double size = line_rule_size(rule, b, span), a = size / (6 * hat);
        add(rule, span, mirrored ? 1 - a : a, 1 / (6 * a * (1 - a)));
        hat = (size + line_rule_size(rule, b, span + step)) / 2 - size / (6 * (1 - a));
    }
    add_pair(rule, last, (double[]){hat / line_rule_size(rule, b, last), 0.5}, mirrored);
}

/* Adds points to spans between two repeated knots, of even degree p: p more than spans. */
static void alone(const struct bspline *b, struct line_rule *rule, int first, int spans)
{
    const int ends = b->p / 2 - 1, last = first + spans - 1 - ends;
    const int middle = first + spans / 2, odd = spans % 2;

    if (spans < 2 + 2 * ends) {
        middles(b, rule, first, spans);
        return;
    }
    for (int e = 0; e < ends; e++) {
        add_gauss(rule, first + e, 2);
        add_gauss(rule, first + spans - 1 - e, 2);
    }
    for (int side = 0; side < 2; side++) {
        const int from = side ? middle + odd : middle - 1;
        const double size = line_rule_size(rule, b, from) / 2;
        const double centre = line_rule_size(rule, b, middle);
        outwards(b, rule, from, side ? last : first + ends, !side, size + odd * centre / 6);
    }
    if (odd)
        add(rule, middle, 0.5, 2. / 3);
}

static void fill(const struct bspline *b, struct line_rule *rule)
{
    const bool odd = b->p % 2;
    const int smooth = odd && b->p > 1 ? b->p - 1 : 1; /* most repeats in a net */
    int first = 0;

    for (int e = 1; e <= rule->spans; e++)
        if (e == rule->spans || rule->span[e] - rule->span[e - 1] > smooth) {
            (odd ? middles : alone)(b, rule, first, e - first);
            first = e;
        }
}

enum status reduced_rule_init(struct line_rule *rule, const struct bspline *b, bool refined)
{
    enum status st = line_rule_room(rule, b);

    if (st == STATUS_OK) {
        fill(b, rule);
        line_rule_most(rule);
        st = refined ? line_rule_refine(rule, b) : STATUS_OK;
    }
    if (st != STATUS_OK)
        line_rule_clear(rule);
    return st;
}

enum status reduced_rule_derived(struct line_rule *rule, const struct bspline *b)
{
    return b->p == 2 && !b->wrap ? reduced_rule_init(rule, b, true)
                                 : line_rule_greville(rule, b, true);
}

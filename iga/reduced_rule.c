#include "iga/reduced_rule.h"

#include <math.h>
#include <stdlib.h>

#include "models/linalg/gauss.h"

/* The spans of a space, and the rule to be made. */
struct spans {
    int order, count;
    const int *knot;    /* [count] index of the knot where each begins                  */
    const double *size; /* [count]                                                      */
    struct line_rule *rule;
};

static void add(const struct spans *s, int span, double x, double part)
{
    int at = span * LINE_RULE_MOST + s->rule->count[span]++;

    s->rule->x[at] = x;
    s->rule->part[at] = part;
}

static void add_gauss(const struct spans *s, int span, int count)
{
    double x[GAUSS_MAX], w[GAUSS_MAX];

    gauss_rule(count, x, w);
    for (int q = 0; q < count; q++)
        add(s, span, x[q], w[q]);
}

/* Puts points at spans' middles: one a span, and one more for every function that the spans
 * between two knots of full multiplicity have beyond their number, dealt out from both ends
 * inwards; an odd last one in the middle, so that a clamp at u = 0 and one at u = 1 are
 * alike. */
static void middles(const struct spans *s, int first, int spans)
{
    const int p = s->order - 1;
    int *counts = s->rule->count + first; /* first how many, then the points themselves */

    for (int e = 0; e < spans; e++) /* a knot that repeats adds functions */
        counts[e] = e + 1 < spans ? s->knot[first + e + 1] - s->knot[first + e] : 1;
    for (int k = 0; k < p; k++) {
        int e = k % 2 ? spans - 1 - k / 2 : k == p - 1 ? spans / 2 : k / 2;
        counts[e < 0 ? 0 : e >= spans ? spans - 1 : e]++;
    }
    for (int e = 0; e < spans; e++) {
        int count = counts[e] > s->order ? s->order : counts[e];
        counts[e] = 0;
        add_gauss(s, first + e, count);
    }
}

/* Adds two points to an outermost span that complete the integrals of the hats at its
 * knots, hat[] from inside out, and of its bubble; all in lengths of the span. */
static void add_pair(const struct spans *s, int span, const double hat[2], bool mirrored)
{
    const double both = hat[0] + hat[1];
    const double a = (1 - sqrt(1 - 2 / (3 * both))) / 2; /* a (1 - a) both = 1/6 */
    const double inner = (both * (1 - a) - hat[1]) / (1 - 2 * a);

    add(s, span, mirrored ? 1 - a : a, inner);
    add(s, span, mirrored ? a : 1 - a, both - inner);
}

/* Adds Gauss's rule of continuous piecewise quadratics from a span outwards to the last
 * one. Each point completes the integral, `hat`, of the hat at the inner knot of its span,
 * and that of the span's bubble. */
static void outwards(const struct spans *s, int span, int last, bool mirrored, double hat)
{
    const int step = mirrored ? -1 : 1;

    for (; span != last; span += step) {
        const double size = s->size[span], a = size / (6 * hat);
        add(s, span, mirrored ? 1 - a : a, 1 / (6 * a * (1 - a)));
        hat = (size + s->size[span + step]) / 2 - size / (6 * (1 - a));
    }
    add_pair(s, last, (double[]){hat / s->size[last], 0.5}, mirrored);
}

/* Adds points to spans between two repeated knots, of even degree p: p more than spans. */
static void alone(const struct spans *s, int first, int spans)
{
    const int ends = (s->order - 1) / 2 - 1, last = first + spans - 1 - ends;
    const int middle = first + spans / 2, odd = spans % 2;

    if (spans < 2 + 2 * ends) {
        middles(s, first, spans);
        return;
    }
    for (int e = 0; e < ends; e++) {
        add_gauss(s, first + e, 2);
        add_gauss(s, first + spans - 1 - e, 2);
    }
    for (int side = 0; side < 2; side++) {
        const int from = side ? middle + odd : middle - 1;
        const double size = s->size[from] / 2, centre = s->size[middle];
        outwards(s, from, side ? last : first + ends, !side, size + odd * centre / 6);
    }
    if (odd)
        add(s, middle, 0.5, 2. / 3);
}

static void fill(const struct spans *s)
{
    const bool odd = s->order % 2 == 0;
    const int smooth = odd && s->order > 2 ? s->order - 2 : 1; /* most repeats in a net */
    int first = 0;

    for (int e = 1; e <= s->count; e++)
        if (e == s->count || s->knot[e] - s->knot[e - 1] > smooth) {
            (odd ? middles : alone)(s, first, e - first);
            first = e;
        }
}

enum status reduced_rule_init(struct line_rule *rule, const struct bspline *b)
{
    enum status st = line_rule_room(rule, b);
    double *size = malloc((size_t)b->n * sizeof *size);

    if (!size)
        st = STATUS_MEMORY;
    if (st == STATUS_OK) {
        const struct spans s = {b->p + 1, rule->spans, rule->span, size, rule};
        for (int e = 0; e < s.count; e++)
            size[e] = line_rule_size(rule, b, e);
        fill(&s);
        line_rule_most(rule);
    } else
        line_rule_clear(rule);
    free(size);
    return st;
}

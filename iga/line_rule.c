#include "iga/line_rule.h"

#include <stdlib.h>
#include <string.h>

#include "iga/greville.h"

void line_rule_clear(struct line_rule *rule)
{
    free(rule->span);
    free(rule->count);
    free(rule->x);
    free(rule->part);
    memset(rule, 0, sizeof *rule);
}

enum status line_rule_room(struct line_rule *rule, const struct bspline *b)
{
    const size_t n = (size_t)b->n, points = n * LINE_RULE_MOST;

    *rule = (struct line_rule){.span = malloc(n * sizeof *rule->span),
                               .count = calloc(n, sizeof *rule->count),
                               .x = malloc(points * sizeof *rule->x),
                               .part = malloc(points * sizeof *rule->part)};
    if (!rule->span || !rule->count || !rule->x || !rule->part) {
        line_rule_clear(rule);
        return STATUS_MEMORY;
    }
    rule->spans = bspline_spans(b, rule->span);
    return STATUS_OK;
}

double line_rule_size(const struct line_rule *rule, const struct bspline *b, int span)
{
    return b->U[rule->span[span] + 1] - b->U[rule->span[span]];
}

void line_rule_most(struct line_rule *rule)
{
    rule->most = 0;
    for (int e = 0; e < rule->spans; e++)
        rule->most = rule->count[e] > rule->most ? rule->count[e] : rule->most;
}

static void set_gauss(struct line_rule *rule, int span, int count)
{
    rule->count[span] = count;
    gauss_rule(count, rule->x + span * LINE_RULE_MOST, rule->part + span * LINE_RULE_MOST);
}

enum status line_rule_gauss(struct line_rule *rule, const struct bspline *b, int count)
{
    enum status st = line_rule_room(rule, b);

    for (int e = 0; st == STATUS_OK && e < rule->spans; e++)
        set_gauss(rule, e, count);
    if (st == STATUS_OK)
        line_rule_most(rule);
    return st;
}

enum status line_rule_bending(struct line_rule *rule, const struct bspline *b)
{
    enum status st = line_rule_room(rule, b);
    const int usual = b->p > 2 ? b->p - 1 : 2;

    for (int e = 0, end; st == STATUS_OK && e < rule->spans; e = end) {
        for (end = e + 1; end < rule->spans; end++)
            if (rule->span[end] > rule->span[end - 1] + 1)
                break;
        const int spans = end - e, needed = (spans + b->p + spans - 1) / spans;
        for (int k = e; k < end; k++)
            set_gauss(rule, k, needed > usual ? needed : usual);
    }
    if (st == STATUS_OK)
        line_rule_most(rule);
    return st;
}

enum status line_rule_greville(struct line_rule *rule, const struct bspline *b,
                               bool derivative)
{
    enum status st = line_rule_room(rule, b);
    double *at = malloc(2 * (size_t)b->n * sizeof *at), *weight = at ? at + b->n : NULL;
    const int count = at && st == STATUS_OK ? greville_rule(b, derivative, at, weight) : 0;

    for (int q = 0, e = 0; q < count; q++) {
        while (e + 1 < rule->spans && at[q] >= b->U[rule->span[e + 1]])
            e++;
        const double size = line_rule_size(rule, b, e);
        const int to = e * LINE_RULE_MOST + rule->count[e]++;
        rule->x[to] = (at[q] - b->U[rule->span[e]]) / size;
        rule->part[to] = weight[q] / size;
    }
    free(at);
    if (!count) {
        line_rule_clear(rule);
        return STATUS_MEMORY;
    }
    line_rule_most(rule);
    return STATUS_OK;
}

#include "iga/line_rule.h"

#include <stdlib.h>
#include <string.h>

#include "models/room.h"

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

static double integral(const struct bspline *b, int a)
{
    return (b->U[a + b->p + 1] - b->U[a]) / (b->p + 1);
}

/* Solves A w = w in place; A[n][n] with `band` entries either side of its diagonal, totally
 * positive, so that elimination needs no pivots (de Boor, Pinkus 1977). */
static void solve(int n, int band, double *A, double *w)
{
    for (int k = 0; k < n; k++)
        for (int i = k + 1; i < n && i <= k + band; i++) {
            double factor = A[i * n + k] / A[k * n + k];
            for (int j = k; j < n && j <= k + band; j++)
                A[i * n + j] -= factor * A[k * n + j];
            w[i] -= factor * w[k];
        }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < n && j <= k + band; j++)
            w[k] -= A[k * n + j] * w[j];
        w[k] /= A[k * n + k];
    }
}

/* Computes points and weights of line_rule_greville; returns how many, 0: no memory. */
static int greville(const struct bspline *b, bool derivative, double *at, double *weight)
{
    const struct bspline s = {b->p - derivative, b->n - derivative, b->U + derivative, 0};
    size_t n = (size_t)s.n;
    double *A = calloc(n * n, sizeof *A), *N = malloc(n * sizeof *N);
    bool positive = true;

    if (!A || !N) {
        free(A);
        free(N);
        return 0;
    }
    for (int q = 0; q < s.n; q++) {
        at[q] = bspline_greville(&s, q);
        weight[q] = integral(&s, q);
        bspline_values(&s, at[q], N);
        for (int a = 0; a < s.n; a++)
            A[a * s.n + q] = N[a];
    }
    solve(s.n, s.p, A, weight);
    for (int q = 0; q < s.n; q++)
        positive = positive && weight[q] > 0;
    for (int q = 0; q < s.n && !positive; q++)
        weight[q] = integral(&s, q);
    free(A);
    free(N);
    return s.n;
}

/* Takes one point in each span of a closed basis. */
static enum status spread(struct line_rule *rule, const struct bspline *b, bool derivative)
{
    enum status st = line_rule_room(rule, b);

    for (int e = 0; st == STATUS_OK && e < rule->spans; e++) {
        rule->count[e] = 1;
        rule->x[e * LINE_RULE_MOST] = (b->p - derivative) % 2 ? 0 : 0.5;
        rule->part[e * LINE_RULE_MOST] = 1;
    }
    if (st == STATUS_OK)
        line_rule_most(rule);
    return st;
}

enum status line_rule_greville(struct line_rule *rule, const struct bspline *b,
                               bool derivative)
{
    if (b->wrap)
        return spread(rule, b, derivative);
    enum status st = line_rule_room(rule, b);
    double *at = malloc(2 * (size_t)b->n * sizeof *at), *weight = at ? at + b->n : NULL;
    const int parts = b->parts > 1 ? b->parts : 1;
    int count = at && st == STATUS_OK;

    for (int k = 0; k < parts && count; k++) {
        const struct bspline part = bspline_part(b, k);
        const int spans = rule->spans / parts;
        count = greville(&part, derivative, at, weight);
        for (int q = 0, e = k * spans; q < count; q++) {
            while (e + 1 < (k + 1) * spans && at[q] >= b->U[rule->span[e + 1]])
                e++;
            const double size = line_rule_size(rule, b, e);
            const int to = e * LINE_RULE_MOST + rule->count[e]++;
            rule->x[to] = (at[q] - b->U[rule->span[e]]) / size;
            rule->part[to] = weight[q] / size;
        }
    }
    free(at);
    if (!count) {
        line_rule_clear(rule);
        return STATUS_MEMORY;
    }
    line_rule_most(rule);
    return STATUS_OK;
}

/* Fills the numbers of the points of functions span - p to span, ascending; returns which
 * function comes first. */
static int ascend(const struct bspline *b, int span, int *node)
{
    const int order = b->p + 1, first = span - b->p, points = bspline_points(b);
    const int turn = first + order > points ? (points - first) % order : 0;

    for (int a = 0; a < order; a++)
        node[a] = bspline_point(b, first + (a + turn) % order);
    return turn;
}

/* Moves the first `turn` of each row's functions behind the others. */
static void rotate(double *value, int rows, int order, int turn)
{
    double old[BSPLINE_MAX_ORDER];

    for (int r = 0; r < rows && turn; r++, value += order) {
        memcpy(old, value, (size_t)order * sizeof *old);
        for (int a = 0; a < order; a++)
            value[a] = old[(a + turn) % order];
    }
}

enum status line_rule_table(struct line_table *table, const struct bspline *b,
                            enum status st, struct line_rule *rule, int rows,
                            void (*eval)(const struct bspline *b, int span, double u,
                                         int order, double *out))
{
    struct line_table new = {
        .spans = rule->spans, .most = rule->most, .order = b->p + 1, .rows = rows};
    const size_t points = (size_t)(new.spans *new.most), row = (size_t)(rows * new.order);

    if (st == STATUS_OK)
        st = room_cut(&new.room, ROOM(new.node, new.spans *new.order),
                      ROOM(new.points, new.spans), ROOM(new.weight, points),
                      ROOM(new.value, points * row));
    for (int e = 0; st == STATUS_OK && e < new.spans; e++) {
        const double lo = b->U[rule->span[e]], size = line_rule_size(rule, b, e);
        const int turn = ascend(b, rule->span[e], new.node + e *new.order);
        new.points[e] = rule->count[e];
        for (int q = 0; q < new.points[e]; q++) {
            const int from = e * LINE_RULE_MOST + q, to = e * new.most + q;
            eval(b, rule->span[e], lo + size * rule->x[from], rows - 1,
                 new.value + (size_t)to *row);
            rotate(new.value + (size_t)to *row, rows, new.order, turn);
            new.weight[to] = size * rule->part[from];
        }
    }
    line_rule_clear(rule);
    *table = new;
    return st;
}

void line_rule_table_clear(struct line_table *table)
{
    free(table->room);
    memset(table, 0, sizeof *table);
}

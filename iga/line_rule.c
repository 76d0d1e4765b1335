#include "iga/line_rule.h"

#include <math.h>
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

/* Points in the making that integrate a spline space. */
struct points {
    struct bspline s; /* the space; borrows its knots                                  */
    int count;
    double *at, *weight; /* [count]                                            owned   */
    int *span;           /* [count] knot index of the span that each lies in           */
    bool *stays;         /* [count] whether it keeps its place                         */
};

/* Places a point at each Greville abscissa: on either side of a knot where the space has a
 * jump one of them. Those on knots where functions end stay there. */
static void place(struct points *p)
{
    const struct bspline *s = &p->s;

    for (int q = 0; q < s->n; q++) {
        p->stays[q] = s->U[q + 1] == s->U[q + s->p];
        p->at[q] = p->stays[q] ? s->U[q + 1] : bspline_greville(s, q);
        p->span[q] = bspline_span(s, p->at[q]);
        if (p->stays[q] && s->U[q + s->p + 1] == p->at[q])
            while (s->U[p->span[q]] == p->at[q])
                p->span[q]--;
    }
}

/* Computes weights for which every spline of the space is integrated exactly. */
static void weigh(struct points *p, double *A)
{
    const struct bspline *s = &p->s;
    double N[BSPLINE_MAX_ORDER];
    bool positive = true;

    memset(A, 0, (size_t)s->n * (size_t)s->n * sizeof *A);
    for (int q = 0; q < s->n; q++) {
        bspline_eval(s, p->span[q], p->at[q], 0, N);
        for (int a = 0; a <= s->p; a++)
            A[(p->span[q] - s->p + a) * s->n + q] = N[a];
        p->weight[q] = integral(s, q);
    }
    solve(s->n, s->p, A, p->weight);
    for (int q = 0; q < s->n; q++)
        positive = positive && p->weight[q] > 0;
    for (int q = 0; q < s->n && !positive; q++)
        p->weight[q] = integral(s, q);
}

/* Makes the space of products of the splines in s and straight lines: of degree p + 1,
 * every knot once more. V has room for twice the knots. */
static struct bspline times_line(const struct bspline *s, double *V)
{
    int count = 0;

    for (int k = 0; k < s->n + s->p + 1; k++) {
        V[count++] = s->U[k];
        if (k == s->n + s->p || s->U[k + 1] > s->U[k])
            V[count++] = s->U[k];
    }
    return (struct bspline){.p = s->p + 1, .n = count - s->p - 2, .U = V};
}

/* Computes what is missing to the integrals of e, [e->n], and its product with the
 * transposed Jacobian in the points' relative changes (of weights, and of places in
 * weights); returns the largest miss, in parts of an integral. */
static double miss(const struct points *p, const struct bspline *e, double *A, double *F)
{
    double T[2 * (BSPLINE_MAX_ORDER + 1)], worst = 0;
    const double *slope = T + e->p + 1;

    memset(A, 0, (size_t)e->n * (size_t)e->n * sizeof *A);
    for (int a = 0; a < e->n; a++)
        F[a] = integral(e, a);
    for (int q = 0; q < p->count; q++) {
        const double w = p->weight[q], w2 = p->stays[q] ? 0 : w * w;
        const int span = bspline_span(e, p->s.U[p->span[q]]), first = span - e->p;
        bspline_eval(e, span, p->at[q], 1, T);
        for (int a = 0; a <= e->p; a++) {
            F[first + a] -= w * T[a];
            for (int b = 0; b <= e->p; b++)
                A[(first + a) * e->n + first + b] +=
                    w * w * (T[a] * T[b] + w2 * slope[a] * slope[b]);
        }
    }
    for (int a = 0; a < e->n; a++)
        worst = fmax(worst, fabs(F[a]) / integral(e, a));
    return worst;
}

/* Moves the points by A^-1 F times the Jacobian: the least change that meets the integrals,
 * or a part of it. */
static void move(struct points *p, const struct bspline *e, const double *y, double *change)
{
    const double MOST = 0.3; /* of a weight, in one step */
    double T[2 * (BSPLINE_MAX_ORDER + 1)], most = MOST;

    for (int q = 0; q < p->count; q++) {
        const int span = bspline_span(e, p->s.U[p->span[q]]);
        double *c = change + 2 * q;
        bspline_eval(e, span, p->at[q], 1, T);
        c[0] = c[1] = 0;
        for (int a = 0; a <= e->p; a++) {
            c[0] += p->weight[q] * T[a] * y[span - e->p + a];
            c[1] += p->weight[q] * p->weight[q] * T[e->p + 1 + a] * y[span - e->p + a];
        }
        c[1] *= !p->stays[q];
        most = fmax(most, fmax(fabs(c[0]), fabs(c[1])));
    }
    for (int q = 0; q < p->count; q++) {
        p->at[q] += MOST / most * change[2 * q + 1] * p->weight[q];
        p->weight[q] *= 1 + MOST / most * change[2 * q];
        if (!p->stays[q])
            p->span[q] = bspline_span(&p->s, p->at[q]);
    }
}

/* Moves points and weights until they integrate products with straight lines, too: Newton's
 * method, by least changes. Returns whether they do, are positive, and, where they are one
 * a function, unisolvent for the space (Schoenberg, Whitney 1953). */
static bool refine(struct points *p, double *room)
{
    enum { TRIES = 40 };
    const double EXACT = 1e-13; /* the last step but one leaves 1e-7, round-off 1e-14 */
    const struct bspline *s = &p->s, e = times_line(s, room);
    double *F = room + 2 * (s->n + s->p + 1), *change = F + e.n, *A = change + 2 * p->count;
    bool good = false;

    for (int n = 0; n < TRIES && !(good = miss(p, &e, A, F) < EXACT); n++) {
        solve(e.n, e.p, A, F);
        move(p, &e, F, change);
    }
    for (int q = 0; q < p->count; q++)
        good = good && p->weight[q] > 0 && p->at[q] >= s->U[s->p] &&
               p->at[q] <= s->U[s->n] &&
               (p->stays[q] || p->count != s->n ||
                (p->at[q] > s->U[q] && p->at[q] < s->U[q + s->p + 1])) &&
               (!q || p->at[q] > p->at[q - 1] || p->span[q] > p->span[q - 1]);
    return good;
}

static void points_clear(struct points *p)
{
    free(p->at);
    free(p->span);
    free(p->stays);
}

/* Allocates `count` points of the splines in b or their derivatives, and *room for `weigh`
 * and `refine`. STATUS_MEMORY leaves nothing. */
static enum status points_room(struct points *p, const struct bspline *b, bool derivative,
                               int count, double **room)
{
    const size_t n = (size_t)b->n, all = (size_t)count;

    *p = (struct points){.s = {b->p - derivative, b->n - derivative, b->U + derivative, 0},
                         .count = count,
                         .at = malloc(2 * all * sizeof *p->at),
                         .span = malloc(all * sizeof *p->span),
                         .stays = calloc(all, sizeof *p->stays)};
    *room = malloc((4 * n * n + 6 * (n + (size_t)b->p + 1) + 2 * all) * sizeof **room);
    if (*room && p->at && p->span && p->stays) {
        p->weight = p->at + count;
        return STATUS_OK;
    }
    points_clear(p);
    free(*room);
    return STATUS_MEMORY;
}

/* Puts the points in place of those of part k of a rule. */
static void give(const struct points *p, const struct bspline *b, int k,
                 struct line_rule *rule)
{
    const int parts = b->parts > 1 ? b->parts : 1, each = rule->spans / parts,
              before = (int)(p->s.U - b->U);
    int e = k * each;

    memset(rule->count + e, 0, (size_t)each * sizeof *rule->count);
    for (int q = 0; q < p->count; q++) {
        while (rule->span[e] - before < p->span[q])
            e++;
        const double size = line_rule_size(rule, b, e);
        const int to = e * LINE_RULE_MOST + rule->count[e]++;
        rule->x[to] = (p->at[q] - b->U[rule->span[e]]) / size;
        rule->part[to] = p->weight[q] / size;
    }
}

static enum status greville(struct line_rule *rule, const struct bspline *b, int k,
                            bool derivative)
{
    const struct bspline part = bspline_part(b, k);
    struct points p;
    double *room;
    const enum status st = points_room(&p, &part, derivative, part.n - derivative, &room);

    if (st != STATUS_OK)
        return st;
    place(&p);
    weigh(&p, room);
    if (p.s.p > 1 && !refine(&p, room)) {
        place(&p);
        weigh(&p, room);
    }
    give(&p, b, k, rule);
    points_clear(&p);
    free(room);
    return STATUS_OK;
}

/* Takes part k's points from the rule, those on a knot between two spans once. */
static void take(const struct line_rule *rule, const struct bspline *b, int k,
                 struct points *p)
{
    const int parts = b->parts > 1 ? b->parts : 1, each = rule->spans / parts,
              before = (int)(p->s.U - b->U);
    bool shared = false;

    p->count = 0;
    for (int e = k * each; e < (k + 1) * each; e++) {
        const double lo = b->U[rule->span[e]], size = line_rule_size(rule, b, e);
        for (int q = 0; q < rule->count[e]; q++) {
            const int from = e * LINE_RULE_MOST + q, n = p->count;
            const double at = rule->x[from], w = size * rule->part[from];
            if (shared && at == 0) {
                p->weight[n - 1] += w;
                continue;
            }
            p->at[n] = lo + size * at, p->weight[n] = w;
            p->span[n] = rule->span[e] - before;
            p->count++;
            shared = at == 1;
        }
    }
}

enum status line_rule_refine(struct line_rule *rule, const struct bspline *b)
{
    const int parts = b->parts > 1 ? b->parts : 1;

    for (int k = 0; k < parts && !b->wrap && b->p > 2; k++) {
        const struct bspline part = bspline_part(b, k);
        struct points p;
        double *room;
        const enum status st =
            points_room(&p, &part, true, rule->spans * rule->most, &room);
        if (st != STATUS_OK)
            return st;
        take(rule, b, k, &p);
        if (refine(&p, room))
            give(&p, b, k, rule);
        points_clear(&p);
        free(room);
    }
    line_rule_most(rule);
    return STATUS_OK;
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

    for (int k = 0; k < (b->parts > 1 ? b->parts : 1) && st == STATUS_OK; k++)
        st = greville(rule, b, k, derivative);
    if (st == STATUS_OK)
        line_rule_most(rule);
    else
        line_rule_clear(rule);
    return st;
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

#include "shell_ref/shell_space.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/linalg/blocks.h"
#include "models/linalg/gauss.h"
#include "models/room.h"

/* Which derivative of the u and of the v function makes each row of a table. */
static const int derivative_u[SHELL_DERIVATIVES] = {0, 1, 0, 2, 0, 1};
static const int derivative_v[SHELL_DERIVATIVES] = {0, 0, 1, 0, 2, 1};

void shell_space_clear(struct shell_space *space)
{
    for (int d = 0; d < 2; d++) {
        bspline_clear(&space->basis[d]);
        free(space->direction[d].span);
        for (int r = 0; r < SHELL_RULES; r++) {
            struct shell_line *line = &space->rule[r].line[d];
            free(line->points);
            free(line->weight);
            free(line->table);
        }
    }
    free(space->room);
    free(space->slab);
    memset(space, 0, sizeof *space);
}

static enum status check(const struct bspline basis[2], const int gauss[2],
                         struct message *why)
{
    for (int d = 0; d < 2; d++) {
        const struct bspline *b = &basis[d];
        if (b->p < 2)
            return status_fail(why, STATUS_INPUT,
                               "degree %d: a Kirchhoff-Love shell needs degree 2 or more",
                               b->p);
        for (int i = b->p + 1; i + b->p <= b->n; i++)
            if (b->U[i] == b->U[i + b->p - 1])
                return status_fail(why, STATUS_INPUT,
                                   "inner knot %g is repeated %d times: a Kirchhoff-Love "
                                   "shell needs continuous slopes",
                                   b->U[i], b->p);
        if (gauss[d] < 0 || gauss[d] > SHELL_MAX_GAUSS)
            return status_fail(why, STATUS_INPUT, "gauss: 0 to %d points, not %d",
                               SHELL_MAX_GAUSS, gauss[d]);
    }
    return STATUS_OK;
}

/* `points` a span, or as many as functions where that is 0. */
static enum status place_points(const struct bspline *b, const struct shell_direction *d,
                                int points, struct shell_line *line)
{
    line->points = points ? malloc((size_t)d->spans * sizeof *line->points)
                          : bspline_reduced_points(b);
    if (!line->points)
        return STATUS_MEMORY;
    for (int s = 0; s < d->spans; s++) {
        if (points)
            line->points[s] = points;
        if (line->points[s] > line->most)
            line->most = line->points[s];
    }
    return STATUS_OK;
}

static enum status tabulate(const struct bspline *b, const struct shell_direction *d,
                            int points, struct shell_line *line)
{
    double x[SHELL_MAX_GAUSS], w[SHELL_MAX_GAUSS];
    size_t row = 3 * (size_t)d->order;
    enum status st = place_points(b, d, points, line);

    if (st != STATUS_OK)
        return st;
    line->weight = calloc((size_t)(d->spans * line->most), sizeof *line->weight);
    line->table = calloc((size_t)(d->spans * line->most) * row, sizeof *line->table);
    if (!line->weight || !line->table)
        return STATUS_MEMORY;
    for (int s = 0; s < d->spans; s++) {
        double from = b->U[d->span[s]], step = b->U[d->span[s] + 1] - from;
        gauss_rule(line->points[s], x, w);
        for (int q = 0; q < line->points[s]; q++) {
            size_t at = (size_t)(s * line->most + q);
            line->weight[at] = step * w[q];
            bspline_eval(b, d->span[s], from + step * x[q], 2, line->table + at * row);
        }
    }
    return STATUS_OK;
}

static enum status make_rules(struct shell_space *space, const int gauss[2], bool selective)
{
    for (int r = 0; r < SHELL_RULES; r++) {
        struct shell_rule *rule = &space->rule[r];
        for (int d = 0; d < 2; d++) {
            const int p = space->basis[d].p, full = gauss[d] ? gauss[d] : p + 1,
                      own[SHELL_RULES] = {0, p - 1, full};
            enum status st = tabulate(&space->basis[d], &space->direction[d],
                                      selective ? own[r] : full, &rule->line[d]);
            if (st != STATUS_OK)
                return st;
        }
        rule->padded = SHELL_PADDED(rule->line[0].most * rule->line[1].most);
    }
    return STATUS_OK;
}

static enum status make_directions(struct shell_space *space)
{
    for (int d = 0; d < 2; d++) {
        struct shell_direction *dir = &space->direction[d];
        const struct bspline *b = &space->basis[d];
        dir->order = b->p + 1;
        dir->span = malloc((size_t)b->n * sizeof *dir->span);
        if (!dir->span)
            return STATUS_MEMORY;
        dir->spans = bspline_spans(b, dir->span);
    }
    return STATUS_OK;
}

static void number_elements(struct shell_space *space)
{
    const struct shell_direction *u = &space->direction[0], *v = &space->direction[1];
    int m = space->basis[1].n;

    for (int e = 0; e < space->elements; e++) {
        int ku = u->span[e / v->spans], kv = v->span[e % v->spans];
        int *node = space->ien + (size_t)e * (size_t)space->local;
        for (int a = 0; a < space->local; a++)
            node[a] =
                (ku - u->order + 1 + a / v->order) * m + kv - v->order + 1 + a % v->order;
    }
}

enum status shell_space_init(struct shell_space *space, const struct bspline basis[2],
                             const double *point, const double *weight, const int gauss[2],
                             bool selective, struct message *why)
{
    enum status st;
    struct shell_space new = {0};

    TRY(check(basis, gauss, why));
    for (int d = 0; d < 2; d++)
        TRY(bspline_copy(&basis[d], &new.basis[d]));
    new.nodes = basis[0].n *basis[1].n;
    new.local = (basis[0].p + 1) * (basis[1].p + 1);
    TRY(make_directions(&new));
    TRY(make_rules(&new, gauss, selective));
    new.elements = new.direction[0].spans *new.direction[1].spans;
    TRY(room_cut(&new.room, ROOM(new.ien, new.elements *(size_t) new.local),
                 ROOM(new.rest, 3 * (size_t) new.nodes),
                 ROOM(new.weight, weight ? new.nodes : 0)));
    memcpy(new.rest, point, 3 * (size_t) new.nodes * sizeof *point);
    if (weight)
        memcpy(new.weight, weight, (size_t) new.nodes * sizeof *weight);
    number_elements(&new);
    TRY(blocks_slabs(new.elements, new.direction[1].spans, new.direction[0].order,
                     &new.slabs, &new.slab));
    HAND_OVER(space, new);
out:
    shell_space_clear(&new);
    return st;
}

/* Turns B-spline functions into rational ones, R = w N / W, W = sum w N, by the quotient
 * rule; T[derivatives][local][row], the first `count` columns. */
static void make_rational(const struct shell_space *space, const int *node, int derivatives,
                          int row, int count, double *T)
{
    size_t stride = (size_t)space->local * (size_t)row;

    for (int q = 0; q < count; q++) {
        double W[SHELL_DERIVATIVES] = {0};
        for (int a = 0; a < space->local; a++)
            for (int k = 0; k < derivatives; k++) {
                double *t = T + (size_t)k * stride + (size_t)(a * row + q);
                *t *= space->weight[node[a]];
                W[k] += *t;
            }
        for (int a = 0; a < space->local; a++) {
            double *t = T + a * row + q;
            double R = t[0] / W[0];
            double u = (t[stride] - R * W[1]) / W[0];
            double v = (t[2 * stride] - R * W[2]) / W[0];
            t[0] = R, t[stride] = u, t[2 * stride] = v;
            if (derivatives == SHELL_SLOPES)
                continue;
            t[3 * stride] = (t[3 * stride] - 2 * u * W[1] - R * W[3]) / W[0];
            t[4 * stride] = (t[4 * stride] - 2 * v * W[2] - R * W[4]) / W[0];
            t[5 * stride] = (t[5 * stride] - u * W[2] - v * W[1] - R * W[5]) / W[0];
        }
    }
}

/* The points of direction d in an element's span. */
static int points_of(const struct shell_space *space, int rule, int element, int d)
{
    int spans = space->direction[1].spans;

    return space->rule[rule].line[d].points[d ? element % spans : element / spans];
}

int shell_space_points(const struct shell_space *space, int rule, int element)
{
    return points_of(space, rule, element, 0) * points_of(space, rule, element, 1);
}

void shell_space_weights(const struct shell_space *space, int rule, int element,
                         double *weight)
{
    const struct shell_line *u = &space->rule[rule].line[0], *v = u + 1;
    int spans = space->direction[1].spans, along = points_of(space, rule, element, 1);
    const double *wu = u->weight + element / spans * u->most,
                 *wv = v->weight + element % spans * v->most;

    for (int q = 0; q < shell_space_points(space, rule, element); q++)
        weight[q] = wu[q / along] * wv[q % along];
}

/* Values and derivatives of one direction, [3 order], at each of an element's points:
 * F[3 order][padded]. */
static void spread(const struct shell_space *space, int rule, int element, int d, double *F)
{
    const struct shell_line *line = &space->rule[rule].line[d];
    int spans = space->direction[1].spans, padded = space->rule[rule].padded;
    int rows = 3 * space->direction[d].order, along = points_of(space, rule, element, 1);
    int first = (d ? element % spans : element / spans) * line->most;

    memset(F, 0, (size_t)(rows * padded) * sizeof *F);
    for (int q = 0; q < shell_space_points(space, rule, element); q++) {
        const double *from = line->table + (first + (d ? q % along : q / along)) * rows;
        for (int t = 0; t < rows; t++)
            F[t * padded + q] = from[t];
    }
}

void shell_space_functions(const struct shell_space *space, int rule, int element,
                           double *T)
{
    enum { ROOM = 3 * BSPLINE_MAX_ORDER * SHELL_MAX_POINTS };
    const int derivatives = rule == SHELL_BENDING ? SHELL_DERIVATIVES : SHELL_SLOPES;
    const int *order = (const int[]){space->direction[0].order, space->direction[1].order};
    int row = space->rule[rule].padded;
    double U[ROOM], V[ROOM], *t = T;

    spread(space, rule, element, 0, U);
    spread(space, rule, element, 1, V);
    for (int k = 0; k < derivatives; k++)
        for (int i = 0; i < order[0]; i++)
            for (int j = 0; j < order[1]; j++, t += row) {
                const double *f = U + (derivative_u[k] * order[0] + i) * row;
                const double *g = V + (derivative_v[k] * order[1] + j) * row;
                for (int q = 0; q < row; q++)
                    t[q] = f[q] * g[q];
            }
    if (space->weight)
        make_rational(space, space->ien + (size_t)element * (size_t)space->local,
                      derivatives, row, shell_space_points(space, rule, element), T);
}

void shell_space_at(const struct shell_space *space, double u, double v, int *node,
                    double *T)
{
    const double at[2] = {u, v};
    double N[2][3 * BSPLINE_MAX_ORDER];
    int first[2], order[2], a = 0;

    for (int d = 0; d < 2; d++) {
        const struct bspline *b = &space->basis[d];
        int span = bspline_span(b, at[d]);
        bspline_eval(b, span, at[d], 2, N[d]);
        first[d] = span - b->p;
        order[d] = b->p + 1;
    }
    for (int i = 0; i < order[0]; i++)
        for (int j = 0; j < order[1]; j++, a++) {
            node[a] = (first[0] + i) * space->basis[1].n + first[1] + j;
            for (int k = 0; k < SHELL_DERIVATIVES; k++)
                T[k * space->local + a] = N[0][derivative_u[k] * order[0] + i] *
                                          N[1][derivative_v[k] * order[1] + j];
        }
    if (space->weight)
        make_rational(space, node, SHELL_DERIVATIVES, 1, 1, T);
}

#include "shell_ref/shell_space.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "iga/reduced_rule.h"
#include "models/linalg/blocks.h"
#include "models/room.h"

/* The derivatives of the u and of the v function that make each row of a table. */
static const int derivative_u[SHELL_DERIVATIVES] = {0, 1, 0, 2, 0, 1};
static const int derivative_v[SHELL_DERIVATIVES] = {0, 0, 1, 0, 2, 1};

void shell_space_clear(struct shell_space *space)
{
    for (int d = 0; d < 2; d++) {
        bspline_clear(&space->basis[d]);
        for (int l = 0; l < SHELL_LINES; l++)
            line_rule_table_clear(&space->direction[d].line[l]);
    }
    free(space->room);
    free(space->slab);
    memset(space, 0, sizeof *space);
}

static enum status check(const struct bspline basis[2], const int gauss[2],
                         struct message *why)
{
    for (int d = 0; d < 2; d++) {
        const struct bspline part = bspline_part(&basis[d], 0), *b = &part;
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

static enum status make_line(const struct bspline *b, struct line_table *line, int l,
                             int gauss)
{
    struct line_rule rule;
    enum status st = l == SHELL_FULL   ? line_rule_gauss(&rule, b, gauss ? gauss : b->p + 1)
                     : l == SHELL_BENT ? line_rule_bending(&rule, b)
                                       : reduced_rule_derived(&rule, b);

    return line_rule_table(line, b, st, &rule, 3, bspline_eval);
}

/* Computes the factors by which the strains at the p + 1 Gauss points of a span have as
 * their sum, by the q-th Legendre polynomial, so much of the root mean square of a zigzag
 * from span to span that has the same q-th derivative d: d (span / pi)^q sqrt(8) / pi. q is
 * p, but 3 of degree 5: a zigzag is so nearly a sine that its part of degree 5 has a ten
 * thousandth of its energy; taken for the zigzag, it made what is beside a clamp 17,000
 * times as stiff (degree 3: 17), and a strip that is pulled wrinkled. */
static void make_unseen(int order, double *factor)
{
    /* Between a tenth, which leaves motions in the plane too soft (the test cure_states),
     * and the whole, by which beside a clamp, where strains change within a span, a strip
     * that is pulled by 1 % wrinkles at nu = .45. */
    const double PI = 3.14159265358979323846, PART = 0.2;
    const int q = order - 1 < 5 ? order - 1 : 3;
    double x[GAUSS_MAX], scale = sqrt(8 * PART) / PI * (2 * q + 1);

    gauss_rule(order, x, factor);
    for (int k = 1; k <= q; k++)
        scale *= (q + k) / PI;
    for (int n = 0; n < order; n++) {
        double before = 1, here = 2 * x[n] - 1;
        for (int k = 1; k < q; k++) {
            const double next =
                ((2 * k + 1) * (2 * x[n] - 1) * here - k * before) / (k + 1);
            before = here, here = next;
        }
        factor[n] *= scale * here;
    }
}

static enum status make_directions(struct shell_space *space, const int gauss[2],
                                   bool selective)
{
    for (int i = 0; i < 2; i++) {
        struct shell_direction *d = &space->direction[i];
        const struct bspline *b = &space->basis[i];
        for (int l = 0; l < (selective ? SHELL_LINES : SHELL_FULL + 1); l++) {
            enum status st = make_line(b, &d->line[l], l, gauss[i]);
            if (st != STATUS_OK)
                return st;
        }
        d->order = d->line[SHELL_FULL].order, d->spans = d->line[SHELL_FULL].spans;
        make_unseen(d->order, d->unseen);
    }
    return STATUS_OK;
}

static void make_rules(struct shell_space *space, bool selective)
{
    static const struct shell_rule full = {1, {{{SHELL_FULL, SHELL_FULL}, SHELL_ALL}}, 0},
                                   bending = {1,
                                              {{{SHELL_BENT, SHELL_BENT}, SHELL_ALL}},
                                              0},
                                   membrane = {
                                       3,
                                       {{{SHELL_DERIVED, SHELL_DERIVED}, SHELL_ALL},
                                        {{SHELL_DERIVED, SHELL_FULL}, SHELL_UNSEEN_U},
                                        {{SHELL_FULL, SHELL_DERIVED}, SHELL_UNSEEN_V}},
                                       0};

    space->rule[SHELL_MEMBRANE] = selective ? membrane : full;
    space->rule[SHELL_BENDING] = selective ? bending : full;
    space->rule[SHELL_MASS] = full;
    space->alike = !selective;
    for (int r = 0; r < SHELL_RULES; r++) {
        struct shell_rule *rule = &space->rule[r];
        int most = 0;
        for (int g = 0; g < rule->grids; g++) {
            const int *line = rule->grid[g].line;
            most += space->direction[0].line[line[0]].most *
                    space->direction[1].line[line[1]].most;
        }
        rule->padded = SHELL_PADDED(most);
    }
}

static void number_elements(struct shell_space *space)
{
    const struct shell_direction *u = &space->direction[0], *v = &space->direction[1];
    int m = bspline_points(&space->basis[1]);

    for (int e = 0; e < space->elements; e++) {
        const int *at_u = u->line[SHELL_FULL].node + e / v->spans * u->order;
        const int *at_v = v->line[SHELL_FULL].node + e % v->spans * v->order;
        int *node = space->ien + (size_t)e * (size_t)space->local;
        for (int a = 0; a < space->local; a++)
            node[a] = at_u[a / v->order] * m + at_v[a % v->order];
    }
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

int shell_space_places(const struct shell_space *space, int rule, int element,
                       struct shell_place *place)
{
    const struct shell_direction *d = space->direction;
    const int span[2] = {element / d[1].spans, element % d[1].spans};
    int count = 0;

    for (int g = 0; g < space->rule[rule].grids; g++) {
        const struct shell_grid *grid = &space->rule[rule].grid[g];
        const struct line_table *u = &d[0].line[grid->line[0]],
                                *v = &d[1].line[grid->line[1]];
        const int rows = v->points[span[1]], all = rows * u->points[span[0]];
        for (int n = 0; n < all; n++) {
            const bool along_u = grid->share == SHELL_UNSEEN_V; /* its rows are */
            const int i = along_u ? n % (all / rows) : n / rows,
                      j = along_u ? n / (all / rows) : n % rows,
                      at_u = span[0] * u->most + i, at_v = span[1] * v->most + j;
            place[count++] = (struct shell_place){
                u->weight[at_u] * v->weight[at_v],
                {u->value + at_u * 3 * d[0].order, v->value + at_v * 3 * d[1].order}};
        }
    }
    return count;
}

static int derivatives_of(int rule)
{
    return rule == SHELL_BENDING ? SHELL_DERIVATIVES : SHELL_SLOPES;
}

size_t shell_space_size(const struct shell_space *space, int rule)
{
    return (size_t)(derivatives_of(rule) * space->local * space->rule[rule].padded);
}

static int points_of(const struct shell_space *space, int rule, int element)
{
    const struct shell_direction *d = space->direction;
    int count = 0;

    for (int g = 0; g < space->rule[rule].grids; g++) {
        const int *line = space->rule[rule].grid[g].line;
        count += d[0].line[line[0]].points[element / d[1].spans] *
                 d[1].line[line[1]].points[element % d[1].spans];
    }
    return count;
}

/* Returns where a kept table begins. Alike: one for both, slopes where both have them. */
static size_t place_of(const struct shell_space *space, int rule, int element)
{
    const size_t bending = shell_space_size(space, SHELL_BENDING),
                 flat = space->alike ? 0 : shell_space_size(space, SHELL_MEMBRANE);

    return (size_t)element * (bending + flat) +
           (rule == SHELL_MEMBRANE && flat ? bending : 0);
}

static int make_functions(const struct shell_space *space, int rule, int element, double *T)
{
    enum { ROOM = 3 * BSPLINE_MAX_ORDER * SHELL_MAX_POINTS };
    const int derivatives = derivatives_of(rule);
    const int first = rule < SHELL_PARTS && !space->weight; /* strains need no values */
    const int *order = (const int[]){space->direction[0].order, space->direction[1].order};
    struct shell_place place[SHELL_MAX_POINTS];
    int row = space->rule[rule].padded, count;
    double F[2][ROOM], *t = T; /* of u and of v at each point: [3][order][used] */

    count = shell_space_places(space, rule, element, place);
    int used = SHELL_PADDED(count);
    for (int d = 0; d < 2; d++)
        for (int k = 0; k < 3 * order[d]; k++)
            for (int q = 0; q < used; q++)
                F[d][k * used + q] = q < count ? place[q].N[d][k] : 0;
    t += first * space->local * row;
    for (int k = first; k < derivatives; k++)
        for (int i = 0; i < order[0]; i++)
            for (int j = 0; j < order[1]; j++, t += row) {
                const double *f = F[0] + (derivative_u[k] * order[0] + i) * used;
                const double *g = F[1] + (derivative_v[k] * order[1] + j) * used;
                for (int q = 0; q < used; q++)
                    t[q] = f[q] * g[q];
            }
    if (space->weight)
        make_rational(space, space->ien + (size_t)element * (size_t)space->local,
                      derivatives, row, count, T);
    return count;
}

int shell_space_functions(const struct shell_space *space, int rule, int element,
                          double *room, const double **T)
{
    const bool kept = space->table && rule < SHELL_PARTS;

    *T = kept ? space->table + place_of(space, rule, element) : room;
    return kept ? points_of(space, rule, element)
                : make_functions(space, rule, element, room);
}

/* Tables are kept up to so many numbers, 16 MB: that far from the processor, reading them
 * takes as long as making them. */
enum { TABLE = 1 << 21 };

enum status shell_space_init(struct shell_space *space, const struct bspline basis[2],
                             const double *point, const double *weight, const int gauss[2],
                             bool selective, struct message *why)
{
    enum status st;
    struct shell_space new = {0};
    size_t table;

    TRY(check(basis, gauss, why));
    for (int d = 0; d < 2; d++)
        TRY(bspline_copy(&basis[d], &new.basis[d]));
    new.nodes = basis[0].n *bspline_points(&basis[1]);
    new.local = (basis[0].p + 1) * (basis[1].p + 1);
    TRY(make_directions(&new, gauss, selective));
    make_rules(&new, selective);
    new.elements = new.direction[0].spans *new.direction[1].spans;
    table = place_of(&new, SHELL_BENDING, new.elements);
    TRY(room_cut(&new.room, ROOM(new.ien, new.elements *(size_t) new.local),
                 ROOM(new.rest, 3 * (size_t) new.nodes),
                 ROOM(new.weight, weight ? new.nodes : 0),
                 ROOM(new.table, table <= TABLE ? table : 0)));
    memcpy(new.rest, point, 3 * (size_t) new.nodes * sizeof *point);
    if (weight)
        memcpy(new.weight, weight, (size_t) new.nodes * sizeof *weight);
    number_elements(&new);
    for (int n = 0; new.table &&n < new.elements; n++)
        for (int r = new.alike; r < SHELL_PARTS; r++)
            make_functions(&new, r, n, new.table + place_of(&new, r, n));
    TRY(blocks_slabs(new.elements, new.direction[1].spans, new.direction[0].order,
                     &new.slabs, &new.slab));
    HAND_OVER(space, new);
out:
    shell_space_clear(&new);
    return st;
}

void shell_space_at(const struct shell_space *space, int part, double s, double v,
                    int *node, double *T)
{
    double N[2][3 * BSPLINE_MAX_ORDER];
    const int first[2] = {bspline_alive(&space->basis[0], part, s, 2, N[0]),
                          bspline_alive(&space->basis[1], 0, v, 2, N[1])};
    const int order[2] = {space->basis[0].p + 1, space->basis[1].p + 1};
    int a = 0;

    for (int i = 0; i < order[0]; i++)
        for (int j = 0; j < order[1]; j++, a++) {
            node[a] = (first[0] + i) * bspline_points(&space->basis[1]) +
                      bspline_point(&space->basis[1], first[1] + j);
            for (int k = 0; k < SHELL_DERIVATIVES; k++)
                T[k * space->local + a] = N[0][derivative_u[k] * order[0] + i] *
                                          N[1][derivative_v[k] * order[1] + j];
        }
    if (space->weight)
        make_rational(space, node, SHELL_DERIVATIVES, 1, 1, T);
}

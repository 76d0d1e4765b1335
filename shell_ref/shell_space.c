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
        free(space->direction[d].table);
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

/* Values at the `mine` Gauss points of each span, spread over the element's: point
 * q = qu other + qv belongs to place (d == 0 ? q / other : q % other) of this direction. */
static enum status tabulate(struct shell_space *space, int d, int mine, int other)
{
    const struct bspline *b = &space->basis[d];
    struct shell_direction *dir = &space->direction[d];
    double x[SHELL_MAX_GAUSS], w[SHELL_MAX_GAUSS];
    double N[3 * BSPLINE_MAX_ORDER];
    size_t row = (size_t)space->padded;

    dir->order = b->p + 1;
    dir->span = malloc((size_t)b->n * sizeof *dir->span);
    if (!dir->span)
        return STATUS_MEMORY;
    dir->spans = bspline_spans(b, dir->span);
    dir->table = calloc((size_t)(dir->spans * 3 * dir->order) * row, sizeof *dir->table);
    if (!dir->table)
        return STATUS_MEMORY;
    gauss_rule(mine, x, w);
    for (int s = 0; s < dir->spans; s++)
        for (int q = 0; q < space->gauss; q++) {
            int k = dir->span[s];
            double from = b->U[k], step = b->U[k + 1] - from;
            double at = from + step * x[d == 0 ? q / other : q % other];
            bspline_eval(b, k, at, 2, N);
            for (int t = 0; t < 3 * dir->order; t++)
                dir->table[(size_t)(s * 3 * dir->order + t) * row + (size_t)q] = N[t];
        }
    return STATUS_OK;
}

static void number_elements(struct shell_space *space, const int gauss[2])
{
    const struct shell_direction *u = &space->direction[0], *v = &space->direction[1];
    double x[SHELL_MAX_GAUSS], wu[SHELL_MAX_GAUSS], wv[SHELL_MAX_GAUSS];
    int m = space->basis[1].n;

    gauss_rule(gauss[0], x, wu);
    gauss_rule(gauss[1], x, wv);
    for (int e = 0; e < space->elements; e++) {
        int ku = u->span[e / v->spans], kv = v->span[e % v->spans];
        int *node = space->ien + (size_t)e * (size_t)space->local;
        double *weight = space->parametric + (size_t)e * (size_t)space->padded;
        double area = (space->basis[0].U[ku + 1] - space->basis[0].U[ku]) *
                      (space->basis[1].U[kv + 1] - space->basis[1].U[kv]);
        for (int a = 0; a < space->local; a++)
            node[a] =
                (ku - u->order + 1 + a / v->order) * m + kv - v->order + 1 + a % v->order;
        for (int q = 0; q < space->gauss; q++)
            weight[q] = area * wu[q / gauss[1]] * wv[q % gauss[1]];
    }
}

enum status shell_space_init(struct shell_space *space, const struct bspline basis[2],
                             const double *point, const double *weight, const int gauss[2],
                             struct message *why)
{
    enum status st;
    int points[2];
    struct shell_space new = {0};

    TRY(check(basis, gauss, why));
    for (int d = 0; d < 2; d++) {
        points[d] = gauss[d] ? gauss[d] : basis[d].p + 1;
        TRY(bspline_copy(&basis[d], &new.basis[d]));
    }
    new.nodes = basis[0].n *basis[1].n;
    new.local = (basis[0].p + 1) * (basis[1].p + 1);
    new.gauss = points[0] * points[1];
    new.padded = SHELL_PADDED(new.gauss);
    TRY(tabulate(&new, 0, points[0], points[1]));
    TRY(tabulate(&new, 1, points[1], points[1]));
    new.elements = new.direction[0].spans *new.direction[1].spans;
    TRY(room_cut(&new.room, ROOM(new.ien, new.elements *(size_t) new.local),
                 ROOM(new.parametric, new.elements *(size_t) new.padded),
                 ROOM(new.rest, 3 * (size_t) new.nodes),
                 ROOM(new.weight, weight ? new.nodes : 0)));
    memcpy(new.rest, point, 3 * (size_t) new.nodes * sizeof *point);
    if (weight)
        memcpy(new.weight, weight, (size_t) new.nodes * sizeof *weight);
    number_elements(&new, points);
    TRY(blocks_slabs(new.elements, new.direction[1].spans, new.direction[0].order,
                     &new.slabs, &new.slab));
    HAND_OVER(space, new);
out:
    shell_space_clear(&new);
    return st;
}

/* Turns B-spline functions into rational ones, R = w N / W, W = sum w N, by the quotient
 * rule; T[SHELL_DERIVATIVES][local][row], columns first .. first + count. */
static void make_rational(const struct shell_space *space, const int *node, int row,
                          int count, double *T)
{
    size_t stride = (size_t)space->local * (size_t)row;

    for (int q = 0; q < count; q++) {
        double W[SHELL_DERIVATIVES] = {0};
        for (int a = 0; a < space->local; a++)
            for (int k = 0; k < SHELL_DERIVATIVES; k++) {
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
            t[3 * stride] = (t[3 * stride] - 2 * u * W[1] - R * W[3]) / W[0];
            t[4 * stride] = (t[4 * stride] - 2 * v * W[2] - R * W[4]) / W[0];
            t[5 * stride] = (t[5 * stride] - u * W[2] - v * W[1] - R * W[5]) / W[0];
        }
    }
}

void shell_space_functions(const struct shell_space *space, int element, double *T)
{
    const struct shell_direction *u = &space->direction[0], *v = &space->direction[1];
    size_t row = (size_t)space->padded;
    const double *U = u->table + (size_t)(element / v->spans * 3 * u->order) * row;
    const double *V = v->table + (size_t)(element % v->spans * 3 * v->order) * row;

    for (int k = 0; k < SHELL_DERIVATIVES; k++)
        for (int i = 0; i < u->order; i++)
            for (int j = 0; j < v->order; j++, T += row) {
                const double *f = U + (size_t)(derivative_u[k] * u->order + i) * row;
                const double *g = V + (size_t)(derivative_v[k] * v->order + j) * row;
                for (size_t q = 0; q < row; q++)
                    T[q] = f[q] * g[q];
            }
    if (space->weight)
        make_rational(space, space->ien + (size_t)element * (size_t)space->local,
                      space->padded, space->gauss,
                      T - (size_t)(SHELL_DERIVATIVES * space->local) * row);
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
        make_rational(space, node, 1, 1, T);
}

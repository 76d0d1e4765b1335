/* A polynomial piece f of degree p has a blossom: the symmetric multi-affine f(t1..tp) with
 * f(t..t) = f(t). Control point i is f at the p knots after knot i, in any space that holds
 * the curve; seen as a curve of degree P >= p, its blossom is the mean of f over all
 * choices of p out of the P arguments. So one formula gives the rows of the operator from
 * old to new control points for insertion, elevation and both at once (Ramshaw 1989; for P
 * = p it is the Oslo algorithm, Cohen, Lyche, Riesenfeld 1980). Rows are convex
 * combinations: nothing is lost to round-off, and positive weights stay positive. */
#include "iga/refine.h"

#include <assert.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* Computes c[p + 1]: weights of the control points span-p..span in f(argument[0..p-1]),
 * f the piece on `span`. The basis function recurrence with another argument on every
 * level. */
static void blossom(const struct bspline *b, int span, const double *argument, double *c)
{
    c[0] = 1.0;
    for (int q = 1; q <= b->p; q++) {
        double carried = 0.0, t = argument[q - 1];
        for (int a = 0; a < q; a++) {
            double left = b->U[span + 1 - q + a], right = b->U[span + 1 + a];
            double share = c[a] / (right - left);
            c[a] = carried + (right - t) * share;
            carried = (t - left) * share;
        }
        c[q] = carried;
    }
}

/* Computes row i of the operator. The span is that of the knot before the arguments, and
 * these ascend: every factor is then a convex one. */
static void operator_row(const struct bspline *old, const struct bspline *new, int i,
                         int span, double *row)
{
    const double *knot = new->U + i + 1;
    double argument[BSPLINE_MAX_DEGREE], c[BSPLINE_MAX_ORDER];
    int choices = 0;

    memset(row, 0, ((size_t)old->p + 1) * sizeof *row);
    for (unsigned choice = 0; choice < 1u << new->p; choice++) {
        int count = 0;
        if (__builtin_popcount(choice) != old->p)
            continue;
        for (int k = 0; k < new->p; k++)
            if (choice >> k & 1)
                argument[count++] = knot[k];
        blossom(old, span, argument, c);
        for (int a = 0; a <= old->p; a++)
            row[a] += c[a];
        choices++;
    }
    for (int a = 0; a <= old->p; a++)
        row[a] /= choices;
}

/* Control points as a net [outer][n][block], n along the direction, block = points across
 * times 4 homogeneous coordinates (w x, w y, w z, w). */
struct net {
    size_t outer, block;
    double *value; /* owned */
};

static enum status net_read(const struct patch *patch, int direction, struct net *net)
{
    size_t nodes = (size_t)patch_nodes(patch);

    net->outer = 1, net->block = 4;
    for (int d = 0; d < 3; d++)
        if (d < direction)
            net->outer *= (size_t)patch->basis[d].n;
        else if (d > direction)
            net->block *= (size_t)patch->basis[d].n;
    net->value = malloc(nodes * 4 * sizeof *net->value);
    if (!net->value)
        return STATUS_MEMORY;
    for (size_t a = 0; a < nodes; a++) {
        double weight = patch->weight ? patch->weight[a] : 1.0;
        for (int d = 0; d < 3; d++)
            net->value[4 * a + d] = weight * patch->point[3 * a + d];
        net->value[4 * a + 3] = weight;
    }
    return STATUS_OK;
}

/* Writes a net to a patch whose arrays have the right size. Without weights the last
 * coordinate is 1 up to the row sums' round-off, which dividing removes. */
static void net_write(const double *value, struct patch *patch)
{
    size_t nodes = (size_t)patch_nodes(patch);

    for (size_t a = 0; a < nodes; a++) {
        for (int d = 0; d < 3; d++)
            patch->point[3 * a + d] = value[4 * a + d] / value[4 * a + 3];
        if (patch->weight)
            patch->weight[a] = value[4 * a + 3];
    }
}

static void net_apply(const struct net *net, const struct bspline *old,
                      const struct bspline *new, double *out)
{
    for (int i = 0; i < new->n; i++) {
        int span = bspline_span(old, new->U[i]);
        double row[BSPLINE_MAX_ORDER];
        operator_row(old, new, i, span, row);
        for (size_t o = 0; o < net->outer; o++) {
            double *to = out + (o * (size_t) new->n + (size_t)i) * net->block;
            const double *from = net->value;
            from += (o * (size_t)old->n + (size_t)(span - old->p)) * net->block;
            for (size_t x = 0; x < net->block; x++) {
                to[x] = 0.0;
                for (int a = 0; a <= old->p; a++)
                    to[x] += row[a] * from[(size_t)a * net->block + x];
            }
        }
    }
}

/* Moves the patch into a space of degree p and knots U[count] that contains its own: every
 * old knot occurs in U once for each time it did, and once more for each degree gained. */
static enum status change_space(struct patch *patch, int direction, int p, int count,
                                const double *U, struct message *why)
{
    enum status st = STATUS_OK;
    struct bspline basis[3], finer = {0};
    struct patch new = {0};
    struct net net = {0};
    double *value = NULL;
    size_t nodes;

    TRY(bspline_init(&finer, p, count, U, why));
    memcpy(basis, patch->basis, sizeof basis); /* borrowed */
    basis[direction] = finer;
    nodes = (size_t)basis[0].n * (size_t)basis[1].n * (size_t)basis[2].n;
    if (nodes > INT_MAX / 4)
        TRY(status_fail(why, STATUS_INPUT, "%zu control points are too many", nodes));
    TRY(patch_init(&new, basis));
    TRY(net_read(patch, direction, &net));
    value = malloc(nodes * 4 * sizeof *value);
    if (!value)
        TRY(STATUS_MEMORY);
    if (patch->weight) {
        new.weight = malloc(nodes * sizeof *new.weight);
        if (!new.weight)
            TRY(STATUS_MEMORY);
    }
    net_apply(&net, &patch->basis[direction], &finer, value);
    net_write(value, &new);
    patch_clear(patch);
    *patch = new, new = (struct patch){0};
out:
    if (st == STATUS_MEMORY)
        status_fail(why, st, "no memory to refine the patch");
    free(value);
    free(net.value);
    patch_clear(&new);
    bspline_clear(&finer);
    return st;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* Elevates by `by` and inserts u[count], in one step: it succeeds or nothing happens. */
static enum status refine(struct patch *patch, int direction, int by, int count,
                          const double *u, struct message *why)
{
    const struct bspline *b = &patch->basis[direction];
    const int old = b->n + b->p + 1;
    enum status st;
    double *T;

    if (!by && !count)
        return STATUS_OK;
    T = malloc(((size_t)old * (1 + (size_t)by) + (size_t)count) * sizeof *T);
    if (!T)
        return status_fail(why, STATUS_MEMORY, "no memory for the knots");
    if (count)
        memcpy(T, u, (size_t)count * sizeof *T);
    for (int i = 0; i < old; i++) /* the last of equal ones stands for those gained */
        for (int k = 0; k < (i + 1 == old || b->U[i + 1] > b->U[i] ? 1 + by : 1); k++)
            T[count++] = b->U[i];
    qsort(T, (size_t)count, sizeof *T, ascending);
    TRY(change_space(patch, direction, b->p + by, count, T, why));
out:
    free(T);
    return st;
}

static enum status check_elevation(const struct bspline *b, int by, struct message *why)
{
    if (by < 0)
        return status_fail(why, STATUS_INPUT, "a degree cannot be elevated by %d", by);
    if (by > BSPLINE_MAX_DEGREE - b->p)
        return status_fail(why, STATUS_INPUT, "degree %d elevated by %d is above %d", b->p,
                           by, BSPLINE_MAX_DEGREE);
    return STATUS_OK;
}

enum status refine_insert(struct patch *patch, int direction, int count, const double *u,
                          struct message *why)
{
    assert(direction >= 0 && direction < 3);
    if (count < 0)
        return status_fail(why, STATUS_INPUT, "%d knots cannot be inserted", count);
    for (int i = 0; i < count; i++) {
        if (!(u[i] > 0.0 && u[i] < 1.0))
            return status_fail(why, STATUS_INPUT,
                               "new knot %g is not strictly between 0 and 1", u[i]);
        if (i && u[i] < u[i - 1])
            return status_fail(why, STATUS_INPUT,
                               "new knots must not decrease: %g after %g", u[i], u[i - 1]);
    }
    return refine(patch, direction, 0, count, u, why);
}

enum status refine_k(struct patch *patch, int direction, int elevate_by, int parts,
                     struct message *why)
{
    enum status st = STATUS_OK;
    const struct bspline *b;
    double *u = NULL;
    int *span = NULL, spans, count = 0;

    assert(direction >= 0 && direction < 3);
    b = &patch->basis[direction];
    TRY(check_elevation(b, elevate_by, why));
    if (parts < 1 || parts > INT_MAX / 4 / b->n)
        TRY(status_fail(why, STATUS_INPUT, "a span cannot be split into %d parts", parts));
    span = malloc((size_t)(b->n - b->p) * sizeof *span);
    u = calloc((size_t)(b->n - b->p) * (size_t)parts, sizeof *u);
    if (!span || !u)
        TRY(status_fail(why, STATUS_MEMORY, "no memory for the knots"));
    spans = bspline_spans(b, span);
    for (int s = 0; s < spans; s++) {
        double left = b->U[span[s]], width = b->U[span[s] + 1] - left;
        for (int j = 1; j < parts; j++)
            u[count++] = left + width * j / parts;
    }
    TRY(refine(patch, direction, elevate_by, count, u, why));
out:
    free(span);
    free(u);
    return st;
}

enum status refine_elevate(struct patch *patch, int direction, int by, struct message *why)
{
    return refine_k(patch, direction, by, 1, why);
}

enum status refine_split(struct patch *patch, int direction, int parts, struct message *why)
{
    return refine_k(patch, direction, 0, parts, why);
}

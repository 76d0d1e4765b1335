#include "projective_dynamics/pd_dual.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST_ROOM = 32, MOST_LINEAR = 1000 };

/* A pivot below this share of its diagonal is round-off: the row depends on others. */
static const double DEPENDENT = 1e-13;

void pd_dual_clear(struct pd_dual *d)
{
    free(d->place);
    free(d->column);
    for (int n = 0; n < 3; n++)
        free(d->entry[n]);
    for (int n = 0; n < 2 && d->system; n++)
        pd_net_free_fields(d->system->net, d->field[n]);
    for (int n = 0; n < PD_DUAL_KINDS; n++) {
        free(d->factor[n].row);
        free(d->factor[n].S);
    }
    free(d->work);
    memset(d, 0, sizeof *d);
}

enum status pd_dual_init(struct pd_dual *d, struct pd_system *system)
{
    size_t nodes = (size_t)system->net->nodes;

    *d = (struct pd_dual){.system = system, .dense = PD_DUAL_DENSE};
    d->place = malloc(nodes * sizeof *d->place);
    d->column = malloc(nodes * sizeof *d->column);
    d->field[0] = pd_net_fields(system->net, 3);
    d->field[1] = pd_net_fields(system->net, 3);
    if (!d->place || !d->column || !d->field[0] || !d->field[1]) {
        pd_dual_clear(d);
        return STATUS_MEMORY;
    }
    for (size_t k = 0; k < nodes; k++)
        d->place[k] = -1;
    return STATUS_OK;
}

/* --- entries of A^-1 ---------------------------------------------------------------------
 */

static enum status grow(struct pd_dual *d)
{
    int room = d->room ? 2 * d->room : FIRST_ROOM;

    room = room > d->dense ? d->dense : room;
    for (int g = 0; g < d->system->group_count; g++) {
        double *new = malloc((size_t)room * (size_t)room * sizeof *new);
        if (!new)
            return STATUS_MEMORY;
        for (int k = 0; k < d->known; k++)
            memcpy(new + (size_t)k *(size_t)room, d->entry[g] + (size_t)k * (size_t)d->room,
                   (size_t)d->known * sizeof *new);
        free(d->entry[g]);
        d->entry[g] = new;
    }
    d->room = room;
    return STATUS_OK;
}

static enum status learn(struct pd_dual *d, int node)
{
    enum status st = STATUS_OK;
    int at = d->known;

    if (at == d->room)
        TRY(grow(d));
    d->place[node] = d->known++;
    for (int g = 0; g < d->system->group_count; g++) {
        TRY(pd_system_column(d->system, g, node, d->column));
        d->solves++;
        for (int k = 0; k < d->system->net->nodes; k++)
            if (d->place[k] >= 0) {
                size_t other = (size_t)d->place[k], room = (size_t)d->room;
                d->entry[g][(size_t)at * room + other] = d->column[k];
                d->entry[g][other * room + (size_t)at] = d->column[k];
            }
    }
out:
    return st;
}

static void forget(struct pd_dual *d)
{
    for (int k = 0; k < d->system->net->nodes; k++)
        d->place[k] = -1;
    d->known = 0;
}

static enum status learn_rows(struct pd_dual *d, const struct pd_push *row, int count)
{
    enum status st = STATUS_OK;

    for (int attempt = 0; attempt < 2; attempt++) {
        int n = 0;
        for (; n < count; n++)
            if (d->place[row[n].node] < 0) {
                if (d->known == d->dense)
                    break;
                TRY(learn(d, row[n].node));
            }
        if (n == count)
            break;
        forget(d);
    }
out:
    return st;
}

/* --- dense -------------------------------------------------------------------------------
 */

static double coupling(const struct pd_dual *d, const struct pd_push *a,
                       const struct pd_push *b)
{
    size_t at = (size_t)d->place[a->node] * (size_t)d->room + (size_t)d->place[b->node];
    double sum = 0;

    for (int g = 0; g < d->system->group_count; g++) {
        const struct pd_group *group = &d->system->group[g];
        double along = 0;
        for (int c = group->first; c < group->first + group->count; c++)
            along += a->direction[c] * b->direction[c];
        sum += along * d->entry[g][at];
    }
    return sum;
}

/* Factors S = L L^T in place; a row that depends on others gets the diagonal INFINITY. */
static void cholesky(double *S, int count)
{
    for (int i = 0; i < count; i++) {
        double *row = S + (size_t)i * (size_t)count, left = row[i];
        for (int j = 0; j < i; j++) {
            const double *other = S + (size_t)j * (size_t)count;
            double sum = row[j];
            for (int k = 0; k < j; k++)
                sum -= row[k] * other[k];
            row[j] = sum / other[j];
            left -= row[j] * row[j];
        }
        row[i] = left > DEPENDENT * row[i] ? sqrt(left) : INFINITY;
    }
}

static bool same_rows(const struct pd_dual_factor *f, const struct pd_push *row, int count)
{
    bool same = count == f->count;

    for (int n = 0; same && n < count; n++) {
        same = row[n].node == f->row[n].node;
        for (int c = 0; same && c < 3; c++)
            same = row[n].direction[c] == f->row[n].direction[c];
    }
    return same;
}

static enum status make_room(struct pd_dual_factor *f, int count)
{
    size_t n = (size_t)count;

    f->count = 0;
    if (count <= f->room)
        return STATUS_OK;
    free(f->S);
    free(f->row);
    f->S = malloc(n * n * sizeof *f->S);
    f->row = malloc(n * sizeof *f->row);
    f->room = f->S && f->row ? count : 0;
    return f->room ? STATUS_OK : STATUS_MEMORY;
}

static enum status factor(struct pd_dual *d, struct pd_dual_factor *f,
                          const struct pd_push *row, int count)
{
    enum status st = STATUS_OK;
    size_t n = (size_t)count;

    if (same_rows(f, row, count))
        return STATUS_OK;
    TRY(make_room(f, count));
    TRY(learn_rows(d, row, count));
    for (int a = 0; a < count; a++)
        for (int b = 0; b <= a; b++)
            f->S[(size_t)a * n + (size_t)b] = coupling(d, row + a, row + b);
    cholesky(f->S, count);
    memcpy(f->row, row, n * sizeof *row);
    f->count = count;
out:
    return st;
}

static void substitute(const double *L, int count, double *x)
{
    for (int i = 0; i < count; i++) {
        const double *row = L + (size_t)i * (size_t)count;
        for (int k = 0; k < i; k++)
            x[i] -= row[k] * x[k];
        x[i] /= row[i];
    }
    for (int i = count - 1; i >= 0; i--) {
        const double *row = L + (size_t)i * (size_t)count;
        x[i] /= row[i];
        for (int k = 0; k < i; k++)
            x[k] -= row[k] * x[i];
    }
}

/* --- conjugate gradients -----------------------------------------------------------------
 */

static void scatter(const struct pd_dual *d, const struct pd_push *row, int count,
                    const double *x, double *z)
{
    const struct pd_net *net = d->system->net;
    ptrdiff_t stride = pd_net_stride(net);

    for (int c = 0; c < 3; c++)
        memset(z + c * stride, 0, (size_t)net->nodes * sizeof *z);
    for (int n = 0; n < count; n++)
        for (int c = 0; c < 3; c++)
            if (!d->system->held[c * net->nodes + row[n].node])
                z[c * stride + row[n].node] += row[n].direction[c] * x[n];
}

static void gather(const struct pd_dual *d, const struct pd_push *row, int count,
                   const double *z, double *x)
{
    const struct pd_net *net = d->system->net;
    ptrdiff_t stride = pd_net_stride(net);

    for (int n = 0; n < count; n++) {
        x[n] = 0;
        for (int c = 0; c < 3; c++)
            if (!d->system->held[c * net->nodes + row[n].node])
                x[n] += row[n].direction[c] * z[c * stride + row[n].node];
    }
}

enum status pd_dual_push(struct pd_dual *d, const struct pd_push *row, int count,
                         const double *x, double *z)
{
    scatter(d, row, count, x, z);
    d->solves++;
    return pd_system_solve(d->system, z);
}

static enum status iterate(struct pd_dual *d, const struct pd_push *row, int count,
                           double near, double *r)
{
    enum status st = STATUS_OK;
    size_t n = (size_t)count;

    if (count > d->work_room) {
        free(d->work);
        d->work_room = count;
        d->work = malloc(4 * n * sizeof *d->work);
        if (!d->work) {
            d->work_room = 0;
            return STATUS_MEMORY;
        }
    }
    double *x = d->work, *z = x + n, *q = z + n, *Sq = q + n, size = 0;
    memset(x, 0, 2 * n * sizeof *x);
    for (int turn = 0; turn < MOST_LINEAR; turn++) {
        double most = 0, before = size, bent = 0;
        for (size_t t = 0; t < n; t++)
            most = fabs(r[t]) > most ? fabs(r[t]) : most;
        if (!(most > near))
            break;
        scatter(d, row, count, r, d->field[0]);
        pd_system_multiply(d->system, d->field[0], d->field[1]);
        gather(d, row, count, d->field[1], z);
        size = 0;
        for (size_t t = 0; t < n; t++)
            size += r[t] * z[t];
        for (size_t t = 0; t < n; t++)
            q[t] = z[t] + (turn ? size / before * q[t] : 0);
        TRY(pd_dual_push(d, row, count, q, d->field[0]));
        gather(d, row, count, d->field[0], Sq);
        for (size_t t = 0; t < n; t++)
            bent += q[t] * Sq[t];
        if (!(bent > 0))
            break;
        for (size_t t = 0; t < n; t++) {
            x[t] += size / bent * q[t];
            r[t] -= size / bent * Sq[t];
        }
    }
    memcpy(r, x, n * sizeof *r);
out:
    return st;
}

enum status pd_dual_solve(struct pd_dual *d, enum pd_dual_kind kind,
                          const struct pd_push *row, int count, double near, double *r)
{
    enum status st = STATUS_OK;

    if (count > d->dense)
        return iterate(d, row, count, near, r);
    TRY(factor(d, &d->factor[kind], row, count));
    substitute(d->factor[kind].S, count, r);
out:
    return st;
}

#include "models/linalg/ichol.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "models/room.h"

/* The first shift of the diagonal, its growth from try to try, and the largest. */
static const double FIRST_SHIFT = 1e-3, GROWTH = 4, MOST_SHIFT = 1;

struct ichol {
    int n;
    void *room;  /* memory of the arrays                                       owned   */
    long *start; /* [n + 1] lower triangle by columns, diagonal first                  */
    int *row;    /* [start[n]]                                                         */
    double *value, *factor; /* [start[n]] A and L                                      */
    long *first, *entry;    /* row i of L: entries entry[first[i] .. first[i+1])       */
    int *column;            /* [start[n]] of those                                     */
    long *where;            /* [n] work: of each row in the present column, -1         */
};

/* Lists the rows of the strict lower triangle, by counting. */
static void list_rows(struct ichol *f)
{
    for (int j = 0; j < f->n; j++)
        for (long s = f->start[j] + 1; s < f->start[j + 1]; s++)
            f->first[f->row[s] + 2]++;
    for (int i = 0; i < f->n; i++)
        f->first[i + 2] += f->first[i + 1];
    for (int j = 0; j < f->n; j++)
        for (long s = f->start[j] + 1; s < f->start[j + 1]; s++) {
            long at = f->first[f->row[s] + 1]++;
            f->entry[at] = s;
            f->column[at] = j;
        }
}

enum status ichol_create(const struct factor_pattern *a, struct ichol **out)
{
    size_t n = (size_t)a->n, entries = (size_t)a->start[a->n];
    struct ichol *f = calloc(1, sizeof *f);
    enum status st = f ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    f->n = a->n;
    TRY(room_cut(&f->room, ROOM(f->start, n + 1), ROOM(f->row, entries),
                 ROOM(f->value, entries), ROOM(f->factor, entries), ROOM(f->first, n + 2),
                 ROOM(f->entry, entries), ROOM(f->column, entries), ROOM(f->where, n)));
    memcpy(f->start, a->start, (n + 1) * sizeof *f->start);
    if (entries)
        memcpy(f->row, a->row, entries * sizeof *f->row);
    list_rows(f);
    for (int i = 0; i < f->n; i++)
        f->where[i] = -1;
    *out = f, f = NULL;
out:
    ichol_destroy(f);
    return st;
}

void ichol_destroy(struct ichol *f)
{
    if (!f)
        return;
    free(f->room);
    free(f);
}

double *ichol_values(struct ichol *f)
{
    return f->value;
}

/* Updates column k by the columns before it, within its pattern. */
static void update(struct ichol *f, int k)
{
    double *l = f->factor;

    for (long s = f->start[k]; s < f->start[k + 1]; s++)
        f->where[f->row[s]] = s;
    for (long t = f->first[k]; t < f->first[k + 1]; t++) {
        long p = f->entry[t], end = f->start[f->column[t] + 1];
        for (long q = p; q < end; q++) {
            long at = f->where[f->row[q]];
            if (at >= 0)
                l[at] -= l[q] * l[p];
        }
    }
    for (long s = f->start[k]; s < f->start[k + 1]; s++)
        f->where[f->row[s]] = -1;
}

/* Factors A + shift diag A; false at a pivot that is not positive. */
static bool factor(struct ichol *f, double shift)
{
    double *l = f->factor;

    memcpy(l, f->value, (size_t)f->start[f->n] * sizeof *l);
    for (int k = 0; k < f->n; k++) {
        long s = f->start[k];
        double own = l[s];
        l[s] += shift * own;
        update(f, k);
        if (!(l[s] > 1e-14 * own && isfinite(l[s])))
            return false;
        l[s] = sqrt(l[s]);
        for (long t = s + 1; t < f->start[k + 1]; t++)
            l[t] /= l[s];
    }
    return true;
}

enum status ichol_refactor(struct ichol *f)
{
    double shift = 0;

    for (int k = 0; k < f->n; k++)
        if (!(f->value[f->start[k]] > 0))
            return STATUS_INDEFINITE;
    while (f->n && !factor(f, shift)) {
        shift = shift > 0 ? GROWTH * shift : FIRST_SHIFT;
        if (shift > MOST_SHIFT)
            return STATUS_INDEFINITE;
    }
    return STATUS_OK;
}

void ichol_solve(const struct ichol *f, double *x)
{
    const double *l = f->factor;

    for (int j = 0; j < f->n; j++) {
        x[j] /= l[f->start[j]];
        for (long s = f->start[j] + 1; s < f->start[j + 1]; s++)
            x[f->row[s]] -= l[s] * x[j];
    }
    for (int j = f->n - 1; j >= 0; j--) {
        double sum = x[j];
        for (long s = f->start[j] + 1; s < f->start[j + 1]; s++)
            sum -= l[s] * x[f->row[s]];
        x[j] = sum / l[f->start[j]];
    }
}

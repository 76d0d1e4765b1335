#include "fem_ref/freefem.h"
#include "fem_ref/reference.h"

#include <math.h>
#include <stdlib.h>

enum { POINTS = FREEFEM_SIDE * FREEFEM_SIDE };

/* The 17 digits of u = i / 11 reproduce it to one rounding. */
#define SAME_POINT 1e-15

/* Held unknowns have pivots of 1e30 and move by less than any displacement's rounding. */
#define HELD 1e-20

/* --- Reading --- */

static const char *row_fault(const struct reference *table, int row,
                             struct freefem_field *f)
{
    static const char *const name[] = {"dx", "dy", "dz"};
    const int t = row / POINTS, j = row % POINTS / FREEFEM_SIDE, i = row % FREEFEM_SIDE;
    double *shift = f->shift[t][j][i];

    if (f->times > 1 && !(reference_number(table, row, "t") == f->time[t]))
        return "another time than expected";
    if (!(fabs(reference_number(table, row, "u") - i / 11.0) <= SAME_POINT &&
          fabs(reference_number(table, row, "v") - j / 11.0) <= SAME_POINT))
        return "another point than expected";
    for (int c = 0; c < 3; c++) {
        shift[c] = reference_number(table, row, name[c]);
        if (!isfinite(shift[c]))
            return "a displacement is not a finite number";
        if (i == 0 && fabs(shift[c]) > HELD)
            return "the clamped edge moves";
    }
    if (i > 0 && shift[2] == 0)
        return "a point does not move";
    return NULL;
}

/* Sums the mesh's and the time step's error, where the file has them. */
static void read_error(const struct reference *table, struct freefem_field *f)
{
    static const char *const key[] = {"mesh_error_m", "step_error_m"};
    for (int t = 0; t < f->times; t++)
        f->error[t] = reference_note(table, key[0]) ? 0 : NAN;
    for (int k = 0; k < 2; k++) {
        const char *at = reference_note(table, key[k]);
        for (int t = 0; at && t < f->times; t++) {
            char *end;
            double error = strtod(at, &end);
            f->error[t] += end == at ? NAN : error;
            at = end;
        }
    }
}

static enum status take_table(const struct reference *table, const char *path,
                              struct freefem_field *f, struct message *why)
{
    static const char *const name[] = {"u", "v", "dx", "dy", "dz"};
    bool moving = reference_column(table, "t") >= 0;

    for (int c = 0; c < 5; c++)
        if (reference_column(table, name[c]) < 0)
            return status_fail(why, STATUS_INPUT, "%s: no column %s", path, name[c]);
    f->times = moving ? FREEFEM_TIMES : 1;
    for (int t = 0; t < f->times; t++)
        f->time[t] = moving ? (t + 1) / 10.0 : INFINITY;
    if (reference_rows(table) != f->times * POINTS)
        return status_fail(why, STATUS_INPUT, "%s: %d rows, not %d", path,
                           reference_rows(table), f->times * POINTS);
    for (int row = 0; row < f->times * POINTS; row++) {
        const char *fault = row_fault(table, row, f);
        if (fault)
            return status_fail(why, STATUS_INPUT, "%s: row %d: %s", path, row + 1, fault);
    }
    read_error(table, f);
    return reference_fault(table, why);
}

enum status freefem_read(const char *path, struct freefem_field *field, struct message *why)
{
    enum status st;
    struct freefem_field f = {0};
    struct reference *table = NULL;

    TRY(reference_open(path, &table, why));
    TRY(take_table(table, path, &f, why));
    *field = f;
out:
    reference_close(table);
    return st;
}

/* --- Comparing --- */

double freefem_difference(const struct freefem_field *a, const struct freefem_field *b,
                          int t)
{
    const double *p = a->shift[t][0][0], *q = b->shift[t][0][0];
    double sum = 0;
    for (int n = 0; n < 3 * POINTS; n++)
        sum += (p[n] - q[n]) * (p[n] - q[n]);
    return sqrt(sum / POINTS);
}

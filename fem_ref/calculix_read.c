#include "fem_ref/calculix_read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fem_ref/calculix_deck.h"

/* Displacements carry 7 digits, times 7. */
#define SAME_TIME 1e-6

/* ------------------------------------------------------------------ matrices -------- */

/* stem + ending; STATUS_LIBRARY if the program left no such file. */
static enum status open_output(const char *stem, const char *ending, FILE **file,
                               struct message *why)
{
    char path[600];
    snprintf(path, sizeof path, "%s%s", stem, ending);
    *file = fopen(path, "r");
    return *file ? STATUS_OK
                 : status_fail(why, STATUS_LIBRARY, "CalculiX wrote no %s file", ending);
}

/* row[n]: our row of CalculiX's equation n; a line `node.direction` each. */
static enum status read_unknowns(const struct calculix_job *job, const char *stem, int *row,
                                 int rows, struct message *why)
{
    enum status st;
    FILE *file = NULL;
    char *seen = calloc((size_t)rows, 1);
    int n = 0, a, i;

    TRY(seen ? STATUS_OK : STATUS_MEMORY);
    TRY(open_output(stem, ".dof", &file, why));
    while (fscanf(file, "%d.%d", &a, &i) == 2 && n < rows) {
        if (a < 1 || a > calculix_deck_nodes(job) || i < 1 || i > 3 ||
            seen[3 * (a - 1) + i - 1]++) {
            st = status_fail(why, STATUS_LIBRARY,
                             "CalculiX's equation %d is of node %d, direction %d: unknown "
                             "or there already",
                             n + 1, a, i);
            goto out;
        }
        row[n++] = 3 * (a - 1) + i - 1;
    }
    if (n != rows || !feof(file))
        st = status_fail(why, STATUS_LIBRARY,
                         "CalculiX's .dof file has other than %d unknowns", rows);
out:
    if (file)
        fclose(file);
    free(seen);
    return st;
}

static void swap(int *a, int *b)
{
    int t = *a;
    *a = *b, *b = t;
}

/* Lines `row column value` of one triangle. */
static enum status read_entries(const char *stem, const char *ending, const int *row,
                                int rows, struct matrix *m, struct message *why)
{
    enum status st;
    FILE *file = NULL;
    long most = (long)rows * (rows + 1) / 2;
    int i, j;
    double value;

    TRY(open_output(stem, ending, &file, why));
    *m = (struct matrix){.rows = rows,
                         .row = malloc((size_t)most * sizeof *m->row),
                         .column = malloc((size_t)most * sizeof *m->column),
                         .value = malloc((size_t)most * sizeof *m->value)};
    TRY(m->row && m->column && m->value ? STATUS_OK : STATUS_MEMORY);
    while (fscanf(file, "%d %d %lf", &i, &j, &value) == 3) {
        if (i < 1 || i > rows || j < 1 || j > rows || !isfinite(value) ||
            m->entries == most) {
            st = status_fail(why, STATUS_LIBRARY,
                             "CalculiX's %s file: entry %ld is %d %d %g", ending,
                             m->entries + 1, i, j, value);
            goto out;
        }
        i = row[i - 1], j = row[j - 1];
        if (i < j)
            swap(&i, &j);
        m->row[m->entries] = i, m->column[m->entries] = j;
        m->value[m->entries++] = value;
    }
    if (!feof(file) || m->entries < rows)
        st = status_fail(why, STATUS_LIBRARY,
                         "CalculiX's %s file stops after entry %ld of %d rows", ending,
                         m->entries, rows);
out:
    if (file)
        fclose(file);
    return st;
}

enum status calculix_read_matrices(const struct calculix_job *job, const char *stem,
                                   struct calculix_answer *answer, struct message *why)
{
    enum status st;
    int rows = 3 * calculix_deck_nodes(job), *row = malloc((size_t)rows * sizeof *row);

    TRY(row ? STATUS_OK : STATUS_MEMORY);
    TRY(read_unknowns(job, stem, row, rows, why));
    TRY(read_entries(stem, ".sti", row, rows, &answer->K, why));
    TRY(read_entries(stem, ".mas", row, rows, &answer->M, why));
out:
    free(row);
    return st;
}

/* ------------------------------------------------------------------ displacements --- */

/* One table of the file: a line with the time, an empty one, a row `node x y z` per node.
 */
static enum status read_table(const struct calculix_job *job, FILE *file, double time,
                              double *shift, struct message *why)
{
    int nodes = calculix_deck_nodes(job), a;
    double told = NAN, *x = shift;

    if (fscanf(file, " displacements (vx,vy,vz) for set ALL and time %lf", &told) != 1 ||
        !(fabs(told - time) <= SAME_TIME * time))
        return status_fail(why, STATUS_LIBRARY,
                           "CalculiX's .dat file has no displacements at time %g", time);
    for (int n = 1; n <= nodes; n++, x += 3) {
        if (fscanf(file, "%d %lf %lf %lf", &a, &x[0], &x[1], &x[2]) != 4 || a != n)
            return status_fail(why, STATUS_LIBRARY,
                               "CalculiX's .dat file stops before node %d at time %g", n,
                               time);
        for (int i = 0; i < 3; i++)
            if (!(fabs(x[i]) <= 1e6 * job->length))
                return status_fail(why, STATUS_LIBRARY,
                                   "CalculiX moves node %d by %g m: no solution", n, x[i]);
    }
    return STATUS_OK;
}

/* The mid-surface's displacement from all nodes'. */
static enum status take_middle(const struct calculix_job *job, const double *all,
                               double *shift, struct message *why)
{
    bool moves = false;

    for (int i = 0; i <= job->cells[0]; i++)
        for (int j = 0; j <= job->cells[1]; j++, shift += 3) {
            int low = calculix_deck_corner(job, i, j, 0);
            int high = calculix_deck_corner(job, i, j, job->cells[2]);
            for (int c = 0; c < 3; c++) {
                shift[c] = (all[3 * low + c] + all[3 * high + c]) / 2;
                if (i == 0 && (all[3 * low + c] != 0 || all[3 * high + c] != 0))
                    return status_fail(why, STATUS_LIBRARY,
                                       "CalculiX moves the clamped edge");
                moves = moves || shift[c] != 0;
            }
        }
    return moves ? STATUS_OK
                 : status_fail(why, STATUS_LIBRARY, "CalculiX's sheet does not move");
}

enum status calculix_read_shifts(const struct calculix_job *job, const char *stem,
                                 struct calculix_answer *answer, struct message *why)
{
    enum status st;
    FILE *file = NULL;
    bool swing = job->task == CALCULIX_SWING;
    double every = swing ? job->step * job->every : 1; /* a static step lasts 1 */
    size_t points = (size_t)(job->cells[0] + 1) * (size_t)(job->cells[1] + 1);
    double *all = malloc(3 * (size_t)calculix_deck_nodes(job) * sizeof *all);
    char rest;

    answer->times = swing ? (int)floor(job->end / every + 0.5) : 1;
    answer->points[0] = job->cells[0] + 1, answer->points[1] = job->cells[1] + 1;
    answer->time = malloc((size_t)answer->times * sizeof *answer->time);
    answer->shift = malloc((size_t)answer->times * 3 * points * sizeof *answer->shift);
    TRY(all && answer->time && answer->shift ? STATUS_OK : STATUS_MEMORY);
    TRY(open_output(stem, ".dat", &file, why));
    for (int t = 0; t < answer->times; t++) {
        answer->time[t] = swing ? every * (t + 1) : INFINITY;
        TRY(read_table(job, file, every * (t + 1), all, why));
        TRY(take_middle(job, all, answer->shift + 3 * points * (size_t)t, why));
    }
    if (fscanf(file, " %c", &rest) == 1)
        st = status_fail(why, STATUS_LIBRARY,
                         "CalculiX's .dat file has more than %d tables", answer->times);
out:
    if (file)
        fclose(file);
    free(all);
    return st;
}

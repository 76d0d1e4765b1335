/* Times the linear algebra of a frame by CHOLMOD and LAPACK in turn with ours, on the same
 * numbers: named baselines for speed ratios. */
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/bench_solid.h"
#include "bench/speed/bench.h"

enum { NETS = 4, TASKS = 6 };

/* The most unknowns for a band matrix: that of a large net would take 7 GB. */
static const int BAND_MOST = 10000;

/* A net with our factor and with CHOLMOD's, and its matrix as a band for LAPACK. */
struct baseline {
    struct run ours, theirs;
    int n, width; /* unknowns, half bandwidth                                          */
    long *start;
    int *row;
    double *value; /* lower triangle by columns, [n + 1] starts                   owned */
    double *band;  /* [n][width + 1]; NULL: too large                             owned */
    double *x;     /* [n] right-hand side of ones, solution                       owned */
};

static void clear(struct baseline *m)
{
    free(m->start);
    free(m->row);
    free(m->value);
    free(m->band);
    free(m->x);
    run_close(&m->ours);
    run_close(&m->theirs);
}

static enum status run_factor(void *run)
{
    return bench_solid_run(((struct run *)run)->state, BENCH_SOLID_FACTOR);
}

static enum status run_solve(void *run)
{
    return bench_solid_run(((struct run *)run)->state, BENCH_SOLID_SOLVE);
}

/* Fills the band before each factorization; not timed. */
static void fill_band(void *baseline)
{
    struct baseline *m = baseline;
    const size_t rows = (size_t)m->width + 1;

    memset(m->band, 0, (size_t)m->n * rows * sizeof *m->band);
    for (int j = 0; j < m->n; j++)
        for (long t = m->start[j]; t < m->start[j + 1]; t++)
            m->band[(size_t)j * rows + (size_t)(m->row[t] - j)] = m->value[t];
}

/* Sets the right-hand side before each solve; not timed. */
static void fill_ones(void *baseline)
{
    struct baseline *m = baseline;

    for (int j = 0; j < m->n; j++)
        m->x[j] = 1;
}

static enum status band_factor(void *baseline)
{
    struct baseline *m = baseline;

    return LAPACKE_dpbtrf_work(LAPACK_COL_MAJOR, 'L', m->n, m->width, m->band, m->width + 1)
               ? STATUS_INDEFINITE
               : STATUS_OK;
}

static enum status band_solve(void *baseline)
{
    struct baseline *m = baseline;

    return LAPACKE_dpbtrs_work(LAPACK_COL_MAJOR, 'L', m->n, m->width, 1, m->band,
                               m->width + 1, m->x, m->n)
               ? STATUS_INDEFINITE
               : STATUS_OK;
}

/* Makes the band and checks that LAPACK solves with it: STATUS_LIBRARY with a sentence if
 * A x is not the right-hand side. */
static enum status make_band(struct baseline *m, const char *name, struct message *why)
{
    static const double SOLVED = 1e-10; /* above round-off, below any other matrix */
    double *sum = calloc(2 * (size_t)m->n, sizeof *sum), *size = sum + m->n;
    double off = 0, scale = 0;
    enum status st;

    for (int j = 0; j < m->n; j++) /* rows of a column ascend */
        m->width = (int)fmax(m->width, m->row[m->start[j + 1] - 1] - j);
    m->band = malloc((size_t)m->n * ((size_t)m->width + 1) * sizeof *m->band);
    m->x = malloc((size_t)m->n * sizeof *m->x);
    TRY(sum && m->band && m->x ? STATUS_OK : STATUS_MEMORY);
    fill_band(m);
    fill_ones(m);
    TRY(band_factor(m));
    TRY(band_solve(m));
    for (int j = 0; j < m->n; j++)
        for (long t = m->start[j]; t < m->start[j + 1]; t++) {
            const int i = m->row[t];
            sum[i] += m->value[t] * m->x[j];
            size[i] += fabs(m->value[t] * m->x[j]);
            if (i == j)
                continue;
            sum[j] += m->value[t] * m->x[i];
            size[j] += fabs(m->value[t] * m->x[i]);
        }
    for (int i = 0; i < m->n; i++) {
        off = fmax(off, fabs(sum[i] - 1));
        scale = fmax(scale, size[i]);
    }
    if (!(off < SOLVED * scale))
        st = status_fail(why, STATUS_LIBRARY, "%s: LAPACK is %.1e off the solution", name,
                         off / scale);
out:
    free(sum);
    return st;
}

/* Opens the net of a row with both factors. */
static enum status make(struct bench *b, const struct bench_row *row, struct baseline *m,
                        struct message *why)
{
    struct model_size size;
    enum status st;

    TRY(bench_part_add(b, row, why));
    const struct run_plan *plan = &b->batch.cases[b->batch.count - 1].plan;
    TRY(run_open(&m->ours, plan, why));
    settings_set(batch_settings(&b->batch), "discretization.solver=cholmod");
    TRY(run_open(&m->theirs, plan, why));
    m->theirs.model->size(m->theirs.state, &size);
    if (strcmp(size.solver, "cholmod") != 0)
        TRY(status_fail(why, STATUS_LIBRARY, "%s: solved by %s, not by CHOLMOD", row->title,
                        size.solver));
    TRY(bench_solid_run(m->ours.state, BENCH_SOLID_ASSEMBLE));
    TRY(bench_solid_run(m->theirs.state, BENCH_SOLID_ASSEMBLE));
    TRY(bench_solid_matrix(m->ours.state, &m->n, &m->start, &m->row, &m->value));
    if (m->n < BAND_MOST)
        TRY(make_band(m, row->title, why));
out:
    return st;
}

static enum status sample(struct bench *b, struct message *why)
{
    struct baseline made[NETS] = {{{0}}};
    struct samples_task tasks[NETS * TASKS];
    enum status st = STATUS_OK;
    int count = 0;

    for (int n = 0; n < (b->quick ? NETS - 1 : NETS); n++) { /* the last is large */
        const struct bench_row *row = &bench_part_solids.rows[n];
        struct baseline *m = &made[n];
        const struct samples_task own[TASKS] = {
            {row->title, "factor ours", run_factor, NULL, &m->ours},
            {row->title, "solve ours", run_solve, NULL, &m->ours},
            {row->title, "factor CHOLMOD", run_factor, NULL, &m->theirs},
            {row->title, "solve CHOLMOD", run_solve, NULL, &m->theirs},
            {row->title, "factor LAPACK", band_factor, fill_band, m},
            {row->title, "solve LAPACK", band_solve, fill_ones, m}};
        TRY(make(b, row, m, why));
        for (int k = 0; k < (m->band ? TASKS : TASKS - 2); k++)
            tasks[count++] = own[k];
    }
    TRY(samples_time(&b->samples, b->quick, count, tasks));
out:
    for (int n = 0; n < NETS; n++)
        clear(&made[n]);
    return st;
}

static void add_ratio(struct table *t, const struct bench *b, const char *net,
                      const char *phase, const char *library)
{
    char theirs[SAMPLES_NAME], ours[SAMPLES_NAME];

    snprintf(theirs, sizeof theirs, "%s %s", phase, library);
    snprintf(ours, sizeof ours, "%s ours", phase);
    const double a = samples_number(&b->samples, net, theirs);
    const double o = samples_number(&b->samples, net, ours);
    table_add(t, "%.3g|%.3g|%.3g", 1e3 * a, 1e3 * o, a / o);
}

static enum status print(const struct bench *b, struct message *why)
{
    (void)why;
    static const struct table_column columns[] = {{"case", NULL, TABLE_LEFT},
                                                  {"baseline", NULL, TABLE_LEFT},
                                                  {"factor", "ms"},
                                                  {"ours", "ms", .key = "our_factor_ms"},
                                                  {"ratio", .key = "factor_ratio"},
                                                  {"solve", "ms"},
                                                  {"ours", "ms", .key = "our_solve_ms"},
                                                  {"ratio", .key = "solve_ratio"},
                                                  {"repeats"}};
    static const char *const library[] = {"CHOLMOD", "LAPACK"};
    struct table *t =
        TABLE_OF(columns, "The same matrices by libraries as they come, in this run");

    for (int n = 0; n < NETS; n++)
        for (int k = 0; k < 2; k++) {
            const char *net = bench_part_solids.rows[n].title;
            if (!samples_of(&b->samples, net, k ? "factor LAPACK" : "factor CHOLMOD").count)
                continue;
            table_line(t, "%s|%s%s", net, library[k], k ? " band" : "");
            add_ratio(t, b, net, "factor", library[k]);
            add_ratio(t, b, net, "solve", library[k]);
            table_add(t, "%d", samples_of(&b->samples, net, "factor ours").count);
        }
    table_note(t,
               "CHOLMOD with its defaults, analysis not counted; LAPACK dpbtrf and "
               "dpbtrs in natural order. Our factor and CHOLMOD's include filling in the "
               "numbers.");
    return table_finish(t, b->format, b->file);
}

const struct bench_part bench_part_baselines = {
    .item = {"baselines", "the same matrices by CHOLMOD and LAPACK as they come"},
    .sample = sample,
    .print = print};

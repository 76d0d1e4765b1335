/* Times the linear algebra of a frame with libraries used as they come, in turn with ours
 * on the same numbers: named baselines for speed ratios. */
#include <cholmod.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/bench_solid.h"
#include "bench/speed/bench.h"

/* A net's matrix, lower triangle by columns, and the libraries' factors and solutions. */
struct baseline {
    struct run run;
    int n, width; /* unknowns, half bandwidth                                          */
    long *start;
    int *row;
    double *value, *band, *x; /* band and x: LAPACK's; NULL: too large                 */
    cholmod_common common;
    cholmod_sparse *copy;
    cholmod_dense *one;
    cholmod_factor *L;
};

static void clear(struct baseline *m)
{
    if (m->common.itype || m->L) {
        cholmod_free_factor(&m->L, &m->common);
        cholmod_free_dense(&m->one, &m->common);
        cholmod_free_sparse(&m->copy, &m->common);
        cholmod_finish(&m->common);
    }
    free(m->start);
    free(m->row);
    free(m->value);
    free(m->band);
    free(m->x);
    run_close(&m->run);
}

static enum status our_factor(void *made)
{
    struct baseline *m = made;

    return bench_solid_run(m->run.state, BENCH_SOLID_FACTOR);
}

static enum status our_solve(void *made)
{
    struct baseline *m = made;

    return bench_solid_run(m->run.state, BENCH_SOLID_SOLVE);
}

static enum status their_factor(void *made)
{
    struct baseline *m = made;
    const bool good = cholmod_factorize(m->copy, m->L, &m->common);

    return good && m->L->minor == m->L->n ? STATUS_OK : STATUS_INDEFINITE;
}

static enum status their_solve(void *made)
{
    struct baseline *m = made;
    cholmod_dense *x = cholmod_solve(CHOLMOD_A, m->L, m->one, &m->common);

    cholmod_free_dense(&x, &m->common);
    return STATUS_OK;
}

/* Fills the band before each factorization; not timed. */
static void fill_band(void *made)
{
    struct baseline *m = made;
    const size_t rows = (size_t)m->width + 1;

    memset(m->band, 0, (size_t)m->n * rows * sizeof *m->band);
    for (int j = 0; j < m->n; j++)
        for (long t = m->start[j]; t < m->start[j + 1]; t++)
            m->band[(size_t)j * rows + (size_t)(m->row[t] - j)] = m->value[t];
}

/* Sets the right-hand side of ones before each solve; not timed. */
static void fill_ones(void *made)
{
    struct baseline *m = made;
    for (int j = 0; j < m->n; j++)
        m->x[j] = 1;
}

static enum status band_factor(void *made)
{
    struct baseline *m = made;

    return LAPACKE_dpbtrf_work(LAPACK_COL_MAJOR, 'L', m->n, m->width, m->band, m->width + 1)
               ? STATUS_INDEFINITE
               : STATUS_OK;
}

static enum status band_solve(void *made)
{
    struct baseline *m = made;

    return LAPACKE_dpbtrs_work(LAPACK_COL_MAJOR, 'L', m->n, m->width, 1, m->band,
                               m->width + 1, m->x, m->n)
               ? STATUS_INDEFINITE
               : STATUS_OK;
}

/* The phases in their order: each factorization comes before its solve. */
static const struct phase {
    const char *what;
    enum status (*call)(void *made);
    void (*prepare)(void *made);
} phases[] = {
    {"factor ours", our_factor, NULL},         {"solve ours", our_solve, NULL},
    {"factor CHOLMOD", their_factor, NULL},    {"solve CHOLMOD", their_solve, NULL},
    {"factor LAPACK", band_factor, fill_band}, {"solve LAPACK", band_solve, fill_ones}};
enum { PHASES = sizeof phases / sizeof *phases, LAPACK = 4, NETS = 4 };

static enum status make_cholmod(struct baseline *m)
{
    const size_t n = (size_t)m->n, entries = (size_t)m->start[m->n];

    cholmod_start(&m->common);
    m->copy =
        cholmod_allocate_sparse(n, n, entries, true, true, -1, CHOLMOD_REAL, &m->common);
    m->one = cholmod_ones(n, 1, CHOLMOD_REAL, &m->common);
    if (!m->copy || !m->one)
        return STATUS_MEMORY;
    for (int j = 0; j <= m->n; j++)
        ((int *)m->copy->p)[j] = (int)m->start[j];
    memcpy(m->copy->i, m->row, entries * sizeof *m->row);
    memcpy(m->copy->x, m->value, entries * sizeof *m->value);
    m->L = cholmod_analyze(m->copy, &m->common);
    return m->L ? STATUS_OK : STATUS_MEMORY;
}

/* The most unknowns for a band matrix: that of a large net would take 7 GB. */
static const int BAND_MOST = 10000;

static enum status make_band(struct baseline *m)
{
    for (int j = 0; j < m->n; j++) /* rows of a column ascend */
        m->width = (int)fmax(m->width, m->row[m->start[j + 1] - 1] - j);
    m->band = malloc((size_t)m->n * ((size_t)m->width + 1) * sizeof *m->band);
    m->x = malloc((size_t)m->n * sizeof *m->x);
    return m->band && m->x ? STATUS_OK : STATUS_MEMORY;
}

static enum status make(const struct run_plan *plan, struct baseline *m,
                        struct message *why)
{
    enum status st;

    TRY(run_open(&m->run, plan, why));
    TRY(bench_solid_run(m->run.state, BENCH_SOLID_ASSEMBLE));
    TRY(bench_solid_matrix(m->run.state, &m->n, &m->start, &m->row, &m->value));
    TRY(make_cholmod(m));
    if (m->n < BAND_MOST)
        TRY(make_band(m));
out:
    return st;
}

/* Returns the largest |A x - 1| over the largest sum of |A| |x|; NaN without memory. */
static double residual(const struct baseline *m, const double *x)
{
    double *sum = calloc(2 * (size_t)m->n, sizeof *sum), *size = sum + m->n;
    double most = sum ? 0 : NAN, scale = 0;

    for (int j = 0; sum && j < m->n; j++)
        for (long t = m->start[j]; t < m->start[j + 1]; t++) {
            const int i = m->row[t];
            sum[i] += m->value[t] * x[j];
            size[i] += fabs(m->value[t] * x[j]);
            if (i == j)
                continue;
            sum[j] += m->value[t] * x[i];
            size[j] += fabs(m->value[t] * x[i]);
        }
    for (int i = 0; sum && i < m->n; i++) {
        most = fmax(most, fabs(sum[i] - 1));
        scale = fmax(scale, size[i]);
    }
    free(sum);
    return most / scale;
}

/* Measures the libraries' residuals for a right-hand side of ones; LAPACK's is 0 if left
 * out. */
static enum status solve_once(struct baseline *m, double off[2])
{
    cholmod_dense *x = NULL;
    enum status st;

    off[1] = 0;
    TRY(their_factor(m));
    x = cholmod_solve(CHOLMOD_A, m->L, m->one, &m->common);
    TRY(x ? STATUS_OK : STATUS_MEMORY);
    off[0] = residual(m, x->x);
    if (m->band) {
        fill_band(m);
        fill_ones(m);
        TRY(band_factor(m));
        TRY(band_solve(m));
        off[1] = residual(m, m->x);
    }
out:
    cholmod_free_dense(&x, &m->common);
    return st;
}

enum status bench_baseline_check(const struct run_plan *plan, double off[2],
                                 struct message *why)
{
    struct baseline m = {{0}};
    enum status st;

    TRY(make(plan, &m, why));
    TRY(solve_once(&m, off));
out:
    clear(&m);
    return st;
}

/* A solution's residual must be below this, which is above round-off; a larger one means
 * that the baseline solved another matrix. */
static const double SOLVED = 1e-10;

static enum status check(struct baseline *m, const char *name, struct message *why)
{
    double off[2];
    const enum status st = solve_once(m, off);

    if (st == STATUS_OK && !(off[0] < SOLVED && off[1] < SOLVED))
        return status_fail(why, STATUS_LIBRARY,
                           "%s: CHOLMOD is %.1e off the solution, LAPACK %.1e", name,
                           off[0], off[1]);
    return st;
}

static enum status sample(struct bench *b, struct message *why)
{
    struct baseline made[NETS] = {{{0}}};
    struct samples_task tasks[NETS * PHASES];
    enum status st = STATUS_OK;
    int count = 0;

    for (int n = 0; n < (b->quick ? NETS - 1 : NETS); n++) { /* the last is large */
        const struct bench_row *row = &bench_part_solids.rows[n];
        TRY(bench_part_add(b, row, why));
        TRY(make(&b->batch.cases[n].plan, &made[n], why));
        TRY(check(&made[n], row->title, why));
        for (int p = 0; p < (made[n].band ? PHASES : LAPACK); p++)
            tasks[count++] = (struct samples_task){
                row->title, phases[p].what, phases[p].call, phases[p].prepare, &made[n]};
    }
    TRY(samples_time(&b->samples, b->quick, count, tasks));
out:
    for (int n = 0; n < NETS; n++)
        clear(&made[n]);
    return st;
}

static void ratio_cells(struct table *t, const struct bench *b, const char *net,
                        const char *phase, const char *library)
{
    char theirs[SAMPLES_NAME], ours[SAMPLES_NAME];

    snprintf(theirs, sizeof theirs, "%s %s", phase, library);
    snprintf(ours, sizeof ours, "%s ours", phase);
    const double a = samples_number(&b->samples, net, theirs);
    const double o = samples_number(&b->samples, net, ours);
    table_number(t, 1e3 * a, 3);
    table_number(t, 1e3 * o, 3);
    table_number(t, a / o, 3);
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
        table_create(sizeof columns / sizeof *columns, columns,
                     "The same matrices by libraries as they come, in this run");

    for (int n = 0; n < NETS; n++)
        for (int k = 0; k < 2; k++) {
            const char *net = bench_part_solids.rows[n].title;
            if (!samples_of(&b->samples, net, k ? "factor LAPACK" : "factor CHOLMOD").count)
                continue;
            table_row(t);
            table_text(t, "%s", net);
            table_text(t, "%s%s", library[k], k ? " band" : "");
            ratio_cells(t, b, net, "factor", library[k]);
            ratio_cells(t, b, net, "solve", library[k]);
            table_integer(t, samples_of(&b->samples, net, "factor ours").count);
        }
    table_note(t, "CHOLMOD with its defaults, analysis not counted; LAPACK dpbtrf and "
                  "dpbtrs in natural order. Our factor includes filling in the numbers.");
    return table_finish(t, b->format, b->file);
}

const struct bench_part bench_part_baselines = {
    .item = {"baselines", "the same matrices by CHOLMOD and LAPACK as they come"},
    .sample = sample,
    .print = print};

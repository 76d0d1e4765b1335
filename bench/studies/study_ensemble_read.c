#include "bench/studies/study_ensemble.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/store.h"
#include "bench/harness/run_result.h"
#include "bench/truth/truth_level.h"
#include "models/grid.h"
#include "models/metric/metric.h"

enum { FIELD = 3 * GRID_POINTS };

void study_ensemble_clear(struct study_ensemble *e)
{
    for (int n = 0; n < e->count; n++)
        free(e->one[n].value);
    free(e->time);
    *e = (struct study_ensemble){0};
}

double *study_ensemble_values(const struct study_ensemble *e,
                              const struct study_ensemble_one *one, int number, int look)
{
    return one->value +
           ((size_t)number * (size_t)e->looks + (size_t)look) * (size_t)one->lived;
}

/* The path of a number in a run's file. */
static void path_of(int number, char path[64])
{
    snprintf(path, 64, "%s/%s", number == STUDY_ENSEMBLE_KINETIC ? "energy" : "metrics",
             study_ensemble_name[number]);
}

/* The looks' times, of the first run that is read. */
static enum status read_times(const struct store_read *file, struct study_ensemble *e,
                              struct message *why)
{
    int columns;

    return e->time ? STATUS_OK
                   : store_read_array(file, "time", &e->time, &e->looks, &columns, why);
}

/* Numbers of a run that lived, at the end of what is there. */
static enum status read_numbers(const char *path, struct study_ensemble *e,
                                struct study_ensemble_one *one, int member,
                                struct message *why)
{
    struct store_read *file = NULL;
    double *value = NULL;
    char name[64];
    int rows, columns;
    enum status st;

    TRY(store_read_open(path, &file, why));
    TRY(read_times(file, e, why));
    if (!one->value)
        one->value = calloc((size_t)(STUDY_ENSEMBLE_NUMBERS * e->looks * one->lived),
                            sizeof *one->value);
    TRY(one->value ? STATUS_OK : STATUS_MEMORY);
    for (int n = 0; n < STUDY_ENSEMBLE_NUMBERS; n++) {
        path_of(n, name);
        free(value), value = NULL;
        TRY(store_read_array(file, name, &value, &rows, &columns, why));
        if (rows != e->looks)
            TRY(status_fail(why, STATUS_INPUT, "%s: %d looks where others have %d", path,
                            rows, e->looks));
        for (int t = 0; t < rows; t++)
            study_ensemble_values(e, one, n, t)[member] = value[t];
    }
out:
    free(value);
    store_read_close(file);
    return st;
}

/* Sums of a run's fields, less those of the first run, and of their squares. */
struct sums {
    double *first, *sum, *squares; /* [fields][FIELD], of squares [fields]; owned        */
};

static enum status add_fields(const struct run_result *r, int fields, struct sums *s)
{
    for (int t = 0; t < fields; t++) {
        double *first = s->first + (size_t)t * FIELD, *sum = s->sum + (size_t)t * FIELD;
        if (!isfinite(s->squares[t])) {
            memcpy(first, r->xyz[t], FIELD * sizeof *first);
            s->squares[t] = 0;
        }
        for (int n = 0; n < FIELD; n++) {
            const double by = r->xyz[t][n] - first[n];
            sum[n] += by;
            s->squares[t] += by * by;
        }
    }
    return STATUS_OK;
}

/* The sums become the mean positions; how far the runs are spread about them [m], rms over
 * the grid: NaN of one run. */
static void reduce_fields(struct sums *s, int fields, int count, double *spread)
{
    for (int t = 0; t < fields; t++) {
        double *first = s->first + (size_t)t * FIELD, *sum = s->sum + (size_t)t * FIELD;
        double squares = s->squares[t];
        for (int n = 0; n < FIELD; n++) {
            squares -= sum[n] * sum[n] / count;
            sum[n] = first[n] + sum[n] / count;
        }
        spread[t] = count > 1 ? sqrt(fmax(squares, 0) / (count - 1) / GRID_POINTS) : NAN;
    }
}

static enum status sums_init(struct sums *s, int fields)
{
    s->first = calloc((size_t)fields * FIELD, sizeof(double));
    s->sum = calloc((size_t)fields * FIELD, sizeof(double));
    s->squares = malloc((size_t)fields * sizeof(double));
    if (!s->first || !s->sum || !s->squares)
        return STATUS_MEMORY;
    for (int t = 0; t < fields; t++)
        s->squares[t] = INFINITY;
    return STATUS_OK;
}

static void sums_clear(struct sums *s)
{
    free(s->first);
    free(s->sum);
    free(s->squares);
}

/* Who lived, and what the first of the others died of. */
static enum status read_ends(const struct study_ensemble_job *job, int scene, int ensemble,
                             struct study_ensemble_one *one, bool *lived,
                             struct message *why)
{
    char path[STUDY_ENSEMBLE_PATH];
    enum status st = STATUS_OK;

    for (int m = 0; m < job->scene[scene].runs; m++) {
        struct run_result r = {0};
        study_ensemble_file(job, scene, ensemble, m, path);
        TRY(run_result_read(path, false, &r, why));
        lived[m] = r.outcome == STATUS_OK;
        one->lived += lived[m];
        if (!lived[m] && !one->died++)
            one->sentence = r.sentence;
        run_result_clear(&r);
    }
out:
    return st;
}

/* Numbers and fields of those who lived; `truth` is NULL for the truth itself. */
static enum status read_one(const struct study_ensemble_job *job, int scene, int ensemble,
                            const double *truth, double length, struct study_ensemble *e,
                            struct sums *s, struct message *why)
{
    struct study_ensemble_one *one = &e->one[ensemble];
    bool *lived = calloc((size_t)job->scene[scene].runs, sizeof *lived);
    struct run_result r = {0};
    char path[STUDY_ENSEMBLE_PATH];
    int count = 0;
    enum status st;

    TRY(lived ? STATUS_OK : STATUS_MEMORY);
    TRY(sums_init(s, STUDY_ENSEMBLE_FIELDS));
    TRY(read_ends(job, scene, ensemble, one, lived, why));
    for (int m = 0; m < job->scene[scene].runs; m++) {
        if (!lived[m])
            continue;
        study_ensemble_file(job, scene, ensemble, m, path);
        run_result_clear(&r);
        TRY(run_result_read(path, true, &r, why));
        if (!e->fields)
            memcpy(e->field_time, r.time, (size_t)(e->fields = r.frames) * sizeof *r.time);
        if (r.frames != e->fields)
            TRY(status_fail(why, STATUS_INPUT, "%s: %d fields where others have %d", path,
                            r.frames, e->fields));
        TRY(read_numbers(path, e, one, count++, why));
        TRY(add_fields(&r, e->fields, s));
    }
    reduce_fields(s, count ? e->fields : 0, count, one->growth);
    for (int t = 0; t < STUDY_ENSEMBLE_FIELDS; t++) {
        const size_t at = (size_t)t * FIELD;
        const bool known = count && truth && t < e->fields;
        one->growth[t] = count ? one->growth[t] / (TRUTH_PERTURBATION * length) : NAN;
        one->points[t] = known ? metric_rmse(s->sum + at, truth + at) / length : NAN;
    }
out:
    run_result_clear(&r);
    free(lived);
    return st;
}

static enum status name_one(const struct study_ensemble_job *job, int scene, int ensemble,
                            struct study_ensemble *e, double *length, struct message *why)
{
    struct study_ensemble_one *one = &e->one[ensemble];
    struct settings settings = {0};
    struct run run = {0};
    struct run_plan plan = {job->scene[scene].path, NULL, &settings, 0};
    enum status st;

    TRY(study_ensemble_settings(job, scene, ensemble, 0, &plan.contestant, &settings, why));
    TRY(run_read(&run, &plan, why));
    const int *points = run.discretization.points;
    snprintf(one->net, sizeof one->net, "%dx%d", points[0], points[1]);
    snprintf(one->title, sizeof one->title, "%s%s",
             ensemble < STUDY_ENSEMBLE_TRUTHS ? "truth: " : "", plan.contestant->title);
    *length = run.scene.length;
out:
    run_close(&run);
    settings_clear(&settings);
    return st;
}

enum status study_ensemble_read(const struct study_ensemble_job *job, int scene,
                                struct study_ensemble *e, struct message *why)
{
    struct sums fine = {0}, s = {0};
    double length;
    enum status st;

    *e = (struct study_ensemble){.quick = job->quick,
                                 .runs = job->scene[scene].runs,
                                 .count = STUDY_ENSEMBLE_TRUTHS + job->models};
    snprintf(e->name, sizeof e->name, "%s", job->scene[scene].name);
    for (int n = 0; n < e->count; n++)
        TRY(name_one(job, scene, n, e, &length, why));
    /* The truth first: all others are held against it. */
    TRY(read_one(job, scene, STUDY_ENSEMBLE_FINE, NULL, length, e, &fine, why));
    for (int n = 0; n < e->count; n++) {
        if (n == STUDY_ENSEMBLE_FINE)
            continue;
        st = read_one(job, scene, n, e->one[STUDY_ENSEMBLE_FINE].lived ? fine.sum : NULL,
                      length, e, &s, why);
        sums_clear(&s);
        s = (struct sums){0};
        TRY(st);
    }
out:
    sums_clear(&fine);
    sums_clear(&s);
    if (st != STATUS_OK)
        study_ensemble_clear(e);
    return st;
}

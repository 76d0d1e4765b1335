#include "bench/harness/run_result.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/store_scene.h"
#include "bench/harness/looks.h"
#include "models/grid.h"

static enum status find_outcome(const char *text, const char *path, enum status *outcome,
                                struct message *why)
{
#define RUN_OUTCOME(code, sentence) STATUS_##code,
    static const enum status all[] = {STATUS_LIST(RUN_OUTCOME)};
#undef RUN_OUTCOME

    for (size_t n = 0; n < sizeof all / sizeof *all; n++)
        if (!strcmp(text, status_text(all[n]))) {
            *outcome = all[n];
            return STATUS_OK;
        }
    if (!strcmp(text, STORE_NOT_ARRIVED))
        return STATUS_OK;
    return status_fail(why, STATUS_INPUT, "%s: unknown outcome '%.100s'", path, text);
}

/* Reads an array of as many numbers as there are looks into value[], every `stride`-th. */
static enum status read_numbers(struct store_read *file, const char *path, const char *name,
                                int count, int stride, double *value, struct message *why)
{
    double *array;
    int rows, columns;

    CALL(store_read_array(file, name, &array, &rows, &columns, why));
    if (rows != count || columns != 1)
        return status_fail(why, STATUS_INPUT, "%s: %s has %d numbers for %d looks", path,
                           name, rows * columns, count);
    for (int n = 0; n < count; n++)
        value[n * stride] = array[n];
    return STATUS_OK;
}

static enum status read_looks(struct store_read *file, const char *path, struct looks *l,
                              struct message *why)
{
    double *time;
    char name[64];
    int count, columns;

    CALL(store_read_array(file, "time", &time, &count, &columns, why));
    looks_init(l, count);
    l->count = count;
    CALL(read_numbers(file, path, "time", count, 1, l->time, why));
    for (int n = 0; n < LOOKS_SERIES; n++) {
        snprintf(name, sizeof name, "metrics/%s", looks_series[n].name);
        for (int k = 0; k < count; k++)
            l->series[n][k] = NAN;
        if (n != LOOKS_REACTION || store_read_has(file, name)) /* older files lack it */
            CALL(read_numbers(file, path, name, count, 1, l->series[n], why));
    }
    CALL(read_numbers(file, path, "energy/kinetic", count, 3, &l->energy->kinetic, why));
    CALL(read_numbers(file, path, "energy/elastic", count, 3, &l->energy->elastic, why));
    return read_numbers(file, path, "energy/potential", count, 3, &l->energy->potential,
                        why);
}

/* Reads the measures of the truth, where the file has distances to one (looks_truth). */
static enum status read_truth(struct store_read *file, const char *path, int looks,
                              double *value, struct message *why)
{
    double *number[LOOKS_TRUTH];
    char name[64];
    int rows, columns;

    for (int n = 0; n < LOOKS_TRUTH; n++) {
        snprintf(name, sizeof name, "metrics/%s", looks_truth[n]);
        if (!store_read_has(file, name))
            return STATUS_OK;
        CALL(store_read_array(file, name, &number[n], &rows, &columns, why));
        CALL(read_numbers(file, path, name, looks, 1, number[n], why));
    }
    looks_reduce_truth(looks, number[LOOKS_TRUTH_ERROR], number[LOOKS_TRUTH_BAR], value);
    return STATUS_OK;
}

/* Reads an array of seconds, if it is there: the summary, over the repeats, of each one's
 * mean over its steps (a death leaves some out); the first repeat's sum and number of
 * steps. */
static enum status read_seconds(struct store_read *file, const char *name,
                                struct clock_summary *summary, double *sum, long *steps,
                                struct message *why)
{
    double *seconds, total = 0;
    int rows, columns, repeats = 0;

    if (!store_read_has(file, name))
        return STATUS_OK;
    CALL(store_read_array(file, name, &seconds, &rows, &columns, why));
    for (int r = 0; r < rows; r++) {
        double mean = 0;
        int count = 0;
        for (int n = 0; n < columns; n++)
            if (!isnan(seconds[r * columns + n])) {
                mean += seconds[r * columns + n];
                count++;
            }
        if (r == 0 && sum)
            *sum += mean;
        if (r == 0 && steps)
            *steps = count;
        total = count ? mean / count : NAN;
        if (count)
            seconds[repeats++] = total;
    }
    if (repeats && summary) {
        *summary = clock_summarise(seconds, repeats);
        CALL(summary->count ? STATUS_OK : STATUS_MEMORY);
    }
    return STATUS_OK;
}

static enum status read_times(struct store_read *file, struct run_result *r,
                              struct message *why)
{
    static const char *const phase[RUN_RESULT_PHASES] = {"seconds/assemble",
                                                         "seconds/factor", "seconds/solve"};
    double all = 0, ours = 0;

    CALL(read_seconds(file, "seconds/timed", NULL, &all, NULL, why));
    CALL(read_seconds(file, "seconds/processor", NULL, &ours, NULL, why));
    r->processor = ours / all;
    CALL(read_seconds(file, "seconds/create", &r->create, &r->create_seconds, NULL, why));
    CALL(read_seconds(file, "seconds/advance", &r->step, &r->step_seconds, &r->steps, why));
    CALL(read_seconds(file, "seconds/equilibrium", &r->step, NULL, NULL, why));
    CALL(read_seconds(file, "seconds/look", NULL, &r->look_seconds, NULL, why));
    for (int p = 0; p < RUN_RESULT_PHASES; p++)
        CALL(read_seconds(file, phase[p], &r->phase[p], NULL, NULL, why));
    return STATUS_OK;
}

/* Returns a count from a file; 0: it is none. */
static long count_of(double value)
{
    return fabs(value) < 1e15 ? lround(value) : 0;
}

/* Reads the work up to the last look. */
static enum status read_work(struct store_read *file, struct counters *work,
                             struct message *why)
{
    const struct {
        const char *name;
        long *count; /* NULL: of `left` */
    } counters[] = {{"counters/steps", &work->steps},
                    {"counters/assemblies", &work->assemblies},
                    {"counters/factorisations", &work->factorisations},
                    {"counters/solves", &work->solves},
                    {"counters/iterations", &work->iterations},
                    {"counters/substeps", &work->substeps},
                    {"counters/tested", &work->tested},
                    {"counters/missed", &work->missed},
                    {"counters/left", NULL}};

    for (size_t n = 0; n < sizeof counters / sizeof *counters; n++) {
        double *value;
        int rows, columns;
        CALL(store_read_array(file, counters[n].name, &value, &rows, &columns, why));
        const double last = rows && isfinite(value[rows - 1]) ? value[rows - 1] : 0;
        if (counters[n].count)
            *counters[n].count = count_of(last);
        else
            work->left = last;
    }
    return STATUS_OK;
}

static enum status read_fields(struct store_read *file, const char *path, bool fields,
                               struct run_result *r, struct message *why)
{
    int times, columns;
    double *time;

    CALL(store_read_array(file, "xyz_time", &time, &times, &columns, why));
    r->frames = store_read_frames(file);
    if (times != r->frames)
        return status_fail(why, STATUS_INPUT, "%s: has %d fields at %d times", path,
                           r->frames, times);
    r->time = arena_take(&r->arena, (size_t)times, sizeof *time);
    memcpy(r->time, time, (size_t)times * sizeof *time);
    if (!fields)
        return STATUS_OK;
    r->xyz = arena_take(&r->arena, (size_t)r->frames, sizeof *r->xyz);
    for (int n = 0; n < r->frames; n++) {
        r->xyz[n] = arena_take(&r->arena, 3 * GRID_POINTS, sizeof **r->xyz);
        CALL(store_read_frame(file, n, r->xyz[n], why));
    }
    return STATUS_OK;
}

bool run_result_refused(const struct run_result *r)
{
    return r->outcome == STATUS_UNSUPPORTED || r->outcome == STATUS_INPUT;
}

bool run_result_missed(const struct run_result *r)
{
    return r->outcome == STATUS_OK && r->work.missed > 0;
}

void run_result_tell(struct run_result *r, const char *refusal)
{
    if (status_is_death(r->outcome))
        status_fail(&r->sentence, r->outcome, "died at t = %.6g s: %s", r->death_time,
                    status_text(r->outcome));
    else if (run_result_missed(r))
        status_fail(&r->sentence, STATUS_OK,
                    STORE_NOT_ARRIVED ": the iterations of %ld steps left up to %.2g %% of "
                                      "the loads at their limit",
                    r->work.missed, 100 * r->work.left);
    else
        status_fail(&r->sentence, r->outcome, "%s", r->outcome ? refusal : "done");
}

/* Reads a text that not every file has. */
static void read_extra(struct store_read *file, const char *key, char *text, size_t size)
{
    char *whole;

    if (store_read_text(file, "/", key, &whole, NULL) == STATUS_OK)
        snprintf(text, size, "%s", whole);
}

static enum status read_end(struct store_read *file, const char *path, struct run_result *r,
                            struct message *why)
{
    char *outcome, *note = "", quick[8] = "";

    r->death_time = NAN;
    CALL(store_read_text(file, "/", "outcome", &outcome, why));
    CALL(find_outcome(outcome, path, &r->outcome, why));
    if (run_result_refused(r))
        CALL(store_read_text(file, "/", "note", &note, why));
    else if (r->outcome)
        CALL(store_read_number(file, "death_time", &r->death_time, why));
    run_result_tell(r, note);
    read_extra(file, "made_for", r->made_for, sizeof r->made_for);
    read_extra(file, "quick", quick, sizeof quick);
    r->quick = *quick;
    read_extra(file, "distrust", r->distrust.text, sizeof r->distrust.text);
    return STATUS_OK;
}

/* Reads what of its numerics a table shows. */
static enum status read_numerics(struct store_read *file, const char *path,
                                 struct run_result *r, struct message *why)
{
    char *text;
    const char *points;

    CALL(store_read_text(file, "/", "discretization", &text, why));
    points = strstr(text, "discretization.points=");
    if (!points || sscanf(points, "discretization.points=[%d,%d,%d", &r->points[0],
                          &r->points[1], &r->points[2]) < 2)
        return status_fail(why, STATUS_INPUT, "%s: has no points", path);
    r->linear = strstr(text, "discretization.kinematics=linear\n");
    return STATUS_OK;
}

enum status run_result_read(const char *path, bool fields, struct run_result *result,
                            struct message *why)
{
    struct run_result r SCOPED(run_result_clear) = {0};
    struct looks looks SCOPED(looks_clear) = {0};
    struct store_read *file SCOPED(store_read_close_scope) = NULL;

    CALL(store_read_open(path, &file, why));
    CALL(read_work(file, &r.work, why));
    CALL(read_end(file, path, &r, why));
    CALL(store_read_number(file, "unknowns", &r.unknowns, why));
    CALL(store_read_number(file, "factor_entries", &r.factor_entries, why));
    if (store_read_number(file, "model_bytes", &r.bytes, NULL) != STATUS_OK)
        r.bytes = NAN;
    CALL(store_scene(file, path, &r.scene, why));
    CALL(read_numerics(file, path, &r, why));
    CALL(read_looks(file, path, &looks, why));
    CALL(read_times(file, &r, why));
    looks_reduce(&looks, &r.scene, r.outcome, r.death_time, &r.work, r.value);
    CALL(read_truth(file, path, looks.count, r.value, why));
    CALL(read_fields(file, path, fields, &r, why));
    *result = r;
    r = (struct run_result){0};
    return STATUS_OK;
}

void run_result_clear(struct run_result *r)
{
    arena_clear(&r->arena);
    scene_clear(&r->scene);
    *r = (struct run_result){0};
}

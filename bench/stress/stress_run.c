#include "bench/stress/stress_run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/harness/child.h"
#include "bench/harness/derived_key.h"
#include "models/clock.h"
#include "models/grid.h"

enum { MOST_SETTINGS = 3 * STRESS_SETTINGS, SETTING = 256 };

/* Settings of case and model into all[MOST_SETTINGS]; text[SETTING] is for the net's. */
static int collect_settings(const struct stress_job *job, char *text, const char **all)
{
    const struct stress_case *c = job->c;
    const struct stress_model *m = job->model;
    const int side = c->side == 0 ? 10 : c->side == 1 ? m->least : c->side;
    int count = 0;

    for (int n = 0; n < STRESS_SETTINGS && c->physics[n]; n++)
        all[count++] = c->physics[n];
    if (job->quick && c->quick_end)
        all[count++] = c->quick_end;
    snprintf(text, SETTING, "discretization.points=[%d,%d%s]", side, side,
             m->layers ? ",2" : "");
    all[count++] = text;
    for (int n = 0; n < STRESS_SETTINGS && m->settings[n]; n++)
        all[count++] = m->settings[n];
    for (int n = 0; n < STRESS_SETTINGS && c->numerics[n]; n++)
        all[count++] = c->numerics[n];
    return count;
}

/* Every other row of control points weighs `ratio`. */
static enum status give_weights(struct discretization *d, double ratio)
{
    const int row = d->points[1] * (d->points[2] > 0 ? d->points[2] : 1);
    const int count = d->points[0] * row;

    d->weights = malloc((size_t)count * sizeof *d->weights);
    if (!d->weights)
        return STATUS_MEMORY;
    for (int n = 0; n < count; n++)
        d->weights[n] = n / row % 2 ? ratio : 1;
    d->weight_count = count;
    return STATUS_OK;
}

enum status stress_run_read(const struct stress_job *job, struct trial *t,
                            struct message *why)
{
    const struct stress_case *c = job->c;
    const char *settings[MOST_SETTINGS];
    char text[SETTING];
    const int count = collect_settings(job, text, settings);
    enum status st;

    TRY(trial_read(t, job->path, count, settings, job->model->model, why));
    if (c->gamma > 0)
        t->scene.young = derived_key_solve("gamma", "material.young", c->gamma, &t->scene);
    if (c->weight_ratio > 0)
        st = give_weights(&t->discretization, c->weight_ratio);
out:
    return st;
}

/* Leaves word of the time, for whoever finds out that it was the last. */
static enum status watch_time(void *context, const struct motion *m, struct message *why)
{
    struct stress_run *r = context;

    child_reached(m->time);
    return r->watch ? r->watch(context, m, why) : STATUS_OK;
}

enum status stress_run_move(struct stress_run *r, motion_watcher *watch,
                            struct message *why)
{
    const struct trial *t = &r->trial;
    struct motion m = {0};
    enum status st;

    TRY(motion_init(&m, t->model, &t->scene, t->state));
    r->watch = watch;
    TRY(motion_run(&m, watch_time, r, true, why));
    if (!m.death)
        goto out;
    r->result->time = m.death_time;
    st = status_fail(why, m.death, "%s", status_text(m.death));
out:
    motion_clear(&m);
    return st;
}

enum status stress_run_settle(struct stress_run *r, struct message *why)
{
    struct trial *t = &r->trial;
    struct counters counters = {0};
    enum status st;

    if (!t->model->equilibrium)
        return stress_run_move(r, NULL, why);
    st = t->model->equilibrium(t->state, &counters, why);
    if (status_is_death(st))
        r->result->time = 0;
    return st;
}

void stress_run_displacement(const struct stress_run *r, const double uvw[3], double d[3])
{
    const struct trial *t = &r->trial;
    double rest[3];

    t->model->probe(t->state, 1, uvw, d);
    scene_rest_point(&t->scene, uvw, rest);
    for (int i = 0; i < 3; i++)
        d[i] -= rest[i];
}

void stress_run_note(struct stress_run *r, double time, double error)
{
    struct stress_result *result = r->result;

    if (!(error <= r->job->c->bound) && !(result->error > r->job->c->bound))
        result->time = time;
    if (!(error <= result->error))
        result->error = error;
}

/* What a model makes of the case is the result, whatever it is. */
static enum status settle_result(enum status st, const struct message *said,
                                 struct stress_result *result, struct message *why)
{
    const char *text = *said->text ? said->text : status_text(st);

    if (st == STATUS_OK)
        return st;
    if (st == STATUS_FILE)
        return status_fail(why, st, "%s", text);
    result->outcome =
        st == STATUS_UNSUPPORTED || st == STATUS_INPUT ? STRESS_SAID_NO : STRESS_DEAD;
    result->error = NAN;
    snprintf(result->sentence.text, sizeof result->sentence.text, "%s", text);
    return STATUS_OK;
}

enum status stress_run(const struct stress_job *job, struct stress_result *result,
                       struct message *why)
{
    struct stress_run r = {.job = job, .result = result};
    struct message said = {""};
    const double start = clock_processor();
    enum status st;

    *result = (struct stress_result){.error = NAN, .time = NAN};
    r.xyz = malloc(3 * GRID_POINTS * sizeof *r.xyz);
    r.first = malloc(3 * GRID_POINTS * sizeof *r.first);
    TRY(r.xyz && r.first ? STATUS_OK : STATUS_MEMORY);
    TRY(stress_run_read(job, &r.trial, &said));
    TRY(trial_build(&r.trial, &said));
    st = stress_judge(&r, &said);
out:
    result->seconds = clock_processor() - start;
    kirchhoff_destroy(r.plate);
    truth_destroy(r.truth);
    trial_close(&r.trial);
    free(r.energies);
    free(r.xyz);
    free(r.first);
    return settle_result(st, &said, result, why);
}

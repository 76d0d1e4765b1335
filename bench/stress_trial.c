/* One model on one hard case: the run, and its error. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/child.h"
#include "bench/folder.h"
#include "bench/motion.h"
#include "bench/stand_in.h"
#include "bench/stress.h"
#include "bench/trial.h"
#include "fem_ref/elastica.h"
#include "fem_ref/kirchhoff_field.h"
#include "models/clock.h"
#include "models/grid.h"
#include "models/metric.h"

enum { MOST_SETTINGS = 3 * STRESS_SETTINGS, SETTING = 256 };

/* A job on its way. */
struct run {
    const struct stress_job *job;
    struct trial trial;
    struct stress_result *result;
    double *xyz, *first; /* fields (grid.h)                                      owned */
    struct kirchhoff *plate;
    double load; /* on it [N/m^2]                                                      */
    struct energy *energies; /* [frame_count + 1]                                owned */
    int frames;
    struct truth *truth;
    motion_watcher *watch;
};

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

/* The case's scene and numerics as read, E from Gamma. */
static enum status read(const struct stress_job *job, struct trial *t, struct message *why)
{
    const struct stress_case *c = job->c;
    const char *settings[MOST_SETTINGS];
    char text[SETTING];
    const int count = collect_settings(job, text, settings);
    enum status st;

    TRY(trial_read(t, job->path, count, settings, job->model->model, why));
    if (c->gamma > 0)
        t->scene.young = stand_in_solve("gamma", "material.young", c->gamma, &t->scene);
    if (c->weight_ratio > 0)
        st = give_weights(&t->discretization, c->weight_ratio);
out:
    return st;
}

/* Leaves word of the time, for whoever finds out that it was the last. */
static enum status watch_time(void *context, const struct motion *m, struct message *why)
{
    struct run *r = context;

    child_reached(m->time);
    return r->watch ? r->watch(context, m, why) : STATUS_OK;
}

/* Through the scene's motion; a death leaves its time and sentence. */
static enum status move(struct run *r, motion_watcher *watch, struct message *why)
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

/* To static equilibrium; by damped motion where the model has no other way. */
static enum status settle(struct run *r, struct message *why)
{
    struct trial *t = &r->trial;
    struct counters counters = {0};
    enum status st;

    if (!t->model->equilibrium)
        return move(r, NULL, why);
    st = t->model->equilibrium(t->state, &counters, why);
    if (status_is_death(st))
        r->result->time = 0;
    return st;
}

/* How far a material point has come from rest [m]. */
static void displacement(const struct run *r, const double uvw[3], double d[3])
{
    const struct trial *t = &r->trial;
    double rest[3];

    t->model->probe(t->state, 1, uvw, d);
    scene_rest_point(&t->scene, uvw, rest);
    for (int i = 0; i < 3; i++)
        d[i] -= rest[i];
}

static const double tip[3] = {1, 0.5, 0.5}, middle[3] = {0.5, 0.5, 0.5};

/* Functions a direction: 24 give statics to 1e-6. */
enum { TERMS = 24 };

static enum status make_plate(struct run *r, struct message *why)
{
    const struct scene *s = &r->trial.scene;
    const struct kirchhoff_plate plate = {s->length, s->width,   s->thickness,
                                          s->young,  s->poisson, s->density};
    enum status st = kirchhoff_create(&plate, TERMS, &r->plate);

    r->load = s->density * s->thickness * -s->gravity[2];
    return st == STATUS_OK ? st : status_fail(why, st, "%s", status_text(st));
}

static enum status judge_plate(struct run *r, struct message *why)
{
    const struct scene *s = &r->trial.scene;
    double d[3];
    enum status st;

    TRY(make_plate(r, why));
    TRY(settle(r, why));
    displacement(r, tip, d);
    r->result->error =
        fabs(-d[2] / kirchhoff_static(r->plate, r->load, s->length, s->width / 2) - 1);
out:
    return st;
}

static enum status judge_elastica(struct run *r, struct message *why)
{
    const struct scene *s = &r->trial.scene;
    struct elastica e;
    double d[3];
    enum status st;

    TRY(elastica_solve(scene_gamma(s), &e));
    TRY(settle(r, why));
    displacement(r, tip, d);
    r->result->error = hypot(d[0] / s->length + 1 - e.reach, d[2] / s->length + e.drop);
out:
    return st;
}

enum status stress_find_truth(const struct stress_job *job, enum truth_effort effort,
                              struct truth **truth, struct message *why)
{
    static const double time[] = {0.1, 0.2, 0.3};
    char folder[4096];
    int count = 0;

    while (count < STRESS_SETTINGS && job->c->physics[count])
        count++;
    snprintf(folder, sizeof folder, "%s/%s.truth", job->folder, job->c->name);
    const enum status st = effort == TRUTH_READ ? STATUS_OK : folder_make(folder, why);
    return st == STATUS_OK
               ? truth_find(job->path, count, job->c->physics, sizeof time / sizeof *time,
                            time, folder, effort, truth, why)
               : st;
}

/* The frame's error; the greatest is the run's, and the bound is kept until its first. */
static void note_error(struct run *r, double time, double error)
{
    struct stress_result *result = r->result;

    if (!(error <= r->job->c->bound) && !(result->error > r->job->c->bound))
        result->time = time;
    if (!(error <= result->error))
        result->error = error;
}

static enum status watch_vibration(void *context, const struct motion *m,
                                   struct message *why)
{
    struct run *r = context;
    const struct scene *s = &r->trial.scene;
    const double at = s->length, half = s->width / 2;
    double d[3];

    (void)why;
    displacement(r, tip, d);
    const double true_tip = kirchhoff_transient(r->plate, r->load, 0, m->time, at, half);
    const double greatest = 2 * kirchhoff_static(r->plate, r->load, at, half);
    note_error(r, m->time, fabs(-d[2] - true_tip) / greatest);
    return STATUS_OK;
}

static enum status judge_vibration(struct run *r, struct message *why)
{
    enum status st;

    r->result->error = 0;
    TRY(make_plate(r, why));
    st = move(r, watch_vibration, why);
out:
    return st;
}

/* The scene in units of `length` metres, `mass` kilograms and `time` seconds. */
static void change_units(struct scene *s, double length, double mass, double time)
{
    s->length /= length, s->width /= length, s->thickness /= length;
    s->young *= length * time * time / mass;
    s->density *= length * length * length / mass;
    for (int i = 0; i < 3; i++)
        s->gravity[i] *= time * time / length, s->origin[i] /= length;
    s->damping.value *= time;
    s->step /= time, s->end /= time;
}

static enum status judge_similar(struct run *r, struct message *why)
{
    const struct stress_case *c = r->job->c;
    struct run other = *r;
    enum status st;

    other.trial = (struct trial){0};
    TRY(move(r, NULL, why));
    r->trial.model->sample(r->trial.state, r->xyz);
    TRY(read(r->job, &other.trial, why));
    change_units(&other.trial.scene, c->length, c->mass, c->time);
    TRY(trial_build(&other.trial, why));
    TRY(move(&other, NULL, why));
    other.trial.model->sample(other.trial.state, r->first);
    for (size_t n = 0; n < 3 * GRID_POINTS; n++)
        r->first[n] *= c->length;
    r->result->error = metric_rmse(r->xyz, r->first) / r->trial.scene.length;
out:
    if (st != STATUS_OK && isfinite(r->result->time))
        r->result->time *= other.trial.state ? c->time : 1;
    trial_close(&other.trial);
    return st;
}

static enum status watch_energy(void *context, const struct motion *m, struct message *why)
{
    struct run *r = context;

    (void)why;
    if (!r->energies)
        r->energies = calloc((size_t)m->frame_count + 1, sizeof *r->energies);
    if (!r->energies)
        return STATUS_MEMORY;
    m->model->energy(m->state, &r->energies[r->frames++]);
    return STATUS_OK;
}

static enum status judge_energy(struct run *r, struct message *why)
{
    const struct trial *t = &r->trial;
    struct energy rest = {NAN, NAN, NAN};
    double *drift = NULL;
    enum status st;

    if (t->model->energy)
        t->model->energy(t->state, &rest);
    if (!isfinite(rest.elastic))
        return status_fail(why, STATUS_UNSUPPORTED,
                           "unsupported: no elastic energy that could be kept");
    TRY(move(r, watch_energy, why));
    drift = malloc((size_t)r->frames * sizeof *drift);
    TRY(drift ? STATUS_OK : STATUS_MEMORY);
    metric_energy_drift(r->frames, r->energies, drift);
    r->result->error = 0;
    double most = 0, least = 0;
    for (int n = 0; n < r->frames; n++) {
        note_error(r, n * t->scene.step, fabs(drift[n]));
        most = fmax(most, drift[n]), least = fmin(least, drift[n]);
    }
    snprintf(r->result->sentence.text, sizeof r->result->sentence.text,
             "%.2g won at most, %.2g lost at most, of the energy in play", most, -least);
out:
    free(drift);
    return st;
}

static enum status judge_buckled(struct run *r, struct message *why)
{
    const struct scene *s = &r->trial.scene;
    const struct scene_support *moved = &s->supports[s->support_count - 1];
    double d[3], shift[3];
    enum status st;

    scene_support_shift(moved, s->end, shift);
    TRY(move(r, NULL, why));
    displacement(r, middle, d);
    r->result->error =
        fabs(fabs(d[2]) / s->length - elastica_buckled(-shift[0] / s->length));
out:
    return st;
}

static enum status watch_still(void *context, const struct motion *m, struct message *why)
{
    struct run *r = context;

    (void)why;
    m->model->sample(m->state, m->frames ? r->xyz : r->first);
    if (m->frames)
        note_error(r, m->time, metric_rmse(r->xyz, r->first) / m->scene->length);
    return STATUS_OK;
}

static enum status judge_still(struct run *r, struct message *why)
{
    enum status st = STATUS_OK;

    if (r->job->c->truth == STRESS_STILL_REST) {
        if (!r->trial.model->equilibrium)
            return status_fail(why, STATUS_UNSUPPORTED,
                               "unsupported: no static equilibrium to start from");
        TRY(settle(r, why));
    }
    r->result->error = 0;
    st = move(r, watch_still, why);
out:
    return st;
}

static enum status judge_shifted(struct run *r, struct message *why)
{
    const struct scene *s = &r->trial.scene;
    double shift[3], uvw[3];
    enum status st;

    scene_support_shift(&s->supports[0], s->end, shift);
    TRY(move(r, NULL, why));
    r->trial.model->sample(r->trial.state, r->xyz);
    for (int n = 0; n < GRID_POINTS; n++) {
        grid_point(n, uvw);
        scene_rest_point(s, uvw, r->first + 3 * (size_t)n);
        for (int i = 0; i < 3; i++)
            r->first[3 * (size_t)n + (size_t)i] += shift[i];
    }
    r->result->error = metric_rmse(r->xyz, r->first) / s->length;
out:
    return st;
}

static enum status watch_shell(void *context, const struct motion *m, struct message *why)
{
    struct run *r = context;
    const struct truth *truth = r->truth;

    (void)why;
    for (int n = 0; n < truth->times; n++)
        if (fabs(m->time - truth->time[n]) < m->scene->step / 4) {
            m->model->sample(m->state, r->xyz);
            note_error(r, m->time, metric_rmse(r->xyz, truth->xyz[n]) / m->scene->length);
        }
    return STATUS_OK;
}

static enum status judge_shell(struct run *r, struct message *why)
{
    enum status st;

    TRY(stress_find_truth(r->job, TRUTH_READ, &r->truth, why));
    r->result->error = 0;
    TRY(move(r, watch_shell, why));
    snprintf(r->result->sentence.text, sizeof r->result->sentence.text,
             "the truth's error bar is %.2g",
             r->truth->error[r->truth->times - 1] / r->trial.scene.length);
out:
    return st;
}

static enum status judge(struct run *r, struct message *why)
{
    switch (r->job->c->truth) {
    case STRESS_PLATE:
        return judge_plate(r, why);
    case STRESS_ELASTICA:
        return judge_elastica(r, why);
    case STRESS_VIBRATION:
        return judge_vibration(r, why);
    case STRESS_SIMILAR:
        return judge_similar(r, why);
    case STRESS_ENERGY:
        return judge_energy(r, why);
    case STRESS_BUCKLED:
        return judge_buckled(r, why);
    case STRESS_STILL:
    case STRESS_STILL_REST:
        return judge_still(r, why);
    case STRESS_SHIFTED:
        return judge_shifted(r, why);
    case STRESS_SHELL:
        return judge_shell(r, why);
    case STRESS_TRUTHS:
        break;
    }
    return STATUS_LIBRARY;
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

enum status stress_trial(const struct stress_job *job, struct stress_result *result,
                         struct message *why)
{
    struct run r = {.job = job, .result = result};
    struct message said = {""};
    const double start = clock_processor();
    enum status st;

    *result = (struct stress_result){.error = NAN, .time = NAN};
    r.xyz = malloc(3 * GRID_POINTS * sizeof *r.xyz);
    r.first = malloc(3 * GRID_POINTS * sizeof *r.first);
    TRY(r.xyz && r.first ? STATUS_OK : STATUS_MEMORY);
    TRY(read(job, &r.trial, &said));
    TRY(trial_build(&r.trial, &said));
    st = judge(&r, &said);
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

/* The errors of hard cases. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/files/folder.h"
#include "bench/stress/stress.h"
#include "bench/stress/stress_run.h"
#include "fem_ref/elastica.h"
#include "models/clock.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

static const double tip[3] = {1, 0.5, 0.5}, middle[3] = {0.5, 0.5, 0.5};

/* Functions a direction: 24 give statics to 1e-6. */
enum { TERMS = 24 };

static enum status make_plate(struct stress_run *r, struct message *why)
{
    const struct scene *s = &r->run.scene;
    const struct kirchhoff_plate plate = {s->length, s->width,   s->thickness,
                                          s->young,  s->poisson, s->density};
    enum status st = kirchhoff_create(&plate, TERMS, &r->plate);

    r->load = s->density * s->thickness * -s->gravity[2];
    return st == STATUS_OK ? st : status_fail(why, st, "%s", status_text(st));
}

static enum status judge_plate(struct stress_run *r, struct message *why)
{
    const struct scene *s = &r->run.scene;
    double d[3];
    enum status st;

    TRY(make_plate(r, why));
    TRY(stress_run_settle(r, why));
    stress_run_displacement(r, tip, d);
    r->result->error =
        fabs(-d[2] / kirchhoff_static(r->plate, r->load, s->length, s->width / 2) - 1);
out:
    return st;
}

static enum status judge_elastica(struct stress_run *r, struct message *why)
{
    const struct scene *s = &r->run.scene;
    struct elastica e;
    double d[3];
    enum status st;

    TRY(elastica_solve(scene_gamma(s), &e));
    TRY(stress_run_settle(r, why));
    stress_run_displacement(r, tip, d);
    r->result->error = hypot(d[0] / s->length + 1 - e.reach, d[2] / s->length + e.drop);
out:
    return st;
}

static enum status watch_vibration(void *context, const struct motion *m,
                                   struct message *why)
{
    struct stress_run *r = context;
    const struct scene *s = &r->run.scene;
    const double at = s->length, half = s->width / 2;
    double d[3];

    (void)why;
    stress_run_displacement(r, tip, d);
    const double true_tip = kirchhoff_transient(r->plate, r->load, 0, m->time, at, half);
    const double greatest = 2 * kirchhoff_static(r->plate, r->load, at, half);
    stress_run_note(r, m->time, fabs(-d[2] - true_tip) / greatest);
    return STATUS_OK;
}

static enum status judge_vibration(struct stress_run *r, struct message *why)
{
    enum status st;

    r->result->error = 0;
    TRY(make_plate(r, why));
    st = stress_run_move(r, watch_vibration, why);
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

static enum status judge_similar(struct stress_run *r, struct message *why)
{
    const struct stress_case *c = r->job->c;
    struct stress_run other = *r;
    enum status st;

    other.run = (struct run){0};
    TRY(stress_run_move(r, NULL, why));
    r->run.model->sample(r->run.state, r->xyz);
    TRY(stress_run_read(r->job, &other.run, why));
    change_units(&other.run.scene, c->length, c->mass, c->time);
    TRY(run_build(&other.run, why));
    TRY(stress_run_move(&other, NULL, why));
    other.run.model->sample(other.run.state, r->first);
    for (size_t n = 0; n < 3 * GRID_POINTS; n++)
        r->first[n] *= c->length;
    r->result->error = metric_rmse(r->xyz, r->first) / r->run.scene.length;
out:
    if (st != STATUS_OK && isfinite(r->result->time))
        r->result->time *= other.run.state ? c->time : 1;
    run_close(&other.run);
    return st;
}

static enum status watch_energy(void *context, const struct motion *m, struct message *why)
{
    struct stress_run *r = context;

    (void)why;
    if (!r->energies)
        r->energies = calloc((size_t)m->frame_count + 1, sizeof *r->energies);
    if (!r->energies)
        return STATUS_MEMORY;
    m->model->energy(m->state, &r->energies[r->frames++]);
    return STATUS_OK;
}

static enum status judge_energy(struct stress_run *r, struct message *why)
{
    const struct run *run = &r->run;
    struct energy rest = {NAN, NAN, NAN};
    double *drift = NULL;
    enum status st;

    if (run->model->energy)
        run->model->energy(run->state, &rest);
    if (!isfinite(rest.elastic))
        return status_fail(why, STATUS_UNSUPPORTED,
                           "unsupported: no elastic energy that could be kept");
    TRY(stress_run_move(r, watch_energy, why));
    drift = malloc((size_t)r->frames * sizeof *drift);
    TRY(drift ? STATUS_OK : STATUS_MEMORY);
    metric_energy_drift(r->frames, r->energies, drift);
    r->result->error = 0;
    double most = 0, least = 0;
    for (int n = 0; n < r->frames; n++) {
        stress_run_note(r, n * run->scene.step, fabs(drift[n]));
        most = fmax(most, drift[n]), least = fmin(least, drift[n]);
    }
    snprintf(r->result->sentence.text, sizeof r->result->sentence.text,
             "%d steps: %.2g won at most, %.2g lost at most, of the energy in play",
             r->frames - 1, most, -least);
out:
    free(drift);
    return st;
}

static enum status judge_buckled(struct stress_run *r, struct message *why)
{
    const struct scene *s = &r->run.scene;
    const struct scene_support *moved = &s->supports[s->support_count - 1];
    double d[3], shift[3];
    enum status st;

    scene_support_shift(moved, s->end, shift);
    TRY(stress_run_move(r, NULL, why));
    stress_run_displacement(r, middle, d);
    r->result->error =
        fabs(fabs(d[2]) / s->length - elastica_buckled(-shift[0] / s->length));
out:
    return st;
}

static enum status watch_still(void *context, const struct motion *m, struct message *why)
{
    struct stress_run *r = context;

    (void)why;
    m->model->sample(m->state, m->frames ? r->xyz : r->first);
    if (m->frames)
        stress_run_note(r, m->time, metric_rmse(r->xyz, r->first) / m->scene->length);
    return STATUS_OK;
}

static enum status judge_still(struct stress_run *r, struct message *why)
{
    enum status st = STATUS_OK;

    if (r->job->c->truth == STRESS_STILL_REST) {
        if (!r->run.model->equilibrium)
            return status_fail(why, STATUS_UNSUPPORTED,
                               "unsupported: no static equilibrium to start from");
        TRY(stress_run_settle(r, why));
    }
    r->result->error = 0;
    st = stress_run_move(r, watch_still, why);
out:
    return st;
}

static enum status judge_shifted(struct stress_run *r, struct message *why)
{
    const struct scene *s = &r->run.scene;
    double shift[3], *rest = metric_rest_field(s);
    enum status st = rest ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    scene_support_shift(&s->supports[0], s->end, shift);
    TRY(stress_run_move(r, NULL, why));
    r->run.model->sample(r->run.state, r->xyz);
    for (int n = 0; n < 3 * GRID_POINTS; n++)
        rest[n] += shift[n % 3];
    r->result->error = metric_rmse(r->xyz, rest) / s->length;
out:
    free(rest);
    return st;
}

enum status stress_find_truth(const struct stress_job *job, enum truth_effort effort,
                              struct truth **truth, struct message *why)
{
    static const double time[] = {0.1, 0.2, 0.3};
    char folder[4096];
    struct settings physics = {0};
    enum status st = STATUS_OK;

    settings_list(&physics, STRESS_SETTINGS, job->c->physics);
    snprintf(folder, sizeof folder, "%s/%s.truth", job->folder, job->c->item.name);
    if (effort != TRUTH_READ)
        TRY(folder_make(folder, why));
    st = truth_find(job->path, &physics, sizeof time / sizeof *time, time, folder, effort,
                    truth, why);
out:
    settings_clear(&physics);
    return st;
}

static enum status watch_shell(void *context, const struct motion *m, struct message *why)
{
    struct stress_run *r = context;
    const struct truth *truth = r->truth;

    (void)why;
    for (int n = 0; n < truth->times; n++)
        if (fabs(m->time - truth->time[n]) < m->scene->step / 4) {
            m->model->sample(m->state, r->xyz);
            stress_run_note(r, m->time,
                            metric_rmse(r->xyz, truth->xyz[n]) / m->scene->length);
        }
    return STATUS_OK;
}

static enum status judge_shell(struct stress_run *r, struct message *why)
{
    struct message missing = {""};
    enum status st;

    if (stress_find_truth(r->job, TRUTH_READ, &r->truth, &missing) != STATUS_OK)
        return status_fail(why, STATUS_UNSUPPORTED, "no truth to hold it against: %.900s",
                           missing.text);
    r->result->error = 0;
    TRY(stress_run_move(r, watch_shell, why));
    snprintf(r->result->sentence.text, sizeof r->result->sentence.text,
             "the truth's error bar is %.2g",
             r->truth->error[r->truth->times - 1] / r->run.scene.length);
out:
    return st;
}

static enum status judge(struct stress_run *r, struct message *why)
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

enum status stress_judge(const struct stress_job *job, struct stress_result *result,
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
    TRY(stress_run_read(job, &r.run, &said));
    TRY(run_build(&r.run, &said));
    st = judge(&r, &said);
out:
    result->seconds = clock_processor() - start;
    kirchhoff_destroy(r.plate);
    truth_destroy(r.truth);
    run_close(&r.run);
    free(r.energies);
    free(r.xyz);
    free(r.first);
    return settle_result(st, &said, result, why);
}

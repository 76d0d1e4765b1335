/* The errors of hard cases. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/harness/child.h"
#include "bench/harness/derived_key.h"
#include "bench/harness/motion.h"
#include "bench/harness/run.h"
#include "bench/stress/stress.h"
#include "fem_ref/elastica.h"
#include "fem_ref/kirchhoff.h"
#include "models/clock.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

/* A run of a hard case, on its way to an error. */
struct judged {
    const struct stress_job *job; /*                                          borrowed */
    struct run run;
    struct stress_result *result; /* to be filled                             borrowed */
    struct message *why;          /* of who judges                            borrowed */
    double *xyz, *first;          /* fields (grid.h), room for judges        xyz owned */
    struct kirchhoff *plate;      /* of the judges that need it                  owned */
    double load;                  /* on that plate [N/m^2]                             */
    struct energy *energies;      /* [frame_count + 1]                           owned */
    int frames;                   /* of energies                                       */
    struct truth *truth;          /* of STRESS_SHELL                             owned */
    motion_watcher *watch;
};

/* Settings of the case, on top of the contestant's. */
static void add_settings(const struct stress_job *job, struct settings *s)
{
    const struct stress_case *c = job->c;
    const int least = contestant_least(job->contestant);
    const int side = c->side == 0 ? 10 : c->side == 1 ? least : c->side;

    settings_list(s, STRESS_SETTINGS, c->physics);
    if (job->quick && c->quick_end)
        settings_set(s, c->quick_end);
    contestant_points(job->contestant, side, side, s);
    settings_list(s, STRESS_SETTINGS, c->numerics);
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

/* The case's scene and the contestant's numerics, E from Gamma; errors as run_read. */
static enum status read_run(const struct stress_job *job, struct run *run,
                            struct message *why)
{
    const struct stress_case *c = job->c;
    struct settings settings = {0};
    enum status st;

    add_settings(job, &settings);
    TRY(run_read(run, &(struct run_plan){job->path, job->contestant, .settings = &settings},
                 why));
    if (c->gamma > 0)
        run->scene.young =
            derived_key_solve("gamma", "material.young", c->gamma, &run->scene);
    if (c->weight_ratio > 0)
        st = give_weights(&run->discretization, c->weight_ratio);
out:
    settings_clear(&settings);
    return st;
}

/* Leaves word of the time, for whoever finds out that it was the last. */
static enum status watch_time(void *context, const struct motion *m, struct message *why)
{
    struct judged *r = context;

    child_reached(m->time);
    return r->watch ? r->watch(context, m, why) : STATUS_OK;
}

/* Through the scene's motion, watch(run) at every frame (NULL: nobody); a death leaves its
 * time and sentence. */
static enum status move(struct judged *r, motion_watcher *watch)
{
    const struct run *run = &r->run;
    struct motion m = {0};
    enum status st;

    TRY(motion_init(&m, run->model, &run->scene, run->state));
    r->watch = watch;
    TRY(motion_run(&m, watch_time, r, true, r->why));
    if (!m.death)
        goto out;
    r->result->time = m.death_time;
    st = status_fail(r->why, m.death, "%s", status_text(m.death));
out:
    motion_clear(&m);
    return st;
}

/* To static equilibrium; by damped motion where the model has no other way. */
static enum status settle(struct judged *r)
{
    struct counters counters = {0};
    enum status st;

    if (!r->run.model->equilibrium)
        return move(r, NULL);
    st = run_settle(&r->run, &counters, r->why);
    if (status_is_death(st))
        r->result->time = 0;
    return st;
}

/* How far a material point has come from rest [m]. */
static void displacement(const struct judged *r, const double uvw[3], double d[3])
{
    const struct run *run = &r->run;
    double rest[3];

    run->model->probe(run->state, 1, uvw, d);
    scene_rest_point(&run->scene, uvw, rest);
    for (int i = 0; i < 3; i++)
        d[i] -= rest[i];
}

/* The error at a frame: the greatest is the run's, and the bound is kept until its first
 * above that. */
static void note(struct judged *r, double time, double error)
{
    struct stress_result *result = r->result;

    if (!(error <= r->job->c->bound) && !(result->error > r->job->c->bound))
        result->time = time;
    if (!(error <= result->error))
        result->error = error;
}

static const double tip[3] = {1, 0.5, 0.5}, middle[3] = {0.5, 0.5, 0.5};

/* Functions a direction: 24 give statics to 1e-6. */
enum { TERMS = 24 };

static enum status make_plate(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    const struct kirchhoff_plate plate = {s->length, s->width,   s->thickness,
                                          s->young,  s->poisson, s->density};
    enum status st = kirchhoff_create(&plate, TERMS, &r->plate);

    r->load = s->density * s->thickness * -s->gravity[2];
    return st == STATUS_OK ? st : status_fail(r->why, st, "%s", status_text(st));
}

static enum status end_plate(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    double d[3];

    displacement(r, tip, d);
    r->result->error =
        fabs(-d[2] / kirchhoff_static(r->plate, r->load, s->length, s->width / 2) - 1);
    return STATUS_OK;
}

static enum status end_elastica(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    struct elastica_point e;
    double d[3];
    enum status st;

    TRY(elastica_solve(scene_gamma(s), &e));
    displacement(r, tip, d);
    r->result->error = hypot(d[0] / s->length + 1 - e.reach, d[2] / s->length + e.drop);
out:
    return st;
}

static enum status watch_vibration(void *context, const struct motion *m,
                                   struct message *why)
{
    struct judged *r = context;
    const struct scene *s = &r->run.scene;
    const double at = s->length, half = s->width / 2;
    double d[3];

    (void)why;
    displacement(r, tip, d);
    const double true_tip = kirchhoff_transient(r->plate, r->load, 0, m->time, at, half);
    const double greatest = 2 * kirchhoff_static(r->plate, r->load, at, half);
    note(r, m->time, fabs(-d[2] - true_tip) / greatest);
    return STATUS_OK;
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

/* The same once more in other units, in which it may die, too. */
static enum status end_similar(struct judged *r)
{
    const struct stress_case *c = r->job->c;
    struct judged other = *r;
    enum status st;

    other.run = (struct run){0};
    r->run.model->sample(r->run.state, r->xyz);
    TRY(read_run(r->job, &other.run, r->why));
    change_units(&other.run.scene, c->length, c->mass, c->time);
    TRY(run_build(&other.run, r->why));
    TRY(move(&other, NULL));
    other.run.model->sample(other.run.state, r->first);
    for (size_t n = 0; n < 3 * GRID_POINTS; n++)
        r->first[n] *= c->length;
    r->result->error = metric_rmse(r->xyz, r->first) / r->run.scene.length;
out:
    r->result->time *= c->time;
    run_close(&other.run);
    return st;
}

static enum status begin_energy(struct judged *r)
{
    struct energy rest = {NAN, NAN, NAN};

    if (r->run.model->energy)
        r->run.model->energy(r->run.state, &rest);
    return isfinite(rest.elastic)
               ? STATUS_OK
               : status_fail(r->why, STATUS_UNSUPPORTED,
                             "unsupported: no elastic energy that could be kept");
}

static enum status watch_energy(void *context, const struct motion *m, struct message *why)
{
    struct judged *r = context;

    (void)why;
    if (!r->energies)
        r->energies = calloc((size_t)m->frame_count + 1, sizeof *r->energies);
    if (!r->energies)
        return STATUS_MEMORY;
    m->model->energy(m->state, &r->energies[r->frames++]);
    return STATUS_OK;
}

static enum status end_energy(struct judged *r)
{
    double *drift = malloc((size_t)r->frames * sizeof *drift), most = 0, least = 0;

    if (!drift)
        return STATUS_MEMORY;
    metric_energy_drift(r->frames, r->energies, drift);
    for (int n = 0; n < r->frames; n++) {
        note(r, n * r->run.scene.step, fabs(drift[n]));
        most = fmax(most, drift[n]), least = fmin(least, drift[n]);
    }
    snprintf(r->result->sentence.text, sizeof r->result->sentence.text,
             "%d steps: %.2g won at most, %.2g lost at most, of the energy in play",
             r->frames - 1, most, fabs(least));
    free(drift);
    return STATUS_OK;
}

static enum status end_buckled(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    double d[3], shift[3];

    scene_support_shift(&s->supports[s->support_count - 1], s->end, shift);
    displacement(r, middle, d);
    r->result->error =
        fabs(fabs(d[2]) / s->length - elastica_buckled(-shift[0] / s->length));
    return STATUS_OK;
}

static enum status watch_still(void *context, const struct motion *m, struct message *why)
{
    struct judged *r = context;

    (void)why;
    m->model->sample(m->state, m->frames ? r->xyz : r->first);
    if (m->frames)
        note(r, m->time, metric_rmse(r->xyz, r->first) / m->scene->length);
    return STATUS_OK;
}

static enum status begin_still_rest(struct judged *r)
{
    return r->run.model->equilibrium
               ? settle(r)
               : status_fail(r->why, STATUS_UNSUPPORTED,
                             "unsupported: no static equilibrium to start from");
}

static enum status end_shifted(struct judged *r)
{
    const struct scene *s = &r->run.scene;
    double shift[3], *rest = metric_rest_field(s);

    if (!rest)
        return STATUS_MEMORY;
    scene_support_shift(&s->supports[0], s->end, shift);
    r->run.model->sample(r->run.state, r->xyz);
    for (int n = 0; n < 3 * GRID_POINTS; n++)
        rest[n] += shift[n % 3];
    r->result->error = metric_rmse(r->xyz, rest) / s->length;
    free(rest);
    return STATUS_OK;
}

static enum status begin_shell(struct judged *r)
{
    const struct message *lost = r->job->no_truth;
    struct message missing = {""};

    if (stress_find_truth(r->job, false, &r->truth, &missing) != STATUS_OK)
        return status_fail(r->why, STATUS_UNSUPPORTED,
                           "no truth to hold it against: %.900s",
                           lost && *lost->text ? lost->text : missing.text);
    snprintf(r->result->sentence.text, sizeof r->result->sentence.text,
             "the truth's error bar is %.2g",
             r->truth->error[r->truth->times - 1] / r->run.scene.length);
    return STATUS_OK;
}

static enum status watch_shell(void *context, const struct motion *m, struct message *why)
{
    struct judged *r = context;
    const struct truth *truth = r->truth;

    (void)why;
    for (int n = 0; n < truth->times; n++)
        if (fabs(m->time - truth->time[n]) < m->scene->step / 4) {
            m->model->sample(m->state, r->xyz);
            note(r, m->time, metric_rmse(r->xyz, truth->xyz[n]) / m->scene->length);
        }
    return STATUS_OK;
}

/* How a case of each truth is judged. */
static const struct {
    enum status (*begin)(struct judged *r); /* NULL: nothing to do */
    bool rests;                             /* instead of moving    */
    motion_watcher *watch;
    enum status (*end)(struct judged *r); /* NULL: `watch` told all */
} judges[STRESS_TRUTHS] = {
    [STRESS_PLATE] = {make_plate, true, NULL, end_plate},
    [STRESS_ELASTICA] = {NULL, true, NULL, end_elastica},
    [STRESS_VIBRATION] = {make_plate, false, watch_vibration, NULL},
    [STRESS_SIMILAR] = {NULL, false, NULL, end_similar},
    [STRESS_ENERGY] = {begin_energy, false, watch_energy, end_energy},
    [STRESS_BUCKLED] = {NULL, false, NULL, end_buckled},
    [STRESS_STILL] = {NULL, false, watch_still, NULL},
    [STRESS_STILL_REST] = {begin_still_rest, false, watch_still, NULL},
    [STRESS_SHIFTED] = {NULL, false, NULL, end_shifted},
    [STRESS_SHELL] = {begin_shell, false, watch_shell, NULL},
};

static enum status judge(struct judged *r)
{
    const enum stress_truth n = r->job->c->truth;
    enum status st;

    TRY(judges[n].begin ? judges[n].begin(r) : STATUS_OK);
    TRY(judges[n].rests ? settle(r) : move(r, judges[n].watch));
    TRY(judges[n].end ? judges[n].end(r) : STATUS_OK);
out:
    return st;
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
    struct message said = {""};
    struct judged r = {.job = job, .result = result, .why = &said};
    const double start = clock_processor();
    enum status st;

    *result = (struct stress_result){
        .error = NAN, .time = NAN, .quick = job->quick && job->c->quick_end};
    r.xyz = malloc(2 * 3 * GRID_POINTS * sizeof *r.xyz);
    TRY(r.xyz ? STATUS_OK : STATUS_MEMORY);
    r.first = r.xyz + 3 * GRID_POINTS;
    TRY(read_run(job, &r.run, &said));
    TRY(run_build(&r.run, &said));
    st = judge(&r);
out:
    result->seconds = clock_processor() - start;
    kirchhoff_destroy(r.plate);
    truth_destroy(r.truth);
    run_close(&r.run);
    free(r.energies);
    free(r.xyz);
    return settle_result(st, &said, result, why);
}

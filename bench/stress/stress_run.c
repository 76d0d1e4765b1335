#include "bench/stress/stress_run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/harness/child.h"
#include "bench/harness/derived_key.h"
#include "models/clock.h"
#include "models/grid.h"

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

enum status stress_run_read(const struct stress_job *job, struct run *run,
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
    struct stress_run *r = context;

    child_reached(m->time);
    return r->watch ? r->watch(context, m, why) : STATUS_OK;
}

enum status stress_run_move(struct stress_run *r, motion_watcher *watch,
                            struct message *why)
{
    const struct run *run = &r->run;
    struct motion m = {0};
    enum status st;

    TRY(motion_init(&m, run->model, &run->scene, run->state));
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
    struct counters counters = {0};
    enum status st;

    if (!r->run.model->equilibrium)
        return stress_run_move(r, NULL, why);
    st = run_settle(&r->run, &counters, why);
    if (status_is_death(st))
        r->result->time = 0;
    return st;
}

void stress_run_displacement(const struct stress_run *r, const double uvw[3], double d[3])
{
    const struct run *run = &r->run;
    double rest[3];

    run->model->probe(run->state, 1, uvw, d);
    scene_rest_point(&run->scene, uvw, rest);
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

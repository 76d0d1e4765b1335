#include "bench/harness/run.h"

#include <stdlib.h>
#include <string.h>

#include "models/clock.h"
#include "models/reader/scene_file.h"

enum status run_read(struct run *r, const struct case_plan *c, struct message *why)
{
    struct settings all SCOPED(settings_clear) = {0};
    char *path SCOPED(scope_free) = NULL;

    memset(r, 0, sizeof *r);
    r->contestant = c->contestant;
    r->model = c->contestant->model;
    model_open(r->model, &r->discretization);
    contestant_settings(c->contestant, &all);
    settings_append(&all, &c->settings);
    CALL(scene_file_find(c->path, &path, why));
    CALL(contestant_read_settings(&all, path, &r->scene, &r->discretization, why));
    model_complete(r->model, &r->scene, &r->discretization, &r->adapted);
    if (c->end > 0)
        r->scene.end = c->end;
    return STATUS_OK;
}

enum status run_build(struct run *r, struct message *why)
{
    const double start = clock_now();
    const enum status st =
        model_create(r->model, &r->scene, &r->discretization, &r->state, why);

    r->create_seconds = clock_now() - start;
    return st;
}

enum status run_open(struct run *r, const struct case_plan *c, struct message *why)
{
    const enum status st = run_read(r, c, why);

    return st == STATUS_OK ? run_build(r, why) : st;
}

enum status run_settle(struct run *r, struct counters *work, struct message *why)
{
    if (!r->model->equilibrium)
        return status_fail(why, STATUS_UNSUPPORTED, "%s has no static equilibrium",
                           r->model->name);
    return r->model->equilibrium(r->state, work, why);
}

enum status run_modes(struct run *r, int count, double *omega, struct message *why)
{
    if (!r->model->modes)
        return status_fail(why, STATUS_UNSUPPORTED, "%s has no natural frequencies",
                           r->model->name);
    return r->model->modes(r->state, count, omega, why);
}

void run_close(struct run *r)
{
    if (r->model)
        model_destroy(r->model, r->state);
    scene_clear(&r->scene);
    discretization_clear(&r->discretization);
    memset(r, 0, sizeof *r);
}

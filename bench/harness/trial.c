#include "bench/harness/trial.h"

#include <string.h>

#include "bench/harness/registry.h"
#include "models/clock.h"
#include "models/reader/scene_file.h"

enum status trial_read(struct trial *t, const char *path, int setting_count,
                       const char *const *settings, const char *model, struct message *why)
{
    enum status st;

    memset(t, 0, sizeof *t);
    TRY(registry_find(model, &t->model, why));
    t->model->defaults(&t->discretization);
    st = scene_file_read(path, setting_count, settings, &t->scene, &t->discretization, why);
out:
    return st;
}

enum status trial_build(struct trial *t, struct message *why)
{
    const double start = clock_now();
    const enum status st = t->model->create(&t->scene, &t->discretization, &t->state, why);

    t->create_seconds = clock_now() - start;
    return st;
}

enum status trial_open(struct trial *t, const char *path, int setting_count,
                       const char *const *settings, const char *model, struct message *why)
{
    enum status st = trial_read(t, path, setting_count, settings, model, why);

    return st == STATUS_OK ? trial_build(t, why) : st;
}

void trial_close(struct trial *t)
{
    if (t->model)
        t->model->destroy(t->state);
    scene_clear(&t->scene);
    discretization_clear(&t->discretization);
    memset(t, 0, sizeof *t);
}

#include "bench/harness/rung.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/motion.h"
#include "bench/files/store.h"
#include "bench/files/store_read.h"
#include "bench/harness/trial.h"
#include "models/grid.h"

static void file_of(const struct rung_plan *plan, char *path, int size)
{
    snprintf(path, (size_t)size, "%s/%s.h5", plan->folder, plan->name);
}

/* Keeps the frames whose time is wanted. */
struct keeper {
    const struct rung_plan *plan;
    struct store *store;
    double *xyz;
    int kept;
};

static enum status keep(void *context, const struct motion *m, struct message *why)
{
    struct keeper *k = context;
    struct energy energy;
    const double *want = k->plan->time;

    if (k->kept == k->plan->times || m->time < want[k->kept] - m->scene->step / 4)
        return STATUS_OK;
    m->model->sample(m->state, k->xyz);
    if (m->model->energy)
        m->model->energy(m->state, &energy);
    return store_frame(k->store, want[k->kept++], k->xyz, m->model->energy ? &energy : NULL,
                       &m->counters, why);
}

enum status rung_run(const struct rung_plan *plan, struct message *why)
{
    enum status st;
    struct trial trial;
    struct provenance provenance;
    struct motion m = {0};
    struct keeper k = {.plan = plan};
    struct model_size size;
    char path[4096];

    TRY(trial_open(&trial, plan->path, plan->setting_count, plan->settings, plan->model,
                   why));
    trial.scene.end = plan->time[plan->times - 1];
    k.xyz = malloc(3 * GRID_POINTS * sizeof *k.xyz);
    if (!k.xyz)
        TRY(STATUS_MEMORY);
    provenance_collect(&provenance);
    file_of(plan, path, sizeof path);
    TRY(store_create(path,
                     &(struct store_run){.scene = &trial.scene,
                                         .model = trial.model,
                                         .discretization = &trial.discretization,
                                         .provenance = &provenance,
                                         .single = true},
                     &k.store, why));
    trial.model->size(trial.state, &size);
    TRY(store_size(k.store, &size, why));
    TRY(motion_init(&m, trial.model, &trial.scene, trial.state));
    TRY(motion_run(&m, keep, &k, true, why));
    TRY(store_seconds(k.store, "create", &trial.create_seconds, 1, 0, why));
    TRY(store_seconds(k.store, "advance", m.seconds, 1, m.steps, why));
    if (m.death)
        store_death(k.store, m.death, m.death_time);
    struct store *store = k.store;
    k.store = NULL;
    TRY(store_close(store, why));
out:
    store_discard(k.store);
    motion_clear(&m);
    free(k.xyz);
    trial_close(&trial);
    return st;
}

/* Seconds of the steps up to the last frame kept, and how many they were. */
static enum status read_seconds(const struct store_read *file, struct rung_result *r,
                                struct message *why)
{
    enum status st;
    double *create = NULL, *advance = NULL;
    int rows, columns;

    TRY(store_read_array(file, "seconds/create", &create, &rows, &columns, why));
    r->create = create[0];
    TRY(store_read_array(file, "seconds/advance", &advance, &rows, &columns, why));
    r->steps = rows * columns;
    for (long n = 0; n < r->steps; n++)
        r->stepping += advance[n];
out:
    free(create);
    free(advance);
    return st;
}

enum status rung_read(const struct rung_plan *plan, struct rung_result *r,
                      struct message *why)
{
    enum status st;
    struct store_read *file = NULL;
    struct rung_result new = {0};
    char path[4096];

    file_of(plan, path, sizeof path);
    TRY(store_read_open(path, &file, why));
    TRY(store_read_number(file, "unknowns", &new.unknowns, why));
    TRY(store_read_text(file, "/", "outcome", &new.outcome, why));
    TRY(read_seconds(file, &new, why));
    int frames = store_read_frames(file);
    new.xyz = calloc((size_t)frames + 1, sizeof *new.xyz);
    if (!new.xyz)
        TRY(STATUS_MEMORY);
    for (; new.frames < frames; new.frames++) {
        new.xyz[new.frames] = malloc(3 * GRID_POINTS * sizeof(double));
        if (!new.xyz[new.frames])
            TRY(STATUS_MEMORY);
        TRY(store_read_frame(file, new.frames, new.xyz[new.frames], why));
    }
    *r = new;
    memset(&new, 0, sizeof new);
out:
    if (new.xyz &&new.xyz[new.frames])
        free(new.xyz[new.frames]); /* the one that failed */
    rung_clear(&new);
    store_read_close(file);
    return st;
}

void rung_clear(struct rung_result *r)
{
    if (!r)
        return;
    for (int n = 0; n < r->frames; n++)
        free(r->xyz[n]);
    free(r->xyz);
    free(r->outcome);
    memset(r, 0, sizeof *r);
}

#include "bench/harness/record.h"

#include <assert.h>
#include <stdlib.h>

#include "bench/harness/series.h"
#include "models/clock.h"
#include "models/grid.h"
#include "models/metric/metric.h"

struct record {
    const struct scene *scene;
    const struct model *model;
    struct store *store; /* NULL once closed                             owned      */
    int room, frames;    /* kept                                                    */
    int every, seen;     /* frames                                                  */
    bool waits;          /* the last frame seen is not kept yet                     */
    double t;            /* of the last frame seen, as the next two             [s] */
    struct counters counters;
    double *xyz; /* [GRID_POINTS][3]                                owned      */
    double *value[SERIES_METRICS]; /* [room]                                owned      */
    struct energy *energy;  /* [room], if the model has any                 owned      */
    double *sample_seconds; /* [room]                                       owned      */
};

void record_discard(struct record *r)
{
    if (!r)
        return;
    store_discard(r->store);
    for (int n = 0; n < SERIES_METRICS; n++)
        free(r->value[n]);
    free(r->energy);
    free(r->sample_seconds);
    free(r->xyz);
    free(r);
}

enum status record_create(const char *path, const struct store_run *run, int frame_count,
                          int every, struct record **record, struct message *why)
{
    enum status st = STATUS_OK;
    int room = frame_count / every + 2;
    size_t size = (size_t)room * sizeof(double);
    struct record *r = calloc(1, sizeof *r);

    if (!r)
        return STATUS_MEMORY;
    r->scene = run->scene;
    r->model = run->model;
    r->room = room;
    r->every = every;
    r->xyz = malloc(GRID_POINTS * 3 * sizeof *r->xyz);
    r->sample_seconds = malloc(size);
    r->energy = malloc((size_t)r->room * sizeof *r->energy);
    if (!r->xyz || !r->sample_seconds || !r->energy)
        TRY(STATUS_MEMORY);
    for (int n = 0; n < SERIES_METRICS; n++)
        if (!(r->value[n] = malloc(size)))
            TRY(STATUS_MEMORY);
    TRY(store_create(path, run, &r->store, why));
    *record = r, r = NULL;
out:
    record_discard(r);
    return st;
}

static enum status keep(struct record *r, struct message *why)
{
    struct energy *energy = r->model->energy ? &r->energy[r->frames] : NULL;

    for (int n = 0; n < SERIES_METRICS; n++)
        r->value[n][r->frames] = series_metric[n].value(r->scene, r->xyz);
    r->frames++;
    r->waits = false;
    return store_frame(r->store, r->t, r->xyz, energy, &r->counters, why);
}

enum status record_frame(struct record *r, const void *state, double t,
                         const struct counters *counters, struct message *why)
{
    double start = clock_now();

    assert(r->frames < r->room);
    r->model->sample(state, r->xyz);
    r->sample_seconds[r->frames] = clock_now() - start;
    if (r->model->energy)
        r->model->energy(state, &r->energy[r->frames]);
    r->t = t;
    r->counters = counters ? *counters : (struct counters){0};
    r->waits = true;
    return r->seen++ % r->every == 0 ? keep(r, why) : STATUS_OK;
}

static enum status store_drift(const struct record *r, struct message *why)
{
    double *drift = malloc((size_t)r->room * sizeof *drift);
    enum status st = STATUS_MEMORY;

    if (drift) {
        metric_energy_drift(r->frames, r->energy, drift);
        st = store_metric(r->store, "energy_drift", "1", drift, r->frames, why);
    }
    free(drift);
    return st;
}

enum status record_close(struct record *r, const void *state, double create_seconds,
                         const struct motion *m, struct message *why)
{
    enum status st = STATUS_OK;
    struct model_size size = {0};
    struct store *store = r->store;

    if (r->waits)
        TRY(keep(r, why));
    r->model->size(state, &size);
    TRY(store_size(store, &size, why));
    for (int n = 0; n < SERIES_METRICS; n++)
        TRY(store_metric(store, series_metric[n].name, series_metric[n].unit, r->value[n],
                         r->frames, why));
    if (r->model->energy)
        TRY(store_drift(r, why));
    TRY(store_seconds(store, "create", &create_seconds, 1, 0, why));
    TRY(store_seconds(store, "sample", r->sample_seconds, r->frames, 0, why));
    if (m && m->steps)
        TRY(store_seconds(store, "advance", m->seconds, 1, m->steps, why));
    if (m && m->death)
        store_death(store, m->death, m->death_time);
    r->store = NULL; /* closing frees it, whatever comes of it */
    TRY(store_close(store, why));
out:
    record_discard(r);
    return st;
}

#include "bench/harness/case.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/case_looks.h"
#include "bench/harness/motion.h"
#include "bench/files/store.h"
#include "bench/harness/trial.h"
#include "models/clock.h"
#include "models/grid.h"
#include "models/metric/metric.h"

/* Every third grid point: three or four to a span of a net of 10 x 10 control points, where
 * a quadratic spline has no folds to hide, at a tenth of the time of the whole grid. Of
 * 1,098 looks at 18 runs of the flag (Table 4) none was judged otherwise than by the whole
 * grid. */
enum { INTERSECTION_STEP = 3 };

static const struct {
    const char *name, *unit, *sentence;
} measure_words[] = {
#define CASE_MEASURE_WORDS(code, name, unit, sentence) {#name, unit, sentence},
    CASE_MEASURE_LIST(CASE_MEASURE_WORDS)
#undef CASE_MEASURE_WORDS
        {"unknown", "", ""},
};

static int known(int measure)
{
    return 0 <= measure && measure < CASE_MEASURES ? measure : CASE_MEASURES;
}

const char *case_measure_name(int measure)
{
    return measure_words[known(measure)].name;
}

const char *case_measure_unit(int measure)
{
    return measure_words[known(measure)].unit;
}

const char *case_measure_sentence(int measure)
{
    return measure_words[known(measure)].sentence;
}

struct watch {
    const struct case_plan *plan;
    const struct scene *scene;
    struct case_looks looks;
    struct store *store;  /* NULL: none                                               */
    double *xyz, *before; /* this look's field and the last one's                     */
    int snapshot;         /* the next of the scene's                                  */
    double seconds;       /* spent looking                                            */
};

static void measure(struct watch *w, const struct motion *m)
{
    struct case_looks *l = &w->looks;
    const int n = l->count;

    for (int i = 0; i < SERIES_METRICS; i++)
        l->series[i][n] = series_metric[i].value(w->scene, w->xyz);
    l->series[CASE_LOOKS_INTERSECTIONS][n] =
        w->plan->intersections ? metric_intersections_every(w->xyz, INTERSECTION_STEP)
                               : NAN;
    l->series[CASE_LOOKS_SPEED][n] =
        n ? metric_rmse(w->xyz, w->before) / (m->time - l->time[n - 1]) : NAN;
    l->energy[n] = (struct energy){NAN, NAN, NAN};
    if (m->model->energy)
        m->model->energy(m->state, &l->energy[n]);
    l->time[n] = m->time;
    l->count++;
}

/* At a multiple of `every`, the end and the snapshots, whether these are kept or not. */
static enum status look(void *context, const struct motion *m, struct message *why)
{
    struct watch *w = context;
    const struct scene *scene = w->scene;
    bool snapshot = w->snapshot < scene->snapshot_count &&
                    m->time > scene->snapshots[w->snapshot] - scene->step / 2;
    double start = clock_now();
    enum status st = STATUS_OK;

    if (!snapshot && m->frames % w->plan->every && m->frames < m->frame_count)
        return STATUS_OK;
    w->snapshot += snapshot;
    m->model->sample(m->state, w->xyz);
    measure(w, m);
    if (w->store)
        st = store_frame(w->store, m->time, snapshot && w->plan->snapshots ? w->xyz : NULL,
                         &w->looks.energy[w->looks.count - 1], &m->counters, why);
    double *swap = w->before;
    w->before = w->xyz, w->xyz = swap;
    w->seconds += clock_now() - start;
    return st;
}

static enum status open_store(const struct case_plan *plan, const struct trial *trial,
                              struct store **store, struct message *why)
{
    struct provenance here;

    if (!plan->out)
        return STATUS_OK;
    if (!plan->provenance)
        provenance_collect(&here);
    return store_create(
        plan->out,
        &(struct store_run){.scene = &trial->scene,
                            .model = trial->model,
                            .discretization = &trial->discretization,
                            .provenance = plan->provenance ? plan->provenance : &here,
                            .single = true},
        store, why);
}

/* Series, seconds and end of a case; frees the store in any case. */
static enum status close_store(struct watch *w, const struct trial *trial,
                               const struct motion *m, const struct case_result *r,
                               struct message *why)
{
    enum status st = STATUS_OK;
    struct store *store = w->store;
    struct model_size size = {0};

    if (!store)
        return STATUS_OK;
    if (trial->state)
        trial->model->size(trial->state, &size);
    TRY(store_size(store, &size, why));
    for (int n = 0; n < CASE_LOOKS_SERIES; n++)
        TRY(store_metric(store, case_looks_name(n), case_looks_unit(n), w->looks.series[n],
                         w->looks.count, why));
    TRY(store_seconds(store, "create", &trial->create_seconds, 1, 0, why));
    TRY(store_seconds(store, "advance", m->seconds, 1, m->steps, why));
    TRY(store_seconds(store, "look", &w->seconds, 1, 0, why));
    if (r->outcome == STATUS_UNSUPPORTED)
        TRY(store_note(store, r->sentence.text, why));
    if (r->outcome)
        store_death(store, r->outcome, m->death_time);
    w->store = NULL;
    st = store_close(store, why);
out:
    return st;
}

/* Through the motion, if the model could be built. */
static enum status go(struct watch *w, const struct trial *trial, struct motion *m,
                      struct case_result *r, struct message *why)
{
    const int snapshots = trial->scene.snapshot_count;
    enum status st;

    TRY(motion_init(m, trial->model, &trial->scene, trial->state));
    TRY(case_looks_init(&w->looks, m->frame_count / w->plan->every + snapshots + 2));
    if (r->outcome == STATUS_OK)
        TRY(motion_run(m, look, w, true, why));
    if (m->death)
        r->outcome = m->death;
    for (int n = 0; n < m->steps; n++)
        r->step_seconds += m->seconds[n];
    r->look_seconds = w->seconds;
out:
    return st;
}

enum status case_run(const struct case_plan *plan, struct case_result *result,
                     struct message *why)
{
    struct case_result r = {0};
    struct message left_out = {""};
    struct trial trial;
    struct motion m = {0};
    struct watch w = {.plan = plan, .scene = &trial.scene};
    enum status st = trial_open(&trial, plan->path, plan->setting_count, plan->settings,
                                plan->model, &left_out);

    if (st == STATUS_UNSUPPORTED || status_is_death(st))
        r.outcome = st;
    else if (st && why)
        *why = left_out;
    TRY(r.outcome ? STATUS_OK : st);
    r.create_seconds = trial.create_seconds;
    w.xyz = malloc(3 * GRID_POINTS * sizeof *w.xyz);
    w.before = malloc(3 * GRID_POINTS * sizeof *w.before);
    TRY(w.xyz && w.before ? STATUS_OK : STATUS_MEMORY);
    TRY(open_store(plan, &trial, &w.store, why));
    TRY(go(&w, &trial, &m, &r, why));
    TRY(case_looks_reduce(&w.looks, &trial.scene, m.death_time,
                          r.outcome == STATUS_UNSUPPORTED ? left_out.text : "", &r));
    TRY(close_store(&w, &trial, &m, &r, why));
    *result = r;
out:
    store_discard(w.store);
    case_looks_clear(&w.looks);
    motion_clear(&m);
    free(w.xyz);
    free(w.before);
    trial_close(&trial);
    return st;
}

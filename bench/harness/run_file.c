#include "bench/harness/run_file.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/atomic_file.h"
#include "bench/files/store.h"
#include "bench/harness/distrust.h"
#include "bench/harness/looks.h"
#include "bench/harness/run_surface.h"
#include "bench/harness/warnings.h"
#include "models/clock.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/vector.h"

struct run_file {
    const struct run *run;
    const struct run_keep *keep;
    struct looks looks;
    struct store *store;  /* NULL: none                                              */
    struct arena fields;  /* of the two, until the looks end                  owned   */
    double *xyz, *before; /* this look's field and the last one's                    */
    struct run_surface surface; /* of xyz, where there is a file                  owned  */
    struct run_surface net; /* its own triangles, where crossings are counted   owned  */
    double *truth;          /* [LOOKS_TRUTH][looks' room]; NULL: none is known         */
    int next;               /* of keep->time                                           */
    bool waits;             /* xyz is of a frame that is no look, at:                  */
    double time;
    struct energy energy; /* NaN: the model has none                               */
    int pushers;          /* supports and obstacles, where their forces are kept     */
    double (*push)[6];    /* [pushers] of the field, as model.h's forces             */
    double (*pushed)[6];  /* [pushers][looks' room]                                  */
    double load;          /* carried by obstacles, over the weight */
    double through;       /* steps that ended with part of an obstacle through the sheet */
    struct counters work;
    double seconds; /* spent looking                                           */
    bool ended;
    struct model_size size; /* zeros: not built                                        */
    bool created, advanced; /* the caller gave those seconds                           */
    enum status refused;
    struct message sentence, doubt;
    struct arena arena; /* of truth and forces                                  owned  */
};

void run_file_discard(struct run_file *f)
{
    if (!f)
        return;
    store_discard(f->store);
    looks_clear(&f->looks);
    run_surface_clear(&f->surface);
    run_surface_clear(&f->net);
    arena_clear(&f->fields);
    arena_clear(&f->arena);
    free(f);
}

static enum status open_store(struct run_file *f, struct message *why)
{
    const struct run *run = f->run;
    const struct store_run what = {.scene = &run->scene,
                                   .model = run->model,
                                   .discretization = &run->discretization,
                                   .single = !f->keep->doubles};

    if (!f->keep->file)
        return STATUS_OK;
    if (f->keep->made_for) /* the program chose the name */
        atomic_file_claim(f->keep->file);
    CALL(store_create(f->keep->file, &what, &f->store, why));
    if (f->keep->made_for)
        CALL(store_text(f->store, "made_for", f->keep->made_for, why));
    if (f->keep->quick)
        CALL(store_text(f->store, "quick", "yes", why));
    CALL(run_surface_init(&f->surface, &run->scene));
    return run_surface_begin(&f->surface, &run->scene, f->store, why);
}

enum status run_file_open(const struct run *run, const struct run_keep *keep,
                          struct run_file **file, struct message *why)
{
    const long frames = lround(run->scene.end / run->scene.step);
    struct run_file *f SCOPED(run_file_discard_scope) = calloc(1, sizeof *f);

    if (!f)
        arena_end();
    f->run = run;
    f->keep = keep;
    f->xyz = arena_take(&f->fields, 3 * GRID_POINTS, sizeof *f->xyz);
    f->before = arena_take(&f->fields, 3 * GRID_POINTS, sizeof *f->before);
    looks_init(&f->looks,
               (keep->every ? (int)(frames / keep->every) : 0) + keep->times + 2);
    if (keep->truth)
        f->truth =
            arena_take(&f->arena, LOOKS_TRUTH * (size_t)f->looks.room, sizeof *f->truth);
    if (run->model->forces) {
        f->pushers = run->scene.support_count + run->scene.obstacle_count;
        f->push = arena_take(&f->arena, (size_t)f->pushers + 1, sizeof *f->push);
        f->pushed = arena_take(&f->arena, ((size_t)f->pushers + 1) * (size_t)f->looks.room,
                               sizeof *f->pushed);
    }
    if (keep->intersections)
        CALL(run_surface_net(&f->net, run));
    CALL(open_store(f, why));
    *file = f, f = NULL;
    return STATUS_OK;
}

static void measure(struct run_file *f)
{
    struct looks *l = &f->looks;
    const int n = l->count, *points = f->run->discretization.points;

    looks_add(l, &f->run->scene, f->time, f->xyz,
              f->net.flat.nodes        ? run_surface_crossings(&f->net)
              : f->keep->intersections ? looks_crossings(&f->run->scene, f->xyz)
                                       : NAN);
    if (n)
        l->series[LOOKS_SPEED][n] =
            metric_rmse(f->xyz, f->before) / (l->time[n] - l->time[n - 1]);
    l->series[LOOKS_LOAD][n] = f->load;
    l->series[LOOKS_TURN][n] =
        metric_turn(&f->run->scene, (const int[]){points[0] - 1, points[1] - 1}, f->xyz);
    l->series[LOOKS_THROUGH][n] = f->through;
    l->energy[n] = f->energy;
    l->series[LOOKS_REACTION][n] =
        f->pushers && f->run->scene.support_count ? vector_length(f->push[0]) : NAN;
    for (int k = 0; k < f->pushers; k++)
        memcpy(f->pushed[k * l->room + n], f->push[k], sizeof *f->push);
}

/* Returns the share of the sheet's weight that obstacles carry; NaN without either. */
static double load_of(const struct run *run, const struct model_contact *c)
{
    const struct scene *s = &run->scene;
    const double *g = s->gravity;
    const double pull = vector_length(g);

    if (!(pull > 0))
        return NAN;
    return -vector_dot(c->force, g) /
           (pull * pull * s->density * scene_area(s) * s->thickness);
}

/* Samples the present state, since a frame may turn out to be a look only after the state
 * has moved on, or died. */
static enum status sample(struct run_file *f, double time, const struct counters *work)
{
    const struct run *run = f->run;
    enum status st = STATUS_OK;

    model_sample(run->model, run->state, f->xyz);
    run_surface_sample(&f->surface, run->model, run->state);
    run_surface_sample(&f->net, run->model, run->state);
    f->energy = (struct energy){NAN, NAN, NAN};
    if (run->model->energy)
        run->model->energy(run->state, &f->energy);
    f->load = f->through = NAN;
    if (run->scene.obstacle_count && run->model->contact) {
        struct model_contact c;
        run->model->contact(run->state, &c);
        f->load = load_of(run, &c);
        f->through = (double)c.crossed;
    }
    if (f->pushers)
        st = run->model->forces(run->state, f->push, f->push + run->scene.support_count);
    f->time = time;
    f->work = *work;
    return st;
}

/* Makes a look of the field that was sampled last. */
static enum status take(struct run_file *f, bool field, struct message *why)
{
    enum status st = STATUS_OK;

    measure(f);
    f->waits = false;
    if (f->store)
        st = store_frame(f->store, f->time, field ? f->xyz : NULL, &f->energy, &f->work,
                         why);
    if (f->store && field && st == STATUS_OK)
        st = run_surface_store(&f->surface, f->store, why);
    double *swap = f->before;
    f->before = f->xyz, f->xyz = swap;
    return st;
}

/* Tell whether a frame is a look because of its time, and whether it is one at all. */
static bool is_timed(const struct run_file *f, double time)
{
    const struct run_keep *keep = f->keep;

    return f->next < keep->times && time > keep->time[f->next] - f->run->scene.step / 2;
}

static bool is_due(const struct run_file *f, int frames, int last, double time)
{
    const int every = f->keep->every;

    return is_timed(f, time) || (every && (frames % every == 0 || frames == last));
}

/* Has the next frame tell its forces if it is a look: that may cost it something. */
static enum status ask(struct run_file *f, const struct motion *m)
{
    const struct run *run = f->run;

    return f->pushers && is_due(f, m->frames + 1, m->frame_count, m->time + run->scene.step)
               ? run->model->forces(run->state, NULL, NULL)
               : STATUS_OK;
}

enum status run_file_watch(void *context, const struct motion *m, struct message *why)
{
    struct run_file *f = context;
    const struct run_keep *keep = f->keep;
    const bool all = keep->fields == RUN_FIELDS_ALL;
    const bool timed = is_timed(f, m->time);
    const bool due = is_due(f, m->frames, m->frame_count, m->time);
    const double start = clock_now();
    enum status st = STATUS_OK;

    if (!due && !all)
        return ask(f, m);
    TRY(sample(f, m->time, &m->counters));
    f->waits = true;
    f->next += timed;
    if (due && keep->truth)
        keep->truth(keep->context, m->time, f->xyz, f->truth + f->looks.count,
                    f->truth + f->looks.room + f->looks.count);
    if (due)
        TRY(take(f, all || (timed && keep->fields == RUN_FIELDS_TIMES), why));
    TRY(ask(f, m));
    f->seconds += clock_now() - start;
out:
    return st;
}

enum status run_file_rest(struct run_file *f, const struct counters *work,
                          struct message *why)
{
    CALL(sample(f, 0, work));
    return take(f, f->keep->fields != RUN_FIELDS_NONE, why);
}

enum status run_file_seconds(struct run_file *f, const char *phase, const double *seconds,
                             int repeats, int columns, struct message *why)
{
    f->created |= !strcmp(phase, "create");
    f->advanced |= !strcmp(phase, "advance") || !strcmp(phase, "equilibrium");
    return f->store ? store_seconds(f->store, phase, seconds, repeats, columns, why)
                    : STATUS_OK;
}

enum status run_file_bytes(struct run_file *f, double bytes, struct message *why)
{
    return f->store ? store_number(f->store, "model_bytes", bytes, why) : STATUS_OK;
}

/* Stores the forces or the moments of a support or an obstacle. */
static enum status store_push(const struct run_file *f, int pusher, bool moments,
                              struct message *why)
{
    const int supports = f->run->scene.support_count, count = f->looks.count;
    const bool body = pusher >= supports;
    struct arena own SCOPED(arena_clear) = {0};
    double(*value)[3] = arena_take(&own, (size_t)count, sizeof *value);
    const char *name =
        arena_print(&own, "%s/%s_%d", moments ? "moments" : "forces",
                    body ? "obstacle" : "support", body ? pusher - supports : pusher);

    for (int n = 0; n < count; n++)
        memcpy(value[n], f->pushed[pusher * f->looks.room + n] + (moments ? 3 : 0),
               sizeof *value);
    return store_vectors(f->store, name, moments ? "N m" : "N", (const double(*)[3])value,
                         count, why);
}

static enum status store_series(struct run_file *f, struct message *why)
{
    const struct looks *l = &f->looks;

    for (int n = 0; n < LOOKS_SERIES; n++)
        CALL(store_metric(f->store, looks_series[n].name, looks_series[n].unit,
                          l->series[n], l->count, why));
    for (int n = 0; n < 2 * f->pushers; n++)
        CALL(store_push(f, n / 2, n % 2, why));
    for (int n = 0; n < LOOKS_TRUTH && f->truth; n++)
        CALL(store_metric(f->store, looks_truth[n], "1", f->truth + n * l->room, l->count,
                          why));
    return f->run->model->energy
               ? store_metric(f->store, "energy_drift", "1", l->drift, l->count, why)
               : STATUS_OK;
}

enum status run_file_end(struct run_file *f, struct message *why)
{
    enum status st = STATUS_OK;

    if (f->ended)
        return st;
    if (f->waits)
        st = take(f, true, why);
    if (!f->net.flat.nodes)
        looks_recount(&f->looks, &f->run->scene, f->before);
    if (f->run->state)
        f->run->model->size(f->run->state, &f->size);
    if (f->run->state && f->run->model->doubt)
        f->run->model->doubt(f->run->state, &f->doubt);
    arena_clear(&f->fields);
    f->ended = true;
    return st;
}

/* Stores the warnings about the run that are also printed on standard error. */
static enum status store_warnings(const struct run_file *f, const struct run_result *r,
                                  struct message *why)
{
    char *text SCOPED(scope_free) = NULL;
    size_t size = 0;
    FILE *file = open_memstream(&text, &size);
    enum status st = STATUS_MEMORY;

    if (!file)
        return st;
    if (*r->distrust.text)
        fprintf(file, "%s\n", r->distrust.text);
    if (*f->run->adapted.text)
        fprintf(file, "%s\n", f->run->adapted.text);
    warnings_print(f->run, "", file);
    if (*f->doubt.text)
        fprintf(file, "%s\n", f->doubt.text);
    if (fclose(file) == 0)
        st = *text ? store_text(f->store, "warnings", text, why) : STATUS_OK;
    return st;
}

static enum status complete(struct run_file *f, const struct motion *m,
                            const struct run_result *r, struct message *why)
{
    const struct run *run = f->run;
    struct store *store = f->store;

    CALL(store_size(store, &f->size, why));
    CALL(store_warnings(f, r, why));
    if (*r->distrust.text)
        CALL(store_text(store, "distrust", r->distrust.text, why));
    CALL(store_series(f, why));
    if (!f->created)
        CALL(store_seconds(store, "create", &run->create_seconds, 1, 0, why));
    if (!f->advanced && m && m->steps)
        CALL(store_seconds(store, "advance", m->seconds, 1, m->steps, why));
    CALL(store_seconds(store, "look", &f->seconds, 1, 0, why));
    if (f->refused)
        CALL(store_text(store, "note", f->sentence.text, why));
    if (r->outcome)
        store_death(store, r->outcome, r->death_time);
    f->store = NULL; /* closing frees it, whatever comes of it */
    return store_close(store, why);
}

enum status run_file_close(struct run_file *f, const struct motion *m,
                           struct run_result *result, struct message *why)
{
    struct run_result r = {.outcome = f->refused ? f->refused
                                      : m        ? m->death
                                                 : STATUS_OK,
                           .death_time = m && m->death ? m->death_time : NAN};
    enum status st = STATUS_OK;

    if (f->refused && status_is_death(f->refused))
        r.death_time = 0;
    TRY(run_file_end(f, why));
    r.quick = f->keep->quick;
    r.create_seconds = f->run->create_seconds;
    r.look_seconds = f->seconds;
    for (int n = 0; m && n < m->steps; n++)
        r.step_seconds += m->seconds[n];
    r.steps = m ? m->steps : 0;
    r.work = f->work;
    run_result_tell(&r, f->sentence.text);
    looks_reduce(&f->looks, &f->run->scene, r.outcome, r.death_time, &r.work, r.value);
    distrust(f->run, r.value, &r.distrust);
    if (f->store)
        TRY(complete(f, m, &r, why));
    if (result)
        *result = r;
out:
    run_file_discard(f);
    return st;
}

bool run_file_refused(const struct run_file *f)
{
    return f->refused != STATUS_OK;
}

/* Stores a refusal of the model as a result; fails with what is a failure of ours. */
static enum status refuse(struct run_file *f, enum status st, const struct message *said,
                          struct message *why)
{
    if (st != STATUS_UNSUPPORTED && st != STATUS_INPUT && !status_is_death(st))
        return status_fail(why, st, "%s", said->text);
    f->refused = st;
    f->sentence = *said;
    return STATUS_OK;
}

static enum status settle(struct run *run, struct run_file *f, struct message *why)
{
    struct counters work = {0};
    struct message said = {""};
    const enum status st = run_settle(run, &work, &said);

    return st ? refuse(f, st, &said, why) : run_file_rest(f, &work, why);
}

enum status run_file_follow(const struct case_plan *c, struct run *run, struct motion *m,
                            struct run_file **file, struct message *why)
{
    struct run_file *f SCOPED(run_file_discard_scope) = NULL;
    struct message said = {""};
    const enum status built = run_build(run, &said);

    CALL(run_file_open(run, &c->keep, &f, why));
    if (built) {
        CALL(refuse(f, built, &said, why));
    } else if (c->rest) {
        CALL(settle(run, f, why));
    } else {
        motion_init(m, run->model, &run->scene, run->state);
        m->until = c->until;
        CALL(motion_run(m, run_file_watch, f, true, why));
    }
    *file = f, f = NULL;
    return STATUS_OK;
}

enum status run_file_make(const struct case_plan *c, struct run *run,
                          struct run_result *result, struct message *why)
{
    struct run_file *f;
    struct motion m SCOPED(motion_clear) = {0};

    CALL(run_file_follow(c, run, &m, &f, why));
    return run_file_close(f, m.model ? &m : NULL, result, why);
}

enum status run_file_write(const struct case_plan *c, struct run_result *result,
                           struct message *why)
{
    struct run run SCOPED(run_close) = {0};

    CALL(run_read(&run, c, why));
    return run_file_make(c, &run, result, why);
}

enum status run_file_lost(const struct case_plan *c, const struct run *run,
                          const struct message *said, struct message *why)
{
    struct run_file *f;
    enum status st = run_file_open(run, &c->keep, &f, why);

    if (st != STATUS_OK)
        return st;
    refuse(f, STATUS_INPUT, said, why);
    return run_file_close(f, NULL, NULL, why);
}

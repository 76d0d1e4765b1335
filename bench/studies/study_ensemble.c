#include "bench/studies/study_ensemble.h"

#include <math.h>
#include <omp.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/files/folder.h"
#include "bench/files/seal.h"
#include "bench/harness/pool.h"
#include "bench/harness/run_file.h"
#include "bench/truth/truth_plan.h"
#include "models/metric/metric.h"
#include "models/metric/waves.h"
#include "models/reader/scene_file.h"

#define STUDY_ENSEMBLE_TEXT(code, name, unit, words) name,
const char *const study_ensemble_name[] = {STUDY_ENSEMBLE_LIST(STUDY_ENSEMBLE_TEXT)};
#undef STUDY_ENSEMBLE_TEXT
#define STUDY_ENSEMBLE_TEXT(code, name, unit, words) unit,
const char *const study_ensemble_unit[] = {STUDY_ENSEMBLE_LIST(STUDY_ENSEMBLE_TEXT)};
#undef STUDY_ENSEMBLE_TEXT
#define STUDY_ENSEMBLE_TEXT(code, name, unit, words) words,
const char *const study_ensemble_words[] = {STUDY_ENSEMBLE_LIST(STUDY_ENSEMBLE_TEXT)};
#undef STUDY_ENSEMBLE_TEXT

/* A run is given up after [s]: the longest takes a minute. */
static const double TIME_LIMIT = 3600;

/* Where a job is. */
struct place {
    int scene, ensemble, member;
};

static struct place place_of(const struct study_ensemble_job *job, long number)
{
    const int ensembles = STUDY_ENSEMBLE_TRUTHS + job->models;
    const long rest = number / job->runs;

    return (struct place){(int)(rest / ensembles), (int)(rest % ensembles),
                          (int)(number % job->runs)};
}

/* What the pool's calls need. */
struct work {
    const struct study_ensemble_job *job;
    unsigned long program;
};

enum { MADE_FOR = 96 };

/* Sums of all that a run depends on. */
static enum status made_for(const struct work *w, struct place at,
                            const struct settings *settings, char text[MADE_FOR],
                            struct message *why)
{
    char *bytes = NULL;
    size_t size = 0;
    unsigned long sum = 0;
    enum status st;

    TRY(named_file_read(&scene_file_kind, w->job->scene[at.scene].path, &bytes, &size,
                        why));
    sum = seal_text_sum(0, bytes, size);
    for (int n = 0; n < settings->count; n++)
        sum = seal_text_sum(sum, settings->text[n], strlen(settings->text[n]) + 1);
    snprintf(text, MADE_FOR, "a run of an ensemble to %g s, settings %08lx program %08lx",
             w->job->scene[at.scene].until, sum, w->program);
out:
    free(bytes);
    return st;
}

static int times_of(double until, double time[STUDY_ENSEMBLE_FIELDS])
{
    const long frames = lround(until / TRUTH_PLAN_FRAME);
    const int count = frames < STUDY_ENSEMBLE_FIELDS ? (int)frames : STUDY_ENSEMBLE_FIELDS;

    for (int n = 0; n < count; n++)
        time[n] = TRUTH_PLAN_FRAME * round((double)((n + 1) * frames) / count);
    return count;
}

/* The program's own numbers of a look. */
enum { OWN = 1 + STUDY_ENSEMBLE_WAVES_8 - STUDY_ENSEMBLE_WAVES + 1 };

static enum status look(void *context, const struct motion *m, const double *xyz,
                        double *value)
{
    double band[WAVES_BANDS];

    (void)context;
    value[0] = metric_mean_drop(m->scene, xyz);
    waves_spectrum(m->scene, xyz, band);
    memcpy(value + 1, band, (OWN - 1) * sizeof *value);
    return STATUS_OK;
}

static enum status write_run(const struct work *w, struct place at, struct message *why)
{
    const struct study_ensemble_job *job = w->job;
    struct settings settings = {0};
    struct run_plan plan = {.path = job->scene[at.scene].path, .settings = &settings};
    double time[STUDY_ENSEMBLE_FIELDS];
    char path[STUDY_ENSEMBLE_PATH], key[MADE_FOR];
    struct run_own own[OWN] = {{"mean_drop", "1"}};
    struct scene scene = {0};
    enum status st;

    for (int n = 1; n < OWN; n++)
        own[n].name = study_ensemble_name[STUDY_ENSEMBLE_WAVES + n - 1], own[n].unit = "1";
    TRY(settings_read_scene(&settings, plan.path, &scene, why));
    plan.end = job->scene[at.scene].until;
    TRY(study_ensemble_settings(job, at.scene, at.ensemble, at.member, &plan.contestant,
                                &settings, why));
    TRY(made_for(w, at, &settings, key, why));
    study_ensemble_file(job, at.scene, at.ensemble, at.member, path);
    st = run_file_write(&plan,
                        &(struct run_keep){.file = path,
                                           .every = (int)lround(TRUTH_PLAN_FRAME /
                                                                truth_plan_frame(&scene)),
                                           .times = times_of(plan.end, time),
                                           .time = time,
                                           .packed = true,
                                           .quick = job->quick,
                                           .made_for = key,
                                           .own_count = OWN,
                                           .own = own,
                                           .own_look = look},
                        NULL, why);
out:
    scene_clear(&scene);
    settings_clear(&settings);
    return st;
}

static enum status work(void *context, long number, struct message *why)
{
    const struct work *w = context;

    return write_run(w, place_of(w->job, number), why);
}

/* A run that came to no result is none of the model's: it ends the study. */
static enum status settle(void *context, long number, const struct child_end *end,
                          struct message *why)
{
    const struct work *w = context;
    const struct place at = place_of(w->job, number);
    char path[STUDY_ENSEMBLE_PATH];

    if (end->outcome == CHILD_DONE)
        return STATUS_OK;
    study_ensemble_file(w->job, at.scene, at.ensemble, at.member, path);
    return status_fail(why, STATUS_FAILED, "%s: %s", path, end->why.text);
}

static enum status is_done(const struct work *w, long number, bool *done,
                           struct message *why)
{
    const struct place at = place_of(w->job, number);
    const struct contestant *c;
    struct settings settings = {0};
    struct run_result r = {0};
    char path[STUDY_ENSEMBLE_PATH], key[MADE_FOR];
    enum status st;

    *done = at.member >= w->job->scene[at.scene].runs;
    if (*done)
        return STATUS_OK;
    TRY(study_ensemble_settings(w->job, at.scene, at.ensemble, at.member, &c, &settings,
                                why));
    TRY(made_for(w, at, &settings, key, why));
    study_ensemble_file(w->job, at.scene, at.ensemble, at.member, path);
    *done = access(path, F_OK) == 0 &&
            run_result_read(path, false, &r, NULL) == STATUS_OK && !strcmp(r.made_for, key);
out:
    run_result_clear(&r);
    settings_clear(&settings);
    return st;
}

enum status study_ensemble_run(const struct study_ensemble_job *job, int slots, long *ran,
                               struct message *why)
{
    struct work w = {.job = job};
    struct pool pool = {.slots = slots,
                        .time_limit = TIME_LIMIT,
                        .context = &w,
                        .work = work,
                        .settle = settle};
    bool *done = NULL;
    enum status st;

    pool.count = (long)job->scenes * (STUDY_ENSEMBLE_TRUTHS + job->models) * job->runs;
    TRY(folder_make(job->folder, why));
    TRY(seal_text_program(&w.program, why));
    done = calloc((size_t)pool.count, sizeof *done);
    TRY(done ? STATUS_OK : STATUS_MEMORY);
    for (long n = 0; n < pool.count; n++)
        TRY(is_done(&w, n, &done[n], why));
    pool.done = done;
    TRY(pool_run(&pool, why));
    if (pool.stopped_by) {
        fprintf(stderr,
                "clothbench: stopped; the same command goes on with what is in %s\n",
                job->folder);
        pool_raise(&pool);
    }
    st = study_ensemble_keep(job, why);
    if (ran)
        *ran = pool.ran;
out:
    free(done);
    return st;
}

/* Enough to see a change grow. */
enum { FEW = 4 };

static enum status choose_runs(struct study_ensemble_job *job, int scene,
                               struct message *why)
{
    struct study_ensemble e;
    const enum status st = study_ensemble_read(job, scene, &e, why);

    if (st != STATUS_OK)
        return st;
    for (int n = 0; n < STUDY_ENSEMBLE_TRUTHS; n++)
        if (study_ensemble_horizon(&e, n) >= 0)
            job->scene[scene].runs = job->runs;
    study_ensemble_clear(&e);
    return st;
}

enum status study_ensemble_run_all(struct study_ensemble_job *job, int slots,
                                   struct message *why)
{
    enum status st;

    for (int n = 0; n < job->scenes; n++)
        job->scene[n].runs = job->runs < FEW ? job->runs : FEW;
    TRY(study_ensemble_run(job, slots, NULL, why));
    if (job->runs <= FEW)
        return st;
    for (int n = 0; n < job->scenes; n++)
        TRY(choose_runs(job, n, why));
    st = study_ensemble_run(job, slots, NULL, why);
out:
    return st;
}

/* --- the experiment ----------------------------------------------------------------------
 */

static enum status measure(const struct experiment_options *options, struct message *why)
{
    struct study_ensemble_job job;
    enum status st;

    TRY(study_ensemble_choose(options, &job, why));
    const int slots = omp_get_num_procs();
    omp_set_num_threads(1);
    st = study_ensemble_run_all(&job, slots, why);
out:
    return st;
}

static enum status print(const char *folder, enum table_format format, FILE *file,
                         struct message *why)
{
    struct study_ensemble_job job;
    struct study_ensemble e;
    enum status st;

    TRY(study_ensemble_find(folder, &job, why));
    for (int n = 0; n < job.scenes; n++) {
        TRY(study_ensemble_read(&job, n, &e, why));
        st = study_ensemble_tell(&e, folder, format, file, why);
        study_ensemble_clear(&e);
        TRY(st);
    }
out:
    return st;
}

const struct experiment study_ensemble_experiment = {
    .item = {"ensemble",
             "beyond the horizon: motions that cannot be predicted, compared as "
             "distributions"},
    .chooses = true,
    .measure = measure,
    .print = print,
};

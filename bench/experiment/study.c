#include "bench/experiment/study.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "bench/experiment/batch.h"
#include "bench/files/folder.h"
#include "bench/harness/timing.h"
#include "bench/truth/truth.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

enum { PATH = 4096, NAME = 512 };

/* Writes the name of a level's result file, which in a sweep is a number. */
static void name_of(const struct plan *plan, const struct plan_study *study,
                    const struct plan_level *level, char name[NAME])
{
    long number = level - study->levels + 1;

    for (const struct plan_study *s = plan->studies; s < study; s++)
        number += s->level_count;
    if (plan_is_study(plan))
        snprintf(name, NAME, "%s_%s", study->name, level->name);
    else
        snprintf(name, NAME, "case_%06ld", number);
}

static void file_of(const struct plan *plan, const struct plan_study *study,
                    const struct plan_level *level, const char *folder, char path[PATH])
{
    char name[NAME];

    name_of(plan, study, level, name);
    snprintf(path, PATH, "%s/%s.h5", folder, name);
}

static bool begins(const char *text, const char *with)
{
    return !strncmp(text, with, strlen(with));
}

/* The requests for a study's truth that is not stored yet. */
static const struct truth_wish wish = {.error = 0.005, .seconds = 240, .alone = true},
                               quick_wish = {.error = TRUTH_MOST_ERROR, .alone = true};

/* Leaves out times behind the last one that is stored, if only earlier ones are known. */
static enum status cut_times(const char *path, const struct settings *physics, int *times,
                             const double *time, struct message *why)
{
    struct truth *all = NULL;
    struct message none = {""};
    double last = 0;
    int count = 0, early = 0;
    enum status st = time ? truth_find(path, physics, *times, time, NULL, &all, &none) : 0;

    truth_destroy(all);
    if (!time || (st != STATUS_FILE && st != STATUS_UNSUPPORTED))
        return STATUS_OK;
    CALL(truth_stored_times(path, physics, time[*times - 1], 1, &last, &count, why));
    while (count && early < *times && time[early] <= last + 1e-9)
        early++;
    *times = early ? early : *times;
    return STATUS_OK;
}

/* Finds the truth of a study, which depends on its physics and not on its nets and steps,
 * at the first of its times. It is made where nothing is known and a wish is given. */
static enum status find_truth(const struct plan *plan, const struct plan_study *study,
                              int times, const double *time, const char *folder,
                              const struct truth_wish *made_by, struct truth **truth,
                              struct message *why)
{
    struct settings physics SCOPED(settings_clear) = {0};
    struct plan_case c SCOPED(plan_case_clear) = {0};
    char kept[PATH];

    CALL(plan_case_level(plan, study, NULL, false, &c, why));
    for (int n = 0; n < c.run.settings.count; n++)
        if (!begins(c.run.settings.text[n], "discretization.") &&
            !begins(c.run.settings.text[n], "time."))
            settings_set(&physics, c.run.settings.text[n]);
    if (study->truth == PLAN_TRUTH_PLATE)
        return truth_of_plate(c.run.path, &physics, times,
                              time ? time : (double[]){INFINITY}, truth, why);
    snprintf(kept, sizeof kept, "%s/%s_truth", folder, study->name);
    CALL(cut_times(c.run.path, &physics, &times, time, why));
    if (made_by)
        CALL(folder_make(kept, why));
    return made_by ? truth_find_or_make(c.run.path, &physics, times, time, kept, made_by,
                                        truth, why)
                   : truth_find(c.run.path, &physics, times, time, kept, truth, why);
}

/* Returns whether a scene has no truth, which is told with the numbers and ends nothing:
 * none is claimed, or the run that was to be it died. */
static bool has_none(enum status st)
{
    return st == STATUS_UNSUPPORTED || status_is_death(st);
}

/* Adds a level to what is measured together. */
static enum status add_level(const struct plan *plan, const struct plan_study *study,
                             const struct plan_level *level, bool quick_run,
                             struct batch *batch, struct message *why)
{
    const bool quick = quick_run && study->quick_count;
    const int times = quick ? study->quick_count : study->time_count;
    const double *time = quick ? study->quick_times : study->times;
    const int timed = level->timed < 0 ? study->timed : level->timed;
    const int most = quick_run ? TIMING_REPEATS_QUICK : timed;
    const bool sweep = !plan_is_study(plan);
    struct plan_case c;
    char name[NAME];
    enum status st = plan_case_level(plan, study, level, quick_run, &c, why);

    name_of(plan, study, level, name);
    if (st == STATUS_INPUT && sweep) /* read_case finds out why */
        return STATUS_OK;
    CALL(st);
    struct case_plan *m = batch_add(batch, c.run.path, c.run.contestant, name);
    settings_append(&m->settings, &c.run.settings);
    m->end = times > 0 ? time[times - 1] : 0;
    m->keep.every = plan->look;
    m->keep.intersections = plan->intersections;
    m->keep.times = times;
    m->keep.time = time;
    m->keep.fields =
        sweep && plan->keep != PLAN_KEEP_SNAPSHOTS ? RUN_FIELDS_NONE : RUN_FIELDS_TIMES;
    m->keep.doubles = !sweep && plan->reference.count > 0; /* differences may be small */
    m->rest = times == 0;
    m->timed = timed && !sweep ? CASE_FAIR : CASE_UNTIMED;
    m->repeats = most < timed ? most : timed;
    m->phases = level->phases;
    plan_case_clear(&c);
    return STATUS_OK;
}

static enum status measure_truths(const struct plan *plan, const char *folder, bool quick,
                                  struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < plan->study_count && st == STATUS_OK; n++) {
        const struct plan_study *study = &plan->studies[n];
        struct truth *truth = NULL;
        if (study->truth != PLAN_TRUTH_SCENE)
            continue;
        st = find_truth(plan, study, study->time_count, study->times, folder,
                        quick ? &quick_wish : &wish, &truth, why);
        truth_destroy(truth);
        if (has_none(st))
            st = STATUS_OK;
    }
    return st;
}

enum status study_measure(const struct plan *plan, const char *folder,
                          const struct measurement_options *options, struct message *why)
{
    struct measurement_options how = *options;
    const struct pool *pool = options->pool;
    struct batch batch = {0};
    int most = 0, lock = -1;
    enum status st = STATUS_OK;

    if (!pool || !pool->ranks || !pool->ranks->rank)
        TRY(folder_lock(folder, &lock, why));
    folder_tidy(folder);
    for (int n = 0; n < plan->study_count; n++)
        most += plan->studies[n].level_count;
    how.what = plan->name;
    how.truth = !plan_is_study(plan);
    batch_init(&batch, folder, most);
    for (int n = 0; n < plan->study_count; n++)
        for (int k = 0; k < plan->studies[n].level_count; k++)
            if (!options->quick || !plan->studies[n].levels[k].slow)
                TRY(add_level(plan, &plan->studies[n], &plan->studies[n].levels[k],
                              options->quick, &batch, why));
    TRY(batch_run(&batch, &how, why));
    TRY(measure_truths(plan, folder, options->quick, why));
out:
    if (lock >= 0)
        close(lock);
    batch_clear(&batch);
    return st;
}

/* Chooses the times: files of a quick run end earlier if the plan has times for it. */
static void choose_times(const struct plan_study *plan, struct study *s)
{
    double last = 0;

    for (int n = 0; n < plan->level_count; n++) {
        const struct run_result *r = &s->row[n].result;
        last = fmax(last, r->frames ? r->time[r->frames - 1] : 0);
    }
    const bool quick = plan->quick_count && last > 0 &&
                       last < 1.001 * plan->quick_times[plan->quick_count - 1];
    s->time = quick ? plan->quick_times : plan->times;
    s->frames = quick ? plan->quick_count : plan->time_count;
    if (!plan->time_count)
        s->frames = 1;
}

/* Returns the drop that theory has for a tip at rest. Rows share it where nothing that it
 * depends on differs. */
static double theory_of(const struct study *s, const struct study_row *row)
{
    const struct scene *scene = &row->result.scene;
    const bool linear = row->result.linear;

    for (const struct study_row *r = s->row; r < row && !s->time; r++)
        if (scene->poisson == r->result.scene.poisson &&
            scene->width == r->result.scene.width &&
            fabs(scene_gamma(&r->result.scene) / scene_gamma(scene) - 1) < 1e-12 &&
            r->result.linear == linear)
            return r->theory;
    return s->time ? NAN : truth_plate_drop(scene, linear);
}

static const struct plan_level of_truth = {.label = "truth"};

/* Reads the truth of a study, if it is to have one. */
static enum status read_truth(const struct plan *plan, const char *folder, struct study *s,
                              struct message *why)
{
    struct study_row *row = &s->row[s->plan->level_count];

    if (!s->plan->truth)
        return STATUS_OK;
    const enum status st = find_truth(plan, s->plan, s->frames, s->time, folder, NULL,
                                      &s->truth, &s->no_truth);
    for (int t = 0; st == STATUS_OK && t < s->truth->times; t++)
        row->xyz[t] = s->truth->xyz[t];
    return has_none(st) ? STATUS_OK
           : st         ? status_fail(why, st, "%s", s->no_truth.text)
                        : STATUS_OK;
}

/* Reads a case of a sweep: its result, or why there is none. */
static enum status read_case(const struct plan *plan, const struct plan_study *study,
                             const char *path, struct arena *arena, struct study_row *row)
{
    static const char later[] = "; the next sweep runs it again";
    struct run_result *r = &row->result;
    struct plan_case c SCOPED(plan_case_clear) = {0};
    struct scene scene SCOPED(scene_clear) = {0};
    struct message said = {""};
    enum status st = run_result_read(path, false, r, NULL);

    if (st == STATUS_OK && r->outcome != STATUS_INPUT)
        return st;
    CALL(st == STATUS_MEMORY ? st : STATUS_OK);
    if (r->outcome == STATUS_INPUT) {
        row->again = !*r->made_for;
        said = r->sentence;
    } else {
        st = plan_case_level(plan, study, row->level, false, &c, &said);
        if (st == STATUS_OK)
            st = plan_case_scene(&c, &scene, &said);
        CALL(st == STATUS_MEMORY ? st : STATUS_OK);
        row->again = !*said.text;
        if (row->again)
            status_fail(&said, STATUS_FILE, "its file is %s",
                        access(path, F_OK) ? "gone" : "damaged");
    }
    row->left_out = true;
    row->lost = arena_print(arena, "%s%s", said.text, row->again ? later : "");
    return STATUS_OK;
}

/* Returns the error of a case of a sweep at the worst of the kept times; infinite where it
 * or its reference died, NaN where nobody knows the reference or the model refused. */
static double reference_error(const struct run_result *r, const struct study_row *other,
                              const struct run_result *reference, const double *rest)
{
    const enum status end = other->result.outcome;
    const bool gone = (other->lost && !other->again) || status_is_death(end);
    double worst = status_is_death(r->outcome) || (!r->outcome && gone) ? INFINITY : NAN;

    for (int n = 0; !r->outcome && !other->lost && !end && n < reference->frames; n++)
        worst = fmax(worst, metric_rmse(r->xyz[n], reference->xyz[n]) /
                                metric_rmse(reference->xyz[n], rest));
    return worst;
}

/* Reads again, with its fields, the case of a row. */
static enum status read_fields(const struct plan *plan, const struct study *s, int level,
                               const char *folder, struct run_result *r)
{
    char path[PATH];

    run_result_clear(r);
    if (s->row[level].lost)
        return STATUS_OK;
    file_of(plan, s->plan, s->row[level].level, folder, path);
    return run_result_read(path, true, r, NULL);
}

/* Compares the cases of a sweep with the reference of each, of which one is held. */
static enum status compare_all(const struct plan *plan, const char *folder, struct study *s)
{
    struct run_result reference SCOPED(run_result_clear) = {0};
    struct run_result one SCOPED(run_result_clear) = {0};
    double *rest SCOPED(scope_free) = NULL;
    int held = -1;

    for (int n = 0; plan->reference.count && n < s->plan->level_count; n++) {
        const int other = plan_level_with(s->plan, s->row[n].level, &plan->reference);
        if (s->row[n].lost || other < 0)
            continue;
        CALL(read_fields(plan, s, n, folder, &one));
        if (other != held) {
            CALL(read_fields(plan, s, other, folder, &reference));
            free(rest);
            rest = s->row[other].lost ? NULL : metric_rest_field(&reference.scene);
            held = other;
        }
        s->row[n].result.value[MEASURE_REFERENCE_ERROR_MAX] =
            reference_error(&one, &s->row[other], &reference, rest);
    }
    return STATUS_OK;
}

static enum status read_one(const struct plan *plan, const struct plan_study *study,
                            const char *folder, struct study_results *d, struct study *s,
                            struct message *why)
{
    const bool sweep = !plan_is_study(plan);
    struct study_row *row;
    struct plan_case base;
    char path[PATH];
    enum status st;

    s->plan = study;
    s->row = row = arena_take(&d->arena, (size_t)study->level_count + 1, sizeof *row);
    for (int n = 0; n < study->level_count; n++) {
        row[n].level = &study->levels[n];
        row[n].left_out = d->quick && study->levels[n].slow;
        file_of(plan, study, row[n].level, folder, path);
        if (sweep)
            CALL(read_case(plan, study, path, &d->arena, &row[n]));
        else if (!row[n].left_out)
            CALL(run_result_read(path, true, &row[n].result, why));
    }
    if (sweep)
        return compare_all(plan, folder, s);
    choose_times(study, s);
    for (int n = 0; n < study->level_count; n++) {
        for (int t = 0; t < s->frames && t < row[n].result.frames; t++)
            row[n].xyz[t] = row[n].result.xyz[t];
        row[n].theory = row[n].left_out ? NAN : theory_of(s, &row[n]);
    }
    row += study->level_count;
    row->level = &of_truth;
    row->left_out = true;
    CALL(plan_case_level(plan, study, NULL, false, &base, why));
    st = plan_case_scene(&base, &row->result.scene, why);
    plan_case_clear(&base);
    CALL(st);
    s->gamma = scene_gamma(&row->result.scene);
    s->length = row->result.scene.length;
    return read_truth(plan, folder, s, why);
}

/* Returns whether the files are of a quick run, by the first that every run leaves. */
static bool is_quick(const struct plan *plan, const char *folder)
{
    const struct plan_study *study = plan->studies;
    struct run_result r SCOPED(run_result_clear) = {0};
    char path[PATH];
    int n = 0;

    while (n < study->level_count - 1 && study->levels[n].slow)
        n++;
    file_of(plan, study, &study->levels[n], folder, path);
    const bool quick = run_result_read(path, false, &r, NULL) == STATUS_OK && r.quick;
    return quick;
}

enum status study_read(const struct plan *plan, const char *folder, struct study_results *r,
                       struct message *why)
{
    enum status st = STATUS_OK;

    *r = (struct study_results){
        .plan = plan, .count = plan->study_count, .quick = is_quick(plan, folder)};
    r->study = arena_take(&r->arena, (size_t)r->count, sizeof *r->study);
    file_of(plan, plan->studies, plan->studies->levels, folder, r->machine);
    for (int n = 0; n < r->count; n++)
        TRY(read_one(plan, &plan->studies[n], folder, r, &r->study[n], why));
out:
    if (st != STATUS_OK)
        study_clear(r);
    return st;
}

void study_clear(struct study_results *r)
{
    for (int n = 0; r->study && n < r->count; n++) {
        struct study *s = &r->study[n];
        for (int k = 0; s->row && k <= s->plan->level_count; k++)
            run_result_clear(&s->row[k].result);
        truth_destroy(s->truth);
    }
    arena_clear(&r->arena);
    *r = (struct study_results){0};
}

double study_distance(const struct place *a, const struct place *b)
{
    const double *one = a->s->row[a->level].xyz[a->time];
    const double *other = b->s->row[b->level].xyz[a->time];

    return one && other ? metric_rmse(one, other) / a->s->length : NAN;
}

int study_reference(const struct study_results *d, const struct study *s, int level)
{
    const struct plan_settings *labels = &d->plan->reference;
    const int found =
        labels->count ? plan_level_with(s->plan, s->row[level].level, labels) : -1;

    return found >= 0 && !s->row[found].left_out ? found : -1;
}

#include "bench/experiment/study.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/fit.h"
#include "bench/files/folder.h"
#include "bench/harness/registry.h"
#include "bench/experiment/timed.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/reader/scene_file.h"

static int append(const char *const *settings, const char **all, int count)
{
    for (int n = 0; n < STUDY_SETTINGS && settings[n]; n++)
        all[count++] = settings[n];
    return count;
}

/* The scene of a level (of the study by itself: NULL) and its discretization. */
static enum status read_level(const struct study *study, const struct study_level *level,
                              const struct model *model, struct scene *scene,
                              struct discretization *d, struct message *why)
{
    const char *all[3 * STUDY_SETTINGS];
    int count = append(study->settings, all, 0);
    char *path = NULL;
    enum status st;

    if (level) {
        count = append(study->numerics, all, count);
        count = append(level->settings, all, count);
    }
    if (model)
        model->defaults(d);
    TRY(scene_file_find(study->scene, &path, why));
    TRY(scene_file_read(path, count, all, scene, d, why));
    if (study->times)
        scene->end = study->time[study->times - 1];
out:
    free(path);
    return st;
}

static void file_of(const struct study *study, const struct study_level *level,
                    const char *folder, char path[TIMED_PATH])
{
    snprintf(path, TIMED_PATH, "%s/%s_%s.h5", folder, study->name, level->name);
}

/* Newton iterations are more in some frames than in others: then all are timed. */
static int frames_timed(const struct timed_case *c)
{
    bool iterates =
        c->d.kinematics == KINEMATICS_NONLINEAR || !strcmp(c->model->name, "shell");

    return iterates ? (int)lround(c->scene->end / c->scene->step) : 0;
}

static enum status find_truth(const struct study *study, const char *folder,
                              enum truth_effort effort, struct truth **truth,
                              struct message *why)
{
    const char *all[STUDY_SETTINGS];
    int count = append(study->settings, all, 0);
    char *path = NULL, kept[TIMED_PATH];
    enum status st;

    snprintf(kept, sizeof kept, "%s/%s_truth", folder, study->name);
    TRY(folder_make(kept, why));
    TRY(scene_file_find(study->scene, &path, why));
    TRY(truth_find(path, count, all, study->times, study->time, kept, effort, truth, why));
out:
    free(path);
    return st;
}

enum status study_measure(const struct study *study,
                          const struct experiment_options *options, struct message *why)
{
    struct timed_case cases[STUDY_LEVELS] = {{0}};
    struct scene scenes[STUDY_LEVELS] = {{0}};
    struct discretization d[STUDY_LEVELS] = {{{0}}};
    struct provenance provenance;
    struct truth *truth = NULL;
    enum status st = STATUS_OK;

    assert(study->count <= STUDY_LEVELS && study->times <= STUDY_TIMES);
    provenance_collect(&provenance);
    for (int n = 0; n < study->count; n++) {
        const struct study_level *level = &study->levels[n];
        struct timed_case *c = &cases[n];
        TRY(registry_find(level->model ? level->model : "iga", &c->model, why));
        TRY(read_level(study, level, c->model, &scenes[n], &d[n], why));
        c->scene = &scenes[n];
        c->d = d[n];
        c->times = study->times;
        c->time = study->time;
        c->frames = frames_timed(c);
        file_of(study, level, options->folder, c->path);
    }
    TRY(timed_measure(options, study->name, &provenance, study->count, cases, why));
    if (study->truth)
        TRY(find_truth(study, options->folder, options->quick ? TRUTH_QUICK : TRUTH_FULL,
                       &truth, why));
out:
    truth_destroy(truth);
    for (int n = 0; n < study->count; n++) {
        scene_clear(&scenes[n]);
        discretization_clear(&d[n]);
    }
    return st;
}

static void measure_frame(const struct scene *scene, const double *xyz,
                          struct study_frame *f)
{
    f->roughness = metric_roughness(scene, xyz);
    f->inner = metric_inner_roughness(scene, xyz);
    f->stretch = metric_stretch(scene, xyz);
    f->drop = metric_drop(scene, xyz);
    f->unevenness = metric_unevenness(scene, xyz);
}

static enum status read_frames(const struct study *study, const char *path,
                               const struct scene *scene, struct study_row *row,
                               struct message *why)
{
    const int frames =
        study->times ? study->times : 1; /* of a motion, or the equilibrium */
    struct store_read *file = NULL;
    enum status st;

    TRY(store_read_open(path, &file, why));
    for (int t = 0; t < frames && t < store_read_frames(file); t++) {
        struct study_frame *f = &row->frame[t];
        f->xyz = malloc(3 * GRID_POINTS * sizeof *f->xyz);
        if (!f->xyz)
            TRY(STATUS_MEMORY);
        TRY(store_read_frame(file, t, f->xyz, why));
        measure_frame(scene, f->xyz, f);
    }
out:
    store_read_close(file);
    return st;
}

static enum status read_row(const struct study *study, const struct study_level *level,
                            const char *folder, struct study_row *row, struct message *why)
{
    const struct model *model = NULL;
    struct scene scene = {0};
    struct discretization d = {0};
    struct timed_result timed = {0};
    char path[TIMED_PATH];
    enum status st;

    for (int t = 0; t < STUDY_TIMES; t++)
        row->frame[t] = (struct study_frame){NULL, NAN, NAN, NAN, NAN, NAN, NAN, NAN, NAN};
    row->milliseconds = row->seconds = NAN;
    file_of(study, level, folder, path);
    TRY(timed_read(path, &timed, why));
    if (timed.refused) {
        snprintf(row->refused, sizeof row->refused, "%.255s", timed.refused);
        goto out;
    }
    snprintf(row->outcome, sizeof row->outcome, "%.255s", timed.outcome);
    row->unknowns = timed.unknowns;
    row->factor_entries = timed.factor_entries;
    TRY(registry_find(level->model ? level->model : "iga", &model, why));
    TRY(read_level(study, level, model, &scene, &d, why));
    if (timed.step.count) {
        row->milliseconds = 1e3 * timed.step.median;
        row->seconds = timed.step.median * scene.end / scene.step;
    }
    TRY(read_frames(study, path, &scene, row, why));
out:
    timed_clear(&timed);
    scene_clear(&scene);
    discretization_clear(&d);
    return st;
}

static void compare(const struct study *study, struct study_result *r, int t)
{
    const double *finest = NULL, *next = NULL;

    for (int n = study->count - 1; n >= 0; n--) {
        struct study_frame *f = &r->row[n].frame[t];
        if (!f->xyz)
            continue;
        if (next)
            f->next = metric_rmse(f->xyz, next) / r->length;
        if (finest)
            f->finest = metric_rmse(f->xyz, finest) / r->length;
        if (r->truth)
            f->error = metric_rmse(f->xyz, r->truth->xyz[t]) / r->length;
        next = f->xyz;
        finest = finest ? finest : next;
    }
}

enum status study_read(const struct study *study, const char *folder,
                       struct study_result *r, struct message *why)
{
    struct scene scene = {0};
    struct discretization unused = {0};
    enum status st;

    memset(r, 0, sizeof *r);
    TRY(read_level(study, NULL, NULL, &scene, &unused, why));
    r->gamma = scene_gamma(&scene);
    r->length = scene.length;
    for (int n = 0; n < study->count; n++)
        TRY(read_row(study, &study->levels[n], folder, &r->row[n], why));
    if (study->truth)
        TRY(find_truth(study, folder, TRUTH_READ, &r->truth, why));
    for (int t = 0; t < study->times; t++) {
        if (r->truth)
            measure_frame(&scene, r->truth->xyz[t], &r->true_frame[t]);
        compare(study, r, t);
    }
out:
    scene_clear(&scene);
    discretization_clear(&unused);
    if (st != STATUS_OK)
        study_result_clear(r);
    return st;
}

void study_result_clear(struct study_result *r)
{
    for (int n = 0; n < STUDY_LEVELS; n++)
        for (int t = 0; t < STUDY_TIMES; t++)
            free(r->row[n].frame[t].xyz);
    truth_destroy(r->truth);
    memset(r, 0, sizeof *r);
}

double study_order(const struct study *study, const struct study_result *r, int time)
{
    double size[STUDY_LEVELS], value[STUDY_LEVELS];
    int count = 0;

    for (int n = 0; n < study->count; n++) {
        const struct study_frame *f = &r->row[n].frame[time];
        double v = r->truth ? f->error : f->finest;
        if (isnan(v) || !(study->levels[n].size > 0))
            continue;
        size[count] = study->levels[n].size;
        value[count++] = v;
    }
    return count < (r->truth ? 3 : 2) ? NAN : fit_exponent(count, size, value);
}

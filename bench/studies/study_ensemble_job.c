#define _GNU_SOURCE /* strtok_r */
#include "bench/studies/study_ensemble.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/seal.h"
#include "bench/harness/net_fit.h"
#include "bench/truth/truth_plan.h"
#include "bench/truth/truth_level.h"
#include "iga/support_knots.h"
#include "models/reader/scene_file.h"

enum { RUNS = 32, QUICK_RUNS = 4 };

/* Spans a side of the truth's two nets, besides what knots at supports' ends take. */
enum { COARSE = 14, QUICK_COARSE = 5 };
static const double FINER = 1.4;

/* A quick one stops at [s]. */
static const double QUICK_UNTIL = 0.3;

static const char *const usual_scenes[] = {"corners_patch", "flag"};
static const char usual_models[] =
    "mass_spring_single,triangles_explicit,position_based_single,projective_dynamics_admm,"
    "hex_incompatible_incremental,iga_paper";

/* --- choosing ----------------------------------------------------------------------------
 */

static enum status choose_scene(struct study_ensemble_job *job, const char *word,
                                double until, struct message *why)
{
    const int n = job->scenes++;
    struct scene scene = {0};
    char *path = NULL;
    enum status st;

    TRY(scene_file_find(word, &path, why));
    TRY(settings_read_scene(&(struct settings){0}, path, &scene, why));
    const double *g = scene.gravity;
    if (g[0] == 0 && g[1] == 0 && g[2] == 0)
        TRY(status_fail(why, STATUS_INPUT,
                        "%s has no gravity, which an ensemble's runs are pushed by", word));
    if (!(until > 0))
        until = job->quick ? fmin(QUICK_UNTIL, scene.end) : scene.end;
    job->scene[n].until =
        TRUTH_PLAN_FRAME * floor((until + scene.step / 2) / TRUTH_PLAN_FRAME);
    if (!(job->scene[n].until >= 4 * TRUTH_PLAN_FRAME))
        TRY(status_fail(why, STATUS_INPUT, "%s, %g s: an ensemble takes %g s at least",
                        word, until, 4 * TRUTH_PLAN_FRAME));
    job->scene[n].runs = job->runs;
    snprintf(job->scene[n].path, sizeof job->scene[n].path, "%s", path);
    snprintf(job->scene[n].name, sizeof job->scene[n].name, "%s", scene.name);
    for (int k = 0; k < n; k++)
        if (!strcmp(job->scene[k].name, job->scene[n].name))
            st = status_fail(why, STATUS_INPUT, "%s is given twice", scene.name);
out:
    scene_clear(&scene);
    free(path);
    return st;
}

static enum status choose_models(struct study_ensemble_job *job, const char *list,
                                 struct message *why)
{
    enum status st = STATUS_OK;

    for (const char *word = list;; word++) {
        const int size = (int)strcspn(word, ",");
        char name[64];
        snprintf(name, sizeof name, "%.*s", size, word);
        if (job->models == STUDY_ENSEMBLE_MODELS)
            TRY(status_fail(why, STATUS_INPUT, "--models: at most %d contestants",
                            STUDY_ENSEMBLE_MODELS));
        TRY(contestant_find(name, &job->model[job->models], why));
        for (int n = 0; n < job->models; n++)
            if (job->model[n] == job->model[job->models])
                TRY(status_fail(why, STATUS_INPUT, "--models: %s is given twice", name));
        job->models++;
        word += size;
        if (!*word)
            break;
    }
out:
    return st;
}

enum status study_ensemble_choose(const struct experiment_options *o,
                                  struct study_ensemble_job *job, struct message *why)
{
    const int usual = sizeof usual_scenes / sizeof *usual_scenes;
    const int count = o->scene_count ? o->scene_count : usual;
    const char *const *scene = o->scene_count ? o->scene : usual_scenes;
    enum status st = STATUS_OK;

    *job = (struct study_ensemble_job){.folder = o->folder, .quick = o->quick};
    job->runs = o->runs ? o->runs : o->quick ? QUICK_RUNS : RUNS;
    for (int n = 0; n < count; n++)
        TRY(choose_scene(job, scene[n], o->until, why));
    TRY(choose_models(job, o->models ? o->models : usual_models, why));
out:
    return st;
}

/* --- what was chosen, kept ---------------------------------------------------------------
 */

static void job_file(const char *folder, char path[STUDY_ENSEMBLE_PATH])
{
    snprintf(path, STUDY_ENSEMBLE_PATH, "%s/ensemble.txt", folder);
}

enum status study_ensemble_keep(const struct study_ensemble_job *job, struct message *why)
{
    char path[STUDY_ENSEMBLE_PATH], text[16384];
    int at = snprintf(text, sizeof text, "ensemble %d %d\n", job->quick, job->runs);

    for (int n = 0; n < job->scenes; n++)
        at += snprintf(text + at, sizeof text - (size_t)at, "scene %s %d %.17g %s\n",
                       job->scene[n].name, job->scene[n].runs, job->scene[n].until,
                       job->scene[n].path);
    for (int n = 0; n < job->models; n++)
        at += snprintf(text + at, sizeof text - (size_t)at, "model %s\n",
                       job->model[n]->name);
    job_file(job->folder, path);
    return seal_text_write(path, text, why);
}

static bool read_line(const char *line, struct study_ensemble_job *job)
{
    char word[64];
    int quick;

    if (sscanf(line, "ensemble %d %d", &quick, &job->runs) == 2) {
        job->quick = quick;
        return job->runs > 0;
    }
    if (job->scenes < STUDIES_SCENES &&
        sscanf(line, "scene %63s %d %lf %511[^\n]", job->scene[job->scenes].name,
               &job->scene[job->scenes].runs, &job->scene[job->scenes].until,
               job->scene[job->scenes].path) == 4)
        return ++job->scenes;
    return job->models < STUDY_ENSEMBLE_MODELS && sscanf(line, "model %63s", word) == 1 &&
           contestant_find(word, &job->model[job->models++], NULL) == STATUS_OK;
}

enum status study_ensemble_find(const char *folder, struct study_ensemble_job *job,
                                struct message *why)
{
    char path[STUDY_ENSEMBLE_PATH], *text = NULL, *rest = NULL;
    enum status st;

    *job = (struct study_ensemble_job){.folder = folder};
    job_file(folder, path);
    TRY(seal_text_read(path, &text, why));
    for (char *line = strtok_r(text, "\n", &rest); line; line = strtok_r(NULL, "\n", &rest))
        if (!read_line(line, job))
            TRY(status_fail(why, STATUS_INPUT, "%s: of another version of the program: %s",
                            path, line));
out:
    free(text);
    return st;
}

/* --- who runs
 * ------------------------------------------------------------------------------
 */

void study_ensemble_file(const struct study_ensemble_job *job, int scene, int ensemble,
                         int member, char path[STUDY_ENSEMBLE_PATH])
{
    const char *who = ensemble == STUDY_ENSEMBLE_COARSE ? "truth_coarse"
                      : ensemble == STUDY_ENSEMBLE_FINE
                          ? "truth_fine"
                          : job->model[ensemble - STUDY_ENSEMBLE_TRUTHS]->name;

    snprintf(path, STUDY_ENSEMBLE_PATH, "%s/%s_%s_%03d.h5", job->folder,
             job->scene[scene].name, who, member);
}

/* The finest net of its list, of solids the one before, whose frames cost as much. */
static int side_of(const struct contestant *c, bool quick)
{
    int last = 0;

    while (last + 1 < CONTESTANT_STEPS && c->points[last + 1])
        last++;
    return c->points[quick ? 0 : c->layers && last ? last - 1 : last];
}

static void choose_net(const struct study_ensemble_job *job, const struct scene *scene,
                       int ensemble, const struct contestant *c, struct settings *settings)
{
    int side[2];

    for (int i = 0; i < 2; i++) {
        const int repeats = support_knots_repeats(scene, i, c->degree, SUPPORT_KNOTS_SOLID);
        int spans = job->quick ? QUICK_COARSE : COARSE;
        if (ensemble == STUDY_ENSEMBLE_FINE)
            spans = (int)lround(FINER * spans);
        side[i] = ensemble < STUDY_ENSEMBLE_TRUTHS ? spans + c->degree + repeats
                                                   : side_of(c, job->quick);
        const int fit = net_fit_points(scene, i, side[i], c->degree);
        side[i] = fit ? fit : side[i];
    }
    contestant_points(c, side[0], side[1], settings);
}

enum status study_ensemble_settings(const struct study_ensemble_job *job, int n,
                                    int ensemble, int member,
                                    const struct contestant **contestant,
                                    struct settings *settings, struct message *why)
{
    const char *path = job->scene[n].path;
    const struct contestant *c;
    struct scene scene = {0};
    enum status st;

    c = ensemble < STUDY_ENSEMBLE_TRUTHS ? truth_level_contestant(TRUTH_SHELL)
                                         : job->model[ensemble - STUDY_ENSEMBLE_TRUTHS];
    TRY(settings_read_scene(&(struct settings){0}, path, &scene, why));
    contestant_settings(c, settings);
    choose_net(job, &scene, ensemble, c, settings);
    /* As compare has it: a factor on the velocity is the paper's scheme's alone. */
    const char *damping = truth_plan_damping(&scene);
    if (damping && !contestant_is_paper_scheme(c))
        settings_set(settings, damping);
    settings_number(settings, "time.step", truth_plan_frame(&scene));
    st = truth_level_push(path, &(struct settings){0}, member, settings, why);
    *contestant = c;
out:
    scene_clear(&scene);
    return st;
}

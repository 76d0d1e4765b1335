#include "bench/truth/truth_level.h"

#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/provenance.h"
#include "bench/files/store_scene.h"
#include "bench/harness/run_file.h"
#include "bench/truth/truth_physics.h"

enum { PATH = 4096 };

const struct contestant *truth_level_contestant(enum truth_model model)
{
    static const char *const name[] = {"iga_reduced", "shell_3", "shell_selective_3"};
    const struct contestant *c = NULL;
    const enum status st = contestant_find(name[model], &c, NULL);

    assert(st == STATUS_OK);
    (void)st;
    return c;
}

/* The scene's gravity, changed. */
static enum status perturb(const struct truth_runs *runs, struct settings *settings,
                           struct message *why)
{
    struct scene scene = {0};
    enum status st;

    TRY(settings_read_scene(runs->settings, runs->path, &scene, why));
    double *g = scene.gravity;
    const double by =
        TRUTH_PERTURBATION * sqrt((g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) / 3);
    for (int i = 0; i < 3; i++)
        g[i] += by;
    settings_numbers(settings, "gravity", 3, g);
    scene_clear(&scene);
out:
    return st;
}

/* The contestant's own once more: nobody's --set makes it another one. */
enum status truth_level_settings(const struct truth_runs *runs,
                                 const struct truth_level *level, struct settings *settings,
                                 struct message *why)
{
    const struct contestant *c = truth_level_contestant(level->model);
    const int degree[] = {level->degree, level->degree, 1};

    settings_append(settings, runs->settings);
    contestant_settings(c, settings);
    contestant_points(c, level->side, level->side, settings);
    settings_integers(settings, "discretization.degree", c->layers ? 3 : 2, degree);
    settings_number(settings, "time.step", level->step);
    return level->perturbed ? perturb(runs, settings, why) : STATUS_OK;
}

/* The times, and perhaps later ones. */
static bool has_times(const struct run_result *r, const struct truth_runs *runs)
{
    for (int n = 0; n < runs->times; n++)
        if (n >= r->frames || !(fabs(r->time[n] - runs->time[n]) < 1e-9))
            return false;
    return true;
}

/* Made by this commit, and with as many files changed. */
static bool is_ours(const struct store_read *file)
{
    static const char *const keys[] = {"commit", "changed_files"};
    struct provenance here;
    bool same = true;

    provenance_collect(&here);
    for (int n = 0; n < 2; n++) {
        char *text = NULL;
        same &= store_read_text(file, "provenance", keys[n], &text, NULL) == STATUS_OK &&
                !strcmp(text, provenance_value(&here, keys[n]));
        free(text);
    }
    return same;
}

static bool has_physics(const char *path, const struct run_plan *plan, bool ours)
{
    struct scene kept = {0};
    struct run wanted = {0};
    struct store_read *file = NULL;
    char *physics = NULL;
    const bool same = store_read_open(path, &file, NULL) == STATUS_OK &&
                      store_scene(file, path, &kept, NULL) == STATUS_OK &&
                      run_read(&wanted, plan, NULL) == STATUS_OK &&
                      truth_physics(&kept, &physics) == STATUS_OK &&
                      truth_physics_check(physics, &wanted.scene, NULL) == STATUS_OK &&
                      (!ours || is_ours(file));

    store_read_close(file);
    scene_clear(&kept);
    run_close(&wanted);
    free(physics);
    return same;
}

/* Reads the plan's file if it is complete and of the same physics. */
static bool is_kept(const char *path, const struct run_plan *plan,
                    const struct truth_runs *runs, struct run_result *r)
{
    struct run_result found = {0};
    const bool good = run_result_read(path, true, &found, NULL) == STATUS_OK &&
                      has_times(&found, runs) && has_physics(path, plan, runs->ours);

    if (good)
        *r = found;
    else
        run_result_clear(&found);
    return good;
}

/* What a run that came to no end says. */
static enum status check(const struct run_result *r, const struct truth_level *level,
                         const struct truth_runs *runs, struct message *why)
{
    if (run_result_refused(r))
        return status_fail(why, STATUS_UNSUPPORTED,
                           "the %s, %dx%d, that was to be the truth would not: %s",
                           truth_level_contestant(level->model)->title, level->side,
                           level->side, r->sentence.text);
    if (r->frames >= runs->times)
        return STATUS_OK;
    return status_fail(why, STATUS_DIVERGED, "the %s, %dx%d, that was to be the truth %s",
                       truth_level_contestant(level->model)->title, level->side,
                       level->side, r->sentence.text);
}

enum status truth_level_find(const struct truth_runs *runs, const struct truth_level *level,
                             bool read_only, struct run_result *r, struct message *why)
{
    const struct contestant *c = truth_level_contestant(level->model);
    struct settings settings = {0};
    const struct run_plan plan = {runs->path, c, &settings, runs->time[runs->times - 1]};
    char path[PATH];
    enum status st;

    TRY(truth_level_settings(runs, level, &settings, why));
    snprintf(path, sizeof path, "%s/truth_%s_p%d_%d_%ldus%s.h5", runs->folder,
             level->model == TRUTH_CURED ? "cured" : c->model->name, level->degree,
             level->side, lround(1e6 * level->step), level->perturbed ? "_perturbed" : "");
    if (!is_kept(path, &plan, runs, r)) {
        if (read_only)
            TRY(status_fail(why, STATUS_FILE, "%s is not there, or of another run", path));
        TRY(run_file_write(
            &plan,
            &(struct run_keep){.file = path, .times = runs->times, .time = runs->time},
            NULL, why));
        TRY(run_result_read(path, true, r, why));
    }
    TRY(check(r, level, runs, why));
out:
    if (st != STATUS_OK)
        run_result_clear(r);
    settings_clear(&settings);
    return st;
}

#include "bench/truth/truth_level.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/store_scene.h"
#include "bench/truth/truth_physics.h"
#include "models/reader/scene_file.h"

static enum status read_scene(const char *path, int count, const char *const *settings,
                              struct scene *scene, struct message *why)
{
    struct discretization unused = {0};
    enum status st = scene_file_read(path, count, settings, scene, &unused, why);

    discretization_clear(&unused);
    return st;
}

/* The scene's gravity, changed. */
static enum status perturb(const struct truth_runs *runs, char *text, struct message *why)
{
    struct scene scene;
    enum status st;

    TRY(read_scene(runs->path, runs->setting_count, runs->settings, &scene, why));
    const double *g = scene.gravity;
    double by = TRUTH_PERTURBATION * sqrt((g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) / 3);
    snprintf(text, TRUTH_LEVEL_TEXT, "gravity=[%.17g,%.17g,%.17g]", g[0] + by, g[1] + by,
             g[2] + by);
    scene_clear(&scene);
out:
    return st;
}

enum status truth_level_settings(const struct truth_runs *runs,
                                 const struct truth_level *level,
                                 char text[TRUTH_LEVEL_SETTINGS][TRUTH_LEVEL_TEXT],
                                 const char **all, int *count, struct message *why)
{
    enum status st = STATUS_OK;
    bool solid = !strcmp(level->model, "iga");
    int more = 0;

    if (runs->setting_count + TRUTH_LEVEL_SETTINGS > TRUTH_MOST_SETTINGS)
        return status_fail(why, STATUS_INPUT, "--set: at most %d settings",
                           TRUTH_MOST_SETTINGS - TRUTH_LEVEL_SETTINGS);
    snprintf(text[more++], TRUTH_LEVEL_TEXT, "discretization.points=[%d,%d%s]", level->side,
             level->side, solid ? ",2" : "");
    snprintf(text[more++], TRUTH_LEVEL_TEXT, "discretization.degree=[%d,%d%s]",
             level->degree, level->degree, solid ? ",1" : "");
    snprintf(text[more++], TRUTH_LEVEL_TEXT, "discretization.kinematics=nonlinear");
    snprintf(text[more++], TRUTH_LEVEL_TEXT, "time.step=%.17g", level->step);
    if (solid)
        snprintf(text[more++], TRUTH_LEVEL_TEXT, "discretization.remedy=reduced");
    if (level->perturbed)
        TRY(perturb(runs, text[more++], why));
    for (int n = 0; n < runs->setting_count; n++)
        all[n] = runs->settings[n];
    for (int n = 0; n < more; n++)
        all[runs->setting_count + n] = text[n];
    *count = runs->setting_count + more;
out:
    return st;
}

/* The times, and perhaps later ones. */
static bool has_times(const struct store_read *file, const struct truth_runs *runs)
{
    double *time = NULL;
    int rows, columns;
    bool same =
        store_read_array(file, "xyz_time", &time, &rows, &columns, NULL) == STATUS_OK &&
        rows >= runs->times;

    for (int n = 0; same && n < runs->times; n++)
        same = fabs(time[n] - runs->time[n]) < 1e-9;
    free(time);
    return same;
}

/* Whether the plan's file is there, complete, and of the same physics. */
static bool is_kept(const struct rung_plan *plan, const struct truth_runs *runs)
{
    struct scene kept = {0}, wanted = {0};
    struct store_read *file = NULL;
    char path[4096], *a = NULL, *b = NULL;
    bool same;

    snprintf(path, sizeof path, "%s/%s.h5", plan->folder, plan->name);
    same = store_read_open(path, &file, NULL) == STATUS_OK && has_times(file, runs) &&
           store_scene(file, path, &kept, NULL) == STATUS_OK &&
           read_scene(plan->path, plan->setting_count, plan->settings, &wanted, NULL) ==
               STATUS_OK &&
           truth_physics(&kept, &a) == STATUS_OK &&
           truth_physics(&wanted, &b) == STATUS_OK && !strcmp(a, b);
    store_read_close(file);
    scene_clear(&kept);
    scene_clear(&wanted);
    free(a);
    free(b);
    return same;
}

enum status truth_level_find(const struct truth_runs *runs, const struct truth_level *level,
                             bool read_only, struct rung_result *r, struct message *why)
{
    char text[TRUTH_LEVEL_SETTINGS][TRUTH_LEVEL_TEXT], name[TRUTH_LEVEL_TEXT];
    const char *all[TRUTH_MOST_SETTINGS];
    enum status st;
    int count;

    TRY(truth_level_settings(runs, level, text, all, &count, why));
    snprintf(name, sizeof name, "truth_%s_p%d_%d_%ldus%s", level->model, level->degree,
             level->side, lround(1e6 * level->step), level->perturbed ? "_perturbed" : "");
    struct rung_plan plan = {.path = runs->path,
                             .setting_count = count,
                             .settings = all,
                             .model = level->model,
                             .times = runs->times,
                             .time = runs->time,
                             .folder = runs->folder,
                             .name = name};
    if (!is_kept(&plan, runs)) {
        if (read_only)
            return status_fail(why, STATUS_FILE, "%s/%s.h5 is not there, or of another run",
                               runs->folder, name);
        TRY(rung_run(&plan, why));
    }
    TRY(rung_read(&plan, r, why));
    if (r->frames < runs->times) {
        status_fail(why, STATUS_DIVERGED, "the %s, %dx%d, that was to be the truth: %s",
                    level->model, level->side, level->side, r->outcome);
        rung_clear(r);
        st = STATUS_DIVERGED;
    }
out:
    return st;
}

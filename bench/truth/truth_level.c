#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/files/provenance.h"
#include "bench/files/seal.h"
#include "bench/harness/run_file.h"
#include "bench/truth/truth_parts.h"

enum { PATH = 4096, KEY = sizeof((struct run_result *)0)->made_for };

static const double EARTH = 9.81; /* [m/s^2] */

const struct contestant *truth_level_contestant(enum truth_model model)
{
    static const char *const name[] = {"iga_selective_3", "shell_selective_3"};
    const struct contestant *c = NULL;
    const enum status st = contestant_find(name[model], &c, NULL);

    assert(st == STATUS_OK);
    (void)st;
    return c;
}

/* Sets, in `settings`, the gravity of the scene at `path` with settings `given`, changed by
 * TRUTH_PERTURBATION of its size along (1,1,1): whatever symmetry a scene has is gone, and
 * how fast such a change grows says how long a motion can be predicted. */
static enum status push(const char *path, const struct settings *given,
                        struct settings *settings, struct message *why)
{
    struct scene scene = {0};
    enum status st;

    TRY(contestant_read_scene(given, path, &scene, why));
    double *g = scene.gravity;
    const double mean = (g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) / 3;
    const double by = TRUTH_PERTURBATION * sqrt(mean > 0 ? mean : EARTH * EARTH / 3);
    for (int i = 0; i < 3; i++)
        g[i] += by;
    settings_numbers(settings, "gravity", 3, g);
    scene_clear(&scene);
out:
    return st;
}

/* Adds the contestant's settings last: nobody's --set makes it another one. */
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
    return level->perturbed ? push(runs->path, runs->settings, settings, why) : STATUS_OK;
}

/* Returns whether a run has these times, and perhaps later ones. */
static bool has_times(const struct run_result *r, const struct truth_runs *runs)
{
    for (int n = 0; n < runs->times; n++)
        if (n >= r->frames || !(fabs(r->time[n] - runs->time[n]) < 1e-9))
            return false;
    return true;
}

static unsigned long add(unsigned long sum, const char *text)
{
    return seal_text_sum(sum, text, strlen(text) + 1);
}

/* Writes what a level's file is made for: the physics and what the caller sets besides, by
 * these solvers (other commits may differ in words, or in what judges runs); its name has
 * the rest. */
static enum status key_of(const struct run_plan *plan, const struct settings *given,
                          char key[KEY], struct message *why)
{
    struct provenance here;
    struct run run = {0};
    char *physics = NULL;
    unsigned long sum;
    enum status st;

    TRY(run_read(&run, plan, why));
    TRY(truth_physics(&run.scene, &physics));
    provenance_collect(&here);
    sum = add(0, physics);
    sum = add(sum, provenance_value(&here, "compiler"));
    sum = add(sum, provenance_value(&here, "flags"));
    for (int n = 0; n < given->count; n++)
        if (strncmp(given->text[n], "discretization", 14) == 0)
            sum = add(sum, given->text[n]);
    snprintf(key, KEY, "a level of %08lx by solvers %.64s", sum,
             provenance_value(&here, "solvers"));
out:
    run_close(&run);
    free(physics);
    return st;
}

/* Reads a level's file if it is whole, complete and made for the same. */
static bool is_kept(const char *path, const char *key, const struct truth_runs *runs,
                    struct run_result *r)
{
    if (run_result_read(path, true, r, NULL) == STATUS_OK && has_times(r, runs) &&
        strcmp(r->made_for, key) == 0)
        return true;
    run_result_clear(r);
    return false;
}

/* Refuses a run that came to no end, with its sentence. */
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
                             struct run_result *r, struct message *why)
{
    const struct contestant *c = truth_level_contestant(level->model);
    struct settings settings = {0};
    const struct run_plan plan = {runs->path, c, &settings, runs->time[runs->times - 1]};
    char path[PATH], key[KEY];
    enum status st;

    TRY(truth_level_settings(runs, level, &settings, why));
    TRY(key_of(&plan, runs->settings, key, why));
    snprintf(path, sizeof path, "%s/truth_%s_p%d_%d_%ldus%s.h5", runs->folder,
             level->model == TRUTH_SOLID ? "selective" : "cured", level->degree,
             level->side, lround(1e6 * level->step), level->perturbed ? "_perturbed" : "");
    if (!is_kept(path, key, runs, r)) {
        TRY(run_file_write(
            &plan,
            &(struct run_keep){
                .file = path, .times = runs->times, .time = runs->time, .made_for = key},
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

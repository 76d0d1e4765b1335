#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/run_file.h"
#include "bench/truth/truth_making.h"
#include "models/pattern.h"

enum { PATH = 4096 };

static const double EARTH = 9.81; /* [m/s^2] */

const char *truth_level_word(enum truth_model model, enum truth_net net,
                             enum truth_form form)
{
    static const char *const word[][TRUTH_MODELS][3] = {
        {{"selective solid, cured of locking", "selective solid", "solid"},
         {"Kirchhoff-Love shell, cured of locking", "cured Kirchhoff-Love shell", "shell"}},
        {{"triangles with turns at mid-edges", "triangles with turns", "turns"},
         {"triangles with slopes at edges", "triangles with slopes", "slopes"}}};

    if (net == TRUTH_MESHES && model == TRUTH_SHELL && form == TRUTH_FORM_WHOLE)
        return "triangles with slopes at edges, on another mesh";
    return word[net != TRUTH_SPLINES][model][form];
}

const struct contestant *truth_level_contestant(const struct truth_level *level)
{
    static const char *const name[] = {"iga_selective_3", "shell_selective_3"};
    const struct contestant *c = NULL;
    const enum status st =
        contestant_find(level->net ? "triangles" : name[level->model], &c, NULL);

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
    struct scene scene SCOPED(scene_clear) = {0};

    CALL(contestant_read_scene(given, path, &scene, why));
    double *g = scene.gravity;
    const double mean = (g[0] * g[0] + g[1] * g[1] + g[2] * g[2]) / 3;
    const double by = TRUTH_PERTURBATION * sqrt(mean > 0 ? mean : EARTH * EARTH / 3);
    for (int i = 0; i < 3; i++)
        g[i] += by;
    settings_numbers(settings, "gravity", 3, g);
    return STATUS_OK;
}

/* Adds the contestant's settings last: nobody's --set makes it another one. */
enum status truth_level_settings(const struct truth_runs *runs,
                                 const struct truth_level *level, struct settings *settings,
                                 struct message *why)
{
    const struct contestant *c = truth_level_contestant(level);
    const int degree[] = {level->degree, level->degree, 1};
    static const char *const bending[TRUTH_MODELS] = {"discretization.bending=midedge",
                                                      "discretization.bending=quadratic"},
                             *const seed[TRUTH_MODELS] = {"discretization.seed=0",
                                                          "discretization.seed=1"};

    settings_append(settings, runs->settings);
    contestant_settings(c, settings);
    contestant_points(c, level->side, level->side, settings);
    if (level->net == TRUTH_SPLINES)
        settings_integers(settings, "discretization.degree", c->layers ? 3 : 2, degree);
    if (level->net != TRUTH_SPLINES)
        settings_set(settings, bending[level->model]);
    if (level->net == TRUTH_MESHES) {
        settings_set(settings, "discretization.mesh=irregular");
        settings_set(settings, seed[level->model]);
    }
    if (level->net == TRUTH_OWN_MESH)
        settings_number(settings, "discretization.refine", level->refine);
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

/* Reads a level's file if it is whole, complete and made for the same. */
static bool is_kept(const struct case_plan *c, const struct truth_runs *runs,
                    struct run_result *r)
{
    if (run_result_read(c->keep.file, true, r, NULL) == STATUS_OK && has_times(r, runs) &&
        strcmp(r->made_for, c->keep.made_for) == 0)
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
                           truth_level_contestant(level)->title, level->side, level->side,
                           r->sentence.text);
    if (r->frames >= runs->times)
        return STATUS_OK;
    return status_fail(why, STATUS_DIVERGED, "the %s, %dx%d, that was to be the truth %s",
                       truth_level_contestant(level)->title, level->side, level->side,
                       r->sentence.text);
}

/* Reads a level's scene, and names its file, which may have more times than are asked for,
 * and its key: of the case without its end. */
static enum status read_level(const struct truth_runs *runs,
                              const struct truth_level *level, struct case_plan *c,
                              struct run *run, char key[CASE_KEY], struct message *why)
{
    char name[PATH];

    CALL(truth_level_settings(runs, level, &c->settings, why));
    CALL(run_read(run, c, why));
    case_key(c, &run->scene, case_program(false), key);
    run->scene.end = runs->time[runs->times - 1];
    c->until = runs->until;
    snprintf(name, sizeof name, "truth_%s_p%d_%d_%ldus%s",
             level->net ? truth_level_word(level->model, level->net, TRUTH_FORM_WORD)
             : level->model == TRUTH_SOLID ? "selective"
                                           : "cured",
             level->degree, level->side, lround(1e6 * level->step),
             level->perturbed ? "_perturbed" : "");
    c->keep =
        (struct run_keep){.times = runs->times,
                          .time = runs->time,
                          .made_for = key,
                          .intersections = pattern_starts_in_space(run->scene.pattern)};
    case_file(c, runs->folder, name);
    return STATUS_OK;
}

enum status truth_level_find(const struct truth_runs *runs, const struct truth_level *level,
                             struct run_result *r, struct message *why)
{
    struct case_plan c = {runs->path, truth_level_contestant(level)};
    struct run run = {0};
    char key[CASE_KEY];
    enum status st;

    TRY(read_level(runs, level, &c, &run, key, why));
    if (!is_kept(&c, runs, r)) {
        TRY(run_file_make(&c, &run, NULL, why));
        TRY(run_result_read(c.keep.file, true, r, why));
    }
    TRY(check(r, level, runs, why));
out:
    if (st != STATUS_OK)
        run_result_clear(r);
    run_close(&run);
    case_clear(&c);
    return st;
}

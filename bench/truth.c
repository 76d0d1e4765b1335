#include "bench/truth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/rung.h"
#include "fem_ref/kirchhoff_field.h"
#include "models/grid.h"
#include "models/metric.h"
#include "models/scene_file.h"

void truth_destroy(struct truth *t)
{
    if (!t)
        return;
    for (int n = 0; t->xyz && n < t->times; n++)
        free(t->xyz[n]);
    free(t->xyz);
    free(t->time);
    free(t->error);
    free(t);
}

static struct truth *make(int times, const double *time)
{
    struct truth *t = calloc(1, sizeof *t);

    if (!t)
        return NULL;
    t->times = times;
    t->time = malloc((size_t)times * sizeof *t->time);
    t->error = malloc((size_t)times * sizeof *t->error);
    t->xyz = calloc((size_t)times, sizeof *t->xyz);
    if (!t->time || !t->error || !t->xyz) {
        truth_destroy(t);
        return NULL;
    }
    memcpy(t->time, time, (size_t)times * sizeof *time);
    return t;
}

/* Rms displacement from rest [m]. */
static enum status displacement(const struct scene *scene, const double *xyz, double *rms)
{
    double *rest = malloc(3 * GRID_POINTS * sizeof *rest), uvw[3];

    if (!rest)
        return STATUS_MEMORY;
    for (int n = 0; n < GRID_POINTS; n++) {
        grid_point(n, uvw);
        scene_rest_point(scene, uvw, rest + 3 * n);
    }
    *rms = metric_rmse(xyz, rest);
    free(rest);
    return STATUS_OK;
}

static enum status from_kirchhoff(const struct scene *scene, struct truth *t,
                                  struct message *why)
{
    enum status st;
    struct kirchhoff_plate plate;
    struct kirchhoff *k = NULL;
    double gamma = scene_gamma(scene), rms;
    /* What linear theory leaves out (TRUTH_GAMMA), and what Kirchhoff's does. */
    double relative = KIRCHHOFF_TRANSIENT_ERROR + 0.0125 * gamma * gamma +
                      2 * pow(scene->thickness / scene->length, 2);

    TRY(kirchhoff_field_plate(scene, &plate, why));
    TRY(kirchhoff_create(&plate, KIRCHHOFF_TERMS, &k));
    for (int n = 0; n < t->times; n++) {
        t->xyz[n] = malloc(3 * GRID_POINTS * sizeof(double));
        if (!t->xyz[n])
            TRY(STATUS_MEMORY);
        TRY(kirchhoff_field_sample(k, scene, t->time[n], t->xyz[n], why));
        TRY(displacement(scene, t->xyz[n], &rms));
        t->error[n] = relative * rms;
    }
    snprintf(t->source, sizeof t->source,
             "Kirchhoff plate, modal solution exact in time; Gamma = %.3g leaves linear "
             "theory",
             gamma);
out:
    kirchhoff_destroy(k);
    return st;
}

/* Nets and steps of the shell: the truth, and the coarser one that gives its error bar. */
struct level {
    int side, divisor;
};
static const struct level fine[2] = {{36, 8}, {16, 4}}, coarse[2] = {{24, 4}, {12, 2}};

enum { MORE = 4, TEXT = 96 };

static enum status shell_run(const char *path, int count, const char *const *settings,
                             double step, struct level level, const struct truth *t,
                             const char *folder, bool read_only, struct rung_result *r,
                             struct message *why)
{
    char text[MORE][TEXT], name[TEXT];
    const char **all = malloc((size_t)(count + MORE) * sizeof *all);
    enum status st;

    if (!all)
        return STATUS_MEMORY;
    snprintf(text[0], TEXT, "discretization.points=[%d,%d]", level.side, level.side);
    snprintf(text[1], TEXT, "discretization.degree=[3,3]");
    snprintf(text[2], TEXT, "discretization.kinematics=nonlinear");
    snprintf(text[3], TEXT, "time.step=%.17g", step / level.divisor);
    snprintf(name, sizeof name, "truth_shell_%d_%d", level.side, level.divisor);
    memcpy(all, settings, (size_t)count * sizeof *all);
    for (int n = 0; n < MORE; n++)
        all[count + n] = text[n];
    struct rung_plan plan = {.path = path,
                             .setting_count = count + MORE,
                             .settings = all,
                             .model = "shell",
                             .times = t->times,
                             .time = t->time,
                             .folder = folder,
                             .name = name};
    if (rung_read(&plan, r, NULL) == STATUS_OK && r->frames == t->times) {
        free(all);
        return STATUS_OK;
    }
    rung_clear(r);
    if (!read_only)
        TRY(rung_run(&plan, why));
    TRY(rung_read(&plan, r, why));
out:
    free(all);
    return st;
}

static enum status from_shell(const char *path, int count, const char *const *settings,
                              double step, const char *folder, bool quick, bool read_only,
                              struct truth *t, struct message *why)
{
    enum status st;
    struct rung_result best = {0}, check = {0};

    TRY(shell_run(path, count, settings, step, coarse[quick], t, folder, read_only, &check,
                  why));
    TRY(shell_run(path, count, settings, step, fine[quick], t, folder, read_only, &best,
                  why));
    if (best.frames < t->times || check.frames < t->times)
        TRY(status_fail(why, STATUS_DIVERGED, "the shell that was to be the truth: %s",
                        best.frames < t->times ? best.outcome : check.outcome));
    for (int n = 0; n < t->times; n++) {
        t->xyz[n] = best.xyz[n];
        best.xyz[n] = NULL;
        t->error[n] = metric_rmse(t->xyz[n], check.xyz[n]);
    }
    snprintf(t->source, sizeof t->source,
             "nonlinear Kirchhoff-Love shell, p = 3, %dx%d, step %.4g ms; error bar: its "
             "difference from %dx%d, %.4g ms",
             fine[quick].side, fine[quick].side, 1e3 * step / fine[quick].divisor,
             coarse[quick].side, coarse[quick].side, 1e3 * step / coarse[quick].divisor);
out:
    rung_clear(&best);
    rung_clear(&check);
    return st;
}

static enum status find_shell(const char *path, int count, const char *const *settings,
                              double step, const char *folder, enum truth_effort effort,
                              struct truth *t, struct message *why)
{
    bool read_only = effort == TRUTH_READ;

    if (read_only &&
        from_shell(path, count, settings, step, folder, false, true, t, NULL) == STATUS_OK)
        return STATUS_OK;
    return from_shell(path, count, settings, step, folder, effort != TRUTH_FULL, read_only,
                      t, why);
}

enum status truth_find(const char *path, int setting_count, const char *const *settings,
                       int times, const double *time, const char *folder,
                       enum truth_effort effort, struct truth **truth, struct message *why)
{
    enum status st;
    struct scene scene = {0};
    struct discretization unused = {0};
    struct kirchhoff_plate plate;
    struct truth *t = make(times, time);

    if (!t)
        return STATUS_MEMORY;
    TRY(scene_file_read(path, setting_count, settings, &scene, &unused, why));
    if (scene_gamma(&scene) < TRUTH_GAMMA &&
        kirchhoff_field_plate(&scene, &plate, NULL) == STATUS_OK)
        TRY(from_kirchhoff(&scene, t, why));
    else
        TRY(find_shell(path, setting_count, settings, scene.step, folder, effort, t, why));
    *truth = t, t = NULL;
out:
    truth_destroy(t);
    scene_clear(&scene);
    discretization_clear(&unused);
    return st;
}

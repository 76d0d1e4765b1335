#include "bench/truth/truth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/distrust.h"
#include "bench/truth/truth_closed.h"
#include "bench/truth/truth_file.h"
#include "bench/truth/truth_plate.h"
#include "bench/truth/truth_plan.h"
#include "bench/truth/truth_sharp.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

/* One block holds all of it. */
static struct truth *make(int times, const double *time)
{
    const size_t count = (size_t)times, field = 3 * GRID_POINTS;
    struct truth *t =
        calloc(1, sizeof *t + count * (sizeof *t->xyz + (2 + field) * sizeof(double)));

    if (!t)
        return NULL;
    t->times = times;
    t->xyz = (double **)(t + 1);
    t->time = (double *)(t->xyz + count);
    t->error = t->time + count;
    for (size_t n = 0; n < count; n++)
        t->xyz[n] = t->error + count + n * field;
    memcpy(t->time, time, count * sizeof *time);
    return t;
}

void truth_destroy(struct truth *t)
{
    free(t);
}

static enum status from_kirchhoff(const struct scene *scene, struct truth *t,
                                  struct message *why)
{
    const double gamma = scene_gamma(scene);
    /* What linear theory leaves out (TRUTH_GAMMA), and what Kirchhoff's does. */
    const double relative = KIRCHHOFF_TRANSIENT_ERROR + 0.0125 * gamma * gamma +
                            2 * pow(scene->thickness / scene->length, 2);
    double *rest = metric_rest_field(scene);
    enum status st = rest ? STATUS_OK : STATUS_MEMORY;

    TRY(st);
    TRY(truth_plate_fields(scene, t->times, t->time, t->xyz, why));
    for (int n = 0; n < t->times; n++)
        t->error[n] = relative * metric_rmse(t->xyz[n], rest);
    snprintf(t->source, sizeof t->source,
             "Kirchhoff plate, modal solution exact in time; Gamma = %.3g leaves linear "
             "theory",
             gamma);
out:
    free(rest);
    return st;
}

/* Nets and steps of the shell: the truth, and the coarser one that gives its error bar. */
static const struct {
    int side, divisor;
} shells[2][2] = {{{36, 8}, {24, 4}}, {{16, 4}, {12, 2}}};

static enum status from_shell(const struct truth_runs *runs, double step, bool quick,
                              bool read_only, struct truth *t, struct message *why)
{
    struct run_result run[2] = {{0}, {0}};
    struct truth_level level[2];
    enum status st = STATUS_OK;

    for (int n = 1; n >= 0; n--) {
        level[n] = (struct truth_level){TRUTH_SHELL, 3, shells[quick][n].side,
                                        step / shells[quick][n].divisor, false};
        TRY(truth_level_find(runs, &level[n], read_only, &run[n], why));
    }
    for (int n = 0; n < t->times; n++) {
        memcpy(t->xyz[n], run[0].xyz[n], 3 * GRID_POINTS * sizeof(double));
        t->error[n] = metric_rmse(t->xyz[n], run[1].xyz[n]);
    }
    snprintf(t->source, sizeof t->source,
             "nonlinear Kirchhoff-Love shell, p = 3, %dx%d, step %.4g ms; error bar: its "
             "difference from %dx%d, %.4g ms",
             level[0].side, level[0].side, 1e3 * level[0].step, level[1].side,
             level[1].side, 1e3 * level[1].step);
    t->alone = true;
out:
    run_result_clear(&run[0]);
    run_result_clear(&run[1]);
    return st;
}

static enum status find_shell(const struct truth_runs *runs, double step,
                              enum truth_effort effort, struct truth *t,
                              struct message *why)
{
    bool read_only = effort == TRUTH_READ;

    if (read_only && from_shell(runs, step, false, true, t, NULL) == STATUS_OK)
        return STATUS_OK;
    return from_shell(runs, step, effort != TRUTH_FULL, read_only, t, why);
}

const char *truth_bar_name(const struct truth *t)
{
    return t->alone ? "one model's own bar" : "truth's error bar";
}

enum status truth_doubt(const struct scene *scene, const struct truth_made *made,
                        struct truth *t)
{
    const double percent = 100 / scene->length;
    struct message said;
    int n = 0;
    enum status st;

    t->alone =
        isinf(made->value[0][TRUTH_SOLID_BAR]) || isinf(made->value[0][TRUTH_SHELL_BAR]);
    while (n < t->times && t->error[n] <= TRUTH_MOST_ERROR * scene->length)
        n++;
    if (n < t->times && t->alone)
        snprintf(t->unresolved, sizeof t->unresolved,
                 "%s is not resolved from %.3g s on: one model alone was run, and its own "
                 "bar is %.2g %% of the length there.",
                 scene->name, t->time[n], percent * t->error[n]);
    else if (n < t->times)
        snprintf(t->unresolved, sizeof t->unresolved,
                 "%s is not resolved from %.3g s on: there solid and shell are %.2g %% of "
                 "the length apart, and their own bars are %.2g %% and %.2g %%.",
                 scene->name, t->time[n], percent * made->value[n][TRUTH_DIFFERENCE],
                 percent * made->value[n][TRUTH_SOLID_BAR],
                 percent * made->value[n][TRUTH_SHELL_BAR]);
    TRY(distrust_fields(scene, n, t->time, t->xyz, &said));
    const size_t used = strlen(t->unresolved);
    if (*said.text)
        snprintf(t->unresolved + used, sizeof t->unresolved - used,
                 "%sOf the truth itself: %s", used ? " " : "", said.text);
out:
    return st;
}

/* As sharp as is wished. */
static enum status from_sharp(const struct truth_runs *runs, const struct scene *scene,
                              const struct truth_wish *wish, struct truth *t,
                              struct message *why)
{
    struct truth_made made = {0};
    struct truth_verdict verdict;
    char text[TRUTH_WISH_TEXT];
    enum status st;

    TRY(truth_sharp_make(runs, scene, &(struct truth_sharp){scene->step, stderr}, wish,
                         &made, &verdict, text, why));
    if (verdict.answer == TRUTH_LOST)
        TRY(status_fail(why, STATUS_UNSUPPORTED, "no truth of %s: %s", scene->name, text));
    for (int n = 0; n < t->times; n++) {
        memcpy(t->xyz[n], made.xyz[n], 3 * GRID_POINTS * sizeof(double));
        t->error[n] = made.value[n][TRUTH_ERROR];
    }
    snprintf(t->source, sizeof t->source, "%s", made.note);
    TRY(truth_doubt(scene, &made, t));
out:
    truth_made_clear(&made);
    return st;
}

/* With a wish; without one, the shell by effort. A factor a step is another damping at
 * every step, the truth's own too. */
static enum status find_run(const struct truth_runs *runs, const struct scene *scene,
                            enum truth_effort effort, const struct truth_wish *wish,
                            struct truth *t, struct message *why)
{
    if (truth_plan_damping(scene))
        return status_fail(why, STATUS_UNSUPPORTED,
                           "no truth of %s: its velocities are scaled by a factor each "
                           "step, which is no rate and has no limit; it has one with "
                           "damping {kind: none} or {kind: mass}",
                           scene->name);
    return wish ? from_sharp(runs, scene, wish, t, why)
                : find_shell(runs, scene->step, effort, t, why);
}

/* Index of a stored time, -1 if it has none. */
static int stored_index(const struct truth_made *made, double time)
{
    for (int n = 0; n < made->times; n++)
        if (fabs(made->time[n] - time) < 1e-9)
            return n;
    return -1;
}

/* Copies what is stored for the times of t. *found is false if a time is missing.
 * STATUS_UNSUPPORTED: one is past the horizon. */
static enum status take(const struct scene *scene, const struct truth_made *made,
                        struct truth *t, bool *found, struct message *why)
{
    double horizon = made->claimed ? made->time[made->claimed - 1] : 0;
    bool ends = made->claimed < made->times;

    *found = false;
    for (int n = 0; n < t->times; n++) {
        if (ends && t->time[n] > horizon + 1e-9)
            return status_fail(why, STATUS_UNSUPPORTED,
                               "no truth is claimed for %s at %.3g s: its motion is known "
                               "to %.3g s (clothbench truth %s --stored)",
                               scene->name, t->time[n], horizon, scene->name);
        const int k = stored_index(made, t->time[n]);
        if (k < 0)
            return STATUS_OK;
        memcpy(t->xyz[n], made->xyz[k], 3 * GRID_POINTS * sizeof(double));
        t->error[n] = made->value[k][TRUTH_ERROR];
    }
    snprintf(t->source, sizeof t->source, "stored: %s", made->note);
    *found = true;
    return STATUS_OK;
}

/* The stored truth of the scene, if its physics are these; else made->times is 0. */
static enum status read_stored(const struct scene *scene, struct truth_made *made,
                               struct message *why)
{
    struct message said = {""};
    const enum status st = truth_file_find(scene->name, scene, made, &said);

    if (st == STATUS_FILE || st == STATUS_UNSUPPORTED) /* and that is no error to tell */
        return STATUS_OK;
    return st ? status_fail(why, st, "%s", said.text) : st;
}

enum status truth_known(const struct scene *scene, struct truth_made *made,
                        struct message *why)
{
    enum status st = truth_closed_make(scene, made);

    if (st != STATUS_UNSUPPORTED)
        return st;
    st = read_stored(scene, made, why);
    if (st == STATUS_OK)
        truth_made_thin(made, scene);
    return st;
}

/* STATUS_UNSUPPORTED: none, or not so early. */
static enum status from_closed(const struct scene *scene, struct truth *t)
{
    char source[TRUTH_CLOSED_SOURCE];
    const enum status st =
        truth_closed_fields(scene, t->times, t->time, t->xyz, t->error, source);

    if (st == STATUS_OK)
        snprintf(t->source, sizeof t->source, "%s", source);
    return st;
}

enum status truth_stored_times(const char *path, const struct settings *settings,
                               double until, int most, double *time, int *count,
                               struct message *why)
{
    struct scene scene = {0};
    struct truth_made made = {0};
    enum status st;
    int last = 0;

    *count = 0;
    TRY(settings_read_scene(settings, path, &scene, why));
    TRY(truth_known(&scene, &made, why));
    while (last < made.claimed && made.time[last] <= until + 1e-9)
        last++;
    *count = last < most ? last : most;
    for (int n = 0; n < *count; n++)
        time[n] = made.time[last - *count + n];
out:
    truth_made_clear(&made);
    scene_clear(&scene);
    return st;
}

static enum status find(const char *path, const struct settings *settings, int times,
                        const double *time, const char *folder, enum truth_effort effort,
                        const struct truth_wish *wish, struct truth **truth,
                        struct message *why)
{
    enum status st;
    struct scene scene = {0};
    struct kirchhoff_plate plate;
    struct truth *t = make(times, time);
    const struct truth_runs runs = {path, settings, times, time, folder};
    struct truth_made made = {0};
    bool found;

    if (!t)
        return STATUS_MEMORY;
    TRY(settings_read_scene(settings, path, &scene, why));
    st = from_closed(&scene, t);
    if (st != STATUS_UNSUPPORTED) {
        TRY(st);
    } else if (scene_gamma(&scene) < TRUTH_GAMMA &&
               kirchhoff_field_plate(&scene, &plate, NULL) == STATUS_OK) {
        TRY(from_kirchhoff(&scene, t, why));
    } else {
        TRY(read_stored(&scene, &made, why));
        TRY(take(&scene, &made, t, &found, why));
        if (!found)
            TRY(find_run(&runs, &scene, effort, wish, t, why));
    }
    *truth = t, t = NULL;
out:
    truth_destroy(t);
    truth_made_clear(&made);
    scene_clear(&scene);
    return st;
}

enum status truth_find(const char *path, const struct settings *settings, int times,
                       const double *time, const char *folder, enum truth_effort effort,
                       struct truth **truth, struct message *why)
{
    return find(path, settings, times, time, folder, effort, NULL, truth, why);
}

enum status truth_find_sharp(const char *path, const struct settings *settings, int times,
                             const double *time, const char *folder,
                             const struct truth_wish *wish, struct truth **truth,
                             struct message *why)
{
    return find(path, settings, times, time, folder, TRUTH_FULL, wish, truth, why);
}

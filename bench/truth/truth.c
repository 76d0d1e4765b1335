#include "bench/truth/truth.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/harness/distrust.h"
#include "bench/truth/truth_making.h"
#include "fem_ref/kirchhoff.h"
#include "models/bodies/body_shape.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

/* --- A scene as its truth moves --- */

static bool is_at(double time, double other)
{
    return fabs(time - other) < 1e-9;
}

bool truth_plan_judges(const struct scene *scene, double time)
{
    bool judged = is_at(time, round(time / 0.1) * 0.1);

    for (int n = 0; n < scene->snapshot_count; n++)
        judged |= is_at(scene->snapshots[n], time);
    return judged;
}

/* Refuses a sheet that nothing holds and that lies within a thickness on an obstacle. */
static enum status check_drape(const struct scene *scene, struct message *why)
{
    if (!scene->obstacle_count || scene->support_count)
        return STATUS_OK;
    double *rest SCOPED(scope_free) = metric_rest_field(scene);
    CALL(rest ? STATUS_OK : STATUS_MEMORY);
    if (body_shape_least_gap(scene, 0, GRID_POINTS, rest) <= scene->thickness)
        return status_fail(
            why, STATUS_UNSUPPORTED,
            "%s has no truth: it is laid on an obstacle, and a drape has many "
            "equilibria, of which net and round-off choose one; claimed of each "
            "is that it is in balance, its energy, and whether it is stable "
            "(run %s --static); dropped onto an obstacle a sheet has a truth "
            "for a while, as sphere",
            scene->name, scene->name);
    return STATUS_OK;
}

enum status truth_plan_check(const struct scene *scene, struct message *why)
{
    for (int n = 0; n < scene->support_count; n++) {
        const struct scene_support *s = &scene->supports[n];
        if (scene_grips(s))
            return status_fail(
                why, STATUS_UNSUPPORTED,
                "%s has no truth: support %d takes hold or lets go, which stops or frees "
                "points at once, and refinement has not been seen to agree on what follows",
                scene->name, n);
        if (!(s->hi[0] > s->lo[0]) && !(s->hi[1] > s->lo[1]))
            return status_fail(
                why, STATUS_UNSUPPORTED,
                "%s has no truth: support %d holds a point, and the motion of a sheet that "
                "is held at points has no limit under refinement (a point of a solid holds "
                "nothing); held at patches it has one, as corners_patch, for which a truth "
                "is claimed",
                scene->name, n);
    }
    return check_drape(scene, why);
}

const char *truth_plan_damping(const struct scene *scene)
{
    return scene->damping.kind == DAMPING_VELOCITY_SCALE ? "damping={kind: none}" : NULL;
}

enum status truth_plan_scene(const char *path, struct settings *settings,
                             struct scene *scene, struct message *why)
{
    const char *damping;

    CALL(contestant_read_scene(settings, path, scene, why));
    damping = truth_plan_damping(scene);
    if (!damping)
        return STATUS_OK;
    scene_clear(scene);
    settings_set(settings, damping);
    return contestant_read_scene(settings, path, scene, why);
}

/* --- A truth as it was made or read --- */

void truth_init(struct truth *t, int times, int claimed, const double *time)
{
    const size_t count = (size_t)times, field = 3 * GRID_POINTS;

    *t = (struct truth){.times = times, .claimed = claimed};
    t->xyz = arena_take(&t->arena, count, sizeof *t->xyz);
    t->time = arena_take(&t->arena, count, sizeof *t->time);
    t->error = arena_take(&t->arena, count, sizeof *t->error);
    t->value = arena_take(&t->arena, count, sizeof *t->value);
    for (int n = 0; n < claimed; n++)
        t->xyz[n] = arena_take(&t->arena, field, sizeof **t->xyz);
    memcpy(t->time, time, count * sizeof *time);
    for (int n = 0; n < times; n++)
        for (int c = TRUTH_PACKING; c < TRUTH_COLUMNS; c++)
            t->value[n][c] = NAN;
}

void truth_clear(struct truth *t)
{
    arena_clear(&t->arena);
    *t = (struct truth){0};
}

void truth_destroy(struct truth *t)
{
    if (t)
        truth_clear(t);
    free(t);
}

int truth_index(const struct truth *t, int count, double time)
{
    for (int n = 0; n < count; n++)
        if (is_at(t->time[n], time))
            return n;
    return -1;
}

void truth_thin(struct truth *t, const struct scene *scene)
{
    const int last = t->claimed - 1;
    int times = 0, claimed = 0;

    for (int n = 0; n < t->times; n++) {
        if (!truth_plan_judges(scene, t->time[n]) && (n != last || claimed))
            continue;
        t->time[times] = t->time[n];
        t->xyz[times] = t->xyz[n];
        t->error[times] = t->error[n];
        memcpy(t->value[times], t->value[n], sizeof *t->value);
        times++;
        claimed += n <= last;
    }
    t->times = times;
    t->claimed = claimed;
}

enum status truth_known(const struct scene *scene, struct truth *made, struct message *why)
{
    enum status st = truth_closed_make(scene, made);

    if (st == STATUS_UNSUPPORTED)
        st = truth_file_find(scene->name, scene, made, why);
    if (st == STATUS_FILE && truth_plan_check(scene, why) != STATUS_OK)
        st = STATUS_UNSUPPORTED;
    return st;
}

enum status truth_judged(const struct scene *scene, struct truth *made, struct message *why)
{
    struct message said = {""};
    const enum status st = truth_known(scene, made, &said);

    if (st == STATUS_OK && !made->closed)
        truth_thin(made, scene);
    if (st == STATUS_OK || st == STATUS_FILE || st == STATUS_UNSUPPORTED)
        return STATUS_OK;
    return status_fail(why, st, "%s", said.text);
}

enum status truth_stored_times(const char *path, const struct settings *settings,
                               double until, int most, double *time, int *count,
                               struct message *why)
{
    struct scene scene SCOPED(scene_clear) = {0};
    struct truth made SCOPED(truth_clear) = {0};
    int last = 0;

    *count = 0;
    CALL(contestant_read_scene(settings, path, &scene, why));
    CALL(truth_judged(&scene, &made, why));
    while (last < made.claimed && made.time[last] <= until + 1e-9)
        last++;
    *count = last < most ? last : most;
    for (int n = 0; n < *count; n++)
        time[n] = made.time[last - *count + n];
    return STATUS_OK;
}

/* --- A truth at given times --- */

static enum status from_kirchhoff(const struct scene *scene, bool linear, struct truth *t,
                                  struct message *why)
{
    const double gamma = scene_gamma(scene);
    /* Linear theory leaves out the second term (TRUTH_GAMMA), Kirchhoff's the third. */
    const double relative = KIRCHHOFF_TRANSIENT_ERROR +
                            (linear ? 0 : 0.0125 * gamma * gamma) +
                            2 * pow(scene->thickness / scene->length, 2);
    double *rest SCOPED(scope_free) = metric_rest_field(scene);

    CALL(rest ? STATUS_OK : STATUS_MEMORY);
    CALL(kirchhoff_field(scene, KIRCHHOFF_TERMS, t->times, t->time, t->xyz, why));
    for (int n = 0; n < t->times; n++)
        t->error[n] = relative * metric_rmse(t->xyz[n], rest);
    snprintf(t->source, sizeof t->source,
             linear ? "Kirchhoff plate, modal solution exact in time"
                    : "Kirchhoff plate, modal solution exact in time; Gamma = %.3g leaves "
                      "linear theory",
             gamma);
    return STATUS_OK;
}

const char *truth_bar_name(const struct truth *t)
{
    return t->alone ? "one model's own bar" : "truth's error bar";
}

void truth_doubt(const struct scene *scene, struct truth *t)
{
    const double percent = 100 / scene->length;
    struct message said;
    int n = 0;

    t->alone = isinf(t->value[0][TRUTH_SOLID_BAR]) || isinf(t->value[0][TRUTH_SHELL_BAR]);
    while (n < t->times && t->error[n] <= TRUTH_MOST_ERROR * scene->length)
        n++;
    if (n < t->times && t->alone)
        snprintf(t->unresolved, sizeof t->unresolved,
                 "%s is not resolved from %.3g s on: one model alone was run, and its own "
                 "bar is %.2g %% of the length there.",
                 scene->name, t->time[n], percent * t->error[n]);
    else if (n < t->times)
        snprintf(t->unresolved, sizeof t->unresolved,
                 "%s is not resolved from %.3g s on: there %s and %s are %.2g %% of "
                 "the length apart, and their own bars are %.2g %% and %.2g %%.",
                 scene->name, t->time[n],
                 truth_level_word(TRUTH_SOLID, truth_plan_net(scene), TRUTH_FORM_WORD),
                 truth_level_word(TRUTH_SHELL, truth_plan_net(scene), TRUTH_FORM_WORD),
                 percent * t->value[n][TRUTH_DIFFERENCE],
                 percent * t->value[n][TRUTH_SOLID_BAR],
                 percent * t->value[n][TRUTH_SHELL_BAR]);
    distrust_fields(scene, n, t->time, t->xyz, &said);
    if (*said.text)
        TEXT_JOIN(t->unresolved, " ", "Of the truth itself: %s", said.text);
}

/* Copies what is stored for the times of t. STATUS_FILE: a time is missing;
 * STATUS_UNSUPPORTED: one is past the horizon. */
static enum status take(const struct scene *scene, const struct truth *made,
                        struct truth *t, struct message *why)
{
    const double horizon = made->claimed ? made->time[made->claimed - 1] : 0;

    for (int n = 0; n < t->times; n++) {
        const int k = truth_index(made, made->times, t->time[n]);
        if (made->claimed < made->times && t->time[n] > horizon + 1e-9)
            return status_fail(why, STATUS_UNSUPPORTED,
                               "no truth is claimed for %s at %.3g s: its motion is known "
                               "to %.3g s (clothbench truth %s --stored)",
                               scene->name, t->time[n], horizon, scene->name);
        if (k < 0)
            return STATUS_FILE;
        memcpy(t->xyz[n], made->xyz[k], 3 * GRID_POINTS * sizeof(double));
        memcpy(t->value[n], made->value[k], sizeof *t->value);
        t->error[n] = made->error[k];
    }
    return STATUS_OK;
}

/* Fills t with what needs no file: a closed form, or the plate. */
static enum status from_theory(const struct scene *scene, struct truth *t,
                               struct message *why)
{
    struct kirchhoff_plate plate;
    const enum status st = truth_closed_fields(scene, t);

    if (st != STATUS_UNSUPPORTED || !(scene_gamma(scene) < TRUTH_GAMMA) ||
        kirchhoff_field_plate(scene, &plate, NULL) != STATUS_OK)
        return st;
    return from_kirchhoff(scene, false, t, why);
}

/* Fills t with the truth of a name or a file; of other physics is none (STATUS_FILE). */
static enum status from_file(const char *name, const char *before,
                             const struct scene *scene, struct truth *t,
                             struct message *why)
{
    struct truth made SCOPED(truth_clear) = {0};
    struct message said = {""};
    enum status st = truth_file_find(name, scene, &made, &said);

    if (st == STATUS_UNSUPPORTED)
        st = STATUS_FILE;
    if (st == STATUS_OK)
        st = take(scene, &made, t, why);
    else if (st != STATUS_FILE)
        status_fail(why, st, "%s", said.text);
    snprintf(t->source, sizeof t->source, "%s%.511s", before, made.source);
    return st;
}

enum { PATH = 4096 };

/* Returns the file that truth_find_or_make leaves in a folder. */
static const char *left_in(const char *folder, char path[PATH])
{
    snprintf(path, PATH, "%s/truth.h5", folder);
    return path;
}

static enum status from_folder(const char *folder, const struct scene *scene,
                               struct truth *t, struct message *why)
{
    char path[PATH];
    const enum status st = from_file(left_in(folder, path), "", scene, t, why);

    if (st == STATUS_OK)
        truth_doubt(scene, t);
    return st;
}

/* Makes one, and leaves it in the folder of its runs. */
static enum status make_one(const struct truth_runs *runs, const struct truth_wish *wish,
                            const struct scene *scene, struct truth *t, struct message *why)
{
    struct truth_end end;
    char path[PATH];

    truth_clear(t);
    CALL(truth_make(runs, scene, wish, t, &end, why));
    if (end.answer == TRUTH_LOST)
        return status_fail(why, STATUS_UNSUPPORTED, "no truth of %s: %s", scene->name,
                           end.text);
    truth_doubt(scene, t);
    return truth_file_write(left_in(runs->folder, path), runs, t, why);
}

/* Fills t with what is known or, with a wish, made in the folder; without, left there. */
static enum status fill(struct truth_runs *runs, const struct truth_wish *wish,
                        const struct scene *scene, struct truth *t, struct message *why)
{
    enum status st = from_theory(scene, t, why);

    runs->frame = scene->step;
    if (st == STATUS_UNSUPPORTED)
        st = from_file(scene->name, "stored: ", scene, t, why);
    if (st == STATUS_FILE && truth_plan_damping(scene))
        return status_fail(why, STATUS_UNSUPPORTED,
                           "no truth of %s: its velocities are scaled by a factor each "
                           "step, which is no rate and has no limit; it has one with "
                           "damping {kind: none} or {kind: mass}",
                           scene->name);
    if (wish)
        runs->until = wish->until;
    if (st == STATUS_FILE && wish)
        return make_one(runs, wish, scene, t, why);
    if (st == STATUS_FILE && runs->folder)
        st = from_folder(runs->folder, scene, t, NULL);
    if (st == STATUS_FILE)
        status_fail(why, st, "nothing is known of %s with these physics at these times",
                    scene->name);
    return st;
}

/* Finds or makes one; `plate`: by linear theory, whatever else is known. */
static enum status find(struct truth_runs *runs, const struct truth_wish *wish, bool plate,
                        struct truth **truth, struct message *why)
{
    struct scene scene SCOPED(scene_clear) = {0};
    struct truth *t SCOPED(truth_destroy_scope) = calloc(1, sizeof *t);

    if (!t)
        arena_end();
    truth_init(t, runs->times, runs->times, runs->time);
    CALL(contestant_read_scene(runs->settings, runs->path, &scene, why));
    CALL(plate ? from_kirchhoff(&scene, true, t, why) : fill(runs, wish, &scene, t, why));
    *truth = t, t = NULL;
    return STATUS_OK;
}

enum status truth_of_plate(const char *path, const struct settings *settings, int times,
                           const double *time, struct truth **truth, struct message *why)
{
    return find(&(struct truth_runs){path, settings, times, time}, NULL, true, truth, why);
}

enum status truth_find(const char *path, const struct settings *settings, int times,
                       const double *time, const char *folder, struct truth **truth,
                       struct message *why)
{
    return find(&(struct truth_runs){path, settings, times, time, folder}, NULL, false,
                truth, why);
}

enum status truth_find_or_make(const char *path, const struct settings *settings, int times,
                               const double *time, const char *folder,
                               const struct truth_wish *wish, struct truth **truth,
                               struct message *why)
{
    return find(&(struct truth_runs){path, settings, times, time, folder, .say = stderr},
                wish, false, truth, why);
}

#include "bench/truth/truth_plan.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MS 1e-3

/* Chosen so that a truth takes a quarter of an hour on one processor; the last is for
 * scenes that are not named (strip_swing, thick and stiff take a minute). On corners_patch
 * every net has a knot at the patches' edges.
 */
static const struct truth_plan plans[] = {
    {"edge_drop", 1.0, 1.5, {{3, {16, 24, 36}, 5 * MS}, {5, {16, 24, 32}, 5 * MS}}},
    {"flag", 0.6, 0.8, {{3, {12, 18, 27}, 5 * MS}, {5, {10, 14, 18}, 5 * MS}}},
    {"corners_patch", 0.3, 1, {{3, {13, 23, 33}, 5 * MS}, {3, {13, 23, 33}, 5 * MS}}},
    {"sphere", 0.3, 0.3, {{2, {8, 11, 15}, 2.5 * MS}, {3, {9, 12, 16}, 2.5 * MS}}},
    {"strip_swing", 0.5, 1, {{3, {12, 18, 27}, 2.5 * MS}, {3, {12, 18, 27}, 2.5 * MS}}},
    {"thick", 0.5, 1, {{3, {12, 18, 27}, 2.5 * MS}, {3, {12, 18, 27}, 2.5 * MS}}},
    {"stiff", 0.5, 1, {{3, {12, 18, 27}, 2.5 * MS}, {3, {12, 18, 27}, 2.5 * MS}}},
    {NULL, 0.5, 5, {{3, {12, 18, 27}, 2.5 * MS}, {4, {12, 18, 27}, 2.5 * MS}}},
};

static const struct truth_plan quick_plan = {
    NULL, 0.2, 0.2, {{3, {8, 12, 16}, 2.5 * MS}, {3, {8, 12, 16}, 2.5 * MS}}};

struct truth_plan truth_plan_of(const char *scene, bool quick)
{
    const struct truth_plan *p = plans;

    while (p->scene && strcmp(p->scene, scene) != 0)
        p++;
    return quick ? quick_plan : *p;
}

static bool is_multiple(double t, double step)
{
    return fabs(t - round(t / step) * step) < 1e-9;
}

static int compare_times(const void *a, const void *b)
{
    const double *left = a, *right = b;

    return (*left > *right) - (*left < *right);
}

int truth_plan_times(const struct truth_plan *plan, const struct scene *scene,
                     double **time)
{
    int tenths = (int)floor(10 * plan->until + 1e-9), count = 0, kept = 0;
    double longest = 4 * fmax(plan->ladder[0].step, plan->ladder[1].step);
    double *t = malloc((size_t)(tenths + scene->snapshot_count + 1) * sizeof *t);

    if (!t)
        return -1;
    for (int n = 1; n <= tenths; n++)
        t[count++] = n / 10.0;
    for (int n = 0; n < scene->snapshot_count; n++)
        if (scene->snapshots[n] <= plan->until && scene->snapshots[n] > 0 &&
            is_multiple(scene->snapshots[n], longest))
            t[count++] = scene->snapshots[n];
    qsort(t, (size_t)count, sizeof *t, compare_times);
    for (int n = 0; n < count; n++)
        if (!kept || t[n] > t[kept - 1] + 1e-9)
            t[kept++] = t[n];
    *time = t;
    return kept;
}

const char *truth_plan_damping(const struct scene *scene)
{
    return scene->damping.kind == DAMPING_VELOCITY_SCALE ? "damping={kind: none}" : NULL;
}

enum status truth_plan_scene(const char *path, struct settings *settings,
                             struct scene *scene, struct message *why)
{
    enum status st;
    const char *damping;

    TRY(settings_read_scene(settings, path, scene, why));
    damping = truth_plan_damping(scene);
    if (!damping)
        return STATUS_OK;
    scene_clear(scene);
    settings_set(settings, damping);
    TRY(settings_read_scene(settings, path, scene, why));
out:
    return st;
}

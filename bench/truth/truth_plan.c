#include "bench/truth/truth_plan.h"

#include <math.h>
#include <stdlib.h>

#include "iga/support_knots.h"
#include "models/contact.h"
#include "models/grid.h"
#include "models/metric/metric_rest.h"

static bool is_multiple(double t, double step)
{
    return fabs(t - round(t / step) * step) < 1e-9;
}

static int compare_times(const void *a, const void *b)
{
    const double *left = a, *right = b;

    return (*left > *right) - (*left < *right);
}

int truth_plan_times(double until, double longest, const struct scene *scene, double **time)
{
    const int frames = (int)floor(until / TRUTH_PLAN_FRAME + 1e-9);
    int count = 0, kept = 0;
    double *t = malloc((size_t)(frames + scene->snapshot_count + 1) * sizeof *t);

    if (!t)
        return -1;
    for (int n = 1; n <= frames; n++)
        t[count++] = n / round(1 / TRUTH_PLAN_FRAME);
    for (int n = 0; n < scene->snapshot_count; n++)
        if (scene->snapshots[n] <= until && scene->snapshots[n] > 0)
            t[count++] = scene->snapshots[n];
    qsort(t, (size_t)count, sizeof *t, compare_times);
    for (int n = 0; n < count; n++)
        if (is_multiple(t[n], longest) && (!kept || t[n] > t[kept - 1] + 1e-9))
            t[kept++] = t[n];
    *time = t;
    return kept;
}

bool truth_plan_judges(const struct scene *scene, double time)
{
    bool judged = is_multiple(time, 0.1);

    for (int n = 0; n < scene->snapshot_count; n++)
        judged |= fabs(scene->snapshots[n] - time) < 1e-9;
    return judged;
}

/* Whether so many spans a side have a knot at every edge of what is loaded; at those of
 * what is held splines have knots by themselves. */
static bool fits(const struct scene *scene, int spans)
{
    bool good = true;

    for (int n = 0; n < scene->support_count; n++)
        for (int i = 0; i < 2; i++)
            good &= scene->supports[n].lo[i] < scene->supports[n].hi[i] ||
                    is_multiple(scene->supports[n].lo[i], 1.0 / spans);
    for (int n = 0; n < scene->load_count; n++)
        for (int i = 0; i < 2; i++)
            good &= is_multiple(scene->loads[n].lo[i], 1.0 / spans) &&
                    is_multiple(scene->loads[n].hi[i], 1.0 / spans);
    return good;
}

bool truth_plan_rung(const struct scene *scene, double frame, int k,
                     struct truth_level *level)
{
    /* Some 1.4 apart: near enough to stop in time, far enough to show an order. */
    static const int sizes[] = {1, 2, 3, 4, 6, 9, 13, 18, 26};
    enum { DEGREE = 3, LEAST = 6, SIZES = sizeof sizes / sizeof *sizes };
    int unit = 3, first = 0, repeats = 0;

    for (int i = 0; i < 2; i++)
        repeats = (int)fmax(repeats,
                            support_knots_repeats(scene, i, DEGREE, SUPPORT_KNOTS_SOLID));
    while (unit < 20 && !fits(scene, unit))
        unit++;
    unit = fits(scene, unit) ? unit : 3;
    while (unit * sizes[first] < LEAST)
        first++;
    if (k + first >= SIZES)
        return false;
    *level = (struct truth_level){.degree = DEGREE,
                                  .side = unit * sizes[k + first] + DEGREE + repeats,
                                  .repeats = repeats};
    /* Three spans for a piece of the frame. */
    level->step = frame / (sizes[k + first] * fmax(1, round(unit / 3.0)));
    return true;
}

double truth_plan_frame(const struct scene *scene)
{
    return TRUTH_PLAN_FRAME / ceil(TRUTH_PLAN_FRAME / scene->step - 1e-9);
}

/* Lying on an obstacle from the start on, within a thickness. */
static enum status lies(const struct scene *scene, bool *does)
{
    double *rest = scene->obstacle_count ? metric_rest_field(scene) : NULL;

    if (scene->obstacle_count && !rest)
        return STATUS_MEMORY;
    *does = contact_least_gap(scene, rest ? GRID_POINTS : 0, rest) <= scene->thickness;
    free(rest);
    return STATUS_OK;
}

enum status truth_plan_check(const struct scene *scene, struct message *why)
{
    bool laid = false;
    enum status st;

    for (int n = 0; n < scene->support_count; n++) {
        const struct scene_support *s = &scene->supports[n];
        if (!(s->hi[0] > s->lo[0]) && !(s->hi[1] > s->lo[1]))
            return status_fail(
                why, STATUS_UNSUPPORTED,
                "%s has no truth: support %d holds a point, and the motion of a sheet that "
                "is held at points has no limit under refinement (a point of a solid holds "
                "nothing); held at patches it has one, as corners_patch, for which a truth "
                "is claimed",
                scene->name, n);
    }
    TRY(lies(scene, &laid));
    if (laid && !scene->support_count)
        TRY(status_fail(
            why, STATUS_UNSUPPORTED,
            "%s has no truth: it is laid on an obstacle, and a drape has many "
            "equilibria, of which net and round-off choose one; claimed of each "
            "is that it is in balance, its energy, and whether it is stable "
            "(run %s --static); dropped onto an obstacle a sheet has a truth "
            "for a while, as sphere",
            scene->name, scene->name));
out:
    return st;
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

    TRY(contestant_read_scene(settings, path, scene, why));
    damping = truth_plan_damping(scene);
    if (!damping)
        return STATUS_OK;
    scene_clear(scene);
    settings_set(settings, damping);
    TRY(contestant_read_scene(settings, path, scene, why));
out:
    return st;
}

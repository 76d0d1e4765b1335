#include "bench/truth/truth_watch.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "models/metric/metric.h"

static void tell(const struct truth_runs *runs, const struct truth_level *level,
                 const struct run_result run[2], double length, char *text)
{
    double most = 0, last = runs->time[runs->times - 1];
    int n = 0;

    for (; n < runs->times && most <= TRUTH_MOST_GROWTH; n++)
        most = fmax(most, metric_rmse(run[0].xyz[n], run[1].xyz[n]) /
                              (TRUTH_PERTURBATION * length));
    if (most > TRUTH_MOST_GROWTH)
        snprintf(
            text, TRUTH_WATCH_TEXT,
            "a change of gravity by %g has grown %.2g-fold at %.3g s: from there on the "
            "motion cannot be predicted (solid, %dx%d, step %.3g ms)",
            TRUTH_PERTURBATION, most, runs->time[n - 1], level->side, level->side,
            1e3 * level->step);
    else
        snprintf(text, TRUTH_WATCH_TEXT,
                 "a change of gravity by %g grows at most %.2g-fold up to %.3g s: so long "
                 "the motion can be predicted (solid, %dx%d, step %.3g ms)",
                 TRUTH_PERTURBATION, most, last, level->side, level->side,
                 1e3 * level->step);
}

enum status truth_watch(const struct truth_plan *plan, const struct truth_runs *runs,
                        const struct scene *scene, char text[TRUTH_WATCH_TEXT],
                        struct message *why)
{
    const struct truth_ladder *ladder = &plan->ladder[TRUTH_SOLID];
    /* Nodes of a coarse net touch an obstacle one by one, in jumps that are the net's. */
    int net = scene->obstacle_count ? 1 : 0;
    struct truth_level level = {TRUTH_SOLID, ladder->degree, ladder->side[net],
                                2 * ladder->step, false};
    struct truth_runs far = *runs;
    struct run_result run[2] = {{0}};
    struct message death = {""};
    enum status st = STATUS_OK;

    far.times = (int)floor(10 * fmin(scene->end, plan->watch) + 1e-9);
    double *time = malloc(((size_t)far.times + 1) * sizeof *time);
    if (!time)
        return STATUS_MEMORY;
    for (int n = 0; n < far.times; n++)
        time[n] = (n + 1) / 10.0;
    far.time = time;
    snprintf(text, TRUTH_WATCH_TEXT, "the scene is too short to watch a change grow");
    for (int n = 0; n < 2 && far.times > 0 && st == STATUS_OK; n++) {
        level.perturbed = n;
        st = truth_level_find(&far, &level, false, &run[n], &death);
    }
    if (st == STATUS_OK && far.times > 0)
        tell(&far, &level, run, scene->length, text);
    else if (st == STATUS_DIVERGED) {
        snprintf(text, TRUTH_WATCH_TEXT, "the growth of a change was not watched: %.200s",
                 death.text);
        st = STATUS_OK;
    } else if (st != STATUS_OK && why)
        *why = death;
    run_result_clear(&run[0]);
    run_result_clear(&run[1]);
    free(time);
    return st;
}

#include "bench/truth/truth_make.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/truth/truth_bar.h"
#include "bench/ui/progress.h"

static void plan_family(const struct truth_ladder *ladder, enum truth_model model,
                        struct truth_family *f)
{
    f->count = TRUTH_BAR_RUNS;
    for (int n = 0; n < TRUTH_BAR_RUNS; n++)
        f->level[n] = (struct truth_level){
            .model = ladder->cured ? TRUTH_CURED : model,
            .degree = ladder->degree,
            .side = ladder->side[n <= TRUTH_BAR_FINE ? n : TRUTH_BAR_MIDDLE],
            .step = ladder->step,
            .grade = ladder->grade};
    f->level[TRUTH_BAR_TWICE].step *= 2;
    f->level[TRUTH_BAR_FOUR].step *= 4;
}

static enum status find_all(struct truth_family family[TRUTH_MODELS],
                            const struct truth_runs *runs, bool quiet,
                            struct run_result *pushed, struct message *why)
{
    enum { TOTAL = TRUTH_MODELS * TRUTH_BAR_RUNS + 1 };
    struct progress bar = progress_start("truth", TOTAL, quiet);
    struct truth_level push = family[TRUTH_SOLID].level[TRUTH_BAR_TWICE];
    enum status st = STATUS_OK;

    for (int n = 0; n < TOTAL - 1; n++) {
        struct truth_family *f = &family[n / TRUTH_BAR_RUNS];
        progress_update(&bar, n);
        TRY(truth_level_find(runs, &f->level[n % TRUTH_BAR_RUNS], false,
                             &f->run[n % TRUTH_BAR_RUNS], why));
    }
    push.perturbed = true;
    TRY(truth_level_find(runs, &push, false, pushed, why));
out:
    progress_end(&bar);
    return st;
}

/* The coarse solid of the plan (with obstacles, the middle one), with twice its step, every
 * tenth of a second up to the scene's end or the plan's; a sentence on the growth into
 * text. A death is one, too. */
static enum status watch(const struct truth_plan *plan, const struct truth_runs *runs,
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
        truth_bar_horizon(&(struct truth_push){level, &run[0], &run[1]}, far.times, time,
                          scene->length, text);
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

enum status truth_make(const struct truth_plan *plan, const struct truth_runs *runs,
                       const struct scene *scene, bool quiet, struct truth_made *made,
                       struct message *why)
{
    struct truth_family family[TRUTH_MODELS] = {0};
    const struct truth_family *solid = &family[TRUTH_SOLID];
    struct run_result pushed = {0};
    struct truth_push push = {{0}, &solid->run[TRUTH_BAR_TWICE], &pushed};
    enum status st;

    for (int m = 0; m < TRUTH_MODELS; m++)
        plan_family(&plan->ladder[m], (enum truth_model)m, &family[m]);
    TRY(truth_made_init(made, runs->times, runs->times, runs->time));
    TRY(find_all(family, runs, quiet, &pushed, why));
    push.level = solid->level[TRUTH_BAR_TWICE];
    truth_bar_compare(family, &push, scene->length, made);
    truth_bar_choose(family, scene->length, made);
    TRY(watch(plan, runs, scene, made->horizon, why));
out:
    for (int m = 0; m < TRUTH_MODELS; m++)
        truth_family_clear(&family[m]);
    run_result_clear(&pushed);
    if (st != STATUS_OK)
        truth_made_clear(made);
    return st;
}

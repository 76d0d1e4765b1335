#include "bench/truth/truth_make.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/truth/truth_bar.h"

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

/* Cheap ones first: what they take foretells the others. */
static const enum truth_bar_at order[TRUTH_BAR_RUNS] = {
    TRUTH_BAR_FOUR, TRUTH_BAR_TWICE, TRUTH_BAR_COARSE, TRUTH_BAR_MIDDLE, TRUTH_BAR_FINE};

static double seconds_of(const struct run_result *r)
{
    return r->create_seconds + r->step_seconds;
}

/* Unknowns, bandwidth, steps. */
static double work_of(const struct truth_level *level)
{
    return pow(level->side, 3) / level->step;
}

/* The n-th in this order, by the one before; 0: there is none. */
static double foresee(const struct truth_family *f, int n)
{
    if (n == 0)
        return 0;
    const enum truth_bar_at now = order[n], last = order[n - 1];
    return seconds_of(&f->run[last]) * work_of(&f->level[now]) / work_of(&f->level[last]);
}

/* What comes next, unless the budget forbids it. */
static enum status announce(const struct truth_make_how *how, const struct truth_family *f,
                            int n, int made, double spent, struct message *why)
{
    const double seconds = foresee(f, n);
    char text[TRUTH_BAR_LEVEL];

    truth_bar_level(&f->level[order[n]], false, text);
    if (how->seconds > 0 && seconds > 0 && spent + seconds > how->seconds)
        return status_fail(why, STATUS_FAILED,
                           "no: after %d of %d runs in %.3g s the next, the %s, takes some "
                           "%.2g s more, and the budget is %.3g s (a larger --budget goes "
                           "on from here)",
                           made, TRUTH_MODELS * TRUTH_BAR_RUNS, spent, text, seconds,
                           how->seconds);
    if (how->say && seconds > 0)
        fprintf(how->say, "truth: %d of %d runs, %.3g s; next: the %s, some %.2g s\n", made,
                TRUTH_MODELS * TRUTH_BAR_RUNS, spent, text, seconds);
    return STATUS_OK;
}

static enum status find_all(struct truth_family family[TRUTH_MODELS],
                            const struct truth_runs *runs, const struct truth_make_how *how,
                            struct run_result *pushed, struct message *why)
{
    struct truth_level push = family[TRUTH_SOLID].level[TRUTH_BAR_TWICE];
    double spent = 0;
    enum status st = STATUS_OK;

    for (int n = 0; n < TRUTH_MODELS * TRUTH_BAR_RUNS; n++) {
        struct truth_family *f = &family[n % TRUTH_MODELS];
        const int k = n / TRUTH_MODELS, at = order[k];
        TRY(announce(how, f, k, n, spent, why));
        TRY(truth_level_find(runs, &f->level[at], false, &f->run[at], why));
        spent += seconds_of(&f->run[at]);
    }
    push.perturbed = true;
    TRY(truth_level_find(runs, &push, false, pushed, why));
out:
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
        truth_bar_horizon(&(struct truth_push){level, &run[0], &run[1]}, false, far.times,
                          time, scene->length, text);
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
                       const struct scene *scene, const struct truth_make_how *how,
                       struct truth_made *made, struct message *why)
{
    struct truth_family family[TRUTH_MODELS] = {0};
    const struct truth_family *solid = &family[TRUTH_SOLID];
    struct run_result pushed = {0};
    struct truth_push push = {{0}, &solid->run[TRUTH_BAR_TWICE], &pushed};
    enum status st;

    for (int m = 0; m < TRUTH_MODELS; m++)
        plan_family(&plan->ladder[m], (enum truth_model)m, &family[m]);
    TRY(truth_made_init(made, runs->times, runs->times, runs->time));
    TRY(find_all(family, runs, how, &pushed, why));
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

#include "bench/truth/truth_make.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/ui/progress.h"
#include "models/grid.h"
#include "models/metric/metric.h"

static const double SAFETY = 1.25, UNSAFE = 3, LEAST = 0.5;

/* first / second, if errors were c h^p. */
static double ratio(const double h[3], double p)
{
    return (pow(h[0], p) - pow(h[1], p)) / (pow(h[1], p) - pow(h[2], p));
}

/* The ratio grows with p: halving. */
static double solve(const double h[3], double wanted)
{
    double low = 1e-3, high = 20;

    if (!(wanted > ratio(h, low)))
        return NAN;
    for (int n = 0; n < 60; n++) {
        double middle = (low + high) / 2;
        if (ratio(h, middle) < wanted)
            low = middle;
        else
            high = middle;
    }
    return low;
}

struct truth_order truth_order(const double h[3], double first, double second,
                               double promised)
{
    struct truth_order o = {.order = NAN};

    if (!(second > 0))
        return o;
    o.order = solve(h, first / second);
    double p = o.order >= LEAST ? fmin(o.order, promised) : LEAST;
    double left = pow(h[2], p) / (pow(h[1], p) - pow(h[2], p));
    o.bar = (o.order >= LEAST ? SAFETY : UNSAFE) * second * left;
    return o;
}

/* Of one model: coarse, middle, fine net; the middle one with twice and four times the
 * step. */
enum { COARSE, MIDDLE, FINE, TWICE, FOUR, RUNS };

struct family {
    struct truth_level level[RUNS];
    struct run_result run[RUNS];
};

/* Splines of degree p bend with errors of order min(p + 1, 2 (p - 1)) in the mean square;
 * both models' steps are of second order. */
static double promised_order(int degree)
{
    return fmin(degree + 1, 2 * (degree - 1));
}
static const double STEP_ORDER = 2;

static void plan_family(const struct truth_ladder *ladder, enum truth_model model,
                        struct family *f)
{
    for (int n = 0; n < RUNS; n++)
        f->level[n] = (struct truth_level){.model = model,
                                           .degree = ladder->degree,
                                           .side = ladder->side[n <= FINE ? n : MIDDLE],
                                           .step = ladder->step};
    f->level[TWICE].step *= 2;
    f->level[FOUR].step *= 4;
}

static double between(const struct family *f, int a, int b, int time)
{
    return metric_rmse(f->run[a].xyz[time], f->run[b].xyz[time]);
}

/* Orders and bar of one model at a time, into value[0..2] of its columns. */
static void judge(const struct family *f, int time, double *value)
{
    double h[3], step[3];

    for (int n = 0; n < 3; n++)
        h[n] = 1.0 / (f->level[n].side - f->level[n].degree);
    step[0] = f->level[FOUR].step;
    step[1] = f->level[TWICE].step;
    step[2] = f->level[MIDDLE].step;
    struct truth_order space =
        truth_order(h, between(f, COARSE, MIDDLE, time), between(f, MIDDLE, FINE, time),
                    promised_order(f->level[FINE].degree));
    struct truth_order steps = truth_order(step, between(f, FOUR, TWICE, time),
                                           between(f, TWICE, MIDDLE, time), STEP_ORDER);
    value[0] = space.order;
    value[1] = steps.order;
    value[2] = space.bar + steps.bar;
}

static void compare(const struct family family[TRUTH_MODELS],
                    const struct run_result *pushed, double length, int time,
                    double value[TRUTH_COLUMNS])
{
    judge(&family[TRUTH_SOLID], time, value + TRUTH_SOLID_SPACE);
    judge(&family[TRUTH_SHELL], time, value + TRUTH_SHELL_SPACE);
    value[TRUTH_DIFFERENCE] = metric_rmse(family[TRUTH_SOLID].run[FINE].xyz[time],
                                          family[TRUTH_SHELL].run[FINE].xyz[time]);
    value[TRUTH_GROWTH] =
        metric_rmse(family[TRUTH_SOLID].run[TWICE].xyz[time], pushed->xyz[time]) /
        (TRUTH_PERTURBATION * length);
}

int truth_made_claimed(int times, double (*value)[TRUTH_COLUMNS], double length)
{
    int n = 0;

    while (n < times && value[n][TRUTH_ERROR] <= TRUTH_MOST_ERROR * length &&
           value[n][TRUTH_GROWTH] <= TRUTH_MOST_GROWTH)
        n++;
    return n;
}

/* Error bars if this model's field is the truth. */
static void set_bars(enum truth_model model, struct truth_made *made, double length)
{
    const int bar = model == TRUTH_SOLID ? TRUTH_SOLID_BAR : TRUTH_SHELL_BAR;

    for (int n = 0; n < made->times; n++) {
        double *v = made->value[n];
        v[TRUTH_ERROR] = fmax(v[bar], v[TRUTH_DIFFERENCE]);
    }
    made->claimed = truth_made_claimed(made->times, made->value, length);
}

enum truth_model truth_made_choose(struct truth_made *made, double length)
{
    set_bars(TRUTH_SHELL, made, length);
    const int shell = made->claimed;
    set_bars(TRUTH_SOLID, made, length);
    const int solid = made->claimed;
    const double *last = made->value[solid ? solid - 1 : 0];

    if (solid != shell ? solid > shell : last[TRUTH_SOLID_BAR] <= last[TRUTH_SHELL_BAR])
        return TRUTH_SOLID;
    set_bars(TRUTH_SHELL, made, length);
    return TRUTH_SHELL;
}

static void choose(const struct family family[TRUTH_MODELS], double length,
                   struct truth_made *made)
{
    const enum truth_model best = truth_made_choose(made, length);
    const struct family *f = &family[best], *other = &family[!best];
    const struct truth_level *l = &f->level[FINE], *o = &other->level[FINE];

    made->level = *l;
    for (int n = 0; n < made->times; n++)
        memcpy(made->xyz[n], f->run[FINE].xyz[n], 3 * GRID_POINTS * sizeof(double));
    snprintf(made->note, sizeof made->note,
             "nonlinear %s, p = %d, %dx%d, step %.4g ms; error bar: its own by observed "
             "orders or, if larger, its difference from the %s, p = %d, %dx%d, %.4g ms",
             best == TRUTH_SOLID ? "solid, cured of locking" : "Kirchhoff-Love shell",
             l->degree, l->side, l->side, 1e3 * l->step,
             best == TRUTH_SOLID ? "Kirchhoff-Love shell" : "cured solid", o->degree,
             o->side, o->side, 1e3 * o->step);
}

enum status truth_made_init(struct truth_made *made, int times, int claimed,
                            const double *time)
{
    const size_t count = (size_t)times, field = 3 * GRID_POINTS;
    const size_t numbers = count * (1 + TRUTH_COLUMNS) + (size_t)claimed * field;

    *made = (struct truth_made){.times = times, .claimed = claimed};
    made->xyz = calloc(1, count * sizeof *made->xyz + (numbers + 1) * sizeof(double));
    if (!made->xyz)
        return STATUS_MEMORY;
    made->time = (double *)(made->xyz + count);
    made->value = (double(*)[TRUTH_COLUMNS])(made->time + count);
    for (int n = 0; n < claimed; n++)
        made->xyz[n] = (double *)(made->value + count) + (size_t)n * field;
    memcpy(made->time, time, count * sizeof *time);
    return STATUS_OK;
}

void truth_made_clear(struct truth_made *made)
{
    free(made->xyz);
    *made = (struct truth_made){0};
}

static enum status find_all(struct family family[TRUTH_MODELS],
                            const struct truth_runs *runs, bool quiet,
                            struct run_result *pushed, struct message *why)
{
    enum { TOTAL = TRUTH_MODELS * RUNS + 1 };
    struct progress bar = progress_start("truth", TOTAL, quiet);
    struct truth_level push = family[TRUTH_SOLID].level[TWICE];
    enum status st = STATUS_OK;

    for (int n = 0; n < TOTAL - 1; n++) {
        struct family *f = &family[n / RUNS];
        progress_update(&bar, n);
        TRY(truth_level_find(runs, &f->level[n % RUNS], false, &f->run[n % RUNS], why));
    }
    push.perturbed = true;
    TRY(truth_level_find(runs, &push, false, pushed, why));
out:
    progress_end(&bar);
    return st;
}

static void tell(const struct truth_runs *runs, const struct truth_level *level,
                 const struct run_result run[2], double length, char *text)
{
    double most = 0;
    int n = 0;

    for (; n < runs->times && most <= TRUTH_MOST_GROWTH; n++)
        most = fmax(most, metric_rmse(run[0].xyz[n], run[1].xyz[n]) /
                              (TRUTH_PERTURBATION * length));
    const bool lost = most > TRUTH_MOST_GROWTH;
    snprintf(text, TRUTH_WATCH_TEXT,
             "a change of gravity by %g %s %.2g-fold %s %.3g s: %s predicted (solid, "
             "%dx%d, step %.3g ms)",
             TRUTH_PERTURBATION, lost ? "has grown" : "grows at most", most,
             lost ? "at" : "up to", runs->time[n - 1],
             lost ? "from there on the motion cannot be" : "so long the motion can be",
             level->side, level->side, 1e3 * level->step);
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

enum status truth_make(const struct truth_plan *plan, const struct truth_runs *runs,
                       const struct scene *scene, bool quiet, struct truth_made *made,
                       struct message *why)
{
    struct family family[TRUTH_MODELS] = {0};
    struct run_result pushed = {0};
    enum status st;

    for (int m = 0; m < TRUTH_MODELS; m++)
        plan_family(&plan->ladder[m], (enum truth_model)m, &family[m]);
    TRY(truth_made_init(made, runs->times, runs->times, runs->time));
    TRY(find_all(family, runs, quiet, &pushed, why));
    for (int n = 0; n < runs->times; n++)
        compare(family, &pushed, scene->length, n, made->value[n]);
    choose(family, scene->length, made);
    TRY(watch(plan, runs, scene, made->horizon, why));
out:
    for (int m = 0; m < TRUTH_MODELS; m++)
        for (int n = 0; n < RUNS; n++)
            run_result_clear(&family[m].run[n]);
    run_result_clear(&pushed);
    if (st != STATUS_OK)
        truth_made_clear(made);
    return st;
}

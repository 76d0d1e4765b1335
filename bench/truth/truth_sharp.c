#include "bench/truth/truth_sharp.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/truth/truth_make.h"
#include "models/grid.h"
#include "models/metric/metric.h"

/* Points a side and pieces of the scene's step: both halves of an error shrink alike. */
enum { LEVELS = 6, DEGREE = 3 };
static const struct {
    int side, pieces;
} levels[LEVELS] = {{9, 2}, {12, 3}, {15, 4}, {21, 6}, {30, 9}, {42, 13}};

/* Both in space and in time, as the cured shell and its steps converge. */
static const double ORDER = 2;

/* Two runs show no order: their difference counts so many times. */
static const double UNSEEN = 3;

/* Unknowns times bandwidth times steps. */
static const double GROWTH = 4;

static double size_of(int level)
{
    return 1.0 / levels[level].pieces;
}

/* Error bar at a time, from the last two or three runs of `count`. */
static double judge(const struct run_result *run, int count, int time)
{
    const struct run_result *last = &run[count - 1];
    const double second = metric_rmse(last->xyz[time], last[-1].xyz[time]);

    if (count < 3)
        return UNSEEN * second;
    const double h[3] = {size_of(count - 3), size_of(count - 2), size_of(count - 1)};
    return truth_order(h, metric_rmse(last[-1].xyz[time], last[-2].xyz[time]), second,
                       ORDER)
        .bar;
}

static double judge_all(const struct run_result *run, int count, int times, double *error)
{
    double most = 0;

    for (int n = 0; n < times; n++) {
        error[n] = judge(run, count, n);
        most = fmax(most, error[n]);
    }
    return most;
}

static void tell(int level, double step, char source[TRUTH_SHARP_SOURCE])
{
    snprintf(source, TRUTH_SHARP_SOURCE,
             "nonlinear Kirchhoff-Love shell, cured of locking, p = %d, %dx%d, step %.4g "
             "ms; error bar: what its observed order leaves, from %s",
             DEGREE, levels[level].side, levels[level].side,
             1e3 * step / levels[level].pieces,
             level > 1 ? "three nets and steps"
                       : "two nets and steps, their difference "
                         "three times");
}

enum status truth_sharp_fields(const struct truth_runs *runs, double step, double length,
                               const struct truth_wish *wish, double *const *xyz,
                               double *error, char source[TRUTH_SHARP_SOURCE],
                               struct message *why)
{
    struct run_result run[LEVELS] = {{0}};
    enum status st = STATUS_OK;
    double spent = 0, last = 0, bar = INFINITY;
    int n = 0;

    while (n < 2 || (n < LEVELS && bar > wish->error * length &&
                     spent + GROWTH * last <= wish->seconds)) {
        const struct truth_level level = {.model = TRUTH_CURED,
                                          .degree = DEGREE,
                                          .side = levels[n].side,
                                          .step = step / levels[n].pieces};
        TRY(truth_level_find(runs, &level, false, &run[n], why));
        last = run[n].create_seconds + run[n].step_seconds;
        spent += last;
        if (++n >= 2)
            bar = judge_all(run, n, runs->times, error);
    }
    for (int t = 0; t < runs->times; t++)
        memcpy(xyz[t], run[n - 1].xyz[t], 3 * GRID_POINTS * sizeof(double));
    tell(n - 1, step, source);
out:
    for (int k = 0; k < LEVELS; k++)
        run_result_clear(&run[k]);
    return st;
}

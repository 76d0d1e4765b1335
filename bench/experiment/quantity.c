#include "bench/experiment/study.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/bench_solid.h"
#include "bench/experiment/judge.h"
#include "bench/truth/truth.h"
#include "models/grid.h"
#include "models/metric/drape.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

/* Returns the sheet there; NULL after a death. */
static const double *sheet(const struct place *p)
{
    return p->s->row[p->level].xyz[p->time];
}

/* Defines a number that a level has whatever the time. */
#define OF_LEVEL(name, value)                                                              \
    static double name(const struct place *p)                                              \
    {                                                                                      \
        const struct study_row *row = &p->s->row[p->level];                                \
        const struct run_result *r = &row->result;                                         \
        return row->left_out || run_result_refused(r) ? NAN : (value);                     \
    }

/* Defines a number of the sheet at a time, by a function of metric.h. */
#define OF_SHEET(name, metric)                                                             \
    static double name(const struct place *p)                                              \
    {                                                                                      \
        return sheet(p) ? metric(&p->s->row[p->level].result.scene, sheet(p)) : NAN;       \
    }

static double a_step(const struct run_result *r, long count)
{
    return r->outcome || !r->work.steps ? NAN : (double)count / (double)r->work.steps;
}

OF_LEVEL(size, row->level->size > 0 ? row->level->size : NAN)
OF_LEVEL(death, r->death_time)

/* Milliseconds of a summary; NaN: it was not timed. */
#define MILLISECONDS(summary, member) ((summary).count ? 1e3 * (summary).member : NAN)

static bool is_timed(const struct place *p)
{
    const int timed = p->s->row[p->level].level->timed;

    return timed < 0 ? p->s->plan->timed : timed;
}

/* Returns the seconds of all frames to the last time, each of so many, or of the
 * equilibrium; if none was timed, those of the one run. */
static double to_last_time(const struct place *p, double frame)
{
    const struct study_row *row = &p->s->row[p->level];

    return !p->s->time    ? frame
           : isnan(frame) ? row->result.step_seconds
                          : frame * p->s->time[p->s->frames - 1] / row->result.scene.step;
}

static double net(const struct run_result *r)
{
    return (double)r->points[0] * r->points[1] * (r->points[2] ? r->points[2] : 1);
}

OF_LEVEL(control_points, net(r))
OF_LEVEL(unknowns, r->unknowns)
OF_LEVEL(factor_entries, r->factor_entries)
OF_LEVEL(create, MILLISECONDS(r->create, median))
OF_LEVEL(frame, is_timed(p) ? MILLISECONDS(r->step, min) : NAN)
OF_LEVEL(frame_lower, is_timed(p) ? MILLISECONDS(r->step, lower) : NAN)
OF_LEVEL(frame_upper, is_timed(p) ? MILLISECONDS(r->step, upper) : NAN)
OF_LEVEL(assemble, MILLISECONDS(r->phase[BENCH_SOLID_ASSEMBLE], min))
OF_LEVEL(factor, MILLISECONDS(r->phase[BENCH_SOLID_FACTOR], min))
OF_LEVEL(solve, MILLISECONDS(r->phase[BENCH_SOLID_SOLVE], min))
OF_LEVEL(processor, is_timed(p) ? r->processor : NAN)
OF_LEVEL(paper, p->s->plan->truth ? NAN : row->level->paper_ms)
OF_LEVEL(seconds, to_last_time(p, quantity_at(p, QUANTITY_FRAME) / 1e3))
OF_LEVEL(factorisations, a_step(r, r->work.factorisations))
OF_LEVEL(solves, a_step(r, r->work.solves))
OF_LEVEL(iterations, a_step(r, r->work.iterations))
OF_LEVEL(tested, r->work.tested ? a_step(r, r->work.tested) : NAN)
OF_LEVEL(left, r->work.left > 0 ? r->work.left : NAN)
OF_LEVEL(loss, -r->value[MEASURE_ENERGY_DRIFT_END] / r->value[MEASURE_END_TIME])
OF_LEVEL(stiffness, r->value[MEASURE_DROP_MAX] > 1 ? r->value[MEASURE_HANGING_STRAIN] / 2 /
                                                         (r->value[MEASURE_DROP_MAX] - 1)
                                                   : NAN)
OF_SHEET(roughness, metric_roughness)
OF_SHEET(inner, metric_inner_roughness)
OF_SHEET(stretch, metric_stretch)
OF_SHEET(drop, metric_drop)
OF_SHEET(unevenness, metric_unevenness)
OF_SHEET(angle, metric_angle)

/* Returns the distance of two sheets over the length; NaN unless there are both. */
static double distance(const struct place *p, const double *xyz)
{
    return sheet(p) && xyz ? metric_rmse(sheet(p), xyz) / p->s->length : NAN;
}

static double next(const struct place *p)
{
    const double *xyz = NULL;

    for (int n = p->level + 1; n < p->s->plan->level_count && !xyz; n++)
        xyz = p->s->row[n].xyz[p->time];
    return distance(p, xyz);
}

/* The finest level that lives. */
static double finest(const struct place *p)
{
    const double *xyz = NULL;

    for (int n = p->s->plan->level_count - 1; n > p->level && !xyz; n--)
        xyz = p->s->row[n].xyz[p->time];
    return distance(p, xyz);
}

/* Returns whether the truth is known at that time: it may end before the study. */
static bool known(const struct place *p)
{
    return p->s->truth && p->time < p->s->truth->times;
}

static double error(const struct place *p)
{
    return distance(p, known(p) ? p->s->truth->xyz[p->time] : NULL);
}

OF_SHEET(crossings, metric_intersections)
OF_SHEET(drape, drape_coefficient)
OF_SHEET(folds, drape_folds)

/* At rest bodies are where their paths end. */
static double penetration(const struct place *p)
{
    const double time = p->s->time ? p->s->time[p->time] : INFINITY;

    return sheet(p) ? metric_penetration(&p->s->row[p->level].result.scene, time, sheet(p))
                    : NAN;
}

/* Measures that did not come, such as the time of a crossing, are infinite. */
#define OF_RUN(code, name, unit, sentence)                                                 \
    OF_LEVEL(of_##name, isfinite(r->value[MEASURE_##code]) ? r->value[MEASURE_##code] : NAN)
MEASURE_LIST(OF_RUN)

/* Finds the same time of the level that this one is compared with; false: there is none. */
static bool find_other(const struct place *p, struct place *other)
{
    *other = *p;
    other->level = study_reference(p->d, p->s, p->level);
    return other->level >= 0;
}

/* Compares the cost of two runs; one that died is no solution and has no such number. */
static double of_reference(const struct place *p)
{
    struct place other;

    return !find_other(p, &other) || p->s->row[p->level].result.outcome ||
                   p->s->row[other.level].result.outcome
               ? NAN
               : quantity_at(p, QUANTITY_FRAME) / quantity_at(&other, QUANTITY_FRAME);
}

static double paper_of_reference(const struct place *p)
{
    struct place other;

    return find_other(p, &other)
               ? quantity_at(p, QUANTITY_PAPER) / quantity_at(&other, QUANTITY_PAPER)
               : NAN;
}

static double apart(const struct place *p)
{
    struct place other;

    return find_other(p, &other) && other.level != p->level ? study_distance(p, &other)
                                                            : NAN;
}

/* Returns the depth of the middle of the edge u = 1 [m]. */
static double depth(const struct place *p)
{
    return sheet(p) ? -truth_plate_edge(sheet(p)) : NAN;
}

static double speed(const struct place *p)
{
    struct place before = *p;
    const double *time = p->s->time;

    if (!before.time--)
        return NAN;
    return (quantity_at(p, QUANTITY_DEPTH) - quantity_at(&before, QUANTITY_DEPTH)) /
           (time[p->time] - time[before.time]);
}

static double tip(const struct place *p)
{
    return quantity_at(p, QUANTITY_DEPTH) / p->s->length / p->s->row[p->level].theory;
}

static double tip_of_reference(const struct place *p)
{
    struct place other;

    return find_other(p, &other)
               ? quantity_at(p, QUANTITY_TIP) / quantity_at(&other, QUANTITY_TIP)
               : quantity_at(p, QUANTITY_TIP);
}

static double swing(const struct place *p)
{
    const struct study_row *row = &p->s->row[p->level];
    double *rest SCOPED(scope_free) =
        row->left_out ? NULL : metric_rest_field(&row->result.scene);
    const double angle = rest ? metric_angle(&row->result.scene, rest) : NAN;
    double most = NAN;

    for (int t = 0; t <= p->time; t++)
        if (row->xyz[t])
            most = fmax(most, metric_angle(&row->result.scene, row->xyz[t]) - angle);
    return most;
}

static double edge_moved(const struct place *p)
{
    const double *xyz = sheet(p);
    double *rest = xyz ? metric_rest_field(&p->s->row[p->level].result.scene) : NULL,
           sum = rest ? 0 : NAN;

    for (int n = GRID_U - 1; rest && n < GRID_POINTS; n += GRID_U)
        for (int c = 0; c < 3; c++)
            sum += pow(xyz[3 * n + c] - rest[3 * n + c], 2);
    free(rest);
    return sqrt(sum / (GRID_V * GRID_W));
}

static double apart_most(const struct place *p)
{
    struct place at = *p;
    double most = -INFINITY;

    for (at.time = 0; at.time < p->s->frames; at.time++)
        most = judge_most(most, quantity_at(&at, QUANTITY_APART));
    return most;
}

/* Returns the error over the way that the truth has moved. */
static double off(const struct place *p)
{
    const struct study *s = p->s;
    double *rest SCOPED(scope_free) =
        known(p) ? metric_rest_field(&s->row[p->level].result.scene) : NULL;
    const double moved = rest ? metric_rmse(s->truth->xyz[p->time], rest) : NAN;

    return quantity_at(p, QUANTITY_ERROR) * s->length / moved;
}

static double bar(const struct place *p)
{
    return known(p) ? p->s->truth->error[p->time] / p->s->length : NAN;
}

const struct quantity_row quantity_table[QUANTITIES] = {
#define ROW(code, function, name, head, unit, digits, moves, help)                         \
    [QUANTITY_##code] = {name, head, unit, digits, moves, function, help},
    QUANTITY_LIST(ROW)
#define OF_MEASURE(code, name, unit, sentence)                                             \
    [QUANTITY_##code] = {#name, #name, unit, 3, false, of_##name, sentence},
        MEASURE_LIST(OF_MEASURE)};

int quantity_find(const char *name)
{
    for (int n = 0; n < QUANTITIES; n++)
        if (!strcmp(quantity_table[n].name, name))
            return n;
    return -1;
}

double quantity_at(const struct place *p, enum quantity q)
{
    struct study_row *row = &p->s->row[p->level];

    if (!row->known[p->time][q]) {
        row->value[p->time][q] = quantity_table[q].at(p);
        row->known[p->time][q] = true;
    }
    return row->value[p->time][q];
}

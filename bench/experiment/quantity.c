#include "bench/experiment/quantity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/experiment/bench_solid.h"
#include "bench/experiment/judge.h"
#include "bench/experiment/study.h"
#include "bench/truth/truth.h"
#include "models/grid.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"

/* Numbers that a level has whatever the time. */
#define OF_LEVEL(name, value)                                                              \
    static double name(const struct study_results *d, const struct study *s, int level,    \
                       int time)                                                           \
    {                                                                                      \
        const struct study_row *row = &s->row[level];                                      \
        const struct run_result *r = &row->result;                                         \
        (void)d, (void)time, (void)r;                                                      \
        return row->left_out || run_result_refused(r) ? NAN : (value);                     \
    }

/* Members of its frame at a time. */
#define OF_FRAME(name)                                                                     \
    static double name(const struct study_results *d, const struct study *s, int level,    \
                       int time)                                                           \
    {                                                                                      \
        (void)d;                                                                           \
        return s->row[level].frame[time].name;                                             \
    }

static double a_step(const struct run_result *r, long count)
{
    return r->outcome || !r->work.steps ? NAN : (double)count / (double)r->work.steps;
}

OF_LEVEL(size, row->level->size > 0 ? row->level->size : NAN)
OF_LEVEL(death, r->death_time)

/* Of what was timed, in milliseconds. */
#define MILLISECONDS(summary, member) ((summary).count ? 1e3 * (summary).member : NAN)

static double net(const struct discretization *d)
{
    double points = 1;

    for (int i = 0; i < 3; i++)
        points *= d->points[i] ? d->points[i] : 1;
    return points;
}

OF_LEVEL(control_points, net(&row->run.discretization))
OF_LEVEL(unknowns, r->unknowns)
OF_LEVEL(factor_entries, r->factor_entries)
OF_LEVEL(create, MILLISECONDS(r->create, median))
OF_LEVEL(frame, row->milliseconds)
OF_LEVEL(frame_lower, isnan(row->milliseconds) ? NAN : MILLISECONDS(r->step, lower))
OF_LEVEL(frame_upper, isnan(row->milliseconds) ? NAN : MILLISECONDS(r->step, upper))
OF_LEVEL(assemble, MILLISECONDS(r->phase[BENCH_SOLID_ASSEMBLE], median))
OF_LEVEL(factor, MILLISECONDS(r->phase[BENCH_SOLID_FACTOR], median))
OF_LEVEL(solve, MILLISECONDS(r->phase[BENCH_SOLID_SOLVE], median))
OF_LEVEL(paper, s->plan->truth ? NAN : row->paper_ms)
OF_LEVEL(seconds, row->seconds)
OF_LEVEL(factorisations, a_step(r, r->work.factorisations))
OF_LEVEL(solves, a_step(r, r->work.solves))
OF_LEVEL(iterations, a_step(r, r->work.iterations))
OF_FRAME(next)
OF_FRAME(finest)
OF_FRAME(error)
OF_FRAME(roughness)
OF_FRAME(inner)
OF_FRAME(stretch)
OF_FRAME(drop)
OF_FRAME(unevenness)
OF_FRAME(angle)

static double crossings(const struct study_results *d, const struct study *s, int level,
                        int time)
{
    const double *xyz = s->row[level].frame[time].xyz;

    (void)d;
    return xyz ? metric_intersections(xyz) : NAN;
}

/* Measures that did not come, such as the time of a crossing, are infinite. */
#define OF_RUN(code, name, unit, sentence)                                                 \
    OF_LEVEL(of_##name, isfinite(r->value[MEASURE_##code]) ? r->value[MEASURE_##code] : NAN)
MEASURE_LIST(OF_RUN)

/* A run that died is no solution, and its cost is compared with none. */
static double of_reference(const struct study_results *d, const struct study *s, int level,
                           int time)
{
    const int other = study_reference(d, s, level);

    return other < 0 || s->row[level].result.outcome || s->row[other].result.outcome
               ? NAN
               : frame(d, s, level, time) / frame(d, s, other, time);
}

static double paper_of_reference(const struct study_results *d, const struct study *s,
                                 int level, int time)
{
    const int other = study_reference(d, s, level);

    return other < 0 ? NAN : paper(d, s, level, time) / paper(d, s, other, time);
}

static double apart(const struct study_results *d, const struct study *s, int level,
                    int time)
{
    const int other = study_reference(d, s, level);

    return other < 0 || other == level ? NAN : study_distance(s, level, s, other, time);
}

/* The middle of the edge u = 1. */
static double depth(const struct study_results *d, const struct study *s, int level,
                    int time)
{
    const double *xyz = s->row[level].frame[time].xyz;

    (void)d;
    return xyz ? -truth_plate_edge(xyz) : NAN;
}

static double speed(const struct study_results *d, const struct study *s, int level,
                    int time)
{
    return time ? (depth(d, s, level, time) - depth(d, s, level, time - 1)) /
                      (s->time[time] - s->time[time - 1])
                : NAN;
}

static double tip(const struct study_results *d, const struct study *s, int level, int time)
{
    const struct study_row *row = &s->row[level];
    const double *xyz = row->frame[time].xyz;

    (void)d;
    return xyz ? -truth_plate_edge(xyz) / s->length / row->theory : NAN;
}

static double tip_of_reference(const struct study_results *d, const struct study *s,
                               int level, int time)
{
    const int other = study_reference(d, s, level);
    const double own = tip(d, s, level, time);

    return other < 0 ? own : own / tip(d, s, other, time);
}

static double swing(const struct study_results *d, const struct study *s, int level,
                    int time)
{
    const struct study_row *row = &s->row[level];
    double *rest = row->left_out ? NULL : metric_rest_field(&row->run.scene);
    const double angle = rest ? metric_angle(&row->run.scene, rest) : NAN;
    double most = NAN;

    (void)d;
    for (int t = 0; t <= time; t++)
        if (row->frame[t].xyz)
            most = fmax(most, metric_angle(&row->run.scene, row->frame[t].xyz) - angle);
    free(rest);
    return most;
}

static double edge_moved(const struct study_results *d, const struct study *s, int level,
                         int time)
{
    const double *xyz = s->row[level].frame[time].xyz;
    double *rest = xyz ? metric_rest_field(&s->row[level].run.scene) : NULL,
           sum = rest ? 0 : NAN;

    (void)d;
    for (int n = GRID_U - 1; rest && n < GRID_POINTS; n += GRID_U)
        for (int c = 0; c < 3; c++)
            sum += pow(xyz[3 * n + c] - rest[3 * n + c], 2);
    free(rest);
    return sqrt(sum / (GRID_V * GRID_W));
}

static double apart_most(const struct study_results *d, const struct study *s, int level,
                         int time)
{
    double most = apart(d, s, level, 0);

    (void)time;
    for (int t = 1; t < s->frames; t++)
        most = judge_most(most, apart(d, s, level, t));
    return most;
}

/* Over how far the truth has moved. */
static double off(const struct study_results *d, const struct study *s, int level, int time)
{
    double *rest = s->truth ? metric_rest_field(&s->row[level].run.scene) : NULL;
    double moved = NAN;

    if (rest)
        moved = metric_rmse(s->truth->xyz[time], rest);
    free(rest);
    return error(d, s, level, time) * s->length / moved;
}

static double bar(const struct study_results *d, const struct study *s, int level, int time)
{
    (void)d, (void)level;
    return s->truth ? s->truth->error[time] / s->length : NAN;
}

/* clang-format off */
const struct quantity_row quantity_table[QUANTITIES] = {
    [QUANTITY_SIZE] = {"size", "size", NULL, 3, false, size,
        "what the plan calls the size of a level: a mesh width, a step [s], ..."},
    [QUANTITY_CONTROL_POINTS] = {"control_points", "points", NULL, 0, false, control_points,
        "points of the net"},
    [QUANTITY_UNKNOWNS] = {"unknowns", "unknowns", NULL, 0, false, unknowns,
        "components of points that are not held"},
    [QUANTITY_FACTOR_ENTRIES] = {"factor_entries", "factor", NULL, 0, false, factor_entries,
        "numbers stored in the factor"},
    [QUANTITY_CREATE] = {"create_ms", "set-up", "ms", 3, false, create,
        "building the model, median over repeats"},
    [QUANTITY_FRAME] = {"frame_ms", "a frame", "ms", 3, false, frame,
        "a time step, or the equilibrium: median over repeats, one thread"},
    [QUANTITY_FRAME_LOWER] = {"frame_lower_ms", "", "ms", 3, false, frame_lower,
        "lower quartile of a frame's milliseconds"},
    [QUANTITY_FRAME_UPPER] = {"frame_upper_ms", "", "ms", 3, false, frame_upper,
        "upper quartile of them"},
    [QUANTITY_OF_REFERENCE] = {"of_reference", "of reference", NULL, 3, false, of_reference,
        "a frame's milliseconds over those of the reference"},
    [QUANTITY_ASSEMBLE] = {"assemble_ms", "K and M", "ms", 3, false, assemble,
        "assembly of K and M alone"},
    [QUANTITY_FACTOR] = {"factor_ms", "factor", "ms", 3, false, factor,
        "one factorisation alone"},
    [QUANTITY_SOLVE] = {"solve_ms", "solve", "ms", 3, false, solve,
        "one solution with the factor alone"},
    [QUANTITY_PAPER] = {"paper_ms", "paper", "ms", 0, false, paper,
        "what the paper prints for a frame"},
    [QUANTITY_PAPER_OF_REFERENCE] = {"paper_of_reference", "paper's", NULL, 3, false,
        paper_of_reference, "the paper's milliseconds over its own for the reference"},
    [QUANTITY_SECONDS] = {"stepping_s", "stepping", "s", 3, false, seconds,
        "all frames to the last time"},
    [QUANTITY_FACTORISATIONS] = {"factorisations", "factors", "a frame", 3, false, factorisations,
        "factorisations, mean over the frames"},
    [QUANTITY_SOLVES] = {"solves", "solves", "a frame", 3, false, solves,
        "products with the factor or the preconditioner, mean over the frames"},
    [QUANTITY_ITERATIONS] = {"iterations", "iterations", "a frame", 3, false, iterations,
        "iterations of the step, mean over the frames"},
    [QUANTITY_APART] = {"apart", "apart", "L", 2, true, apart,
        "rms distance to the reference on the material grid, over the length"},
    [QUANTITY_TIP] = {"tip", "tip", NULL, 4, false, tip,
        "how far the middle of a cantilever's free edge drops, over Kirchhoff's plate or, "
        "not linear, over a strip, the elastica"},
    [QUANTITY_TIP_OF_REFERENCE] = {"tip_of_reference", "over reference", NULL, 4, false,
        tip_of_reference, "tip over that of the reference; without one, tip"},
    [QUANTITY_DEPTH] = {"depth", "depth", "m", 4, true, depth,
        "how far the middle of the edge u = 1 is below z = 0"},
    [QUANTITY_SPEED] = {"speed", "speed", "m/s", 4, true, speed,
        "mean speed at which it sinks, since the time before"},
    [QUANTITY_SWING] = {"swing", "swing", "degrees", 3, true, swing,
        "largest turn, at any of the times so far, of the line between the middles of the "
        "edges u = 0 and 1 out of its angle at rest"},
    [QUANTITY_EDGE_MOVED] = {"edge_moved", "edge moved", "m", 3, true, edge_moved,
        "rms displacement of the edge u = 1"},
    [QUANTITY_DEATH] = {"death_s", "death", "s", 3, false, death,
        "when the run died"},
    [QUANTITY_APART_MOST] = {"apart_most", "most apart", "L", 2, false, apart_most,
        "the largest of these distances over all times"},
    [QUANTITY_NEXT] = {"to_next", "to next", "L", 3, true, next,
        "rms distance to the next level"},
    [QUANTITY_FINEST] = {"to_finest", "to finest", "L", 3, true, finest,
        "rms distance to the last level"},
    [QUANTITY_ERROR] = {"error", "error", "L", 3, true, error,
        "rms distance to the scene's truth"},
    [QUANTITY_OFF] = {"off", "off", NULL, 3, true, off,
        "rms distance to the truth over the rms way that the truth has moved"},
    [QUANTITY_BAR] = {"error_bar", "error bar", "L", 2, true, bar,
        "error bar of the truth"},
    [QUANTITY_ROUGHNESS] = {"roughness", "roughness", NULL, 3, true, roughness,
        "length times the rms curvature"},
    [QUANTITY_INNER] = {"inner_roughness", "inner", NULL, 3, true, inner,
        "the same away from the edges"},
    [QUANTITY_STRETCH] = {"stretch", "stretch", NULL, 4, true, stretch,
        "largest principal stretch"},
    [QUANTITY_DROP] = {"drop", "drop", "L", 4, true, drop,
        "lowest point below the support"},
    [QUANTITY_UNEVENNESS] = {"unevenness", "unevenness", NULL, 3, true, unevenness,
        "rms change of the curvature over it, per length"},
    [QUANTITY_ANGLE] = {"angle_degrees", "angle", "degrees", 3, true, angle,
        "angle of the middle line below level"},
    [QUANTITY_CROSSINGS] = {"crossings", "crossings", "pairs", 0, true, crossings,
        "pairs of the mid-surface's triangles that cross"},
#define QUANTITY_MEASURE(code, name, unit, sentence)                                       \
    [QUANTITY_##code] = {#name, #name, unit, 3, false, of_##name, sentence},
    MEASURE_LIST(QUANTITY_MEASURE)
#undef QUANTITY_MEASURE
};
/* clang-format on */

int quantity_find(const char *name)
{
    for (int n = 0; n < QUANTITIES; n++)
        if (!strcmp(quantity_table[n].name, name))
            return n;
    return -1;
}

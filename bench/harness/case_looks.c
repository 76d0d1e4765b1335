#include "bench/harness/case_looks.h"

#include <math.h>
#include <stdlib.h>

#include "models/metric/metric.h"

const char *case_looks_name(int series)
{
    return series < SERIES_METRICS              ? series_metric[series].name
           : series == CASE_LOOKS_INTERSECTIONS ? "intersections"
                                                : "speed";
}

const char *case_looks_unit(int series)
{
    return series < SERIES_METRICS              ? series_metric[series].unit
           : series == CASE_LOOKS_INTERSECTIONS ? "1"
                                                : "m/s";
}

enum status case_looks_init(struct case_looks *l, int room)
{
    size_t size = (size_t)(room + 1) * sizeof(double);
    bool good;

    *l = (struct case_looks){.room = room};
    l->time = malloc(size);
    l->energy = malloc((size_t)(room + 1) * sizeof *l->energy);
    good = l->time && l->energy;
    for (int n = 0; n < CASE_LOOKS_SERIES; n++)
        good = (l->series[n] = malloc(size)) && good;
    return good ? STATUS_OK : STATUS_MEMORY;
}

void case_looks_clear(struct case_looks *l)
{
    free(l->time);
    free(l->energy);
    for (int n = 0; n < CASE_LOOKS_SERIES; n++)
        free(l->series[n]);
    *l = (struct case_looks){0};
}

/* Of the numbers that exist; NaN if none does. */
static double largest(int count, const double *value)
{
    double most = NAN;

    for (int n = 0; n < count; n++)
        most = fmax(most, value[n]);
    return most;
}

static double last(int count, const double *value)
{
    return count ? value[count - 1] : NAN;
}

static double first_crossing(const struct case_looks *l)
{
    const double *crossings = l->series[CASE_LOOKS_INTERSECTIONS];

    if (l->count == 0 || isnan(crossings[0]))
        return NAN;
    for (int n = 0; n < l->count; n++)
        if (crossings[n] > 0)
            return l->time[n];
    return INFINITY;
}

static void reduce_series(const struct case_looks *l, const struct scene *scene,
                          double *value)
{
    static const struct {
        int series, most, end; /* end < 0: none */
    } pair[] = {
        {SERIES_STRETCH, CASE_STRETCH_MAX, CASE_STRETCH_END},
        {SERIES_DROP, CASE_DROP_MAX, CASE_DROP_END},
        {SERIES_ANGLE, CASE_ANGLE_MAX, CASE_ANGLE_END},
        {SERIES_ROUGHNESS, CASE_ROUGHNESS_MAX, CASE_ROUGHNESS_END},
        {SERIES_PENETRATION, CASE_PENETRATION_MAX, -1},
        {CASE_LOOKS_INTERSECTIONS, CASE_INTERSECTIONS_MAX, CASE_INTERSECTIONS_END},
        {CASE_LOOKS_SPEED, CASE_SPEED_MAX, CASE_SPEED_END},
    };

    for (size_t n = 0; n < sizeof pair / sizeof *pair; n++) {
        value[pair[n].most] = largest(l->count, l->series[pair[n].series]);
        if (pair[n].end >= 0)
            value[pair[n].end] = last(l->count, l->series[pair[n].series]);
    }
    if (!scene->obstacle_count)
        value[CASE_PENETRATION_MAX] = NAN;
    value[CASE_INTERSECTION_TIME] = first_crossing(l);
    value[CASE_END_TIME] = last(l->count, l->time);
}

static enum status reduce_energy(const struct case_looks *l, double *value)
{
    double *drift = malloc((size_t)(l->count + 1) * sizeof *drift);

    if (!drift)
        return STATUS_MEMORY;
    metric_energy_drift(l->count, l->energy, drift);
    value[CASE_ENERGY_DRIFT_MAX] = largest(l->count, drift);
    value[CASE_ENERGY_DRIFT_END] = last(l->count, drift);
    free(drift);
    return STATUS_OK;
}

static void reduce_scene(const struct scene *scene, double *value)
{
    const double *g = scene->gravity;
    double weight = scene->density * sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);

    value[CASE_GAMMA] = scene_gamma(scene);
    value[CASE_YOUNG_OVER_DENSITY] = scene->young / scene->density;
    value[CASE_HANGING_STRAIN] = weight * scene->length / scene->young;
}

enum status case_looks_reduce(const struct case_looks *l, const struct scene *scene,
                              double death_time, const char *left_out,
                              struct case_result *r)
{
    bool died = status_is_death(r->outcome);

    reduce_series(l, scene, r->value);
    reduce_scene(scene, r->value);
    r->value[CASE_BLOWUP_TIME] = died                      ? death_time
                                 : r->outcome == STATUS_OK ? INFINITY
                                                           : NAN;
    if (died)
        status_fail(&r->sentence, r->outcome, "died at t = %.6g s: %s", death_time,
                    status_text(r->outcome));
    else
        status_fail(&r->sentence, r->outcome, "%s",
                    r->outcome == STATUS_OK ? "done" : left_out);
    return reduce_energy(l, r->value);
}

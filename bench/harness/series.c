#include "bench/harness/series.h"

#include "models/metric/metric.h"

const struct series_metric series_metric[SERIES_METRICS] = {
    [SERIES_DROP] = {"drop", "1", metric_drop},
    [SERIES_ANGLE] = {"angle", "degrees", metric_angle},
    [SERIES_STRETCH] = {"stretch", "1", metric_stretch},
    [SERIES_ROUGHNESS] = {"roughness", "1", metric_roughness},
    [SERIES_PENETRATION] = {"penetration", "m", metric_penetration},
};

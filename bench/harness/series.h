/* series.h - the metrics that are kept of every frame of a run. */
#ifndef SERIES_H
#define SERIES_H

#include "models/scene.h"

enum {
    SERIES_DROP,
    SERIES_ANGLE,
    SERIES_STRETCH,
    SERIES_ROUGHNESS,
    SERIES_PENETRATION,
    SERIES_METRICS
};

struct series_metric {
    const char *name, *unit; /* as in result files (store.h)                            */
    double (*value)(const struct scene *scene, const double *xyz);
};
extern const struct series_metric series_metric[SERIES_METRICS];

#endif

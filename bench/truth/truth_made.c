#include "bench/truth/truth_made.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bench/truth/truth_plan.h"
#include "models/grid.h"

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
    for (int n = 0; n < times; n++)
        made->value[n][TRUTH_THIRD] = made->value[n][TRUTH_THIRD_BAR] = NAN;
    return STATUS_OK;
}

void truth_made_clear(struct truth_made *made)
{
    free(made->xyz);
    *made = (struct truth_made){0};
}

void truth_made_thin(struct truth_made *made, const struct scene *scene)
{
    const int last = made->claimed - 1;
    int times = 0, claimed = 0;

    for (int n = 0; n < made->times; n++) {
        if (!truth_plan_judges(scene, made->time[n]) && (n != last || claimed))
            continue;
        made->time[times] = made->time[n];
        made->xyz[times] = made->xyz[n];
        memcpy(made->value[times], made->value[n], sizeof *made->value);
        times++;
        claimed += n <= last;
    }
    made->times = times;
    made->claimed = claimed;
}

/* looks.h - the moments of a run that were looked at, and what is read off them: shared by
 * the run and by the reading of its file.
 */
#ifndef LOOKS_H
#define LOOKS_H

#include "bench/harness/measures.h"
#include "models/model.h"

/* One number a look. */
enum {
    LOOKS_INTERSECTIONS = MEASURES_METRICS, /* NaN: not counted                        */
    LOOKS_SPEED, /* rms over the grid since the look before; NaN at the first    [m/s] */
    LOOKS_SERIES
};
const char *looks_name(int series);
const char *looks_unit(int series);

struct looks {
    int count, room;
    double *time;                 /* [count] [s]                               owned   */
    double *series[LOOKS_SERIES]; /* [count]                                   owned   */
    struct energy *energy;        /* [count]; NaN: the model has none          owned   */
};

/* Room for that many, count 0. *looks is overwritten. */
enum status looks_init(struct looks *looks, int room);
void looks_clear(struct looks *looks); /* all-zero is allowed */

/* The measures of a run that ended so (STATUS_OK, a death at death_time, or
 * STATUS_UNSUPPORTED) into value[MEASURES]. */
enum status looks_reduce(const struct looks *looks, const struct scene *scene,
                         enum status outcome, double death_time, double *value);

#endif

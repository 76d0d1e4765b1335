/* case_looks.h - the looks of a case and what is read off them: shared by the run and by
 * the reading of its file. */
#ifndef CASE_LOOKS_H
#define CASE_LOOKS_H

#include "bench/harness/case.h"
#include "bench/harness/series.h"
#include "models/model.h"

/* One number a look. */
enum {
    CASE_LOOKS_INTERSECTIONS = SERIES_METRICS, /* NaN: not counted                     */
    CASE_LOOKS_SPEED, /* rms over the grid since the look before; NaN at the first [m/s] */
    CASE_LOOKS_SERIES
};
const char *case_looks_name(int series);
const char *case_looks_unit(int series);

struct case_looks {
    int count, room;
    double *time;                      /* [count] [s]                          owned   */
    double *series[CASE_LOOKS_SERIES]; /* [count]                              owned   */
    struct energy *energy;             /* [count]; NaN: the model has none     owned   */
};

/* Room for that many, count 0. *looks is overwritten. */
enum status case_looks_init(struct case_looks *looks, int room);
void case_looks_clear(struct case_looks *looks); /* all-zero is allowed */

/* The measures, and the sentence of result->outcome; a death was at death_time. `left_out`
 * is what an unsupported case lacks. */
enum status case_looks_reduce(const struct case_looks *looks, const struct scene *scene,
                              double death_time, const char *left_out,
                              struct case_result *result);

#endif

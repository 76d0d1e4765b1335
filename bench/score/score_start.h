/* score_start.h - how somebody's frames begin: as the sheet at rest, or shifted, turned,
 * with vertices out of place. */
#ifndef SCORE_START_H
#define SCORE_START_H

#include "bench/score/score.h"

/* Fills start, begin, turn and strays of a score that has its net, its truth and its maps,
 * from the first frame xyz[vertices][3] [m] at score->first. Where that is no frame at t =
 * 0, neither turn nor strays are looked for. STATUS_MEMORY. */
enum status score_start_find(struct score *score, const double *xyz);

#endif

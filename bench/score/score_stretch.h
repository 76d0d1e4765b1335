/* score_stretch.h - how long the lines of a net are in frames, beside the truth's. */
#ifndef SCORE_STRETCH_H
#define SCORE_STRETCH_H

#include "bench/score/score.h"

/* Lines along u, or along v: lengths, and how unlike each other the frames' pieces are. */
struct score_lines {
    double rest, truth, got;
    double spread; /* standard deviation of got over truth, a piece */
    double floor;  /* share of the truth's length by which got may be off */
};

/* Of the grid's lines, `truth` as the net sees it, `whole` as it is: fields
 * [SCORE_POINTS][3]. */
struct score_lines score_stretch_lines(const struct score *score, const double *whole,
                                       const double *truth, const double *got,
                                       bool along_v);

/* By which share they are longer than the truth's; whether the truth itself stretches, so
 * that its stretch is the measure. */
double score_stretch_share(const struct score_lines *lines);
bool score_stretch_has(const struct score_lines *lines);

/* Of both directions at all times, the one that is farthest beyond its own floor, and when
 * [s]; 0: none is. STATUS_MEMORY. */
enum status score_stretch_find(const struct score *score, struct score_lines *most,
                               double *when);

#endif

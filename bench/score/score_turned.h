/* score_turned.h - whether frames would fit if axes were exchanged, positions were in
 * another unit, or vertices in another order. */
#ifndef SCORE_TURNED_H
#define SCORE_TURNED_H

#include "bench/score/score.h"

struct score_turned {
    int axis[3];    /* the scene's x, y, z are the frames' so many-th */
    double sign[3]; /* 1 or -1 of it                                  */
    double scale;   /* and times this                                 */
    int order;    /* bits: 1: u and v exchanged, 2: u, 4: v runs the other way           */
    double error; /* rms over all known times, over the length                           */
    double as_is; /* the same of the frames as they are                                  */
};

/* The best of all of them; as they are, if nothing is much better. */
struct score_turned score_turned_best(const struct score *score);

#endif

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

/* Whether an error is so much smaller than that of the frames as they are, which is worth
 * it, that something else must be meant; both over the length. */
bool score_turned_is_better(double error, double as_is);

/* rms distance of few of the frames' points at the n-th time of the truth, which is known,
 * from the truth's nearest, over the length. */
double score_turned_nearest(const struct score *score, int n);

/* The best of all of them; as they are, if nothing is much better. */
struct score_turned score_turned_best(const struct score *score);

#endif

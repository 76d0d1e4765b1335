/* score_pace.h - whether frames would fit if their times were another multiple of the
 * truth's: frames that stand twice or were left out, another rate of frames. */
#ifndef SCORE_PACE_H
#define SCORE_PACE_H

#include "bench/score/score.h"

struct score_pace {
    double speed; /* frames show at t what the truth does at t times this; 1: no other   */
    double error; /* rms over the times at which both are known, over the length         */
    double as_is; /* the same of the frames as they are                                  */
};

/* The best between an eighth and eight; as they are, if no other is much better. */
struct score_pace score_pace_best(const struct score *score);

#endif

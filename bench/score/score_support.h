/* score_support.h - how far off what a scene holds is in frames. */
#ifndef SCORE_SUPPORT_H
#define SCORE_SUPPORT_H

#include "bench/score/score.h"

struct score_support {
    int which;   /* the support that is farthest off:                                    */
    double most; /* rms over its points in what it fixes, over the length; 0: no more   */
                 /* than penalties give way                                             */
    double time, by[3]; /* then [s]; so much on average [m] */
    bool steady; /* all supports are off by the same, `shift`, at all times             */
    double shift[3]; /* [m]; else zero */
};

/* Against what the net sees of the truth. STATUS_MEMORY. */
enum status score_support_find(const struct score *score, struct score_support *support);

#endif

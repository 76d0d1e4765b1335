/* score_fit.h - finds the flaws, and their sizes, that turn the truth into the frames:
 * least squares, over all times and points, of the difference by each flaw's effect.
 *
 * On edge_drop what a flaw does is taken from the ladder (score_ladder.h): bending by
 * cubics in log D, the others in proportion. On a sheet that nothing holds it is known: a
 * fall by d(t) that begins with the velocity of half a step moves on by 2 d / t, and so on.
 * Elsewhere nothing is fitted.
 */
#ifndef SCORE_FIT_H
#define SCORE_FIT_H

#include "bench/score/score.h"

enum fit_kind {
    FIT_LEAD,    /* [s] frames show what the truth does so much later                     */
    FIT_GRAVITY, /* share of g too much                                                   */
    FIT_DAMPING, /* [1/s] of mass damping                                                 */
    FIT_HINGE,   /* 1: the edge is a hinge, 0: a clamp                                    */
    FIT_STRETCH, /* longer; no size is given, score_diagnosis.h measures it               */
    FIT_BENDING, /* D times so much                                                       */
    FIT_KINDS
};

struct score_fit {
    int count;               /* of flaws                                               */
    bool has[FIT_KINDS];     /* whether the frames have the flaw                       */
    double value[FIT_KINDS]; /* its size, if so                                        */
    bool at_end;             /* bending: off the ladder's end                          */
    double rest;             /* rms difference that is left, in the same unit of all fits */
    double left;             /* share of the rms difference; 1: no flaw                */
};

/* Fits flaws to the frames, moved back by `shift` [m]. *fit has none where nothing can be
 * fitted, the difference is within the bars and the net's floor, or no three flaws explain
 * most of it. */
void score_fit_make(const struct score *score, const double shift[3],
                    struct score_fit *fit);

#endif

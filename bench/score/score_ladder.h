/* score_ladder.h - edge_drop moved with other bending stiffnesses, and with one flaw each:
 * frames are compared with them to find a flaw and its size. tools/ladder makes the file
 * bench/truths/edge_drop_ladder.npz and says how. */
#ifndef SCORE_LADDER_H
#define SCORE_LADDER_H

#include "models/scene.h"

enum { LADDER_RUNGS = 7, LADDER_BASE = 3, LADDER_U = 21, LADDER_V = 11 };
enum { LADDER_POINTS = LADDER_U * LADDER_V };

enum ladder_flaw {
    LADDER_DAMPING, /* mass damping of `size` 1/s                                      */
    LADDER_GRAVITY, /* gravity times `size`                                            */
    LADDER_STRETCH, /* E h times `size`, D as it is                                    */
    LADDER_HINGE,   /* the edge held as a hinge                                        */
    LADDER_FLAWS
};

struct score_ladder {
    int times;     /* 0: none of this scene                                           */
    double *time;  /* [times] evenly from the first step on [s]                owned  */
    double *scale; /* [LADDER_RUNGS] of D, evenly in its logarithm             owned  */
    double *size;  /* [LADDER_FLAWS]                                           owned  */
    double *rung;  /* [LADDER_RUNGS][times][LADDER_POINTS][3] [m]              owned  */
    double *flaw;  /* [LADDER_FLAWS][times][LADDER_POINTS][3] [m]              owned  */
    double *bar;   /* [LADDER_RUNGS][times] rms error bar [L]                  owned  */
};

/* Reads the ladder of this scene, moved as its truth is; `times` is 0 where there is none.
 * Free with score_ladder_clear. STATUS_INPUT with a sentence: the file is damaged. */
enum status score_ladder_read(const struct scene *scene, struct score_ladder *ladder,
                              struct message *why);
void score_ladder_clear(struct score_ladder *ladder); /* all-zero is allowed, and left */

/* Return fields [LADDER_POINTS][3], u fastest. */
const double *score_ladder_rung(const struct score_ladder *l, int rung, int time);
const double *score_ladder_flaw(const struct score_ladder *l, int flaw, int time);

#endif

/* score_truth.h - the reference of a score: the middle surface of a scene's truth at the
 * times at which it is known. */
#ifndef SCORE_TRUTH_H
#define SCORE_TRUTH_H

#include "bench/truth/truth.h"
#include "models/grid.h"

enum { SCORE_POINTS = GRID_U * GRID_V };

/* A few of the grid's points, every ninth each way, for trying many motions. */
enum { SCORE_EVERY = 9, SCORE_SIDE = (GRID_U - 1) / SCORE_EVERY + 1 };
enum { SCORE_FEW = SCORE_SIDE * SCORE_SIDE };

struct score_truth {
    struct scene scene; /* as the truth moves: undamped where damping is no rate        */
    bool undamped;      /* the scene is damped, and its truth is not                    */
    int times;          /* at which frames are judged                                   */
    int *at;            /* [times] their indices in `known`                   owned     */
    bool moves;         /* the motion between those times is known, too                 */
    struct truth known; /* the first layer of each field is the middle surface,
                           [SCORE_POINTS][3] [m]                                        */
    double *rest;       /* the same of the sheet at rest                      owned     */
};

/* Finds the truth of a scene by name or path: a closed form or a stored truth; runs
 * nothing. STATUS_INPUT: there is no such scene, or no truth of it is known. Free with
 * score_truth_clear. */
enum status score_truth_read(const char *scene, struct score_truth *truth,
                             struct message *why);
void score_truth_clear(struct score_truth *truth); /* all-zero is allowed, and left */

/* Returns the grid's index of the n-th of the few points. */
int score_truth_few(int n);

#endif

/* score_truth.h - what frames are held against: the middle surface of a scene's truth at
 * the times at which it is known. */
#ifndef SCORE_TRUTH_H
#define SCORE_TRUTH_H

#include "models/grid.h"
#include "models/scene.h"

enum { SCORE_POINTS = GRID_U * GRID_V };

/* Few of the grid's points, every ninth each way, where many motions are tried. */
enum { SCORE_EVERY = 9, SCORE_SIDE = (GRID_U - 1) / SCORE_EVERY + 1 };
enum { SCORE_FEW = SCORE_SIDE * SCORE_SIDE };

struct score_truth {
    struct scene scene; /* as the truth moves: undamped where damping is no rate        */
    int times;
    double *time;        /* [times] [s]                                       owned      */
    double *bar;         /* [times] rms error bar [m]                         owned      */
    double *xyz;         /* [times][SCORE_POINTS][3] [m]                      owned      */
    double *rest;        /* [SCORE_POINTS][3]                                 owned      */
    int motions;         /* 0: no frames are stored between these times                  */
    double *motion_time; /* [motions] from 0 on [s]            owned      */
    double (*motion)[SCORE_FEW][3]; /* [motions] [m]                      owned      */
    char source[640]; /* a sentence                                                   */
    bool undamped;    /* the scene is damped, and its truth is not                    */
};

/* Of a scene by name or path: closed forms and stored truths; runs nothing. STATUS_INPUT:
 * no such scene, or nothing is known of it. Free with score_truth_clear. */
enum status score_truth_read(const char *scene, struct score_truth *truth,
                             struct message *why);
void score_truth_clear(struct score_truth *truth); /* all-zero is allowed, and left */

/* Which of the grid's points the n-th of the few is. */
int score_truth_few(int n);

/* The n-th field. */
const double *score_truth_field(const struct score_truth *truth, int n);

#endif

/* score_start.h - how somebody's frames begin: as the sheet at rest, or turned, or with
 * vertices out of place. */
#ifndef SCORE_START_H
#define SCORE_START_H

#include "bench/score/score_net.h"

/* Vertices that are far from their material points, as most are not. */
struct score_strays {
    int count;      /* 0: none, or too many to be strays                                 */
    int vertex[2];  /* the two that are farthest off                                     */
    bool exchanged; /* all of them stand at each other's points                          */
    double off, others; /* largest distance; median of all, over the length              */
};

/* Finds the strays of a first frame xyz[vertices][3] [m], which should be the sheet at
 * rest, rest[GRID_V][GRID_U][3] [m]. */
void score_start_strays(const struct scene *scene, const struct score_net *net,
                        const double *rest, const double *xyz, struct score_strays *strays);

/* The rotation of a sheet as a whole. */
struct score_turn {
    double angle; /* [degrees]; 0: it is not turned, or not only                          */
    double axis[3];
};

/* Finds the rotation, and shift, that takes rest[points][3] to got, `start` rms apart [m].
 */
void score_start_turn(int points, const double *rest, const double *got, double start,
                      double length, struct score_turn *turn);

#endif

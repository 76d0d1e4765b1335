/* scene_motion.h - a rigid motion that a scene prescribes, of a support or a body: a turn
 * about a line, then a displacement along a path, which moves the line, too.
 */
#ifndef SCENE_MOTION_H
#define SCENE_MOTION_H

#include "models/status.h"

struct scene_motion {
    int path_count;    /* 0: no path                                                   */
    double (*path)[4]; /* [path_count][t, dx, dy, dz], t increasing; linear between,
                          constant outside                             [s, m]    owned */
    int turn_count;    /* 0: no turn                                                   */
    double (*turn)[2]; /* [turn_count][t, angle] likewise, right-handed [s, deg] owned */
    double axis[3], about[3]; /* of the turn: its direction, of length 1, and a point on
                                 it [m]                                                */
};

/* A place in that motion: x = turn X + shift for points X that the scene places. */
struct scene_placement {
    double turn[3][3]; /* rotation                                                     */
    double shift[3];   /*                                                        [m]   */
};

/* Tells whether it moves at all. */
#define SCENE_MOVES(motion) ((motion).path_count + (motion).turn_count > 0)

/* Copies path and turn of *from, which it then owns; leaves *motion empty on failure. */
enum status scene_motion_copy(struct scene_motion *motion, const struct scene_motion *from);

/* Frees path and turn, and leaves no motion. */
void scene_motion_clear(struct scene_motion *motion);

/* Computes the place at time t [s]. */
void scene_motion_at(const struct scene_motion *motion, double t,
                     struct scene_placement *place);

/* Computes where a direction d points in that place. */
void scene_placement_turn(const struct scene_placement *place, const double d[3],
                          double turned[3]);

/* Compute where the point X is in that place, and the X of a point at x. */
void scene_placement_point(const struct scene_placement *place, const double X[3],
                           double x[3]);
void scene_placement_back(const struct scene_placement *place, const double x[3],
                          double X[3]);

/* Computes value[columns - 1] at time t from rows [t, value...] with t increasing: linear
 * between, constant outside; 0 without rows. */
void scene_motion_table(int rows, int columns, const double *table, double t,
                        double *value);

#endif

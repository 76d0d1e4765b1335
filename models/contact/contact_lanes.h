/* contact_lanes.h - distances of points from triangles, eight pairs at a time, as wide as
 * processors compute. A pair has the same result in each lane and beside any others.
 */
#ifndef CONTACT_LANES_H
#define CONTACT_LANES_H

#include <stdbool.h>

enum { CONTACT_LANES = 8 };

/* A pair is a point and a triangle, which may be a segment or a point. Of the four places
 * of an array the first is the point's, the others are the corners'. */
struct contact_lanes {
    int count; /* lanes in use; the others have any points, at first number 0            */
    const double *y; /* [][3] places                               [m]    borrowed  */
    const double
        *normal; /* [][3] normals of any length, for contact_lanes_meet; the same */
    int point[4][CONTACT_LANES];    /* their numbers                                */
    double share[4][CONTACT_LANES]; /* of the corners in the closest point; sum 1   */
    double way[3][CONTACT_LANES];   /* from there to the point                  [m] */
    double square[CONTACT_LANES];   /* of its length                          [m^2] */
    double distance[CONTACT_LANES]; /* by contact_lanes_measure and _meet         [m] */
    bool met[CONTACT_LANES];        /* by contact_lanes_meet                        */
};

/* Sets the points of a lane. */
static inline void contact_lanes_set(struct contact_lanes *lanes, int l, int point,
                                     const int corner[3])
{
    lanes->point[0][l] = point;
    for (int k = 0; k < 3; k++)
        lanes->point[k + 1][l] = corner[k];
}

/* Computes share, way and square between points and triangles. */
void contact_lanes_nearest(struct contact_lanes *lanes);

/* Computes square and distance, and `way` of length 1, for the shares of a triangle's
 * corners. */
void contact_lanes_measure(struct contact_lanes *lanes);

/* Solves p + h n = y for the shares of the triangle's corners, whose places p and normals n
 * are interpolated, from shares near it, and measures; `met` tells whether the normals
 * allow it. */
void contact_lanes_meet(struct contact_lanes *lanes);

#endif

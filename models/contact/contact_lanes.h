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
    int count; /* lanes in use; the others have any numbers                            */
    double p[4][3][CONTACT_LANES];  /*                                          [m] */
    double n[4][3][CONTACT_LANES];  /* normals at the corners, of any length       */
    double share[4][CONTACT_LANES]; /* of the corners in the closest point; sum 1   */
    double way[3][CONTACT_LANES];   /* from there to the point                  [m] */
    double square[CONTACT_LANES];   /* of its length                          [m^2] */
    double distance[CONTACT_LANES]; /* by contact_lanes_measure                  [m] */
    bool met[CONTACT_LANES];        /* by contact_lanes_meet                        */
};

/* Adds a pair by the numbers of its points in y[][3]; returns whether all lanes are in use.
 */
bool contact_lanes_add(struct contact_lanes *lanes, const double *y, const int point[4]);

/* Computes share, way and square between points and triangles. */
void contact_lanes_nearest(struct contact_lanes *lanes);

/* Computes square and distance, and `way` of length 1, for the shares of a triangle's
 * corners. */
void contact_lanes_measure(struct contact_lanes *lanes);

/* Solves p + h n = p[0] for the shares of the triangle's corners, whose normals n are
 * interpolated, from shares near it; `met` tells whether the normals allow it. */
void contact_lanes_meet(struct contact_lanes *lanes);

#endif

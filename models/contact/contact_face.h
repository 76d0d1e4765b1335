/* contact_face.h - distances of a point from a triangle, which may be a segment or a point.
 */
#ifndef CONTACT_FACE_H
#define CONTACT_FACE_H

#include <stdbool.h>

struct contact_face {
    const double *p[4]; /* places of the point and the corners          [m]    borrowed  */
    double share[3];    /* of the corners in the closest point; sum 1                    */
    double way[3];      /* from there to the point                      [m]              */
    double square;      /* of its length                                [m^2]            */
};

/* Computes share, way and square. */
void contact_face_nearest(struct contact_face *f);

/* Computes square, and `way` of length 1, for the shares; returns the distance [m]. */
double contact_face_measure(struct contact_face *f);

/* Solves p + h n = y for the shares of the corners, whose places p and normals n, of any
 * length, are interpolated, from shares near it; returns whether the normals allow it. */
bool contact_face_meet(struct contact_face *f, const double *const normal[3]);

#endif

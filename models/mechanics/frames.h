/* frames.h - the rotation of the columns of a net: an orthonormal frame each. */
#ifndef FRAMES_H
#define FRAMES_H

#include <stdbool.h>

/* Fills Q[n m l][9], columns the axes: the third along the column's thickness (l = 1: along
 * the normal of the net), the first nearest to the net's lines of u. x[n][m][l][3];
 * legendre: coefficient 0 of a column is its middle, 1 half its thickness (solid_space.h).
 * The same frame for all nodes of a column; the unit matrix where the net has folded to
 * nothing. */
void frames_of_net(const int points[3], bool legendre, const double *x, double (*Q)[9]);

#endif

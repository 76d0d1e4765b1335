/* drape.h - what Cusick's drape test (ISO 9073-9) reads off the shadow that a disc which
 * hangs over a round holder casts along gravity. Fields are as metric.h has them.
 *
 * The disc is a closed cloak with a flare of 90 degrees (scene.h), the holder the circle of
 * its edge u = 0; or it is a flat mesh with a round border, of which the only support holds
 * a round group of the middle: its border is continued from the grid's cells inside. The
 * outline of the shadow is the farthest point in each of 1440 directions from the axis, of
 * the lines of the grid along u and v; the thickness is left out. Chords between the grid's
 * points cut areas by .07 %, of the flat disc likewise.
 */
#ifndef DRAPE_H
#define DRAPE_H

#include "models/scene.h"

/* Returns the drape coefficient: the area of the shadow beyond the holder over that of the
 * flat disc [1], 1 for a disc that does not bend. NaN of other sheets, of a coordinate that
 * is NaN, and if memory ran out. */
double drape_coefficient(const struct scene *scene, const double *xyz);

/* Counts the folds ("nodes"): maxima of the outline's radius between which it falls by more
 * than 2 % of the width of what hangs. NaN likewise. */
double drape_folds(const struct scene *scene, const double *xyz);

#endif

/* metric.h - numbers read off sampled fields (grid.h). Model-free.
 *
 * Fields are const double *xyz of shape [GRID_W][GRID_V][GRID_U][3], metres.
 */
#ifndef METRIC_H
#define METRIC_H

#include "models/scene.h"

/* sqrt( sum over the grid of |a - b|^2 / GRID_POINTS ) [m]; NaN if any value is. A shift by
 * (3,4,12) cm gives 0.13 m. Sums are ordered: the same bits on every run. */
double metric_rmse(const double *a, const double *b);

/* Largest principal stretch of the mid-surface, central differences of the grid. >= 0. */
double metric_stretch(const struct scene *scene, const double *xyz);

/* Lowest point below the highest rest point of the supports, along -gravity, over L. */
double metric_drop(const struct scene *scene, const double *xyz);

/* Rms over interior mid-surface points of |second differences along u and v| times
 * (GRID_U - 1) / L: a cylinder of radius R gives about L / (99 R) ... zero for a plane. */
double metric_roughness(const struct scene *scene, const double *xyz);

/* Greatest depth of a grid point below any obstacle's surface [m]; 0 without obstacles. */
double metric_penetration(const struct scene *scene, const double *xyz);

/* STATUS_NAN, STATUS_ESCAPED (a point farther than 10 L from the nearest rest point of a
 * support; from its own rest point without supports) or STATUS_OK. */
enum status metric_blowup(const struct scene *scene, const double *xyz);

/* Angle below the horizontal of the line from (0, 1/2) to (1, 1/2) on the mid-surface, in
 * degrees, gravity giving the vertical. */
double metric_angle(const struct scene *scene, const double *xyz);

#endif

/* metric.h - numbers read off sampled fields (grid.h). Model-free.
 *
 * Fields are const double *xyz of shape [GRID_W][GRID_V][GRID_U][3], metres. The
 * mid-surface is the mean of the two layers. `Down` is the direction of gravity, -z in a
 * scene without. Of several sheets, numbers are taken over all, and what connects points
 * within each; lengths are those of one. A NaN among the points that a metric reads makes
 * it NaN. Sums are ordered: the same bits on every run.
 */
#ifndef METRIC_H
#define METRIC_H

#include "models/model.h"

/* Returns sqrt( sum over the grid of |a - b|^2 / GRID_POINTS ) [m]. A shift by (3,4,12) cm
 * gives 0.13 m. */
double metric_rmse(const double *a, const double *b);

/* Returns the largest principal stretch of the mid-surface [1], >= 0: largest singular
 * value of the gradient by central differences (one-sided on the edges), relative to the
 * rest shape. Exact for an affine map of a flat sheet; 1 for a curved one at rest. */
double metric_stretch(const struct scene *scene, const double *xyz);

/* Returns the spread of neighbouring stretches: the rms difference of the largest principal
 * stretch from the mean of the four a tenth of the sheet away [1]. 0 for an affine map;
 * where a net cannot follow, it stretches and shrinks by turns. */
double metric_spread(const struct scene *scene, const double *xyz);

/* Returns the rms angle between the normals in the middles of neighbouring spans of a net
 * of spans[2], along u and v [rad]: how far a cell bends. NaN for a curved rest shape, and
 * for several sheets. */
double metric_turn(const struct scene *scene, const int spans[2], const double *xyz);

/* Returns how far the lowest mid-surface point lies below the highest mid-surface rest
 * point of the supports (of the sheet, if it has none), over L. Zero for a level sheet at
 * rest. */
double metric_drop(const struct scene *scene, const double *xyz);

/* Returns L times the root mean square, over the mid-surface's interior points, of
 *     sqrt( |x_aa|^2 + 2 |x_ab|^2 + |x_bb|^2 )                                [1],
 * second derivatives by central differences in the arc lengths a = u L, b = v W of the rest
 * shape; of a curved one its covariant second derivatives in an orthonormal frame: normal
 * to the surface at rest and in every shape without strain, the square root that of the sum
 * of squared principal curvatures. Zero for any affine map of a flat sheet; L/R for a
 * cylinder of radius R whatever its axis, less a share of (s/R)^2/12 for the grid's step s.
 * Noise of one grid step is magnified by 1/s^2. */
double metric_roughness(const struct scene *scene, const double *xyz);

/* Returns the same over the inner points 0.2 <= u, v <= 0.8 alone: away from edges, and
 * from held points, around which a sheet has no limit under refinement. */
double metric_inner_roughness(const struct scene *scene, const double *xyz);

/* Returns how suddenly the mid-surface bends: L times the rms of its third derivatives over
 * that of its second ones, |x_aaa|^2 + 3 |x_aab|^2 + 3 |x_abb|^2 + |x_bbb|^2 over those of
 * roughness (differences along a = u L, b = v W) [1]. n waves over the length give 2 pi n,
 * whatever their height; jumps of curvature, as splines of degree 2 have at their knots,
 * give more than that. NaN for a flat sheet. */
double metric_unevenness(const struct scene *scene, const double *xyz);

/* Returns the greatest depth of a grid point in any obstacle at time t [m]; 0 without
 * obstacles. */
double metric_penetration(const struct scene *scene, double t, const double *xyz);

/* Returns how far the sheet as a whole has been carried at time t: the mean displacement
 * of points uvw[count][3] (NULL: of the grid) that are at xyz[count][3], in the
 * components that no support holds, 0 in the others; but no farther than a rigid sheet
 * could fly [m]. */
void metric_carried(const struct scene *scene, double t, int count, const double *uvw,
                    const double *xyz, double shift[3]);

/* Returns STATUS_NAN (a coordinate is not finite), STATUS_ESCAPED (a point farther than 10
 * L, or W if that is more, from the nearest point of a support where the support is at time
 * t; from its own rest point without supports; either carried along with the sheet as a
 * whole where nothing holds it) or STATUS_OK. */
enum status metric_blowup(const struct scene *scene, double t, const double *xyz);

/* Returns the angle below the horizontal of the line from (0, 1/2) to (1, 1/2) on the
 * mid-surface of the first sheet, in degrees, -180 to 180: past 90 the line points back
 * over the rest direction of u. */
double metric_angle(const struct scene *scene, const double *xyz);

/* Counts pairs of triangles of the mid-surface that intersect (intersection.h: touching
 * counts, thickness does not); 0 for a sheet clear of itself. NaN of a garment, whose
 * creases and seams run through the grid's cells, and if memory ran out.
 * Takes some 10 ms, more for a crumpled sheet: a hundred times what the others cost. */
double metric_intersections(const struct scene *scene, const double *xyz);

/* Counts those of the surface through every `step`-th grid point, step a divisor of 99: at
 * step 3, 34 x 34 points, in a tenth of the time. It may miss folds narrower than a step,
 * and meet itself where the finer surface just does not. */
double metric_intersections_every(const struct scene *scene, const double *xyz, int step);

/* Fills drift[n] = (E_n - E_0) / E_max of a motion's energies [count], count >= 1, with E
 * the sum of the three and E_max the largest of kinetic + elastic + |potential -
 * potential_0|: the share of the energy in play that was lost (negative) or gained. 0 at
 * rest. A scene without damping, drag, friction and moving supports should keep 0; none
 * should rise without supports that move. */
void metric_energy_drift(int count, const struct energy *energy, double *drift);

#endif

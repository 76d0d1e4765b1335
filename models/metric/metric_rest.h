/* metric_rest.h - the rest shape's mid-surface for metrics: the length of a step of the
 * material grid, and its curvature at rest. Flat sheets have closed forms. */
#ifndef METRIC_REST_H
#define METRIC_REST_H

#include "models/scene.h"

struct metric_rest {
    const struct scene *scene; /* borrowed                                             */
    double *xyz; /* [GRID_V][GRID_U][3] curved mid-surface; NULL if flat  [m]    owned */
};

enum status metric_rest_init(struct metric_rest *rest, const struct scene *scene);
void metric_rest_clear(struct metric_rest *rest);

/* The step from column i0 to i1 of row j has the rest length a; that from row j0 to j1 of
 * column i has `shear` along it and b across it. */
struct metric_rest_step {
    double a, b, shear; /* [m]                                                         */
};
struct metric_rest_step metric_rest_step(const struct metric_rest *rest, int i, int j,
                                         int i0, int i1, int j0, int j1);

/* Returns |nabla nabla x|^2 [1/m^2] of the field x[row][column][component] around the
 * interior grid point (i,j), of a curved rest shape: second derivatives by central
 * differences, less the part due to the rest's own tangential ones (Christoffel symbols),
 * in an orthonormal frame of the rest shape. Flat rest shapes would give |x_aa|^2 + 2
 * |x_ab|^2 + |x_bb|^2. */
double metric_rest_bending(const struct metric_rest *rest, int i, int j, double x[3][3][3]);

/* Returns the height [m] of the highest rest point of the mid-surface against `down` inside
 * the box [lo, hi] of (u,v). Of a curved one, over 33 x 33 points. */
double metric_rest_highest(const struct scene *scene, const double lo[3],
                           const double hi[3], const double down[3]);

/* Returns the squared distance [m^2] of x from the rest points of the box [lo, hi]. Of a
 * curved one, the nearest of 3 x 3 points, or the first nearer than `near` [m]. */
double metric_rest_distance(const struct scene *scene, const double lo[3],
                            const double hi[3], double near, const double x[3]);

/* Returns the rest shape on the whole grid (grid.h) [m], NaN beside the sheet; freed by the
 * receiver, or NULL. */
double *metric_rest_field(const struct scene *scene);

#endif

/* metric_fixture.h - fields of the sample grid, for tests of metrics: a tilted sheet at
 * rest, moved as one, and what rounding leaves of its numbers. */
#ifndef METRIC_FIXTURE_H
#define METRIC_FIXTURE_H

#include <float.h>

#include "models/grid.h"
#include "models/scene.h"
#include "tests/check.h"

/* A few operations on numbers of size 1, each a rounding off. */
#define TOL_ROUND (16 * DBL_EPSILON)
/* 60000 squares summed by rows: 300 + 200 roundings at most, far fewer on average. */
#define TOL_RMSE (500 * DBL_EPSILON)
/* A second difference loses 4 eps/s^2 on coordinates of size 1; s = 0.7/99, 0.35/99. */
#define TOL_ROUGHNESS (8 * DBL_EPSILON * (99 / 0.35) * (99 / 0.35))

enum { COUNT = GRID_POINTS * 3 };

static inline void fill_rest(const struct scene *scene, double *xyz)
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double uvw[3];
        grid_point(n, uvw);
        scene_rest_point(scene, uvw, xyz + 3 * n);
    }
}

/* A sheet 0.7 m x 0.35 m x 2 cm in a tilted pose. */
static inline void init_tilted(struct scene *scene)
{
    REQUIRE(scene_init(scene) == STATUS_OK);
    scene->length = 0.7, scene->width = 0.35, scene->thickness = 0.02;
    memcpy(scene->axis_u, (double[]){0.6, 0.0, 0.8}, sizeof scene->axis_u);
    memcpy(scene->axis_v, (double[]){0.0, 1.0, 0.0}, sizeof scene->axis_v);
    memcpy(scene->origin, (double[]){0.1, -0.2, 0.3}, sizeof scene->origin);
    memcpy(scene->gravity, (double[]){0, 0, -9.81}, sizeof scene->gravity);
}

/* x -> A x + b for every point. */
static inline void map_affine(double *xyz, const double A[3][3], const double b[3])
{
    for (int n = 0; n < GRID_POINTS; n++) {
        double x[3] = {xyz[3 * n], xyz[3 * n + 1], xyz[3 * n + 2]};
        for (int i = 0; i < 3; i++)
            xyz[3 * n + i] = A[i][0] * x[0] + A[i][1] * x[1] + A[i][2] * x[2] + b[i];
    }
}

#endif

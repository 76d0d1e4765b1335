/* plate_fixture.h - square plates for tests of statics and modes through struct model. */
#ifndef PLATE_FIXTURE_H
#define PLATE_FIXTURE_H

#include "fem_ref/hex_model.h"
#include "iga/plate_model.h"
#include "tests/check.h"

/* A unit square of thickness h in the x-y plane, without supports or loads. E = 1e5 Pa;
 * rho = 1 kg/m^3: linear answers scale. */
static inline void plate_scene(struct scene *scene, double h, double nu)
{
    REQUIRE(scene_init(scene) == STATUS_OK);
    scene->thickness = h;
    scene->young = 1e5;
    scene->poisson = nu;
}

/* Holds the components `fix` of the edge where parameter `direction` equals `at`. */
static inline void plate_hold(struct scene *scene, int direction, double at, unsigned fix)
{
    struct scene_support support = {.hi = {1, 1, 1}, .fix = fix};

    support.lo[direction] = support.hi[direction] = at;
    REQUIRE(scene_add_support(scene, &support) == STATUS_OK);
}

static inline struct discretization plate_degrees(int p, int q, int r, int n, int m, int l)
{
    return (struct discretization){.model = &plate_model,
                                   .points = {n, m, l},
                                   .degree = {p, q, r},
                                   .kinematics = KINEMATICS_LINEAR};
}

#endif

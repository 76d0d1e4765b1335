/* cloak_fixture.h - a curved sheet and the models that tests put it through. */
#ifndef CLOAK_FIXTURE_H
#define CLOAK_FIXTURE_H

#include <float.h>

#include "models/grid.h"
#include "models/vector.h"
#include "tests/run_fixture.h"

static const double PI = 3.14159265358979323846;

/* A cloak L = 0.8, W = 0.5, h = 0.02 m, tilted, held at the neck. */
static inline void init_cloak(struct scene *s, double opening, double flare)
{
    const struct scene_support edge = {.hi = {0, 1, 1}, .fix = FIX_XYZ};

    REQUIRE(scene_init(s) == STATUS_OK);
    s->length = 0.8, s->width = 0.5, s->thickness = 0.02;
    memcpy(s->origin, (double[]){0.1, -0.2, 0.3}, sizeof s->origin);
    memcpy(s->axis_u, (double[]){0.6, 0, -0.8}, sizeof s->axis_u);
    memcpy(s->axis_v, (double[]){0, 1, 0}, sizeof s->axis_v);
    memcpy(s->gravity, (double[]){0, 0, -9.81}, sizeof s->gravity);
    s->shape = SCENE_CLOAK, s->opening = opening, s->flare = flare;
    s->young = 1e5, s->poisson = 0.3, s->density = 0.5;
    REQUIRE(scene_add_support(s, &edge) == STATUS_OK);
}

static inline struct discretization net(const struct model *model, int n, int m, int p,
                                        int q)
{
    struct discretization d;

    model_defaults(model, &d);
    d.points[0] = n, d.points[1] = m;
    d.degree[0] = p, d.degree[1] = q;
    d.remedy = REMEDY_NONE;
    return d;
}

#endif

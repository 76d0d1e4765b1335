/* contract.h - the sheet and the steps that the tests of the model contract share. */
#ifndef TESTS_CONTRACT_H
#define TESTS_CONTRACT_H

#include "tests/run_fixture.h"
#include "tests/toy_model.h"

enum { FRAMES = 12 };

/* The models held to the contract: those of the contestants, then the toy of
 * doc/adding_a_model.md; NULL after the last. */
static inline const struct model *contract_model(int n)
{
    int models = 0;

    while (contestant_model(models))
        models++;
    return n < models ? contestant_model(n) : n == models ? &toy_model : NULL;
}

/* A small sheet held along u = 0, undamped. */
static inline void fill_scene(struct scene *scene)
{
    struct scene_support edge = {.lo = {0, 0, 0}, .hi = {0, 1, 1}, .fix = FIX_XYZ};

    REQUIRE(scene_init(scene) == STATUS_OK);
    scene->length = 0.5;
    scene->width = 0.4;
    scene->thickness = 0.005;
    scene->young = 1e5;
    scene->poisson = 0.3;
    scene->density = 0.5;
    scene->gravity[2] = -9.81;
    scene->end = FRAMES * scene->step;
    REQUIRE(scene_add_support(scene, &edge) == STATUS_OK);
}

static inline struct discretization small_net(const struct model *model)
{
    struct discretization d;
    model_defaults(model, &d);
    d.points[0] = 6;
    d.points[1] = 5;
    return d;
}

static inline struct counters advance(const struct model *model, void *state, int frames)
{
    struct counters counters = {0};
    for (int n = 0; n < frames; n++)
        CHECK(model->advance(state, &counters) == STATUS_OK);
    return counters;
}

#endif

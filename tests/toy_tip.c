/* The toy model's accuracy: a strand held at one end and damped until it rests hangs by
 * rho g L^2 / 2 G at its tip. Linear elements are exact at their nodes here. */
#include "tests/check.h"
#include "tests/toy_model.h"

/* Steps of 5 ms, a = 60 / s: what is left after 5 s has shrunk by more than exp(-60). */
enum { STEPS = 1000 };
/* Round-off of systems of ten unknowns, condition 4 (points)^2 / pi^2 at most: about 1e-14.
 */
static const double rounding = 1e-12;

int main(void)
{
    const double tip[3] = {1, 0.3, 0.5};
    struct scene_support edge = {.lo = {0, 0, 0}, .hi = {0, 1, 1}, .fix = FIX_XYZ};
    struct discretization d;
    struct scene scene;
    struct counters counters = {0};
    void *state = NULL;
    double xyz[3];

    REQUIRE(scene_init(&scene) == STATUS_OK);
    REQUIRE(scene_add_support(&scene, &edge) == STATUS_OK);
    scene.length = 0.5;
    scene.young = 100;
    scene.poisson = 0.3;
    scene.density = 0.5;
    scene.gravity[2] = -9.81;
    scene.damping = (struct scene_damping){.kind = DAMPING_MASS, .value = 60};
    model_defaults(&toy_model, &d);
    REQUIRE(model_create(&toy_model, &scene, &d, &state, NULL) == STATUS_OK);
    for (int n = 0; n < STEPS; n++)
        CHECK(toy_model.advance(state, &counters) == STATUS_OK);
    toy_model.probe(state, 1, tip, xyz);
    double shear = scene.young / (2 * (1 + scene.poisson));
    CHECK_RELATIVE(xyz[2], -0.5 * 9.81 * 0.25 / (2 * shear), rounding);
    model_destroy(&toy_model, state);
    scene_clear(&scene);
    return check_result();
}

/* The paper's sentence about projective dynamics (Fig. 6): held at two corners, with its
 * weights, damping and mass, the sheet of edges does not over-stretch: by more than the 10
 * % that Provot 1995 allows a spring. */
#include "tests/pd_fixture.h"

static const double provot = 1.1;

static void hang(enum constraint constraint)
{
    enum { FRAMES = 3000, LOOK = 20 };
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(10, 10, constraint);
    double swinging = 0, hanging = 0; /* longest edge: on the way, and in the end */

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.thickness = 0.001177;
    scene.gravity[2] = -9.81;
    pd_fixture_hold(&scene, 0, 0, 0, 0, FIX_XYZ);
    pd_fixture_hold(&scene, 0, 0, 1, 1, FIX_XYZ);
    o.parameters = PARAMETERS_PAPER;
    pd_fixture_motion(&m, &scene, &o);
    for (int n = 0; n < FRAMES; n += LOOK) {
        pd_fixture_frames(&m, LOOK);
        hanging = pd_fixture_longest(&m);
        swinging = fmax(swinging, hanging);
    }
    printf("%s: longest edge %.4f swinging, %.4f hanging\n",
           pd_energy_constraints[constraint], swinging, hanging);
    CHECK(swinging >= hanging && hanging > 1);
    CHECK(constraint != CONSTRAINT_EDGES || hanging < provot);
    pd_motion_clear(&m);
    scene_clear(&scene);
}

int main(void)
{
    hang(CONSTRAINT_TRIANGLES);
    hang(CONSTRAINT_EDGES);
    return check_result();
}

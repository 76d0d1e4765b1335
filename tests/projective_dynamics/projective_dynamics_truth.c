/* Matched projective dynamics, iterated to its end, against a large swing that no cloth
 * model computed: the planar elastica at nu = 0, clamped. Under refinement of space and
 * time the tip comes to it. */
#include "fem_ref/reference.h"
#include "tests/pd_fixture.h"

/* Distance of the tip's middle from the truth at 0.3 s, where it has fallen by 0.58 L. */
static double tip_error(const struct reference *truth, int points, int substeps)
{
    enum { FRAMES = 60 };
    struct scene scene;
    struct pd_motion m;
    struct pd_options o = pd_fixture_options(points, 3, CONSTRAINT_TRIANGLES);
    int row = 0;

    REQUIRE(scene_init(&scene) == STATUS_OK);
    scene.thickness = 0.005;
    scene.young = 1e5;
    scene.density = 0.3;
    scene.gravity[2] = -9.81;
    scene.width = 2.0 / (points - 1); /* square cells; nothing varies across the width */
    pd_fixture_hold(&scene, 0, 0, 0, 1, FIX_XYZ);
    o.substeps = substeps;
    o.iterations = 100000;
    o.tolerance = 1e-10;
    o.chebyshev = true;
    pd_fixture_motion(&m, &scene, &o);
    pd_fixture_frames(&m, FRAMES);
    while (row < reference_rows(truth) &&
           fabs(reference_number(truth, row, "t") - m.time) > 1e-9)
        row++;
    REQUIRE(row < reference_rows(truth));
    ptrdiff_t stride = pd_net_stride(&m.energy.net), tip = m.energy.net.nodes - 2;
    double error = hypot(m.x[tip] - reference_number(truth, row, "x1"),
                         m.x[2 * stride + tip] - reference_number(truth, row, "z1"));
    pd_fixture_close(&m, &scene);
    return error;
}

int main(void)
{
    /* Space is of second order, implicit Euler of first with four times the steps. */
    const double tol_order = 0.3, tol_tip = 1e-3;
    struct reference *truth = NULL;
    double error[3];

    REQUIRE(reference_open(REFERENCE_DIR "/pendulum_C0_E1e5_h5mm_undamped.csv", &truth,
                           NULL) == STATUS_OK);
    for (int n = 0; n < 3; n++)
        error[n] = tip_error(truth, (10 << n) + 1, 4 << 2 * n);
    printf("tip at 0.3 s off by %.2e, %.2e, %.2e L: orders %.2f, %.2f\n", error[0],
           error[1], error[2], log2(error[0] / error[1]), log2(error[1] / error[2]));
    CHECK_NEAR(error[2], 0, tol_tip);
    CHECK_NEAR(log2(error[1] / error[2]), 2, tol_order);
    reference_close(truth);
    return check_result();
}

/* Triangles in motion: a hinge, one solve a step where cells ring. (Bent: nets_bend.c; in
 * time: fall.c, time_order.c, momenta.c; swept: mass_spring_leapfrog.c.) */
#include "tests/opened_run.h"

/* A support of the mid-surface alone is a hinge, on which the strip turns freely; nothing
 * else does. */
static void check_hinge(const char *bending)
{
    struct run run;
    double omega[2];

    OPENED_RUN(&run, "cantilever", "triangles", "discretization.points=[11,3]", bending,
               "sheet.width=0.2", "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]");
    REQUIRE(run_modes(&run, 2, omega, NULL) == STATUS_OK);
    CHECK(omega[0] < 1e-3 * omega[1]);
    run_close(&run);
}

/* One solve a step where a cell rings a dozen times in it: each step has the tangent of its
 * own start, or the sheet flies apart in a tenth of a second. The free edge falls freely at
 * first, g t^2 / 2 (1 + dt / t). */
static void check_stiff(void)
{
    enum { FRAMES = 30 };
    const double FREE = 0.1; /* of the fall: what the clamp already holds back          */
    struct run run;
    double tip[3];

    OPENED_RUN(&run, "cantilever", "triangles_baraff_witkin", "sheet.thickness=1.177e-3",
               "material.density=0.5", "discretization.points=[10,10]");
    const struct counters work = opened_steps(&run, FRAMES);
    run.model->probe(run.state, 1, (const double[]){1, 0.5, 0.5}, tip);
    double t = FRAMES * run.scene.step;
    CHECK_RELATIVE(tip[2], -9.81 / 2 * t * (t + run.scene.step), FREE);
    CHECK(work.iterations == FRAMES && work.substeps == FRAMES);
    run_close(&run);
}

int main(void)
{
    check_hinge("discretization.bending=quadratic");
    check_hinge("discretization.bending=hinge");
    check_stiff();
    return check_result();
}

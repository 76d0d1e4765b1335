/* Triangles in motion: a hinge, one solve a step where cells ring, explicit steps by the
 * slope of the energy. (Bent: nets_bend.c; in time: fall.c, time_order.c, momenta.c.) */
#include "tests/opened_run.h"
#include "triangles/tri_model.h"

/* A support of the mid-surface alone is a hinge, on which the strip turns freely; nothing
 * else does. */
static void check_hinge(const char *bending)
{
    struct run run;
    struct message why = {""};
    double omega[2];

    OPENED_RUN(&run, "cantilever", "triangles", "discretization.points=[11,3]", bending,
               "sheet.width=0.2", "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]");
    REQUIRE(run_modes(&run, 2, omega, &why) == STATUS_OK);
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

/* Where a net is cut into strips (spring_sweep.h), whole, ended early, of even and odd
 * rows: explicit steps have the slope of the energy that implicit ones have. */
static void check_slope(int n, int m, const char *membrane)
{
    enum { EVERY = 37 };
    const double SLOPE = 1e-5; /* of differences, of the greatest                       */
    struct run run;
    double most = 0, off = 0;
    char points[64];

    snprintf(points, sizeof points, "discretization.points=[%d,%d]", n, m);
    OPENED_RUN(&run, "cantilever", "triangles", points, membrane, "supports=[]",
               "discretization.integrator=leapfrog", "sheet.thickness=0.01",
               "material={young: 1, poisson: 0, density: 1}", "gravity=[0,0,0]",
               "discretization.substeps=1", "time={step: 1e-9, end: 1e-8}", "snapshots=[]");
    struct tri_motion *s = run.state;
    double *x = s->net.x, small = 1e-4 * run.scene.length / n;
    for (int t = 0; t < 3 * n * m; t++)
        x[t] += 1e3 * small * sin(7. * t);
    spring_leapfrog_place(s->march.own, 0);
    opened_steps(&run, 1);
    opened_total(&run); /* fetches the velocities */
    for (int t = 0; t < 3 * n * m; t += EVERY) {
        double was = x[t], slope;
        x[t] = was + small, slope = tri_body_energy(&s->body, x);
        x[t] = was - small, slope -= tri_body_energy(&s->body, x);
        x[t] = was, slope = s->net.load[t] - slope / (2 * small);
        off = fmax(off, fabs(s->march.v[t] * s->net.mass[t / 3] / run.scene.step - slope));
        most = fmax(most, fabs(slope));
    }
    if (!CHECK(off < SLOPE * most))
        printf("%d x %d, %s: %g of %g\n", n, m, membrane, off, most);
    run_close(&run);
}

int main(void)
{
    check_hinge("discretization.bending=quadratic");
    check_hinge("discretization.bending=hinge");
    check_slope(6, 5, "discretization.membrane=green");
    check_slope(33, 31, "discretization.membrane=corotational");
    check_slope(4, 260, "discretization.membrane=green");
    check_stiff();
    return check_result();
}

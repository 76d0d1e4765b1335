/* Triangles in motion: a hinge, one solve a step where cells ring, explicit steps by the
 * slope of the energy. (Bent: nets_bend.c; in time: fall.c, time_order.c, momenta.c.) */
#include "tests/triangles.h"

/* A support of the mid-surface alone is a hinge, on which the strip turns freely; nothing
 * else does. */
static void check_hinge(enum bending bending)
{
    struct sheet s;
    double omega[2];
    struct message why = {{0}};

    sheet_init(&s, 11, 3);
    s.d.bending = bending;
    s.scene.width = 0.2, s.scene.thickness = 1e-3;
    sheet_clamp(&s);
    s.scene.supports[0].lo[2] = s.scene.supports[0].hi[2] = 0.5;
    sheet_start(&s);
    REQUIRE(tri_model.modes(s.m, 2, omega, &why) == STATUS_OK);
    CHECK(omega[0] < 1e-3 * omega[1]);
    sheet_clear(&s);
}

/* One solve a step where a cell rings a dozen times in it: each step has the tangent of its
 * own start, or the sheet flies apart in a tenth of a second. The free edge falls freely at
 * first, g t^2 / 2 (1 + dt / t). */
static void check_stiff(void)
{
    enum { FRAMES = 30 };
    const double FREE = 0.1; /* of the fall: what the clamp already holds back          */
    struct sheet s;
    double tip[3];

    sheet_init(&s, 10, 10);
    s.d.integrator = INTEGRATOR_IMPLICIT, s.d.iterations = 1;
    OWN(tri_own, &s.d)->membrane = MEMBRANE_BARAFF_WITKIN, s.d.bending = BENDING_HINGE;
    s.scene.thickness = 1.177e-3;
    s.scene.young = 1e5, s.scene.poisson = 0.3, s.scene.density = 0.5;
    s.scene.gravity[2] = -9.81;
    sheet_clamp(&s);
    sheet_start(&s);
    sheet_frames(&s, FRAMES);
    sheet_point(&s, 1, 0.5, tip);
    double t = FRAMES * s.scene.step;
    CHECK_RELATIVE(tip[2], -9.81 / 2 * t * (t + s.scene.step), FREE);
    CHECK(s.counters.iterations == FRAMES && s.counters.substeps == FRAMES);
    sheet_clear(&s);
}

/* Where a net is cut into strips (spring_sweep.h), whole, ended early, of even and odd
 * rows: explicit steps have the slope of the energy that implicit ones have. */
static void check_slope(int n, int m, enum membrane membrane)
{
    enum { EVERY = 37 };
    const double SLOPE = 1e-5; /* of differences, of the greatest                       */
    struct sheet s;
    struct energy e;
    double most = 0, off = 0;

    sheet_init(&s, n, m);
    s.d.integrator = INTEGRATOR_LEAPFROG, OWN(tri_own, &s.d)->membrane = membrane,
    s.d.substeps = 1;
    s.scene.step = 1e-9;
    sheet_start(&s);
    double *x = s.m->x, small = 1e-4 * s.scene.length / n;
    for (int t = 0; t < 3 * n * m; t++)
        x[t] += 1e3 * small * sin(7. * t);
    spring_leapfrog_place(s.m->leapfrog, 0, x);
    sheet_frames(&s, 1);
    tri_model.energy(s.m, &e);
    for (int t = 0; t < 3 * n * m; t += EVERY) {
        double was = x[t], slope;
        x[t] = was + small, slope = tri_body_energy(&s.m->body, x);
        x[t] = was - small, slope -= tri_body_energy(&s.m->body, x);
        x[t] = was, slope = s.m->load.load[t] - slope / (2 * small);
        off = fmax(off, fabs(s.m->v[t] * s.m->load.mass[t / 3] / s.scene.step - slope));
        most = fmax(most, fabs(slope));
    }
    if (!CHECK(off < SLOPE * most))
        printf("%d x %d, membrane %d: %g of %g\n", n, m, (int)membrane, off, most);
    sheet_clear(&s);
}

int main(void)
{
    check_hinge(BENDING_QUADRATIC);
    check_hinge(BENDING_HINGE);
    check_slope(6, 5, MEMBRANE_GREEN);
    check_slope(33, 31, MEMBRANE_COROTATIONAL);
    check_slope(4, 260, MEMBRANE_GREEN);
    check_stiff();
    return check_result();
}

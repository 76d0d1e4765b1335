/* Implicit springs of second order: forces and tangents, order in time against Euler's, the
 * same motion as leapfrog's, energy over many periods, momenta, rest and the clamp's order
 * in the net, what is refused. */
#include "mass_spring/spring_model.h"
#include "mass_spring/spring_rest.h"
#include "tests/mass_spring.h"

enum { N = 7, M = 6, COUNT = 3 * N * M };

static void begin(struct spring_motion *m, struct scene *scene, enum integrator integrator,
                  int substeps)
{
    struct discretization d = net_of(N, M);

    d.integrator = integrator, d.substeps = substeps;
    if (integrator == INTEGRATOR_IMPLICIT)
        d.tolerance = 1e-9;
    start(m, scene, &d);
    REQUIRE(m->x);
}

static void frames(struct spring_motion *m, int count)
{
    struct counters counters = {0};

    for (int n = 0; n < count; n++)
        REQUIRE(spring_motion_step(m, &counters) == STATUS_OK);
}

static double norm(const double *a, const double *b)
{
    double sum = 0;

    for (int t = 0; t < COUNT; t++)
        sum += (a[t] - b[t]) * (a[t] - b[t]);
    return sqrt(sum);
}

/* Forces are those of the explicit steps, which are the energy's slope (their own test);
 * tangents the slope of the forces: the best of a sweep of differences. */
static void check_tangent(void)
{
    static const struct large_path statics = {.s1 = 1, .g1 = 1};
    const double DIFFERENCE = 5e-9, none[COUNT] = {0};
    struct scene scene;
    struct spring_motion m;
    double x[COUNT], d[COUNT], moved[COUNT], f[2][COUNT], want[COUNT], best = 1;

    fill_scene(&scene, true);
    begin(&m, &scene, INTEGRATOR_MOMENTUM, 1);
    const struct large_body *body = &m.strips.body;
    for (int t = 0; t < COUNT; t++) {
        x[t] = 1.1 * m.net.rest[t] + 0.02 * noise(t);
        d[t] = noise(3 * t + 1);
        want[t] = 0;
    }
    CHECK(large_body_force(body, &statics, x, f[0]) == STATUS_OK);
    spring_stencil_force_add(&m.stencil, x, want);
    for (int t = 0; t < COUNT; t++)
        want[t] += f[0][t];
    CHECK(norm(want, none) < 1e-12 * norm(f[0], none));
    CHECK(large_body_tangent(body, &statics, x, (struct large_foresight){0}, m.large.K) ==
          STATUS_OK);
    blocks_multiply(&m.net.graph, (const double(*)[9])m.large.K, d, want);
    for (double step = 1e-4; step > 1e-8; step /= 3) {
        for (int side = 0; side < 2; side++) {
            for (int t = 0; t < COUNT; t++)
                moved[t] = x[t] + (side ? step : -step) * d[t];
            CHECK(large_body_force(body, &statics, moved, f[side]) == STATUS_OK);
        }
        for (int t = 0; t < COUNT; t++)
            moved[t] = (f[1][t] - f[0][t]) / (2 * step);
        best = fmin(best, norm(moved, want) / norm(want, none));
    }
    CHECK_NEAR(best, 0, DIFFERENCE);
    spring_motion_clear(&m);
    scene_clear(&scene);
}

/* A soft swing through a quarter turn, so that every scheme has come to its order. */
static void swing(enum integrator integrator, int substeps, double x[COUNT])
{
    struct scene scene;
    struct spring_motion m;

    fill_scene(&scene, true);
    scene.thickness = 0.05, scene.young = 2e3, scene.density = 4;
    scene.gravity[0] = 0.5, scene.gravity[2] = -3;
    scene.step = 0.05;
    begin(&m, &scene, integrator, substeps);
    frames(&m, 12);
    memcpy(x, m.x, COUNT * sizeof *x);
    spring_motion_clear(&m);
    scene_clear(&scene);
}

/* Differences between three steps, each half the one before. */
static double order(enum integrator integrator)
{
    double x[3][COUNT];

    for (int k = 0; k < 3; k++)
        swing(integrator, 10 << k, x[k]);
    return log2(norm(x[0], x[1]) / norm(x[1], x[2]));
}

static void check_order(void)
{
    const double TOL_TIME = 0.3, SAME = 2e-3; /* m, of 0.6: steps of 1.25 ms            */
    double x[2][COUNT], second = order(INTEGRATOR_MOMENTUM),
                        first = order(INTEGRATOR_IMPLICIT);

    swing(INTEGRATOR_MOMENTUM, 40, x[0]);
    swing(INTEGRATOR_LEAPFROG, 80, x[1]);
    printf("orders in time: momentum %.2f, Euler %.2f; off leapfrog by %.2g m\n", second,
           first, norm(x[0], x[1]) / sqrt(N * M));
    CHECK_NEAR(second, 2, TOL_TIME);
    CHECK_NEAR(first, 1, TOL_TIME);
    CHECK(norm(x[0], x[1]) / sqrt(N * M) < SAME);
}

/* Energy that a swing has lost or gained after `count` frames, of what turned. */
static double energy_off(enum integrator integrator, int count)
{
    struct scene scene;
    struct spring_motion m;
    double turned = 0, off = 0;

    fill_scene(&scene, true);
    scene.thickness = 0.003, scene.young = 1e6;
    begin(&m, &scene, integrator, 1);
    for (int n = 0; n < count; n++) {
        struct energy e;
        frames(&m, 1);
        spring_motion_energy(&m, &e);
        turned = fmax(turned, -e.potential);
        off = fmax(off, fabs(e.kinetic + e.elastic + e.potential));
    }
    spring_motion_clear(&m);
    scene_clear(&scene);
    return off / turned;
}

/* Ten periods, undamped, in steps of 5 ms. What is lost is what the viscosity of the
 * springs takes; Euler's steps lose the motion. */
static void check_energy(void)
{
    const double KEPT = 1e-2;
    double kept = energy_off(INTEGRATOR_MOMENTUM, 1000);
    double damped = energy_off(INTEGRATOR_IMPLICIT, 250);

    printf("energy: momentum off by %.2e, Euler in a quarter of that by %.2e\n", kept,
           damped);
    CHECK(kept < KEPT);
    CHECK(damped > 10 * KEPT);
}

/* A free sheet that is thrown and turns keeps momentum and angular momentum to what
 * Newton's method leaves. */
static void check_momenta(void)
{
    const double KEPT = 1e-6;
    struct scene scene;
    struct spring_motion m;
    double L[2][6] = {{0}};

    fill_scene(&scene, false);
    memset(scene.gravity, 0, sizeof scene.gravity);
    begin(&m, &scene, INTEGRATOR_MOMENTUM, 1);
    double *v = m.large.newmark.v;
    for (int a = 0; a < N * M; a++) {
        v[3 * a] = 0.3, v[3 * a + 1] = -2 * m.x[3 * a + 2];
        v[3 * a + 2] = 4 * (m.x[3 * a] - 0.2) + 0.5 * noise(a);
    }
    for (int k = 0; k < 2; k++) {
        for (int a = 0; a < N * M; a++)
            for (int c = 0; c < 3; c++) {
                int p = 3 * a + (c + 1) % 3, q = 3 * a + (c + 2) % 3;
                L[k][c] += m.points.mass[a] * v[3 * a + c];
                L[k][3 + c] += m.points.mass[a] * (m.x[p] * v[q] - m.x[q] * v[p]);
            }
        frames(&m, k ? 0 : 100);
    }
    double scale = fabs(L[0][2]) + fabs(L[0][4]);
    for (int c = 0; c < 6; c++)
        CHECK_NEAR(L[1][c] / scale, L[0][c] / scale, KEPT);
    spring_motion_clear(&m);
    scene_clear(&scene);
}

/* Rest is leapfrog's, and steps from there stay there. */
static void check_rest(void)
{
    const double STILL = 1e-6; /* m: Newton's tolerance over frames                     */
    struct scene scene;
    struct spring_motion m[2];
    double x[COUNT];
    struct counters counters = {0};
    struct message why;

    fill_scene(&scene, true);
    for (int k = 0; k < 2; k++) {
        begin(&m[k], &scene, k ? INTEGRATOR_LEAPFROG : INTEGRATOR_MOMENTUM, 0);
        CHECK(spring_rest_equilibrium(&m[k], &counters, &why) == STATUS_OK);
    }
    CHECK(norm(m[0].x, m[1].x) < STILL);
    memcpy(x, m[0].x, sizeof x);
    frames(&m[0], 20);
    CHECK(norm(m[0].x, x) < STILL);
    for (int k = 0; k < 2; k++)
        spring_motion_clear(&m[k]);
    scene_clear(&scene);
}

/* Tip of a strip under a small load, at rest, against Kirchhoff's q L^4 / 8 B. */
static double droop(int n)
{
    struct scene scene;
    struct spring_motion m;
    struct discretization d = net_of(n, 3);
    struct counters counters = {0};
    struct message why;

    d.integrator = INTEGRATOR_MOMENTUM;
    fill_scene(&scene, true);
    scene.poisson = 0, scene.thickness = 0.02, scene.width = 0.2;
    scene.gravity[0] = 0, scene.gravity[2] = -1e-4;
    start(&m, &scene, &d);
    REQUIRE(spring_rest_equilibrium(&m, &counters, &why) == STATUS_OK);
    double tip = m.x[3 * (m.net.nodes - 1) + 2];
    double want = scene.density * scene.thickness * scene.gravity[2] *
                  pow(scene.length, 4) / 8 / scene_bending_stiffness(&scene);
    spring_motion_clear(&m);
    scene_clear(&scene);
    return tip / want - 1;
}

/* Second order in the net, as of triangles and constraints, which have the same clamp. */
static void check_clamp(void)
{
    const double ORDER = 0.25; /* seen between two nets; the weights 1/2 and 1 have 0.9 */
    double coarse = droop(17), fine = droop(33);

    printf("cantilever off by %.2e, with half the cells' size %.2e\n", coarse, fine);
    CHECK_NEAR(log2(fabs(coarse / fine)), 2, ORDER);
}

static void check_refusals(void)
{
    static const struct {
        struct discretization d;
        const char *says;
        struct spring_own own;
    } cases[] = {
        {{.iterations = 3}, "iterations"},
        {{.tolerance = 1e-6}, "tolerance"},
        {{0}, "strain_limit", {.strain_limit = 0.1}},
        {{.parameters = PARAMETERS_PAPER}, "parameters=paper"},
        {{.precision = PRECISION_SINGLE}, "precision=single"},
        {{.integrator = INTEGRATOR_LEAPFROG}, "strain_limit", {.strain_limit = 0.1}},
        {{0}, "with integrator=leapfrog only", {.springs = SPRINGS_LENGTHS}},
        {{.integrator = INTEGRATOR_EXPLICIT, .bending = BENDING_STRUT},
         "with integrator=leapfrog only"},
        {{.integrator = INTEGRATOR_LEAPFROG, .bending = BENDING_STRUT},
         "with springs=lengths only"},
        {{.integrator = INTEGRATOR_LEAPFROG, .bending = BENDING_HINGE}, "bending=hinge"},
        {{.integrator = INTEGRATOR_BDF2}, "integrator=bdf2"},
        {{.integrator = INTEGRATOR_MIDPOINT}, "integrator=midpoint"}};

    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        struct scene scene;
        struct discretization d = net_of(5, 5);
        struct message why = {{0}};
        void *state = NULL;
        fill_scene(&scene, true);
        d.integrator = cases[k].d.integrator ? cases[k].d.integrator : INTEGRATOR_MOMENTUM;
        d.iterations = cases[k].d.iterations, d.tolerance = cases[k].d.tolerance;
        *OWN(spring_own, &d) = cases[k].own, d.precision = cases[k].d.precision;
        d.parameters = cases[k].d.parameters;
        d.bending = cases[k].d.bending;
        CHECK(spring_model.create(&scene, &d, &state, &why) == STATUS_UNSUPPORTED);
        if (!CHECK(!state && strstr(why.text, cases[k].says)))
            printf("%s\n", why.text);
        scene_clear(&scene);
    }
}

int main(void)
{
    check_tangent();
    check_order();
    check_energy();
    check_momenta();
    check_rest();
    check_clamp();
    check_refusals();
    return check_result();
}

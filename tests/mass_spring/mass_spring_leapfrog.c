/* Springs in explicit steps, leapfrog's above all: stability limit, scaled
 * velocities, moved edges, precision. (Falls: fall.c; order: time_order.c; the clamp:
 * nets_bend.c.) */
#include "models/net/spring_stencil.h"
#include "tests/mass_spring.h"

static struct discretization leapfrog(int n, int m)
{
    struct discretization d = net_of(n, m);

    d.integrator = INTEGRATOR_LEAPFROG;
    return d;
}

static double total(struct spring_motion *m)
{
    struct energy e;

    spring_motion_energy(m, &e);
    return e.kinetic + e.elastic + e.potential;
}

/* Energy after 4000 steps at a part of the limit, over that at the start. */
static double growth(enum integrator integrator, double part, double beta,
                     enum precision precision)
{
    struct scene scene;
    struct spring_motion m;
    struct discretization d = leapfrog(7, 6);
    double first = 0, last = 0;

    fill_scene(&scene, true);
    memset(scene.gravity, 0, sizeof scene.gravity);
    scene.damping = (struct scene_damping){.kind = DAMPING_RAYLEIGH, .beta = beta};
    scene.velocity[2] = 0.1;
    d.integrator = integrator, d.precision = precision;
    start(&m, &scene, &d);
    CHECK(m.dt < m.limit); /* steps that it takes by itself */
    scene.step = part * m.limit;
    spring_motion_clear(&m);
    d.substeps = 1;
    start(&m, &scene, &d);
    for (int n = 0; n < 4000 && last < 1; n++) {
        struct counters counters = {0};
        const enum status st = spring_motion_step(&m, &counters);
        last = st == STATUS_OK ? total(&m) : INFINITY;
        CHECK(st == STATUS_OK || st == STATUS_NAN);
        if (!n)
            first = last;
    }
    spring_motion_clear(&m);
    scene_clear(&scene);
    return last / first;
}

/* The limit is that of the largest frequency: stable below, not above. Symplectic Euler
 * keeps the energy within a factor 1 / (1 - dt omega / 2) on either side. */
static void check_limit(void)
{
    const struct {
        enum integrator by;
        double most;
    } rows[] = {{INTEGRATOR_LEAPFROG, 2}, {INTEGRATOR_EXPLICIT, 20}};

    for (int k = 0; k < 2; k++) {
        CHECK(growth(rows[k].by, 0.95, 0, PRECISION_DOUBLE) < rows[k].most);
        CHECK(growth(rows[k].by, 1.05, 0, PRECISION_DOUBLE) > 1e3);
        CHECK(growth(rows[k].by, 0.9, 1e-3, PRECISION_DOUBLE) < 1);
        CHECK(growth(rows[k].by, 1.1, 1e-3, PRECISION_DOUBLE) > 1e3);
    }
    CHECK(growth(INTEGRATOR_LEAPFROG, 0.95, 0, PRECISION_SINGLE) < 2);
}

/* A net and the same with u and v exchanged move alike, whatever their sizes. */
static void check_exchanged(int n, int m)
{
    struct scene scene[2];
    struct spring_motion motion[2];
    double off = 0;

    for (int k = 0; k < 2; k++) {
        struct scene_support edge = {.hi = {k ? 1 : 0, k ? 0 : 1, 1}, .fix = FIX_XYZ};
        struct discretization d = leapfrog(k ? m : n, k ? n : m);
        fill_scene(&scene[k], false);
        scene[k].gravity[0] = 0;
        if (k) {
            double length = scene[k].length;
            scene[k].length = scene[k].width, scene[k].width = length;
        }
        REQUIRE(scene_add_support(&scene[k], &edge) == STATUS_OK);
        start(&motion[k], &scene[k], &d);
        steps(&motion[k], 20);
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            const double *a = motion[0].x + 3 * (i * m + j),
                         *b = motion[1].x + 3 * (j * n + i);
            off = fmax(off, fabs(a[0] - b[1]) + fabs(a[1] - b[0]) + fabs(a[2] - b[2]));
        }
    const double rounding = 1e-10; /* of some thousand steps */
    if (!CHECK(off < rounding))
        printf("%d x %d: %g\n", n, m, off);
    CHECK(fabs(motion[0].x[3 * (n * m - 1) + 2]) > 0.01);
    for (int k = 0; k < 2; k++) {
        spring_motion_clear(&motion[k]);
        scene_clear(&scene[k]);
    }
}

/* A frame's halving of velocities only takes energy, also from modes at the limit: the net
 * hangs still, no spring is strained; single precision goes where double does. */
static void check_scaled(void)
{
    enum { KINDS = 3 };
    static const enum integrator by[KINDS] = {INTEGRATOR_EXPLICIT, INTEGRATOR_LEAPFROG,
                                              INTEGRATOR_LEAPFROG};
    struct scene scene;
    struct spring_motion m[KINDS];
    double off = 0;

    fill_scene(&scene, true);
    scene.thickness = 0.001;
    scene.damping = (struct scene_damping){.kind = DAMPING_VELOCITY_SCALE, .value = 0.5};
    for (int k = 0; k < KINDS; k++) {
        struct discretization d = leapfrog(8, 7);
        struct energy e;
        d.integrator = by[k];
        d.precision = k == 2 ? PRECISION_SINGLE : PRECISION_DOUBLE;
        start(&m[k], &scene, &d);
        steps(&m[k], 400);
        spring_motion_energy(&m[k], &e);
        CHECK(e.kinetic < 0.01 * -e.potential);
        CHECK(largest_strain(&m[k]) < 0.01);
    }
    for (int t = 0; t < 3 * m[1].net.nodes; t++)
        off = fmax(off, fabs(m[1].x[t] - m[2].x[t]));
    CHECK(off > 0 && off < 1e-4);
    for (int k = 0; k < KINDS; k++)
        spring_motion_clear(&m[k]);
    scene_clear(&scene);
}

/* A sheet damped by mass and stiffness, whose edge is pulled in its plane and turns back:
 * small strains, in which all springs are one law. Positions and energy while it moves. */
struct driven {
    double pull; /* [m] */
    enum integrator integrator;
    int substeps;
    enum precision precision;
};

static void drive(struct driven by, double *x, double *energy)
{
    const double path[3][4] = {{0}, {0.05, by.pull, by.pull, 0}, {0.1}};
    struct scene scene;
    struct spring_motion m;
    struct discretization d = net_of(8, 7);

    fill_scene(&scene, true);
    scene.gravity[0] = scene.gravity[2] = 0;
    scene.young = 1e3;
    scene.damping =
        (struct scene_damping){.kind = DAMPING_RAYLEIGH, .alpha = 1, .beta = 2e-3};
    scene.supports[0].path = malloc(sizeof path);
    REQUIRE(scene.supports[0].path);
    memcpy(scene.supports[0].path, path, sizeof path);
    scene.supports[0].path_count = 3;
    d.integrator = by.integrator, d.substeps = by.substeps, d.precision = by.precision;
    start(&m, &scene, &d);
    steps(&m, 8);
    memcpy(x, m.x, 3 * (size_t)m.net.nodes * sizeof *x);
    *energy = total(&m);
    spring_motion_clear(&m);
    scene_clear(&scene);
}

/* Damping by stiffness knows the velocity of held points, too: the leapfrog goes where the
 * implicit and the explicit steps go, and has the same energy, of held points as well. What
 * first-order steps of 25 us leave is a part of beta / 25 us, and some parts in a thousand;
 * held points without velocity would be off by 5 %. Single precision moves points at 0.6 m
 * by 1e-4 m, of which its digits are 6e-4, a hundred steps a frame. */
static void check_driven(void)
{
    static const struct {
        struct driven one, other;
        double tolerance; /* of the pull, and of the energy                           */
    } cases[] = {
        {{1e-6, INTEGRATOR_LEAPFROG, 400, PRECISION_DOUBLE},
         {1e-6, INTEGRATOR_IMPLICIT, 400, PRECISION_DOUBLE},
         1e-2},
        {{1e-6, INTEGRATOR_LEAPFROG, 400, PRECISION_DOUBLE},
         {1e-6, INTEGRATOR_EXPLICIT, 400, PRECISION_DOUBLE},
         1e-2},
        {{1e-4, INTEGRATOR_LEAPFROG, 100, PRECISION_SINGLE},
         {1e-4, INTEGRATOR_LEAPFROG, 100, PRECISION_DOUBLE},
         5e-2},
    };

    for (int k = 0; k < 3; k++) {
        double x[3 * 56], y[3 * 56], energy[2], off = 0;
        drive(cases[k].one, x, energy);
        drive(cases[k].other, y, energy + 1);
        for (int t = 0; t < 3 * 56; t++)
            off = fmax(off, fabs(x[t] - y[t]) / cases[k].one.pull);
        printf("driven: off by %.2e of the pull, energy by %.2e\n", off,
               fabs(energy[0] / energy[1] - 1));
        CHECK(off < cases[k].tolerance);
        CHECK_RELATIVE(energy[0], energy[1], cases[k].tolerance);
    }
}

int main(void)
{
    omp_set_num_threads(1);
    check_limit();
    check_exchanged(2, 3);
    check_exchanged(5, 9);
    check_exchanged(8, 17);
    check_exchanged(18, 35); /* strips of rows, lengthened ones of columns */
    check_scaled();
    check_driven();
    return check_result();
}

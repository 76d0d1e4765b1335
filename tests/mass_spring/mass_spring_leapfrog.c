/* Springs in explicit steps, leapfrog's above all: stability limit, scaled velocities,
 * moved edges, precision, stretched springs; slopes, also of swept triangles. (Falls:
 * fall.c; order: time_order.c; the clamp: nets_bend.c.) */
#include "models/net/spring_stencil.h"
#include "tests/mass_spring.h"
#include "tests/opened_run.h"

static void leapfrog(struct springs *s, int n, int m, bool held)
{
    springs_init(s, n, m, held);
    s->d.integrator = INTEGRATOR_LEAPFROG;
}

/* Energy after 4000 steps at a part of the limit, over that at the start. */
static double growth(double part, double beta, enum precision precision)
{
    struct springs s;
    double first = 0, last = 0;

    leapfrog(&s, 7, 6, true);
    memset(s.scene.gravity, 0, sizeof s.scene.gravity);
    s.scene.damping = (struct scene_damping){.kind = DAMPING_RAYLEIGH, .beta = beta};
    s.scene.velocity[2] = 0.1;
    s.d.precision = precision;
    springs_start(&s);
    const struct spring_leapfrog *l = s.m.march.own;
    const double limit = l->limit;
    CHECK(l->dt < limit); /* steps that it takes by itself */
    s.scene.step = part * limit;
    spring_motion_clear(&s.m);
    s.d.substeps = 1;
    springs_start(&s);
    for (int n = 0; n < 4000 && last < 1; n++) {
        const enum status st = spring_motion_step(&s.m, &s.counters);
        last = st == STATUS_OK ? springs_energy(&s) : INFINITY;
        CHECK(st == STATUS_OK || st == STATUS_NAN);
        if (!n)
            first = last;
    }
    springs_clear(&s);
    return last / first;
}

/* The limit is that of the largest frequency: stable below, not above. */
static void check_limit(void)
{
    CHECK(growth(0.95, 0, PRECISION_DOUBLE) < 2);
    CHECK(growth(1.05, 0, PRECISION_DOUBLE) > 1e3);
    CHECK(growth(0.9, 1e-3, PRECISION_DOUBLE) < 1);
    CHECK(growth(1.1, 1e-3, PRECISION_DOUBLE) > 1e3);
    CHECK(growth(0.95, 0, PRECISION_SINGLE) < 2);
}

/* A net and the same with u and v exchanged move alike, whatever their sizes. */
static void check_exchanged(int n, int m)
{
    const double rounding = 1e-10; /* of some thousand steps */
    struct springs s[2];
    double off = 0;

    for (int k = 0; k < 2; k++) {
        const struct scene_support edge = {.hi = {k ? 1 : 0, k ? 0 : 1, 1}, .fix = FIX_XYZ};
        struct scene *scene = &s[k].scene;
        leapfrog(&s[k], k ? m : n, k ? n : m, false);
        scene->gravity[0] = 0;
        if (k) {
            double length = scene->length;
            scene->length = scene->width, scene->width = length;
        }
        REQUIRE(scene_add_support(scene, &edge) == STATUS_OK);
        springs_start(&s[k]);
        springs_steps(&s[k], 20);
    }
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            const double *a = s[0].m.net.x + 3 * (i * m + j),
                         *b = s[1].m.net.x + 3 * (j * n + i);
            off = fmax(off, fabs(a[0] - b[1]) + fabs(a[1] - b[0]) + fabs(a[2] - b[2]));
        }
    CHECK_SAY(off < rounding, "%d x %d: %g", n, m, off);
    CHECK(fabs(s[0].m.net.x[3 * (n * m - 1) + 2]) > 0.01);
    for (int k = 0; k < 2; k++)
        springs_clear(&s[k]);
}

/* A frame's halving of velocities only takes energy, also from modes at the limit: the net
 * hangs still, no spring is strained; single precision goes where double does. */
static void check_scaled(void)
{
    static const struct {
        enum integrator by;
        enum precision precision;
    } kinds[] = {{INTEGRATOR_EXPLICIT, PRECISION_DOUBLE},
                 {INTEGRATOR_LEAPFROG, PRECISION_DOUBLE},
                 {INTEGRATOR_LEAPFROG, PRECISION_SINGLE}};
    struct springs s[3];
    double off = 0;

    for (int k = 0; k < 3; k++) {
        struct energy e;
        leapfrog(&s[k], 8, 7, true);
        s[k].scene.thickness = 0.001;
        s[k].scene.damping =
            (struct scene_damping){.kind = DAMPING_VELOCITY_SCALE, .value = 0.5};
        s[k].d.integrator = kinds[k].by, s[k].d.precision = kinds[k].precision;
        springs_start(&s[k]);
        springs_steps(&s[k], 400);
        spring_motion_energy(&s[k].m, &e);
        CHECK(e.kinetic < 0.01 * -e.potential);
        CHECK(springs_strain(&s[k]) < 0.01);
    }
    for (int t = 0; t < 3 * s[1].m.net.mesh.nodes; t++)
        off = fmax(off, fabs(s[1].m.net.x[t] - s[2].m.net.x[t]));
    CHECK(off > 0 && off < 1e-4);
    for (int k = 0; k < 3; k++)
        springs_clear(&s[k]);
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
    double path[3][4] = {{0}, {0.05, by.pull, by.pull, 0}, {0.1}};
    const struct scene_support edge = {
        .hi = {0, 1, 1}, .fix = FIX_XYZ, .motion = {.path = path, .path_count = 3}};
    struct springs s;

    springs_init(&s, 8, 7, false);
    REQUIRE(scene_add_support(&s.scene, &edge) == STATUS_OK);
    s.scene.gravity[0] = s.scene.gravity[2] = 0;
    s.scene.young = 1e3;
    s.scene.damping =
        (struct scene_damping){.kind = DAMPING_RAYLEIGH, .alpha = 1, .beta = 2e-3};
    s.d.integrator = by.integrator, s.d.substeps = by.substeps,
    s.d.precision = by.precision;
    springs_start(&s);
    springs_steps(&s, 8);
    memcpy(x, s.m.net.x, 3 * (size_t)s.m.net.mesh.nodes * sizeof *x);
    *energy = springs_energy(&s);
    springs_clear(&s);
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

static double elastic_of(const struct run *run)
{
    struct energy e;

    run->model->energy(run->state, &e);
    return e.elastic;
}

/* A step too short to move anything shows what pulls: the slope of the energy. */
static void check_slope(const char *model, const char *membrane, int n, int m)
{
    enum { EVERY = 23 };
    const double SLOPE = 1e-5; /* of differences, of the greatest                       */
    struct run run;
    double most = 0, off = 0;
    char points[64];

    snprintf(points, sizeof points, "discretization.points=[%d,%d]", n, m);
    OPENED_RUN(&run, "cantilever", model, points, "discretization.integrator=leapfrog",
               "discretization.substeps=1", "damping={kind: none}", "sheet.thickness=0.01",
               "material={young: 1, poisson: 0, density: 1}",
               "time={step: 1e-9, end: 1e-8}", "snapshots=[]", membrane);
    const struct march *march = run.state;
    double *x = march->x, small = 1e-4 * run.scene.length / n;
    for (int t = 0; t < 3 * n * m; t++)
        x[t] += march->supports->free_index[t] < 0 ? 0 : 1e3 * small * noise(t);
    spring_leapfrog_place(march->own, 0);
    opened_steps(&run, 1);
    const double *v = march_velocity(march); /* x is that of a step before, to 1e-9 s */
    for (int t = 0; t < 3 * n * m; t += EVERY) {
        double was = x[t], slope, force = v[t] * march->mass[t / 3] / run.scene.step;
        if (march->supports->free_index[t] < 0)
            continue;
        x[t] = was + small, slope = elastic_of(&run);
        x[t] = was - small, slope -= elastic_of(&run);
        x[t] = was, slope = march->load[t] - slope / (2 * small);
        off = fmax(off, fabs(force - slope));
        most = fmax(most, fabs(slope));
    }
    CHECK_SAY(off < SLOPE * most, "%s, %d x %d: %g of %g", model, n, m, off, most);
    run_close(&run);
}

/* A weak net that its weight stretches by half and more becomes stiffer: the step follows,
 * and with the number of steps fixed at what rest asks for it dies. */
static void check_watched(void)
{
    struct springs s;
    enum status st = STATUS_OK;

    leapfrog(&s, 6, 5, true);
    s.scene.young = 6;
    s.scene.gravity[0] = 30, s.scene.gravity[2] = 0;
    s.scene.step = 0.02;
    springs_start(&s);
    const struct spring_leapfrog *l = s.m.march.own;
    const double dt = l->dt;
    springs_steps(&s, 200);
    CHECK(spring_stencil_stretch2(&s.m.stencil, s.m.net.x) > 1.5);
    CHECK(l->dt < 0.9 * dt);
    spring_motion_clear(&s.m);
    s.d.substeps = (int)round(s.scene.step / dt);
    springs_start(&s);
    for (int n = 0; n < 200 && st == STATUS_OK; n++)
        st = spring_motion_step(&s.m, &s.counters);
    CHECK(st == STATUS_NAN);
    springs_clear(&s);
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
    check_slope("mass_spring", NULL, 6, 7);
    check_slope("mass_spring", NULL, 35, 19);
    check_slope("triangles", "discretization.membrane=green", 6, 5);
    check_slope("triangles", "discretization.membrane=corotational", 33, 31);
    check_slope("triangles", "discretization.membrane=green", 4, 260);
    check_watched();
    return check_result();
}

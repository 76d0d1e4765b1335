/* A sheet that flies away or is carried away is not taken for one that flies apart; and in
 * every model one that nothing holds turns as it was thrown. (How far it flies: fall.c.) */

#include "bench/harness/motion.h"
#include "models/metric/metric.h"
#include "models/metric/metric_rest.h"
#include "tests/opened_run.h"

/* Round-off of positions of some hundred metres, and of iterations that stop at 1e-6 L. */
static const double TOL_FLIGHT = 1e-5;

/* Free along x alone, which it does not fall; and carried by its edge: no death. */
static void check_partly_held(const struct model *model)
{
    static const char *const held[][2] = {
        {"motion={velocity: [60, 0, 0]}", "supports=[{at: {u: 0}, fix: yz}]"},
        {"motion={velocity: [0, 30, 0]}",
         "supports=[{at: {u: 0}, fix: xyz, path: [[0, 0, 0, 0], [0.5, 0, 15, 0]]}]"}};
    static const double edge[3] = {0, 0.5, 0.5}, want[][2] = {{30, 0}, {0, 15}};
    const char *points = model->defaults.points[2] > 1 ? "discretization.points=[5,4,2]"
                                                       : "discretization.points=[5,4]";

    for (int n = 0; n < 2; n++) {
        double start[3], x[3];
        struct motion m;
        struct run run;
        OPENED_RUN(&run, "edge_drop", model->name, "gravity=[0,0,-9.81]",
                   "damping={kind: none}", "snapshots=[]", "time={step: 0.01, end: 0.5}",
                   points,
                   !strcmp(model->name, "position_based") /* as small as it likes them */
                       ? "discretization.substeps=40"
                       : points,
                   held[n][0], held[n][1]);
        motion_init(&m, run.model, &run.scene, run.state);
        REQUIRE(motion_run(&m, NULL, NULL, true, NULL) == STATUS_OK);
        CHECK_SAY(!m.death && m.frames == m.frame_count, "%s, %s: dies at %g s",
                  model->name, held[n][0], m.death_time);
        motion_clear(&m);
        scene_rest_point(&run.scene, edge, start);
        run.model->probe(run.state, 1, edge, x);
        CHECK_NEAR(x[0] - start[0], want[n][0], run.scene.length);
        CHECK_NEAR(x[1] - start[1], want[n][1], TOL_FLIGHT);
        run_close(&run);
    }
}

#define THROWN                                                                             \
    "supports=[]", "gravity=[0,0,0]", "damping={kind: none}", "sheet.thickness=0.02",      \
        "material.density=100", "pose.origin=[-0.5,-0.5,0]"

/* Kinetic energy of the throw itself, m v^2 / 2 + omega I omega / 2 about the middle;
 * masses in points, and shells without rotary inertia, leave some of it out: points 1/81 of
 * the sheet's own inertia. */
static const double TOL_ENERGY = 1e-12, TOL_LUMPED = 0.03;
/* Half a turn by 100 steps: average velocity comes (omega dt)^2 / 12 of it late, and a
 * sheet of 1e8 Pa is all but rigid; implicit Euler loses a part of its spin. */
static const double TOL_TURN = 2e-3, TOL_EULER = 0.1;

static void check_spun(const struct model *model)
{
    static const double corner[3] = {1, 1, 0.5};
    const bool solid = !strcmp(model->name, "iga") || !strcmp(model->name, "hex");
    struct energy e;
    struct run run;
    double x[3];

    OPENED_RUN(&run, "edge_drop", model->name, THROWN,
               "motion={velocity: [1,-2,3], spin: [4,-5,6]}");
    const double h = 0.02, mass = 100 * h, across = mass / 12 * (1 + h * h);
    const double want = mass / 2 * (1 + 4 + 9) + across / 2 * (16 + 25) + mass / 12 * 36;
    run.model->energy(run.state, &e);
    bool good = CHECK_NEAR(e.kinetic / want, 1, solid ? TOL_ENERGY : TOL_LUMPED);
    run_close(&run);
    OPENED_RUN(&run, "edge_drop", model->name, THROWN, "motion={spin: [0,10,0]}",
               "material.young=1e8", "time={step: 0.00314159265358979, end: 1}",
               model->matrices ? "discretization.kinematics=nonlinear" : NULL);
    const double tolerance = model->matrices ? TOL_TURN : TOL_EULER;
    for (int half = 1; half <= 2; half++) { /* a quarter: first (0, 0, -5) m/s */
        opened_steps(&run, 50);
        run.model->probe(run.state, 1, corner, x);
        good &= CHECK_NEAR(x[0], half == 1 ? 0 : -0.5, tolerance);
        good &= CHECK_NEAR(x[2], half == 1 ? -0.5 : 0, tolerance);
        good &= CHECK_NEAR(x[1], 0.5, tolerance);
    }
    SAY_UNLESS(good, "%s", model->name);
    run_close(&run);
}

/* A sheet that is carried away as a whole, as far as its row allows, is no blow-up. */
enum { GRAVITY = 8, LOAD, WIND, PATH, HELD_XZ, HELD };
static const struct {
    int with; /* bits 1 << the above                                               */
    double v[3], t, shift[3], corner;
    enum status want;
} carried[] = {
    {0, {30, 0, 0}, 1, {30, 0, 0}, 0, STATUS_OK},
    {0, {30, 0, 0}, 1, {30, 0, 0}, 9.9, STATUS_OK},
    {0, {30, 0, 0}, 1, {30, 0, 0}, 10.1, STATUS_ESCAPED},
    {0, {30, 0, 0}, 1, {0, -30, 0}, 0, STATUS_OK}, /* round a corner               */
    {0, {30, 0, 0}, 1, {39.9, 0, 0}, 0, STATUS_OK},
    {0, {30, 0, 0}, 1, {40.1, 0, 0}, 0, STATUS_ESCAPED},
    {0, {30, 0, 0}, 0.5, {26, 0, 0}, 0, STATUS_ESCAPED},
    {0, {0, 0, 0}, 1, {9.9, 0, 0}, 0, STATUS_OK},
    {0, {0, 0, 0}, 1, {10.1, 0, 0}, 0, STATUS_ESCAPED},
    {1 << GRAVITY, {0, 0, 0}, 4, {0, 0, -78}, 0, STATUS_OK}, /* g t^2 / 2 = 80      */
    {1 << GRAVITY, {0, 0, 0}, 4, {0, 0, -91}, 0, STATUS_ESCAPED},
    {1 << GRAVITY, {0, 0, 0}, 4, {0, 0, 9.9}, 0, STATUS_OK}, /* it cannot rise      */
    {1 << GRAVITY, {0, 0, 0}, 4, {0, 0, 10.1}, 0, STATUS_ESCAPED},
    {1 << GRAVITY, {20, 0, 0}, 4, {0, 0, 29.9}, 0, STATUS_OK}, /* v^2 / 2 g = 20    */
    {1 << GRAVITY, {20, 0, 0}, 4, {0, 0, 30.1}, 0, STATUS_ESCAPED},
    {1 << LOAD, {0, 0, 0}, 2, {0, 44, 0}, 0, STATUS_OK}, /* 20 m/s^2: 40            */
    {1 << LOAD, {0, 0, 0}, 2, {0, 51, 0}, 0, STATUS_ESCAPED},
    {1 << WIND, {0, 0, 0}, 2, {29, 0, 0}, 0, STATUS_OK}, /* 10 m/s                  */
    {1 << WIND, {0, 0, 0}, 2, {31, 0, 0}, 0, STATUS_ESCAPED},
    {1 << HELD, {30, 0, 0}, 1, {11, 0, 0}, 0, STATUS_ESCAPED},
    {1 << HELD_XZ, {0, 30, 0}, 1, {0, 30, 0}, 0, STATUS_OK},
    {1 << HELD_XZ, {0, 30, 0}, 1, {11, 0, 0}, 0, STATUS_ESCAPED},
    {1 << HELD | 1 << PATH, {0, 0, 0}, 1, {20, 0, 0}, 0, STATUS_OK},
    {1 << HELD | 1 << PATH, {0, 0, 0}, 0, {20, 0, 0}, 0, STATUS_ESCAPED},
    {1 << HELD | 1 << PATH, {0, 0, 0}, 1, {0, 0, 0}, 0, STATUS_ESCAPED},
};

static void test_carried(void)
{
    double path[][4] = {{0, 0, 0, 0}, {1, 20, 0, 0}};

    for (size_t r = 0; r < sizeof carried / sizeof *carried; r++) {
        const int with = carried[r].with;
        struct scene scene;
        struct scene_support edge = {.lo = {0, 0, 0}, .hi = {0, 1, 1}, .fix = FIX_XYZ};
        REQUIRE(scene_init(&scene) == STATUS_OK);
        scene.gravity[2] = with & 1 << GRAVITY ? -10 : 0;
        memcpy(scene.velocity, carried[r].v, sizeof scene.velocity);
        scene.drag = with & 1 << WIND ? 1 : 0;
        scene.wind[0] = 10;   /* nothing without drag */
        if (with & 1 << LOAD) /* of a sheet of 0.01 kg */
            REQUIRE(scene_add_load(&scene, &(struct scene_load){.force = {0, 0.2, 0}}) ==
                    STATUS_OK);
        if (with & 1 << PATH)
            edge.motion.path_count = 2, edge.motion.path = path;
        if (with & 1 << HELD_XZ)
            edge.fix = FIX_X | FIX_Z;
        if (with & (1 << HELD | 1 << HELD_XZ))
            REQUIRE(scene_add_support(&scene, &edge) == STATUS_OK);
        double *xyz = metric_rest_field(&scene);
        REQUIRE(xyz);
        for (int n = 0; n < GRID_POINTS; n++)
            for (int c = 0; c < 3; c++)
                xyz[3 * n + c] += carried[r].shift[c];
        xyz[3 * (GRID_POINTS - 1) + 1] += carried[r].corner;
        CHECK_SAY(metric_blowup(&scene, carried[r].t, xyz) == carried[r].want, "row %zu",
                  r);
        scene_clear(&scene);
        free(xyz);
    }
}

int main(void)
{
    test_carried();
    for (int n = 0; contestant_model(n); n++) {
        check_partly_held(contestant_model(n));
        check_spun(contestant_model(n));
    }
    return check_result();
}

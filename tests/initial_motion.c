/* Initial velocity and spin: a free sheet flies as it was thrown, in every model. */
#include "bench/harness/contestant.h"
#include "models/reader/scene_file.h"
#include "tests/check.h"
#include "tests/opened_run.h"

/* Round-off of 20 steps: a sheet that keeps its shape asks for no iterations. The rebuilt
 * schemes sum it up, times the condition of control points as unknowns. */
static const double TOL_FLIGHT = 1e-7;

/* Kinetic energy of the throw itself; masses in points, and shells without rotary inertia,
 * leave some of it out: points 1/81 of the sheet's own inertia. */
static const double TOL_ENERGY = 1e-12, TOL_LUMPED = 0.03;

/* Half a turn by 100 steps: average velocity comes (omega dt)^2 / 12 of it late, and a
 * sheet of 1e8 Pa is all but rigid; implicit Euler loses a part of its spin. */
static const double TOL_TURN = 2e-3, TOL_EULER = 0.1;

enum { STEPS = 20 };

static const char *const kinematics[] = {
    "discretization.kinematics=linear", "discretization.kinematics=printed",
    "discretization.kinematics=incremental", "discretization.kinematics=nonlinear"};

static const char *path; /* of edge_drop */

#define SHEET                                                                              \
    "supports=[]", "gravity=[0,0,0]", "damping={kind: none}", "sheet.thickness=0.02",      \
        "material={young: 1e3, poisson: 0.3, density: 100}", "pose.origin=[-0.5,-0.5,0]"

static void open(struct run *t, const char *model, const char *const *settings)
{
    int count = 0;

    while (settings[count])
        count++;
    opened_run(t, path, model, count, settings);
}

#define OPEN(run, model, ...) open(run, model, (const char *const[]){__VA_ARGS__, NULL})

static void advance(struct run *t, int steps)
{
    struct counters counters = {0};

    for (int n = 0; n < steps; n++)
        if (!CHECK(t->model->advance(t->state, &counters) == STATUS_OK)) {
            printf("%s, %s, step %d\n", t->model->name,
                   option_kinematics[t->discretization.kinematics], n);
            exit(1);
        }
}

/* Without spin: displacement = velocity times t, in every kinematics. */
static void check_throw(const char *model, const char *how)
{
    static const double velocity[3] = {1, -2, 3}, uvw[3] = {0.3, 1, 0.5};
    struct run t;
    OPEN(&t, model, SHEET, "motion={velocity: [1,-2,3]}", how);
    double rest[3], xyz[3];

    scene_rest_point(&t.scene, uvw, rest);
    advance(&t, STEPS);
    t.model->probe(t.state, 1, uvw, xyz);
    for (int i = 0; i < 3; i++)
        if (!CHECK_NEAR(xyz[i], rest[i] + STEPS * t.scene.step * velocity[i], TOL_FLIGHT))
            printf("%s, %s\n", model, how);
    run_close(&t);
}

/* m v^2 / 2 + omega I omega / 2 about the middle, before any step. */
static void check_energy(const char *model, const char *how)
{
    struct run t;
    OPEN(&t, model, SHEET, "motion={velocity: [1,-2,3], spin: [4,-5,6]}", how);
    const double h = t.scene.thickness, mass = t.scene.density * h;
    const double across = mass / 12 * (1 + h * h), about = mass / 6;
    const double want = mass / 2 * (1 + 4 + 9) + across / 2 * (16 + 25) + about / 2 * 36;
    const double tolerance =
        t.model->matrices && strcmp(model, "shell") && strcmp(model, "triangles")
            ? TOL_ENERGY
            : TOL_LUMPED;
    struct energy energy;

    t.model->energy(t.state, &energy);
    if (!CHECK_NEAR(energy.kinetic / want, 1, tolerance))
        printf("%s, %s\n", model, how);
    run_close(&t);
}

/* An edge that is held stays, whatever was thrown. */
static void check_held(const char *model, const char *how)
{
    static const double uvw[3] = {0, 0.5, 0.5};
    struct run t;
    OPEN(&t, model, "motion={velocity: [0.01,0,0.1], spin: [0,0.1,0]}",
         "damping={kind: none}", how);
    double before[3], after[3];

    t.model->probe(t.state, 1, uvw, before);
    advance(&t, 3);
    t.model->probe(t.state, 1, uvw, after);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(after[i], before[i], TOL_FLIGHT);
    run_close(&t);
}

static void check_turn(const char *model)
{
    static const double uvw[3] = {1, 1, 0.5};
    struct run t;
    OPEN(&t, model, SHEET, "material.young=1e8", "motion={spin: [0,10,0]}",
         "time={step: 0.00314159265358979, end: 1}", kinematics[3]);
    const double tolerance = t.model->matrices ? TOL_TURN : TOL_EULER;
    double xyz[3];

    advance(&t, 50); /* a quarter: omega x r = (0, 0, -5) m/s at first */
    t.model->probe(t.state, 1, uvw, xyz);
    bool good = CHECK_NEAR(xyz[0], 0, tolerance) && CHECK_NEAR(xyz[2], -0.5, tolerance);
    advance(&t, 50);
    t.model->probe(t.state, 1, uvw, xyz);
    good &= CHECK_NEAR(xyz[0], -0.5, tolerance) && CHECK_NEAR(xyz[1], 0.5, tolerance) &&
            CHECK_NEAR(xyz[2], 0, tolerance);
    if (!good)
        printf("%s\n", model);
    run_close(&t);
}

int main(void)
{
    REQUIRE(scene_file_find("edge_drop", (char **)&path, NULL) == STATUS_OK);
    for (int n = 0; contestant_model(n); n++) {
        const char *model = contestant_model(n)->name;
        const bool solid = !strcmp(model, "iga") || !strcmp(model, "hex");

        REQUIRE(contestant_model(n)->serves & SCENE_NEED_INITIAL_MOTION);
        for (int k = solid ? 0 : 3; k < 4; k++) {
            check_throw(model, kinematics[k]);
            check_energy(model, kinematics[k]);
            check_held(model, kinematics[k]);
        }
        check_turn(model);
    }
    free((char *)path);
    return check_result();
}

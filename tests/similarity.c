/* Similarity: trajectories do not depend on units, on a common factor of E and rho, on
 * where the sheet stands in space or on which edge is called u; round-off, carried through
 * the motion, is all that differs. similarity iga|hex
 */
#include "tests/motion_fixture.h"

/* Asked of trajectories: 1e-9 and 1e-8 of the length. Round-off after 60 frames, each of
 * them solved to eps times its condition, stays far below (measured: 3e-12). */
static const double TOL_FACTOR = 1e-9, TOL_POSE = 1e-10;

/* With control points as unknowns h = 1 cm has a condition above 1e7 (measured: 8e-10). */
static const double TOL_BASES = 1e-8;

enum { STEPS = 60 };

/* Damped, pulled sideways and along too, so that nothing vanishes by symmetry. */
#define SHEET                                                                              \
    "gravity=[1,2,-9.81]", "sheet.thickness=0.01", "material.density=2",                   \
        "drag={coefficient: 0.4, wind: [3,2,1]}"

static const char *model, *points, *kinematics, *unknowns;
static run_field here, there;

static void read_run(struct run *run, const char *damping)
{
    run_read(run, model, "edge_drop",
             RUN_SETTINGS(SHEET, points, kinematics, unknowns, damping));
}

static void finish(struct run *run, run_field field)
{
    run_start(run);
    run_steps(run, STEPS);
    run_sample(run, field);
}

static void check_factor(const char *damping)
{
    struct run one, seven;

    read_run(&one, damping);
    read_run(&seven, damping);
    seven.scene.young *= 7;
    seven.scene.density *= 7;
    seven.scene.drag *= 7;
    finish(&one, here);
    finish(&seven, there);
    CHECK(metric_drop(&one.scene, here[0]) > 0.01);
    CHECK_NEAR(run_distance(here, there), 0, TOL_FACTOR);
    run_close(&one);
    run_close(&seven);
}

/* u and v change names: the same sheet held along the same edge, seen from below. */
static void check_names(const char *damping)
{
    struct run one, two;
    const struct scene_support edge_v = {.hi = {1, 0, 1}, .fix = FIX_XYZ};

    read_run(&one, damping);
    read_run(&two, damping);
    one.scene.width = 0.6;
    two.scene.length = 0.6, two.scene.width = 1;
    two.scene.supports[0].lo[0] = two.scene.supports[0].lo[1] = 0;
    two.scene.supports[0].hi[0] = edge_v.hi[0], two.scene.supports[0].hi[1] = edge_v.hi[1];
    const double u[3] = {0, 1, 0}, v[3] = {1, 0, 0};
    memcpy(two.scene.axis_u, u, sizeof u);
    memcpy(two.scene.axis_v, v, sizeof v);
    int points_u = two.d.points[0];
    two.d.points[0] = two.d.points[1], two.d.points[1] = points_u;
    finish(&one, here);
    finish(&two, there);
    double worst = 0;
    for (int k = 0; k < GRID_W; k++)
        for (int j = 0; j < GRID_V; j++)
            for (int i = 0; i < GRID_U; i++)
                for (int t = 0; t < 3; t++)
                    worst =
                        fmax(worst, fabs(here[(k * GRID_V + j) * GRID_U + i][t] -
                                         there[((1 - k) * GRID_V + i) * GRID_U + j][t]));
    CHECK_NEAR(worst, 0, TOL_POSE);
    run_close(&one);
    run_close(&two);
}

/* Control points or mid-surface and difference: two bases of one space. */
static void check_bases(const char *damping)
{
    struct run run;

    unknowns = "discretization.unknowns=points";
    read_run(&run, damping);
    finish(&run, here);
    run_close(&run);
    unknowns = "discretization.unknowns=thickness";
    read_run(&run, damping);
    finish(&run, there);
    run_close(&run);
    CHECK_NEAR(run_distance(here, there), 0, TOL_BASES);
}

int main(int argc, char **argv)
{
    static const struct {
        const char *kinematics, *damping;
    } cases[] = {
        {"linear", "{kind: none}"},
        {"linear", "{kind: rayleigh, alpha: 0.5, beta: 0.001}"},
        {"printed", "{kind: velocity_scale, value: 0.5}"},
        {"incremental", "{kind: mass, value: 0.5}"},
        {"incremental", "{kind: velocity_rate, value: 0.5}"},
    };
    char text[64], damping[96];

    REQUIRE(argc == 2);
    model = argv[1];
    points = "discretization.points=[7,6,2]";
    for (size_t n = 0; n < sizeof cases / sizeof *cases; n++) {
        snprintf(text, sizeof text, "discretization.kinematics=%s", cases[n].kinematics);
        snprintf(damping, sizeof damping, "damping=%s", cases[n].damping);
        kinematics = text;
        unknowns = "discretization.unknowns=thickness";
        check_factor(damping);
        check_names(damping);
        check_bases(damping);
    }
    return check_result();
}

/* A sheet between two edges that turn about one line, by a quarter: at each frame the edges
 * are where the turn has them, and at the end the damped sheet lies turned, but for waves.
 * Nets take edges that are hinges; shells and solids, whose clamps turn, too, take either.
 */
#include <float.h>

#include "tests/opened_run.h"

/* Places of some metres, turned: sums of a few numbers. */
static const double TOL_HELD = 64 * DBL_EPSILON;

/* Waves that the turn leaves [m]; a sheet whose clamps do not turn bends by .3. */
static const double TOL_REST = 0.03;
enum { STEPS = 45 };

#define TURN(at)                                                                           \
    "{at: {" at "}, fix: xyz, path: [[0, 0, 0, 0], [0.2, 0, 0.1, 0]], turn: {axis: "       \
    "[0, 2, 0], about: [0.5, 0, 0.1], angles: [[0, 0], [0.2, 90]]}}"

static const char *const hinges = "supports=[" TURN("u: 0, w: 0.5") ", " TURN(
                             "u: 1, w: 0.5") "]",
                         *const clamps = "supports=[" TURN("u: 0") ", " TURN("u: 1") "]";

static const struct row {
    const char *name, *points;
} rows[] = {
    {"shell_3", "[5,4]"},
    {"shell_explicit_3", "[5,4]"},
    {"iga_selective_3", "[5,4,2]"},
    {"hex_incompatible", "[4,3,2]"},
    {"triangles", "[5,4]"},
    {"mass_spring", "[5,4]"},
    {"mass_spring_leapfrog", "[5,4]"},
    {"position_based", "[5,4]"},
    {"projective_dynamics", "[5,4]"},
    {"vbd", "[5,4]"},
};

/* Returns the largest distance of points of the mid-surface at u from where the turn
 * carries them [m]. */
static double off(const struct run *run, double t, double u)
{
    enum { COUNT = 5 };
    struct scene_placement place;
    double uvw[COUNT][3], xyz[COUNT][3], worst = 0;

    for (int n = 0; n < COUNT; n++)
        memcpy(uvw[n], (double[3]){u, n / (COUNT - 1.0), 0.5}, sizeof uvw[n]);
    run->model->probe(run->state, COUNT, uvw[0], xyz[0]);
    scene_motion_at(&run->scene.supports[0].motion, t, &place);
    for (int n = 0; n < COUNT; n++) {
        double rest[3], want[3];
        scene_rest_point(&run->scene, uvw[n], rest);
        scene_placement_point(&place, rest, want);
        for (int i = 0; i < 3; i++)
            worst = fmax(worst, fabs(xyz[n][i] - want[i]));
    }
    return worst;
}

static void check_turned(const struct row *row, const char *supports)
{
    struct run run;
    char points[64];

    snprintf(points, sizeof points, "discretization.points=%s", row->points);
    opened_read(&run, "cantilever", row->name,
                OPENED_LIST(supports, points, "gravity=[0,0,0]", "time.step=0.005",
                            "damping={kind: mass, value: 40}"));
    opened_build(&run);
    for (int n = 1; n <= STEPS; n++) {
        opened_steps(&run, 1);
        const double t = n * run.scene.step;
        SAY_UNLESS(CHECK_NEAR(off(&run, t, 0), 0, TOL_HELD) &&
                       CHECK_NEAR(off(&run, t, 1), 0, TOL_HELD),
                   "%s, frame %d", row->name, n);
    }
    SAY_UNLESS(CHECK_NEAR(off(&run, STEPS * run.scene.step, 0.5), 0, TOL_REST), "%s",
               row->name);
    run_close(&run);
}

/* Explicit steps end where energy comes from nowhere: what a soft sheet gains that its
 * clamp turns about the edge, from rest, is the clamp's work, beside the edge, too. */
static void check_work(void)
{
    struct run run;

    OPENED_RUN(&run, "edge_drop", "shell_3", "discretization.points=[6,4]",
               "discretization.integrator=leapfrog", "gravity=[0,0,0]",
               "sheet={length: 1, width: 0.6, thickness: 0.05}",
               "material={young: 2e3, poisson: 0.3, density: 4}", "damping={kind: none}",
               "supports=[{at: {u: 0}, fix: xyz, turn: {axis: [0, 1, 0], about: [0, 0, 0], "
               "angles: [[0, 0], [0.05, 10], [0.1, 40], [0.15, 75], [0.2, 90]]}}]",
               "time.step=0.0025");
    opened_steps(&run, 80);
    run_close(&run);
}

/* The first rows' models turn clamps, too. */
enum { WITH_CLAMPS = 4 };

int main(void)
{
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        check_turned(&rows[n], hinges);
        if (n < WITH_CLAMPS)
            check_turned(&rows[n], clamps);
    }
    check_work();
    return check_result();
}

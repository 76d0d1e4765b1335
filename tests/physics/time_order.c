/* Order in time of every scheme: a sheet that swings softly through a quarter turn, in
 * three steps, each half the one before. (Linear solids: march.c, against what is
 * exact.) */
#include "models/grid.h"
#include "models/metric/metric.h"
#include "tests/opened_run.h"

/* Tolerance of an order, seen between two changes of the step. */
static const double TOL_ORDER = 0.3;

enum { FRAMES = 12, EXTRA = 4 };

#define SOLID        "discretization.points=[5,4,2]"
#define NET          "discretization.points=[6,4]"
#define TO_THE_END   "discretization.iterations=2000", "discretization.tolerance=1e-13"
#define EXPLICIT     "discretization.integrator=leapfrog"
#define EULER        "discretization.integrator=implicit"
#define SINGLE       "discretization.precision=single"
#define ONCE         "discretization.substeps=1"
#define HINGES       "discretization.bending=hinge"
#define STIFF_DAMPED "damping={kind: rayleigh, alpha: 0, beta: 5e-3}"
#define TURNED                                                                             \
    "supports=[{at: {u: 0}, fix: xyz, turn: {axis: [0, 1, 0], about: [0, 0, 0], angles: "  \
    "[[-1, -900], [1, 900]]}}]",                                                           \
        "motion={spin: [0, 15.707963267948966, 0]}"
#define MESH        "discretization.mesh=irregular"
#define MEMBRANE(m) "discretization.membrane=" #m
/* clang-format off */
static const struct row {
    const char *name, *points;
    int steps; /* of the coarsest, in 0.05 s                                            */
    int order; /* 0: rounding hides it                                                  */
    bool same; /* the motion of the row before, too                                     */
    const char *settings[EXTRA];
} rows[] = {
    {"iga_nonlinear", SOLID, 40, 2, false, {0}},
    {"shell_3", NET, 10, 2, false, {"discretization.viscosity=none"}},
    {"shell_3", NET, 10, 2, true, {0}},
    {"shell_3", NET, 80, 2, false, {TURNED, "discretization.newton=full"}},
    {"shell_3", NET, 40, 2, false, {TURNED, EXPLICIT}},
    {"iga_explicit_3", SOLID, 40, 2, false, {0}},
    {"hex_explicit", SOLID, 40, 2, false, {0}},
    {"shell_explicit_3", NET, 40, 2, false, {0}},
    {"triangles", NET, 40, 2, false, {0}},
    {"triangles", NET, 40, 2, true, {EXPLICIT}},
    {"triangles", NET, 40, 0, true, {EXPLICIT, SINGLE}},
    {"triangles", NET, 40, 1, false, {EULER, HINGES}},
    {"triangles", NET, 40, 2, true, {HINGES}},
    {"triangles", NET, 40, 2, true, {EXPLICIT, HINGES}},
    {"triangles", NET, 40, 2, false, {MEMBRANE(corotational)}},
    {"triangles", NET, 40, 2, true, {EXPLICIT, MEMBRANE(corotational)}},
    {"triangles", NET, 40, 0, true, {EXPLICIT, MEMBRANE(corotational), SINGLE}},
    {"triangles", NET, 40, 2, false, {EXPLICIT, MEMBRANE(corotational), HINGES}},
    {"triangles_baraff_witkin", NET, 40, 1, false, {"discretization.bending=quadratic"}},
    {"triangles", NET, 40, 2, true, {MEMBRANE(baraff_witkin)}},
    {"triangles", NET, 40, 2, true, {EXPLICIT, MEMBRANE(baraff_witkin)}},
    {"mass_spring", NET, 10, 1, false, {"discretization.tolerance=1e-9"}},
    {"mass_spring", NET, 10, 1, false, {STIFF_DAMPED, "discretization.tolerance=1e-9"}},
    {"mass_spring_explicit", NET, 40, 2, false, {0}},
    {"mass_spring_explicit", NET, 40, 1, false, {STIFF_DAMPED}},
    {"mass_spring_momentum", NET, 40, 2, false, {0}},
    {"mass_spring_leapfrog", NET, 40, 2, true, {0}},
    {"mass_spring_single", NET, 40, 0, true, {0}},
    {"position_based", NET, 20, 1, false, {ONCE}},
    {"position_based_single", NET, 20, 0, true, {ONCE}},
    {"position_based_pbd", NET, 20, 0, true, {ONCE, "discretization.iterations=1"}},
    {"position_based_pbd", NET, 20, 0, true, {ONCE, "discretization.iterations=8"}},
    {"vbd", NET, 40, 1, false, {ONCE, "discretization.iterations=300"}},
    {"mass_spring_momentum", NET, 40, 2, false, {MESH}},
    {"mass_spring", NET, 40, 1, true, {MESH, "discretization.tolerance=1e-9"}},
    {"projective_dynamics", NET, 40, 1, true,
     {MESH, TO_THE_END, "discretization.constraint=edges"}},
    {"mass_spring_leapfrog", NET, 40, 2, false, {MESH}}, /* slopes have a mass */
    {"mass_spring_explicit", NET, 40, 2, true, {MESH}},
    {"position_based", NET, 40, 1, true, {MESH, ONCE}},
    {"position_based_single", NET, 40, 0, true, {MESH, ONCE}},
    {"vbd", NET, 40, 1, false, {MESH, ONCE, "discretization.iterations=300"}},
    {"projective_dynamics", NET, 40, 1, false, {TO_THE_END}},
    {"projective_dynamics", NET, 40, 2, false, {TO_THE_END, "discretization.integrator=bdf2"}},
    {"projective_dynamics", NET, 40, 1, false, {MESH, TO_THE_END}},
    {"projective_dynamics", NET, 40, 2, false,
     {MESH, TO_THE_END, "discretization.integrator=bdf2"}},
};
/* clang-format on */
/* Explicit steps know the same forces as implicit ones, each law: of 0.5 m, 0.1 mm is what
 * steps of first order leave, single precision and those of second order far less. */
static const double SAME = 2e-4;

static double field[4][3 * GRID_POINTS]; /* by three steps; of the row before        */

static void swing(const struct row *row, int steps, double *xyz)
{
    char step[64];
    struct run run;

    snprintf(step, sizeof step, "time.step=%.17g", 0.05 / steps);
    OPENED_RUN(&run, "edge_drop", row->name,
               "sheet={length: 1, width: 0.6, thickness: 0.05}",
               "material={young: 2e3, poisson: 0.3, density: 4}", "gravity=[0.5,0,-3]",
               "damping={kind: none}", step, row->points, row->settings[0],
               row->settings[1], row->settings[2], row->settings[3]);
    opened_steps(&run, FRAMES * steps);
    model_sample(run.model, run.state, xyz);
    run_close(&run);
}

/* Implicit springs take the matrix of their stiffness damping where a step begins, so that
 * the step is the minimum of a potential, and first order as Euler's method is itself:
 * where steps go to nothing, they go as explicit ones do, which take the same matrix. */
static void check_damped_springs(void)
{
    const double EXTRAPOLATED = 2e-5; /* a tenth of what one run is off                 */
    static const struct row euler[] = {
        {"mass_spring", NET, 40, 1, false, {STIFF_DAMPED, "discretization.tolerance=1e-9"}},
        {"mass_spring_explicit", NET, 40, 1, false, {STIFF_DAMPED}}};

    for (int n = 0; n < 2; n++) {
        swing(&euler[n], 160, field[2]);
        swing(&euler[n], 320, field[n]);
        for (int t = 0; t < 3 * GRID_POINTS; t++)
            field[n][t] += field[n][t] - field[2][t];
    }
    CHECK_NEAR(metric_rmse(field[0], field[1]), 0, EXTRAPOLATED);
}

int main(void)
{
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        for (int k = 0; k < 3; k++)
            swing(&rows[n], rows[n].steps << k, field[k]);
        const double coarse = metric_rmse(field[0], field[1]),
                     fine = metric_rmse(field[1], field[2]);
        const double off = metric_rmse(field[2], field[3]);
        printf("%s, %s: order %.2f, difference %.2e, %.2e\n", rows[n].name,
               rows[n].settings[0] ? rows[n].settings[0] : "", log2(coarse / fine), fine,
               off);
        if (rows[n].order)
            CHECK_NEAR(log2(coarse / fine), rows[n].order, TOL_ORDER);
        CHECK(!rows[n].same || off < SAME);
        memcpy(field[3], field[2], sizeof field[3]);
    }
    check_damped_springs();
    return check_result();
}

/* `printed` kinematics is no elastic sheet: its angle beside undamped `incremental`, and
 * that it keeps no stress. (How it falls: fall.c; how it dies: commands/run.cases.) */
#include "models/metric/metric.h"
#include "tests/opened_run.h"

static const char printed[] = "discretization.kinematics=printed",
                  incremental[] = "discretization.kinematics=incremental",
                  thin[] = "sheet.thickness=0.001";
static double field[GRID_POINTS][3];

static double angle_at(const char *kinematics, const char *damping, double t)
{
    struct run run;

    OPENED_RUN(&run, "edge_drop", "iga_paper", thin, kinematics, damping);
    opened_steps(&run, (int)lround(t / run.scene.step));
    model_sample(run.model, run.state, field[0]);
    double angle = metric_angle(&run.scene, field[0]);
    run_close(&run);
    return angle;
}

/* mu = 1/3 makes the effective gravity g: 59.0 and 59.2 degrees in an independent prototype
 * (DESIGN.md section 5). */
static void check_angles(void)
{
    const double TOL_ANGLE = 1, TOL_PROTOTYPE = 0.1; /* degrees; its last digit */
    double viscous =
        angle_at(printed, "damping={kind: velocity_scale, value: 0.33333333333}", 0.4);
    double undamped = angle_at(incremental, "damping={kind: none}", 0.4);

    CHECK_NEAR(viscous, undamped, TOL_ANGLE);
    CHECK_NEAR(viscous, 59.0, TOL_PROTOTYPE);
    CHECK_NEAR(undamped, 59.2, TOL_PROTOTYPE);
}

/* Kinematics that rebuild keep no stress: from static equilibrium the sheet sets off at
 * rest, by about a free fall's first step, g dt^2 / 4 (1.07 times that near the clamp). */
static void check_from_equilibrium(const char *kinematics)
{
    struct run run;
    static double after[GRID_POINTS][3];
    double step = 0;

    OPENED_RUN(&run, "cantilever", "iga_paper", kinematics, "sheet.thickness=0.05",
               "material.density=5");
    opened_settle(&run);
    model_sample(run.model, run.state, field[0]);
    CHECK(metric_drop(&run.scene, field[0]) > 0.1);
    opened_steps(&run, 1);
    model_sample(run.model, run.state, after[0]);
    step = opened_apart(field[0], after[0]);
    CHECK(step > 0 && step < 2 * 9.81 * run.scene.step * run.scene.step / 4);
    run_close(&run);
}

int main(void)
{
    check_from_equilibrium(printed);
    check_from_equilibrium(incremental);
    check_angles();
    return check_result();
}

/* What `printed` kinematics is: not an elastic sheet. Its angle beside undamped
 * `incremental`, its effective gravity, and the damping that is no rate. (claims.c,
 * run_file.c: its fall by `incremental`, its death in row 7 of the paper's Table 4.)
 */
#include "tests/motion_fixture.h"

static const char printed[] = "discretization.kinematics=printed",
                  incremental[] = "discretization.kinematics=incremental",
                  linear[] = "discretization.kinematics=linear",
                  thin[] = "sheet.thickness=0.001";
static run_field field;

static double angle_at(const char *kinematics, const char *damping, double t)
{
    struct run run;

    run_open(&run, "iga", "edge_drop", RUN_SETTINGS(thin, kinematics, damping));
    run_until(&run, t);
    run_sample(&run, field);
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

/* Height of a free sheet after each of `steps` frames into z[steps + 1]. */
static void fall(const char *kinematics, double mu, double dt, int steps, double *z)
{
    struct run run;
    char damping[64], step[64];

    snprintf(damping, sizeof damping, "damping={kind: velocity_scale, value: %.17g}", mu);
    snprintf(step, sizeof step, "time.step=%.17g", dt);
    run_open(&run, "iga", "drag_fall",
             RUN_SETTINGS(kinematics, damping, step, "drag.coefficient=0",
                          "discretization.points=[4,4,2]"));
    z[0] = 0;
    for (int n = 1; n <= steps; n++) {
        double uvw[3] = {0.3, 0.4, 0.5}, xyz[3];
        run_steps(&run, 1);
        run.model->probe(run.state, 1, uvw, xyz);
        z[n] = xyz[2];
    }
    run_close(&run);
}

/* After step n the velocity is V + mu^(n-1) (V/2 (1 - mu) - V), V = mu g dt / (1 - mu); the
 * increments of z grow by dt v_n + g dt^2/2, in the end by g (1 + mu) / (2 (1 - mu)) dt^2.
 */
static void check_effective_gravity(void)
{
    enum { STEPS = 120 };
    static const double factor[] = {0, 1.0 / 3, 0.5, 0.9};
    const double dt = 0.005, g = -9.81;
    double z[STEPS + 1];

    for (int k = 0; k < 4; k++) {
        double mu = factor[k], end = mu * g * dt / (1 - mu);
        fall(printed, mu, dt, STEPS, z);
        /* Three sums of positions up to z. */
        const double TOL_SECOND = 64 * DBL_EPSILON * (1 + fabs(z[STEPS]));
        for (int n = 1; n < STEPS; n++) {
            double v = end + pow(mu, n - 1) * (mu * g * dt / 2 - end);
            CHECK_NEAR(z[n + 1] - 2 * z[n] + z[n - 1], dt * v + g * dt * dt / 2,
                       TOL_SECOND);
        }
        double effective = g * (1 + mu) / (2 * (1 - mu)), left = pow(mu, STEPS - 2);
        const double TOL_EFFECTIVE = fabs(g / (1 - mu)) * left + TOL_SECOND / (dt * dt);
        CHECK_NEAR((z[STEPS] - 2 * z[STEPS - 1] + z[STEPS - 2]) / (dt * dt), effective,
                   TOL_EFFECTIVE);
    }
}

/* Tip's height of a thick linear cantilever at 0.5 s, its first swing. */
static double tip(const char *damping, int steps)
{
    struct run run;
    char step[64];
    double uvw[3] = {1, 0.5, 0.5}, xyz[3];

    snprintf(step, sizeof step, "time.step=%.17g", 0.5 / steps);
    run_open(&run, "iga", "cantilever_transient",
             RUN_SETTINGS(linear, damping, step, "discretization.points=[6,4,2]",
                          "sheet.thickness=0.05", "material.density=10"));
    run_steps(&run, steps);
    run.model->probe(run.state, 1, uvw, xyz);
    run_close(&run);
    return xyz[2];
}

/* Halving dt: damping by a rate converges, to first order if applied after the step, and to
 * the motion of mass damping (whose order 2 is newmark.c's); by a factor it does not. */
static void check_rates(void)
{
    /* Gravity's jump also shakes modes that 100 steps do not follow: 5e-4 of the motion. */
    const double TOL_SHAKEN = 1e-3, TOL_ORDER = 0.05;
    const char rate[] = "damping={kind: velocity_rate, value: 3}",
               mass[] = "damping={kind: mass, value: 3}",
               factor[] = "damping={kind: velocity_scale, value: 0.98}";
    double r[3], m[3], f[3];

    for (int k = 0; k < 3; k++) {
        r[k] = tip(rate, 100 << k);
        m[k] = tip(mass, 100 << k);
        f[k] = tip(factor, 100 << k);
    }
    for (int k = 0; k < 2; k++)
        CHECK_NEAR(log2((r[k] - m[k]) / (r[k + 1] - m[k + 1])), 1, TOL_ORDER);
    CHECK_RELATIVE(m[0], m[1], TOL_SHAKEN);
    CHECK_RELATIVE(m[1], m[2], TOL_SHAKEN);
    CHECK_RELATIVE(2 * r[2] - r[1], m[2], TOL_SHAKEN);
    CHECK(fabs(f[1] / f[0] - 1) > 0.1 && fabs(f[2] / f[1] - 1) > 0.1);
}

/* Kinematics that rebuild keep no stress: from static equilibrium the sheet sets off at
 * rest, by about a free fall's first step, g dt^2 / 4 (1.07 times that near the clamp). */
static void check_from_equilibrium(const char *kinematics)
{
    struct run run;
    struct message why;
    static run_field after;
    double step = 0;

    run_open(&run, "iga", "cantilever",
             RUN_SETTINGS(kinematics, "sheet.thickness=0.05", "material.density=5"));
    REQUIRE(run.model->equilibrium(run.state, &run.counters, &why) == STATUS_OK);
    run_sample(&run, field);
    CHECK(metric_drop(&run.scene, field[0]) > 0.1);
    run_steps(&run, 1);
    run_sample(&run, after);
    step = run_distance(field, after);
    CHECK(step > 0 && step < 2 * 9.81 * run.scene.step * run.scene.step / 4);
    run_close(&run);
}

int main(void)
{
    check_from_equilibrium(printed);
    check_from_equilibrium(incremental);
    check_angles();
    check_effective_gravity();
    check_rates();
    return check_result();
}

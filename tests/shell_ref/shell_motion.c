/* The shell's supports: which control points are held; damping of small motions, linear and
 * nonlinear alike; a sheet that has no stiffness where its search for rest begins. */
#include "tests/opened_run.h"

/* Slopes of 1e-4 differ by their square between the kinematics, which then are one rule;
 * measured 2e-9. */
static const double SMALL_SWING = 1e-7;
/* Newton's tolerance, and the square of a strain of 1.5e-5. */
static const double HANGING = 1e-7;

/* Counts the held ones of the 300 unknowns of 10 x 10 points, eight spans a side. */
static void check_held(void)
{
    static const struct {
        const char *supports;
        long held;
    } rows[] = {
        {"[{at: {u: 0}, fix: xyz}]", 50}, /* clamped: a row, and two components beside */
        {"[{at: {u: 1}, fix: xyz}]", 50},
        {"[{at: {v: 0}, fix: xyz}]", 50},
        {"[{at: {v: 1}, fix: xyz}]", 50},
        {"[{at: {u: 0, w: 0.5}, fix: xyz}]", 30}, /* a hinge: one */
        {"[{at: {u: 1, w: 0.5}, fix: xyz}]", 30},
        {"[{at: {v: 0, w: 0.5}, fix: xyz}]", 30},
        {"[{at: {v: 1, w: 0.5}, fix: xyz}]", 30},
        {"[{at: {u: 0}, fix: yz}]", 20},
        {"[{at: {u: 1}, fix: yz}]", 20},
        {"[{at: {v: 0}, fix: yz}]", 20},
        {"[{at: {v: 1}, fix: yz}]", 20},
        {"[{at: {u: 0, v: 1}, fix: xyz}]", 3},                 /* a corner: one point */
        {"[{at: {u: 1, v: [0,0.5]}, fix: xyz}]", 6 * (3 + 2)}, /* half: four spans */
    };

    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        struct model_size size;
        struct run run;
        char supports[128];

        snprintf(supports, sizeof supports, "supports=%s", rows[n].supports);
        OPENED_RUN(&run, "cantilever", "shell_2", "discretization.points=[10,10]",
                   supports);
        run.model->size(run.state, &size);
        if (!CHECK(size.unknowns == 300 - rows[n].held))
            printf("%s: %ld unknowns\n", rows[n].supports, size.unknowns);
        run_close(&run);
    }
}

/* Returns the height of a cantilever's tip after 40 steps under a load so small that slopes
 * are 1e-3. */
static double small_tip(const char *name, const char *damping)
{
    struct run run;
    double xyz[3];

    OPENED_RUN(&run, "cantilever", name, "discretization.points=[11,5]", "sheet.width=0.2",
               "sheet.thickness=0.02", "material={young: 1e6, poisson: 0.3, density: 100}",
               "gravity=[0,0,-0.0025]", damping);
    opened_steps(&run, 40);
    run.model->probe(run.state, 1, (const double[]){1, 0.5, 0.5}, xyz);
    run_close(&run);
    return xyz[2];
}

static void check_damping(void)
{
    static const char *const damping[] = {"damping={kind: none}",
                                          "damping={kind: mass, value: 3}",
                                          "damping={kind: rayleigh, alpha: 1, beta: 0.02}",
                                          "damping={kind: velocity_scale, value: 0.9}",
                                          "damping={kind: velocity_rate, value: 5}"};
    double last = 0;

    for (size_t n = 0; n < sizeof damping / sizeof *damping; n++) {
        const double linear = small_tip("shell_linear_3", damping[n]);
        CHECK(linear < -1e-5 && fabs(linear - last) > 1e-3 * fabs(linear)); /* it matters */
        CHECK_RELATIVE(small_tip("shell_3", damping[n]), linear, SMALL_SWING);
        last = linear;
    }
}

/* A strip hinged at u = 0, flat at rest, has no stiffness against falling: it ends up
 * hanging, longer by rho g L^2 / 2 E. */
static void check_hanging(void)
{
    struct run run;
    double xyz[3];

    OPENED_RUN(&run, "cantilever", "shell_2", "discretization.points=[10,4]",
               "sheet.width=0.3", "material.density=0.3",
               "supports=[{at: {u: 0, w: 0.5}, fix: xyz}]");
    opened_settle(&run);
    run.model->probe(run.state, 1, (const double[]){1, 0.5, 0.5}, xyz);
    CHECK_NEAR(xyz[0], 0, HANGING);
    CHECK_NEAR(xyz[2], -1 - run.scene.density * 9.81 / (2 * run.scene.young), HANGING);
    run_close(&run);
}

int main(void)
{
    check_held();
    check_damping();
    check_hanging();
    return check_result();
}

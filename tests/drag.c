/* Body drag on a free sheet, which falls and drifts without deforming: the discrete motion
 * in closed form, order 2 towards the exponential, terminal velocity rho g / c + wind. drag
 * iga|hex
 */
#include "tests/motion_fixture.h"

/* Kinematics that add increments up: a few eps of up to 4 m for each of 400 steps. */
static const double TOL_INCREMENTS = 2e-11;

/* `linear` solves for all of d, to eps times the condition of M + dt^2/4 K, 2e7. */
static const double TOL_LINEAR = 4e-9;

static const char wind[] = "drag={coefficient: 2.5, wind: [1.5, -0.7, 0.4]}";
static const char *model, *points;

static run_field field;

/* Largest deviation from rest + shift over the grid. */
static double deviation(const struct run *run, const double shift[3])
{
    double worst = 0;

    run_sample(run, field);
    for (int p = 0; p < GRID_POINTS; p++) {
        double uvw[3], rest[3];
        grid_point(p, uvw);
        scene_rest_point(&run->scene, uvw, rest);
        for (int i = 0; i < 3; i++)
            worst = fmax(worst, fabs(field[p][i] - rest[i] - shift[i]));
    }
    return worst;
}

/* Terminal velocity: weight and wind over drag and mass damping alpha [1/s] in all. */
static double terminal(const struct scene *s, double alpha, int i)
{
    return (s->density * s->gravity[i] + s->drag * s->wind[i]) / (s->density * alpha);
}

/* Average acceleration from rest: v_n = V (1 - z^n), z = (1 - alpha dt/2) / (1 + alpha
 * dt/2); sums of (v_k + v_{k+1}) dt/2 give x_n = V (n dt - (1 - z^n) / alpha). */
static void check_linear(const char *damping, double own)
{
    struct run run;

    run_open(&run, model, "drag_fall",
             RUN_SETTINGS("discretization.kinematics=linear", points, damping, wind));
    double alpha = run.scene.drag / run.scene.density + own, dt = run.scene.step;
    double z = (1 - alpha * dt / 2) / (1 + alpha * dt / 2), shift[3];
    for (int n = 0; n < 400; n += 40) {
        run_steps(&run, 40);
        for (int i = 0; i < 3; i++)
            shift[i] = terminal(&run.scene, alpha, i) *
                       ((n + 40) * dt - (1 - pow(z, n + 40)) / alpha);
        CHECK_NEAR(deviation(&run, shift), 0, TOL_LINEAR);
    }
    run_close(&run);
}

/* The exact motion, V (t - (1 - exp(-alpha t)) / alpha), is met to second order. */
static void check_order(void)
{
    /* The next term of the error is (alpha dt)^2 / 20 of the first: 3e-3 at dt = 0.05. */
    const double TOL_ORDER = 0.01, T = 0.8, alpha = 5;
    double e[3];

    for (int k = 0; k < 3; k++) {
        struct run run;
        char step[64];
        double want[3];
        snprintf(step, sizeof step, "time.step=%.17g", 0.05 / (1 << k));
        run_open(&run, model, "drag_fall",
                 RUN_SETTINGS("discretization.kinematics=linear", points, wind, step));
        run_until(&run, T);
        for (int i = 0; i < 3; i++)
            want[i] = terminal(&run.scene, alpha, i) * (T - (1 - exp(-alpha * T)) / alpha);
        e[k] = deviation(&run, want);
        run_close(&run);
    }
    for (int k = 0; k < 2; k++)
        CHECK_NEAR(log2(e[k] / e[k + 1]), 2, TOL_ORDER);
}

/* The kinematics that rebuild start with a = 0. `incremental`: drag on v. */
static void check_incremental(void)
{
    struct run run;
    double x[3] = {0}, v[3] = {0}, a[3] = {0};

    run_open(&run, model, "drag_fall",
             RUN_SETTINGS("discretization.kinematics=incremental", points, wind));
    double alpha = run.scene.drag / run.scene.density, dt = run.scene.step;
    for (int n = 1; n <= 400; n++) {
        run_steps(&run, 1);
        for (int i = 0; i < 3; i++) {
            double force = alpha * terminal(&run.scene, alpha, i);
            double next = (force - alpha * (v[i] + dt / 2 * a[i])) / (1 + alpha * dt / 2);
            x[i] += dt * v[i] + dt * dt / 4 * (a[i] + next);
            v[i] += dt / 2 * (a[i] + next);
            a[i] = next;
        }
        if (n % 40 == 0)
            CHECK_NEAR(deviation(&run, x), 0, TOL_INCREMENTS);
    }
    /* exp(-alpha t) of the way is left. */
    const double TOL_TERMINAL = 2 * exp(-alpha * 400 * dt);
    for (int i = 0; i < 3; i++)
        CHECK_RELATIVE(v[i], terminal(&run.scene, alpha, i), TOL_TERMINAL);
    run_close(&run);
}

/* `printed`: d / dt is the velocity, and the drag on it ends at the same terminal velocity,
 * whatever the factor on v. */
static void check_printed(void)
{
    struct run run;
    double x[3] = {0}, d[3] = {0}, v[3] = {0}, a[3] = {0};

    run_open(&run, model, "drag_fall",
             RUN_SETTINGS("discretization.kinematics=printed", points, wind,
                          "damping={kind: velocity_scale, value: 0.5}"));
    double alpha = run.scene.drag / run.scene.density, dt = run.scene.step;
    for (int n = 1; n <= 400; n++) {
        run_steps(&run, 1);
        for (int i = 0; i < 3; i++) {
            double force = alpha * terminal(&run.scene, alpha, i), c = dt * dt / 4;
            double p = d[i] + dt * v[i] + c * a[i];
            double next = (force - alpha / dt * p) / (1 + alpha / dt * c);
            d[i] = p + c * next;
            v[i] = 0.5 * (v[i] + dt / 2 * (a[i] + next));
            a[i] = next;
            x[i] += d[i];
        }
        if (n % 40 == 0)
            CHECK_NEAR(deviation(&run, x), 0, TOL_INCREMENTS);
    }
    const double TOL_TERMINAL = 2 * exp(-alpha * 400 * dt);
    for (int i = 0; i < 3; i++)
        CHECK_RELATIVE(d[i] / dt, terminal(&run.scene, alpha, i), TOL_TERMINAL);
    run_close(&run);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    model = argv[1];
    points = "discretization.points=[5,4,2]";
    check_linear("damping={kind: none}", 0);
    check_linear("damping={kind: mass, value: 3}", 3);
    check_linear("damping={kind: rayleigh, alpha: 3, beta: 0.1}", 3);
    check_order();
    check_incremental();
    check_printed();
    return check_result();
}

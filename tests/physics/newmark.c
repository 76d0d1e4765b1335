/* The time integration of the linear solids against closed forms: every mode of a small
 * cantilever follows the scheme's own frequency and decay, which is the trapezoidal rule's
 * and so of second order and reversible.
 *   newmark iga|hex
 */
#include <complex.h>

#include "tests/motion_fixture.h"

/* 120 (iga), 192 (hex) unknowns, thick, so that the spectrum is not too wide for a check
 * of every mode. */
#define SHEET                                                                              \
    "material={young: 1.0e5, poisson: 0.3, density: 10}", "sheet.thickness=0.05",          \
        "sheet.width=0.7"

static const char *model, *points;

static void open_run(struct run *run, const char *damping, const char *gravity, double step)
{
    char text[3][64];

    snprintf(text[0], sizeof text[0], "damping=%s", damping);
    snprintf(text[1], sizeof text[1], "gravity=%s", gravity);
    snprintf(text[2], sizeof text[2], "time.step=%.17g", step);
    OPENED_RUN(run, "cantilever", model, SHEET, points, text[0], text[1], text[2]);
}

/* Round-off: lambda_i carries eps lambda_max, which shifts the phase of mode i by
 * sqrt(lambda_i) dt eps lambda_max / (2 lambda_i) each step; each solve adds as much, and
 * sums over `count` unknowns cost a few eps more (measured: a twentieth of this). */
static double phase_tolerance(const struct modes *m, int i, int steps, double dt)
{
    double worst = m->lambda[m->count - 1], omega = sqrt(m->lambda[i]);

    return 64 * DBL_EPSILON *
           (steps * omega * dt * worst / m->lambda[i] + steps + m->count);
}

/* Exact solution of the trapezoidal rule for q'' + c q' + lambda q = 0, q = 1 and q' = 0 at
 * the start, after n steps: roots s of s^2 + c s + lambda are mapped to
 * z = (1 + s dt/2) / (1 - s dt/2). Undamped z = exp(i theta), theta = 2 atan(w dt / 2). */
static double trapezoidal(double c, double lambda, double dt, int n)
{
    double complex root = csqrt(c * c / 4 - lambda), s1 = -c / 2 + root, s2 = -c / 2 - root;
    double complex z1 = (1 + s1 * dt / 2) / (1 - s1 * dt / 2);
    double complex z2 = (1 + s2 * dt / 2) / (1 - s2 * dt / 2);

    return creal((s2 * cpow(z1, n) - s1 * cpow(z2, n)) / (s2 - s1));
}

/* All modes at once, each with amplitude 1. The step gives the lowest mode 50 steps a turn
 * and leaves the highest far beyond what the step resolves. */
static void check_modes(const char *damping, double alpha, double beta, int steps)
{
    struct run run;
    struct modes m;

    open_run(&run, damping, "[0,0,0]", 0.01);
    modes_init(&m, &run);
    double *q = malloc((size_t)m.count * sizeof *q), dt = run.scene.step;
    for (int i = 0; i < m.count; i++)
        q[i] = 1;
    modes_combine(&m, q, run_solid(&run)->march.d);
    CHECK(sqrt(m.lambda[0]) * dt < 0.2 && sqrt(m.lambda[m.count - 1]) * dt > 5);
    for (int done = 0; done < steps;) {
        int more = done < 10 ? 1 : steps / 10;
        opened_steps(&run, more);
        done += more;
        modes_project(&m, &run, run_solid(&run)->march.d, q);
        for (int i = 0; i < m.count; i++) {
            double want = trapezoidal(alpha + beta * m.lambda[i], m.lambda[i], dt, done);
            double theta = 2 * atan(sqrt(m.lambda[i]) * dt / 2);
            double TOL_PHASE = phase_tolerance(&m, i, done, dt);
            CHECK_NEAR(q[i], want, TOL_PHASE);
            if (alpha == 0 && beta == 0)
                CHECK_NEAR(q[i], cos(done * theta), TOL_PHASE);
        }
    }
    free(q);
    modes_clear(&m);
    run_close(&run);
}

/* velocity_scale and velocity_rate: v <- f v after each step, the acceleration stays. Mode
 * by mode that is a recurrence of three numbers, here in the paper's form (eq. 18-19). */
static void check_velocity_damping(const char *damping, double dt, double factor)
{
    enum { STEPS = 400 };
    struct run run;
    struct modes m;

    open_run(&run, damping, "[0,0,-9.81]", dt);
    modes_init(&m, &run);
    double *q = malloc((size_t)m.count * sizeof *q),
           *load = malloc((size_t)m.count * sizeof *q);
    modes_load(&m, &run, load);
    opened_steps(&run, STEPS);
    modes_project(&m, &run, run_solid(&run)->march.d, q);
    for (int i = 0; i < m.count; i++) {
        double d = 0, v = 0, a = load[i], c = dt * dt / 4;
        for (int n = 0; n < STEPS; n++) {
            double next =
                (load[i] - m.lambda[i] * (d + dt * v + c * a)) / (1 + m.lambda[i] * c);
            d += dt * v + c * (a + next);
            v = factor * (v + dt / 2 * (a + next));
            a = next;
        }
        /* Its own phase, and what the large first mode leaks into it by round-off: a step's
         * solve leaves some hundred ulp (121 measured without fused multiply-adds). */
        double TOL_RECURRENCE =
            phase_tolerance(&m, i, STEPS, dt) * fabs(load[i]) / m.lambda[i] +
            256 * DBL_EPSILON * STEPS * fabs(load[0]) / m.lambda[0];
        CHECK_NEAR(q[i], d, TOL_RECURRENCE);
    }
    free(q);
    free(load);
    modes_clear(&m);
    run_close(&run);
}

int main(int argc, char **argv)
{
    REQUIRE(argc == 2);
    model = !strcmp(argv[1], "hex") ? "hex_linear" : "iga_linear";
    points = !strcmp(argv[1], "hex") ? "discretization.points=[9,4,2]"
                                     : "discretization.points=[6,4,2]";
    check_modes("{kind: none}", 0, 0, 2000);
    check_modes("{kind: mass, value: 1.5}", 1.5, 0, 200);
    check_modes("{kind: rayleigh, alpha: 0.7, beta: 0.002}", 0.7, 0.002, 200);
    check_velocity_damping("{kind: velocity_scale, value: 0.9}", 0.01, 0.9);
    check_velocity_damping("{kind: velocity_rate, value: 3}", 0.005, 1 - 3 * 0.005);
    return check_result();
}

/* Air against a sheet: its force is the formula's, its tangent the derivative of it, a
 * sheet falls to the terminal velocity as v_T tanh(g t / v_T), slides in its plane to a
 * stop as 1 / (1 / v_0 + k t), and is carried along by a wind that a table gives; in every
 * model. */
#include "shell_ref/shell_model.h"
#include "models/vector.h"
#include "tests/derivative_fixture.h"
#include "tests/opened_run.h"
#include "tests/shell_fixture.h"

/* Sums of some thousand terms; differences with steps of 1e-6 of what has the size 1. */
static const double ROUND_OFF = 1e-12, DIFFERENCE = 1e-7;

/* A sheet of .1177 kg/m^2 that falls at .981 m/s; k = rho c_t / 2 (rho_s h). */
#define SHEET                                                                              \
    "drag.coefficient=0", "damping={kind: none}", "material.density=100",                  \
        "time={step: 0.005, end: 2}", "snapshots=[]"
static const double GRAVITY = 9.81, AREAL = 100 * 0.001177, AIR = 1.2, NORMAL = 2,
                    ALONG = 0.5;
#define DRAG "air={density: 1.2, drag: [2, 0.5]}"
#define WIND "air={density: 1.2, drag: [2, 0.5], wind: [[0, 0, 0, 0], [0.1, 0, 0, 3]]}"

static double *force_at(const struct shell *m, const struct air_motion *at)
{
    double *f = calloc(3 * (size_t)m->space.nodes, sizeof *f);

    REQUIRE(f);
    air_force(&m->march.air, 2, at, f);
    return f;
}

/* Compares d K d with a difference of the force along d; rate: of the way from x_old. */
static void check_derivative(const struct shell *m, double share, double rate)
{
    const struct blocks *graph = &m->assembly.graph;
    const size_t count = 3 * (size_t)graph->nodes;
    const double step = 1e-6;
    double(*K)[9] = calloc((size_t)graph->start[graph->nodes], sizeof *K);
    double *x_old = shell_moved(&m->space, 0.1, 3), *x = shell_moved(&m->space, 0.1, 7),
           *d = shell_moved(&m->space, 0.1, 5), *Kd = malloc(count * sizeof *Kd), *side[2],
           want = 0;
    struct air_motion at = {.x_old = x_old, .x = x, .share = share, .rate = rate};

    REQUIRE(K && Kd);
    for (size_t t = 0; t < count; t++)
        d[t] -= m->space.rest[t];
    air_tangent(&m->march.air, 2, &at, false, graph, K);
    blocks_multiply(graph, (const double(*)[9])K, d, Kd);
    for (int s = 0; s < 2; s++) {
        for (size_t t = 0; t < count; t++)
            x[t] += (s ? 2 : -1) * step * d[t];
        side[s] = force_at(m, &at);
    }
    for (size_t t = 0; t < count; t++)
        want -= d[t] * (side[1][t] - side[0][t]) / (2 * step);
    CHECK_RELATIVE(derivative_dot(count, d, Kd), want, DIFFERENCE);
    double *all[] = {x_old, x, d, Kd, K[0], side[0], side[1]};
    for (size_t n = 0; n < sizeof all / sizeof *all; n++)
        free(all[n]);
}

/* A flat sheet of 1 m^2 at rest in an oblique wind, to which the tangent is no part. */
static void check_force(void)
{
    const double w[3] = {3, -1, -2}, along = hypot(w[0], w[1]);
    struct run run = {0};

    OPENED_RUN(&run, "drag_fall", "shell", SHEET,
               "air={density: 1.2, drag: [2, 0.5], wind: [3, -1, -2]}");
    const struct shell *m = run.state;
    const struct air_motion at = {.x = m->space.rest, .share = 1};
    double *f = force_at(m, &at), sum[3] = {0};
    for (int t = 0; t < 3 * m->space.nodes; t++)
        sum[t % 3] += f[t] / 2;
    CHECK_RELATIVE(sum[0], AIR / 2 * ALONG * along * w[0], ROUND_OFF);
    CHECK_RELATIVE(sum[1], AIR / 2 * ALONG * along * w[1], ROUND_OFF);
    CHECK_RELATIVE(sum[2], AIR / 2 * NORMAL * fabs(w[2]) * w[2], ROUND_OFF);
    free(f);
    check_derivative(m, 1, 0);
    check_derivative(m, 0.5, 0);
    check_derivative(m, 0.5, 30);
    check_derivative(m, 1, 200);
    run_close(&run);
}

/* Models and choices, with the error of a fall's way in two seconds in steps of 5 ms: of
 * first order, of second order, or of explicit steps. */
static const double FIRST = 3e-3, SECOND = 1e-4, COARSE = 4;
static const struct {
    const char *model, *choice;
    double error;
    double turned; /* what is left of symmetry in iterations, relative to the speed     */
} rows[] = {
    {"mass_spring", "discretization.integrator=implicit", FIRST, 1e-9},
    {"mass_spring", "discretization.integrator=explicit", SECOND, 1e-9},
    {"mass_spring", "discretization.integrator=momentum", SECOND, 1e-9},
    {"mass_spring", "discretization.integrator=leapfrog", SECOND, 1e-9},
    {"mass_spring", "discretization.mesh=irregular", FIRST, 1e-9},
    {"triangles", NULL, SECOND, 1e-9},
    {"triangles", "discretization.integrator=implicit", FIRST, 1e-9},
    {"triangles", "discretization.integrator=leapfrog", SECOND, 1e-9},
    {"triangles", "discretization.mesh=irregular", SECOND, 1e-9},
    {"triangles", "discretization.bending=midedge", SECOND, 1e-9},
    {"position_based", NULL, FIRST, 1e-9},
    {"position_based", "discretization.mesh=irregular", FIRST, 1e-9},
    {"position_based", "discretization.precision=single", FIRST, 1e-4},
    {"vbd", NULL, FIRST, 1e-6},
    {"projective_dynamics", NULL, FIRST, 1e-6},
    {"projective_dynamics", "discretization.integrator=bdf2", SECOND, 1e-4},
    {"shell", NULL, SECOND, 1e-9},
    {"shell", "discretization.integrator=leapfrog", SECOND, 1e-9},
    {"iga", NULL, SECOND, 1e-9},
    {"iga", "discretization.unknowns=points", SECOND, 1e-9},
    {"hex", NULL, SECOND, 1e-9},
};

#define HERE(run, xyz) (run)->model->probe((run)->state, 1, (double[]){0.3, 0.6, 0.5}, xyz)

static void check_fall(size_t n)
{
    const double last = sqrt(2 * AREAL * GRAVITY / (AIR * NORMAL));
    struct run run = {0};
    double x[3], before[3], most = 0;

    OPENED_RUN(&run, "drag_fall", rows[n].model, SHEET, DRAG, rows[n].choice);
    for (int frame = 1; frame <= 400; frame++) {
        HERE(&run, before);
        opened_steps(&run, 1);
        HERE(&run, x);
        const double t = frame * run.scene.step,
                     way = last * last / GRAVITY * log(cosh(GRAVITY * t / last));
        most = fmax(most, fabs(x[2] + way));
    }
    CHECK_SAY(most < rows[n].error, "%s, %s: %g", rows[n].model, rows[n].choice, most);
    CHECK_SAY(fabs((before[2] - x[2]) / run.scene.step / last - 1) < rows[n].turned,
              "%s, %s: %g", rows[n].model, rows[n].choice,
              (before[2] - x[2]) / run.scene.step / last - 1);
    run_close(&run);
}

/* Slides in its plane, in steps of half the length: x = log(1 + k v_0 t) / k. */
static void check_slide(size_t n)
{
    const double k = AIR * ALONG / (2 * AREAL), speed = 2;
    struct run run = {0};
    double from[3], x[3];

    OPENED_RUN(&run, "drag_fall", rows[n].model, SHEET, DRAG, "gravity=[0,0,0]",
               "motion={velocity: [1.6, 1.2, 0]}", "time.step=0.0025", rows[n].choice);
    HERE(&run, from);
    opened_steps(&run, 100);
    HERE(&run, x);
    const double way = log(1 + k * speed * 100 * run.scene.step) / k;
    CHECK_SAY(fabs(hypot(x[0] - from[0], x[1] - from[1]) - way) < rows[n].error &&
                  fabs((x[0] - from[0]) * 0.6 - (x[1] - from[1]) * 0.8) < 1e-6,
              "%s, %s: %.9g of %g", rows[n].model, rows[n].choice,
              hypot(x[0] - from[0], x[1] - from[1]), way);
    run_close(&run);
}

/* A wind that rises to 3 m/s in .1 s and stays takes the sheet along: first the velocity
 * against it is sqrt(a / k) tanh(sqrt(a k) t) with a = 30 m/s^2, in steps of a tenth of the
 * time that this takes; after that it is 1 / (1 / u + k t), by the way that it makes in the
 * last half second, of which u is that at its start. */
static void check_wind(size_t n)
{
    static const int frames[] = {20, 19, 1, 98, 1};
    const double k = AIR * NORMAL / (2 * AREAL), dt = 0.005, end = 99 * dt;
    struct run run = {0};
    double z[6], xyz[3];

    OPENED_RUN(&run, "drag_fall", rows[n].model, SHEET, WIND, "gravity=[0,0,0]",
               rows[n].choice);
    HERE(&run, xyz);
    z[0] = xyz[2];
    for (int s = 0; s < 5; s++) {
        opened_steps(&run, frames[s]);
        HERE(&run, xyz);
        z[s + 1] = xyz[2];
    }
    const double rise = 0.15 - log(cosh(0.1 * sqrt(30 * k))) / k,
                 u = 3 - (z[3] - z[2]) / dt, left = 3 - (z[5] - z[4]) / dt,
                 want = 1 / (1 / u + k * end);
    CHECK_SAY(fabs(z[1] - z[0] - rise) < COARSE * rows[n].error &&
                  fabs(left - want) < rows[n].error,
              "%s, %s: rises %g of %g, %g of %g after %g", rows[n].model, rows[n].choice,
              z[1] - z[0], rise, left, want, u);
    run_close(&run);
}

/* The last velocity of a sheet with an outline and a hole. */
static void check_outline(const char *model)
{
    const double last = sqrt(2 * AREAL * GRAVITY / (AIR * NORMAL));
    struct run run = {0};
    double x[2][3];

    OPENED_RUN(&run, "drag_fall", model, SHEET, DRAG,
               "sheet={outline: [[0, 0], [1, 0], [0.7, 0.6], [0, 0.5]], holes: [[[0.2, "
               "0.2], [0.3, 0.2], [0.3, 0.3]]], thickness: 0.001177}");
    opened_steps(&run, 399);
    for (int s = 0; s < 2; s++) {
        run.model->probe(run.state, 1, (double[]){0.1, 0.1, 0.5}, x[s]);
        opened_steps(&run, 1);
    }
    CHECK_NEAR((x[0][2] - x[1][2]) / run.scene.step / last, 1, 1e-6);
    run_close(&run);
}

/* What is at rest has the same bits in still air and without. */
static void check_rest(const char *model)
{
    static double with[3 * GRID_POINTS], without[3 * GRID_POINTS];
    struct run run = {0};

    for (int s = 0; s < 2; s++) {
        OPENED_RUN(&run, "cantilever", model, "discretization.points=[7,5]",
                   s ? "air={density: 1.2, drag: [2, 0.5]}" : NULL);
        opened_settle(&run);
        model_sample(run.model, run.state, s ? with : without);
        run_close(&run);
    }
    CHECK(opened_apart(with, without) == 0);
}

/* Blows from below at a cantilever with the pressure of its weight, which then does not
 * bend: implicit steps, explicit ones and equilibrium agree on the sheet's bend at half of
 * it to what is left of the motion. */
static void check_blown(void)
{
    const char *const wind = "air={density: 1, drag: [2, 0], wind: [0, 0, 1]}",
                      *const half = "air={density: 0.5, drag: [2, 0], wind: [0, 0, 1]}";
    static double none[3 * GRID_POINTS], at_rest[3 * GRID_POINTS];
    struct run run = {0};

    for (int s = 0; s < 2; s++) {
        OPENED_RUN(&run, "cantilever", "shell", "gravity=[0,0,-1]", "material.density=100",
                   "sheet.thickness=0.01", "material.young=1e7",
                   "discretization.points=[10,4]", s ? half : wind);
        opened_settle(&run);
        model_sample(run.model, run.state, s ? at_rest : none);
        if (!s)
            CHECK_NEAR(opened_off(&run, NULL), 0, 1e-9);
        run_close(&run);
    }
    OPENED_RUN(&run, "cantilever", "shell", "gravity=[0,0,-1]", "material.density=100",
               "sheet.thickness=0.01", "material.young=1e7", "discretization.points=[10,4]",
               half, "damping={kind: mass, value: 4}", "time={step: 0.02, end: 20}",
               "snapshots=[]");
    opened_steps(&run, 1000);
    model_sample(run.model, run.state, none);
    CHECK(opened_apart(none, at_rest) < 1e-4);
    run_close(&run);
}

/* A sheet that a wind presses onto the ground. */
static void check_ground(void)
{
    struct run run = {0};
    struct model_contact c = {0};

    OPENED_RUN(&run, "ground", "shell", "pose={origin: [0, 0, 0.1]}",
               "air={density: 1.2, drag: [2, 0], wind: [0, 0, -2]}");
    opened_settle(&run);
    run.model->contact(run.state, &c);
    CHECK_RELATIVE(c.force[2], 0.7 * 0.001177 * GRAVITY + AIR / 2 * NORMAL * 4, 1e-5);
    run_close(&run);
}

int main(void)
{
    check_force();
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        check_fall(n);
        check_slide(n);
        check_wind(n);
    }
    static const char *const nets[] = {"triangles", "mass_spring", "vbd", "position_based",
                                       "projective_dynamics"};
    for (size_t n = 0; n < sizeof nets / sizeof *nets; n++)
        check_outline(nets[n]);
    check_rest("shell");
    check_rest("triangles");
    check_blown();
    check_ground();
    return check_result();
}

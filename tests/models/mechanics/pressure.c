/* Pressure on a tube: its force is the derivative of the energy, and its tangent that of
 * the force, where the edges stay in their planes; it moves no centre of mass, a ring
 * under it breathes, and a free end rests, by implicit and by explicit steps. */
#include "shell_ref/shell_model.h"
#include "models/vector.h"
#include "tests/derivative_fixture.h"
#include "tests/opened_run.h"
#include "tests/shell_fixture.h"

/* Sums of some thousand terms. */
static const double ROUND_OFF = 1e-12;
/* Strains of 5e-4, and the phase of steps of a sixtieth of a breath; energy by the square
 * of the step. */
static const double BREATH = 3e-3, DRIFT = 3e-3;

/* A ring of R = 1 m. */
#define TUBE                                                                               \
    "sheet={length: 1, width: 6.283185307179586, thickness: 0.01}", "gravity=[0,0,0]",     \
        "pose={kind: cloak, u: [0,1,0], v: [1,0,0], opening: 360}",                        \
        "material={young: 12e6, poisson: 0, density: 100}", "damping={kind: none}",        \
        "discretization.points=[4,24]", "discretization.degree=[2,2]",                     \
        "discretization.viscosity=none", "discretization.remedy=none"

/* Computes the force at (1 - share) from + share to. */
static double *force_at(const struct shell *m, double factor, const double *from,
                        double share, const double *to)
{
    double *f = calloc(3 * (size_t)m->space.nodes, sizeof *f);

    REQUIRE(f);
    pressure_force(&m->march.pressure, factor, from, share, to, f);
    return f;
}

/* Compares differences between x - d and x + d of any size: the volume is of third degree.
 * The rule of degree 2 is exact for products of three functions. `axial`: compare forces
 * along the axis, too. */
static void check_derivatives(const struct shell *m, const double *x, const double *d,
                              bool axial)
{
    const struct blocks *graph = &m->assembly.graph;
    const size_t count = 3 * (size_t)graph->nodes;
    double *end[2] = {malloc(count * sizeof *x), malloc(count * sizeof *x)};
    double *Kd = malloc(count * sizeof *Kd), work = 0, sum = 0;
    double(*K)[9] = calloc((size_t)graph->start[graph->nodes], sizeof *K);

    REQUIRE(end[0] && end[1] && Kd && K);
    for (size_t t = 0; t < count; t++)
        end[0][t] = x[t] - d[t], end[1][t] = x[t] + d[t];
    pressure_tangent(&m->march.pressure, 2, end[0], 0.5, end[1], graph, K);
    blocks_multiply(graph, (const double(*)[9])K, d, Kd);
    double *f = force_at(m, 2, NULL, 1, x), *step = force_at(m, 2, end[0], 0.5, end[1]);
    double *side[2] = {force_at(m, 1, NULL, 1, end[0]), force_at(m, 1, NULL, 1, end[1])};
    for (size_t t = 0; t < count; t++) {
        work += d[t] * (side[0][t] + 2 * f[t] + side[1][t]) / 3; /* Simpson */
        sum += t % 3 == 0 ? f[t] : 0;
        step[t] -= f[t];
        side[1][t] = axial || t % 3 != 1 ? side[1][t] - side[0][t] + 2 * Kd[t] : 0;
    }
    CHECK_RELATIVE(work, -pressure_energy(&m->march.pressure, end[0], end[1]), ROUND_OFF);
    CHECK_NEAR(sum / derivative_norm(count, f), 0, ROUND_OFF);
    CHECK_NEAR(derivative_norm(count, step) / derivative_norm(count, f), 0, ROUND_OFF);
    CHECK_NEAR(derivative_norm(count, side[1]) / derivative_norm(count, Kd), 0, ROUND_OFF);
    double *all[] = {end[0], end[1], Kd, K[0], f, step, side[0], side[1]};
    for (size_t n = 0; n < sizeof all / sizeof *all; n++)
        free(all[n]);
}

/* Moves all points of the tube across its axis, or those within it anywhere. */
static void check_tube(bool within)
{
    struct run run = {0};

    OPENED_RUN(&run, "drape", "shell", TUBE, "pressure=3", "supports=[]");
    const struct shell *m = run.state;
    const int nodes = m->space.nodes, around = bspline_points(&m->space.basis[1]);
    double *x = shell_moved(&m->space, 0.1, 3), *d = shell_moved(&m->space, 0.1, 5);
    for (int t = 0; t < 3 * nodes; t++) {
        const bool end = t / 3 < around || t / 3 >= nodes - around;
        const bool moves = within ? !end : t % 3 != 1;
        d[t] = moves ? d[t] - m->space.rest[t] : 0;
        x[t] = moves ? x[t] : m->space.rest[t];
    }
    check_derivatives(m, x, d, within);
    free(x);
    free(d);
    run_close(&run);
}

/* Lets the pressure act at once on the ring, which then breathes,
 * p R^2 / (E h) (1 - cos(sqrt(E / rho) t / R)); to the middle of its second breath. */
static void breathe(const char *integrator)
{
    const double young = 1e6, thick = 0.01, density = 100, p = 2.5, step = 1e-3;
    const double omega = sqrt(young / density), way = p / (young * thick);
    const int frames = (int)(3 * acos(-1) / omega / step);
    struct run run = {0};
    struct energy e;
    double x[2][3];

    OPENED_RUN(&run, "drape", "shell", TUBE, "pressure=2.5", "time.step=1e-3", integrator,
               "material.young=1e6", "supports=[{at: {u: [0,1]}, fix: y}]", "motion={}");
    run.model->probe(run.state, 1, (double[]){0, 0, 0.5}, x[0]);
    opened_steps(&run, frames);
    run.model->energy(run.state, &e);
    run.model->probe(run.state, 1, (double[]){0, 0, 0.5}, x[1]);
    CHECK_NEAR((vector_length(x[0]) - vector_length(x[1])) /
                   (way * (1 - cos(omega * frames * step))),
               1, BREATH);
    CHECK(e.potential < -4 * acos(-1) * way * p * (1 - BREATH) * 0.9);
    CHECK_NEAR((e.kinetic + e.elastic + e.potential) / e.potential, 0, DRIFT);
    run_close(&run);
}

/* Blows up a tube that is held at one end, damped until it stays; explicit steps do with as
 * many pieces as about rest. Returns the radius of the free end. */
static double blow_up(const char *integrator)
{
    struct run run = {0};
    double x[3];

    OPENED_RUN(&run, "drape", "shell", TUBE, "pressure=-2000", "time.step=2e-3", integrator,
               "material.young=1e6", "damping={kind: mass, value: 100}",
               "supports=[{at: {u: 0}, fix: xyz}]", "motion={}");
    const long pieces = opened_steps(&run, 1).substeps;
    CHECK(opened_steps(&run, 120).substeps == 120 * pieces);
    run.model->probe(run.state, 1, (double[]){1, 0, 0.5}, x);
    run_close(&run);
    return hypot(x[0], x[2]);
}

/* The free end does work that the pressure's potential leaves out: explicit steps count the
 * work itself. What is left of the motion, e^-12, and rows of the mass that are summed. */
static const double AT_REST = 1e-4;

static void check_free_end(void)
{
    const double implicit = blow_up("discretization.integrator=implicit"),
                 explicit = blow_up("discretization.integrator=leapfrog");

    CHECK(implicit > 1.1);
    CHECK_NEAR(explicit / implicit, 1, AT_REST);
}

int main(void)
{
    check_tube(false);
    check_tube(true);
    breathe("discretization.integrator=implicit");
    breathe("discretization.integrator=leapfrog");
    check_free_end();
    return check_result();
}

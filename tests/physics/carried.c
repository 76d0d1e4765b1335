/* Every large-displacement contestant: a damped sheet that is carried along is the still
 * one under the wind of its own motion, and the work of dead loads is energy that the sheet
 * then has. */
#include "tests/opened_run.h"

#define SHEET                                                                              \
    "material={young: 1.0e5, poisson: 0.3, density: 10}", "sheet.thickness=0.004",         \
        "time.step=0.005"

enum { STEPS = 25 };

static const struct {
    const char *name, *points;
    double energy; /* lost or gained, over the work of the loads */
} contestants[] = {
    {"iga_nonlinear", "discretization.points=[5,4,2]", 1e-3},
    {"iga_selective_3", "discretization.points=[6,5,2]", 1e-3},
    {"hex_incompatible", "discretization.points=[5,4,2]", 1e-3},
    {"shell_3", "discretization.points=[6,5]", 0.1},       /* algorithmic viscosity */
    {"triangles", "discretization.points=[6,5,1]", 0.1},   /* likewise */
    {"mass_spring", "discretization.points=[6,5,1]", 0.5}, /* implicit Euler damps */
    {"mass_spring_leapfrog", "discretization.points=[6,5,1]", 1e-3},
    {"mass_spring_momentum", "discretization.points=[6,5,1]", 0.1}, /* as triangles */
    {"projective_dynamics", "discretization.points=[6,5,1]", 0.5},
};

static double field[2][GRID_POINTS][3];

/* Mass damping resists the motion itself: held at an edge that moves at V, all of it moving
 * so from the start, the sheet feels -alpha V, as the still one does under that gravity. */
static void check_carried(const char *name, const char *points)
{
    static const double V[3] = {0.3, -0.2, 0.5};
    /* Positions of 1 m, solved in every step to 1e-6 of a cell at worst. */
    const double TOL_SOLVED = 2e-5;
    struct run still, moving;
    double off = 0, most = 0;

    OPENED_RUN(&still, "cantilever", name, SHEET, points, "damping={kind: mass, value: 8}",
               "gravity=[-2.4,1.6,-4]", "supports=[{at: {u: 0}, fix: xyz}]");
    OPENED_RUN(&moving, "cantilever", name, SHEET, points, "damping={kind: mass, value: 8}",
               "gravity=[0,0,0]", "motion={velocity: [0.3,-0.2,0.5]}",
               "supports=[{at: {u: 0}, fix: xyz, path: "
               "[[-1,-0.3,0.2,-0.5],[0,0,0,0],[1,0.3,-0.2,0.5]]}]");
    opened_steps(&still, STEPS);
    opened_steps(&moving, STEPS);
    still.model->sample(still.state, field[0][0]);
    moving.model->sample(moving.state, field[1][0]);
    for (int n = 0; n < GRID_POINTS; n++)
        for (int i = 0; i < 3; i++) {
            double t = STEPS * still.scene.step;
            off = fmax(off, fabs(field[0][n][i] + V[i] * t - field[1][n][i]));
            most = fmax(most, i == 2 ? fabs(field[0][n][i]) : 0);
        }
    if (!CHECK(off < TOL_SOLVED && most > 0.01))
        printf("  %s, carried: off by %g m, moved %g m\n", name, off, most);
    run_close(&still);
    run_close(&moving);
}

/* A load on the free end, nothing else: what it has worked is kinetic and elastic. */
static void check_work(const char *name, const char *points, double tolerance)
{
    struct run run;
    struct energy e;
    double work = 0;

    OPENED_RUN(&run, "cantilever", name, SHEET, points, "damping={kind: none}",
               "gravity=[0,0,0]", "loads=[{at: {u: 1}, force: [0, 0, 0.05]}]");
    CHECK(opened_steps(&run, STEPS).viscous == 0);
    run.model->sample(run.state, field[0][0]);
    for (int j = 0; j < GRID_V; j++) /* of the end u = 1, by the trapezoidal rule */
        for (int k = 0; k < 2; k++) {
            const int point = (k * GRID_V + j) * GRID_U + GRID_U - 1;
            work +=
                0.05 * field[0][point][2] * (j % (GRID_V - 1) ? 1 : 0.5) / (GRID_V - 1) / 2;
        }
    run.model->energy(run.state, &e);
    /* The mean over the end is that of the nodes but for the rule's curvature. */
    const double TOL_MEAN = 2e-2;
    if (!CHECK(work > 1e-4) || !CHECK_NEAR(e.potential / -work, 1, TOL_MEAN) ||
        !CHECK_NEAR((e.kinetic + e.elastic + e.potential) / work, 0, tolerance))
        printf("  %s, pulled: work %g J, kinetic %g, elastic %g, potential %g\n", name,
               work, e.kinetic, e.elastic, e.potential);
    run_close(&run);
}

/* Pulled in its plane all at once, a shell's membrane rings: its viscosity takes that, and
 * without it nothing does. Lost is told of F^2 L / E h; half of that rings. */
static void check_ringing(void)
{
    static const struct {
        const char *viscosity;
        double least, most;
    } row[] = {{"discretization.viscosity=membrane", 0.2, 0.5},
               {"discretization.viscosity=none", -1e-5, 1e-5}};
    const double WEIGHT = 0.4, EH = 400, STATIC_WORK = WEIGHT * WEIGHT / EH;

    for (int n = 0; n < 2; n++) {
        struct run run;
        struct energy e;
        OPENED_RUN(&run, "cantilever", "shell_3", SHEET, "discretization.points=[6,5]",
                   "damping={kind: none}", "gravity=[0,0,0]",
                   "loads=[{at: {u: 1}, force: [0.4, 0, 0]}]", row[n].viscosity);
        opened_steps(&run, STEPS);
        run.model->energy(run.state, &e);
        const double lost = -(e.kinetic + e.elastic + e.potential) / STATIC_WORK;
        if (!CHECK(lost > row[n].least && lost < row[n].most))
            printf("  %s: lost %g\n", row[n].viscosity, lost);
        run_close(&run);
    }
}

/* Two held edges that approach each other: Newton's method fails in a solid whose membrane
 * rings, and the viscosity that it takes on then spares tangents. */
static void check_relief(void)
{
    const double SPARED = 0.7;
    static const char *viscosity[] = {"discretization.viscosity=membrane",
                                      "discretization.viscosity=none"};
    struct counters work[2];

    for (int n = 0; n < 2; n++) {
        struct run run;
        OPENED_RUN(&run, "cantilever", "iga",
                   "material={young: 3.68e8, poisson: 0.3, density: 200}",
                   "sheet.thickness=0.001", "time.step=0.00145",
                   "discretization.points=[12,5,2]", "damping={kind: none}",
                   "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1}, fix: xyz, path: "
                   "[[0,0,0,0],[0.29,-0.2,0,0]]}]",
                   "gravity=[0,0,-9.81]", viscosity[n]);
        work[n] = opened_steps(&run, 100);
        run_close(&run);
    }
    if (!CHECK(work[0].viscous > 0 && work[1].viscous == 0 &&
               (double)work[0].assemblies < SPARED * (double)work[1].assemblies))
        printf("  relief: %ld and %ld tangents, %ld and %ld steps with viscosity\n",
               work[0].assemblies, work[1].assemblies, work[0].viscous, work[1].viscous);
}

int main(void)
{
    check_ringing();
    check_relief();
    for (size_t n = 0; n < sizeof contestants / sizeof *contestants; n++) {
        check_carried(contestants[n].name, contestants[n].points);
        check_work(contestants[n].name, contestants[n].points, contestants[n].energy);
    }
    return check_result();
}

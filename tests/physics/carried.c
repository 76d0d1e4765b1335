/* A sheet that is carried along is the still one under another force or wind, by every
 * kinematics but `printed`, whose held points start at rest; and the work of dead loads is
 * energy that a sheet then has. */
#include <float.h>

#include "tests/opened_run.h"

#define SHEET                                                                              \
    "material={young: 1.0e5, poisson: 0.3, density: 10}", "sheet.thickness=0.004",         \
        "time.step=0.005"

enum { STEPS = 25 };

/* Positions of 1 m: solved in every step to 1e-6 of a cell at worst; by linear solves, some
 * eps of systems of condition (L / h)^2 each. */
#define SOLVED 2e-5
#define EXACT  (STEPS * 250 * 250 * DBL_EPSILON)

#define NET   "discretization.points=[6,5]"
#define SOLID "discretization.points=[6,5,2]"
static const struct row {
    const char *name, *points, *own; /* a setting of its own, or NULL                     */
    double carried;                  /* tolerance [m]                                     */
    double energy; /* lost or gained, over the work of the loads; 0: there is none        */
} rows[] = {
    {"iga_nonlinear", SOLID, NULL, SOLVED, 1e-3},
    {"iga_selective_3", SOLID, NULL, SOLVED, 1e-3},
    {"hex_incompatible", SOLID, NULL, SOLVED, 1e-3},
    {"shell_3", NET, NULL, SOLVED, 0.1},     /* algorithmic viscosity */
    {"triangles", NET, NULL, SOLVED, 0.1},   /* likewise */
    {"mass_spring", NET, NULL, SOLVED, 0.5}, /* implicit Euler damps */
    {"mass_spring_leapfrog", NET, NULL, SOLVED, 1e-3},
    {"mass_spring_momentum", NET, NULL, SOLVED, 0.1}, /* as triangles */
    {"projective_dynamics", NET, NULL, SOLVED, 0},
    {"iga_linear", SOLID, NULL, EXACT, 0},
    {"iga_linear", SOLID, "discretization.unknowns=points", EXACT, 0},
    {"hex_linear", SOLID, NULL, EXACT, 0},
    {"iga_incremental", SOLID, NULL, EXACT, 0},
    {"hex_incremental", SOLID, "discretization.unknowns=points", EXACT, 0},
};

static double field[2][GRID_POINTS][3];

/* Held at an edge that moves at V, all of it moving so from the start. Mass damping resists
 * the motion itself: the sheet feels -alpha V, as the still one does under that gravity;
 * drag resists what moves against the wind. */
static const double V[3] = {0.3, -0.2, 0.5};
static const struct force {
    const char *common, *still, *moving;
} forces[] = {
    {"damping={kind: mass, value: 8}", "gravity=[-2.4,1.6,-4]", "gravity=[0,0,0]"},
    {"gravity=[0.5,1,-9.81]", "drag={coefficient: 8, wind: [2,-3,0.5]}",
     "drag={coefficient: 8, wind: [2.3,-3.2,1]}"}};

static void check_carried(const struct row *row, const struct force *force)
{
    struct run still, moving;
    double most = 0;

    OPENED_RUN(&still, "cantilever", row->name, SHEET, row->points, "damping={kind: none}",
               force->common, force->still, "supports=[{at: {u: 0}, fix: xyz}]", row->own);
    OPENED_RUN(&moving, "cantilever", row->name, SHEET, row->points, "damping={kind: none}",
               force->common, force->moving, "motion={velocity: [0.3,-0.2,0.5]}",
               "supports=[{at: {u: 0}, fix: xyz, path: "
               "[[-1,-0.3,0.2,-0.5],[0,0,0,0],[1,0.3,-0.2,0.5]]}]",
               row->own);
    opened_steps(&still, STEPS);
    opened_steps(&moving, STEPS);
    model_sample(still.model, still.state, field[0][0]);
    model_sample(moving.model, moving.state, field[1][0]);
    for (int n = 0; n < GRID_POINTS; n++) {
        most = fmax(most, fabs(field[0][n][2]));
        for (int i = 0; i < 3; i++)
            field[0][n][i] += V[i] * STEPS * still.scene.step;
    }
    SAY_UNLESS(CHECK_NEAR(opened_apart(field[0][0], field[1][0]), 0, row->carried) &&
                   CHECK(most > 0.01),
               "%s carried, %s: moved %g m", row->name, force->common, most);
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
    model_sample(run.model, run.state, field[0][0]);
    for (int j = 0; j < GRID_V; j++) /* of the end u = 1, by the trapezoidal rule */
        for (int k = 0; k < 2; k++) {
            const int point = (k * GRID_V + j) * GRID_U + GRID_U - 1;
            work +=
                0.05 * field[0][point][2] * (j % (GRID_V - 1) ? 1 : 0.5) / (GRID_V - 1) / 2;
        }
    run.model->energy(run.state, &e);
    /* The mean over the end is that of the nodes but for the rule's curvature. */
    const double TOL_MEAN = 2e-2;
    SAY_UNLESS(CHECK(work > 1e-4) && CHECK_NEAR(e.potential / -work, 1, TOL_MEAN) &&
                   CHECK_NEAR((e.kinetic + e.elastic + e.potential) / work, 0, tolerance),
               "%s, pulled: work %g J, kinetic %g, elastic %g, potential %g", name, work,
               e.kinetic, e.elastic, e.potential);
    run_close(&run);
}

/* Pulled in its plane all at once, a shell's membrane rings: its viscosity takes what the
 * steps do not resolve, and without it nothing is lost. Lost is told of F^2 L / E h; half
 * of that rings. */
static void check_ringing(void)
{
    static const struct {
        const char *viscosity;
        double least, most;
    } row[] = {{"discretization.viscosity=membrane", 0.1, 0.5},
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
        CHECK_SAY(lost > row[n].least && lost < row[n].most, "%s: lost %g",
                  row[n].viscosity, lost);
        run_close(&run);
    }
}

/* Two held edges that approach each other: Newton's method fails in a solid whose membrane
 * rings, and the viscosity that it takes on then spares tangents, and goes again. */
static void check_relief(void)
{
    const double SPARED =
        1; /* what passes the patch test rings less: some are left to spare */
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
    CHECK_SAY(work[0].viscous > 0 && work[0].viscous < 50 && work[1].viscous == 0 &&
                  (double)work[0].assemblies < SPARED * (double)work[1].assemblies,
              "relief: %ld and %ld tangents, %ld and %ld steps with viscosity",
              work[0].assemblies, work[1].assemblies, work[0].viscous, work[1].viscous);
}

int main(void)
{
    check_ringing();
    check_relief();
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++) {
        for (int k = 0; k < 2; k++)
            check_carried(&rows[n], &forces[k]);
        if (rows[n].energy > 0)
            check_work(rows[n].name, rows[n].points, rows[n].energy);
    }
    return check_result();
}

/* Solids at large displacements, in statics and in time: heavy elastica, pendulum, energy
 * and momenta. What the forces are made of is tested in solid_green.c.
 *
 *   solid_large iga|hex|selective
 */
#include "fem_ref/reference.h"
#include "tests/motion_fixture.h"

static const char nonlinear[] = "discretization.kinematics=nonlinear";

/* Nets that do not lock: cubics, quadratic through the thickness; incompatible modes. */
struct net {
    const char *model, *points, *degree, *remedy;
    /* Asked of the elastica [relative]: bends of spans L/16, L/32; shear of h/L = 1e-2 (its
     * square) is nothing beside it. Measured 3e-4 and 3e-3. */
    double elastica;
    /* Of the pendulum at 0.5 s [L]. Measured 2e-3 and 8e-3. */
    double pendulum;
};
static const struct net nets[] = {
    {"iga", "discretization.points=[19,4,3]", "discretization.degree=[3,3,2]",
     "discretization.remedy=none", 1e-3, 5e-3},
    {"hex", "discretization.points=[33,2,2]", "discretization.degree=[1,1,1]",
     "discretization.remedy=incompatible", 1e-2, 2e-2},
    {"iga", "discretization.points=[19,4,2]", "discretization.degree=[3,3,1]",
     "discretization.remedy=selective", 1e-3, 5e-3},
};

/* Newton's method stops at steps of 1e-7 L, and an undamped swing of 100 steps adds the
 * work of what is left: 100 times 1e-7 of the energy turned over, at most. */
static const double ENERGY_DRIFT = 1e-5;
/* The same for momenta; their forces cancel to round-off whatever Newton leaves, but the
 * positions at which they act are as good as it: sixty steps of 1e-7 L. */
static const double LINEAR_MOMENTUM = 1e-12, ANGULAR_MOMENTUM = 6e-6;

static void check_elastica(const struct net *net)
{
    static const double gammas[] = {1, 10, 100};
    struct reference *truth;
    struct message why = {""};
    char density[64];

    REQUIRE(reference_open(REFERENCE_DIR "/heavy_elastica.csv", &truth, &why) == STATUS_OK);
    for (int n = 0; n < 3; n++) {
        struct run run;
        double D = 1e5 * 1e-6 / 12, tip[3];
        int row = 0;
        while (reference_number(truth, row, "Gamma") != gammas[n])
            row++;
        snprintf(density, sizeof density, "material.density=%.17g",
                 gammas[n] * D / (9.81 * 0.01));
        run_open(&run, net->model, "cantilever",
                 RUN_SETTINGS("material.poisson=0", "sheet.thickness=0.01", density,
                              nonlinear, net->points, net->degree, net->remedy));
        CHECK(run.model->equilibrium(run.state, &run.counters, &why) == STATUS_OK);
        run.model->probe(run.state, 1, (double[3]){1, 0.5, 0.5}, tip);
        CHECK_NEAR(-tip[2] / reference_number(truth, row, "H_over_L"), 1, net->elastica);
        CHECK_NEAR(tip[0] - reference_number(truth, row, "W_over_L"), 0, net->elastica);
        run_close(&run);
    }
    reference_close(truth);
}

/* C0: 5 mm thick, undamped, nu = 0. */
static void check_pendulum(const struct net *net)
{
    struct reference *truth;
    struct message why = {""};
    struct run run;
    struct energy e;
    double x[3], drift = 0, turned = 0;

    REQUIRE(reference_open(REFERENCE_DIR "/pendulum_C0_E1e5_h5mm_undamped.csv", &truth,
                           &why) == STATUS_OK);
    run_open(&run, net->model, "edge_drop",
             RUN_SETTINGS("material.poisson=0", "sheet.thickness=0.005", "sheet.width=0.1",
                          "material.density=0.3", "damping={kind: none}", nonlinear,
                          net->points, net->degree, net->remedy));
    for (int n = 1; n <= 100; n++) {
        run_steps(&run, 1);
        run.model->energy(run.state, &e);
        turned = fmax(turned, -e.potential);
        drift = fmax(drift, fabs(e.kinetic + e.elastic + e.potential));
    }
    run.model->probe(run.state, 1, (double[3]){1, 0.5, 0.5}, x);
    CHECK_NEAR(hypot(x[0] - reference_number(truth, 100, "x1"),
                     x[2] - reference_number(truth, 100, "z1")),
               0, net->pendulum);
    CHECK_NEAR(drift / turned, 0, ENERGY_DRIFT);
    run_close(&run);
    reference_close(truth);
}

/* Momentum and angular momentum about the origin of the control points' motion. */
static void momenta(const struct run *run, double p[3], double l[3])
{
    const struct solid_motion *m = run_motion(run);
    size_t count = run_unknowns(run);
    double *y = malloc(count * sizeof *y);

    REQUIRE(y);
    memset(p, 0, 3 * sizeof *p);
    memset(l, 0, 3 * sizeof *l);
    blocks_multiply_mass(&m->assembly.graph, m->assembly.M, m->newmark.v, y);
    for (size_t a = 0; a < count / 3; a++)
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3, k = (i + 2) % 3;
            p[i] += y[3 * a + (size_t)i];
            l[i] += m->x[3 * a + (size_t)j] * y[3 * a + (size_t)k] -
                    m->x[3 * a + (size_t)k] * y[3 * a + (size_t)j];
        }
    free(y);
}

/* A free sheet without load, thrown, spinning and bending: keeps its momenta. */
static void check_momenta(const struct net *net)
{
    struct run run;
    double p[2][3], l[2][3];

    run_open(&run, net->model, "edge_drop",
             RUN_SETTINGS("supports=[]", "gravity=[0,0,0]", "damping={kind: none}",
                          "discretization.unknowns=points", "sheet.thickness=0.02",
                          nonlinear, "discretization.points=[6,5,2]",
                          net == &nets[1] ? "discretization.degree=[1,1,1]"
                                          : "discretization.degree=[2,2,1]",
                          net->remedy));
    struct solid_motion *m = run_motion(&run);
    for (int a = 0; a < m->space->nodes; a++) {
        const double *x = m->space->rest + 3 * a;
        double *v = m->newmark.v + 3 * a;
        v[0] = 0.3 - 2 * x[1], v[1] = 2 * x[0] + x[2], v[2] = 3 * x[0] * x[0] - x[1];
    }
    momenta(&run, p[0], l[0]);
    run_steps(&run, 60);
    momenta(&run, p[1], l[1]);
    for (int i = 0; i < 3; i++) {
        CHECK_NEAR((p[1][i] - p[0][i]) / p[0][2], 0, LINEAR_MOMENTUM);
        CHECK_NEAR((l[1][i] - l[0][i]) / l[0][2], 0, ANGULAR_MOMENTUM);
    }
    run_close(&run);
}

int main(int argc, char **argv)
{
    const char *word = argc > 1 ? argv[1] : "iga";
    const struct net *net = &nets[!strcmp(word, "selective") ? 2
                                  : !strcmp(word, "hex")     ? 1
                                                             : 0];

    check_elastica(net);
    check_pendulum(net);
    check_momenta(net);
    return check_result();
}

/* What supports and bodies exert on a sheet: with gravity and loads it is the change of
 * momentum, the moments are in balance at rest, and forces have their closed forms. */
#include "models/mechanics/march.h"
#include "tests/opened_run.h"

#define KEY "discretization."

struct variant {
    const char *model;
    const char *settings[3];
    double balance; /* of momentum, in weights                                          */
};

static const char *const moving[] = {
    "sheet={length: 0.5, width: 0.4, thickness: 0.004}",
    "pose={origin: [0.1,0.2,0.3], u: [1,0,0], v: [0,1,0]}",
    "material={young: 1e5, poisson: 0.3, density: 200}",
    "damping={kind: none}",
    "supports=[{at: {u: 0}, fix: xyz}, {at: {u: 1, v: 1}, fix: xyz, path: [[0,0,0,0],"
    "[0.2,-0.02,0,0.05]]}]",
    "loads=[{at: {v: 0}, force: [0,-0.1,0.05]}]",
    "obstacles=[{sphere: {center: [0.35,0.3,0.18], radius: 0.1, friction: 0.3}}]",
    "time={step: 0.005, end: 0.2}",
    "snapshots=[]"};

static const struct variant variants[] = {
    {"shell", {0}, 1e-9},
    {"hex", {KEY "newton=full"}, 1e-9},
    {"iga", {KEY "kinematics=nonlinear", KEY "newton=full"}, 1e-9},
    {"triangles", {0}, 1e-9},
    {"mass_spring", {KEY "integrator=momentum"}, 1e-9},
    {"mass_spring", {KEY "integrator=implicit"}, 1e-9},
    {"shell", {KEY "integrator=leapfrog"}, 1e-9},
    {"hex", {KEY "integrator=leapfrog"}, 1e-9},
    {"iga", {KEY "kinematics=nonlinear", KEY "integrator=leapfrog"}, 1e-9},
    {"triangles", {KEY "integrator=leapfrog", KEY "bending=hinge"}, 1e-9},
    {"mass_spring", {KEY "integrator=explicit"}, 1e-9},
    {"triangles", {KEY "integrator=leapfrog"}, 1e-9},
    {"mass_spring", {KEY "integrator=leapfrog"}, 1e-9},
    {"position_based", {0}, 1e-9},
    {"vbd", {0}, 1e-9},
    {"projective_dynamics", {0}, 1e-9},
};

/* Adds the momentum of v by the mass M, of what is a place and no difference. */
static void add_momentum(const struct march *m, const double *M, double sign, double *y,
                         double p[3])
{
    blocks_multiply_mass(m->graph, M, march_velocity(m), y);
    for (size_t t = 0; t < march_count(m); t++)
        if (!m->uvw || m->uvw[t / 3][2] >= SUPPORTS_MIDDLE)
            p[t % 3] += sign * y[t];
}

static void momentum_of(const struct march *m, double p[3])
{
    double *y = calloc(march_count(m), sizeof *y);

    REQUIRE(y);
    memset(p, 0, 3 * sizeof *p);
    add_momentum(m, m->M, 1, y, p);
    if (m->beyond)
        add_momentum(m, m->beyond, -1, y, p);
    free(y);
}

int main(void)
{
    for (size_t n = 0; n < sizeof variants / sizeof *variants; n++) {
        const struct variant *v = &variants[n];
        const char *list[16] = {0};
        struct run run;
        int count = 0;
        for (size_t k = 0; k < sizeof moving / sizeof *moving; k++)
            list[count++] = moving[k];
        for (int k = 0; k < 3 && v->settings[k]; k++)
            list[count++] = v->settings[k];
        opened_run(&run, "ground", v->model, count, list);
        const bool march = run.model->forces == march_forces;
        if (march)
            ((struct march *)run.state)->tolerance = 1e-13;
        double S[2][6], B[1][6], p0[3], p1[3];
        const double weight = 9.81 * .5 * .4 * .004 * 200;
        printf("%s %s:\n", v->model, v->settings[0] ? v->settings[0] : "");
        for (int f = 0; f < 40; f++) {
            if (march)
                momentum_of(run.state, p0);
            run.model->forces(run.state, NULL, NULL);
            opened_steps(&run, 1);
            run.model->forces(run.state, S, B);
            if (march)
                momentum_of(run.state, p1);
            double off = 0;
            for (int i = 0; i < 3; i++) {
                double sum = S[0][i] + S[1][i] + B[0][i] + (i == 2 ? -weight + .05 : i == 1 ? -.1 : 0);
                off = fmax(off, fabs(sum - (p1[i] - p0[i]) / 0.005));
            }
            if (f % 6 == 0) printf("  %d: S0 %.4f %.4f %.4f S1 %.4f %.4f %.4f B %.4f %.4f %.4f off %.2e\n", f, S[0][0], S[0][1], S[0][2], S[1][0],S[1][1],S[1][2],B[0][0],B[0][1],B[0][2], off / weight);
        }
        run_close(&run);
    }
    return check_result();
}

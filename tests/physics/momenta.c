/* A free sheet without load, thrown, spinning and bending, keeps momentum and angular
 * momentum in every energy-momentum scheme: shells, solids, triangles and springs. */
#include <float.h>

#include "models/mechanics/march.h"
#include "tests/opened_run.h"

enum { FRAMES = 60, EXTRA = 2 };

/* Momentum: forces cancel whatever Newton's method leaves, sixty sums over 30 to 60 nodes,
 * each to round-off. Angular momentum: the positions at which forces act are off by
 * Newton's last step, sixty times 1e-7 L at most; in surfaces, which stretch no thickness,
 * that step is a tenth of what is allowed. */
#define LINEAR (60 * FRAMES * DBL_EPSILON)
static const double ANGULAR[2] = {FRAMES * 1e-8, FRAMES * 1e-7}; /* surfaces, solids */

static const struct row {
    const char *name, *points, *settings[EXTRA];
} rows[] = {
    {"iga_nonlinear", "discretization.points=[6,5,2]", {"discretization.unknowns=points"}},
    {"iga_selective", "discretization.points=[6,5,2]", {"discretization.unknowns=points"}},
    {"hex_incompatible",
     "discretization.points=[6,5,2]",
     {"discretization.unknowns=points"}},
    {"shell_3", "discretization.points=[6,5]", {0}},
    {"shell_selective_2", "discretization.points=[6,5]", {0}},
    {"triangles", "discretization.points=[6,5]", {0}},
    {"triangles",
     "discretization.points=[6,5]",
     {"discretization.mesh=irregular", "discretization.bending=hinge"}},
    {"triangles",
     "discretization.points=[6,5]",
     {"discretization.membrane=corotational", "discretization.bending=hinge"}},
    {"mass_spring_momentum", "discretization.points=[6,5]", {0}},
};

/* The moving parts; a state begins with its march. */
struct parts {
    const struct blocks *graph;
    const double *M, *x; /* [pairs], [nodes][3]                                        */
    double *v;
};

static struct parts parts_of(const struct run *run)
{
    const struct march *m = run->state;

    return (struct parts){m->graph, m->M, m->x, m->v};
}

/* Momentum, and angular momentum about the origin. */
static void momenta(const struct parts *p, double L[6])
{
    double *y = malloc(3 * (size_t)p->graph->nodes * sizeof *y);

    REQUIRE(y);
    memset(L, 0, 6 * sizeof *L);
    blocks_multiply_mass(p->graph, p->M, p->v, y);
    for (int t = 0; t < 3 * p->graph->nodes; t++) {
        const int node = t - t % 3, j = node + (t + 1) % 3, k = node + (t + 2) % 3;
        L[t % 3] += y[t];
        L[3 + t % 3] += p->x[j] * y[k] - p->x[k] * y[j];
    }
    free(y);
}

static void check_momenta(const struct row *row)
{
    double L[2][6];
    struct run run;

    OPENED_RUN(&run, "edge_drop", row->name, "supports=[]", "gravity=[0,0,0]",
               "damping={kind: none}", "sheet.thickness=0.02", row->points,
               row->settings[0], row->settings[1]);
    const struct parts p = parts_of(&run);
    for (int a = 0; a < p.graph->nodes; a++) {
        const double *x = p.x + 3 * a;
        double *v = p.v + 3 * a;
        v[0] = 0.3 - 2 * x[1], v[1] = 2 * x[0] + x[2], v[2] = 3 * x[0] * x[0] - x[1];
    }
    momenta(&p, L[0]);
    opened_steps(&run, FRAMES);
    momenta(&p, L[1]);
    for (int i = 0; i < 6; i++)
        SAY_UNLESS(CHECK_NEAR((L[1][i] - L[0][i]) / L[0][i < 3 ? 2 : 5], 0,
                              i < 3 ? LINEAR : ANGULAR[run.contestant->layers > 0]),
                   "%s, %s", row->name, row->settings[0] ? row->settings[0] : "");
    run_close(&run);
}

int main(void)
{
    for (size_t n = 0; n < sizeof rows / sizeof *rows; n++)
        check_momenta(&rows[n]);
    return check_result();
}

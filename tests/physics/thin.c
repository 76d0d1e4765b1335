/* Thin sheets: control points lose all digits and say so; and what mid-surface and
 * thickness unknowns drop, splitting into membrane and bending motion, is zero to
 * round-off. (That those keep digits: `clothbench verify cantilever`.) */
#include <float.h>

#include "models/solid/solid_model.h"
#include "tests/opened_run.h"

/* With control points the condition is 1e2 (L / h)^4: 1e-16 of it leaves two digits at
 * h / L = 1e-3 and none from here on. */
static const double NO_DIGITS = 1e-4;
/* Dropped entries are sums of odd functions over symmetric Gauss points, or components that
 * no box couples: of the geometric mean of their diagonals a rounding, times the slope 20
 * of the steepest Legendre polynomial here, times a few. The same at every thickness. */
#define TOL_DROPPED (100 * DBL_EPSILON)

#define MATERIAL "material={young: 1e5, poisson: 0.3, density: 1}"
enum { TEXT = 96 };

static void check_points_refused(void)
{
    for (double h = NO_DIGITS; h > 5e-6; h /= 10) {
        struct counters work = {0};
        struct message why = {""};
        struct run run;
        char thickness[TEXT];

        snprintf(thickness, TEXT, "sheet.thickness=%.17g", h);
        OPENED_RUN(&run, "cantilever", "iga_linear", thickness, MATERIAL,
                   "gravity=[0,0,-1e-3]", "discretization.degree=[4,4,2]",
                   "discretization.points=[20,12,3]", "discretization.unknowns=points");
        CHECK(run_settle(&run, &work, &why) == STATUS_INDEFINITE);
        CHECK(strstr(why.text, "unknowns=thickness"));
        run_close(&run);
    }
}

/* Entry i, j of the stiffness diagonal of a node. */
static double diagonal(const struct solid_assembly *s, int node, int i)
{
    return s->K[s->graph.start[node]][4 * i];
}

/* The largest entry between unlike parities, of its diagonals; how many there are. */
static double largest_dropped(const struct solid_assembly *s, const unsigned char *parity,
                              long *count)
{
    double worst = 0;

    for (int a = 0; a < s->graph.nodes; a++)
        for (long n = s->graph.start[a]; n < s->graph.start[a + 1]; n++)
            for (int ij = 0; ij < 9; ij++) {
                int b = s->graph.node[n], i = ij / 3, j = ij % 3;
                if (parity[3 * a + i] == parity[3 * b + j])
                    continue;
                double scale = sqrt(diagonal(s, a, i) * diagonal(s, b, j));
                worst = fmax(worst, fabs(s->K[n][ij]) / scale);
                double mass = sqrt(s->M[s->graph.start[a]] * s->M[s->graph.start[b]]);
                if (i == j)
                    worst = fmax(worst, fabs(s->M[n]) / mass);
                ++*count;
            }
    return worst;
}

static void check_parity(const char *name, const int degree[3], const int points[3],
                         double h, int normal)
{
    static const char *const pose[] = {"pose={origin: [0,0,0], u: [0,1,0], v: [0,0,1]}",
                                       "pose={origin: [0,0,0], u: [0,0,1], v: [1,0,0]}",
                                       "pose={origin: [0,0,0], u: [1,0,0], v: [0,1,0]}"};
    struct run run;
    long count = 0;
    char text[3][TEXT];

    snprintf(text[0], TEXT, "sheet.thickness=%.17g", h);
    snprintf(text[1], TEXT, "discretization.points=[%d,%d,%d]", points[0], points[1],
             points[2]);
    snprintf(text[2], TEXT, "discretization.degree=[%d,%d,%d]", degree[0], degree[1],
             degree[2]);
    OPENED_RUN(&run, "cantilever", name, MATERIAL, "supports=[]", "gravity=[0,0,0]",
               pose[normal], text[0], text[1], degree[2] ? text[2] : NULL);
    const struct solid_sheet *m = run.state; /* solid_model.h: a state begins with it */
    REQUIRE(m->space.parity);
    CHECK_NEAR(largest_dropped(&m->assembly, m->space.parity, &count), 0, TOL_DROPPED);
    CHECK(3 * count > 9 * m->assembly.graph.start[m->space.nodes]); /* near half */
    run_close(&run);
}

int main(void)
{
    static const int degree[][3] = {{2, 2, 1}, {3, 2, 2}, {2, 3, 3}, {1, 2, 4}, {4, 4, 2}};

    check_points_refused();
    for (double h = 0.1; h > 5e-6; h /= 10)
        for (int normal = 0; normal < 3; normal++) {
            check_parity("hex_linear", (int[3]){0}, (int[]){6, 5, 2}, h, normal);
            check_parity("hex_incompatible_linear", (int[3]){0}, (int[]){6, 5, 2}, h,
                         normal);
            for (size_t n = 0; n < sizeof degree / sizeof *degree; n++)
                check_parity("iga_linear", degree[n], (int[]){6, 7, degree[n][2] + 1}, h,
                             normal);
        }
    return check_result();
}

/* Discretizations of the IGA plate that scenes rarely ask for - given knot vectors,
 * repeated knots, NURBS weights that vary over the sheet: samples sit at the same material
 * points. (What such nets answer: patch_test.c; `clothbench verify elastica`.) */
#include "tests/opened_run.h"

/* Points are looked up to 1e-12 (1 m + 1 m) where weights bend the parameters. */
static const double TOL_REST = 4e-12;

enum net { UNIFORM, GRADED, REPEATED, WEIGHTED, WEIGHTED_THROUGH, NETS };

/* Knots of direction i: denser at one end, or with a double knot at the middle. */
static void set_knots(struct discretization *d, int i, enum net net)
{
    int n = d->points[i], p = d->degree[i], spans = n - p;
    double *knots = malloc((size_t)(n + p + 1) * sizeof *knots);

    REQUIRE(knots);
    for (int t = 0; t <= n + p; t++) {
        double x = t <= p ? 0 : t >= n ? 1 : (double)(t - p) / spans;
        if (net == REPEATED && t > p && t < n) /* two knots in place of neighbours */
            x = t - p == spans / 2 + 1 ? (double)(spans / 2) / spans : x;
        knots[t] = net == GRADED ? x * (0.4 + 0.6 * x) : x;
    }
    d->knots[i] = knots;
    d->knot_count[i] = n + p + 1;
}

static void set_weights(struct discretization *d, bool through)
{
    int n = d->points[0], m = d->points[1], l = d->points[2];

    d->weight_count = n * m * l;
    d->weights = malloc((size_t)d->weight_count * sizeof *d->weights);
    REQUIRE(d->weights);
    for (int a = 0; a < d->weight_count; a++) {
        double u = (double)(a / (m * l)) / (n - 1), v = (double)(a / l % m) / (m - 1);
        double w = through ? (double)(a % l) / (l - 1) : 0;
        d->weights[a] = 1 + 0.3 * sin(3 * u) * cos(2 * v) + 0.1 * w;
    }
}

static void open_net(struct run *run, enum net net, const char *points)
{
    struct discretization *d = &run->discretization;

    opened_read(run, "cantilever", "iga_linear",
                OPENED_LIST(points, "discretization.degree=[3,3,2]", "sheet.thickness=0.05",
                            "sheet.width=0.8", "material.density=20", "time.step=0.01",
                            "pose={origin: [1,2,3], u: [0.6,0.8,0], v: [-0.8,0.6,0]}"));
    if (net == GRADED || net == REPEATED) {
        set_knots(d, 0, net);
        set_knots(d, 1, net);
    }
    if (net >= WEIGHTED)
        set_weights(d, net == WEIGHTED_THROUGH);
    opened_build(run);
}

/* At rest every sample is where the scene says its material point is. */
static void check_rest(enum net net)
{
    struct run run;

    open_net(&run, net, "discretization.points=[9,8,3]");
    CHECK_NEAR(opened_off(&run, NULL), 0, TOL_REST);
    run_close(&run);
}

int main(void)
{
    for (int net = UNIFORM; net < NETS; net++)
        check_rest((enum net)net);
    return check_result();
}

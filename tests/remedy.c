/* remedy=reduced and remedy=selective: the paper's own net, 10 x 10 x 2 of degree (2,2,1),
 * is right at any thickness and Poisson's ratio, in linear and in nonlinear statics; and
 * remedy=clamped at h/L = 0.1, too. */
#include "fem_ref/freefem.h"
#include "fem_ref/kirchhoff.h"
#include "tests/cantilever_fixture.h"
#include "tests/solid_fixture.h"

struct cure {
    const char *set;
    /* Asked: 2 % of the deflection, of which bending by the reduced rule takes most at
     * degree 3; 0.4 and 0.14 % were measured where it has its own, which is to show. */
    double target[2];
};
static const struct cure cures[] = {{"discretization.remedy=reduced", {0.02, 0.02}},
                                    {"discretization.remedy=selective", {0.005, 0.002}}};
/* Asked of shapes at Gamma = 10 and 100, too, where the clamp's bend takes one of the eight
 * spans. Measured 1.5 %. */
static const double BENT = 0.02;
/* What a plate of h/L = 1e-2 has beyond Kirchhoff's: shear and the edge, some (h/L)^2 and
 * h/L times nu. Measured 1.5e-3 at nu = 0.49. */
static const double THICK = 2e-3;
/* Thickness by itself changes nothing below h/L = 1e-3: at the same Gamma the same shape,
 * to (h/L)^2 and what Newton's method leaves. */
static const double SAME_SHAPE = 1e-3;

static double tip_coefficient(double nu)
{
    enum { TERMS = 24 };
    const struct kirchhoff_plate plate = {.length = 1,
                                          .width = 1,
                                          .thickness = 1,
                                          .young = 12 * (1 - nu * nu),
                                          .poisson = nu,
                                          .density = 1};
    struct kirchhoff *k = NULL;

    REQUIRE(kirchhoff_create(&plate, TERMS, &k) == STATUS_OK);
    double tip = kirchhoff_static(k, 1, 1, 0.5);
    kirchhoff_destroy(k);
    return tip;
}

static void check_linear(const struct cure *cure)
{
    static const double nus[] = {0, 0.3, 0.49}, hs[] = {1e-2, 1e-3, 1e-4, 1e-5};
    static const char *const sets[2][2] = {
        {"discretization.degree=[2,2,1]", "discretization.points=[10,10,2]"},
        {"discretization.degree=[3,3,1]", "discretization.points=[10,10,2]"}};
    double tip[3];

    for (int n = 0; n < 3; n++) {
        double truth = tip_coefficient(nus[n]);
        for (int t = 0; t < 8; t++) {
            const char *const *set = sets[t / 4];
            int k = t % 4;
            cantilever_tip(nus[n], hs[k], 0.01, "linear", set, cure->set, tip);
            if (!CHECK_NEAR(-tip[2] / (0.01 * truth), 1,
                            cure->target[t / 4] + (k == 0) * THICK))
                printf("nu %g, h %g, %s, %s\n", nus[n], hs[k], set[0], cure->set);
        }
    }
}

/* nu = 0: the elastica; and no thickness changes a bent shape. */
static void check_nonlinear(const struct cure *cure)
{
    static const double gammas[] = {10, 100};
    static const char *const set[2] = {"discretization.degree=[2,2,1]",
                                       "discretization.points=[10,10,2]"};
    double truth[2], tip[3], thin[3];

    for (int n = 0; n < 2; n++) {
        cantilever_elastica(gammas[n], truth);
        cantilever_tip(0, 1e-3, gammas[n], "nonlinear", set, cure->set, tip);
        CHECK_NEAR(fabs(-tip[2] / truth[1] - 1), 0, BENT);
        cantilever_tip(0, 1e-4, gammas[n], "nonlinear", set, cure->set, thin);
        CHECK_NEAR(hypot(tip[0] - thin[0], tip[2] - thin[2]), 0, SAME_SHAPE);
    }
}

/* --- remedy=clamped. */

/* rms of how far the plate of FreeFEM's stored field is from it, of the field's. */
static double off_field(const char *path, int degree, const char *poisson, double nu)
{
    const double h = 0.1, weight = 1e-4; /* of a unit of D / h: small strains */
    static struct freefem_field field, still;
    static struct freefem_field ours;
    char gravity[64], degrees[64];
    struct message why = {""};
    struct run run;

    REQUIRE(freefem_read(path, &field, &why) == STATUS_OK);
    const double D = 1e5 * h * h * h / (12 * (1 - nu * nu)), scale = 0.5 * 9.81 * h / D;
    snprintf(gravity, sizeof gravity, "gravity=[0,0,%.17g]", -weight * D / h);
    snprintf(degrees, sizeof degrees, "discretization.degree=[%d,%d,1]", degree, degree);
    run_open(&run, "iga", "cantilever",
             RUN_SETTINGS("sheet.thickness=0.1", poisson, gravity, "material.density=1",
                          "discretization.kinematics=linear", degrees,
                          "discretization.points=[10,10,2]",
                          "discretization.remedy=clamped"));
    CHECK(run.model->equilibrium(run.state, &run.counters, &why) == STATUS_OK);
    for (int j = 0; j < FREEFEM_SIDE; j++)
        for (int i = 0; i < FREEFEM_SIDE; i++) {
            const double last = FREEFEM_SIDE - 1, uvw[3] = {i / last, j / last, 0.5};
            double x[3];
            run.model->probe(run.state, 1, uvw, x);
            ours.shift[0][j][i][2] = x[2] * scale / weight;
        }
    run_close(&run);
    return freefem_difference(&field, &ours, 0) / freefem_difference(&field, &still, 0);
}

/* A clamped solid, where plane stress is 2.7 % off at nu = 0.49. Asked: what the same net
 * is held to where it is thin, but at degree 2 and nu = 0.49, where the rule's points,
 * which are for thin plates, leave more. Measured 0.45 and 0.09 %, 0.65 and 0.10 %. */
static void check_thick(void)
{
    static const struct {
        const char *path, *poisson;
        double nu;
    } blocks[] = {
        {REFERENCE_DIR "/freefem_static_h100mm_nu03.csv", "material.poisson=0.3", 0.3},
        {REFERENCE_DIR "/freefem_static_h100mm_nu049.csv", "material.poisson=0.49", 0.49}};

    for (int n = 0; n < 2; n++)
        for (int degree = 2; degree <= 3; degree++) {
            const double TOL_RUBBER = 0.01;
            const double TOL_THIN =
                n == 1 && degree == 2 ? TOL_RUBBER : cures[1].target[degree - 2];
            if (!CHECK_NEAR(
                    off_field(blocks[n].path, degree, blocks[n].poisson, blocks[n].nu), 0,
                    TOL_THIN))
                printf("clamped, %s, degree %d\n", blocks[n].poisson, degree);
        }
}

/* What the points of the rule lose turns a strip under the moment x^k as much as the layer
 * does, int c^2 exp(-x / l) x^k dx, k = 0 and 1: on spans longer and shorter than l, at all
 * four edges. */
static void check_clamp(int points, double thickness, int i, bool end)
{
    const double nu = 0.49, c = nu / (1 - nu), l = thickness * sqrt((1 - nu) / 120);
    const double rest = exp(-1 / l), EXACT = 1e-12; /* round-off; what is lost is < 1 */
    const struct solid_case box = {
        SOLID_SELECTIVE, {3, 3, 1}, {points, points, 2}, {1, 1, 1}};
    struct solid_space space;
    struct plate_tables tables;
    struct patch patch;
    double x[2], w[2], lost[2] = {0};

    solid_box(&box, &patch);
    REQUIRE(!plate_space_init(&space, &tables, &patch, (int[3]){0}, true));
    REQUIRE(!plate_space_select(&space, &tables, &patch));
    REQUIRE(tables.cure[PLATE_BENDING][i].gauss == 2);
    plate_space_clamp(&tables, &patch, i, end, thickness, nu);
    gauss_rule(2, x, w);
    for (int e = 0, n = tables.cure[PLATE_BENDING][i].spans; e < n; e++)
        for (int q = 0; q < 2; q++) {
            double had = w[q] / n, at = (e + x[q]) / n;
            double less = had - had * had / tables.cure[PLATE_BENDING][i].weight[2 * e + q];
            lost[0] += less;
            lost[1] += less * (end ? 1 - at : at);
        }
    CHECK_NEAR(lost[0], c * c * l * (1 - rest), EXACT);
    CHECK_NEAR(lost[1], c * c * l * (l - rest * (1 + l)), EXACT);
    for (int e = 0; e < tables.cure[PLATE_BENDING][!i].spans; e++)
        CHECK_NEAR(tables.cure[PLATE_BENDING][!i].weight[2 * e],
                   w[0] / tables.cure[PLATE_BENDING][!i].spans, EXACT);
    plate_space_clear(&space, &tables);
    patch_clear(&patch);
}

int main(void)
{
    for (int n = 0; n < 8; n++)
        check_clamp(n < 4 ? 10 : 40, n < 4 ? 0.1 : 1, n % 2, n % 4 / 2);
    check_thick();
    for (int n = 0; n < 2; n++) {
        check_linear(&cures[n]);
        check_nonlinear(&cures[n]);
    }
    return check_result();
}

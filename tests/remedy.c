/* remedy=reduced and remedy=selective: the paper's own net, 10 x 10 x 2 of degree (2,2,1),
 * is right at any thickness and Poisson's ratio, in linear and in nonlinear statics. */
#include "fem_ref/kirchhoff.h"
#include "tests/cantilever_fixture.h"

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

int main(void)
{
    for (int n = 0; n < 2; n++) {
        check_linear(&cures[n]);
        check_nonlinear(&cures[n]);
    }
    return check_result();
}

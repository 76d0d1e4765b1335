/* remedy=reduced and remedy=selective: the paper's own net, 10 x 10 x 2 of degree (2,2,1),
 * is right at any thickness and Poisson's ratio, in linear and in nonlinear statics. */
#include "fem_ref/kirchhoff.h"
#include "fem_ref/reference.h"
#include "tests/motion_fixture.h"

struct cure {
    const char *set;
    /* Asked: 2 % of the deflection. Measured 0.9 and 0.6 % with bending by the reduced
     * rule; 0.4 and 0.03 % where it has its own, which is to show. */
    double target[2];
};
static const struct cure cures[] = {{"discretization.remedy=reduced", {0.02, 0.02}},
                                    {"discretization.remedy=selective", {0.005, 0.001}}};
/* Shapes at Gamma = 100 on eight spans, of which the clamp's bend takes one. */
static const double BENT = 0.021;
/* What a plate of h/L = 1e-2 has beyond Kirchhoff's: shear and the edge, some (h/L)^2 and
 * h/L times nu. */
static const double THICK = 1e-3;
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

/* Tip of the cantilever at a Gamma in a kinematics [m]. */
static void tip_at(double nu, double h, double gamma, const char *kinematics,
                   const char *degree, const char *remedy, double tip[3])
{
    char thickness[64], poisson[64], gravity[64];
    struct message why = {""};
    struct run run;
    double D = 1e5 * h * h * h / (12 * (1 - nu * nu));

    snprintf(thickness, sizeof thickness, "sheet.thickness=%.17g", h);
    snprintf(poisson, sizeof poisson, "material.poisson=%.17g", nu);
    snprintf(gravity, sizeof gravity, "gravity=[0,0,%.17g]", -gamma * D / h);
    run_open(&run, "iga", "cantilever",
             RUN_SETTINGS(thickness, poisson, gravity, "material.density=1", kinematics,
                          degree, remedy));
    if (!CHECK(run.model->equilibrium(run.state, &run.counters, &why) == STATUS_OK))
        printf("nu %g, h %g, Gamma %g: %s\n", nu, h, gamma, why.text);
    run.model->probe(run.state, 1, (double[3]){1, 0.5, 0.5}, tip);
    run_close(&run);
}

static void check_linear(const struct cure *cure)
{
    static const double nus[] = {0, 0.3, 0.49}, hs[] = {1e-2, 1e-3, 1e-4, 1e-5};
    static const char *const degrees[] = {"discretization.degree=[2,2,1]",
                                          "discretization.degree=[3,3,1]"};
    double tip[3];

    for (int n = 0; n < 3; n++) {
        double truth = tip_coefficient(nus[n]);
        for (int t = 0; t < 8; t++) {
            const char *degree = degrees[t / 4];
            int k = t % 4;
            tip_at(nus[n], hs[k], 0.01, "discretization.kinematics=linear", degree,
                   cure->set, tip);
            if (!CHECK_NEAR(-tip[2] / (0.01 * truth), 1,
                            cure->target[t / 4] + (k == 0) * THICK))
                printf("nu %g, h %g, %s, %s\n", nus[n], hs[k], degree, cure->set);
        }
    }
}

/* nu = 0: the elastica; and no thickness changes a bent shape. */
static void check_nonlinear(const struct cure *cure)
{
    static const double gammas[] = {10, 100};
    struct reference *truth;
    struct message why = {""};
    double tip[3], thin[3];

    REQUIRE(reference_open(REFERENCE_DIR "/heavy_elastica.csv", &truth, &why) == STATUS_OK);
    for (int n = 0; n < 2; n++) {
        int row = 0;
        while (reference_number(truth, row, "Gamma") != gammas[n])
            row++;
        tip_at(0, 1e-3, gammas[n], "discretization.kinematics=nonlinear",
               "discretization.degree=[2,2,1]", cure->set, tip);
        CHECK_NEAR(-tip[2] / reference_number(truth, row, "H_over_L"), 1, BENT);
        tip_at(0, 1e-4, gammas[n], "discretization.kinematics=nonlinear",
               "discretization.degree=[2,2,1]", cure->set, thin);
        CHECK_NEAR(hypot(tip[0] - thin[0], tip[2] - thin[2]), 0, SAME_SHAPE);
    }
    reference_close(truth);
}

int main(void)
{
    for (int n = 0; n < 2; n++) {
        check_linear(&cures[n]);
        check_nonlinear(&cures[n]);
    }
    return check_result();
}

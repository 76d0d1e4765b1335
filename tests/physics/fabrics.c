/* Fabrics that soften, against the heavy elastica; verify orthotropic has the rest of their
 * law. */
#include "tests/opened_run.h"

/* A strip 4 cm long that its weight bends, M = B k + C k |k| without coupling. */
static const double SOFT_B = 2e-5, SOFT_LENGTH = 0.04, SOFT_WEIGHT = 0.1 * 9.81;

/* Returns the curvature of a moment; beyond 0.45 B / |C| the tangent is a tenth of B. */
static double curvature_of(double moment, double C)
{
    const double most = C < 0 ? 0.45 * SOFT_B / -C : INFINITY;
    const double end = C < 0 ? (SOFT_B + C * most) * most : INFINITY;

    return moment > end ? most + (moment - end) / (0.1 * SOFT_B)
           : C < 0      ? (SOFT_B - sqrt(SOFT_B * SOFT_B + 4 * C * moment)) / (-2 * C)
                        : moment / SOFT_B;
}

/* Integrates the elastica from the tip, at the slope `angle`, to the root, by the mid-point
 * rule; returns the slope there, and computes the tip's place from it. */
static double elastica(double angle, double C, double tip[2])
{
    enum { STEPS = 2000 };
    const double step = SOFT_LENGTH / STEPS;
    double moment = 0;

    tip[0] = tip[1] = 0;
    for (int n = 0; n < STEPS; n++) {
        const double weight = SOFT_WEIGHT * (n + 0.5) * step;
        const double half = angle - curvature_of(moment, C) * step / 2;
        const double middle = moment + weight * cos(angle) * step / 2;
        moment += weight * cos(half) * step;
        angle -= curvature_of(middle, C) * step;
        tip[0] += cos(half) * step, tip[1] += sin(half) * step;
    }
    return angle;
}

static void check_softening(const char *name, double warp, double C)
{
    const double HEAVY = 5e-3, uvw[3] = {1, 0.5, 0.5};
    double tip[2], xyz[3], low = 0, high = acos(-1) / 2;
    char material[256];
    struct run run;

    for (int n = 0; n < 50; n++)
        *(elastica((low + high) / 2, C, tip) < 0 ? &low : &high) = (low + high) / 2;
    const bool along = warp == 0;
    snprintf(material, sizeof material,
             "material={membrane: [2000, 2000, 0, 700], areal_density: 0.1, warp: %g, "
             "bending: [%g, %g, 0, 1e-5], softening: [%g, %g]}",
             warp, along ? SOFT_B : 3e-5, along ? 3e-5 : SOFT_B, along ? C : -1e-8,
             along ? -1e-8 : C);
    OPENED_RUN(&run, "cantilever", name, material, "discretization.points=[21,5]",
               "gravity=[0,0,-9.81]", "sheet={length: 0.04, width: 0.01}");
    opened_settle(&run);
    run.model->probe(run.state, 1, uvw, xyz);
    printf("%s, C = %g: tip at %.4f, %.4f of the length, elastica %.4f, %.4f\n", name, C,
           xyz[0] / SOFT_LENGTH, -xyz[2] / SOFT_LENGTH, tip[0] / SOFT_LENGTH,
           tip[1] / SOFT_LENGTH);
    CHECK_NEAR(xyz[0] / SOFT_LENGTH, tip[0] / SOFT_LENGTH, HEAVY);
    CHECK_NEAR(-xyz[2] / SOFT_LENGTH, tip[1] / SOFT_LENGTH, HEAVY);
    run_close(&run);
}

int main(void)
{
    static const char *const names[] = {"shell_selective_3", "triangles",
                                        "mass_spring_momentum"};
    static const double curves[] = {-5e-8, -2e-7}; /* in the law's range, far beyond */

    for (int n = 0; n < 3; n++)
        for (int a = 0; a < 2; a++)
            check_softening(names[n], 90 * a, curves[a]);
    return check_result();
}

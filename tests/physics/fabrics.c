/* Fabrics in every model that has them, against closed forms: frequencies of narrow strips
 * cut at any angle, of Navier's plate, the stretch of strips, the heavy elastica of strips
 * that soften. */
#include "tests/opened_run.h"

static const double PI = 3.14159265358979323846;

/* No modulus is another's multiple by what a mistake would take for it. */
#define FABRIC                                                                             \
    "material={membrane: [2000, 5000, 800, 300], bending: [1e-5, 4e-5, 4e-6, 6e-6], "      \
    "areal_density: 0.1, warp: %g}"
static const struct law_fabric fabric = {
    {2000, 5000, 800, 300}, {1e-5, 4e-5, 4e-6, 6e-6}, 0, 0.1};

/* Contestants and their nets on a strip and a square; springs lack Y12. */
static const struct kind {
    const char *name, *strip, *square;
    bool askew, cross, softens;
} kinds[] = {
    {"shell_selective_3", "[30,6]", "[16,16]", true, true, true},
    {"iga_selective_3", "[30,6,2]", "[16,16,2]", true, true},
    {"triangles", "[41,7]", "[25,25]", true, true, true},
    {"mass_spring", "[41,7]", "[25,25]", false, false},
    {"mass_spring_momentum", "[41,7]", "[25,25]", false, false, true},
};
enum { KINDS = sizeof kinds / sizeof *kinds, MODES = 8 };

static struct law law_at(double warp)
{
    struct law_fabric turned = fabric;

    turned.warp = warp;
    return law_of_fabric(&turned);
}

/* Returns the frequency nearest to the one wanted. */
static double nearest(const struct kind *k, const char *scene, double warp,
                      const char *points, double want, const char *const setting[3])
{
    struct run run;
    struct message why = {""};
    char material[256], net[64];
    double omega[MODES], best = INFINITY;

    snprintf(material, sizeof material, FABRIC, warp);
    snprintf(net, sizeof net, "discretization.points=%s", points);
    OPENED_RUN(&run, scene, k->name, material, net, "gravity=[0,0,0]", setting[0],
               setting[1], setting[2]);
    REQUIRE(run.model->modes(run.state, MODES, omega, &why) == STATUS_OK);
    for (int n = 0; n < MODES; n++)
        if (fabs(omega[n] - want) < fabs(best - want))
            best = omega[n];
    run_close(&run);
    return best;
}

/* A strip 1/20 as wide as long, whose sides are free: B(angle) = 1 / (B^-1)_11, and not
 * B_11, which is up to 40 % more. Its clamp keeps it from twisting there. */
static void check_strip(const struct kind *k, double warp)
{
    static const char *const narrow[] = {"sheet.width=0.05", "time.end=1",
                                         "damping={kind: none}"};
    const double STRIP = 0.012;
    const struct law law = law_at(warp);
    const double B = law_narrow(law.matrix[LAW_BENDING]);
    const double want = 3.5160153 * sqrt(B / fabric.areal_density);

    if (!CHECK_RELATIVE(nearest(k, "cantilever", warp, k->strip, want, narrow), want,
                        STRIP))
        printf("  %s at %g degrees\n", k->name, warp);
}

/* A plate supported on four sides: pi^4 (B1 / a^4 + 2 (B12 + 2 B66) / a^2 b^2 + B2 / b^4).
 */
static void check_plate(const struct kind *k, double warp)
{
    static const char *const oblong[] = {"sheet.width=0.7", "time.end=1",
                                         "damping={kind: none}"};
    const double PLATE = 0.01, a2 = 1, b2 = 0.49;
    const struct law law = law_at(warp);
    const double *B = law.matrix[LAW_BENDING];
    const double want =
        PI * PI *
        sqrt((B[LAW_11] / (a2 * a2) + 2 * (B[LAW_12] + 2 * B[LAW_33]) / (a2 * b2) +
              B[LAW_22] / (b2 * b2)) /
             fabric.areal_density);

    if (!CHECK_RELATIVE(nearest(k, "navier", warp, k->square, want, oblong), want, PLATE))
        printf("  %s at %g degrees\n", k->name, warp);
}

/* A sheet, held along one edge in all but the direction along it, is pulled by the other:
 * far from the ends of a strip the stretch is F / (W Y), Y = 1 / (A^-1)_11. */
static void check_pull(const struct kind *k, double warp)
{
    const double PULL = 0.02, force = 1e-3, width = 0.05;
    struct law law = law_at(warp);

    if (!k->cross) /* springs have Y12 = G */
        law.matrix[LAW_MEMBRANE][LAW_12] = law.matrix[LAW_MEMBRANE][LAW_33];
    const double want = force / (width * law_narrow(law.matrix[LAW_MEMBRANE]));
    struct run run;
    char material[256], net[64];
    const double uvw[2][3] = {{0.25, 0.5, 0.5}, {0.75, 0.5, 0.5}};
    double xyz[2][3];

    snprintf(material, sizeof material, FABRIC, warp);
    snprintf(net, sizeof net, "discretization.points=%s", k->strip);
    OPENED_RUN(&run, "cantilever", k->name, material, net, "gravity=[0,0,0]",
               "sheet.width=0.05", "loads=[{at: {u: 1}, force: [1e-3, 0, 0]}]");
    opened_settle(&run);
    run.model->probe(run.state, 2, &uvw[0][0], &xyz[0][0]);
    if (!CHECK_RELATIVE((xyz[1][0] - xyz[0][0]) / 0.5 - 1, want, PULL))
        printf("  %s at %g degrees\n", k->name, warp);
    run_close(&run);
}

/* --- softening ---------------------------------------------------------------------------
 * A strip 4 cm long that its weight bends, M = B k + C k |k| without coupling. */

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

static void check_softening(const struct kind *k, double warp, double C)
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
    OPENED_RUN(&run, "cantilever", k->name, material, "discretization.points=[21,5]",
               "gravity=[0,0,-9.81]", "sheet={length: 0.04, width: 0.01}");
    opened_settle(&run);
    run.model->probe(run.state, 1, uvw, xyz);
    printf("%s, C = %g: tip at %.4f, %.4f of the length, elastica %.4f, %.4f\n", k->name, C,
           xyz[0] / SOFT_LENGTH, -xyz[2] / SOFT_LENGTH, tip[0] / SOFT_LENGTH,
           tip[1] / SOFT_LENGTH);
    CHECK_NEAR(xyz[0] / SOFT_LENGTH, tip[0] / SOFT_LENGTH, HEAVY);
    CHECK_NEAR(-xyz[2] / SOFT_LENGTH, tip[1] / SOFT_LENGTH, HEAVY);
    run_close(&run);
}

int main(void)
{
    static const double angles[] = {0, 90, 30, 45};
    static const double curves[] = {-5e-8, -2e-7}; /* in the law's range, far beyond */

    for (int n = 0; n < KINDS; n++)
        for (int a = 0; a < (kinds[n].askew ? 4 : 2); a++) {
            if (kinds[n].cross) /* springs have no modes */
                check_strip(&kinds[n], angles[a]);
            if (a < 2 && kinds[n].cross)
                check_plate(&kinds[n], angles[a]);
            check_pull(&kinds[n], angles[a]);
        }
    for (int n = 0; n < KINDS; n++)
        for (int a = 0; kinds[n].softens && a < 2; a++)
            check_softening(&kinds[n], angles[a], curves[a]);
    return check_result();
}

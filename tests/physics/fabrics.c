/* Fabrics in every model that has them, against closed forms: frequencies of narrow strips
 * cut at any angle, of Navier's plate, of bars that swing along themselves. */
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
    bool askew, cross;
} kinds[] = {
    {"shell_selective_3", "[30,6]", "[16,16]", true, true},
    {"iga_selective_3", "[30,6,2]", "[16,16,2]", true, true},
    {"triangles", "[41,7]", "[25,25]", true, true},
    {"mass_spring", "[41,7]", "[25,25]", false, false},
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

int main(void)
{
    static const double angles[] = {0, 90, 30, 45};

    for (int n = 0; n < KINDS; n++)
        for (int a = 0; a < (kinds[n].askew ? 4 : 2); a++) {
            if (kinds[n].cross) /* springs have no modes */
                check_strip(&kinds[n], angles[a]);
            if (a < 2 && kinds[n].cross)
                check_plate(&kinds[n], angles[a]);
            check_pull(&kinds[n], angles[a]);
        }
    return check_result();
}

/* A disc, held inside a circle, that bends a little under its weight: the scene `drape`
 * with gravity so small that theory is linear. */
#include <math.h>

#include "bench/verify/verify_check.h"

/* The rim's deflection over the ring's width, a thousandth of the thickness, whose square
 * stretching adds to bending; and the thickness over that width. */
static const double SAG = 1e-5, THIN = 0.01;
static const double INNER = 0.09, OUTER = 0.15, POISSON = 0.3;
static const double BAR = 1e-9; /* round-off of logarithms and a system of four          */

/* The shear deflection of a solid, near (h / L)^2, and its softer clamp. */
#define SURFACE 1e-4, "a fiftieth of the error of degree 2 on the same net, or less"
#define SOLID   1e-3, "shear and clamp of a solid of h / L = 0.01"
static const struct verify_subject entries[] = {
    {"shell_3,shell_selective_3", SURFACE, {8, 14}, {16, 32}},
    {"iga_selective_3", SOLID, {8, 14}, {16, 32}},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_SMALL, NULL, {8, 14}, {16, 32}};

/* Returns w D / q at the outer radius b of a plate that is clamped at a and free at b:
 *   w = r^4 / 64 + A ln(r / a) + B (r^2 - a^2) + C (r^2 ln(r / a)) + const;
 * no shear at b gives C, no moment there and no slope at a give A and B. */
static double rim(double a, double b, double nu)
{
    const double C = -b * b / 8, l = log(b / a); /* r / 2 + 4 C / r = 0 at b */
    /* slope at a: a^3 / 16 + A / a + 2 a B + a C = 0 */
    /* moment at b: w'' + nu w' / b = 0 */
    const double rest = b * b * (3 + nu) / 16 + C * (2 * l * (1 + nu) + 3 + nu);
    const double of_A = (nu - 1) / (b * b), of_B = 2 * (1 + nu);
    const double slope = -(a * a * a / 16 + a * C) * a; /* A = slope - 2 a^2 B */
    const double B = -(rest + of_A * slope) / (of_B - 2 * a * a * of_A);
    const double A = slope - 2 * a * a * B;
    return (pow(b, 4) - pow(a, 4)) / 64 + A * l + B * (b * b - a * a) + C * b * b * l;
}

/* Returns the rim's deflection, w D / (q L^4). */
static double measure(struct verify_trial *t, void *context)
{
    const double L = OUTER - INNER, h = THIN * L, young = 1e6, density = 400;
    const double D = young * h * h * h / (12 * (1 - POISSON * POISSON));
    const double truth = *(const double *)context, q = SAG * D / (truth * L * L * L);
    double xyz[3] = {0};

    verify_trial_set(t,
                     "sheet.thickness=%.17g; material={young: %g, poisson: %g, "
                     "density: %g}; gravity=[0,0,%.17g]; motion={}",
                     h, young, POISSON, density, -q / (density * h));
    verify_trial_equilibrium(t, 1, (double[]){1, 0.3, 0.5}, xyz);
    return -xyz[2] / (SAG * L) * truth;
}

static void add_row(struct verify_subject *s)
{
    double truth = rim(INNER, OUTER, POISSON) / pow(OUTER - INNER, 4);
    struct verify_trial t = verify_trial_of(s, "drape", "w D / (q L^4) of the rim");

    verify_trial_nets(&t, measure, &truth, truth, BAR);
}

const struct verify_check verify_ring = {
    {"ring", "deflection of a disc that is held inside a circle"},
    "Kirchhoff's plate between two circles (Timoshenko, Woinowsky-Krieger 1959, ch. 3)",
    .parts = {{&field, add_row, 1}}};

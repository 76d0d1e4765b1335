#include <math.h>
#include <string.h>

#include "bench/verify/checks/verify_plates.h"

static const double GAMMA = 0.01; /* every model's answer is that of linear theory */
/* Error of the table: ten digits, uniform loads a series to 6e-7. */
static const double BAR = 1e-6;
/* Modes computed; since those in the plane lie among them, the one nearest counts. */
enum { MODES = 8 };

/* h/a up to which one layer of linear functions, which has no shear correction, lacks 0.2
 * %: a sixth of the shear deflection, which is some 5 (h/a)^2. */
static const double ONE_LAYER = 0.05;

/* Elasticity itself: degree 5 through the thickness leaves (h/a)^10 of it, the in-plane net
 * the corners' r^4 log r; claims 1e-3 down to where degree 4 begins to lock. */
enum { SOLID_LAYERS = 6 };
static const double SOLID_LOCKS = 0.01;
#define SOLID                                                                              \
    1e-3, "elasticity itself, on five spans a half wave", {8, 14}, {8, 14}, 0,             \
        "p = 4, r = 5", {"discretization.degree=[4,4,5]"}, SOLID_LAYERS, 4

static const struct verify_subject entries[] = {
    VERIFY_PLATES(VERIFY_PLATES_CURED),
    {"triangles", VERIFY_PLATES_CURED},
    VERIFY_MESHES(VERIFY_PLATES_CURED, {16, 32}, {16, 32}, .mark = true,
                  .changed = "2 % of 16x16, then of 24x24, where the mode of 1 by 2 waves "
                             "is up to 4.7 and 2.02 % off"),
    {"mass_spring", 0, "isotropic at nu = 1/3"},
    {"iga_linear", SOLID, .mark = true,
     .changed = "of r = 3 through the thickness, which nearly incompressible plates miss"},
    {NULL}};
static const struct verify_field field = {entries, CONTESTANT_SMALL};

static bool is(const struct verify_subject *s, const char *text)
{
    return !strcmp(reference_text(s->sheet->table, s->at, "case"), text);
}

static double truth_of(const struct verify_subject *s)
{
    return verify_number(s, s->layers ? "exact3D_body" : "kirchhoff");
}

/* Returns w D / (q a^4) of the centre, or omega a^2 sqrt(rho h / D). */
static double measure(struct verify_trial *t, void *context)
{
    const double h = verify_number(t->subject, "h_over_a");
    const double nu = verify_number(t->subject, "nu"), young = 1e5, density = 0.05;
    const double D = young * h * h * h / (12 * (1 - nu * nu));
    const double unit = sqrt(D / (density * h)), truth = truth_of(t->subject);
    double xyz[3] = {0}, omega[MODES], value = INFINITY;

    (void)context;
    verify_trial_set(t,
                     "sheet.thickness=%.17g; material.poisson=%.17g; gravity=[0,0,%.17g]",
                     h, nu, -GAMMA * D / (density * h));
    if (is(t->subject, "unif")) {
        verify_trial_equilibrium(t, 1, (double[]){0.5, 0.5, 0.5}, xyz);
        return -xyz[2] / GAMMA;
    }
    verify_trial_modes(t, false, MODES, omega);
    for (int k = 0; t->lived && k < MODES; k++)
        if (fabs(omega[k] / unit - truth) < fabs(value - truth))
            value = omega[k] / unit;
    return value;
}

static void add_row(struct verify_subject *s)
{
    const double h = verify_number(s, "h_over_a"), nu = verify_number(s, "nu");
    const bool uniform = is(s, "unif");

    if (is(s, "sin11") || /* no scene has that load */
        (s->sheet->quick && (nu != 0.3 || h != (uniform ? 0.001 : 0.1))))
        return;
    if ((s->layers == 2 && h > ONE_LAYER) || (s->layers == SOLID_LAYERS && h < SOLID_LOCKS))
        s->tolerance = NAN;
    if (!s->mark)
        verify_subject_square(s, 8, 16);
    struct verify_trial t = verify_trial_of(s, "navier", "%s, h/a = %g, nu = %g",
                                            uniform           ? "w D / (q a^4)"
                                            : is(s, "freq11") ? "lambda 1,1"
                                                              : "lambda 1,2",
                                            h, nu);
    verify_trial_nets(&t, measure, NULL, truth_of(s), BAR);
}

const struct verify_check verify_navier = {
    {"navier", "simply supported plates, thick to thin: deflection, frequencies"},
    "three-dimensional elasticity for solids, Kirchhoff's plate for surfaces, "
    "tests/reference/navier_plate.csv",
    "navier_plate",
    .slow = true,
    .parts = {{&field, add_row}}};

#include <math.h>

#include "bench/truth/truth.h"
#include "bench/verify/checks/verify_plates.h"

/* Returns a weight small enough that every model's answer is that of linear theory: slopes
 * of 1e-3 change a strip by 1e-6 (heavy_elastica.csv), and a plate that bends two ways, as
 * any does with nu > 0, stretches by (deflection / thickness)^2 (von Karman), here 0.05. */
static double gamma_of(double slenderness)
{
    return fmin(0.01, 0.4 * slenderness);
}

/* h / L from which a surface without transverse shear is no model of a plate. */
static const double THICK = 0.1;

/* Claim for the paper's own net, 10 x 10 x 2, cured. */
#define ASKED 0.02, "asked of the paper's net"

/* Large displacements must do as well where they are small. */
static const struct verify_subject entries[] = {
    VERIFY_PLATES(ASKED),
    {"triangles", ASKED},
    {"mass_spring", 0, "isotropic at nu = 1/3"},
    {"iga_selective", ASKED},
    {"hex_incompatible", 0, VERIFY_PLATES_SHEAR, {16, 32}},
    {"shell_3,shell_selective_3", VERIFY_PLATES_THEORY, {7, 10}},
    {NULL}};
static const struct verify_field field = {entries, CONTESTANT_SMALL};

/* --- Kirchhoff's plate: w D / (q L^4) at the middle of the free edge. */

static const double hs[] = {1e-1, 1e-3, 1e-5, 1e-2, 1e-4}, nus[] = {0.3, 0, 0.49};
enum { HS = 5, HS_NUS = 15 };

static double measure_tip(struct verify_trial *t, void *context)
{
    const int at = t->subject->at;
    const double young = 1e5, h = hs[at % HS], nu = nus[at / HS];
    const double D = young * h * h * h / (12 * (1 - nu * nu)), gamma = gamma_of(h);
    double xyz[3] = {0};

    (void)context;
    verify_trial_set(t, "sheet.thickness=%.17g; material.poisson=%.17g; material.density=1",
                     h, nu);
    verify_trial_set(t, "gravity=[0,0,%.17g]", -gamma * D / h);
    verify_trial_tip(t, xyz);
    return -xyz[2] / gamma;
}

/* Judges the tip. The bar is the relative change by the last quarter of the terms; h / L is
 * added for solids, which are no Kirchhoff plates: shear adds some (h/L)^2, and near free
 * and clamped edges, over a width h, stresses differ. */
static void add_tip(struct verify_subject *s)
{
    const double h = hs[s->at % HS], nu = nus[s->at / HS];
    static double kept = NAN, tip, fewer; /* the last nu, its tip by all and fewer terms */
    enum { TERMS = 40 };

    if (s->sheet->quick && s->at >= 3)
        return;
    if (nu != kept &&
        !(verify_sheet_holds(s->sheet, truth_plate_coefficient(nu, TERMS, &tip)) &&
          verify_sheet_holds(s->sheet, truth_plate_coefficient(nu, TERMS * 3 / 4, &fewer))))
        return;
    kept = nu;
    const double bar = fabs(tip - fewer) / tip;
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "tip w D / (q L^4), h/L = %g, nu = %g", h, nu);
    verify_trial_nets(&t, measure_tip, NULL, tip, s->layers ? bar + h : bar);
}

/* --- Three-dimensional elasticity: stored fields of FreeFEM. */

/* Returns the rms difference of one net's field, of the rms of the truth's. The load is
 * that of gamma_of, the shifts are scaled back. */
static double measure_field(struct verify_trial *t, void *context)
{
    const struct verify_subject *s = t->subject;
    const double h = verify_note(s, "thickness"), nu = verify_note(s, "poisson");
    const double gravity = verify_note(s, "gravity");
    const double scale = verify_note(s, "density") * gravity * 12 * (1 - nu * nu) /
                         (verify_note(s, "young") * h * h) / gamma_of(h);
    double xyz[VERIFY_PLATES_POINTS][3] = {{0}};

    verify_plates_physics(s->sheet, &t->settings);
    verify_trial_set(t, "gravity=[0,0,%.17g]", -gravity / scale);
    verify_trial_equilibrium(t, VERIFY_PLATES_POINTS, verify_plates_points(), xyz[0]);
    return verify_plates_error(context, 0, xyz, scale, &t->row->bar);
}

static void add_field(struct verify_subject *s)
{
    static const char *const names[] = {
        "freefem_static_h10mm", "freefem_static_h100mm_nu00", "freefem_static_h100mm_nu03",
        "freefem_static_h100mm_nu049"};
    struct freefem_field f;

    if ((s->sheet->quick && s->at >= 2) || !verify_plates_read(s->sheet, names[s->at], &f))
        return;
    const double h = verify_note(s, "thickness");
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "field by FreeFEM, h/L = %g, nu = %g", h,
                        verify_note(s, "poisson"));
    if (!verify_trial_nets(&t, measure_field, &f, NAN, NAN))
        return;
    if (t.row->verdict == VERDICT_MISSED && s->layers == 2)
        verify_row_note(t.row,
                        "one layer in plane stress thins at the clamp, over a width h, "
                        "where a solid cannot: no net mends that");
    if (!s->layers && h >= THICK)
        verify_row_end(t.row, VERDICT_OUT_OF_RANGE, "a theory of thin sheets");
}

const struct verify_check verify_cantilever = {
    {"cantilever", "tip of a plate under its weight, linear, h/L from 1e-1 to 1e-5"},
    "Kirchhoff's plate by Ritz's method, fem_ref/kirchhoff.h; error bar: what its last "
    "functions change, and h/L for solids; three-dimensional fields by FreeFEM, "
    "tests/reference/freefem_static_*.csv, error: rms, of the field's",
    .parts = {{&field, add_tip, HS_NUS}, {&field, add_field, 4}}};

/* A square plate, clamped along one edge, under its own weight in linear theory: against
 * Kirchhoff's plate at any thickness, and against three-dimensional elasticity.
 */
#include <math.h>

#include "bench/truth/truth.h"
#include "bench/verify/checks/verify_plates.h"

/* Weight small enough that every model's answer is that of linear theory: slopes of 1e-3
 * change a strip by 1e-6 (heavy_elastica.csv), and a plate that bends two ways, as any does
 * with nu > 0, stretches by the square of deflection / thickness (von Karman), here 0.05.
 */
static double gamma_of(double slenderness)
{
    return fmin(0.01, 0.4 * slenderness);
}

/* h / L from which a surface without transverse shear is no model of a plate. */
static const double THICK = 0.1;

/* 2 % are asked of the paper's own net, 10 x 10 x 2, cured. */
#define ASKED 0.02, "asked of the paper's net"

/* As thick at the clamp as a solid. */
#define CLAMPED                                                                            \
    {                                                                                      \
        "discretization.remedy=clamped"                                                    \
    }

/* Large displacements must do as well where they are small. */
static const struct verify_entry entries[] = {
    VERIFY_PLATES(ASKED),
    {"triangles", ASKED},
    {"mass_spring", 0, "isotropic at nu = 1/3"},
    {"iga_reduced", ASKED},
    {"iga_selective", ASKED},
    {"iga_selective_linear", ASKED, {0}, {0}, 0, "clamped", CLAMPED},
    {"iga_selective_linear_3", ASKED, {0}, {0}, 0, "clamped", CLAMPED},
    {"hex_incompatible", 0, VERIFY_PLATES_SHEAR, {16, 32}},
    {"shell_3", VERIFY_PLATES_THEORY, {7, 10}},
    {"shell_selective_3", VERIFY_PLATES_THEORY, {7, 10}},
    {NULL}};
static const struct verify_field field = {entries, CONTESTANT_SMALL};

/* --- Kirchhoff's plate. */

/* Tip w D / (q L^4), and what the last quarter of the terms changes of it, relative. */
static enum status kirchhoff_tip(double nu, double *tip, double *bar)
{
    enum { TERMS = 40 };
    enum status st;
    double fewer;

    TRY(truth_plate_coefficient(nu, TERMS * 3 / 4, &fewer));
    TRY(truth_plate_coefficient(nu, TERMS, tip));
    *bar = fabs(*tip - fewer) / *tip;
out:
    return st;
}

struct thin {
    double h, nu;
};

/* w D / (q L^4) at the middle of the free edge. */
static double measure_tip(struct verify_trial *t, void *context)
{
    const struct thin *p = context;
    const double young = 1e5, h = p->h, nu = p->nu;
    const double D = young * h * h * h / (12 * (1 - nu * nu)), gamma = gamma_of(h);
    double xyz[3] = {0};

    settings_number(&t->settings, "sheet.thickness", h);
    settings_number(&t->settings, "material.poisson", nu);
    settings_numbers(&t->settings, "gravity", 3, (double[]){0, 0, -gamma * D / h});
    settings_set(&t->settings, "material.density=1");
    verify_trial_tip(t, xyz);
    return -xyz[2] / gamma;
}

static void run_kirchhoff(struct verify_sheet *sheet, double nu)
{
    static const double hs[] = {1e-1, 1e-3, 1e-5, 1e-2, 1e-4};
    struct verify_subject s;
    double tip = NAN, bar = NAN;

    if (!verify_sheet_holds(sheet, kirchhoff_tip(nu, &tip, &bar)))
        return;
    for (int i = 0; i < (sheet->quick ? 3 : 5); i++)
        for (int k = 0; verify_sheet_next(sheet, &field, &k, &s);) {
            struct thin p = {hs[i], nu};
            struct verify_trial t = verify_trial_of(
                &s, "cantilever", "tip w D / (q L^4), h/L = %g, nu = %g", p.h, p.nu);
            /* A solid is no Kirchhoff plate: shear adds some (h/L)^2, and near free and
             * clamped edges, over a width h, stresses differ; h / L in all. */
            verify_trial_nets(&t, measure_tip, &p, tip, s.layers ? bar + p.h : bar);
        }
}

/* --- Three-dimensional elasticity: stored fields of FreeFEM. */

static double rms(double sum)
{
    return sqrt(sum / VERIFY_PLATES_POINTS);
}

/* rms of the difference of one net's field, of the rms of the truth's. The load is that of
 * gamma_of, the shifts are scaled back. */
static double measure_field(struct verify_trial *t, void *context)
{
    const struct freefem_field *f = context;
    const struct reference *table = t->subject->sheet->table;
    const double h = truth_table_note(table, "thickness");
    const double nu = truth_table_note(table, "poisson");
    const double gravity = truth_table_note(table, "gravity");
    const double scale = truth_table_note(table, "density") * gravity * 12 * (1 - nu * nu) /
                         (truth_table_note(table, "young") * h * h) / gamma_of(h);
    double uvw[VERIFY_PLATES_POINTS][3], xyz[VERIFY_PLATES_POINTS][3] = {{0}};

    verify_plates_points(uvw);
    verify_plates_physics(t->subject->sheet, &t->settings);
    settings_numbers(&t->settings, "gravity", 3, (double[]){0, 0, -gravity / scale});
    verify_trial_equilibrium(t, VERIFY_PLATES_POINTS, uvw[0], xyz[0]);
    return rms(verify_plates_apart(f, 0, xyz, scale)) / rms(verify_plates_moved(f, 0));
}

static void add_field(const struct verify_subject *s, struct freefem_field *f)
{
    const double h = truth_table_note(s->sheet->table, "thickness");
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "field by FreeFEM, h/L = %g, nu = %g", h,
                        truth_table_note(s->sheet->table, "poisson"));

    if (!verify_trial_nets(&t, measure_field, f, NAN,
                           f->error[0] / rms(verify_plates_moved(f, 0))))
        return;
    if (t.row->verdict == VERIFY_MISSED && s->layers == 2)
        verify_row_note(t.row,
                        "one layer in plane stress thins at the clamp, over a width h, "
                        "where a solid cannot: no net mends that");
    if (!s->layers && h >= THICK)
        verify_row_end(t.row, VERIFY_OUT_OF_RANGE, "a theory of thin sheets");
}

static void run(struct verify_sheet *sheet)
{
    static const double nus[] = {0.3, 0, 0.49};
    static const char *const names[] = {
        "freefem_static_h10mm", "freefem_static_h100mm_nu00", "freefem_static_h100mm_nu03",
        "freefem_static_h100mm_nu049"};
    struct verify_subject s;
    struct freefem_field f;

    for (int n = 0; n < (sheet->quick ? 1 : 3); n++)
        run_kirchhoff(sheet, nus[n]);
    for (int n = 0; n < (sheet->quick ? 2 : 4) && verify_plates_read(sheet, names[n], &f);
         n++)
        for (int k = 0; verify_sheet_next(sheet, &field, &k, &s);)
            add_field(&s, &f);
}

const struct verify_check verify_cantilever = {
    .item = {"cantilever",
             "tip of a plate under its weight, linear, h/L from 1e-1 to 1e-5"},
    .source =
        "Kirchhoff's plate by Ritz's method, fem_ref/kirchhoff.h; error bar: what its "
        "last functions change, and h/L for solids; "
        "three-dimensional fields by FreeFEM, tests/reference/freefem_static_*.csv, "
        "error: rms, of the field's",
    .run = run,
};

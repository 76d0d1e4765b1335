/* A square plate, clamped along one edge, under its own weight in linear theory: against
 * Kirchhoff's plate at any thickness, and against three-dimensional elasticity.
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/truth/truth_plate.h"
#include "bench/verify/verify_net.h"

extern const struct verify_check verify_cantilever;

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
#define ASKED                                                                              \
    {                                                                                      \
        0.02, "asked of the paper's net"                                                   \
    }
#define THEORY                                                                             \
    {                                                                                      \
        0.01, "half of what is asked of solids: nothing in it can lock"                    \
    }

static const struct verify_claim claims[VERIFY_PLATES] = {
    [VERIFY_PLATE_NONE] = {0, "the paper's: locks"},
    [VERIFY_PLATE_NONE_3] = {0, "locks in thickness: (1 - 2 nu) / (1 - nu)^2"},
    [VERIFY_PLATE_REDUCED] = ASKED,
    [VERIFY_PLATE_REDUCED_3] = ASKED,
    [VERIFY_PLATE_SELECTIVE] = ASKED,
    [VERIFY_PLATE_SELECTIVE_3] = ASKED,
    [VERIFY_PLATE_HEX] = {0, "the paper's: locks"},
    [VERIFY_PLATE_INCOMPATIBLE] = {0, "nothing frees twisting from shear in thin ones"},
    [VERIFY_PLATE_SHELL] = THEORY,
    [VERIFY_PLATE_SHELL_3] = THEORY,
    [VERIFY_PLATE_LARGE_REDUCED] = ASKED,
    [VERIFY_PLATE_LARGE_SELECTIVE] = ASKED,
    [VERIFY_PLATE_LARGE_INCOMPATIBLE] = {0,
                                         "nothing frees twisting from shear in thin ones"},
    [VERIFY_PLATE_LARGE_SHELL] = THEORY,
    [VERIFY_PLATE_SPRINGS] = {0, "isotropic at nu = 1/3"},
};

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

/* w D / (q L^4) at the middle of the free edge. */
static enum status measure_tip(struct verify_row *row, const struct verify_series *plate,
                               int net, double h, double nu, double *value, bool *lived,
                               struct message *why)
{
    const double tip[3] = {1, 0.5, 0.5}, young = 1e5;
    double D = young * h * h * h / (12 * (1 - nu * nu)), xyz[3] = {0}, gamma = gamma_of(h);
    char thickness[64], poisson[64], gravity[64];
    struct verify_net n;

    verify_net_make(plate, net, &n);
    const char *settings[] = {thickness, poisson, gravity, "material.density=1",
                              n.points,  NULL};
    snprintf(thickness, sizeof thickness, "sheet.thickness=%.17g", h);
    snprintf(poisson, sizeof poisson, "material.poisson=%.17g", nu);
    snprintf(gravity, sizeof gravity, "gravity=[0,0,%.17g]", -gamma * D / h);
    enum status st = verify_equilibrium(row, &n.subject, "cantilever", settings, 1, tip,
                                        xyz, lived, why);
    *value = -xyz[2] / gamma;
    return st;
}

static enum status add_tip(struct verify_sheet *sheet, const struct verify_series *plate,
                           double h, double nu, double truth, double bar,
                           struct message *why)
{
    enum status st = STATUS_OK;
    double error[2], value = NAN;
    struct verify_net fine;

    verify_net_make(plate, 1, &fine);
    struct verify_row *row =
        verify_add(sheet, &fine.subject, "tip w D / (q L^4), h/L = %g, nu = %g", h, nu);
    for (int net = 0; net < VERIFY_NETS; net++) {
        bool lived;
        TRY(measure_tip(row, plate, net, h, nu, &value, &lived, why));
        if (!lived)
            return STATUS_OK;
        error[net] = fabs(value / truth - 1);
    }
    /* A solid is no Kirchhoff plate: shear adds some (h/L)^2, and near free and clamped
     * edges, over a width h, stresses differ; h / L in all. */
    if (plate->layers)
        bar += h;
    verify_judge(row, value, truth, bar);
    row->order = verify_net_order(plate, error, bar);
out:
    return st;
}

static enum status run_kirchhoff(struct verify_sheet *sheet, struct message *why)
{
    static const double nus[] = {0.3, 0, 0.49}, hs[] = {1e-1, 1e-3, 1e-5, 1e-2, 1e-4};
    enum status st = STATUS_OK;
    bool quick = verify_quick(sheet);

    for (int n = 0; n < (quick ? 1 : 3); n++) {
        double tip, bar;
        TRY(kirchhoff_tip(nus[n], &tip, &bar));
        for (int i = 0; i < (quick ? 3 : 5); i++)
            for (int p = 0; p < VERIFY_PLATES; p++) {
                struct verify_series plate = verify_net_plate(p, claims[p]);
                if (verify_wanted(sheet, &plate.subject))
                    TRY(add_tip(sheet, &plate, hs[i], nus[n], tip, bar, why));
            }
    }
out:
    return st;
}

/* --- Three-dimensional elasticity: stored fields of FreeFEM. */

enum { FIELD_POINTS = 144 };

struct field {
    double thickness, young, poisson, density, gravity;
    double error; /* rms [m]                                                            */
    int count;
    double uvw[FIELD_POINTS][3], shift[FIELD_POINTS][3]; /* [1], [m]                   */
    double rms;                                          /* of the shifts           [m] */
};

static double note_number(const struct reference *table, const char *key)
{
    const char *text = reference_note(table, key);

    return text ? strtod(text, NULL) : NAN;
}

static enum status read_field(const char *name, struct field *f, struct message *why)
{
    static const char *const column[] = {"dx", "dy", "dz"};
    enum status st;
    struct reference *table = NULL;
    double sum = 0;

    TRY(verify_reference(name, &table, why));
    *f = (struct field){.thickness = note_number(table, "thickness"),
                        .young = note_number(table, "young"),
                        .poisson = note_number(table, "poisson"),
                        .density = note_number(table, "density"),
                        .gravity = note_number(table, "gravity"),
                        .error = note_number(table, "mesh_error_m")};
    for (int n = 0; n < reference_rows(table) && n < FIELD_POINTS; n++, f->count++) {
        f->uvw[n][0] = reference_number(table, n, "u");
        f->uvw[n][1] = reference_number(table, n, "v");
        f->uvw[n][2] = 0.5;
        for (int i = 0; i < 3; i++) {
            f->shift[n][i] = reference_number(table, n, column[i]);
            sum += f->shift[n][i] * f->shift[n][i];
        }
    }
    f->rms = sqrt(sum / f->count);
out:
    reference_close(table);
    return st;
}

/* rms of the difference of one net's field, of the rms of the truth's. The load is that of
 * gamma_of, the shifts are scaled back. */
static enum status measure_field(struct verify_row *row, const struct verify_series *plate,
                                 int net, const struct field *f, double *error, bool *lived,
                                 struct message *why)
{
    enum status st;
    struct verify_net n;
    double h = f->thickness, sum = 0, (*xyz)[3] = calloc(FIELD_POINTS, sizeof *xyz);
    double scale = f->density * f->gravity * 12 * (1 - f->poisson * f->poisson) /
                   (f->young * h * h) / gamma_of(h);
    char sheet[64], young[64], poisson[64], density[64], gravity[64];
    const char *settings[] = {sheet, young, poisson, density, gravity, n.points, NULL};

    if (!xyz)
        return STATUS_MEMORY;
    verify_net_make(plate, net, &n);
    snprintf(sheet, sizeof sheet, "sheet.thickness=%.17g", h);
    snprintf(young, sizeof young, "material.young=%.17g", f->young);
    snprintf(poisson, sizeof poisson, "material.poisson=%.17g", f->poisson);
    snprintf(density, sizeof density, "material.density=%.17g", f->density);
    snprintf(gravity, sizeof gravity, "gravity=[0,0,%.17g]", -f->gravity / scale);
    TRY(verify_equilibrium(row, &n.subject, "cantilever", settings, f->count, f->uvw[0],
                           xyz[0], lived, why));
    for (int k = 0; k < f->count; k++)
        for (int i = 0; i < 3; i++) {
            double rest = i < 2 ? f->uvw[k][i] : 0;
            double apart = (xyz[k][i] - rest) * scale - f->shift[k][i];
            sum += apart * apart;
        }
    *error = sqrt(sum / f->count) / f->rms;
out:
    free(xyz);
    return st;
}

static enum status add_field(struct verify_sheet *sheet, const struct verify_series *plate,
                             const struct field *f, struct message *why)
{
    enum status st = STATUS_OK;
    double error[VERIFY_NETS], bar = f->error / f->rms;
    struct verify_net fine;

    verify_net_make(plate, 1, &fine);
    struct verify_row *row =
        verify_add(sheet, &fine.subject, "field by FreeFEM, h/L = %g, nu = %g",
                   f->thickness, f->poisson);
    for (int net = 0; net < VERIFY_NETS; net++) {
        bool lived;
        TRY(measure_field(row, plate, net, f, &error[net], &lived, why));
        if (!lived)
            return STATUS_OK;
    }
    verify_judge_error(row, error[1], bar);
    row->order = verify_net_order(plate, error, bar);
    if (row->verdict == VERIFY_MISSED && plate->layers == 2)
        verify_note(row, "one layer in plane stress thins at the clamp, over a width h, "
                         "where a solid cannot: no net mends that");
    if (!plate->layers && f->thickness >= THICK)
        verify_out_of_range(row, "a theory of thin sheets");
out:
    return st;
}

static enum status run_fields(struct verify_sheet *sheet, struct message *why)
{
    static const char *const names[] = {
        "freefem_static_h10mm", "freefem_static_h100mm_nu00", "freefem_static_h100mm_nu03",
        "freefem_static_h100mm_nu049"};
    enum status st = STATUS_OK;
    struct field *f = malloc(sizeof *f);

    if (!f)
        return STATUS_MEMORY;
    for (size_t n = 0; n < (verify_quick(sheet) ? 2 : sizeof names / sizeof *names); n++) {
        TRY(read_field(names[n], f, why));
        for (int p = 0; p < VERIFY_PLATES; p++) {
            struct verify_series plate = verify_net_plate(p, claims[p]);
            if (verify_wanted(sheet, &plate.subject))
                TRY(add_field(sheet, &plate, f, why));
        }
    }
out:
    free(f);
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;

    TRY(run_kirchhoff(sheet, why));
    TRY(run_fields(sheet, why));
out:
    return st;
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

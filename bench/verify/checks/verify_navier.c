/* Simply supported square plates, thick to thin, in linear theory: deflection under their
 * own weight and the first two flexural frequencies, against three-dimensional elasticity,
 * and for surfaces against Kirchhoff's plate. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/verify/verify_net.h"

extern const struct verify_check verify_navier;

/* Where every model's answer is that of linear theory. */
static const double GAMMA = 0.01;
/* Of the table: ten digits, uniform loads a series to 6e-7. */
static const double BAR = 1e-6;
/* Modes computed: those in the plane lie about, the one nearest to the truth counts. */
enum { MODES = 8 };

#define CURED                                                                              \
    {                                                                                      \
        0.02, "what is asked of the cured plate's deflection"                              \
    }
#define THEORY                                                                             \
    {                                                                                      \
        0.01, "half of what is asked of solids: nothing in it can lock"                    \
    }

static const struct verify_claim claims[VERIFY_PLATES] = {
    [VERIFY_PLATE_NONE] = {0, "the paper's: locks"},
    [VERIFY_PLATE_NONE_3] = {0, "locks in thickness: (1 - 2 nu) / (1 - nu)^2"},
    [VERIFY_PLATE_REDUCED] = CURED,
    [VERIFY_PLATE_REDUCED_3] = CURED,
    [VERIFY_PLATE_SELECTIVE] = CURED,
    [VERIFY_PLATE_SELECTIVE_3] = CURED,
    [VERIFY_PLATE_HEX] = {0, "the paper's: locks"},
    [VERIFY_PLATE_INCOMPATIBLE] = {0, "nothing frees twisting from shear in thin ones"},
    [VERIFY_PLATE_SHELL] = THEORY,
    [VERIFY_PLATE_SHELL_3] = THEORY,
    [VERIFY_PLATE_SPRINGS] = {0, "isotropic at nu = 1/3"},
};

/* One layer of linear functions has no shear correction: a sixth of the shear deflection,
 * which is some 5 (h/a)^2, is missing; 0.2 % up to here. */
static const double ONE_LAYER = 0.05;

/* Elasticity itself: degree 5 through the thickness leaves (h/a)^10 of it, the in-plane net
 * the corners' r^4 log r; claims 1e-3 down to where degree 4 begins to lock. */
enum { SOLID_LAYERS = 6 };
static const struct verify_series solid = {
    .subject = {"iga, none, p = 4, r = 5", "iga",
                "discretization.kinematics=linear discretization.degree=[4,4,5]", 1e-3,
                "elasticity itself, on five spans a half wave"},
    .along = {8, 14},
    .across = {8, 14},
    .layers = SOLID_LAYERS,
    .degree = 4};
static const double SOLID_LOCKS = 0.01;

struct plate {
    const char *kind; /* unif, freq11, freq12                                          */
    double h, nu, kirchhoff, exact;
};

/* w D / (q a^4) of the centre, or omega a^2 sqrt(rho h / D). */
static enum status measure(struct verify_row *row, const struct verify_series *series,
                           int net, const struct plate *p, double truth, double *value,
                           bool *lived, struct message *why)
{
    const double centre[3] = {0.5, 0.5, 0.5}, young = 1e5, density = 0.05;
    double D = young * p->h * p->h * p->h / (12 * (1 - p->nu * p->nu)), xyz[3] = {0};
    double unit = sqrt(D / (density * p->h)), omega[MODES];
    char thickness[64], poisson[64], gravity[64];
    struct verify_net n;
    enum status st;

    verify_net_make(series, net, &n);
    const char *settings[] = {thickness, poisson, gravity, n.points, NULL};
    snprintf(thickness, sizeof thickness, "sheet.thickness=%.17g", p->h);
    snprintf(poisson, sizeof poisson, "material.poisson=%.17g", p->nu);
    snprintf(gravity, sizeof gravity, "gravity=[0,0,%.17g]", -GAMMA * D / (density * p->h));
    if (!strcmp(p->kind, "unif")) {
        st = verify_equilibrium(row, &n.subject, "navier", settings, 1, centre, xyz, lived,
                                why);
        *value = -xyz[2] / GAMMA;
        return st;
    }
    st = verify_modes(row, &n.subject, "navier", settings, MODES, omega, lived, why);
    *value = INFINITY;
    for (int k = 0; *lived && k < MODES; k++)
        if (fabs(omega[k] / unit - truth) < fabs(*value - truth))
            *value = omega[k] / unit;
    return st;
}

static enum status add_row(struct verify_sheet *sheet, struct verify_series *series,
                           const struct plate *p, struct message *why)
{
    enum status st = STATUS_OK;
    const double truth = series->layers ? p->exact : p->kirchhoff;
    double value = NAN, error[VERIFY_NETS];
    struct verify_net fine;

    if ((series->layers == 2 && p->h > ONE_LAYER) ||
        (series->layers == SOLID_LAYERS && p->h < SOLID_LOCKS))
        series->subject.tolerance = NAN;
    verify_net_make(series, 1, &fine);
    struct verify_row *row = verify_add(sheet, &fine.subject, "%s, h/a = %g, nu = %g",
                                        !strcmp(p->kind, "unif")     ? "w D / (q a^4)"
                                        : !strcmp(p->kind, "freq11") ? "lambda 1,1"
                                                                     : "lambda 1,2",
                                        p->h, p->nu);
    for (int net = 0; net < VERIFY_NETS; net++) {
        bool lived;
        TRY(measure(row, series, net, p, truth, &value, &lived, why));
        if (!lived)
            return STATUS_OK;
        error[net] = fabs(value / truth - 1);
    }
    verify_judge(row, value, truth, BAR);
    row->order = verify_net_order(series, error, BAR);
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;

    TRY(verify_reference("navier_plate", &table, why));
    for (int n = 0; n < reference_rows(table); n++) {
        const struct plate p = {.kind = reference_text(table, n, "case"),
                                .h = reference_number(table, n, "h_over_a"),
                                .nu = reference_number(table, n, "nu"),
                                .kirchhoff = reference_number(table, n, "kirchhoff"),
                                .exact = reference_number(table, n, "exact3D_body")};
        if (!strcmp(p.kind, "sin11") || /* no scene has that load: tests/navier.c */
            (verify_quick(sheet) &&
             (p.nu != 0.3 || p.h != (strcmp(p.kind, "unif") ? 0.1 : 0.001))))
            continue;
        for (int k = 0; k < VERIFY_PLATES_LINEAR + 1; k++) {
            struct verify_series series = solid;
            if (k < VERIFY_PLATES_LINEAR) {
                series = verify_net_plate(k, claims[k]);
                for (int net = 0; net < VERIFY_NETS; net++)
                    series.along[net] = series.across[net] = net ? 16 : 8;
            }
            if (verify_wanted(sheet, &series.subject))
                TRY(add_row(sheet, &series, &p, why));
        }
    }
out:
    reference_close(table);
    return st;
}

const struct verify_check verify_navier = {
    .item = {"navier", "simply supported plates, thick to thin: deflection, frequencies"},
    .source = "three-dimensional elasticity for solids, Kirchhoff's plate for surfaces, "
              "tests/reference/navier_plate.csv",
    .slow = true,
    .run = run,
};

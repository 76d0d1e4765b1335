/* Frequencies of thin rectangular plates with clamped, simply supported and free edges. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/verify/verify_net.h"

extern const struct verify_check verify_frequencies;

/* Of solids: thin enough that shear, rotary inertia and edge layers, some h / a in all, are
 * below what is claimed. */
static const double THICKNESS = 1e-3;
/* Frequencies below this part of the plate's first are rigid motions. */
static const double RIGID = 0.05;
/* Modes of each plate that count, and that are computed: up to six rigid ones. */
enum { MODES = 6, COMPUTED = MODES + 6 };

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
};

/* A plate of the table: its first MODES rows. */
struct plate {
    const char *edges; /* u = 0, v = 0, u = 1, v = 1                                    */
    double nu, width;  /* length 1                                                     */
    double lambda[MODES], bar;
    double hertz[MODES]; /* of NAFEMS' plate; NAN: none                                */
};

static void write_supports(const char *edges, size_t size, char *text)
{
    size_t used = (size_t)snprintf(text, size, "supports=[");
    int count = 0;

    for (int e = 0; e < 4 && used < size; e++)
        if (edges[e] != 'F')
            used += (size_t)snprintf(text + used, size - used, "%s{at: {%c: %d}, fix: %s}",
                                     count++ ? ", " : "", "uv"[e % 2], e / 2,
                                     edges[e] == 'C' ? "xyz"
                                     : e % 2         ? "xz"
                                                     : "yz");
    if (used < size)
        snprintf(text + used, size - used, "]");
}

/* Row of the table -> plate; false if it is not the first row of one. */
static bool read_plate(const struct reference *table, int row, struct plate *p)
{
    if (reference_number(table, row, "mode") != 1)
        return false;
    *p = (struct plate){.edges = reference_text(table, row, "bc"),
                        .nu = reference_number(table, row, "nu"),
                        .width = reference_number(table, row, "Ly")};
    for (int n = 0; n < MODES; n++) {
        p->lambda[n] = reference_number(table, row + n, "lambda");
        p->hertz[n] = reference_number(table, row + n, "f_FV_Hz");
        p->bar = fmax(p->bar, reference_number(table, row + n, "est_err") / p->lambda[n]);
    }
    return true;
}

/* omega L^2 sqrt(rho h / D) of one net, rigid motions left out. */
static enum status measure(struct verify_row *row, const struct verify_series *series,
                           int net, const struct plate *p, double lambda[MODES],
                           bool *lived, struct message *why)
{
    const double young = 1e5, density = 0.05;
    double unit = THICKNESS * sqrt(young / (12 * (1 - p->nu * p->nu) * density));
    double omega[COMPUTED];
    char width[64], poisson[64], supports[512];
    struct verify_net n;

    verify_net_make(series, net, &n);
    const char *settings[] = {width, poisson, supports, n.points, "gravity=[0,0,0]", NULL};
    snprintf(width, sizeof width, "sheet.width=%.17g", p->width);
    snprintf(poisson, sizeof poisson, "material.poisson=%.17g", p->nu);
    write_supports(p->edges, sizeof supports, supports);
    enum status st =
        verify_modes(row, &n.subject, "cantilever", settings, COMPUTED, omega, lived, why);
    for (int k = 0, found = 0; *lived && k < COMPUTED && found < MODES; k++)
        if (omega[k] > RIGID * p->lambda[0] * unit)
            lambda[found++] = omega[k] / unit;
    return st;
}

static double error_of(const struct plate *p, const double *lambda, int mode)
{
    return fabs(lambda[mode] / p->lambda[mode] - 1);
}

static enum status add_plate(struct verify_sheet *sheet, const struct verify_series *series,
                             const struct plate *p, struct message *why)
{
    enum status st = STATUS_OK;
    double lambda[VERIFY_NETS][MODES] = {{0}}, error[VERIFY_NETS];
    double bar = p->bar + (series->layers ? THICKNESS : 0);
    struct verify_net fine;
    int worst = 0;

    verify_net_make(series, 1, &fine);
    struct verify_row *row =
        verify_add(sheet, &fine.subject, "lambda, %s, b/a = %g, nu = %g, worst of %d modes",
                   p->edges, p->width, p->nu, MODES);
    for (int net = 0; net < VERIFY_NETS; net++) {
        bool lived;
        TRY(measure(row, series, net, p, lambda[net], &lived, why));
        if (!lived)
            return STATUS_OK;
    }
    for (int n = 1; n < MODES; n++)
        if (error_of(p, lambda[1], n) > error_of(p, lambda[1], worst))
            worst = n;
    for (int net = 0; net < VERIFY_NETS; net++)
        error[net] = error_of(p, lambda[net], worst);
    verify_judge(row, lambda[1][worst], p->lambda[worst], bar);
    row->order = verify_net_order(series, error, bar);
    if (row->verdict == VERIFY_MISSED && row->order < 0.5)
        verify_note(row, "refinement leaves mode %d where it is: spurious, or one missing",
                    worst + 1);
out:
    return st;
}

/* NAFEMS' plates FV12 (free) and FV16 (cantilever), R0015: 10 m x 10 m x 0.05 m, steel, in
 * Hz; h / a = 1/200. */
static enum status add_nafems(struct verify_sheet *sheet,
                              const struct verify_series *series, const struct plate *p,
                              struct message *why)
{
    static const char *const steel[] = {"sheet.length=10",      "sheet.width=10",
                                        "sheet.thickness=0.05", "material.young=200e9",
                                        "material.poisson=0.3", "material.density=8000",
                                        "gravity=[0,0,0]"};
    enum { STEEL = sizeof steel / sizeof *steel };
    const double pi = acos(-1), slender = 0.05 / 10;
    enum status st;
    const char *settings[STEEL + 3];
    double omega[COMPUTED], worst = -1;
    char supports[512];
    struct verify_net n;
    bool lived;
    int found = 0;

    verify_net_make(series, 1, &n);
    memcpy(settings, steel, sizeof steel);
    settings[STEEL] = supports;
    settings[STEEL + 1] = n.points;
    settings[STEEL + 2] = NULL;
    write_supports(p->edges, sizeof supports, supports);
    struct verify_row *row = verify_add(sheet, &n.subject, "NAFEMS %s [Hz], worst of %d",
                                        *p->edges == 'F' ? "FV12" : "FV16", MODES);
    TRY(verify_modes(row, &n.subject, "cantilever", settings, COMPUTED, omega, &lived,
                     why));
    for (int k = 0; lived && k < COMPUTED && found < MODES; k++) {
        double hertz = omega[k] / (2 * pi), error = fabs(hertz / p->hertz[found] - 1);
        if (hertz < RIGID * p->hertz[0])
            continue;
        if (error > worst) {
            worst = error;
            verify_judge(row, hertz, p->hertz[found],
                         p->bar + (series->layers ? slender : 0));
        }
        found++;
    }
out:
    return st;
}

static enum status add_rows(struct verify_sheet *sheet, const struct plate *p,
                            struct message *why)
{
    enum status st = STATUS_OK;
    const bool nafems =
        (!strcmp(p->edges, "FFFF") || !strcmp(p->edges, "CFFF")) && !isnan(p->hertz[0]);

    for (int both = 0; both < 1 + nafems; both++)
        for (int k = 0; k < VERIFY_PLATES_LINEAR; k++) {
            struct verify_series series = verify_net_plate(k, claims[k]);
            /* The sixth mode has two to three half waves. */
            int points = series.degree == 2 ? 16 : 8;
            for (int net = 0; net < VERIFY_NETS; net++)
                series.along[net] = series.across[net] = points << net;
            if (!verify_wanted(sheet, &series.subject))
                continue;
            if (both)
                TRY(add_nafems(sheet, &series, p, why));
            else
                TRY(add_plate(sheet, &series, p, why));
        }
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;
    struct plate p;

    TRY(verify_reference("leissa_plate_frequencies", &table, why));
    for (int row = 0; row < reference_rows(table); row++) {
        if (!read_plate(table, row, &p))
            continue;
        const bool cheap = p.nu == 0.3 && p.width == 1 &&
                           (!strcmp(p.edges, "CFFF") || !strcmp(p.edges, "SSSS"));
        if (!verify_quick(sheet) || cheap)
            TRY(add_rows(sheet, &p, why));
    }
out:
    reference_close(table);
    return st;
}

const struct verify_check verify_frequencies = {
    .item = {"frequencies", "thin plates with clamped, simply supported and free edges"},
    .source = "Kirchhoff's plate by Ritz's method, "
              "tests/reference/leissa_plate_frequencies.csv; error bar: its own, and h/a = "
              "1e-3 for solids (NAFEMS' plates: 5e-3)",
    .slow = true,
    .run = run,
};

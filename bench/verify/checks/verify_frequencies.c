/* Frequencies of thin rectangular plates with clamped, simply supported and free edges. */
#include <math.h>
#include <string.h>

#include "bench/verify/checks/verify_plates.h"

/* Of solids: thin enough that shear, rotary inertia and edge layers, some h / a in all, are
 * below what is claimed. */
static const double THICKNESS = 1e-3;
/* Frequencies below this part of the plate's first are rigid motions. */
static const double RIGID = 0.05;
/* Modes of each plate that count, and that are computed: up to six rigid ones. */
enum { MODES = 6, COMPUTED = MODES + 6 };

static const struct verify_entry entries[] = {VERIFY_PLATES(VERIFY_PLATES_CURED), {NULL}};
static const struct verify_field field = {entries, CONTESTANT_SMALL};

/* A plate of the table: its first MODES rows. */
struct plate {
    const char *edges; /* u = 0, v = 0, u = 1, v = 1                                    */
    double nu, width;  /* length 1                                                     */
    double lambda[MODES], bar;
    double hertz[MODES]; /* of NAFEMS' plate; NAN: none                                */
};

static void add_supports(const char *edges, struct settings *all)
{
    int count = 0;

    settings_set(all, "supports=[");
    for (int e = 0; e < 4; e++)
        if (edges[e] != 'F')
            settings_more(all, "%s{at: {%c: %d}, fix: %s}", count++ ? ", " : "",
                          "uv"[e % 2], e / 2,
                          edges[e] == 'C' ? "xyz"
                          : e % 2         ? "xz"
                                          : "yz");
    settings_more(all, "]");
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
static bool measure(struct verify_trial *t, const struct plate *p, double lambda[MODES])
{
    const double young = 1e5, density = 0.05;
    double unit = THICKNESS * sqrt(young / (12 * (1 - p->nu * p->nu) * density));
    double omega[COMPUTED];

    settings_number(&t->settings, "sheet.width", p->width);
    settings_number(&t->settings, "material.poisson", p->nu);
    settings_set(&t->settings, "gravity=[0,0,0]");
    add_supports(p->edges, &t->settings);
    verify_trial_modes(t, false, COMPUTED, omega);
    for (int k = 0, found = 0; t->lived && k < COMPUTED && found < MODES; k++)
        if (omega[k] > RIGID * p->lambda[0] * unit)
            lambda[found++] = omega[k] / unit;
    return t->lived;
}

static double error_of(const struct plate *p, const double *lambda, int mode)
{
    return fabs(lambda[mode] / p->lambda[mode] - 1);
}

static void add_plate(struct verify_sheet *sheet, const struct verify_subject *s,
                      const struct plate *p)
{
    double lambda[2][MODES] = {{0}}, error[2];
    const double bar = p->bar + (s->layers ? THICKNESS : 0);
    int worst = 0;
    struct verify_trial t = verify_trial_of(
        sheet, s, "cantilever", "lambda, %s, b/a = %g, nu = %g, worst of %d modes",
        p->edges, p->width, p->nu, MODES);

    for (t.net = 0; t.net < 2; t.net++)
        if (!measure(&t, p, lambda[t.net]))
            return;
    for (int n = 1; n < MODES; n++)
        if (error_of(p, lambda[1], n) > error_of(p, lambda[1], worst))
            worst = n;
    for (int net = 0; net < 2; net++)
        error[net] = error_of(p, lambda[net], worst);
    verify_row_judge(t.row, lambda[1][worst], p->lambda[worst], bar);
    t.row->order = verify_subject_order(s, error, bar);
    if (t.row->verdict == VERIFY_MISSED && t.row->order < 0.5)
        verify_row_note(t.row,
                        "refinement leaves mode %d where it is: spurious, or one missing",
                        worst + 1);
}

/* NAFEMS' plates FV12 (free) and FV16 (cantilever), R0015: 10 m x 10 m x 0.05 m, steel, in
 * Hz; h / a = 1/200. */
static void add_nafems(struct verify_sheet *sheet, const struct verify_subject *s,
                       const struct plate *p)
{
    const double pi = acos(-1), slender = 0.05 / 10;
    double omega[COMPUTED], worst = -1;
    int found = 0;
    struct verify_trial t =
        verify_trial_of(sheet, s, "cantilever", "NAFEMS %s [Hz], worst of %d",
                        *p->edges == 'F' ? "FV12" : "FV16", MODES);

    t.net = 1;
    settings_set(&t.settings, "sheet={length: 10, width: 10, thickness: 0.05}");
    settings_set(&t.settings, "material={young: 200e9, poisson: 0.3, density: 8000}");
    settings_set(&t.settings, "gravity=[0,0,0]");
    add_supports(p->edges, &t.settings);
    verify_trial_modes(&t, false, COMPUTED, omega);
    for (int k = 0; t.lived && k < COMPUTED && found < MODES; k++) {
        double hertz = omega[k] / (2 * pi), error = fabs(hertz / p->hertz[found] - 1);
        if (hertz < RIGID * p->hertz[0])
            continue;
        if (error > worst) {
            worst = error;
            verify_row_judge(t.row, hertz, p->hertz[found],
                             p->bar + (s->layers ? slender : 0));
        }
        found++;
    }
}

static void add_rows(struct verify_sheet *sheet, const struct plate *p)
{
    struct verify_subject s;
    const bool nafems =
        (!strcmp(p->edges, "FFFF") || !strcmp(p->edges, "CFFF")) && !isnan(p->hertz[0]);

    for (int both = 0; both < 1 + nafems; both++)
        for (int k = 0; verify_sheet_next(sheet, &field, &k, &s);) {
            /* The sixth mode has two to three half waves. */
            const int points = s.degree == 2 ? 16 : 8;
            verify_subject_square(&s, points, 2 * points);
            (both ? add_nafems : add_plate)(sheet, &s, p);
        }
}

static void run(struct verify_sheet *sheet)
{
    const struct reference *table = sheet->table;
    struct plate p;

    for (int row = 0; row < reference_rows(table); row++) {
        if (!read_plate(table, row, &p))
            continue;
        const bool cheap = p.nu == 0.3 && p.width == 1 &&
                           (!strcmp(p.edges, "CFFF") || !strcmp(p.edges, "SSSS"));
        if (!sheet->quick || cheap)
            add_rows(sheet, &p);
    }
}

const struct verify_check verify_frequencies = {
    .item = {"frequencies", "thin plates with clamped, simply supported and free edges"},
    .table = "leissa_plate_frequencies",
    .source = "Kirchhoff's plate by Ritz's method, "
              "tests/reference/leissa_plate_frequencies.csv; error bar: its own, and h/a = "
              "1e-3 for solids (NAFEMS' plates: 5e-3)",
    .slow = true,
    .run = run,
};

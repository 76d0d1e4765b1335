#include <math.h>
#include <string.h>

#include "bench/verify/checks/verify_plates.h"

/* Thickness of solids, small enough that shear, rotary inertia and edge layers, some h / a
 * in all, are below what is claimed. */
static const double THICKNESS = 1e-3;
/* Share of the plate's first frequency below which a motion is rigid. */
static const double RIGID = 0.05;
/* Modes of each plate that count, and that are computed: up to six are rigid. */
enum { MODES = 6, COMPUTED = MODES + 6 };

static const struct verify_subject entries[] = {VERIFY_PLATES(VERIFY_PLATES_CURED), {NULL}};
static const struct verify_field field = {entries, CONTESTANT_SMALL};

/* Adds the settings of the plate of length 1, or of NAFEMS' FV12 (free) and FV16
 * (cantilever), R0015, of steel, h / a = 1/200. */
static void add_physics(const struct verify_subject *s, const char *edges, bool nafems,
                        struct verify_trial *t)
{
    if (nafems)
        verify_trial_set(t, "sheet={length: 10, width: 10, thickness: 0.05};"
                            "material={young: 200e9, poisson: 0.3, density: 8000}");
    else
        verify_trial_set(t, "sheet.width=%.17g; material.poisson=%.17g",
                         verify_number(s, "Ly"), verify_number(s, "nu"));
    verify_trial_set(t, "gravity=[0,0,0]; supports=[");
    for (int e = 0, count = 0; e < 4; e++)
        if (edges[e] != 'F')
            settings_more(&t->settings, "%s{at: {%c: %d}, fix: %s}", count++ ? ", " : "",
                          "uv"[e % 2], e / 2,
                          edges[e] == 'C' ? "xyz"
                          : e % 2         ? "xz"
                                          : "yz");
    settings_more(&t->settings, "]");
}

/* Judges omega L^2 sqrt(rho h / D) on two nets; NAFEMS' plates in Hz, on the finer one. */
static void judge(struct verify_subject *s, const char *edges, bool nafems)
{
    const double young = 1e5, density = 0.05, nu = verify_number(s, "nu");
    const double scale = sqrt(young / (12 * (1 - nu * nu) * density));
    const double unit = nafems ? 2 * acos(-1) : THICKNESS * scale;
    double truth[MODES], found[2][MODES] = {{0}}, omega[COMPUTED], bar = 0;
    int worst = 0;
    struct verify_trial t =
        nafems ? verify_trial_of(s, "cantilever", "NAFEMS %s [Hz], worst of %d",
                                 *edges == 'F' ? "FV12" : "FV16", MODES)
               : verify_trial_of(s, "cantilever",
                                 "lambda, %s, b/a = %g, nu = %g, worst of %d modes", edges,
                                 verify_number(s, "Ly"), nu, MODES);

    for (int n = 0; n < MODES; n++) {
        const struct reference *table = s->sheet->table;
        const double lambda = reference_number(table, s->at + n, "lambda");
        truth[n] = nafems ? reference_number(table, s->at + n, "f_FV_Hz") : lambda;
        bar = fmax(bar, reference_number(table, s->at + n, "est_err") / lambda);
    }
    bar += !s->layers ? 0 : nafems ? 0.05 / 10 : THICKNESS;
    for (t.net = nafems; t.net < 2; t.net++) {
        add_physics(s, edges, nafems, &t);
        if (!verify_trial_modes(&t, false, COMPUTED, omega))
            return;
        for (int k = 0, n = 0; k < COMPUTED && n < MODES; k++)
            if (omega[k] > RIGID * truth[0] * unit)
                found[t.net][n++] = omega[k] / unit;
    }
    for (int n = 0; n < MODES; n++) {
        const double error[] = {nafems ? NAN : fabs(found[0][n] / truth[n] - 1),
                                fabs(found[1][n] / truth[n] - 1)};
        if (verify_trial_worst(&t, found[1][n], truth[n], error, bar))
            worst = n;
    }
    if (t.row->verdict == VERDICT_MISSED && t.row->order < 0.5)
        verify_row_note(t.row,
                        "refinement leaves mode %d where it is: spurious, or one missing",
                        worst + 1);
}

/* Adds a plate's row at the first of its modes in the table, and at the second one that of
 * NAFEMS' plate, where it is one. */
static void add_row(struct verify_subject *s)
{
    const int mode = (int)verify_number(s, "mode");
    /* The sixth mode has two to three half waves. */
    const int points = s->degree == 2 ? 16 : 8;

    if (mode > 2)
        return;
    s->at -= mode - 1;
    const char *edges = reference_text(s->sheet->table, s->at, "bc");
    const bool cantilever = !strcmp(edges, "CFFF");
    if (s->sheet->quick && (verify_number(s, "nu") != 0.3 || verify_number(s, "Ly") != 1 ||
                            (!cantilever && strcmp(edges, "SSSS"))))
        return;
    verify_subject_square(s, points, 2 * points);
    if (mode == 1 ||
        (!isnan(verify_number(s, "f_FV_Hz")) && (cantilever || !strcmp(edges, "FFFF"))))
        judge(s, edges, mode == 2);
}

const struct verify_check verify_frequencies = {
    {"frequencies", "thin plates with clamped, simply supported and free edges"},
    "Kirchhoff's plate by Ritz's method, tests/reference/leissa_plate_frequencies.csv; "
    "error bar: its own, and h/a = 1e-3 for solids (NAFEMS' plates: 5e-3)",
    "leissa_plate_frequencies",
    .slow = true,
    .parts = {{&field, add_row}}};

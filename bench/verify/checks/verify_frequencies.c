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

/* The plate; or NAFEMS' FV12 (free) and FV16 (cantilever), R0015, of steel: h / a = 1/200.
 */
static void add_physics(const struct plate *p, bool nafems, struct settings *all)
{
    if (nafems) {
        settings_set(all, "sheet={length: 10, width: 10, thickness: 0.05}");
        settings_set(all, "material={young: 200e9, poisson: 0.3, density: 8000}");
    } else {
        settings_number(all, "sheet.width", p->width);
        settings_number(all, "material.poisson", p->nu);
    }
    settings_set(all, "gravity=[0,0,0]");
    add_supports(p->edges, all);
}

/* Angular frequencies of one net over `unit`; rigid motions, far below the truth's first,
 * are left out. */
static bool measure(struct verify_trial *t, const double *truth, double unit, double *found)
{
    double omega[COMPUTED];

    verify_trial_modes(t, false, COMPUTED, omega);
    for (int k = 0, n = 0; t->lived && k < COMPUTED && n < MODES; k++)
        if (omega[k] > RIGID * truth[0] * unit)
            found[n++] = omega[k] / unit;
    return t->lived;
}

/* omega L^2 sqrt(rho h / D) on two nets; NAFEMS' plates in Hz, on the finer one alone. */
static void add_row(const struct verify_subject *s, const struct plate *p, bool nafems)
{
    const double young = 1e5, density = 0.05, *truth = nafems ? p->hertz : p->lambda;
    const double scale = sqrt(young / (12 * (1 - p->nu * p->nu) * density));
    const double unit = nafems ? 2 * acos(-1) : THICKNESS * scale;
    const double bar = p->bar + (!s->layers ? 0 : nafems ? 0.05 / 10 : THICKNESS);
    double found[2][MODES] = {{0}}, error[MODES][2];
    int worst = 0;
    struct verify_trial t =
        nafems ? verify_trial_of(s, "cantilever", "NAFEMS %s [Hz], worst of %d",
                                 *p->edges == 'F' ? "FV12" : "FV16", MODES)
               : verify_trial_of(s, "cantilever",
                                 "lambda, %s, b/a = %g, nu = %g, worst of %d modes",
                                 p->edges, p->width, p->nu, MODES);

    for (t.net = nafems; t.net < 2; t.net++) {
        add_physics(p, nafems, &t.settings);
        if (!measure(&t, truth, unit, found[t.net]))
            return;
    }
    for (int n = 0; n < MODES; n++) {
        for (int net = 0; net < 2; net++)
            error[n][net] = fabs(found[net][n] / truth[n] - 1);
        worst = error[n][1] > error[worst][1] ? n : worst;
    }
    verify_row_judge(t.row, found[1][worst], truth[worst], bar);
    if (!nafems)
        t.row->order = verify_subject_order(s, error[worst], bar);
    if (t.row->verdict == VERIFY_MISSED && t.row->order < 0.5)
        verify_row_note(t.row,
                        "refinement leaves mode %d where it is: spurious, or one missing",
                        worst + 1);
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
            add_row(&s, p, both);
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

#include <math.h>
#include <stdio.h>

#include "bench/verify/verify_check.h"

/* Claims: 1 % for nonlinear solids, as wherever a strip is heavy; 1e-3 L for shells, whose
 * theory is the truth's own. */
#define SOLID 0.01, NULL
#define SHELL 1e-3, NULL

#define SHEET(h) "sheet.width=0.1", "sheet.thickness=" h
#define CLAMPED  "supports=[{at: {u: 0}, fix: xyz}]"
#define UNDAMPED "damping={kind: none}"
/* clang-format off */
static const struct swing {
    const char *name, *file, *settings[5]; /* NULL ends                                   */
    bool thin;
} swings[] = {
    {"C0, h = 5 mm, undamped", "pendulum_C0_E1e5_h5mm_undamped",
     {SHEET("0.005"), CLAMPED, UNDAMPED}},
    {"A5, h = 1 mm, damped", "pendulum_A5_E1e5_h1mm_damp0.5", {SHEET("0.001"), CLAMPED}, true},
    {"A0, h = 1 mm, undamped", "pendulum_A0_E1e5_h1mm_undamped",
     {SHEET("0.001"), CLAMPED, UNDAMPED}, true},
    {"H5, h = 1 mm, hinged", "pendulum_H5_E1e5_h1mm_damp0.5_hinged", {SHEET("0.001")}, true},
};
/* clang-format on */
enum { SWINGS = sizeof swings / sizeof *swings };

/* Times to 1 s, 10 ms apart, which every step divides. The truths keep their own energy to
 * 1e-9 until 1.2 s. */
enum { TIMES = 100, POINTS = 4 };
static const double APART = 0.01, STEP = 0.0025, BAR = 1e-5;

/* Instead of points along u: the spans of the finer of two nets, on thick and on thin
 * strips (whose bend at the clamp, about sqrt(D / (rho g h L)) long, sets the scale). Those
 * marked have one net and one step only. */
#define ONE    {16, 16}, {3, 3}, .mark = true
#define PLANAR "discretization.degree=[3,2]"
#define EULER  "implicit Euler damps; nothing is claimed of it"
static const struct verify_subject entries[] = {
    {"iga_linear", 0, "the paper's space: locks", ONE},
    {"iga_paper", 0, "the paper's scheme: viscous, not elastic", ONE},
    {"iga_selective_incremental", 0, "stress is forgotten after each step", ONE},
    {"iga_selective", SOLID, {64, 128}, {3, 3}},
    {"iga_selective_3", SOLID, {32, 64}, {4, 4}, .dear = true},
    {"iga_nonlinear_3", SOLID, {32, 64}, {4, 4}},
    {"hex_incompatible", SOLID, {80, 320}, {2, 2}},
    {"shell_3,shell_selective_3", SHELL, {32, 128}, {3, 3}, .settings = {PLANAR}},
    {"triangles", SOLID, {40, 80}, {3, 3}},
    {"mass_spring", 0, EULER, {40, 80}, {3, 3}},
    {"position_based", 0, EULER, {20, 40}, {3, 3}},
    {"projective_dynamics", 0, EULER, {40, 40}, {5, 5}, VERIFY_TO_THE_END},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, "iga_nonlinear,hex_nonlinear", {40, 80}};

static const char *const column[POINTS][2] = {
    {"x1", "z1"}, {"x075", "z075"}, {"x05", "z05"}, {"x025", "z025"}};

/* Reads the positions of a strip 0.1 m wide at all times. */
static bool read_truth(struct verify_sheet *sheet, const char *file, double *time,
                       double (*xyz)[POINTS][3])
{
    if (!verify_sheet_table(sheet, file))
        return false;
    for (int t = 0, row = 0; t < TIMES; t++, row++) {
        time[t] = APART * (t + 1);
        while (row < reference_rows(sheet->table) &&
               fabs(reference_number(sheet->table, row, "t") - time[t]) > 1e-9)
            row++;
        if (row == reference_rows(sheet->table))
            return verify_sheet_holds(sheet,
                                      status_fail(&sheet->why, STATUS_INPUT,
                                                  "%s: no row for %g s", file, time[t]));
        for (int n = 0; n < POINTS; n++) {
            xyz[t][n][0] = reference_number(sheet->table, row, column[n][0]);
            xyz[t][n][1] = 0.05;
            xyz[t][n][2] = reference_number(sheet->table, row, column[n][1]);
        }
    }
    return verify_sheet_sound(sheet);
}

/* Returns the largest distance of a point at any time; L = 1 m. */
static double distance(const void *context, const double *a, const double *b)
{
    double worst = 0;

    (void)context;
    for (const double *end = a + 3 * TIMES * POINTS; a < end; a += 3, b += 3)
        worst = verify_row_worse(
            pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) + pow(a[2] - b[2], 2), worst);
    return sqrt(worst);
}

static void add_rows(struct verify_subject *s)
{
    static const double uvw[POINTS][3] = {
        {1, 0.5, 0.5}, {0.75, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.25, 0.5, 0.5}};
    static double time[TIMES], truth[TIMES][POINTS][3];
    const struct swing *swing = &swings[s->at];
    const int fine = s->along[swing->thin]; /* spans */
    char quantity[VERIFY_TEXT];
    struct verify_trial_refine r = {.scene = "hinge", .settings = swing->settings};

    if (!read_truth(s->sheet, swing->file, time, truth))
        return;
    r.steps = s->mark || s->sheet->quick ? 1 : VERIFY_TRIAL_STEPS, r.step = STEP;
    r.times = TIMES, r.time = time, r.n = POINTS, r.uvw = uvw[0], r.truth = truth[0][0];
    r.measure = distance, r.bar = BAR;
    s->along[0] = fine / 2 + s->degree, s->along[1] = fine + s->degree;
    if (s->mark)
        verify_subject_last(s, 1);
    if (verify_subject_is_linear(s))
        r.beyond = "small strains reach to Gamma = 0.9";
    snprintf(quantity, sizeof quantity, "%s: position / L until %g s", swing->name,
             TIMES * APART);
    verify_trial_refine(s, &r, quantity);
}

const struct verify_check verify_pendulum = {
    {"pendulum", "strips that swing down from level, clamped and hinged"},
    "planar extensible elastica, B-splines of degree 7 in 128 spans, steps of 0.05 ms, "
    "tests/reference/pendulum_*.csv, 1e-5",
    .slow = true,
    .parts = {{&field, add_rows, SWINGS, .every = SWINGS}}};

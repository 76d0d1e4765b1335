/* Strips of nu = 0 that swing down from level under their weight. */
#include <math.h>
#include <stdio.h>

#include "bench/truth/truth_table.h"
#include "bench/verify/verify_check.h"

/* Asked of the nonlinear solid wherever the strip is heavy: 1 %; of a shell, whose theory
 * is the truth's own: 1e-3 L. */
#define SOLID 0.01, NULL
#define SHELL 1e-3, NULL

struct swing {
    const char *name, *file;
    const char *settings[5]; /* NULL ends                                             */
    bool thin, quick;
};

#define SHEET    "sheet.width=0.1"
#define CLAMPED  "supports=[{at: {u: 0}, fix: xyz}]"
#define UNDAMPED "damping={kind: none}"
#define THICK(h) "sheet.thickness=" h
/* clang-format off */
static const struct swing swings[] = {
    {"C0, h = 5 mm, undamped", "pendulum_C0_E1e5_h5mm_undamped",
     {SHEET, CLAMPED, THICK("0.005"), UNDAMPED}, .quick = true},
    {"A5, h = 1 mm, damped", "pendulum_A5_E1e5_h1mm_damp0.5",
     {SHEET, CLAMPED, THICK("0.001")}, .thin = true},
    {"A0, h = 1 mm, undamped", "pendulum_A0_E1e5_h1mm_undamped",
     {SHEET, CLAMPED, THICK("0.001"), UNDAMPED}, .thin = true},
    {"H5, h = 1 mm, hinged", "pendulum_H5_E1e5_h1mm_damp0.5_hinged",
     {SHEET, THICK("0.001")}, .thin = true},
};
/* clang-format on */

/* What the truth's files give, to 1 s: 10 ms apart, which every step divides. Their own
 * energy stays to 1e-9 until 1.2 s. */
enum { TIMES = 100, POINTS = 4 };
static const double APART = 0.01, STEP = 0.0025, BAR = 1e-5;

/* Spans along u of the finer of two nets, on thick and on thin strips (whose bend at the
 * clamp, about sqrt(D / (rho g h L)) long, sets the scale). Marked: one net and one step
 * only. */
#define ONE   {16, 16}, {3, 3}, .mark = true
#define EULER "implicit Euler damps; nothing is claimed of it"
#define TO_THE_END                                                                         \
    .more = "iterated to the end",                                                         \
    .settings = {"discretization.acceleration=chebyshev",                                  \
                 "discretization.iterations=100000", "discretization.tolerance=1e-9"}
static const struct verify_entry entries[] = {
    {"iga_linear", 0, "the paper's space: locks", ONE},
    {"iga_paper", 0, "the paper's scheme: viscous, not elastic", ONE},
    {"iga_reduced_incremental", 0, "stress is forgotten after each step", ONE},
    {"iga_reduced", SOLID, {64, 128}, {3, 3}},
    {"iga_reduced_3", SOLID, {32, 64}, {4, 4}, .dear = true},
    {"iga_selective", SOLID, {64, 128}, {3, 3}, .dear = true},
    {"iga_selective_3", SOLID, {32, 64}, {4, 4}, .dear = true},
    {"iga_nonlinear_3", SOLID, {32, 64}, {4, 4}},
    {"hex_incompatible", SOLID, {80, 320}, {2, 2}},
    {"shell_3", SHELL, {32, 128}, {3, 3}, .settings = {"discretization.degree=[3,2]"}},
    {"shell_selective_3",
     SHELL,
     {32, 128},
     {3, 3},
     .settings = {"discretization.degree=[3,2]"}},
    {"triangles", SOLID, {40, 80}, {3, 3}},
    {"mass_spring", 0, EULER, {40, 80}, {3, 3}},
    {"position_based", 0, EULER, {20, 40}, {3, 3}},
    {"projective_dynamics", 0, EULER, {40, 40}, {5, 5}, TO_THE_END, .dear = true},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, "iga_nonlinear,hex_nonlinear", {40, 80}};

/* Positions at all times, and when; the strip is 0.1 m wide. */
static void read_truth(struct verify_sheet *sheet, const char *file, double *time,
                       double (*xyz)[POINTS][3])
{
    static const char *const column[POINTS][2] = {
        {"x1", "z1"}, {"x075", "z075"}, {"x05", "z05"}, {"x025", "z025"}};
    const bool there = verify_sheet_table(sheet, file);
    const struct reference *table = sheet->table;

    for (int t = 0, row = 0; there && t < TIMES; t++) {
        time[t] = APART * (t + 1);
        while (row < reference_rows(table) &&
               fabs(reference_number(table, row, "t") - time[t]) > 1e-9)
            row++;
        if (row == reference_rows(table)) {
            verify_sheet_holds(sheet, status_fail(&sheet->why, STATUS_INPUT,
                                                  "%s: no row for %g s", file, time[t]));
            return;
        }
        for (int n = 0; n < POINTS; n++) {
            xyz[t][n][0] = reference_number(table, row, column[n][0]);
            xyz[t][n][1] = 0.05;
            xyz[t][n][2] = reference_number(table, row, column[n][1]);
        }
    }
}

/* Largest distance of a point at any time; L = 1 m. */
static double distance(const void *context, const double *a, const double *b)
{
    double worst = 0;

    (void)context;
    for (int n = 0; n < TIMES * POINTS; n++) {
        double far = 0;
        for (int i = 0; i < 3; i++)
            far += pow(a[3 * n + i] - b[3 * n + i], 2);
        worst = verify_row_worse(far, worst);
    }
    return sqrt(worst);
}

/* The two nets of a swing, of spans so far. */
static void take_nets(const struct swing *swing, struct verify_subject *s)
{
    const int fine = s->along[swing->thin];

    s->along[0] = fine / 2 + s->degree;
    s->along[1] = fine + s->degree;
    if (s->mark)
        verify_subject_last(s, 1);
}

static void add_rows(struct verify_subject *s, const struct swing *swing,
                     struct verify_trial_refine *r)
{
    char quantity[VERIFY_TEXT];

    take_nets(swing, s);
    r->beyond = verify_subject_is_linear(s) ? "small strains reach to Gamma = 0.9" : NULL;
    r->steps = s->mark || s->sheet->quick ? 1 : VERIFY_TRIAL_STEPS;
    snprintf(quantity, sizeof quantity, "%s: position / L until %g s", swing->name,
             TIMES * APART);
    verify_trial_refine(s, r, quantity);
}

static void add_swing(struct verify_sheet *sheet, const struct swing *swing)
{
    static const double uvw[POINTS][3] = {
        {1, 0.5, 0.5}, {0.75, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.25, 0.5, 0.5}};
    static double time[TIMES], truth[TIMES][POINTS][3];
    struct verify_trial_refine r = {.scene = "hinge",
                                    .settings = swing->settings,
                                    .step = STEP,
                                    .times = TIMES,
                                    .time = time,
                                    .n = POINTS,
                                    .uvw = uvw[0],
                                    .truth = truth[0][0],
                                    .bar = BAR,
                                    .measure = distance};
    struct verify_subject s;

    read_truth(sheet, swing->file, time, truth);
    for (int n = 0; verify_sheet_next(sheet, &field, &n, &s);)
        add_rows(&s, swing, &r);
}

static void run(struct verify_sheet *sheet)
{
    for (size_t n = 0; n < sizeof swings / sizeof *swings; n++)
        if (swings[n].quick || !sheet->quick)
            add_swing(sheet, &swings[n]);
}

const struct verify_check verify_pendulum = {
    .item = {"pendulum", "strips that swing down from level, clamped and hinged"},
    .source = "planar extensible elastica, B-splines of degree 7 in 128 spans, steps of "
              "0.05 ms, tests/reference/pendulum_*.csv, 1e-5",
    .slow = true,
    .run = run,
};

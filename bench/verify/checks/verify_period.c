/* One bar element that swings along itself under sudden weight: what average acceleration
 * makes of a single frequency. */
#include <math.h>

#include "bench/verify/verify_check.h"

/* The table has 12 digits; positions of 1 m have 11 of a sway of 2e-5 m, each of up to
 * 25000 steps adds its round-off. */
#define PERIOD 1e-6, NULL

/* E A / L against rho A L / 3. */
static const double YOUNG = 1e5, DENSITY = 0.5, WEIGHT = 9.81;

static const struct verify_entry entries[] = {
    {"iga_linear", PERIOD, {2}, {2}, 0, "p = 1", {"discretization.degree=[1,1,1]"}},
    {"hex_linear", PERIOD, {2}},
    {NULL}};
static const struct verify_field field = {
    entries,
    CONTESTANT_LARGE,
    "iga,hex,shell,mass_spring,position_based,projective_dynamics",
    {2},
    {2}};

static const struct verify_entry others[] = {
    {"shell"}, {"mass_spring"}, {"position_based"}, {"projective_dynamics"}, {NULL}};
static const struct verify_field without_mode = {.entry = others};

/* The tip moves by x_n = x_s (1 - cos n theta). n is such that n theta is about a radian
 * from 0 or, for steps beyond the period, from n pi: there cos n theta tells theta best. */
static void add_row(const struct verify_subject *s, double a, double ratio)
{
    const double tip[3] = {1, 0.5, 0.5}, omega = sqrt(3 * YOUNG / DENSITY);
    const double dt = a / omega, still = DENSITY * WEIGHT / (2 * YOUNG);
    const bool beyond = a > 2;
    const double angle = 2 * atan(a / 2), small = beyond ? acos(-1) - angle : angle;
    const int n = (int)fmax(1, round(1 / small));
    const double time = n * dt;
    double xyz[3];
    struct verify_trial t =
        verify_trial_of(s, "cantilever_transient", "frequency / exact, omega dt = %g", a);

    settings_set(&t.settings, "sheet={length: 1, width: 1, thickness: 1}");
    settings_set(&t.settings, "material={young: 1e5, poisson: 0, density: 0.5}");
    settings_set(&t.settings, "gravity=[9.81,0,0]");
    settings_set(&t.settings, "damping={kind: none}");
    settings_print(&t.settings, "time={step: %.17g, end: %.17g}", dt, 2 * dt);
    if (verify_trial_motion(&t, 1, &time, 1, tip, xyz)) {
        double cosine = fmax(-1, fmin(1, 1 - (xyz[0] - 1) / still));
        double theta = acos(beyond && n % 2 ? -cosine : cosine) / n;
        verify_row_judge(t.row, (beyond ? acos(-1) - theta : theta) / a, ratio, 0);
        verify_row_note(t.row, "%d steps", n);
    }
}

static void run(struct verify_sheet *sheet)
{
    const struct reference *table = sheet->table;
    struct verify_subject s;

    for (int k = 0; verify_sheet_next(sheet, &without_mode, &k, &s);)
        verify_row_end(verify_sheet_add(&s, "frequency / exact"), VERIFY_NOT_APPLICABLE,
                       "it has no net with a single mode along itself");
    for (int n = 0; (n = reference_find(table, n, "case", "newmark")) >= 0; n++)
        for (int k = 0; verify_sheet_next(sheet, &field, &k, &s);)
            add_row(&s, reference_number(table, n, "a"), reference_number(table, n, "v1"));
}

const struct verify_check verify_period = {
    .item = {"period", "how average acceleration lengthens a period, at any step"},
    .table = "beam_elastica_cable",
    .source = "2 atan(omega dt / 2) / (omega dt), tests/reference/beam_elastica_cable.csv",
    .run = run,
};

#include <math.h>

#include "bench/verify/verify_check.h"

/* The table has 12 digits. Positions of 1 m resolve 11 digits of a sway of 2e-5 m, and each
 * of up to 25000 steps adds its round-off. */
#define PERIOD 1e-6, NULL

/* omega^2 = (E A / L) / (rho A L / 3) for L = 1. */
static const double YOUNG = 1e5, DENSITY = 0.5, WEIGHT = 9.81;

#define SPRINGS "shell,mass_spring,position_based,projective_dynamics"
static const struct verify_subject entries[] = {
    {"iga_linear", PERIOD, {2}, {2}, 0, "p = 1", {"discretization.degree=[1,1,1]"}},
    {"hex_linear", PERIOD, {2}},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, "iga,hex," SPRINGS, {2}, {2}};

static const struct verify_subject others[] = {{SPRINGS}, {NULL}};
static const struct verify_field without_mode = {others};

static void add_none(struct verify_subject *s)
{
    verify_row_end(verify_sheet_add(s, "frequency / exact"), VERDICT_NOT_APPLICABLE,
                   "it has no net with a single mode along itself");
}

/* Finds theta from the tip's x_n = x_s (1 - cos n theta), with n such that n theta is about
 * a radian from 0 or, for steps beyond the period, from n pi: there it is found best. */
static void add_row(struct verify_subject *s)
{
    const double a = verify_number(s, "a"), ratio = verify_number(s, "v1");
    const double dt = a / sqrt(3 * YOUNG / DENSITY), still = DENSITY * WEIGHT / (2 * YOUNG);
    const bool beyond = a > 2;
    const double angle = 2 * atan(a / 2), small = beyond ? acos(-1) - angle : angle;
    const int n = (int)fmax(1, round(1 / small));
    double xyz[3];
    struct verify_trial t =
        verify_trial_of(s, "cantilever_transient", "frequency / exact, omega dt = %g", a);

    verify_trial_set(&t,
                     "sheet={length: 1, width: 1, thickness: 1}; gravity=[9.81,0,0];"
                     "material={young: 1e5, poisson: 0, density: 0.5};"
                     "damping={kind: none}; time={step: %.17g, end: %.17g}",
                     dt, 2 * dt);
    if (verify_trial_motion(&t, 1, (double[]){n * dt}, 1, (double[]){1, 0.5, 0.5}, xyz)) {
        double cosine = fmax(-1, fmin(1, 1 - (xyz[0] - 1) / still));
        double theta = acos(beyond && n % 2 ? -cosine : cosine) / n;
        verify_row_judge(t.row, (beyond ? acos(-1) - theta : theta) / a, ratio, 0);
        verify_row_note(t.row, "%d steps", n);
    }
}

const struct verify_check verify_period = {
    {"period", "how average acceleration lengthens a period, at any step"},
    "2 atan(omega dt / 2) / (omega dt), tests/reference/beam_elastica_cable.csv",
    "beam_elastica_cable",
    .parts = {{&without_mode, add_none, 1},
              {&field, add_row, .column = "case", .text = "newmark"}}};

/* One bar element that swings along itself under sudden weight: what average acceleration
 * makes of a single frequency. */
#include <math.h>
#include <stdio.h>

#include "bench/verify/verify.h"

extern const struct verify_check verify_period;

/* The table has 12 digits; positions of 1 m have 11 of a sway of 2e-5 m, each of up to
 * 25000 steps adds its round-off. */
static const double PERIOD = 1e-6;

/* E A / L against rho A L / 3. */
static const double YOUNG = 1e5, DENSITY = 0.5, WEIGHT = 9.81;

#define CUBE "sheet={length: 1, width: 1, thickness: 1}"
#define ONE  "discretization.points=[2,2,2] discretization.kinematics=linear"
static const struct verify_subject subjects[] = {
    {"iga, p = 1, one element", "iga", ONE " discretization.degree=[1,1,1]", PERIOD, NULL},
    {"hex, one element", "hex", ONE, PERIOD, NULL},
    {"shell", "shell", NULL, NAN, NULL},
    {"mass_spring", "mass_spring", NULL, NAN, NULL},
    {"projective_dynamics", "projective_dynamics", NULL, NAN, NULL},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects, SOLIDS = 2 };

/* The tip moves by x_n = x_s (1 - cos n theta). n is such that n theta is about a radian
 * from 0 or, for steps beyond the period, from n pi: there cos n theta tells theta best. */
static enum status add_row(struct verify_sheet *sheet, const struct verify_subject *s,
                           double a, double ratio, struct message *why)
{
    enum status st;
    const double tip[3] = {1, 0.5, 0.5}, omega = sqrt(3 * YOUNG / DENSITY);
    const double dt = a / omega, still = DENSITY * WEIGHT / (2 * YOUNG);
    const bool beyond = a > 2;
    const double angle = 2 * atan(a / 2), small = beyond ? acos(-1) - angle : angle;
    const int n = (int)fmax(1, round(1 / small));
    const double time = n * dt;
    char step[96];
    const char *settings[] = {"material={young: 1e5, poisson: 0, density: 0.5}",
                              CUBE,
                              "gravity=[9.81,0,0]",
                              "damping={kind: none}",
                              step,
                              NULL};
    double xyz[3];
    bool lived;
    struct verify_row *row = verify_add(sheet, s, "frequency / exact, omega dt = %g", a);

    snprintf(step, sizeof step, "time={step: %.17g, end: %.17g}", dt, 2 * dt);
    TRY(verify_motion(row, s, "cantilever_transient", settings, 1, &time, 1, tip, xyz,
                      &lived, why));
    if (lived) {
        double cosine = fmax(-1, fmin(1, 1 - (xyz[0] - 1) / still));
        double theta = acos(beyond && n % 2 ? -cosine : cosine) / n;
        verify_judge(row, (beyond ? acos(-1) - theta : theta) / a, ratio, 0);
        verify_note(row, "%d steps", n);
    }
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;

    TRY(verify_reference("beam_elastica_cable", &table, why));
    for (int s = SOLIDS; s < SUBJECTS; s++)
        if (verify_wanted(sheet, &subjects[s]))
            verify_not_applicable(verify_add(sheet, &subjects[s], "frequency / exact"),
                                  "it has no net with a single mode along itself");
    for (int n = 0; (n = reference_find(table, n, "case", "newmark")) >= 0; n++)
        for (int s = 0; s < SOLIDS; s++)
            if (verify_wanted(sheet, &subjects[s]))
                TRY(add_row(sheet, &subjects[s], reference_number(table, n, "a"),
                            reference_number(table, n, "v1"), why));
out:
    reference_close(table);
    return st;
}

const struct verify_check verify_period = {
    .item = {"period", "how average acceleration lengthens a period, at any step"},
    .source = "2 atan(omega dt / 2) / (omega dt), tests/reference/beam_elastica_cable.csv",
    .run = run,
};

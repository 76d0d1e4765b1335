/* A strip of nu = 0 that hangs from a clamped edge and swings a little under its weight: a
 * beam where Gamma is small, a heavy chain where it is large. Its frequencies are those of
 * the tangent at the hanging equilibrium. */
#include <math.h>
#include <stdio.h>

#include "bench/verify/verify_check.h"

/* Claims as for the elastica. Linear modes know no weight, which is 0.6 % of the first
 * frequency at Gamma = 0.1 and 6 % at 1. */
#define SOLID 0.01, "1 % is asked"
#define HALF  0.005, "half of what is asked of solids"
static const double LINEAR_GAMMA = 0.1;
static const double BAR = 1e-9; /* of the table, by its header */
/* The truth does not stretch: rho g L / E is this at most, and h / L at most 1e-2, where
 * shear and rotary inertia take 1e-3 off the third frequency. */
static const double STRETCH = 2e-3, THICKEST = 0.01;
/* Swings in the strip's own plane are shut out by holding y; twisting, whose frequencies
 * under tension alone would be those of a chain, by a width of L / sqrt(Gamma), where the
 * strip's torsional stiffness lifts the first above omega_3; of a beam by L / 20. */
static const double WIDEST = 0.05;

enum { MODES = 3 };

/* The claim was missed from Gamma = 1e4 on as long as the cures of degree 2 had their
 * points in the middle of spans, where a net that zigzags has no slope. */
#define WITHDRAWN                                                                          \
    .changed = "1 % at every Gamma, as now; withdrawn for a while after it was missed "    \
               "from 1e4 on"

/* On 25 points graded towards the clamp, with a last span of 1/11 L, a cured shell misses
 * at Gamma = 1e6, by a third. (It missed from 1e5 on where its rule found the weight of the
 * last span to press the tip, and the tip folded.) */
#define REFINED                                                                            \
    "0.5 % with 25 points graded towards the clamp, missed from Gamma = 1e5 on, now at "   \
    "1e6 alone"

/* Knots at (k / spans)^2 near the clamp, where a chain bends over L / sqrt(Gamma). */
#define CHAIN {20, 40}, {3, 3}, 2
static const struct verify_subject entries[] = {
    {"iga_selective_linear", 0.01, "the weight's share at Gamma = 0.1", CHAIN},
    {"iga_nonlinear", 0, "the paper's space: locks", CHAIN},
    {"iga_selective", SOLID, CHAIN, WITHDRAWN},
    {"iga_selective_3", SOLID, CHAIN, .settings = {"discretization.degree=[3,2,1]"}},
    {"hex_incompatible", SOLID, {40, 80}, {2, 2}},
    {"shell_3", HALF, {13, 25}, {4, 4}, 2},
    {"shell_selective_3", HALF, {25, 49}, {4, 4}, .changed = REFINED},
    {"triangles", SOLID, {40, 80}, {3, 5}},
    {"mass_spring,position_based,projective_dynamics", 0, NULL, {20, 40}, {3, 5}},
    {NULL}};
static const struct verify_field field = {
    entries, CONTESTANT_LARGE, "iga_nonlinear_3,hex_nonlinear," VERIFY_TWINS, {20, 40}};

/* Computes sqrt(L / g) omega on one net; writes the mode that is farthest off into the row
 * and returns its error. */
static double measure(struct verify_trial *t, void *context)
{
    static const char *const column[MODES] = {"v1", "v2", "v3"};
    const double gamma = verify_number(t->subject, "a"), rho = 0.05, g = 9.81;
    const double h = fmin(THICKEST, sqrt(12 * STRETCH / gamma));
    double omega[MODES] = {NAN, NAN, NAN}, worst = -1;

    verify_trial_set(
        t,
        "sheet.width=%.17g; sheet.thickness=%.17g; material.young=%.17g; "
        "material.poisson=0; "
        "pose={origin: [0,0,0], u: [0,0,-1], v: [0,1,0]}; "
        "supports=[{at: {u: 0}, fix: xyz}, {at: {u: [0,1], v: [0,1]}, fix: y}]",
        fmin(WIDEST, 1 / sqrt(gamma)), h, 12 * rho * g / (gamma * h * h));
    verify_trial_modes(t, true, MODES, omega);
    for (int n = 0; n < MODES; n++) {
        const double truth = verify_number(t->subject, column[n]);
        const double value = omega[n] * sqrt(1 / g), error = fabs(value - truth) / truth;
        if (error <= worst)
            continue;
        worst = error, *(int *)context = n + 1;
        t->row->value = value, t->row->truth = truth;
    }
    return worst;
}

static void add_row(struct verify_subject *s)
{
    const double gamma = verify_number(s, "a");
    int mode;

    if (!s->contestant->model->modes && gamma != 0.01) /* told once */
        return;
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "omega sqrt(L / g), Gamma = %g", gamma);
    if (!verify_trial_nets(&t, measure, &mode, NAN, BAR))
        return;
    snprintf(t.row->quantity, sizeof t.row->quantity,
             "omega_%d sqrt(L / g), worst of 3, Gamma = %g", mode, gamma);
    if (verify_subject_is_linear(s) && gamma > LINEAR_GAMMA)
        verify_row_end(t.row, VERDICT_OUT_OF_RANGE,
                       "modes without weight reach to Gamma = %g", LINEAR_GAMMA);
}

const struct verify_check verify_hanging = {
    {"hanging", "frequencies of a strip hanging under its weight"},
    "small swings of an inextensible strip, tests/reference/beam_elastica_cable.csv "
    "(hangfreq), 1e-9",
    "beam_elastica_cable",
    .parts = {{&field, add_row, .column = "case", .text = "hangfreq", .every = 3}}};

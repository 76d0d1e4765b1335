/* Two of the shell benchmarks of Sze, Liu and Lo 2004: a cantilever under an end shear that
 * keeps its direction (3.1) and under an end moment, which turns with it (3.2). */
#include <math.h>

#include "bench/verify/checks/verify_strips.h"

static const double BAR = 1e-8; /* of the columns exact1, exact2 */
/* The sheets of 3.1 and 3.2, except for the length. */
#define STRIP                                                                              \
    "sheet.width=1; sheet.thickness=0.1; material.young=1.2e6; material.poisson=0; "       \
    "gravity=[0,0,0]; "
static const double LENGTH = 10, FULL_LOAD = 4;
/* Share of the full load up to which small strains hold: they are 1 % wrong where a third
 * of the squared slope is, 0.03 = (P L^2 / 2 E I)^2 / 3, at 0.6 / 4 of the load. */
static const double LINEAR_LOAD = 0.05;

/* Computes how far the tip is up, and how far it has come back, at a share of the load. */
static void measure(struct verify_trial *t, double at[2])
{
    double xyz[3] = {NAN, NAN, NAN};

    verify_trial_set(t,
                     STRIP "sheet.length=%.17g; loads=[{at: {u: 1}, force: [0, 0, %.17g]}]",
                     LENGTH, verify_number(t->subject, "P_over_Pmax") * FULL_LOAD);
    verify_trial_tip(t, xyz);
    at[0] = xyz[2], at[1] = LENGTH - xyz[0];
}

/* Adds a row for each five loads of the table's first twenty; --quick: their last one. */
static void add_shear(struct verify_subject *s)
{
    enum { GROUP = 5 };
    static const char *const truth[] = {"exact2", "exact1"};
    const int last = s->at + GROUP - 1;

    if (s->at % GROUP)
        return;
    if (s->sheet->quick)
        s->at = last;
    const double from = verify_number(s, "P_over_Pmax");
    const double to = reference_number(s->sheet->table, last, "P_over_Pmax");
    s->changed = NULL;
    struct verify_trial t = verify_trial_of(s, "cantilever",
                                            to > from ? "3.1, end shear %.3g .. %.3g: tip"
                                                      : "3.1, end shear %.3g: tip",
                                            from * FULL_LOAD, to * FULL_LOAD);
    if (!verify_strips_worst(&t, s, measure, last, 1, truth, BAR))
        verify_row_note(t.row, "at %.3g of the load", verify_number(s, "P_over_Pmax"));
    else if (verify_subject_is_linear(s) && to > LINEAR_LOAD)
        verify_row_end(t.row, VERDICT_OUT_OF_RANGE, "small strains reach to %g of the load",
                       LINEAR_LOAD);
}

/* --- 3.2: supports lead the end face along the circle, as a moment would; the shape
 * between must follow. */

static const double LONG = 12, BENDING = 100; /* L [m], E I [N m^2]                      */

/* A motion that is slow against the strip's first frequency, 22.4 sqrt(E I / m L^4) = 22.4
 * / s by this density, and damped near it: e^-20 of the swing is left at the end. */
#define SLOWLY                                                                             \
    "material.density=0.0482253;damping={kind: mass, value: 40};time.step=0.02;time.end=4"
static const double LED = 2, REST_AT = 4; /* [s]                                         */

/* Computes where the arc of angle `turn` over the length puts the point s, z off its
 * middle. */
static void arc(double turn, double s, double z, double *x, double *up)
{
    double phi = turn * s, radius = turn != 0 ? LONG / turn : INFINITY;

    *x = turn != 0 ? radius * sin(phi) - z * sin(phi) : s * LONG;
    *up = turn != 0 ? radius * (1 - cos(phi)) + z * cos(phi) : z;
}

/* Clamps u = 0 and leads the lower and the upper edge at u = 1 round in ROWS pieces. */
static void add_leading(double turn, struct settings *all)
{
    enum { ROWS = 40 };

    settings_set(all, "supports=[{at: {u: 0}, fix: xyz}");
    for (int w = 0; w < 2; w++) {
        settings_more(all, ", {at: {u: 1, w: %d}, fix: xyz, path: [", w);
        for (int k = 0; k <= ROWS; k++) {
            double x, up, z = (w - 0.5) * 0.1;
            arc(turn * k / ROWS, 1, z, &x, &up);
            settings_more(all, "%s[%.17g, %.17g, 0, %.17g]", k ? ", " : "", LED * k / ROWS,
                          x - LONG, up - z);
        }
        settings_more(all, "]}");
    }
    settings_more(all, "]");
}

static void add_moment(struct verify_subject *s)
{
    const double turn = (double[]){0.25, 0.5, 1}[s->at] * 2 * acos(-1), time[1] = {REST_AT};
    const double uvw[3][3] = {{0.25, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.75, 0.5, 0.5}};
    double xyz[3][3], sum = 0;

    s->changed = NULL;
    s->grade = 0; /* no boundary layer here */
    verify_subject_last(s, 1);
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "3.2, end turned by %.3g rad: shape", turn);
    if (!s->layers || verify_subject_is_linear(s)) {
        verify_row_end(t.row, VERDICT_NOT_APPLICABLE,
                       s->layers ? "small strains do not turn"
                                 : "its edge has no face that could be led");
        return;
    }
    verify_trial_set(&t, STRIP SLOWLY "; sheet.length=%g", LONG);
    add_leading(turn, &t.settings);
    if (!verify_trial_motion(&t, 1, time, 3, uvw[0], xyz[0]))
        return;
    for (int k = 0; k < 3; k++) {
        double x, up;
        arc(turn, uvw[k][0], 0, &x, &up);
        sum += (xyz[k][0] - x) * (xyz[k][0] - x) + (xyz[k][2] - up) * (xyz[k][2] - up);
    }
    /* the bar: E z^2 / 24 R^2 of the middle */
    verify_row_judge_error(t.row, sqrt(sum / 3) / LONG, 1e-4);
    verify_row_note(t.row, "moment %.4g N m by supports that lead the end face",
                    BENDING * turn / LONG);
}

const struct verify_check verify_sze = {
    {"sze", "cantilever under an end load, large rotations (Sze, Liu, Lo 2004)"},
    "3.1: inextensible elastica with an end load, tests/reference/sze_benchmarks.csv, "
    "columns exact1, exact2; error: the tip's distance, of its deflection, the worst of "
    "five loads; 3.2: the circle, error: rms, of the length",
    "sze_benchmarks",
    .slow = true,
    .parts = {{&verify_strips, add_shear, .column = "problem", .text = "3.1"},
              {&verify_strips, add_moment, 3, .every = 3}}};

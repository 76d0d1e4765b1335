/* Two of the shell benchmarks of Sze, Liu and Lo 2004: a cantilever under an end shear that
 * keeps its direction (3.1) and under an end moment, which turns with it (3.2). */
#include <math.h>

#include "bench/verify/checks/verify_strips.h"

/* Of the columns exact1, exact2. */
static const double BAR = 1e-8;
/* Sheets of 3.1 and 3.2, but for the length. */
static const char *const strip[] = {"sheet.width=1",        "sheet.thickness=0.1",
                                    "material.young=1.2e6", "material.poisson=0",
                                    "gravity=[0,0,0]",      NULL};
enum { STRIP = sizeof strip / sizeof *strip };
static const double LENGTH = 10, FULL_LOAD = 4;
/* Small strains are 1 % wrong where a third of the squared slope is, 0.03 = (P L^2 / 2 E
 * I)^2 / 3: from 0.6 / 4 of the load in all on they are out of range. */
static const double LINEAR_LOAD = 0.05;

/* Distance of the tip from the truth, of its deflection; the load is a share of the full
 * one, `along` how far the tip has come back. */
static void measure(struct verify_trial *t, const struct verify_strips_load *load,
                    double *up, double *error)
{
    double xyz[3] = {NAN, NAN, NAN};

    settings_number(&t->settings, "sheet.length", LENGTH);
    settings_list(&t->settings, STRIP, strip);
    settings_print(&t->settings, "loads=[{at: {u: 1}, force: [0, 0, %.17g]}]",
                   load->load * FULL_LOAD);
    verify_trial_tip(t, xyz);
    *up = xyz[2];
    *error = verify_subject_is_linear(t->subject)
                 ? fabs(xyz[2] - load->out)
                 : hypot(xyz[2] - load->out, LENGTH - xyz[0] - load->along);
    *error /= load->out;
}

static void add_shear(const struct verify_subject *s, int count,
                      const struct verify_strips_load *load)
{
    const double from = load[0].load * FULL_LOAD, to = load[count - 1].load * FULL_LOAD;
    struct verify_trial t = verify_trial_of(s, "cantilever",
                                            count > 1 ? "3.1, end shear %.3g .. %.3g: tip"
                                                      : "3.1, end shear %.3g: tip",
                                            from, to);
    const struct verify_strips_load *died =
        verify_strips_worst(&t, measure, count, load, 1, BAR);

    if (died)
        verify_row_note(t.row, "at %.3g of the load", died->load);
    else if (verify_subject_is_linear(s) && load[count - 1].load > LINEAR_LOAD)
        verify_row_end(t.row, VERIFY_OUT_OF_RANGE, "small strains reach to %g of the load",
                       LINEAR_LOAD);
}

static void add_steps(struct verify_sheet *sheet)
{
    const struct reference *table = sheet->table;
    enum { MOST = 32, GROUP = 5 };
    struct verify_strips_load load[MOST];
    struct verify_subject s;
    int count = 0;

    for (int row = 0; count < MOST; row++) {
        row = reference_find(table, row, "problem", "3.1");
        if (row < 0)
            break;
        load[count] = (struct verify_strips_load){
            reference_number(table, row, "P_over_Pmax"),
            reference_number(table, row, "exact2"), reference_number(table, row, "exact1")};
        count += !isnan(load[count].out);
    }
    for (int first = 0; first < count; first += GROUP) {
        const int group = count - first < GROUP ? count - first : GROUP;
        const int skip = sheet->quick ? group - 1 : 0; /* the last alone */
        for (int n = 0; verify_sheet_next(sheet, &verify_strips, &n, &s);)
            add_shear(&s, group - skip, &load[first + skip]);
    }
}

/* --- 3.2: the end face is led along the circle, which is what a moment asks of it; the
 * shape between, and the work of the moment as elastic energy, must follow. */

static const double LONG = 12, BENDING = 100; /* L [m], E I [N m^2]                      */

/* Slow against the strip's first frequency, 22.4 sqrt(E I / m L^4) = 22.4 / s by this
 * density, and damped near it: what moves at the end is e^-20 of what was moved. */
static const char *const slowly[] = {"material.density=0.0482253",
                                     "damping={kind: mass, value: 40}",
                                     "time={step: 0.02, end: 4}", NULL};
static const double LED = 2, REST_AT = 4; /* [s]                                         */

/* Where the arc of angle `turn` over the length puts the point s, z from the middle. */
static void arc(double turn, double s, double z, double *x, double *up)
{
    double phi = turn * s, radius = turn != 0 ? LONG / turn : INFINITY;

    *x = turn != 0 ? radius * sin(phi) - z * sin(phi) : s * LONG;
    *up = turn != 0 ? radius * (1 - cos(phi)) + z * cos(phi) : z;
}

/* Clamped at u = 0; the lower and the upper edge at u = 1 go round in ROWS pieces. */
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

/* *s as of 3.1, on its finest net. */
static void add_moment(struct verify_subject *s, double share)
{
    const double turn = share * 2 * acos(-1), time[1] = {REST_AT};
    const double uvw[3][3] = {{0.25, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.75, 0.5, 0.5}};
    double xyz[3][3], sum = 0;

    s->grade = 0; /* no boundary layer here */
    verify_subject_last(s, 1);
    struct verify_trial t =
        verify_trial_of(s, "cantilever", "3.2, end turned by %.3g rad: shape", turn);
    if (!s->layers || verify_subject_is_linear(s)) {
        verify_row_end(t.row, VERIFY_NOT_APPLICABLE,
                       s->layers ? "small strains do not turn"
                                 : "its edge has no face that could be led");
        return;
    }
    settings_number(&t.settings, "sheet.length", LONG);
    settings_list(&t.settings, STRIP, strip);
    settings_list(&t.settings, STRIP, slowly);
    add_leading(turn, &t.settings);
    if (!verify_trial_motion(&t, 1, time, 3, uvw[0], xyz[0]))
        return;
    for (int k = 0; k < 3; k++) {
        double x, up;
        arc(turn, uvw[k][0], 0, &x, &up);
        sum += (xyz[k][0] - x) * (xyz[k][0] - x) + (xyz[k][2] - up) * (xyz[k][2] - up);
    }
    verify_row_judge_error(t.row, sqrt(sum / 3) / LONG, 1e-4); /* E z^2 / 24 R^2 of the
                                                                middle */
    verify_row_note(t.row, "moment %.4g N m by supports that lead the end face",
                    BENDING * turn / LONG);
}

static void run(struct verify_sheet *sheet)
{
    static const double shares[] = {0.25, 0.5, 1};
    struct verify_subject s;

    add_steps(sheet);
    for (int k = 0; k < (sheet->quick ? 1 : 3); k++)
        for (int n = 0; verify_sheet_next(sheet, &verify_strips, &n, &s);)
            add_moment(&s, shares[k]);
}

const struct verify_check verify_sze = {
    .item = {"sze", "cantilever under an end load, large rotations (Sze, Liu, Lo 2004)"},
    .table = "sze_benchmarks",
    .source =
        "3.1: inextensible elastica with an end load, tests/reference/sze_benchmarks.csv, "
        "columns exact1, exact2; error: the tip's distance, of its deflection, the "
        "worst of five loads; 3.2: the circle, error: rms, of the length",
    .slow = true,
    .run = run,
};

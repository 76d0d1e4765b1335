/* Two of the shell benchmarks of Sze, Liu and Lo 2004: a cantilever under an end shear that
 * keeps its direction (3.1) and under an end moment, which turns with it (3.2). */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/verify/verify_strips.h"

extern const struct verify_check verify_sze;

/* Of the columns exact1, exact2. */
static const double BAR = 1e-8;
/* Sheet of 3.1. */
#define STRIP                                                                              \
    "sheet.length=10", "sheet.width=1", "sheet.thickness=0.1", "material.young=1.2e6",     \
        "material.poisson=0", "gravity=[0,0,0]"
static const double LENGTH = 10, FULL_LOAD = 4;
/* Small strains are 1 % wrong where a third of the squared slope is, 0.03 = (P L^2 / 2 E
 * I)^2 / 3: from 0.6 / 4 of the load in all on they are out of range. */
static const double LINEAR_LOAD = 0.05;

struct step {
    double share, back, up; /* of the full load; -u and w of the tip [m]               */
};

/* Distance of the tip from the truth, of its deflection. */
static enum status measure(struct verify_row *row, const struct verify_strip *strip,
                           int net, const struct step *step, double *up, double *error,
                           bool *lived, struct message *why)
{
    const double tip[3] = {1, 0.5, 0.5};
    double xyz[3] = {NAN, NAN, NAN};
    char load[96];
    struct verify_net n;

    verify_net_make(&strip->nets, net, &n);
    const char *settings[] = {STRIP, load, n.points, *n.knots ? n.knots : NULL, NULL};
    snprintf(load, sizeof load, "loads=[{at: {u: 1}, force: [0, 0, %.17g]}]",
             step->share * FULL_LOAD);
    enum status st = verify_equilibrium(row, &n.subject, "cantilever", settings, 1, tip,
                                        xyz, lived, why);
    *up = xyz[2];
    *error = strip->linear ? fabs(xyz[2] - step->up)
                           : hypot(xyz[2] - step->up, LENGTH - xyz[0] - step->back);
    *error /= step->up;
    return st;
}

static enum status add_shear(struct verify_sheet *sheet, const struct verify_strip *strip,
                             int count, const struct step *steps, struct message *why)
{
    enum status st = STATUS_OK;
    double error[VERIFY_NETS] = {0}, up, worst = -1;
    struct verify_net fine;

    verify_net_make(&strip->nets, 1, &fine);
    const double from = steps[0].share * FULL_LOAD, to = steps[count - 1].share * FULL_LOAD;
    struct verify_row *row =
        count > 1
            ? verify_add(sheet, &fine.subject, "3.1, end shear %.3g .. %.3g: tip", from, to)
            : verify_add(sheet, &fine.subject, "3.1, end shear %.3g: tip", from);
    for (int n = 0; n < count; n++) {
        bool lived;
        for (int net = 0; net < VERIFY_NETS; net++) {
            TRY(measure(row, strip, net, &steps[n], &up, &error[net], &lived, why));
            if (!lived) {
                verify_note(row, "at %.3g of the load", steps[n].share);
                return STATUS_OK;
            }
        }
        if (error[1] > worst) {
            worst = error[1];
            row->value = up;
            row->truth = steps[n].up;
            row->order = verify_net_order(&strip->nets, error, BAR);
        }
    }
    verify_judge_error(row, worst, BAR);
    if (strip->linear && steps[count - 1].share > LINEAR_LOAD)
        verify_out_of_range(row, "small strains reach to %g of the load", LINEAR_LOAD);
out:
    return st;
}

static enum status add_steps(struct verify_sheet *sheet, const struct reference *table,
                             struct message *why)
{
    enum { MOST = 32, GROUP = 5 };
    enum status st = STATUS_OK;
    struct step steps[MOST];
    int count = 0, every = verify_quick(sheet) ? GROUP : 1;

    for (int row = reference_find(table, 0, "problem", "3.1"); row >= 0 && count < MOST;
         row = reference_find(table, row + 1, "problem", "3.1")) {
        steps[count] = (struct step){reference_number(table, row, "P_over_Pmax"),
                                     reference_number(table, row, "exact1"),
                                     reference_number(table, row, "exact2")};
        count += !isnan(steps[count].up);
    }
    for (int first = 0; first < count; first += GROUP) {
        int group = count - first < GROUP ? count - first : GROUP;
        for (int s = 0; s < VERIFY_STRIPS; s++)
            if (verify_wanted(sheet, &verify_strips[s].nets.subject))
                TRY(add_shear(sheet, &verify_strips[s], every == 1 ? group : 1,
                              &steps[first + (every == 1 ? 0 : group - 1)], why));
    }
out:
    return st;
}

/* --- 3.2: the end face is led along the circle, which is what a moment asks of it; the
 * shape between, and the work of the moment as elastic energy, must follow. */

#define LONG_STRIP                                                                         \
    "sheet.length=12", "sheet.width=1", "sheet.thickness=0.1", "material.young=1.2e6",     \
        "material.poisson=0", "gravity=[0,0,0]"
static const double LONG = 12, BENDING = 100; /* L [m], E I [N m^2]                      */

/* Slow against the strip's first frequency, 22.4 sqrt(E I / m L^4) = 22.4 / s by this
 * density, and damped near it: what moves at the end is e^-20 of what was moved. */
#define SLOWLY                                                                             \
    "material.density=0.0482253", "damping={kind: mass, value: 40}",                       \
        "time={step: 0.02, end: 4}"
static const double LED = 2, REST_AT = 4; /* [s]                                         */

/* Where the arc of angle `turn` over the length puts the point s, z from the middle. */
static void arc(double turn, double s, double z, double *x, double *up)
{
    double phi = turn * s, radius = turn != 0 ? LONG / turn : INFINITY;

    *x = turn != 0 ? radius * sin(phi) - z * sin(phi) : s * LONG;
    *up = turn != 0 ? radius * (1 - cos(phi)) + z * cos(phi) : z;
}

/* Clamped at u = 0; the lower and the upper edge at u = 1 go round in ROWS pieces. */
static void write_leading(double turn, size_t size, char *text)
{
    enum { ROWS = 40 };
    size_t used = (size_t)snprintf(text, size, "supports=[{at: {u: 0}, fix: xyz}");

    for (int w = 0; w < 2 && used < size; w++) {
        used += (size_t)snprintf(text + used, size - used,
                                 ", {at: {u: 1, w: %d}, fix: xyz, path: [", w);
        for (int k = 0; k <= ROWS && used < size; k++) {
            double x, up, z = (w - 0.5) * 0.1;
            arc(turn * k / ROWS, 1, z, &x, &up);
            used += (size_t)snprintf(text + used, size - used, "%s[%.17g, %.17g, 0, %.17g]",
                                     k ? ", " : "", LED * k / ROWS, x - LONG, up - z);
        }
        if (used < size)
            used += (size_t)snprintf(text + used, size - used, "]}");
    }
    if (used < size)
        snprintf(text + used, size - used, "]");
}

static enum status add_moment(struct verify_sheet *sheet, const struct verify_strip *strip,
                              double share, struct message *why)
{
    const double turn = share * 2 * acos(-1), time[1] = {REST_AT};
    const double uvw[3][3] = {{0.25, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.75, 0.5, 0.5}};
    double xyz[3][3], sum = 0;
    char supports[16384];
    struct verify_net n;
    enum status st;
    bool lived;

    struct verify_series even = strip->nets; /* no boundary layer here                */
    even.grade = 0;
    verify_net_make(&even, 1, &n);
    struct verify_row *row =
        verify_add(sheet, &n.subject, "3.2, end turned by %.3g rad: shape", turn);
    if (!strip->nets.layers || strip->linear) {
        verify_not_applicable(row, strip->linear
                                       ? "small strains do not turn"
                                       : "its edge has no face that could be led");
        return STATUS_OK;
    }
    const char *settings[] = {
        LONG_STRIP, SLOWLY, supports, n.points, *n.knots ? n.knots : NULL, NULL};
    write_leading(turn, sizeof supports, supports);
    TRY(verify_motion(row, &n.subject, "cantilever", settings, 1, time, 3, uvw[0], xyz[0],
                      &lived, why));
    if (!lived)
        return STATUS_OK;
    for (int k = 0; k < 3; k++) {
        double x, up;
        arc(turn, uvw[k][0], 0, &x, &up);
        sum += (xyz[k][0] - x) * (xyz[k][0] - x) + (xyz[k][2] - up) * (xyz[k][2] - up);
    }
    verify_judge_error(row, sqrt(sum / 3) / LONG, 1e-4); /* E z^2 / 24 R^2 of the middle */
    verify_note(row, "moment %.4g N m by supports that lead the end face",
                BENDING * turn / LONG);
out:
    return st;
}

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    static const double shares[] = {0.25, 0.5, 1};
    enum status st;
    struct reference *table = NULL;

    TRY(verify_reference("sze_benchmarks", &table, why));
    TRY(add_steps(sheet, table, why));
    for (int k = 0; k < (verify_quick(sheet) ? 1 : 3); k++)
        for (int s = 0; s < VERIFY_STRIPS; s++)
            if (verify_wanted(sheet, &verify_strips[s].nets.subject))
                TRY(add_moment(sheet, &verify_strips[s], shares[k], why));
out:
    reference_close(table);
    return st;
}

const struct verify_check verify_sze = {
    .item = {"sze", "cantilever under an end load, large rotations (Sze, Liu, Lo 2004)"},
    .source =
        "3.1: inextensible elastica with an end load, tests/reference/sze_benchmarks.csv, "
        "columns exact1, exact2; error: the tip's distance, of its deflection, the "
        "worst of five loads; 3.2: the circle, error: rms, of the length",
    .slow = true,
    .run = run,
};

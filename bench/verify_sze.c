/* Two of the shell benchmarks of Sze, Liu and Lo 2004: a cantilever under an end shear that
 * keeps its direction (3.1) and under an end moment, which turns with it (3.2). */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "bench/verify_strips.h"

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

static enum status run(struct verify_sheet *sheet, struct message *why)
{
    enum status st;
    struct reference *table = NULL;

    TRY(verify_reference("sze_benchmarks", &table, why));
    TRY(add_steps(sheet, table, why));
    for (int s = 0; s < VERIFY_STRIPS; s++)
        if (verify_wanted(sheet, &verify_strips[s].nets.subject))
            verify_not_applicable(
                verify_add(sheet, &verify_strips[s].nets.subject, "3.2, end moment"),
                "a moment turns with the edge it acts on; the loads of a scene keep their "
                "direction");
out:
    reference_close(table);
    return st;
}

const struct verify_check verify_sze = {
    .item = {"sze", "cantilever under an end load, large rotations (Sze, Liu, Lo 2004)"},
    .source = "inextensible elastica with an end load, tests/reference/sze_benchmarks.csv, "
              "columns exact1, exact2; error: the tip's distance, of its deflection, the "
              "worst of five loads",
    .run = run,
};

/* What a reader should take away from Tables 2 and 3, in sentences from the numbers. */
#include <math.h>

#include "bench/harness/fit.h"
#include "bench/tables/table23.h"

struct range {
    double low, high;
};

static void widen(struct range *r, double value)
{
    r->low = fmin(r->low, value); /* a NaN is left out */
    r->high = fmax(r->high, value);
}

static void tell_machine(const struct table23_data *d, FILE *file)
{
    struct range ratio = {INFINITY, 0};

    for (int n = 0; n < d->rows; n++)
        widen(&ratio, d->row[n].paper->milliseconds / table23_cost(d, n, TABLE23_PRINTED));
    fprintf(
        file,
        "- Milliseconds. The paper's frames take %.3g to %.3g times ours. That number is a "
        "machine (an i7-7700 of 2017,\n  assembly on its 4 cores; one thread here), a "
        "compiler, a linear algebra library and a code in one, and nothing in the\n  paper "
        "separates them. Ratios between rows are free of the machine's speed: only they "
        "are compared below.\n",
        ratio.low, ratio.high);
}

enum { ROWS = PAPER_GROWTH_ROWS, FIRST = PAPER_GROWTH, LAST = PAPER_GROWTH + ROWS - 1 };

static double cost_printed(const struct table23_data *d, int row)
{
    return table23_cost(d, row, TABLE23_PRINTED);
}

static double cost_linear(const struct table23_data *d, int row)
{
    return table23_cost(d, row, TABLE23_LINEAR);
}

static double assemble(const struct table23_data *d, int row)
{
    return table23_phase(d, row, BENCH_SOLID_ASSEMBLE);
}

static double factor(const struct table23_data *d, int row)
{
    return table23_phase(d, row, BENCH_SOLID_FACTOR);
}

static double elements(const struct table23_data *d, int row)
{
    return table23_elements(&d->row[row]);
}

static double paper(const struct table23_data *d, int row)
{
    return d->row[row].paper->milliseconds;
}

/* Exponent of the control points over rows first .. LAST. */
static double exponent(const struct table23_data *d, int first,
                       double value(const struct table23_data *d, int row))
{
    double x[ROWS], y[ROWS];

    for (int row = first; row <= LAST; row++) {
        x[row - first] = table23_control_points(&d->row[row]);
        y[row - first] = value(d, row);
    }
    return fit_exponent(LAST - first + 1, x, y);
}

/* Per cent of a rebuilt frame's three phases. */
static double share(const struct table23_data *d, int row, enum bench_solid_phase phase)
{
    double sum = 0;

    for (int p = 0; p < BENCH_SOLID_FRAME; p++)
        sum += table23_phase(d, row, p);
    return 100 * table23_phase(d, row, phase) / sum;
}

static void tell_growth(const struct table23_data *d, FILE *file)
{
    fprintf(
        file,
        "- Growth. The paper's frames grow as (control points)^%.2f over 5, 10, 15 and 20 "
        "points a side, ^%.2f over the\n  last three; ours as ^%.2f rebuilt (K and M alone "
        "^%.2f, factor alone ^%.2f) and ^%.2f prefactored.\n",
        exponent(d, FIRST, paper), exponent(d, FIRST + 1, paper),
        exponent(d, FIRST, cost_printed), exponent(d, FIRST, assemble),
        exponent(d, FIRST, factor), exponent(d, FIRST, cost_linear));
    fprintf(
        file,
        "- Why. A frame is K and M, which cost a fixed sum an element (elements grow as "
        "^%.2f here), and the factor, whose\n  multiplications grow as ^%.2f (2 for a band "
        "in the limit). K and M are %.0f %% of the work at 5x5 and %.0f %% at 20x20,\n  "
        "the "
        "factor %.0f and %.0f %%: a frame's exponent lies between those of its parts. The "
        "paper's %.2f is near that\n  of a band factorisation alone; where its frames "
        "spend "
        "their time it does not say.\n",
        exponent(d, FIRST, elements), exponent(d, FIRST, table23_factor_work),
        share(d, FIRST, BENCH_SOLID_ASSEMBLE), share(d, LAST, BENCH_SOLID_ASSEMBLE),
        share(d, FIRST, BENCH_SOLID_FACTOR), share(d, LAST, BENCH_SOLID_FACTOR),
        exponent(d, FIRST + 1, paper));
    fprintf(
        file,
        "- Prefactored. One factorisation for all frames makes a frame %.0f times cheaper "
        "at 20x20 than a rebuilt one; the\n  paper's scheme rebuilds because its matrices "
        "follow the sheet.\n",
        cost_printed(d, LAST) / cost_linear(d, LAST));
}

/* Rows of one net and degree differ in nothing that costs: how far apart are they? */
static void tell_same(const struct table23_data *d, FILE *file)
{
    struct range printed = {INFINITY, 0}, ours = {INFINITY, 0};
    const int same[] = {0, 1, PAPER_GROWTH + 1};

    for (int n = 0; n < 3; n++) {
        widen(&printed, d->row[same[n]].paper->milliseconds);
        widen(&ours, table23_cost(d, same[n], TABLE23_PRINTED));
    }
    fprintf(
        file,
        "- Scatter. Three rows of Table 2 are one net and degree, 10x10x2 and (2,2,1): the "
        "paper has %.0f to %.0f ms for them\n  (%.0f %% apart), we have %.3g to %.3g "
        "(%.0f %%). Differences below that say nothing.\n",
        printed.low, printed.high, 100 * (printed.high / printed.low - 1), ours.low,
        ours.high, 100 * (ours.high / ours.low - 1));
}

/* Farther from the ground than any sheet that lies on it [m]. */
static const double CLEAR = 0.05;

/* What contact costs by a kinematics, over the flag on the same net, and its factorisations
 * a frame. */
static double contact_ratio(const struct table23_data *d, int kinematics, double *factors)
{
    const int contact = PAPER_TABLE2_CONTACT, flag = PAPER_TABLE2_ROWS - 1;
    const struct counters *work = &d->cell[contact][kinematics].work;

    *factors = (double)work->factorisations / (double)work->steps;
    return table23_cost(d, contact, kinematics) / table23_cost(d, flag, kinematics);
}

static void tell_contact(const struct table23_data *d, FILE *file)
{
    const int contact = PAPER_TABLE2_CONTACT, flag = PAPER_TABLE2_ROWS - 1;
    const struct timed_result *printed = &d->cell[contact][TABLE23_PRINTED];
    double factors, ratio = contact_ratio(d, TABLE23_PRINTED, &factors);

    fprintf(
        file,
        "- Contact. In the paper the sheet on the ground costs %.2f times the flag on the "
        "same net: contact costs nothing\n  there. ",
        d->row[contact].paper->milliseconds / d->row[flag].paper->milliseconds);
    if (isnan(ratio)) {
        fprintf(file, "Here it was not run, for the reason noted above.\n");
        return;
    }
    fprintf(file, "Here it costs %.2f times the flag, fall and landing together", ratio);
    if (printed->work.steps) {
        fprintf(file,
                ", at %.2f factorisations a frame; after\n  %ld frames its lowest point is "
                "%.2g m above the ground%s.\n",
                factors, printed->work.steps, d->gap[contact],
                d->gap[contact] > CLEAR ? ": the scheme has thrown it up again" : "");
        return;
    }
    ratio = contact_ratio(d, TABLE23_INCREMENTAL, &factors);
    fprintf(
        file,
        ", up to the death noted above: the\n  printed scheme throws it up again (study "
        "contact). Incremental kinematics, which lives: %.2f times, at %.2f\n  "
        "factorisations a frame.\n",
        ratio, factors);
}

static void tell_degree(const struct table23_data *d, FILE *file)
{
    for (int low = 0; low < 2; low++) {
        int high = low + 2, side = d->row[low].points[0];
        double ratio = paper(d, high) / paper(d, low);
        double assembly =
            table23_assembly_work(&d->row[high]) / table23_assembly_work(&d->row[low]);
        double factors = table23_factor_work(d, high) / table23_factor_work(d, low);
        fprintf(
            file,
            "- Degree, 2x%dx%d. From (1,2,2) to (1,3,3) the paper's frame costs %.2f times "
            "as much, ours %.2f times. Plain\n  quadrature has %.2f times the "
            "multiplications, a band factor %.2f times: the paper's %.2f is %s.\n",
            side, side, ratio, cost_printed(d, high) / cost_printed(d, low), assembly,
            factors, ratio,
            ratio < fmin(assembly, factors)
                ? "below both, so\n  that a good part of its frame does not depend on the "
                  "degree"
            : ratio < assembly ? "between the two"
                               : "more than either");
    }
}

/* Exponent of the control points from the first net of a degree to the second. */
static double between(const struct table23_data *d, int first,
                      double value(const struct table23_data *d, int row))
{
    double x[2], y[2];

    for (int n = 0; n < 2; n++) {
        x[n] = table23_control_points(&d->row[first + n]);
        y[n] = value(d, first + n);
    }
    return fit_exponent(2, x, y);
}

/* Table 3 against Table 2, both the paper's. */
static void tell_consistency(const struct table23_data *d, FILE *file)
{
    const double second[] = {paper_table2[PAPER_GROWTH + 1].milliseconds,
                             paper_table2[PAPER_GROWTH + 2].milliseconds,
                             paper_table2[PAPER_GROWTH + 4].milliseconds};

    fprintf(
        file,
        "- Consistency. Table 3 has %.0f, %.0f and %.0f ms where Table 2 has %.0f, %.0f "
        "and "
        "%.0f for the same net and degree\n  with the thickness in w: one measurement told "
        "twice, or two that agree to %.1f %%. Only %.0f ms is new.\n",
        paper(d, 0), paper(d, 1), paper(d, 2), second[0], second[1], second[2],
        100 * (paper(d, 0) / second[0] - 1), paper(d, 3));
    fprintf(
        file,
        "- Growth. From 200 to 450 control points the paper's frames grow as ^%.2f at "
        "(1,2,2) and ^%.2f at (1,3,3), ours as\n  ^%.2f and ^%.2f (K and M alone ^%.2f and "
        "^%.2f, factor alone ^%.2f and ^%.2f).\n",
        between(d, 0, paper), between(d, 2, paper), between(d, 0, cost_printed),
        between(d, 2, cost_printed), between(d, 0, assemble), between(d, 2, assemble),
        between(d, 0, factor), between(d, 2, factor));
}

void table23_text(const struct table23_data *d, FILE *file)
{
    fprintf(file, "What was reproduced, and what not\n\n");
    tell_machine(d, file);
    if (d->which == TABLE23_SECOND) {
        tell_growth(d, file);
        tell_same(d, file);
        tell_contact(d, file);
    } else {
        tell_consistency(d, file);
        tell_degree(d, file);
    }
    timed_machine(d->machine, file);
}

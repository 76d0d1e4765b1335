#include "bench/tables/table23.h"

#include <math.h>

#include "bench/experiment/measurement.h"
#include "bench/harness/fit.h"
#include "bench/truth/paper.h"
#include "models/contact.h"
#include "models/grid.h"

const struct run_result *table23_result(const struct table23 *t, int row,
                                        enum table23_kind kind)
{
    return &t->r->study[row].row[kind].result;
}

const struct discretization *table23_net(const struct table23 *t, int row)
{
    return &t->r->study[row].row[TABLE23_PRINTED].run.discretization;
}

static double phase(const struct table23 *t, int row, int which)
{
    const struct clock_summary *s = &table23_result(t, row, TABLE23_PRINTED)->phase[which];

    return s->count ? 1e3 * s->median : NAN;
}

static double assembly_work(const struct discretization *d, double elements)
{
    double functions = 1; /* and Gauss points: degree + 1 in each direction */

    for (int i = 0; i < 3; i++)
        functions *= d->degree[i] + 1;
    return elements * functions * functions * functions;
}

static double entries(const struct table23 *t, int row)
{
    const struct run_result *r = table23_result(t, row, TABLE23_PRINTED);

    return run_result_refused(r) ? NAN : r->factor_entries;
}

double table23_value(const struct table23 *t, int row, enum table23_quantity q)
{
    const struct discretization *d = table23_net(t, row);
    const struct study *s = &t->r->study[row];
    double points = 1, elements = 1;

    for (int i = 0; i < 3; i++) {
        points *= d->points[i];
        elements *= d->points[i] - d->degree[i];
    }
    switch (q) {
    case TABLE23_PAPER_MS:
        return s->plan->paper_ms;
    case TABLE23_PRINTED_MS:
    case TABLE23_INCREMENTAL_MS:
    case TABLE23_PREFACTORED_MS:
        return s->row[q - TABLE23_PRINTED_MS].milliseconds;
    case TABLE23_ASSEMBLE_MS:
    case TABLE23_FACTOR_MS:
    case TABLE23_SOLVE_MS:
        return phase(t, row, q - TABLE23_ASSEMBLE_MS);
    case TABLE23_POINTS:
        return points;
    case TABLE23_ELEMENTS:
        return elements;
    case TABLE23_ENTRIES:
        return entries(t, row);
    case TABLE23_ASSEMBLY_WORK:
        return assembly_work(d, elements);
    case TABLE23_FACTOR_WORK:
        return pow(entries(t, row), 2) / s->row[TABLE23_PRINTED].result.unknowns;
    }
    return NAN;
}

double table23_exponent(const struct table23 *t, int first, int count,
                        enum table23_quantity q)
{
    double x[TABLE23_GROWTH_ROWS], y[TABLE23_GROWTH_ROWS];

    for (int n = 0; n < count; n++) {
        x[n] = table23_value(t, first + n, TABLE23_POINTS);
        y[n] = table23_value(t, first + n, q);
    }
    return fit_exponent(count, x, y);
}

double table23_gap(const struct table23 *t, int row)
{
    const struct study_row *printed = &t->r->study[row].row[TABLE23_PRINTED];
    const int frames = printed->result.frames;

    return frames ? contact_least_gap(&printed->run.scene, GRID_POINTS,
                                      printed->result.xyz[frames - 1])
                  : NAN;
}

struct range {
    double low, high;
};

static void widen(struct range *r, double value)
{
    r->low = fmin(r->low, value); /* a NaN is left out */
    r->high = fmax(r->high, value);
}

/* How much more of a quantity one row has than another. */
static double over(const struct table23 *d, int row, int other, enum table23_quantity q)
{
    return table23_value(d, row, q) / table23_value(d, other, q);
}

static void tell_machine(const struct table23 *d, FILE *file)
{
    struct range ratio = {INFINITY, 0};

    for (int n = 0; n < d->r->count; n++)
        widen(&ratio, table23_value(d, n, TABLE23_PAPER_MS) /
                          table23_value(d, n, TABLE23_PRINTED_MS));
    fprintf(file,
            "- Milliseconds. The paper's frames take %.3g to %.3g times ours. That number "
            "is a machine (an i7-7700 of 2017,\n  assembly on its 4 cores; one thread "
            "here), a compiler, a linear algebra library and a code in one, and nothing in "
            "the\n  paper separates them. Ratios between rows are free of the machine's "
            "speed: only they are compared below.\n",
            ratio.low, ratio.high);
}

enum { FIRST = TABLE23_GROWTH, LAST = FIRST + TABLE23_GROWTH_ROWS - 1 };

/* Of the rows that differ in their net alone, from `first` on. */
static double exponent(const struct table23 *d, int first, enum table23_quantity q)
{
    return table23_exponent(d, first, LAST - first + 1, q);
}

/* Per cent of a rebuilt frame's three phases. */
static double share(const struct table23 *d, int row, enum table23_quantity phase)
{
    double sum = 0;

    for (int p = TABLE23_ASSEMBLE_MS; p <= TABLE23_SOLVE_MS; p++)
        sum += table23_value(d, row, p);
    return 100 * table23_value(d, row, phase) / sum;
}

static void tell_growth(const struct table23 *d, FILE *file)
{
    fprintf(file,
            "- Growth. The paper's frames grow as (control points)^%.2f over 5, 10, 15 and "
            "20 points a side, ^%.2f over the\n  last three; ours as ^%.2f rebuilt (K and "
            "M alone ^%.2f, factor alone ^%.2f) and ^%.2f prefactored.\n",
            exponent(d, FIRST, TABLE23_PAPER_MS), exponent(d, FIRST + 1, TABLE23_PAPER_MS),
            exponent(d, FIRST, TABLE23_PRINTED_MS), exponent(d, FIRST, TABLE23_ASSEMBLE_MS),
            exponent(d, FIRST, TABLE23_FACTOR_MS),
            exponent(d, FIRST, TABLE23_PREFACTORED_MS));
    fprintf(file,
            "- Why. A frame is K and M, which cost a fixed sum an element (elements grow "
            "as ^%.2f here), and the factor, whose\n  multiplications grow as ^%.2f (2 for "
            "a band in the limit). K and M are %.0f %% of the work at 5x5 and %.0f %% at "
            "20x20,\n  the factor %.0f and %.0f %%: a frame's exponent lies between those "
            "of its parts. The paper's %.2f is near that\n  of a band factorisation alone; "
            "where its frames spend their time it does not say.\n",
            exponent(d, FIRST, TABLE23_ELEMENTS), exponent(d, FIRST, TABLE23_FACTOR_WORK),
            share(d, FIRST, TABLE23_ASSEMBLE_MS), share(d, LAST, TABLE23_ASSEMBLE_MS),
            share(d, FIRST, TABLE23_FACTOR_MS), share(d, LAST, TABLE23_FACTOR_MS),
            exponent(d, FIRST + 1, TABLE23_PAPER_MS));
    fprintf(file,
            "- Prefactored. One factorisation for all frames makes a frame %.0f times "
            "cheaper at 20x20 than a rebuilt one; the\n  paper's scheme rebuilds because "
            "its matrices follow the sheet.\n",
            table23_value(d, LAST, TABLE23_PRINTED_MS) /
                table23_value(d, LAST, TABLE23_PREFACTORED_MS));
}

/* Rows of one net and degree differ in nothing that costs: how far apart are they? */
static void tell_same(const struct table23 *d, FILE *file)
{
    struct range printed = {INFINITY, 0}, ours = {INFINITY, 0};
    const int same[] = {0, 1, TABLE23_GROWTH + 1};

    for (int n = 0; n < 3; n++) {
        widen(&printed, table23_value(d, same[n], TABLE23_PAPER_MS));
        widen(&ours, table23_value(d, same[n], TABLE23_PRINTED_MS));
    }
    fprintf(file,
            "- Scatter. Three rows of Table 2 are one net and degree, 10x10x2 and (2,2,1): "
            "the paper has %.0f to %.0f ms for them\n  (%.0f %% apart), we have %.3g to "
            "%.3g (%.0f %%). Differences below that say nothing.\n",
            printed.low, printed.high, 100 * (printed.high / printed.low - 1), ours.low,
            ours.high, 100 * (ours.high / ours.low - 1));
}

/* Farther from the ground than any sheet that lies on it [m]. */
static const double CLEAR = 0.05;

/* What contact costs by a kinematics, over the flag on the same net, and its factorisations
 * a frame. */
static double contact_ratio(const struct table23 *d, enum table23_kind kind,
                            double *factors)
{
    const struct counters *work = &table23_result(d, TABLE23_CONTACT, kind)->work;

    *factors = (double)work->factorisations / (double)work->steps;
    return over(d, TABLE23_CONTACT, TABLE23_FLAG, TABLE23_PRINTED_MS + kind);
}

static void tell_contact(const struct table23 *d, FILE *file)
{
    const struct run_result *printed = table23_result(d, TABLE23_CONTACT, TABLE23_PRINTED);
    const double gap = table23_gap(d, TABLE23_CONTACT);
    double factors, ratio = contact_ratio(d, TABLE23_PRINTED, &factors);

    fprintf(file,
            "- Contact. In the paper the sheet on the ground costs %.2f times the flag on "
            "the same net: contact costs nothing\n  there. ",
            over(d, TABLE23_CONTACT, TABLE23_FLAG, TABLE23_PAPER_MS));
    if (isnan(ratio)) {
        fprintf(file, "Here it was not run, for the reason noted above.\n");
        return;
    }
    fprintf(file, "Here it costs %.2f times the flag, fall and landing together", ratio);
    if (printed->work.steps) {
        fprintf(file,
                ", at %.2f factorisations a frame; after\n  %ld frames its lowest point is "
                "%.2g m above the ground%s.\n",
                factors, printed->work.steps, gap,
                gap > CLEAR ? ": the scheme has thrown it up again" : "");
        return;
    }
    ratio = contact_ratio(d, TABLE23_INCREMENTAL, &factors);
    fprintf(file,
            ", up to the death noted above: the\n  printed scheme throws it up again "
            "(study contact). Incremental kinematics, which lives: %.2f times, at %.2f\n  "
            "factorisations a frame.\n",
            ratio, factors);
}

static void tell_degree(const struct table23 *d, FILE *file)
{
    for (int low = 0; low < 2; low++) {
        int high = low + 2, side = table23_net(d, low)->points[0];
        const double ratio = over(d, high, low, TABLE23_PAPER_MS);
        const double assembly = over(d, high, low, TABLE23_ASSEMBLY_WORK);
        const double factors = over(d, high, low, TABLE23_FACTOR_WORK);
        fprintf(file,
                "- Degree, 2x%dx%d. From (1,2,2) to (1,3,3) the paper's frame costs %.2f "
                "times as much, ours %.2f times. Plain\n  quadrature has %.2f times the "
                "multiplications, a band factor %.2f times: the paper's %.2f is %s.\n",
                side, side, ratio, over(d, high, low, TABLE23_PRINTED_MS), assembly,
                factors, ratio,
                ratio < fmin(assembly, factors) ? "below both, so\n  that a good part of "
                                                  "its frame does not depend on the degree"
                : ratio < assembly              ? "between the two"
                                                : "more than either");
    }
}

/* Table 3 against Table 2, both the paper's. */
static void tell_consistency(const struct table23 *d, FILE *file)
{
    const double second[] = {paper_table2_ms[TABLE23_GROWTH + 1],
                             paper_table2_ms[TABLE23_GROWTH + 2],
                             paper_table2_ms[TABLE23_GROWTH + 4]};
    double third[4];

    for (int n = 0; n < 4; n++)
        third[n] = table23_value(d, n, TABLE23_PAPER_MS);
    fprintf(file,
            "- Consistency. Table 3 has %.0f, %.0f and %.0f ms where Table 2 has %.0f, "
            "%.0f and %.0f for the same net and degree\n  with the thickness in w: one "
            "measurement told twice, or two that agree to %.1f %%. Only %.0f ms is new.\n",
            third[0], third[1], third[2], second[0], second[1], second[2],
            100 * (third[0] / second[0] - 1), third[3]);
    fprintf(file,
            "- Growth. From 200 to 450 control points the paper's frames grow as ^%.2f at "
            "(1,2,2) and ^%.2f at (1,3,3), ours as\n  ^%.2f and ^%.2f (K and M alone ^%.2f "
            "and ^%.2f, factor alone ^%.2f and ^%.2f).\n",
            table23_exponent(d, 0, 2, TABLE23_PAPER_MS),
            table23_exponent(d, 2, 2, TABLE23_PAPER_MS),
            table23_exponent(d, 0, 2, TABLE23_PRINTED_MS),
            table23_exponent(d, 2, 2, TABLE23_PRINTED_MS),
            table23_exponent(d, 0, 2, TABLE23_ASSEMBLE_MS),
            table23_exponent(d, 2, 2, TABLE23_ASSEMBLE_MS),
            table23_exponent(d, 0, 2, TABLE23_FACTOR_MS),
            table23_exponent(d, 2, 2, TABLE23_FACTOR_MS));
}

void table23_text(const struct table23 *d, FILE *file)
{
    fprintf(file, "What was reproduced, and what not\n\n");
    tell_machine(d, file);
    if (d->second) {
        tell_growth(d, file);
        tell_same(d, file);
        tell_contact(d, file);
    } else {
        tell_consistency(d, file);
        tell_degree(d, file);
    }
    measurement_machine(d->r->machine, file);
}

#include "bench/tables/table23.h"

#include <math.h>

#include "bench/harness/fit.h"
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

bool table23_quick(const struct table23 *t, int row)
{
    const struct study *s = &t->r->study[row];

    return s->plan->quick_count && s->time == s->plan->quick_times;
}

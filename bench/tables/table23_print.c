/* The tables of table23.h. */
#include <math.h>
#include <string.h>

#include "bench/harness/fit.h"
#include "bench/tables/table23.h"

static const char *label(const struct table23_row *row)
{
    return *row->paper->figure ? row->paper->figure : "Table 3";
}

static void net_cell(struct table *t, const int n[3])
{
    table_text(t, "%dx%dx%d", n[0], n[1], n[2]);
}

static void degree_cell(struct table *t, const int p[3])
{
    table_text(t, "(%d,%d,%d)", p[0], p[1], p[2]);
}

static void number_or_dash(struct table *t, double value, int digits)
{
    if (isnan(value))
        table_dash(t);
    else
        table_number(t, value, digits);
}

static enum status finish(struct table *t, enum table_format format, FILE *file)
{
    enum status st = table_print(t, format, file);

    table_destroy(t);
    if (st == STATUS_OK)
        fprintf(file, "\n");
    return st;
}

/* What was run: the paper's parameters, and what they make. */
static enum status print_rows(const struct table23_data *d, enum table_format format,
                              FILE *file)
{
    static const struct table_column columns[] = {{"row", NULL, TABLE_LEFT},
                                                  {"scene", NULL, TABLE_LEFT},
                                                  {"degree", NULL, TABLE_LEFT},
                                                  {"net", NULL, TABLE_LEFT},
                                                  {"ours", NULL, TABLE_LEFT},
                                                  {"E", "Pa", 0},
                                                  {"nu", NULL, 0},
                                                  {"rho", "kg/m^3", 0},
                                                  {"mu", NULL, 0},
                                                  {"Gamma", NULL, 0},
                                                  {"points", NULL, 0},
                                                  {"elements", NULL, 0},
                                                  {"unknowns", NULL, 0},
                                                  {"factor", "entries", 0}};
    bool second = d->which == TABLE23_SECOND;
    struct table *t =
        table_create(sizeof columns / sizeof *columns, columns,
                     second ? "Table 2: what was run" : "Table 3: what was run");

    for (int n = 0; n < d->rows; n++) {
        const struct table23_row *row = &d->row[n];
        const struct timed_result *r = &d->cell[n][TABLE23_PRINTED];
        table_row(t);
        table_text(t, "%s", label(row));
        table_text(t, "%s", row->scene);
        degree_cell(t, row->paper->degree);
        net_cell(t, row->paper->points);
        net_cell(t, row->points);
        table_text(t, "%g", row->young);
        table_fixed(t, row->poisson, 1);
        table_fixed(t, row->density, 1);
        table_fixed(t, row->damping, 1);
        number_or_dash(t, d->gamma[n], 4);
        table_integer(t, table23_control_points(row));
        table_integer(t, table23_elements(row));
        if (r->refused)
            continue;
        table_integer(t, lround(r->unknowns));
        table_integer(t, lround(r->factor_entries));
    }
    table_note(t,
               "Degree and net in the order the paper prints them; a net 2 x n x n has the "
               "thickness in u, ours has it last.");
    if (second)
        table_note(t,
                   "The paper does not say what moves in Figs. 12 and 13: edge_drop here. "
                   "A solid's frame costs the same whatever moves, as the rows of one "
                   "net show.");
    else
        table_note(t, "The paper gives Table 3 neither scene nor material: edge_drop with "
                      "those of Fig. 12 here.");
    return finish(t, format, file);
}

/* The row that others are told as multiples of: the paper's net of 10 x 10 at p = 2. */
static int unit_row(const struct table23_data *d)
{
    return d->which == TABLE23_SECOND ? PAPER_GROWTH + 1 : 0;
}

static void cost_cells(struct table *t, const struct table23_data *d, int n)
{
    const struct clock_summary *step = &d->cell[n][TABLE23_PRINTED].step;
    double printed = table23_cost(d, n, TABLE23_PRINTED),
           paper = d->row[n].paper->milliseconds;
    int unit = unit_row(d);

    number_or_dash(t, printed, 3);
    if (step->count)
        table_text(t, "%.3g-%.3g", 1e3 * step->lower, 1e3 * step->upper);
    else
        table_dash(t);
    number_or_dash(t, table23_cost(d, n, TABLE23_INCREMENTAL), 3);
    number_or_dash(t, table23_cost(d, n, TABLE23_LINEAR), 3);
    table_number(t, paper, paper < 1000 ? 3 : 4);
    number_or_dash(t, paper / printed, 3);
    number_or_dash(t, printed / table23_cost(d, unit, TABLE23_PRINTED), 3);
    table_number(t, paper / d->row[unit].paper->milliseconds, 3);
}

/* A sentence for every dash and every death. */
static void note_outcomes(struct table *t, const struct table23_data *d)
{
    for (int n = 0; n < d->rows; n++)
        for (int kind = 0; kind < TABLE23_KINDS; kind++) {
            const struct timed_result *r = &d->cell[n][kind];
            if (r->refused)
                table_note(t, "%s, %s: %s.", label(&d->row[n]), table23_kind_name[kind],
                           r->refused);
            else if (strcmp(r->outcome, "done") != 0)
                table_note(t, "%s, %s: %s; the frames before it are timed.",
                           label(&d->row[n]), table23_kind_name[kind], r->outcome);
        }
}

static enum status print_cost(const struct table23_data *d, enum table_format format,
                              FILE *file)
{
    static const struct table_column columns[] = {
        {"row", NULL, TABLE_LEFT},  {"degree", NULL, TABLE_LEFT},
        {"net", NULL, TABLE_LEFT},  {"printed", "ms", 0},
        {"quartiles", "ms", 0},     {"incremental", "ms", 0},
        {"prefactored", "ms", 0},   {"paper", "ms", 0},
        {"paper/printed", NULL, 0}, {"printed/10x10", NULL, 0},
        {"paper's", NULL, 0}};
    bool second = d->which == TABLE23_SECOND;
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   second ? "Table 2: milliseconds a frame"
                                          : "Table 3: milliseconds a frame");

    for (int n = 0; n < d->rows; n++) {
        table_row(t);
        table_text(t, "%s", label(&d->row[n]));
        degree_cell(t, d->row[n].degree);
        net_cell(t, d->row[n].points);
        cost_cells(t, d, n);
    }
    table_note(
        t,
        "Mean over the frames of a repeat, then median and quartiles of %d repeats, all "
        "cases in turn, one thread. printed and incremental: matrices and factor anew "
        "every frame, as in the paper. prefactored: linear kinematics, one "
        "factorisation for all frames.",
        d->cell[unit_row(d)][TABLE23_PRINTED].step.count);
    note_outcomes(t, d);
    return finish(t, format, file);
}

static void full_row(struct table *t, const struct table23_data *d, int n, int kind)
{
    const struct timed_result *r = &d->cell[n][kind];

    table_row(t);
    table_text(t, "%s", label(&d->row[n]));
    degree_cell(t, d->row[n].degree);
    net_cell(t, d->row[n].points);
    table_text(t, "%s", table23_kind_name[kind]);
    if (r->refused || !r->step.count) {
        for (int k = 0; k < 8; k++)
            table_dash(t);
        return;
    }
    table_number(t, 1e3 * r->create.median, 3);
    table_number(t, 1e3 * r->step.median, 3);
    table_number(t, 1e3 * r->step.min, 3);
    table_text(t, "%.3g-%.3g", 1e3 * r->step.lower, 1e3 * r->step.upper);
    table_integer(t, r->work.steps);
    table_integer(t, r->work.assemblies);
    table_integer(t, r->work.factorisations);
    table_integer(t, r->work.solves);
}

static enum status print_full(const struct table23_data *d, enum table_format format,
                              FILE *file)
{
    static const struct table_column columns[] = {
        {"row", NULL, TABLE_LEFT}, {"degree", NULL, TABLE_LEFT},
        {"net", NULL, TABLE_LEFT}, {"kinematics", NULL, TABLE_LEFT},
        {"set-up", "ms", 0},       {"median", "ms", 0},
        {"min", "ms", 0},          {"quartiles", "ms", 0},
        {"frames", NULL, 0},       {"assemblies", NULL, 0},
        {"factored", NULL, 0},     {"solves", NULL, 0}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Every case, with the work of a motion of its own");

    for (int n = 0; n < d->rows; n++) {
        if (n)
            table_rule(t);
        for (int kind = 0; kind < TABLE23_KINDS; kind++)
            full_row(t, d, n, kind);
    }
    return finish(t, format, file);
}

/* One quantity over the rows that differ in their net alone, and its exponent of the
 * control points. */
struct growth {
    const char *name, *unit;
    double value[PAPER_GROWTH_ROWS];
};

static void growth_row(struct table *t, const struct table23_data *d,
                       const struct growth *g)
{
    double points[PAPER_GROWTH_ROWS];

    table_row(t);
    table_text(t, "%s", g->name);
    table_text(t, "%s", g->unit);
    for (int n = 0; n < PAPER_GROWTH_ROWS; n++) {
        points[n] = table23_control_points(&d->row[PAPER_GROWTH + n]);
        number_or_dash(t, g->value[n], 4);
    }
    number_or_dash(t, fit_exponent(PAPER_GROWTH_ROWS, points, g->value), 3);
    number_or_dash(t, fit_exponent(PAPER_GROWTH_ROWS - 1, points + 1, g->value + 1), 3);
}

static enum status print_growth(const struct table23_data *d, enum table_format format,
                                FILE *file)
{
    static const struct table_column columns[] = {
        {"quantity", NULL, TABLE_LEFT}, {"unit", NULL, TABLE_LEFT},   {"5x5x2", NULL, 0},
        {"10x10x2", NULL, 0},           {"15x15x2", NULL, 0},         {"20x20x2", NULL, 0},
        {"exponent", "all four", 0},    {"exponent", "last three", 0}};
    struct growth g[] = {{"frame, printed", "ms", {0}},
                         {"frame, incremental", "ms", {0}},
                         {"frame, prefactored", "ms", {0}},
                         {"K and M alone", "ms", {0}},
                         {"factor alone", "ms", {0}},
                         {"solve alone", "ms", {0}},
                         {"elements", "", {0}},
                         {"factor entries", "", {0}},
                         {"factor multiplications", "~", {0}},
                         {"paper", "ms", {0}}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Growth with the net, Fig. 12: y ~ (control points)^e");

    for (int n = 0; n < PAPER_GROWTH_ROWS; n++) {
        int row = PAPER_GROWTH + n;
        const double value[] = {table23_cost(d, row, TABLE23_PRINTED),
                                table23_cost(d, row, TABLE23_INCREMENTAL),
                                table23_cost(d, row, TABLE23_LINEAR),
                                table23_phase(d, row, BENCH_SOLID_ASSEMBLE),
                                table23_phase(d, row, BENCH_SOLID_FACTOR),
                                table23_phase(d, row, BENCH_SOLID_SOLVE),
                                table23_elements(&d->row[row]),
                                d->cell[row][TABLE23_PRINTED].factor_entries,
                                table23_factor_work(d, row),
                                d->row[row].paper->milliseconds};
        for (size_t k = 0; k < sizeof g / sizeof *g; k++)
            g[k].value[n] = value[k];
    }
    for (size_t k = 0; k < sizeof g / sizeof *g; k++)
        growth_row(t, d, &g[k]);
    table_note(
        t, "Least squares in logarithms. Factor multiplications: unknowns x bandwidth^2, "
           "the bandwidth taken as entries / unknowns.");
    return finish(t, format, file);
}

/* Table 3: what raising the degree costs, as ratios at one net. Rows 0, 1 and 2, 3 are the
 * degrees; 0, 2 and 1, 3 the nets. */
static enum status print_degree(const struct table23_data *d, enum table_format format,
                                FILE *file)
{
    static const struct table_column columns[] = {
        {"net", NULL, TABLE_LEFT}, {"paper", NULL, 0},      {"printed", NULL, 0},
        {"prefactored", NULL, 0},  {"K and M", NULL, 0},    {"factor", NULL, 0},
        {"K and M", "counted", 0}, {"factor", "counted", 0}};
    struct table *t = table_create(sizeof columns / sizeof *columns, columns,
                                   "Cost of degree (1,3,3) over that of (1,2,2), same net");

    for (int low = 0; low < 2; low++) {
        int high = low + 2;
        table_row(t);
        net_cell(t, d->row[low].points);
        table_number(t, d->row[high].paper->milliseconds / d->row[low].paper->milliseconds,
                     3);
        number_or_dash(t,
                       table23_cost(d, high, TABLE23_PRINTED) /
                           table23_cost(d, low, TABLE23_PRINTED),
                       3);
        number_or_dash(
            t, table23_cost(d, high, TABLE23_LINEAR) / table23_cost(d, low, TABLE23_LINEAR),
            3);
        for (int phase = 0; phase < BENCH_SOLID_SOLVE; phase++)
            number_or_dash(t, table23_phase(d, high, phase) / table23_phase(d, low, phase),
                           3);
        table_number(
            t, table23_assembly_work(&d->row[high]) / table23_assembly_work(&d->row[low]),
            3);
        number_or_dash(t, table23_factor_work(d, high) / table23_factor_work(d, low), 3);
    }
    table_note(t,
               "Counted: K and M as elements x functions^2 x Gauss points, the factor as "
               "unknowns x bandwidth^2 with bandwidth = entries / unknowns.");
    return finish(t, format, file);
}

enum status table23_print(enum table23 which, const char *folder, enum table_format format,
                          FILE *file, struct message *why)
{
    struct table23_data *d = NULL;
    enum status st;

    TRY(table23_load(which, folder, &d, why));
    TRY(print_rows(d, format, file));
    TRY(print_cost(d, format, file));
    TRY(print_full(d, format, file));
    TRY(which == TABLE23_SECOND ? print_growth(d, format, file)
                                : print_degree(d, format, file));
    if (format == TABLE_TEXT)
        table23_text(d, file);
    TRY(table23_plot(d, folder, why));
out:
    table23_destroy(d);
    return st;
}

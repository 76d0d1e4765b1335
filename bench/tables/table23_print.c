/* The tables, CSV file and chart of table23.h. */
#include <math.h>
#include <string.h>

#include "bench/experiment/measurement.h"
#include "bench/tables/table23.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

static const char *label(const struct table23 *d, int row)
{
    return d->r->study[row].plan->caption;
}

static void net_cell(struct table *t, const int n[3])
{
    table_text(t, "%dx%dx%d", n[0], n[1], n[2]);
}

static void degree_cell(struct table *t, const int p[3])
{
    table_text(t, "(%d,%d,%d)", p[0], p[1], p[2]);
}

/* Degree and net as the paper writes them, which is as ours unless the plan says so. */
static void paper_cells(struct table *t, const struct table23 *d, int row)
{
    const char *words = d->r->study[row].plan->paper_net;
    const char *net = words ? strchr(words, ' ') : NULL;

    if (net) {
        table_text(t, "%.*s", (int)(net - words), words);
        table_text(t, "%s", net + 1);
    } else {
        degree_cell(t, table23_net(d, row)->degree);
        net_cell(t, table23_net(d, row)->points);
    }
}

/* For people "0.503-0.545"; for machines one number after the other. */
static void quartile_cells(struct table *t, const struct clock_summary *s)
{
    if (s->count)
        table_text(t, "%.3g-%.3g", 1e3 * s->lower, 1e3 * s->upper);
    else
        table_dash(t);
    table_number(t, s->count ? 1e3 * s->lower : NAN, 3);
    table_number(t, s->count ? 1e3 * s->upper : NAN, 3);
}

static const char *caption(const struct table23 *d, const char *second, const char *third)
{
    return d->second ? second : third;
}

/* What was run: the paper's parameters, and what they make. */
static enum status print_rows(const struct table23 *d, enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {{"row", NULL, TABLE_LEFT},
                                                  {"scene", NULL, TABLE_LEFT},
                                                  {"degree", NULL, TABLE_LEFT},
                                                  {"net", NULL, TABLE_LEFT},
                                                  {"ours", NULL, TABLE_LEFT},
                                                  {"E", "Pa"},
                                                  {"nu"},
                                                  {"rho", "kg/m^3"},
                                                  {"mu"},
                                                  {"Gamma"},
                                                  {"points"},
                                                  {"elements"},
                                                  {"unknowns"},
                                                  {"factor", "entries"}};
    struct table *t =
        table_create(COUNT(columns), columns,
                     caption(d, "Table 2: what was run", "Table 3: what was run"));

    for (int n = 0; n < d->r->count; n++) {
        const struct scene *scene = &d->r->study[n].row[TABLE23_PRINTED].run.scene;
        const struct run_result *r = table23_result(d, n, TABLE23_PRINTED);
        table_row(t);
        table_text(t, "%s", label(d, n));
        table_text(t, "%s", scene->name);
        paper_cells(t, d, n);
        net_cell(t, table23_net(d, n)->points);
        table_text(t, "%g", scene->young);
        table_fixed(t, scene->poisson, 1);
        table_fixed(t, scene->density, 1);
        table_fixed(t, scene->damping.value, 1);
        table_number(t, scene_gamma(scene), 4);
        table_fixed(t, table23_value(d, n, TABLE23_POINTS), 0);
        table_fixed(t, table23_value(d, n, TABLE23_ELEMENTS), 0);
        if (run_result_refused(r))
            continue;
        table_fixed(t, r->unknowns, 0);
        table_fixed(t, r->factor_entries, 0);
    }
    table_note(t, "Degree and net in the order the paper prints them; a net 2 x n x n has "
                  "the thickness in u, ours has it last.");
    table_note(
        t, "%s",
        caption(d,
                "The paper does not say what moves in Figs. 12 and 13: edge_drop here. A "
                "solid's frame costs the same whatever moves, as the rows of one net show.",
                "The paper gives Table 3 neither scene nor material: edge_drop with those "
                "of Fig. 12 here."));
    return table_finish(t, format, file);
}

/* The row that others are told as multiples of: the paper's net of 10 x 10 at p = 2. */
static int unit_row(const struct table23 *d)
{
    return d->second ? TABLE23_GROWTH + 1 : 0;
}

static void cost_row(struct table *t, const struct table23 *d, int n)
{
    const struct discretization *net = table23_net(d, n);
    const struct run_result *r = table23_result(d, n, TABLE23_PRINTED);
    const bool refused = run_result_refused(r);
    const double printed = table23_value(d, n, TABLE23_PRINTED_MS);
    const double paper = table23_value(d, n, TABLE23_PAPER_MS);
    const int unit = unit_row(d);

    table_row(t);
    table_text(t, "%s", label(d, n));
    table_text(t, "%s", d->r->study[n].row[TABLE23_PRINTED].run.scene.name);
    degree_cell(t, net->degree);
    net_cell(t, net->points);
    for (int i = 0; i < 6; i++)
        table_integer(t, i < 3 ? net->degree[i] : net->points[i - 3]);
    table_fixed(t, table23_value(d, n, TABLE23_POINTS), 0);
    table_fixed(t, table23_value(d, n, TABLE23_ELEMENTS), 0);
    table_fixed(t, refused ? NAN : r->unknowns, 0);
    table_fixed(t, refused ? NAN : r->factor_entries, 0);
    table_number(t, printed, 3);
    quartile_cells(t, &r->step);
    for (int ours = TABLE23_INCREMENTAL_MS; ours <= TABLE23_SOLVE_MS; ours++)
        table_number(t, table23_value(d, n, ours), 3);
    table_number(t, paper, paper < 1000 ? 3 : 4);
    table_number(t, paper / printed, 3);
    table_number(t, printed / table23_value(d, unit, TABLE23_PRINTED_MS), 3);
    table_number(t, paper / table23_value(d, unit, TABLE23_PAPER_MS), 3);
}

static struct table *cost_table(const struct table23 *d)
{
    static const struct table_column columns[] = {
        {"row", NULL, TABLE_LEFT, .key = "figure"},
        {"scene", NULL, TABLE_LEFT, .readers = TABLE_MACHINES},
        {"degree", NULL, TABLE_LEFT, .readers = TABLE_PEOPLE},
        {"net", NULL, TABLE_LEFT, .readers = TABLE_PEOPLE},
        {"p", .readers = TABLE_MACHINES},
        {"q", .readers = TABLE_MACHINES},
        {"r", .readers = TABLE_MACHINES},
        {"n", .readers = TABLE_MACHINES},
        {"m", .readers = TABLE_MACHINES},
        {"l", .readers = TABLE_MACHINES},
        {"control points", .readers = TABLE_MACHINES},
        {"elements", .readers = TABLE_MACHINES},
        {"unknowns", .readers = TABLE_MACHINES},
        {"factor entries", .readers = TABLE_MACHINES},
        {"printed", "ms"},
        {"quartiles", "ms", .readers = TABLE_PEOPLE},
        {"printed lower", "ms", .readers = TABLE_MACHINES},
        {"printed upper", "ms", .readers = TABLE_MACHINES},
        {"incremental", "ms"},
        {"prefactored", "ms"},
        {"assemble", "ms", .readers = TABLE_MACHINES},
        {"factor", "ms", .readers = TABLE_MACHINES},
        {"solve", "ms", .readers = TABLE_MACHINES},
        {"paper", "ms"},
        {"paper/printed", .readers = TABLE_PEOPLE},
        {"printed/10x10", .readers = TABLE_PEOPLE},
        {"paper's", .readers = TABLE_PEOPLE}};
    struct table *t = table_create(
        COUNT(columns), columns,
        caption(d, "Table 2: milliseconds a frame", "Table 3: milliseconds a frame"));

    for (int n = 0; n < d->r->count; n++)
        cost_row(t, d, n);
    return t;
}

/* A sentence for every dash and every death. */
static void note_outcomes(struct table *t, const struct table23 *d)
{
    for (int n = 0; n < d->r->count; n++)
        for (int kind = 0; kind < TABLE23_KINDS; kind++) {
            const struct run_result *r = table23_result(d, n, kind);
            if (r->outcome)
                table_note(t, "%s, %s: %s%s.", label(d, n),
                           d->r->study[n].row[kind].level->label, r->sentence.text,
                           run_result_refused(r) ? "" : "; the frames before it are timed");
        }
}

static enum status print_cost(const struct table23 *d, const char *folder,
                              enum table_format format, FILE *file, struct message *why)
{
    struct table *t = cost_table(d);
    enum status st;

    TRY(table_save(t, folder, "cost", why));
    table_note(t,
               "Mean over the frames of a repeat, then median and quartiles of %d repeats, "
               "all cases in turn, one thread. printed and incremental: matrices and "
               "factor anew every frame, as in the paper. prefactored: linear kinematics, "
               "one factorisation for all frames.",
               table23_result(d, unit_row(d), TABLE23_PRINTED)->step.count);
    note_outcomes(t, d);
    return table_finish(t, format, file);
out:
    table_destroy(t);
    return st;
}

static void full_row(struct table *t, const struct table23 *d, int n, int kind)
{
    const struct run_result *r = table23_result(d, n, kind);

    table_row(t);
    table_text(t, "%s", label(d, n));
    degree_cell(t, table23_net(d, n)->degree);
    net_cell(t, table23_net(d, n)->points);
    table_text(t, "%s", d->r->study[n].row[kind].level->label);
    if (!r->step.count) {
        for (int k = 0; k < 10; k++)
            table_dash(t);
        return;
    }
    table_number(t, 1e3 * r->create.median, 3);
    table_number(t, 1e3 * r->step.median, 3);
    table_number(t, 1e3 * r->step.min, 3);
    quartile_cells(t, &r->step);
    table_integer(t, r->work.steps);
    table_integer(t, r->work.assemblies);
    table_integer(t, r->work.factorisations);
    table_integer(t, r->work.solves);
}

static enum status print_full(const struct table23 *d, enum table_format format, FILE *file)
{
    static const struct table_column columns[] = {
        {"row", NULL, TABLE_LEFT},
        {"degree", NULL, TABLE_LEFT},
        {"net", NULL, TABLE_LEFT},
        {"kinematics", NULL, TABLE_LEFT},
        {"set-up", "ms"},
        {"median", "ms"},
        {"min", "ms"},
        {"quartiles", "ms", .readers = TABLE_PEOPLE},
        {"lower", "ms", .readers = TABLE_MACHINES},
        {"upper", "ms", .readers = TABLE_MACHINES},
        {"frames"},
        {"assemblies"},
        {"factored"},
        {"solves"}};
    struct table *t = table_create(COUNT(columns), columns,
                                   "Every case, with the work of a motion of its own");

    for (int n = 0; n < d->r->count; n++) {
        if (n)
            table_rule(t);
        for (int kind = 0; kind < TABLE23_KINDS; kind++)
            full_row(t, d, n, kind);
    }
    return table_finish(t, format, file);
}

/* --- how a frame's cost grows: over nets (Table 2), over degrees (Table 3)
 * ---------------- */

static enum status print_growth(const struct table23 *d, enum table_format format,
                                FILE *file)
{
    static const struct table_column columns[] = {{"quantity", NULL, TABLE_LEFT},
                                                  {"unit", NULL, TABLE_LEFT},
                                                  {"5x5x2"},
                                                  {"10x10x2"},
                                                  {"15x15x2"},
                                                  {"20x20x2"},
                                                  {"exponent", "all four"},
                                                  {"exponent", "last three"}};
    static const struct {
        const char *name, *unit;
        enum table23_quantity of;
    } quantity[] = {{"frame, printed", "ms", TABLE23_PRINTED_MS},
                    {"frame, incremental", "ms", TABLE23_INCREMENTAL_MS},
                    {"frame, prefactored", "ms", TABLE23_PREFACTORED_MS},
                    {"K and M alone", "ms", TABLE23_ASSEMBLE_MS},
                    {"factor alone", "ms", TABLE23_FACTOR_MS},
                    {"solve alone", "ms", TABLE23_SOLVE_MS},
                    {"elements", "", TABLE23_ELEMENTS},
                    {"factor entries", "", TABLE23_ENTRIES},
                    {"factor multiplications", "~", TABLE23_FACTOR_WORK},
                    {"paper", "ms", TABLE23_PAPER_MS}};
    struct table *t = table_create(COUNT(columns), columns,
                                   "Growth with the net, Fig. 12: y ~ (control points)^e");

    for (int k = 0; k < COUNT(quantity); k++) {
        table_row(t);
        table_text(t, "%s", quantity[k].name);
        table_text(t, "%s", quantity[k].unit);
        for (int n = 0; n < TABLE23_GROWTH_ROWS; n++)
            table_number(t, table23_value(d, TABLE23_GROWTH + n, quantity[k].of), 4);
        for (int skip = 0; skip < 2; skip++)
            table_number(t,
                         table23_exponent(d, TABLE23_GROWTH + skip,
                                          TABLE23_GROWTH_ROWS - skip, quantity[k].of),
                         3);
    }
    table_note(t, "Least squares in logarithms. Factor multiplications: unknowns x "
                  "bandwidth^2, the bandwidth taken as entries / unknowns.");
    return table_finish(t, format, file);
}

/* Table 3: what raising the degree costs, as ratios at one net. Rows 0, 1 and 2, 3 are the
 * degrees; 0, 2 and 1, 3 the nets. */
static enum status print_degree(const struct table23 *d, enum table_format format,
                                FILE *file)
{
    static const struct table_column columns[] = {{"net", NULL, TABLE_LEFT},
                                                  {"paper"},
                                                  {"printed"},
                                                  {"prefactored"},
                                                  {"K and M"},
                                                  {"factor"},
                                                  {"K and M", "counted"},
                                                  {"factor", "counted"}};
    static const enum table23_quantity quantity[] = {
        TABLE23_PAPER_MS,    TABLE23_PRINTED_MS, TABLE23_PREFACTORED_MS,
        TABLE23_ASSEMBLE_MS, TABLE23_FACTOR_MS,  TABLE23_ASSEMBLY_WORK,
        TABLE23_FACTOR_WORK};
    struct table *t = table_create(COUNT(columns), columns,
                                   "Cost of degree (1,3,3) over that of (1,2,2), same net");

    for (int low = 0; low < 2; low++) {
        const int *n = table23_net(d, low)->points;
        table_row(t);
        table_text(t, "%dx%dx%d", n[0], n[1], n[2]);
        for (int k = 0; k < COUNT(quantity); k++)
            table_number(t,
                         table23_value(d, low + 2, quantity[k]) /
                             table23_value(d, low, quantity[k]),
                         3);
    }
    table_note(t, "Counted: K and M as elements x functions^2 x Gauss points, the factor "
                  "as unknowns x bandwidth^2 with bandwidth = entries / unknowns.");
    return table_finish(t, format, file);
}

enum status table23_print(const struct table23 *d, const char *folder,
                          enum table_format format, FILE *file, struct message *why)
{
    const bool prose = table_format_is_prose(format);
    enum status st;

    if (prose)
        table23_headline(d, file);
    TRY(print_rows(d, format, file));
    TRY(print_cost(d, folder, format, file, why));
    TRY(print_full(d, format, file));
    TRY(d->second ? print_growth(d, format, file) : print_degree(d, format, file));
    if (prose)
        table23_text(d, file);
    TRY(table23_draw(d, folder, why));
out:
    return st;
}

static enum status print(const struct study_results *r, const char *folder,
                         enum table_format format, FILE *file, struct message *why)
{
    const struct table23 t = {!strcmp(r->plan->name, table23_second.plan), r};
    const enum status st = table23_print(&t, folder, format, file, why);

    if (st == STATUS_OK && table_format_is_prose(format))
        measurement_machine(r->machine, file);
    return st;
}

const struct experiment table23_second = {
    .item = {"2", "Ren et al. 2024, Table 2: milliseconds a frame over ten scenes, and how "
                  "they grow with the net"},
    .plan = "table2",
    .tell = print,
};

const struct experiment table23_third = {
    .item = {"3", "Ren et al. 2024, Table 3: milliseconds a frame over degree and net"},
    .plan = "table3",
    .tell = print,
};

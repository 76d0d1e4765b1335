/* Frames of the solids and their phases: against aims, over nets, and what each choice
 * gives. */
#include <math.h>
#include <stdlib.h>

#include "bench/experiment/bench_solid.h"
#include "bench/harness/fit.h"
#include "bench/speed/bench_nets.h"
#include "bench/truth/paper.h"

#define LEN(array) (sizeof array / sizeof *array)

/* clang-format off */
const struct bench_net bench_nets[BENCH_NETS] = {
    {{"iga 10x10x2 rebuilt", "iga_paper", {0}, 0}, false, {0, 0, 0}, 0.7,
     "G+Smo 34.5 ms, MFEM 59 ms a frame; PetIGA K 3.1, M 1.8, factor 6.6 ms"},
    {{"iga 10x10x2 prefactored", "iga_linear", {UNDAMPED}, 0}, false, {0, 0, 0}, 0.025,
     "PetIGA 0.044 ms a step"},
    {{"hex 32x32x2 rebuilt", "hex_paper", {"discretization.points=[32,32,2]"}, 0}, false,
     {0, 0, 0}, 12, "PetIGA 50, MFEM 94, G+Smo 107, CalculiX 114 ms a step"},
    {{"iga 100x100x2 prefactored", "iga_linear",
      {UNDAMPED, "discretization.points=[100,100,2]"}, 0}, true, {80, 800, 0}, 20,
     "PetIGA K 517 ms, factor 2200 ms, step 39 ms; CHOLMOD solve 29.5 ms"},
};

/* What each choice gives: the same motion with it and without. */
static const struct lever {
    const char *what;
    struct bench_run with, without;
} levers[] = {
#define BAND       "discretization.solver=banded"
#define SUPERNODES "discretization.solver=cholmod"
#define SPLIT      "discretization.unknowns=points"
#define NET_40     "discretization.points=[40,40,2]"
    {"band instead of supernodes", {"iga 10x10x2 rebuilt", "iga_paper", {BAND}, 0},
     {NULL, "iga_paper", {SUPERNODES}, 0}},
    {"band instead of supernodes", {"hex 32x32x2 rebuilt", "hex_paper",
     {BAND, "discretization.points=[32,32,2]"}, 0},
     {NULL, "hex_paper", {SUPERNODES, "discretization.points=[32,32,2]"}, 0}},
    {"membrane and bending apart", {"iga 10x10x2 prefactored", "iga_linear", {UNDAMPED}, 0},
     {NULL, "iga_linear", {UNDAMPED, SPLIT}, 0}},
    {"membrane and bending apart", {"iga 40x40x2 prefactored", "iga_linear",
     {UNDAMPED, NET_40}, 0}, {NULL, "iga_linear", {UNDAMPED, NET_40, SPLIT}, 0}},
    {"one factorisation for all steps", {"iga 10x10x2", "iga_linear", {UNDAMPED}, 0},
     {NULL, "iga_paper", {0}, 0}},
};
/* clang-format on */

/* --- against aims ------------------------------------------------------------------------
 */

static enum status plan_nets(struct bench *b, struct message *why)
{
    enum status st = STATUS_OK;

    for (size_t n = 0; n < LEN(bench_nets) && st == STATUS_OK; n++)
        st = bench_part_add(b, &bench_nets[n].run, why);
    return st;
}

static void phase_row(struct table *t, const char *title, const char *phase,
                      const struct clock_summary *s, double aim)
{
    table_row(t);
    table_text(t, "%s", title);
    table_text(t, "%s", phase);
    bench_part_times(t, s);
    bench_part_aim(t, s, aim);
}

static enum status print_nets(const struct bench *b, struct message *why)
{
    static const char *const phase[] = {"K and M", "factor", "solve"};
    static const struct table_column columns[] = {{"case", NULL, TABLE_LEFT},
                                                  {"phase", NULL, TABLE_LEFT},
                                                  BENCH_PART_TIMES,
                                                  BENCH_PART_AIM};
    struct table *t =
        table_create(LEN(columns), columns, "Speed of the solids, one thread");
    enum status st = STATUS_OK;

    for (int n = 0; n < b->batch.count; n++) {
        const struct bench_net *net = &bench_nets[n];
        struct run_result r;
        TRY(batch_read(&b->batch, n, false, &r, why));
        phase_row(t, net->run.title, "frame", &r.step, net->frame);
        for (int p = 0; p < BENCH_SOLID_FRAME; p++)
            phase_row(t, net->run.title, phase[p], &r.phase[p], net->phase[p]);
        table_rule(t);
        table_note(t,
                   "%s: %.0f unknowns, %.0f numbers in L, set-up %.3g ms. Elsewhere, on "
                   "another machine: %s.",
                   net->run.title, r.unknowns, r.factor_entries, 1e3 * r.create.median,
                   net->elsewhere);
        run_result_clear(&r);
    }
    return table_finish(t, b->format, stdout);
out:
    table_destroy(t);
    return st;
}

const struct bench_part bench_part_solids = {
    .item = {"solids",
             "IGA plate and hexahedra: K and M, factor, solve, frame, against their aims"},
    .plan = plan_nets,
    .print = print_nets};

/* --- levers ------------------------------------------------------------------------------
 */

static enum status plan_levers(struct bench *b, struct message *why)
{
    enum status st = STATUS_OK;

    for (size_t n = 0; n < LEN(levers); n++) {
        TRY(bench_part_add(b, &levers[n].without, why));
        TRY(bench_part_add(b, &levers[n].with, why));
    }
out:
    return st;
}

static enum status print_levers(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {{"lever", NULL, TABLE_LEFT},
                                                  {"case", NULL, TABLE_LEFT},
                                                  {"without", "ms"},
                                                  {"with", "ms"},
                                                  {"gain"},
                                                  {"repeats"}};
    struct table *t = table_create(LEN(columns), columns, "What each lever gives, a frame");
    enum status st = STATUS_OK;

    for (int n = 0; n < b->batch.count / 2; n++) {
        struct run_result without, with;
        TRY(batch_read(&b->batch, 2 * n, false, &without, why));
        TRY(batch_read(&b->batch, 2 * n + 1, false, &with, why));
        table_row(t);
        table_text(t, "%s", levers[n].what);
        table_text(t, "%s", levers[n].with.title);
        table_number(t, 1e3 * without.step.median, 3);
        table_number(t, 1e3 * with.step.median, 3);
        table_number(t, without.step.median / with.step.median, 3);
        table_integer(t, with.step.count);
        run_result_clear(&without);
        run_result_clear(&with);
    }
    return table_finish(t, b->format, stdout);
out:
    table_destroy(t);
    return st;
}

const struct bench_part bench_part_levers = {
    .item = {"levers", "what the band, the splitting of unknowns, one factorisation give"},
    .plan = plan_levers,
    .print = print_levers};

/* --- growth ------------------------------------------------------------------------------
 */

static int side_of(int n)
{
    return 5 * (n + 1); /* of those rows of Table 2 */
}

static enum status plan_growth(struct bench *b, struct message *why)
{
    enum status st = STATUS_OK;

    for (int n = 0; n < PAPER_GROWTH_ROWS && st == STATUS_OK; n++) {
        st = bench_part_add(b, &(struct bench_run){NULL, "iga_paper", {0}, 0}, why);
        if (st == STATUS_OK)
            contestant_points(b->batch.cases[n].plan.contestant, side_of(n), side_of(n),
                              batch_settings(&b->batch));
    }
    return st;
}

/* What a fit needs, a number a net. */
struct growth {
    double unknowns[PAPER_GROWTH_ROWS], points[PAPER_GROWTH_ROWS];
    double elements[PAPER_GROWTH_ROWS], cost[PAPER_GROWTH_ROWS];
    double assemble[PAPER_GROWTH_ROWS], paper[PAPER_GROWTH_ROWS];
};

static void note_growth(struct table *t, const struct growth *g)
{
    enum { ROWS = PAPER_GROWTH_ROWS };

    table_note(
        t,
        "K and M alone grow as unknowns^%.2f and as elements^%.2f: a net of n "
        "points a side has (n - 2)^2 elements, so that elements per unknown more than "
        "double from 5 to 20.",
        fit_exponent(ROWS, g->unknowns, g->assemble),
        fit_exponent(ROWS, g->elements, g->assemble));
    table_note(
        t,
        "Cost grows as unknowns^%.2f (aim 1.2 or less), as control points^%.2f; the "
        "paper's as control points^%.2f over all four nets, ^%.2f over the last three.",
        fit_exponent(ROWS, g->unknowns, g->cost), fit_exponent(ROWS, g->points, g->cost),
        fit_exponent(ROWS, g->points, g->paper),
        fit_exponent(ROWS - 1, g->points + 1, g->paper + 1));
}

static enum status print_growth(const struct bench *b, struct message *why)
{
    static const struct table_column columns[] = {
        {"net", NULL, TABLE_LEFT}, {"unknowns"},    {"frame", "ms"}, {"K and M", "ms"},
        {"factor", "ms"},          {"paper", "ms"}, {"ratio"},       {"repeats"}};
    struct table *t =
        table_create(LEN(columns), columns, "Growth of a rebuilt frame with the net");
    struct growth g;
    enum status st = STATUS_OK;

    for (int n = 0; n < b->batch.count; n++) {
        const int side = side_of(n);
        struct run_result r;
        TRY(batch_read(&b->batch, n, false, &r, why));
        g.unknowns[n] = r.unknowns;
        g.points[n] = 2.0 * side * side;
        g.elements[n] = (side - 2) * (side - 2);
        g.cost[n] = r.step.median;
        g.assemble[n] = r.phase[BENCH_SOLID_ASSEMBLE].median;
        g.paper[n] = paper_table2_ms[PAPER_GROWTH + n];
        table_row(t);
        table_text(t, "%dx%dx2", side, side);
        table_fixed(t, r.unknowns, 0);
        table_number(t, 1e3 * g.cost[n], 3);
        table_number(t, 1e3 * g.assemble[n], 3);
        table_number(t, 1e3 * r.phase[BENCH_SOLID_FACTOR].median, 3);
        table_number(t, g.paper[n], 4);
        table_number(t, g.paper[n] / (1e3 * g.cost[n]), 3);
        table_integer(t, r.step.count);
        run_result_clear(&r);
    }
    note_growth(t, &g);
    return table_finish(t, b->format, stdout);
out:
    table_destroy(t);
    return st;
}

const struct bench_part bench_part_growth = {
    .item = {"growth", "cost of a frame over nets of 5 to 20 points a side"},
    .plan = plan_growth,
    .print = print_growth};
